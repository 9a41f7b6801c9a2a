//! A step before it is accepted: evaluations that refuse singular states, the trial state, its projections and its
//! check.

use super::state::{State, advance, wrap};
use super::system::Ode;
use crate::mechanism::Fault;
use crate::real::Scalar;

/// Diagnostics of an accepted step.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Report<S> {
    /// Worst pivot of its evaluations.
    pub pivot: S,
    /// Largest constraint residual before the first projection; 0 without projection.
    pub residual: S,
}

/// The smallest pivot, relative to its nominal value, with which a step is accepted: at the square root of
/// the rounding unit, half of the digits of an acceleration are lost.
#[must_use]
pub fn pivot_limit<S: Scalar>() -> S {
    S::ROOT_EPSILON
}

/// Evaluates the rates at (t, x); refuses a singular state and lowers `worst` to the pivot found.
pub(super) fn evaluate<S: Scalar>(
    system: &mut impl Ode<S>,
    t: S,
    x: &[S],
    x_dot: &mut [S],
    worst: &mut S,
) -> Result<(), Fault> {
    accept(system.rates(t, x, x_dot)?, worst)
}

/// Refuses a pivot below [`pivot_limit`] or not finite; else lowers `worst` to it.
pub(super) fn accept<S: Scalar>(pivot: S, worst: &mut S) -> Result<(), Fault> {
    let pivot = pivot.abs();
    if !pivot.is_finite() {
        return Err(Fault::NonFinite);
    }
    if pivot < pivot_limit() {
        return Err(Fault::Singular);
    }
    *worst = worst.min(pivot);
    Ok(())
}

/// x + (low + step k), rounded once.
#[inline(always)]
pub(super) fn displace<S: Scalar>(stage: &mut [S], start: &[S], low: &[S], step: S, k: &[S]) {
    for (((stage, x), low), k) in stage.iter_mut().zip(start).zip(low).zip(k) {
        *stage = *x + (*low + step * *k);
    }
}

/// A state that is not yet accepted.
pub(super) struct Trial<'a, S> {
    pub(super) x: &'a mut [S],
    pub(super) low: &'a mut [S],
}

impl<S: Scalar> Trial<'_, S> {
    /// state + delta.
    #[inline(always)]
    pub(super) fn advance_from(&mut self, state: &State<'_, S>, delta: impl Iterator<Item = S>) {
        let old = state.x().iter().zip(state.low());
        let new = self.x.iter_mut().zip(self.low.iter_mut());
        for ((new, old), delta) in new.zip(old).zip(delta) {
            (*new.0, *new.1) = advance(*old.0, *old.1, delta);
        }
    }

    /// Projects at the end `t` of the step and checks that all is finite; returns the residual before the first
    /// projection. `before` is memory.
    #[inline(always)]
    #[expect(clippy::eq_op, reason = "what is not finite leaves no number when taken from itself")]
    pub(super) fn settle(&mut self, system: &mut impl Ode<S>, t: S, before: &mut [S]) -> Result<S, Fault> {
        let mut residual = S::ZERO;
        system.set_time(t);
        let rounds = system.projections().min(2);
        if rounds > 0 {
            before.iter_mut().zip(&*self.x).for_each(|(b, x)| *b = *x);
        }
        for round in 0..rounds {
            let found = system.project(self.x)?;
            residual = if round == 0 { found } else { residual };
        }
        // One check at the end for all numbers: v - v is 0, or NaN where v is not finite.
        let mut watched = residual;
        for ((low, b), x) in self.low.iter_mut().zip(&*before).zip(&*self.x) {
            // A coordinate that the projection has moved is determined by the rounded values of the others,
            // so its old rounding error means nothing any more.
            *low = if rounds == 0 || *b == *x { *low } else { S::ZERO };
            let exact = *x + *low;
            watched = watched + (exact - exact);
        }
        if watched.is_finite() { Ok(residual) } else { Err(Fault::NonFinite) }
    }

    /// Makes the trial state the state; subtracts whole turns from angles.
    pub(super) fn commit(&self, system: &impl Ode<S>, state: &mut State<'_, S>) {
        let new = self.x.iter().zip(&*self.low);
        for (index, (old, new)) in state.entries().zip(new).enumerate() {
            (*old.0, *old.1) = if system.is_angle(index) { wrap(*new.0, *new.1) } else { (*new.0, *new.1) };
        }
    }
}

/// Cuts the first `K` slices of `n` numbers from the scratch memory; `n` is 0 for what moves as commanded only.
pub(crate) fn split<S, const K: usize>(scratch: &mut [S], n: usize) -> Result<[&mut [S]; K], Fault> {
    if n.checked_mul(K).is_none_or(|all| scratch.len() < all) {
        return Err(Fault::Shape);
    }
    let mut rest = scratch;
    Ok(core::array::from_fn(|_| {
        let (slice, left) = core::mem::take(&mut rest).split_at_mut_checked(n).unwrap_or_default();
        rest = left;
        slice
    }))
}

/// Checks that state and system have the same length, and returns it.
pub(super) fn check_shape<S: Scalar>(system: &impl Ode<S>, state: &State<'_, S>) -> Result<usize, Fault> {
    let n = system.n_x();
    if state.x().len() == n { Ok(n) } else { Err(Fault::Shape) }
}
