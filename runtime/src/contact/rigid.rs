//! Impact of a rigid body, point by point along its normal impulse (thesis Eqs. 4.2 to 4.4, 4.14 to 4.26; Stronge 1990).
//!
//! Without friction the rate of the touching point grows with the impulse, v = v_0 + P/M (Eq. 4.17), so the
//! work of the ground is W(P) = v_0 P + P^2/(2 M) (Eq. 4.25 integrated). Compression ends at v = 0 with
//! P_c = -M v_0 and W_c = -M v_0^2/2; restitution ends where Eq. 4.4 holds, W_f = (1 - e^2) W_c, at
//! P_f = (1 + e) P_c. M is the mass that the body shows at the point, 1/M = 1/m + (r x n).J^-1 (r x n).
//! Signs: v along the outward normal, v_0 < 0 closing; P >= 0; W < 0 where the body loses energy.

use crate::body::vec3::{self, Vec3};
use crate::real::Scalar;

/// A rigid body at the instant of touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidBody<S> {
    /// m (kg).
    pub mass: S,
    /// Inverse of the inertia about the centre of mass, rows [1/(kg m^2)].
    pub inverse_inertia: [Vec3<S>; 3],
    /// Velocity of the centre of mass (m/s).
    pub velocity: Vec3<S>,
    /// Angular velocity (rad/s).
    pub spin: Vec3<S>,
}

/// Work and impulse of one impact: the two ends of its phases.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorkImpulse<S> {
    /// v_0: rate of the gap before (m/s).
    pub approach: S,
    /// M (kg).
    pub mass: S,
    /// P_c (N s).
    pub compression: S,
    /// P_f (N s).
    pub last: S,
}

impl<S: Scalar> WorkImpulse<S> {
    /// The impact of a point that shows the mass M and moves at v_0 < 0, with energetic restitution e.
    #[must_use]
    pub fn new(approach: S, mass: S, restitution: S) -> WorkImpulse<S> {
        let compression = (-(mass * approach)).max(S::ZERO);
        WorkImpulse { approach, mass, compression, last: (S::ONE + restitution) * compression }
    }

    /// v(P) = v_0 + P/M (m/s), Eq. 4.17.
    #[must_use]
    pub fn rate(&self, impulse: S) -> S {
        self.approach + impulse / self.mass
    }

    /// W(P) (J): the integral of v dP, Eqs. 4.24 and 4.25; the curve of Fig. 4.2.
    #[must_use]
    pub fn work(&self, impulse: S) -> S {
        impulse * (self.approach + S::from_f64(0.5) * impulse / self.mass)
    }
}

impl<S: Scalar> RigidBody<S> {
    /// Velocity of the point at r from the centre of mass (m/s).
    #[must_use]
    pub fn point_velocity(&self, r: Vec3<S>) -> Vec3<S> {
        vec3::add(self.velocity, vec3::cross(self.spin, r))
    }

    /// Change of the angular velocity by an angular impulse.
    fn turn(&self, moment: Vec3<S>) -> Vec3<S> {
        self.inverse_inertia.map(|row| vec3::dot(row, moment))
    }

    /// M at the point r along n (kg).
    #[must_use]
    pub fn effective_mass(&self, r: Vec3<S>, normal: Vec3<S>) -> S {
        let arm = vec3::cross(r, normal);
        S::ONE / (S::ONE / self.mass + vec3::dot(arm, self.turn(arm)))
    }

    /// Strikes a ground of outward normal n at r; a point that does not close is left alone.
    pub fn strike(&mut self, r: Vec3<S>, normal: Vec3<S>, restitution: S) -> WorkImpulse<S> {
        let approach = vec3::dot(self.point_velocity(r), normal);
        let impact = WorkImpulse::new(approach, self.effective_mass(r, normal), restitution);
        self.velocity = vec3::axpy(self.velocity, impact.last / self.mass, normal);
        let turned = self.turn(vec3::cross(r, normal));
        self.spin = vec3::axpy(self.spin, impact.last, turned);
        impact
    }
}
