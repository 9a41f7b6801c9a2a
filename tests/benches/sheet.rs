//! Time of a step of the bladder: 27 x 27 nodes in a frame, Verlet, pressure as the gradient of the volume.
//!
//! `cargo bench -p smartbed-tests --bench sheet -- STEPS TURNS` prints for f32 and f64 the least and the median time of a
//! step (ns) over the turns, and the height of the middle (m): with the grid, then with the same springs as a list.
//! `python3 tests/peers/sheet.py` runs it beside C.

use std::time::Instant;

use smartbed::scene::shape;
use smartbed::scene::simulation::{Simulation, Surroundings};
use smartbed_runtime::flexible::{Gas, Inflation, PressureForm};
use smartbed_runtime::ode::nodes::Method;
use smartbed_runtime::real::Scalar;

/// Least and median time of a step (ns), height of the middle at the end (m).
fn time<S: Scalar>(form: PressureForm, as_grid: bool, steps: usize, turns: usize) -> (f64, f64, f64) {
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
    let mut motion = Simulation::<S>::new(&lists, &around, Method::Verlet).expect("a body");
    let h = S::from_f64(1e-4);
    motion.begin(h, &mut ()).expect("a start");
    let mut took: Vec<f64> = (0..turns)
        .map(|_| {
            let start = Instant::now();
            (0..steps).for_each(|_| {
                motion.step(h, &mut ()).expect("a step");
            });
            1e9 * start.elapsed().as_secs_f64() / steps as f64
        })
        .collect();
    took.sort_by(f64::total_cmp);
    (took[0], took[turns / 2], motion.pos()[13 * 27 + 13][2].to_f64())
}

fn main() {
    let mut numbers = std::env::args().skip(1).filter_map(|argument| argument.parse::<usize>().ok());
    let (steps, turns) = (numbers.next().unwrap_or(50), numbers.next().unwrap_or(50));
    for (name, form) in [("exact", PressureForm::Exact), ("facet", PressureForm::Facet)] {
        for as_grid in [true, false] {
            let kind = if as_grid { "grid" } else { "list" };
            let (least, median, height) = time::<f32>(form, as_grid, steps, turns);
            println!("f32 {name} {kind} {least:.1} {median:.1} {height:.9}");
            let (least, median, height) = time::<f64>(form, as_grid, steps, turns);
            println!("f64 {name} {kind} {least:.1} {median:.1} {height:.9}");
        }
    }
}
