//! Methods composed of midpoint rules: velocity Verlet, Blanes and Moan's splitting, the implicit midpoint rule.
//!
//! In: state at t, step h. Out: state at t + h. A kick changes speeds at fixed coordinates, a drift coordinates at
//! fixed speeds. Both solve d = h f(x + d/2) by iteration, and are exact where f does not depend on what they change.
//! Forces within a world are pairs (action and reaction), so kicks, drifts and their compositions conserve linear and
//! angular momentum to rounding (Hairer, Lubich & Wanner, Geometric Numerical Integration, II.5, VI.3).

use super::state::{State, advance};
use super::system::Ode;
use super::tableau::{self, BLANES_MOAN_DRIFTS, BLANES_MOAN_KICKS};
use super::trial::{Report, Trial, accept, check_shape, split};
use crate::mechanism::Fault;
use crate::real::{Constant, Scalar};

/// Most iterations of one midpoint rule; each reduces the error by the factor h |df/dx| / 2.
const ITERATIONS: usize = 100;
/// The iteration ends when it changes the state by no more than this many rounding units.
const SETTLED: f64 = 2.0;

/// Blanes and Moan's shares of the step, rounded to every scalar at compile time.
const KICKS: [Constant; 7] = tableau::row(BLANES_MOAN_KICKS);
const DRIFTS: [Constant; 7] = tableau::row(BLANES_MOAN_DRIFTS);

/// Scratch numbers of these methods for a state of `n` entries.
#[must_use]
pub const fn splitting_scratch(n: usize) -> usize {
    5 * n
}

/// Velocity Verlet: half a kick, a drift, half a kick. Order 2, symmetric; symplectic where forces do not depend on
/// speeds.
///
/// # Errors
/// See [`rk4`](super::rk4); [`Fault::Unsettled`] if the step is too long for the iteration to converge.
pub fn verlet<S: Scalar>(
    system: &mut impl Ode<S>,
    t: S,
    h: S,
    state: &mut State<'_, S>,
    scratch: &mut [S],
) -> Result<Report<S>, Fault> {
    let mut flow = Flow::new(system, t, state, scratch)?;
    let half = S::from_f64(0.5) * h;
    flow.kick(half)?;
    flow.drift(h)?;
    flow.kick(half)?;
    flow.finish(t + h, state)
}

/// Blanes & Moan (2002): seven kicks with six drifts between. Order 4 where forces do not depend on speeds and
/// coordinates follow speeds by constant factors, else 2.
///
/// # Errors
/// As [`verlet`].
pub fn blanes_moan4<S: Scalar>(
    system: &mut impl Ode<S>,
    t: S,
    h: S,
    state: &mut State<'_, S>,
    scratch: &mut [S],
) -> Result<Report<S>, Fault> {
    let mut flow = Flow::new(system, t, state, scratch)?;
    for (kick, drift) in KICKS.into_iter().zip(DRIFTS) {
        flow.kick(S::constant(kick) * h)?;
        flow.drift(S::constant(drift) * h)?;
    }
    flow.finish(t + h, state)
}

/// The implicit midpoint rule: coordinates and speeds at once. Order 2, symmetric, symplectic.
///
/// # Errors
/// As [`verlet`].
pub fn implicit_midpoint<S: Scalar>(
    system: &mut impl Ode<S>,
    t: S,
    h: S,
    state: &mut State<'_, S>,
    scratch: &mut [S],
) -> Result<Report<S>, Fault> {
    let mut flow = Flow::new(system, t, state, scratch)?;
    flow.midpoint(Moving::All, t + S::from_f64(0.5) * h, h)?;
    flow.finish(t + h, state)
}

/// The part of the state that a midpoint rule changes.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Moving {
    Speeds,
    Coordinates,
    All,
}

/// A state in the course of a step.
struct Flow<'a, S, O> {
    system: &'a mut O,
    /// Time that the coordinates have reached.
    t: S,
    trial: Trial<'a, S>,
    change: &'a mut [S],
    rates: &'a mut [S],
    middle: &'a mut [S],
    pivot: S,
}

impl<'a, S: Scalar, O: Ode<S>> Flow<'a, S, O> {
    fn new(system: &'a mut O, t: S, state: &State<'_, S>, scratch: &'a mut [S]) -> Result<Self, Fault> {
        let n = check_shape(system, state)?;
        let [change, rates, middle, x, low] = split(scratch, n)?;
        let mut trial = Trial { x, low };
        trial.advance_from(state, core::iter::repeat_n(S::ZERO, n));
        Ok(Flow { system, t, trial, change, rates, middle, pivot: S::ONE })
    }

    /// Changes the speeds by the forces at the present coordinates.
    fn kick(&mut self, h: S) -> Result<(), Fault> {
        self.midpoint(Moving::Speeds, self.t, h)
    }

    /// Changes the coordinates by the present speeds.
    fn drift(&mut self, h: S) -> Result<(), Fault> {
        if h == S::ZERO {
            return Ok(());
        }
        self.midpoint(Moving::Coordinates, self.t + S::from_f64(0.5) * h, h)?;
        self.t = self.t + h;
        Ok(())
    }

    /// Solves d = h f(t, x + d/2) for the part that moves; the rest is held.
    fn midpoint(&mut self, moving: Moving, t: S, h: S) -> Result<(), Fault> {
        let (n_q, n) = (self.system.n_q(), self.system.n_x());
        let range = match moving {
            Moving::Speeds => n_q..n,
            Moving::Coordinates => 0..n_q,
            Moving::All => 0..n,
        };
        let is_exact = moving == Moving::Speeds && !self.system.is_damped();
        self.change.fill(S::ZERO);
        // Changes made by the last two iterations: errors pass between coordinates and speeds, so that only every
        // second change is smaller.
        let mut before = [S::ONE / S::ZERO; 2];
        // Share of each change that is made. Friction turns against a slip by more than the slip has turned where
        // little slip is left: an iteration that gains nothing then makes half the changes.
        let mut share = S::ONE;
        for _ in 0..ITERATIONS {
            self.evaluate(moving, t)?;
            let (step, size) = self.improve((h, share), range.clone())?;
            let settled = step <= S::from_f64(SETTLED) * S::EPSILON * size;
            // A change that no longer shrinks is rounding noise below the root of the rounding unit, and where it moves
            // no coordinate by more than its rounding: balanced forces leave noise at rest, too.
            let is_small = || {
                step <= S::EPSILON.sqrt() * size
                    || moving == Moving::Speeds && h.abs() * step <= self.rounding_of_coordinates()
            };
            let is_rounding = step >= before[0] && is_small();
            if is_exact || settled || is_rounding {
                self.advance();
                return Ok(());
            }
            if step >= before[0] {
                share = S::from_f64(0.5) * share;
            }
            before = [before[1], step];
        }
        Err(Fault::Unsettled)
    }

    /// Rounding of the largest coordinate.
    fn rounding_of_coordinates(&self) -> S {
        let coordinates = self.trial.x.iter().take(self.system.n_q());
        S::EPSILON * coordinates.fold(S::ZERO, |most, q| most.max(q.abs()))
    }

    /// Rates at the midpoint x + d/2.
    fn evaluate(&mut self, moving: Moving, t: S) -> Result<(), Fault> {
        let half = S::from_f64(0.5);
        let start = self.trial.x.iter().zip(&*self.trial.low).zip(&*self.change);
        for (middle, ((x, low), change)) in self.middle.iter_mut().zip(start) {
            *middle = *x + (*low + half * *change);
        }
        let pivot = match moving {
            Moving::Coordinates => self.system.coordinate_rates(t, self.middle, self.rates)?,
            Moving::Speeds | Moving::All => self.system.rates(t, self.middle, self.rates)?,
        };
        accept(pivot, &mut self.pivot)
    }

    /// Moves d by a share of the way to h f; returns the largest entry of that way and the size of the state.
    fn improve(&mut self, (h, share): (S, S), range: core::ops::Range<usize>) -> Result<(S, S), Fault> {
        let (mut step, mut size) = (S::ZERO, S::ZERO);
        let rows = self.change.iter_mut().zip(&*self.rates).zip(&*self.trial.x);
        for ((change, rate), x) in rows.take(range.end).skip(range.start) {
            let next = h * *rate;
            if !next.is_finite() {
                return Err(Fault::NonFinite);
            }
            let way = next - *change;
            step = step.max(way.abs());
            size = size.max(x.abs()).max(next.abs());
            *change = if share < S::ONE { *change + share * way } else { next };
        }
        Ok((step, size))
    }

    fn advance(&mut self) {
        let state = self.trial.x.iter_mut().zip(self.trial.low.iter_mut());
        for ((x, low), change) in state.zip(&*self.change) {
            (*x, *low) = advance(*x, *low, *change);
        }
    }

    /// Projects, checks, and commits.
    fn finish(mut self, t: S, state: &mut State<'_, S>) -> Result<Report<S>, Fault> {
        let residual = self.trial.settle(self.system, t, self.middle)?;
        self.trial.commit(self.system, state);
        Ok(Report { pivot: self.pivot, residual })
    }
}
