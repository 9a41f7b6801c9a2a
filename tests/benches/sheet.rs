//! Time of a step of the bladder: 27 x 27 nodes in a frame, Verlet, pressure as the gradient of the volume.
//!
//! `cargo bench -p smartbed-tests --bench sheet -- STEPS TURNS` prints for f32 and f64 the least and the median time of
//! a step (ns) over the turns, and the height of the middle (m): with the grid, then with the same springs as a list;
//! then of a step of each of 28 such bladders, on one core and on two, and of a step of the energy-momentum method at h
//! w = 1. `python3 tests/peers/sheet.py` runs it beside C.

use std::time::Instant;

use smartbed::scene::many;
use smartbed::scene::shape;
use smartbed::scene::simulation::{Simulation, Surroundings};
use smartbed_runtime::flexible::{Gas, Inflation, PressureForm};
use smartbed_runtime::ode::nodes::Method;
use smartbed_runtime::real::Scalar;

/// The bladder at its start.
fn bladder<S: Scalar>(form: PressureForm, as_grid: bool, method: Method<f64>, h: S) -> Simulation<S> {
    let mut lists = shape::sheet(27, 27, 1.4, 1.4);
    lists.stiffness = vec![5000.0; lists.springs.len()];
    lists.damping = vec![0.0; lists.springs.len()];
    for (point, fixed) in lists.points.iter_mut().zip(&lists.fixed) {
        let [column, row] = [point[0] / 0.05, point[1] / 0.05];
        point[2] = if *fixed { 0.0 } else { 0.01 * (0.3 * column).sin() * (0.2 * row).cos() };
    }
    if !as_grid {
        lists.table = None;
    }
    let around = Surroundings {
        gravity: [0.0, 0.0, -9.81],
        air_drag: 0.0,
        ground: None,
        inflation: Some(Inflation { gas: Gas::Constant(2000.0), form }),
    };
    let mut motion = Simulation::<S>::new(&lists, &around, method).expect("a body");
    motion.begin(h, &mut ()).expect("a start");
    motion
}

/// Least and median time (ns) of a step of each of some bladders, height of the middle of the last at the end (m).
fn time<S: Scalar + Send + Sync>(
    mut bodies: Vec<Simulation<S>>,
    h: S,
    (steps, turns): (usize, usize),
    cores: usize,
) -> (f64, f64, f64) {
    let mut took: Vec<f64> = (0..turns)
        .map(|_| {
            let start = Instant::now();
            many::advance(&mut bodies, h, steps, cores).expect("steps");
            1e9 * start.elapsed().as_secs_f64() / (steps * bodies.len()) as f64
        })
        .collect();
    took.sort_by(f64::total_cmp);
    (took[0], took[turns / 2], bodies[bodies.len() - 1].pos()[13 * 27 + 13][2].to_f64())
}

/// Bladders of a bed, and how many steps each takes in a turn: a turn then ends before the machine turns to others.
const MANY: usize = 28;
const FEW: usize = 10;
/// Length of a step (s), and that of h w = 1: w^2 = 4 K/m of a chain.
const STEP: f64 = 1e-4;
const STIFF_STEP: f64 = 7e-3;

/// Prints the lines of a scalar.
fn report<S: Scalar + Send + Sync>(scalar: &str, steps: usize, turns: usize) {
    let h = S::from_f64(STEP);
    let say = |name: &str, (least, median, height): (f64, f64, f64)| {
        println!("{scalar} {name} {least:.1} {median:.1} {height:.9}");
    };
    for (name, form) in [("exact", PressureForm::Exact), ("facet", PressureForm::Facet)] {
        for (kind, as_grid) in [("grid", true), ("list", false)] {
            let bodies = vec![bladder(form, as_grid, Method::Verlet, h)];
            say(&format!("{name} {kind}"), time(bodies, h, (steps, turns), 1));
        }
    }
    for cores in [1, 2] {
        let bodies = (0..MANY).map(|_| bladder(PressureForm::Exact, true, Method::Verlet, h)).collect();
        say(&format!("many {cores}"), time(bodies, h, (FEW, turns), cores));
    }
    let h = S::from_f64(STIFF_STEP);
    for (name, method) in [("energy_momentum", Method::EnergyMomentum), ("verlet", Method::Verlet)] {
        let bodies = vec![bladder(PressureForm::Exact, true, method, h)];
        say(&format!("stiff {name}"), time(bodies, h, (20, turns), 1));
    }
}

fn main() {
    let mut numbers = std::env::args().skip(1).filter_map(|argument| argument.parse::<usize>().ok());
    let (steps, turns) = (numbers.next().unwrap_or(50), numbers.next().unwrap_or(50));
    report::<f32>("f32", steps, turns);
    report::<f64>("f64", steps, turns);
}
