//! Answers of the equations of motion themselves: M u' + bias = generalised forces of the inputs.

use super::part::Part;
use super::stages::{Stages, Target};
use crate::diagnostic::Diagnostic;
use crate::dynamics;
use crate::expr::{ExprId, SymbolId};
use rustc_hash::FxHashMap as HashMap;

type Parts = Result<Vec<Part>, Diagnostic>;

pub(super) fn mass_matrix(stages: &mut Stages, _: &Target) -> Parts {
    let (names, rows) = (stages.speed_names(), &stages.dynamics.mass_matrix);
    let doc = "M, symmetric: one row and one column an independent speed";
    Ok(vec![Part::matrix("mass_matrix", doc, names.clone(), names.len(), rows)])
}

pub(super) fn bias(stages: &mut Stages, _: &Target) -> Parts {
    let forcing = without_inputs(stages);
    let bias = forcing.into_iter().map(|f| stages.k.dag.negate(f)).collect();
    let doc = "gyroscopic terms, weight, springs and all other forces but those of the inputs, on the left-hand side";
    Ok(vec![Part::list("bias", doc, stages.speed_names(), bias)])
}

/// The forcing with the model's own inputs at 0.
fn without_inputs(stages: &mut Stages) -> Vec<ExprId> {
    let zero = stages.k.dag.zero();
    let off: HashMap<SymbolId, ExprId> = stages.input_symbols().into_iter().map(|s| (s, zero)).collect();
    let forcing = stages.dynamics.forcing.clone();
    stages.k.dag.substitute(&forcing, &off)
}

pub(super) fn inverse_dynamics(stages: &mut Stages, _: &Target) -> Parts {
    let forcing = without_inputs(stages);
    let u_dot = stages.u_dot.clone();
    let force = dynamics::forces_for(&mut stages.k.dag, &stages.dynamics.mass_matrix, &forcing, &u_dot);
    let doc =
        "what the inputs have to supply on each independent speed for u' to be as given (power over speed)";
    let mut parts = vec![Part::list("generalised_force", doc, stages.speed_names(), force.clone())];
    let inputs = stages.input_symbols();
    let map = stages.dynamics.forcing.clone();
    if let Some(values) = dynamics::inputs_for(stages.k, stages.table, &map, &inputs, &force) {
        let names = inputs.iter().map(|&s| stages.k.dag.symbol_name(s).to_owned()).collect();
        parts.push(Part::list("inputs", "inputs that supply it", names, values));
    }
    Ok(parts)
}
