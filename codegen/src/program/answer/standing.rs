//! Answers that every program has: those that the runtime's `Mechanism` trait needs, and a few others.

use super::part::Part;
use crate::program::derived::Program;

pub(super) fn rates(program: &Program) -> Vec<Part> {
    let rates = &program.rates;
    vec![
        Part::list("q_dot", "rates of the coordinates", Vec::new(), rates.q_dot.clone()),
        Part::list("u_dot", "rates of the independent speeds", Vec::new(), rates.u_dot.clone()),
        Part::number("worst_pivot", "smallest pivot relative to nominal", rates.worst_pivot),
    ]
}

pub(super) fn energy(program: &Program) -> Vec<Part> {
    let [kinetic, potential] = program.energy;
    vec![Part::number("kinetic", "J", kinetic), Part::number("potential", "J", potential)]
}

pub(super) fn speeds(program: &Program) -> Vec<Part> {
    vec![named("speeds", &program.speeds)]
}

pub(super) fn outputs(program: &Program) -> Vec<Part> {
    vec![named("outputs", &program.outputs)]
}

pub(super) fn projection(program: &Program) -> Vec<Part> {
    let corrections = program.correction.iter().map(|(_, e)| *e).collect();
    vec![
        Part::list("corrections", "of the coordinates `CORRECTED`", Vec::new(), corrections),
        Part::number("residual", "the largest before the correction", program.residual),
    ]
}

/// Empty if the speeds are independent.
pub(super) fn speed_projection(program: &Program) -> Vec<Part> {
    match program.speed_correction.is_empty() {
        true => Vec::new(),
        false => {
            vec![Part::list("corrections", "of the speeds", Vec::new(), program.speed_correction.clone())]
        }
    }
}

/// Empty if the mechanism is not driven.
pub(super) fn drive(program: &Program) -> Vec<Part> {
    program.drive.map(|power| Part::number("power", "W", power)).into_iter().collect()
}

pub(super) fn augmented(program: &Program) -> Vec<Part> {
    let parts = &program.augmented;
    let list = |name, values: &Vec<_>| Part::list(name, "", Vec::new(), values.clone());
    vec![
        list("mass", &parts.mass),
        list("jacobian", &parts.jacobian),
        list("forcing", &parts.forcing),
        list("bias", &parts.bias),
    ]
}

fn named(name: &'static str, list: &[(String, crate::expr::ExprId)]) -> Part {
    let (labels, values) = list.iter().cloned().unzip();
    Part::list(name, "", labels, values)
}
