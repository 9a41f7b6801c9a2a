//! Ordinary differential equations q_dot = N(q) u, u_dot = f(t, q, u), and one step of them, refused or taken as a whole.
//!
//! An [`Ode`] writes both rates of x = [q, u]; the state is a compensated sum ([`state`]). Methods of any ode:
//! [`runge_kutta`] and [`splitting`] (fixed steps), [`dormand_prince`] (steps by the error, [`step_size`]). All coefficients stand in
//! [`tableau`]; an event within a step is found by [`root`]. [`Driven`] makes an ode of a mechanism and a law.
//!
//! One step: stages, trial state, a fixed number of projections onto the constraints, the check, and only
//! then the commit. Whatever is refused leaves the state as it was, bit for bit: a pivot below
//! [`pivot_limit`], a value that is not finite, slices of wrong length, a fault of the system.
//! Memory is the caller's: `scratch` holds as many numbers as the method's `scratch` function says.

pub mod dormand_prince;
pub mod driven;
pub mod nodes;
pub mod root;
pub mod runge_kutta;
pub mod splitting;
pub mod state;
pub mod step_size;
pub mod tableau;

pub use dormand_prince::DormandPrince;
pub use driven::Driven;
pub use runge_kutta::{explicit_euler, rk4, semi_implicit_euler};
pub use splitting::{blanes_moan4, implicit_midpoint, verlet};
pub use state::State;

use crate::mechanism::Fault;
use crate::real::{Real, Scalar};
use state::{advance, wrap};

/// Ordinary differential equations x_dot = f(t, x), perhaps with constraints to be projected onto.
pub trait Ode<S: Real> {
    /// Length of x.
    fn n_x(&self) -> usize;
    /// How many leading entries of x are coordinates; the rest are speeds.
    fn n_q(&self) -> usize;
    /// Writes x_dot and returns the worst pivot (see [`Mechanism::rates`](crate::mechanism::Mechanism::rates); 1 if there is none).
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not `n_x` entries.
    fn rates(&mut self, t: S, x: &[S], x_dot: &mut [S]) -> Result<S, Fault>;
    /// Writes the rates of the coordinates; what it writes for the speeds does not count. Cheaper than [`Ode::rates`] where
    /// forces are dear.
    ///
    /// # Errors
    /// As [`Ode::rates`].
    fn coordinate_rates(&mut self, t: S, x: &[S], x_dot: &mut [S]) -> Result<S, Fault> {
        self.rates(t, x, x_dot)
    }
    /// Whether the rates of the speeds depend on the speeds.
    fn is_damped(&self) -> bool {
        true
    }
    /// The time at which the next projections are asked for (see [`Mechanism::set_time`](crate::mechanism::Mechanism::set_time)).
    fn set_time(&mut self, t: S) {
        let _ = t;
    }
    /// One correction towards the constraints; returns the largest residual before it.
    ///
    /// # Errors
    /// [`Fault::Shape`] if `x` has not `n_x` entries.
    fn project(&mut self, x: &mut [S]) -> Result<S, Fault> {
        let _ = x;
        Ok(S::ZERO)
    }
    /// Corrections after each step: 0 without constraints, else 1, at most 2.
    fn projections(&self) -> u8 {
        0
    }
    /// Whether whole turns may be taken off entry `index` of x.
    fn is_angle(&self, index: usize) -> bool {
        let _ = index;
        false
    }
}

/// Methods of fixed step, for callers that choose at run time.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Method {
    /// x + h f(x): order 1.
    ExplicitEuler,
    /// Speeds first, then coordinates with the new speeds: order 1, keeps energy bounded.
    SemiImplicitEuler,
    /// Kutta's classical method: order 4.
    Rk4,
    /// Half a kick, a drift, half a kick: order 2, keeps momentum.
    Verlet,
    /// Blanes & Moan's splitting: order 4 where forces do not depend on speeds, keeps momentum.
    BlanesMoan4,
    /// The implicit midpoint rule: order 2, keeps momentum.
    ImplicitMidpoint,
}

impl Method {
    /// Numbers of scratch memory for a state of `n` entries.
    #[must_use]
    pub const fn scratch(self, n: usize) -> usize {
        match self {
            Self::ExplicitEuler => runge_kutta::explicit_euler_scratch(n),
            Self::SemiImplicitEuler => runge_kutta::semi_implicit_euler_scratch(n),
            Self::Rk4 => runge_kutta::rk4_scratch(n),
            Self::Verlet | Self::BlanesMoan4 | Self::ImplicitMidpoint => splitting::splitting_scratch(n),
        }
    }

    /// One step from `t` to `t + h`.
    ///
    /// # Errors
    /// See [`rk4`]; the state is then unchanged.
    pub fn step<S: Scalar>(
        self,
        system: &mut impl Ode<S>,
        t: S,
        h: S,
        state: &mut State<'_, S>,
        scratch: &mut [S],
    ) -> Result<Report<S>, Fault> {
        match self {
            Self::ExplicitEuler => explicit_euler(system, t, h, state, scratch),
            Self::SemiImplicitEuler => semi_implicit_euler(system, t, h, state, scratch),
            Self::Rk4 => rk4(system, t, h, state, scratch),
            Self::Verlet => verlet(system, t, h, state, scratch),
            Self::BlanesMoan4 => blanes_moan4(system, t, h, state, scratch),
            Self::ImplicitMidpoint => implicit_midpoint(system, t, h, state, scratch),
        }
    }
}

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
    S::EPSILON.sqrt()
}

/// The rates at (t, x), refused if singular; lowers `worst` to the pivot met.
fn evaluate<S: Scalar>(
    system: &mut impl Ode<S>,
    t: S,
    x: &[S],
    x_dot: &mut [S],
    worst: &mut S,
) -> Result<(), Fault> {
    accept(system.rates(t, x, x_dot)?, worst)
}

/// Refuses a pivot of a singular configuration; lowers `worst` to it else.
fn accept<S: Scalar>(pivot: S, worst: &mut S) -> Result<(), Fault> {
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
struct Trial<'a, S> {
    x: &'a mut [S],
    low: &'a mut [S],
}

impl<S: Scalar> Trial<'_, S> {
    /// state + delta.
    #[inline(always)]
    fn advance_from(&mut self, state: &State<'_, S>, delta: impl Iterator<Item = S>) {
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
    fn settle(&mut self, system: &mut impl Ode<S>, t: S, before: &mut [S]) -> Result<S, Fault> {
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
    fn commit(&self, system: &impl Ode<S>, state: &mut State<'_, S>) {
        let new = self.x.iter().zip(&*self.low);
        for (index, (old, new)) in state.entries().zip(new).enumerate() {
            (*old.0, *old.1) = if system.is_angle(index) { wrap(*new.0, *new.1) } else { (*new.0, *new.1) };
        }
    }
}

/// The first `K` slices of `n` numbers of the scratch memory.
fn split<S, const K: usize>(scratch: &mut [S], n: usize) -> Result<[&mut [S]; K], Fault> {
    if n == 0 || scratch.len() / n < K {
        return Err(Fault::Shape);
    }
    let mut parts = scratch.chunks_exact_mut(n);
    Ok(core::array::from_fn(|_| parts.next().unwrap_or_default()))
}

/// Whether state and system have the same length.
fn check_shape<S: Scalar>(system: &impl Ode<S>, state: &State<'_, S>) -> Result<usize, Fault> {
    let n = system.n_x();
    if state.x().len() == n { Ok(n) } else { Err(Fault::Shape) }
}
