//! Methods of fixed step: explicit Euler, semi-implicit Euler, Kutta's method of order 4.
//!
//! In: state at t, step h. Out: state at t + h. Stage values are x + (low + h a k), rounded once.

use super::state::State;
use super::system::Ode;
use super::tableau::{self, Tableau};
use super::trial::{Report, Trial, check_shape, displace, evaluate, split};
use crate::mechanism::Fault;
use crate::real::{Constant, Scalar};

const KUTTA: Tableau<Constant, 4> = tableau::RK4.rounded();

/// Scratch numbers of [`explicit_euler`] for a state of `n` entries.
#[must_use]
pub const fn explicit_euler_scratch(n: usize) -> usize {
    3 * n
}

/// Scratch numbers of [`semi_implicit_euler`] for a state of `n` entries.
#[must_use]
pub const fn semi_implicit_euler_scratch(n: usize) -> usize {
    4 * n
}

/// Scratch numbers of [`rk4`] for a state of `n` entries.
#[must_use]
pub const fn rk4_scratch(n: usize) -> usize {
    5 * n
}

/// x(t + h) = x + h f(t, x). One evaluation, order 1, gains energy on every oscillation.
///
/// # Errors
/// See [`rk4`].
pub fn explicit_euler<S: Scalar>(
    system: &mut impl Ode<S>,
    t: S,
    h: S,
    state: &mut State<'_, S>,
    scratch: &mut [S],
) -> Result<Report<S>, Fault> {
    let n = check_shape(system, state)?;
    let [k, x, low] = split(scratch, n)?;
    let mut pivot = S::ONE;
    evaluate(system, t, state.x(), k, &mut pivot)?;
    let mut trial = Trial { x, low };
    trial.advance_from(state, k.iter().map(|k| h * *k));
    let residual = trial.settle(system, t + h, k)?;
    trial.commit(system, state);
    Ok(Report { pivot, residual })
}

/// u(t + h) = u + h u_dot(t, q, u), then q(t + h) = q + h q_dot(q, u(t + h)). Two evaluations, order 1;
/// symplectic where forces do not depend on speeds.
///
/// # Errors
/// See [`rk4`].
pub fn semi_implicit_euler<S: Scalar>(
    system: &mut impl Ode<S>,
    t: S,
    h: S,
    state: &mut State<'_, S>,
    scratch: &mut [S],
) -> Result<Report<S>, Fault> {
    let n = check_shape(system, state)?;
    let n_q = system.n_q();
    let [k, mixed, x, low] = split(scratch, n)?;
    let mut pivot = S::ONE;
    evaluate(system, t, state.x(), k, &mut pivot)?;
    let start = state.x().iter().zip(state.low()).enumerate();
    for ((mixed, (index, (x, low))), k) in mixed.iter_mut().zip(start).zip(&*k) {
        *mixed = if index < n_q { *x } else { *x + (*low + h * *k) };
    }
    let q_dot = x;
    evaluate(system, t, mixed, q_dot, &mut pivot)?;
    k.iter_mut().zip(&*q_dot).take(n_q).for_each(|(k, q_dot)| *k = *q_dot);
    let mut trial = Trial { x: q_dot, low };
    trial.advance_from(state, k.iter().map(|k| h * *k));
    let residual = trial.settle(system, t + h, mixed)?;
    trial.commit(system, state);
    Ok(Report { pivot, residual })
}

/// Kutta's classical method: four evaluations, order 4.
///
/// # Errors
/// [`Fault::Shape`] for wrong lengths; [`Fault::Singular`] or [`Fault::NonFinite`] if a stage or the
/// new state is; the system's own faults. The state is then unchanged, bit for bit.
pub fn rk4<S: Scalar>(
    system: &mut impl Ode<S>,
    t: S,
    h: S,
    state: &mut State<'_, S>,
    scratch: &mut [S],
) -> Result<Report<S>, Fault> {
    let n = check_shape(system, state)?;
    let [k, sum, stage, x, low] = split(scratch, n)?;
    let [b1, b2, b3, b4] = KUTTA.b.map(S::constant);
    let [_, c2, c3, c4] = KUTTA.c.map(S::constant);
    let mut pivot = S::ONE;
    // x is x + low, rounded, so the first stage is the state itself. Every later stage needs only the rates of the one
    // before.
    evaluate(system, t, state.x(), k, &mut pivot)?;
    sum.iter_mut().zip(&*k).for_each(|(sum, k)| *sum = b1 * *k);
    displace(stage, state.x(), state.low(), c2 * h, k);
    evaluate(system, t + c2 * h, stage, k, &mut pivot)?;
    add(sum, b2, k);
    displace(stage, state.x(), state.low(), c3 * h, k);
    evaluate(system, t + c3 * h, stage, k, &mut pivot)?;
    add(sum, b3, k);
    displace(stage, state.x(), state.low(), c4 * h, k);
    evaluate(system, t + c4 * h, stage, k, &mut pivot)?;
    let mut trial = Trial { x, low };
    trial.advance_from(state, sum.iter().zip(&*k).map(|(sum, k)| h * (*sum + b4 * *k)));
    let residual = trial.settle(system, t + h, stage)?;
    trial.commit(system, state);
    Ok(Report { pivot, residual })
}

/// Adds b k.
#[inline(always)]
fn add<S: Scalar>(sum: &mut [S], b: S, k: &[S]) {
    sum.iter_mut().zip(k).for_each(|(sum, k)| *sum = *sum + b * *k);
}
