//! The kinematic form: speeds, outputs, projection, motions of places, of a model whose masses are unknown or missing.
//!
//! In: a model, with or without bodies. Out: a program of which only the answers that need no mass mean anything:
//! those of [`Program::kinematic`], and those on request whose [`Needs`](super::answer::Needs) say so.

use super::answer::{self, Asked, Stages};
use super::assemble::{assemble, constraints, mark_angles};
use super::derived::{Origin, Program};
use super::stage::{self, Stage};
use super::{relative, shorten};
use crate::diagnostic::Diagnostics;
use crate::dynamics;
use crate::expr::cost::Optimise;
use crate::kinematics::sizes::Sizes;
use crate::kinematics::{self, Assembly, ParameterChoice, sampling};
use crate::model::Model;
use crate::value::Effort;

/// Derives what needs no mass.
///
/// # Errors
/// What only numbers show: frames that are none, constraints that are singular or do not fit.
pub fn derive_kinematic(
    model: &Model,
    choice: &ParameterChoice,
    effort: Effort,
) -> Result<Program, Diagnostics> {
    derive(model, choice, effort, &Asked::default())
}

/// The same with answers on request, none of which needs masses.
pub(super) fn derive(
    model: &Model,
    choice: &ParameterChoice,
    effort: Effort,
    asked: &Asked,
) -> Result<Program, Diagnostics> {
    let requests = answer::resolve(model, asked)?;
    stage::begin(Stage::Kinematics);
    let (mut alg, mut k) = kinematics::derive(model, choice, Optimise::default())?;
    stage::begin(Stage::Constraints);
    let mut table = sampling::sample_table(&alg, model, &k);
    let warnings = kinematics::diagnose::check(&mut alg, model, &mut k, &mut table)?;
    let solution = constraints(&mut alg, model, &mut k, &mut table)?;
    let dynamics = dynamics::without_mass(&mut alg, model, &k, &solution, &mut table);
    stage::begin(Stage::Answers);
    let given = (model.inputs.len(), false, effort);
    let mut stages = Stages::new(&mut alg, (model, choice), &k, (&solution, &dynamics), &mut table, given);
    let answered = answer::derive(&mut stages, &requests, asked)?;
    let assembly = Assembly::new(&mut alg, model, &k);
    let sizes = Sizes::new(&alg, model, &k);
    let origin = Origin::new(model, choice, effort.into());
    let mut program =
        assemble(model, (alg, k), (&solution, &mut table), dynamics, (assembly, answered, origin));
    program.warnings = warnings;
    program.keep_only(asked);
    stage::begin(Stage::Values);
    shorten::answers(&mut program, &mut table, effort);
    relative::to_parameters(&mut program, &sizes);
    mark_angles(&mut program);
    Ok(program)
}
