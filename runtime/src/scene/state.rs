//! The state of a body on the ground between steps.

use crate::contact::compensation::PointImpact;
use crate::contact::{ContactState, Repertoire, System};
use crate::ode::nodes::{Motion, Step};
use crate::real::Scalar;
use crate::vec3;

/// The quantities that a step advances.
#[derive(Debug)]
pub struct State<'a, S> {
    /// Positions, velocities, forces.
    pub motion: Motion<'a, S>,
    /// Contact state of each point.
    pub modes: &'a mut [ContactState],
    /// Impulses of the last impact.
    pub impacts: &'a mut [PointImpact<S>],
    /// Time (s) and its rounding error.
    pub time: [S; 2],
    /// Length of the next step of an adaptive method (s); 0 before the first step.
    pub next_step: S,
    /// Energy that an undamped body should have (J); used only by the anchored compensation law.
    pub anchor: S,
}

impl<S: Scalar> State<'_, S> {
    /// Time (s).
    #[must_use]
    pub fn t(&self) -> S {
        self.time[0]
    }

    /// Excess of the total energy over its mean, because it oscillates with the vibrations in Verlet's method (J).
    ///
    /// For a linear body Verlet conserves m v^2/2 + V + h^2 (alpha v.V''v - (1/8 - alpha) m |a|^2), for every alpha;
    /// with alpha = 1/16 its mean is that of the total energy. A touch removes a point's acceleration and would thereby
    /// raise that mean, if it left the total energy of the instant unchanged.
    pub(super) fn energy_swing<R: Repertoire<S>>(
        &self,
        system: &System<S, R>,
        h: S,
        method: R::Method,
        mode: impl Fn(usize) -> ContactState,
    ) -> S {
        if !method.is_verlet() {
            return S::ZERO;
        }
        let mut sum = S::ZERO;
        for (i, mass) in system.body.mass.iter().enumerate() {
            let a = system.acceleration(i, mode(i), self.motion.force(i));
            sum = sum + *mass * vec3::dot(a, a);
        }
        for spring in system.body.springs {
            let rate = spring.stretch(self.motion.pos, self.motion.vel).rate;
            sum = sum - spring.stiffness * rate * rate;
        }
        S::from_f64(1.0 / 16.0) * h * h * sum
    }

    pub(super) fn pass(&mut self, tau: S) {
        let change = tau + self.time[1];
        let sum = self.time[0] + change;
        let part = sum - self.time[0];
        self.time = [sum, (self.time[0] - (sum - part)) + (change - part)];
    }
}
