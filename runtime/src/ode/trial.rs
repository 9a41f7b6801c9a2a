//! A step before it counts: evaluations refused where they are singular, the trial state, its projections, its check.

use super::state::{State, advance, wrap};
use super::system::Ode;
use crate::mechanism::Fault;
use crate::real::Scalar;

/// What a step that was taken has to say.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Report<S> {
    /// Worst pivot of its evaluations.
    pub pivot: S,
    /// Largest constraint residual before the first projection; 0 without projection.
    pub residual: S,
}

/// The smallest pivot, relative to its nominal value, with which a step is taken: at the square root of
/// the rounding unit half of the digits of an acceleration are gone.
#[must_use]
pub fn pivot_limit<S: Scalar>() -> S {
    S::ROOT_EPSILON
}

/// The rates at (t, x), refused if singular; lowers `worst` to the pivot met.
pub(super) fn evaluate<S: Scalar>(
    system: &mut impl Ode<S>,
    t: S,
    x: &[S],
    x_dot: &mut [S],
    worst: &mut S,
) -> Result<(), Fault> {
    accept(system.rates(t, x, x_dot)?, worst)
}

/// Refuses a pivot of a singular configuration; lowers `worst` to it else.
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

    /// Projects at the end `t` of the step and checks; returns the residual before the first projection. `before`
    /// is memory.
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
        // One comparison at the end for all numbers: v - v is 0, or not a number.
        let mut watched = residual;
        for ((low, b), x) in self.low.iter_mut().zip(&*before).zip(&*self.x) {
            // A coordinate that the projection has moved is determined by the others' rounded
            // values: its old rounding error has lost its meaning.
            *low = if rounds == 0 || *b == *x { *low } else { S::ZERO };
            let exact = *x + *low;
            watched = watched + (exact - exact);
        }
        if watched.is_finite() { Ok(residual) } else { Err(Fault::NonFinite) }
    }

    /// Makes it the state; takes whole turns off angles.
    pub(super) fn commit(&self, system: &impl Ode<S>, state: &mut State<'_, S>) {
        let new = self.x.iter().zip(&*self.low);
        for (index, (old, new)) in state.entries().zip(new).enumerate() {
            (*old.0, *old.1) = if system.is_angle(index) { wrap(*new.0, *new.1) } else { (*new.0, *new.1) };
        }
    }
}

/// The first `K` slices of `n` numbers of the scratch memory.
pub(super) fn split<S, const K: usize>(scratch: &mut [S], n: usize) -> Result<[&mut [S]; K], Fault> {
    if n == 0 || scratch.len() / n < K {
        return Err(Fault::Shape);
    }
    let mut parts = scratch.chunks_exact_mut(n);
    Ok(core::array::from_fn(|_| parts.next().unwrap_or_default()))
}

/// Whether state and system have the same length.
pub(super) fn check_shape<S: Scalar>(system: &impl Ode<S>, state: &State<'_, S>) -> Result<usize, Fault> {
    let n = system.n_x();
    if state.x().len() == n { Ok(n) } else { Err(Fault::Shape) }
}
