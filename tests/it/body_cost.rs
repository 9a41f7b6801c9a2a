//! Counts instructions of a step of a large body: what a ground adds if no node is near it.

use crate::instructions::of_a_fresh_process;
use smartbed::scene::shape;
use smartbed::scene::simulation::{Simulation, Surroundings};
use smartbed_runtime::contact::{ContactLaw, Ground};
use smartbed_runtime::ode::nodes::Method;

/// Environment variable with the body that a new process steps, and the number of steps.
const CHILD: &str = "SMARTBED_TESTS_BODY";
/// Most instructions per node that a ground out of reach may add to a step.
const WATCH: f64 = 140.0;

/// Nodes of the sheet.
const NODES: f64 = 837.0;

/// A bladder's sheet of 27 x 27 nodes 3 m above the ground, or without one.
fn step(over_ground: bool, steps: usize) {
    let mut lists = shape::sheet(27, 27, 1.4, 1.4);
    lists.stiffness = vec![5000.0; lists.springs.len()];
    lists.damping = vec![0.0; lists.springs.len()];
    lists.points.iter_mut().for_each(|[_, _, z]| *z += 3.0);
    let law = ContactLaw::Newton { restitution: 0.5 };
    let ground = Ground { normal: [0.0, 0.0, 1.0], offset: 0.0, law, friction: 0.0, tolerance: 1e-9 };
    let ground = over_ground.then_some(ground);
    let around = Surroundings { gravity: [0.0, 0.0, -9.81], air_drag: 0.0, ground, inflation: None };
    let mut motion = Simulation::<f64>::new(&lists, &around, Method::Verlet).expect("a body");
    motion.begin(1e-4, &mut ()).expect("a start");
    for _ in 0..steps {
        motion.step(1e-4, &mut ()).expect("a step");
    }
}

#[test]
fn a_ground_out_of_reach_costs_next_to_nothing() {
    if let Ok(asked) = std::env::var(CHILD) {
        let (ground, steps) = asked.split_once(' ').expect("two words");
        return step(ground == "ground", steps.parse().expect("a number"));
    }
    let test = "body_cost::a_ground_out_of_reach_costs_next_to_nothing";
    let count = |what: &str, steps: usize| of_a_fresh_process(test, CHILD, &format!("{what} {steps}"));
    let a_step = |what: &str| (count(what, 60) - count(what, 10)) / (50.0 * NODES);
    let [alone, watched] = ["nothing", "ground"].map(a_step);
    println!("instructions a node and step: {alone:.1} alone, {watched:.1} over the ground");
    assert!(watched - alone <= WATCH, "{watched} over the ground, {alone} alone");
}
