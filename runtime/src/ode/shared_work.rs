//! Kutta's method for equations whose evaluations within a step share work.
//!
//! In: state at t, step h. Out: state at t + h. The first evaluation also corrects the state onto the constraints, with
//! the sines, coefficients and pivots that the rates need anyway, and hands its sines and cosines to the other
//! evaluations, at states close by. The correction thus comes at the beginning of a step: its end is off the
//! constraints by its own error.

use super::state::{State, advance};
use super::system::Ode;
use super::trial::{Report, Trial, accept, check_shape, displace, split};
use crate::mechanism::Fault;
use crate::real::{Constant, Real, Scalar};

/// Results of the first evaluation of a step.
#[derive(Clone, Copy, Debug)]
pub struct Begun<S, N> {
    /// Worst pivot, as [`Ode::rates`] returns it.
    pub pivot: S,
    /// Largest residual of the constraints before the correction.
    pub residual: S,
    /// Data with which the evaluations close by begin.
    pub near: N,
}

/// Equations whose evaluations in a step share work.
pub trait SharedWork<S: Real>: Ode<S> {
    /// Data that the first evaluation hands on: sines and cosines.
    type Near;
    /// Writes the rates at (t, x), then corrects x once towards the constraints. The rates are those before the
    /// correction; they are off by its size, which is of the order of the step's own error.
    ///
    /// # Errors
    /// As [`Ode::rates`] and [`Ode::project`].
    fn begin(&mut self, t: S, x: &mut [S], x_dot: &mut [S]) -> Result<Begun<S, Self::Near>, Fault>;
    /// [`Ode::rates`] at a state close to that of `near`.
    ///
    /// # Errors
    /// As [`Ode::rates`].
    fn rates_near(&mut self, t: S, x: &[S], x_dot: &mut [S], near: &Self::Near) -> Result<S, Fault>;
    /// Whether the correction determines entry `index` of x: its rounding error is then not carried on as state.
    fn is_corrected(&self, index: usize) -> bool;
}

/// Scratch numbers of [`rk4_shared`] for a state of `n` entries.
#[must_use]
pub const fn rk4_shared_scratch(n: usize) -> usize {
    6 * n
}

/// [`rk4`](super::rk4) for equations that share work: the state is corrected at the beginning of the step.
///
/// # Errors
/// As [`rk4`](super::rk4).
pub fn rk4_shared<S: Scalar>(
    system: &mut impl SharedWork<S>,
    t: S,
    h: S,
    state: &mut State<'_, S>,
    scratch: &mut [S],
) -> Result<Report<S>, Fault> {
    let n = check_shape(system, state)?;
    let [start, stage, k1, k2, k3, k4] = split(scratch, n)?;
    let half = S::from_f64(0.5) * h;
    let mut pivot = S::ONE;
    start.iter_mut().zip(state.x()).for_each(|(start, x)| *start = *x);
    let begun = system.begin(t, start, k1)?;
    accept(begun.pivot, &mut pivot)?;
    let near = &begun.near;
    displace(stage, start, state.low(), half, k1);
    accept(system.rates_near(t + half, stage, k2, near)?, &mut pivot)?;
    displace(stage, start, state.low(), half, k2);
    accept(system.rates_near(t + half, stage, k3, near)?, &mut pivot)?;
    displace(stage, start, state.low(), h, k3);
    accept(system.rates_near(t + h, stage, k4, near)?, &mut pivot)?;
    // h/6 (k1 + 2 (k2 + k3) + k4)
    let sixth = S::constant(const { Constant::new(1.0 / 6.0) }) * h;
    let old = start.iter().zip(state.low());
    let rates = k1.iter().zip(&*k2).zip(&*k3).zip(k4.iter_mut());
    // One check for all entries: a value that is not finite makes the sum so, and `low` is finite where x is.
    let mut sum = S::ZERO;
    for (index, ((x, old), (((k1, k2), k3), k4))) in stage.iter_mut().zip(old).zip(rates).enumerate() {
        let middle = *k2 + *k3;
        let delta = sixth * ((*k1 + *k4) + (middle + middle));
        let low = k4;
        (*x, *low) = if system.is_corrected(index) {
            (*old.0 + delta, S::ZERO)
        } else {
            advance(*old.0, *old.1, delta)
        };
        sum = sum + *x;
    }
    if !sum.is_finite() {
        return Err(Fault::NonFinite);
    }
    Trial { x: stage, low: k4 }.commit(system, state);
    Ok(Report { pivot, residual: begun.residual })
}
