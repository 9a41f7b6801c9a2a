//! Kinematics: everything that needs no mass, in the order of Kane's method.
//!
//! In: a validated model. Out: positions; velocities and angular velocities as linear forms in the generalised speeds
//! (their coefficients are the partial velocities); candidate constraint rows; sampled configurations. Unknowns are the
//! speeds and, for every body that closes a loop, the components of its twist ("lifted" unknowns): a closure then gives
//! one short row per leg against that twist. A driven model has one unknown more, whose value is known: the clock, y_t
//! = 1 and y_t' = 0. Its partial velocity is Kane's v_t, so that linear forms, eliminations and biases treat the
//! contributions of time and of constant parts like those of any speed.

mod angular;
mod assemble;
mod basis;
mod choice;
mod choose;
mod configurations;
mod constraint;
pub(crate) mod diagnose;
pub mod eliminate;
pub(crate) mod factored;
mod least_squares;
mod lifted;
pub mod linear;
mod linear_form;
mod lower;
mod marker;
mod orientation;
mod position;
pub mod projection;
mod quantities;
mod random;
pub(crate) mod rank;
mod rate;
pub mod redundant;
mod regular;
mod route;
pub mod sampling;
pub mod sizes;
mod slopes;
pub(crate) mod sparse;
mod speed_map;
mod unit_vectors;
mod unknowns;
mod unreachable;
mod velocity;
mod walk;

use crate::diagnostic::Diagnostics;
use crate::expr::cost::Optimise;
use crate::model::Model;

pub use crate::vector::Algebra;
pub use assemble::{Assembly, tunable_values};
pub use choice::ParameterChoice;
pub(crate) use lifted::flatten;
pub use linear_form::{Coefficient, LinearForm};
pub(crate) use lower::{scalar as lower_scalar, vector as lower_vector};
pub use marker::Marker;
pub use quantities::{Direction, Kinematics, Motion, Place, Rate, Row, Value};
pub(crate) use rate::{derivative as derivative_of, scalar_rate as scalar_rate_of, sum_of_rates};
pub(crate) use slopes::{dependent_slopes, slopes_by_speeds, speeds_by_rates};
pub use unknowns::{Unknown, UnknownId, UnknownKind, Unknowns};
pub use unreachable::Unreachable;
pub(crate) use velocity::is_lifted_triad;

/// Derives the kinematics of `model`, and the algebra that holds its expressions. `Optimise::Accuracy` uses unrounded
/// differences of angles.
///
/// # Errors
/// Parameters in `choice` that the model does not have or allow, and faults that only numbers show: constraints that
/// cannot be met at the nominal configuration, closed forms that contradict a constraint, speeds from which the rates
/// of the coordinates do not follow.
pub fn derive(
    model: &Model,
    choice: &ParameterChoice,
    optimise: Optimise,
) -> Result<(Algebra, Kinematics), Diagnostics> {
    derive_along(model, choice, optimise, false)
}

/// As [`derive`]; `as_written`: every point by the route that the model writes, for what shows the equations before
/// elimination, else by the shortest one.
///
/// # Errors
/// As [`derive`].
pub(crate) fn derive_along(
    model: &Model,
    choice: &ParameterChoice,
    optimise: Optimise,
    as_written: bool,
) -> Result<(Algebra, Kinematics), Diagnostics> {
    choice.check(model)?;
    let mut alg = Algebra::default();
    let k = lower::symbols(&mut alg, model, choice);
    alg.dag.unrounded_differences = optimise == Optimise::Accuracy;
    let k = position::derive(&mut alg, model, k);
    let k = speed_map::derive(&mut alg, model, k)?;
    let k = velocity::derive(&mut alg, model, k, as_written);
    let k = constraint::derive(&mut alg, model, k);
    let k = configurations::derive(&mut alg, model, k)?;
    let k = constraint::complete(&mut alg, model, k);
    Ok((alg, k))
}
