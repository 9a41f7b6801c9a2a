//! Tension, force and energy of one spring-damper (thesis Eqs. 3.1, 3.2, 3.4, 3.5, 4.9).
//!
//! d = unit vector tail -> head, l = |head - tail|, s = l - L stretch, f = K s + C l_dot.
//! Sign: f > 0 pulls the ends together; +f d acts on the tail, -f d on the head.
//! A spring of length 0 has no direction and gives no force.

use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// A spring longer than this many rest lengths is a runaway: the body has no equilibrium.
///
/// Membranes of linear springs lose their last equilibrium below twice the rest length; the factor 4
/// lies beyond every overshoot of a body that still has one.
pub const STRETCH_LIMIT: f64 = 4.0;

/// Whether a spring of this length is beyond [`STRETCH_LIMIT`].
#[inline(always)]
pub(super) fn is_runaway<S: Scalar>(rest_length: S, length: S) -> bool {
    (rest_length > S::ZERO) & (length > S::from_f64(STRETCH_LIMIT) * rest_length)
}

/// One spring-damper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring<S> {
    /// Point at its start.
    pub tail: usize,
    /// Point at its end.
    pub head: usize,
    /// K (N/m), >= 0.
    pub stiffness: S,
    /// C along the spring (N s/m), >= 0.
    pub damping: S,
    /// L (m), >= 0.
    pub rest_length: S,
}

/// Direction, length and rate of length of a spring.
#[derive(Clone, Copy, Debug)]
pub struct Stretch<S> {
    /// Unit vector tail -> head, or 0.
    pub direction: Vec3<S>,
    /// Length (m).
    pub length: S,
    /// Rate of length (m/s).
    pub rate: S,
}

impl<S: Scalar> Spring<S> {
    /// Direction, length and rate of length at a state.
    #[must_use]
    pub fn stretch(&self, pos: &[Vec3<S>], vel: &[Vec3<S>]) -> Stretch<S> {
        let (direction, length) = self.direction(pos);
        let rate = vec3::dot(vec3::sub(vec3::at(vel, self.head), vec3::at(vel, self.tail)), direction);
        Stretch { direction, length, rate }
    }

    /// Unit vector tail -> head (0 at length 0), and length (m).
    #[must_use]
    pub fn direction(&self, pos: &[Vec3<S>]) -> (Vec3<S>, S) {
        vec3::direction(vec3::sub(vec3::at(pos, self.head), vec3::at(pos, self.tail)))
    }

    /// Elastic tension K (l - L) (N).
    #[must_use]
    pub fn tension(&self, length: S) -> S {
        self.stiffness * (length - self.rest_length)
    }

    /// Adds the elastic forces; returns whether the spring is a runaway, see [`STRETCH_LIMIT`].
    #[inline(always)]
    pub fn add_elastic(&self, pos: &[Vec3<S>], force: &mut [Vec3<S>]) -> bool {
        let (direction, length) = self.direction(pos);
        self.pull(vec3::scale(direction, self.tension(length)), force);
        is_runaway(self.rest_length, length)
    }

    /// Adds a force on the tail, towards the head, and its reaction on the head.
    pub fn pull(&self, pull: Vec3<S>, force: &mut [Vec3<S>]) {
        vec3::add_at(force, self.tail, pull);
        vec3::add_at(force, self.head, vec3::scale(pull, -S::ONE));
    }

    /// Stored energy K (l - L)^2 / 2 (J), Eq. 4.9.
    #[must_use]
    pub fn energy(&self, pos: &[Vec3<S>]) -> S {
        let (_, length) = self.direction(pos);
        let stretch = length - self.rest_length;
        S::from_f64(0.5) * self.stiffness * stretch * stretch
    }
}
