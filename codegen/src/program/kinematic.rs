//! The kinematic form: speeds, outputs and projection of a model whose masses are unknown or missing.
//!
//! In: a model, with or without bodies. Out: a program of which only the answers
//! [`Answer::KINEMATIC`](crate::Answer::KINEMATIC) mean anything.

use super::{Effort, Program, assemble, mark_angles, shorten};
use crate::diagnostic::Diagnostics;
use crate::dynamics;
use crate::expr::cost::Optimise;
use crate::kinematics::{self, Assembly, ParameterChoice, eliminate};
use crate::model::Model;

/// Derives what needs no mass.
///
/// # Errors
/// What only numbers show: frames that are none, constraints that are singular or do not fit.
pub fn derive_kinematic(
    model: &Model,
    choice: &ParameterChoice,
    effort: Effort,
) -> Result<Program, Diagnostics> {
    let mut k = kinematics::derive(model, choice, Optimise::default())?;
    let mut table = eliminate::sample_table(model, &k);
    let warnings = kinematics::diagnose::check(model, &mut k, &mut table)?;
    let solution = eliminate::solve(model, &mut k, &mut table)?;
    let dynamics = dynamics::without_mass(&mut k, &solution);
    let assembly = Assembly::new(model, &mut k);
    let mut program = assemble(model, k, &solution, dynamics, assembly);
    program.warnings = warnings;
    shorten::answers(&mut program, &mut table, effort);
    mark_angles(&mut program);
    Ok(program)
}
