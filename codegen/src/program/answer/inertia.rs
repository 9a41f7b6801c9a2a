//! Answers from the equations of motion: M u' + bias = generalised forces of the inputs.

use super::part::Part;
use super::stages::{Stages, Target};
use crate::diagnostic::Diagnostic;
use crate::dynamics;
use crate::expr::{ExprId, SymbolId};
use crate::kinematics::Direction;
use rustc_hash::FxHashMap as HashMap;

type Parts = Result<Vec<Part>, Diagnostic>;

pub(super) fn mass_matrix(stages: &mut Stages, _: &Target) -> Parts {
    let (names, rows) = (stages.speed_names(), &stages.dynamics.mass_matrix);
    let doc = "M, symmetric: one row and one column an independent speed";
    Ok(vec![Part::matrix("mass_matrix", doc, names.clone(), names.len(), rows)])
}

pub(super) fn bias(stages: &mut Stages, _: &Target) -> Parts {
    let forcing = without(stages, stages.k.inputs.len());
    let bias = forcing.into_iter().map(|f| stages.alg.dag.negate(f)).collect();
    let doc = "gyroscopic terms, weight, springs and all other forces but those of the inputs, on the left-hand side";
    Ok(vec![Part::list("bias", doc, stages.speed_names(), bias)])
}

pub(super) fn forcing(stages: &mut Stages, _: &Target) -> Parts {
    let doc = "gyroscopic terms, weight, springs, inputs and all other forces, on the right-hand side";
    Ok(vec![Part::list("forcing", doc, stages.speed_names(), stages.dynamics.forcing.clone())])
}

/// The forcing with the first `count` inputs at 0.
fn without(stages: &mut Stages, count: usize) -> Vec<ExprId> {
    let off = inputs_off(stages, count);
    let forcing = stages.dynamics.forcing.clone();
    stages.alg.dag.substitute(&forcing, &off)
}

/// Sets each of the first `count` inputs to 0: those of the model, then those of wrenches.
fn inputs_off(stages: &mut Stages, count: usize) -> HashMap<SymbolId, ExprId> {
    let zero = stages.alg.dag.zero();
    let inputs = stages.k.inputs.iter().take(count);
    inputs.filter_map(|&input| Some((stages.alg.dag.as_symbol(input)?, zero))).collect()
}

/// Generalised forces that the given accelerations need with the model's own inputs at 0, the wrenches of ports given,
/// through the mass matrix or by the Newton-Euler recursion, whichever takes fewer operations.
fn needed(stages: &mut Stages) -> Vec<ExprId> {
    let own = stages.own_inputs;
    let forcing = without(stages, own);
    let u_dot = stages.u_dot.clone();
    let by_matrix = dynamics::forces_for(&mut stages.alg.dag, &stages.dynamics.mass_matrix, &forcing, &u_dot);
    let recursive = recursive(stages);
    let off = inputs_off(stages, own);
    let recursive = stages.alg.dag.substitute(&recursive, &off);
    let cost = |forces: &[ExprId]| stages.alg.dag.state_cost(forces);
    if cost(&recursive) < cost(&by_matrix) { recursive } else { by_matrix }
}

/// M u' - forcing at the given accelerations, by the Newton-Euler recursion.
pub(super) fn recursive(stages: &mut Stages) -> Vec<ExprId> {
    let u_dot = stages.u_dot.clone();
    let missing = dynamics::missing_forces(stages.alg, stages.model, stages.k, stages.solution, &u_dot);
    let forces = dynamics::on_independent(stages.alg, stages.k, stages.solution, missing);
    stages.solved(&forces)
}

pub(super) fn power(stages: &mut Stages, _: &Target) -> Parts {
    let (names, powers): (Vec<String>, Vec<ExprId>) =
        dynamics::powers(stages.alg, stages.model, stages.k).into_iter().unzip();
    let powers = stages.solved(&powers);
    let doc = "what each load and the weight put into the mechanism; with `drive` their sum is the rate of the kinetic energy (W)";
    Ok(vec![Part::list("power", doc, names, powers)])
}

pub(super) fn multipliers(stages: &mut Stages, target: &Target) -> Parts {
    let u_dot = stages.dynamics.u_dot.clone();
    let missing = dynamics::missing_forces(stages.alg, stages.model, stages.k, stages.solution, &u_dot);
    let Some(lambda) = dynamics::multipliers(stages.alg, stages.k, stages.table, stages.solution, &missing)
    else {
        return Err(Diagnostic::error(format!("`{}`: there are more constraint rows than dependent speeds", target.request))
            .help("the multipliers of such rows are not determined one by one; solve the equations of `derive --form augmented` in the least squares"));
    };
    let lambda = stages.solved(&lambda);
    let names = names_of_rows(stages);
    let doc = "of J' lambda = M y' - f over all speeds and lifted twists, one a row of J as `derive --form augmented` has them";
    Ok(vec![Part::list("multipliers", doc, names, lambda)])
}

/// A name for each row: that of its equation and, of a vector equation, the axis on which it is projected; or a number,
/// if the axis belongs to no frame of the model.
fn names_of_rows(stages: &Stages) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for row in &stages.solution.rows {
        let named = match row.along {
            None => Some(row.name.clone()),
            Some(direction) => frame_of(stages, direction).map(|frame| {
                let (word, letter) = (
                    if direction.turning { "about" } else { "along" },
                    ["x", "y", "z"][direction.axis as usize],
                );
                format!("{} {word} {frame}.{letter}", row.name)
            }),
        };
        let numbered = (1..).map(|n| format!("{}, row {n}", row.name));
        names.extend(named.into_iter().chain(numbered).find(|name| !names.contains(name)));
    }
    names
}

/// The frame to whose triad the axis belongs.
fn frame_of<'m>(stages: &Stages<'m>, direction: Direction) -> Option<&'m str> {
    let (model, k) = (stages.model, stages.k);
    let mut frames = model.frames.enumerate();
    frames.find(|(id, _)| k.frame_triad[*id] == direction.triad).map(|(_, frame)| frame.name.as_str())
}

pub(super) fn inverse_dynamics(stages: &mut Stages, _: &Target) -> Parts {
    let force = needed(stages);
    let doc = "what the model's inputs have to supply on each independent speed for u' to be as given, against the given wrench of a port too (power over speed)";
    let mut parts = vec![Part::list("generalised_force", doc, stages.speed_names(), force.clone())];
    let inputs = stages.input_symbols();
    let map = stages.dynamics.forcing.clone();
    if let Some(values) = dynamics::inputs_for(stages.alg, stages.table, &map, &inputs, &force) {
        let names = inputs.iter().map(|&s| stages.alg.dag.symbol_name(s).to_owned()).collect();
        parts.push(Part::list("inputs", "inputs that supply it", names, values));
    }
    Ok(parts)
}
