//! Given accelerations: y' = T u' + beta with u' known, so that every acceleration is a value instead of a linear form.
//!
//! In: motions and rates with biases at y' = 0, and u'. Out: the same with the bias at that y'. The bias forces derived
//! from such motions are then the whole inertia force: the Newton-Euler recursion (Luh, Walker, Paul 1980) instead of M
//! u', which would need a mass matrix.

use crate::expr::ExprId;
use crate::kinematics::eliminate::Solution;
use crate::kinematics::{Kinematics, LinearForm, Motion, Rate, UnknownId};
use crate::vector::Algebra;

/// y' of every unknown; empty if accelerations are not given.
#[derive(Clone, Debug, Default)]
pub(crate) struct Given(LinearForm);

impl Given {
    /// Derivatives of all unknowns that follow from those of the independent speeds.
    pub fn new(alg: &mut Algebra, k: &Kinematics, solution: &Solution, u_dot: &[ExprId]) -> Self {
        let y_dot = k.unknowns.independent().into_iter().zip(u_dot.iter().copied()).collect();
        Self(solution.derivatives(alg, y_dot))
    }

    /// Derivatives of all unknowns but the clock.
    pub fn all(y_dot: LinearForm) -> Self {
        Self(y_dot)
    }

    /// Are accelerations given?
    pub fn is_given(&self) -> bool {
        !self.0.is_empty()
    }

    /// The derivative of an unknown.
    pub fn of(&self, unknown: UnknownId) -> Option<ExprId> {
        self.0.get(&unknown).copied()
    }

    /// The motion with its whole acceleration as bias.
    pub fn motion(&self, alg: &mut Algebra, mut motion: Motion) -> Motion {
        for (unknown, partial) in &motion.partials {
            if let Some(y_dot) = self.of(*unknown) {
                let term = partial.scaled(&mut alg.dag, y_dot);
                motion.bias = motion.bias.plus(&mut alg.dag, &term);
            }
        }
        motion
    }

    /// The rate with its whole derivative as bias.
    pub fn rate(&self, alg: &mut Algebra, mut rate: Rate) -> Rate {
        for (unknown, &partial) in &rate.partials {
            if let Some(y_dot) = self.of(*unknown) {
                let term = alg.dag.mul(partial, y_dot);
                rate.bias = alg.dag.add(rate.bias, term);
            }
        }
        rate
    }
}
