//! Time of one f64 evaluation of forward dynamics, generated code, parameters at run time:
//! `cargo bench -p smartbed-tests --bench evaluation`.
//!
//! Each iteration evaluates the states in turn; the figure divided by [`STATES`] is one evaluation.
//! Results by machine are kept beside this file, in results/.

use divan::{Bencher, black_box};
use smartbed_tests::cases;
use smartbed_tests::generated;
use smartbed_tests::subject::arrange;

/// States that one iteration evaluates; the counter below turns times into evaluations a second.
const STATES: usize = 32;
/// Seed of the states.
const SEED: u64 = 4;

fn main() {
    divan::main();
}

#[divan::bench(args = ["tile", "tile_minimal", "arm6", "bicycle", "fourbar", "pendulum3", "pendulum10"])]
fn forward_dynamics(bencher: Bencher<'_, '_>, model: &str) {
    let mut subject = generated::double(model);
    let names = subject.names();
    let states: Vec<[Vec<f64>; 3]> = cases::random_cases(model, STATES, SEED)
        .iter()
        .map(|case| {
            let state = &case.state;
            [arrange(&names.q, &state.q), arrange(&names.u, &state.u), arrange(&names.inputs, &state.inputs)]
        })
        .collect();
    let (mut q_dot, mut u_dot) = (vec![0.0; names.q.len()], vec![0.0; names.u.len()]);
    bencher.counter(divan::counter::ItemsCount::new(STATES)).bench_local(|| {
        for [q, u, inputs] in black_box(&states) {
            let pivot = subject.rates(0.0, q, u, inputs, &mut q_dot, &mut u_dot);
            black_box((&pivot, &q_dot, &u_dot));
        }
    });
}
