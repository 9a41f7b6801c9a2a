//! The fixed-step methods by name, for callers that choose one at run time.

use super::runge_kutta::{self, explicit_euler, rk4, semi_implicit_euler};
use super::splitting::{self, blanes_moan4, implicit_midpoint, verlet};
use super::state::State;
use super::system::Ode;
use super::trial::Report;
use crate::mechanism::Fault;
use crate::real::Scalar;

/// Fixed-step methods, chosen at run time.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Method {
    /// x + h f(x): order 1.
    ExplicitEuler,
    /// Speeds first, then coordinates with the new speeds: order 1, keeps energy bounded.
    SemiImplicitEuler,
    /// Kutta's classical method: order 4.
    Rk4,
    /// Velocity Verlet (half a kick, a drift, half a kick): order 2, conserves momentum.
    Verlet,
    /// Blanes & Moan's splitting: order 4 where forces do not depend on speeds, conserves momentum.
    BlanesMoan4,
    /// The implicit midpoint rule: order 2, conserves momentum.
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
