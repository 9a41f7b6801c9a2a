//! Two bodies that meet at one point, and the progress of their impact along the normal impulse.

use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Inverse mass matrix at the point of contact [1/kg], rows n, t1, t2; symmetric, positive definite.
pub type InverseMass<S> = [Vec3<S>; 3];

/// Data of an impact at one point, at its start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch<S> {
    /// K [1/kg].
    pub inverse_mass: InverseMass<S>,
    /// v_0, relative velocity at the point: n, t1, t2 (m/s).
    pub velocity: Vec3<S>,
    /// Coulomb's mu, >= 0.
    pub friction: S,
    /// Stronge's e, 0 to 1.
    pub restitution: S,
}

/// An impact in progress.
#[derive(Clone, Copy)]
pub(super) struct Progress<S> {
    pub(super) impulse: Vec3<S>,
    pub(super) velocity: Vec3<S>,
    /// W_n since the collision or, in restitution, since the end of compression: no digits are lost where e is small.
    pub(super) work: S,
    /// p and W_n at the end of compression.
    pub(super) compression: Option<(S, S)>,
}

/// Bisections that leave less than an ulp of f64.
pub(super) const BISECTIONS: usize = 60;

/// Unit direction and speed of slip (m/s); no direction at rest.
pub(super) fn slip_of<S: Scalar>(velocity: Vec3<S>) -> ([S; 2], S) {
    let (direction, slip) = vec3::direction([S::ZERO, velocity[1], velocity[2]]);
    ([direction[1], direction[2]], slip)
}

impl<S: Scalar> Progress<S> {
    /// -e^2 W_c less the work that restitution has done (J); None in compression.
    pub(super) fn work_left(&self, restitution: S) -> Option<S> {
        let (_, least) = self.compression?;
        Some(-(restitution * restitution * least) - self.work)
    }

    /// Ends compression, at v_n = 0.
    pub(super) fn compressed(&mut self) {
        self.velocity[0] = S::ZERO;
        self.compression = Some((self.impulse[0], self.work));
        self.work = S::ZERO;
    }

    /// Returns to compression, at v_n = 0: slip has driven the bodies together again.
    pub(super) fn compresses_again(&mut self) {
        self.work = self.normal_work();
        (self.velocity[0], self.compression) = (S::ZERO, None);
    }

    pub(super) fn normal_work(&self) -> S {
        self.compression.map_or(self.work, |(_, least)| least + self.work)
    }
}
