//! Trial steps: plans the length of a step, tries it, and plans the next one.
//!
//! In: the state and the time left of the caller's step. Out: the length of the step taken, with its first event
//! located. Adaptive methods plan by their error estimate; an implicit step that does not converge is halved.

use super::state::State;
use crate::contact::{Ground, Repertoire, Start, System, advance};
use crate::flexible::BodyError;
use crate::guard::{self, Shortened};
use crate::ode::nodes::{Step, Workspace};
use crate::real::Scalar;

/// Most halvings of an implicit step that does not converge.
const HALVINGS: usize = 10;

/// A trial step.
pub(super) struct Attempt<S> {
    /// Its length (s).
    pub length: S,
    /// Error estimate over the allowed error; above 1 the step is rejected.
    pub error: S,
    /// Where the step ends after location of events.
    pub shortened: Shortened<S>,
}

/// Tries a step and locates its first event; halves it while an implicit method does not converge: springs pressed
/// through length 0 reverse their force abruptly, and the iteration can follow shorter steps only.
pub(super) fn attempt<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    watched: Option<&Ground<S>>,
    state: &State<S>,
    tau: S,
    method: R::Method,
    work: &mut Workspace<S>,
) -> Result<Attempt<S>, BodyError<S>> {
    let mut tau = tau;
    for _ in 0..HALVINGS {
        match attempt_once(system, watched, state, tau, method, work) {
            Err(BodyError::NotConverged { .. }) => tau = S::from_f64(0.5) * tau,
            done => return done,
        }
    }
    attempt_once(system, watched, state, tau, method, work)
}

fn attempt_once<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    watched: Option<&Ground<S>>,
    state: &State<S>,
    length: S,
    method: R::Method,
    work: &mut Workspace<S>,
) -> Result<Attempt<S>, BodyError<S>> {
    let start = || Start { motion: &state.motion, modes: state.modes };
    let error = advance(system, start(), length, method, work)?;
    let shortened = match watched {
        Some(ground) if error <= S::ONE => {
            guard::shorten_to_event(system, ground, start(), length, method, work)?
        }
        _ => Shortened { tau: length, is_event: false, trials: 0 },
    };
    Ok(Attempt { length, error, shortened })
}

/// Length of the next trial step (s).
pub(super) fn try_length<S: Scalar>(state: &State<S>, remaining: S, h: S, method: impl Step<S>) -> S {
    let wanted = match method.longest() {
        Some(longest) => {
            let first = h * S::from_f64(0.01);
            let planned = if state.next_step > S::ZERO { state.next_step } else { first };
            planned.min(longest)
        }
        None => h,
    };
    // Less than one part in 1e3 of the step is not left for a step of its own.
    if wanted * S::from_f64(1.001) >= remaining { remaining } else { wanted }
}

/// Standard step size controller: factor 0.9 error^(-1/order), between 1/5 and 5.
pub(super) fn control_step<S: Scalar>(
    state: &mut State<S>,
    tau: S,
    error: S,
    remaining: S,
    method: impl Step<S>,
) {
    let order = method.control_order();
    if order == 0 {
        return;
    }
    let exponent = S::from_f64(-1.0 / f64::from(order));
    let tiny = S::from_f64(1e-10);
    let factor = S::from_f64(0.9) * (exponent * error.max(tiny).ln()).exp();
    let wanted = tau * factor.max(S::from_f64(0.2)).min(S::from_f64(5.0));
    // A trial cut short by the end of the step is no evidence against the longer one planned before.
    let cut = tau >= remaining && error <= S::ONE;
    state.next_step = if cut { wanted.max(state.next_step) } else { wanted };
}
