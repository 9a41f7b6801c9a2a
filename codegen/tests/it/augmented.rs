//! The augmented form, solved numerically, gives the accelerations of the reduced form.

use smartbed_codegen::expr::SymbolId;
use smartbed_codegen::kinematics::linear;
use smartbed_codegen::{Asked, Function, Interpreted, ParameterChoice, Program, Settings, model, program};
use smartbed_runtime::mechanism::Mechanism;
use std::collections::HashMap;
use std::path::Path;

/// Rounding of a dense solve of at most 33 unknowns against the symbolic elimination.
const ROUNDING: f64 = 1e-10;

/// The program of a model with its equations before the elimination.
pub(crate) fn with_augmented(model: &model::Model, settings: Settings) -> Program {
    let asked = Asked::besides(Function::each(&["augmented"]));
    let program = program::derive_asked(model, &ParameterChoice::default(), settings, &asked);
    program.unwrap_or_else(|found| panic!("{found}"))
}

fn values(program: &Program, q: &[f64], u: &[f64], inputs: &[f64]) -> HashMap<SymbolId, f64> {
    let parameters: Vec<f64> = program.parameters.iter().map(|p| p.value).collect();
    let groups =
        [(&program.q, q), (&program.u, u), (&program.inputs, inputs), (&program.parameters, &parameters)];
    let mut values = HashMap::from([(program.time, 0.0)]);
    for (names, numbers) in groups {
        values.extend(names.iter().zip(numbers).map(|(name, &x)| (name.symbol, x)));
    }
    values
}

fn check(name: &str) {
    let model =
        model::read(Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../models/{name}.toml")).as_path())
            .expect("a good model");
    let program = with_augmented(&model, Settings::default());
    let mut q = program.nominal.clone();
    let independent =
        program.q.iter().position(|c| !program.correction.iter().any(|(i, _)| program.q[*i].name == c.name));
    q[independent.expect("a free coordinate")] += 0.05;
    program.assembly.clone().correct(&mut q).expect("near nominal");
    let u: Vec<f64> = (0..program.u.len()).map(|i| 0.3 - 0.2 * i as f64).collect();
    let inputs: Vec<f64> = (0..program.inputs.len()).map(|i| 20.0 + 5.0 * i as f64).collect();
    agree(&program, &q, &u, &inputs);
}

/// The reduced form against the augmented one at a state.
pub(crate) fn agree(program: &Program, q: &[f64], u: &[f64], inputs: &[f64]) {
    let name = &program.name;
    let (mut q_dot, mut u_dot) = (vec![0.0; q.len()], vec![0.0; u.len()]);
    let mut reduced = Interpreted::<f64>::new(program);
    reduced.rates(0.0, q, u, inputs, &mut q_dot, &mut u_dot).expect("lengths fit");

    let values = values(program, q, u, inputs);
    let numbers = program.dag.evaluate::<f64>(&program.augmented_roots(), &|s| values[&s]);
    let n = program.augmented.unknowns.len();
    let m = program.augmented.bias.len();
    let (mass, rest) = numbers.split_at(n * n);
    let (jacobian, rest) = rest.split_at(m * n);
    let (forcing, bias) = rest.split_at(n);
    let size = n + m;
    let mut matrix = vec![0.0; size * size];
    for i in 0..n {
        for j in 0..n {
            assert_eq!(mass[i * n + j], mass[j * n + i], "{name}: symmetric");
            matrix[i * size + j] = mass[i * n + j];
        }
        for r in 0..m {
            matrix[i * size + n + r] = -jacobian[r * n + i];
            matrix[(n + r) * size + i] = jacobian[r * n + i];
        }
    }
    let mut right: Vec<f64> = forcing.iter().copied().chain(bias.iter().map(|b| -b)).collect();
    let (solution, rank) = linear::solve(&matrix, &mut right, size);
    assert_eq!(rank, size, "{name}: regular");
    for (speed, expected) in program.u.iter().zip(&u_dot) {
        let at = program.augmented.unknowns.iter().position(|x| *x == speed.name).expect("a speed");
        let error = (solution[at] - expected).abs() / (1.0 + expected.abs());
        assert!(error < ROUNDING, "{name}, {}: {} {expected}", speed.name, solution[at]);
    }
}

#[test]
fn augmented_form_of_the_pendulum() {
    check("pendulum3");
}

#[test]
fn augmented_form_of_the_fourbar() {
    check("fourbar");
}

#[test]
fn augmented_form_of_the_tile() {
    check("tile");
}
