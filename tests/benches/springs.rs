//! Time of a step of bodies that are no grids: blocks of cubes, every pair of a cube's corners joined and each to its
//! middle.
//!
//! `cargo bench -p smartbed-tests --bench springs -- FOLDER` writes each body as text to the folder, for C, and prints,
//! for one of 1,900 springs, one of a million, and that with points and springs drawn by lot, in f64 and f32: the least
//! time of a step, of all that comes before the first and of the largest stable step (ns a spring), and the height of a
//! point (m) after so many steps. `python3 tests/peers/springs.py` runs it beside C.

use std::fmt::Write as _;
use std::time::Instant;

use smartbed::scene::simulation::{Simulation, Surroundings};
use smartbed::scene::{Lists, shape};
use smartbed_runtime::ode::nodes::Method;
use smartbed_runtime::real::Scalar;

/// Length of a step (s).
const STEP: f64 = 1e-3;

/// Cubes in each direction, steps timed at a time, times, and whether the order of the lists is drawn by lot.
const BODIES: [(&str, usize, usize, usize, bool); 3] =
    [("small", 4, 200, 40, false), ("million", 36, 1, 30, false), ("drawn", 36, 1, 10, true)];

/// Numbers drawn by lot (Knuth's linear congruences).
struct Lot(u64);

impl Lot {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % n
    }

    fn shuffle<T>(&mut self, list: &mut [T]) {
        (1..list.len()).rev().for_each(|last| list.swap(last, self.below(last + 1)));
    }
}

fn body(cubes: usize, drawn: bool) -> Lists {
    let mut lists = shape::cubes(cubes, cubes, cubes, 0.1);
    if drawn {
        let mut lot = Lot(1);
        let mut places: Vec<usize> = (0..lists.points.len()).collect();
        let mut springs: Vec<usize> = (0..lists.springs.len()).collect();
        lot.shuffle(&mut places);
        lot.shuffle(&mut springs);
        let points = lists.points.clone();
        places.iter().zip(points).for_each(|(place, point)| lists.points[*place] = point);
        lists.rest_lengths = springs.iter().map(|i| lists.rest_lengths[*i]).collect();
        lists.springs = springs.iter().map(|i| lists.springs[*i].map(|end| places[end])).collect();
    }
    lists.points.iter_mut().for_each(|[x, y, z]| *z += 0.01 * (3.0 * *x).sin() * (2.0 * *y).cos());
    lists.stiffness = vec![1000.0; lists.springs.len()];
    lists.damping = vec![0.0; lists.springs.len()];
    lists
}

/// Counts, points, then ends and rest lengths of the springs.
fn text(lists: &Lists) -> String {
    let mut text = format!("{} {}\n", lists.points.len(), lists.springs.len());
    for [x, y, z] in &lists.points {
        let _ = writeln!(text, "{x} {y} {z}");
    }
    for ([tail, head], length) in lists.springs.iter().zip(&lists.rest_lengths) {
        let _ = writeln!(text, "{tail} {head} {length}");
    }
    text
}

/// Least times (ns a spring) of a step, of the set-up and of the stable step; height of the first point (m).
fn time<S: Scalar>(lists: &Lists, steps: usize, turns: usize) -> [f64; 4] {
    let around = Surroundings { gravity: [0.0; 3], air_drag: 0.0, ground: None, inflation: None };
    let a_spring = |start: Instant, times: usize| {
        1e9 * start.elapsed().as_secs_f64() / (times * lists.springs.len()) as f64
    };
    let start = Instant::now();
    let mut motion = Simulation::<S>::new(lists, &around, Method::Verlet).expect("a body");
    let h = S::from_f64(STEP);
    motion.begin(h, &mut ()).expect("a start");
    let set_up = a_spring(start, 1);
    let start = Instant::now();
    assert!(motion.largest_stable_step().is_some_and(|stable| h < stable), "a stable step");
    let stable = a_spring(start, 1);
    let took = (0..turns).map(|_| {
        let start = Instant::now();
        (0..steps).for_each(|_| {
            motion.step(h, &mut ()).expect("a step");
        });
        a_spring(start, steps)
    });
    let least = took.fold(f64::INFINITY, f64::min);
    [least, set_up, stable, motion.pos()[0][2].to_f64()]
}

fn main() {
    let folder = std::env::args().skip(1).find(|argument| !argument.starts_with('-'));
    for (name, cubes, steps, turns, drawn) in BODIES {
        let lists = body(cubes, drawn);
        if let Some(folder) = &folder {
            std::fs::write(format!("{folder}/{name}.txt"), text(&lists)).expect("room for a body");
        }
        for (scalar, [least, set_up, stable, height]) in
            [("f64", time::<f64>(&lists, steps, turns)), ("f32", time::<f32>(&lists, steps, turns))]
        {
            let count = lists.springs.len();
            println!(
                "{scalar} {name} {least:.3} {set_up:.1} {stable:.1} {height:.12} {steps} {turns} {count}"
            );
        }
    }
}
