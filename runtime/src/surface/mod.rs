//! Surfaces for contact: the nearest point of a surface to a point, the gap, and the rates of the gap.
//!
//! In: a shape in the axes of a frame, the frame's pose and twist, a point and its velocity in N.
//! Out: signed gap g (> 0 apart), outward unit normal n, foot, and the first two rates of the gap:
//! ```text
//! g'  = n . w,                     w = v - v_O - omega x r          velocity relative to the frame, r from its origin
//! g'' = n . (a - a_O - alpha x r) + bias
//! bias = -n . (omega x (omega x r) + 2 omega x w) + w' H w          H: the shape's curvature seen from the point
//! ```
//! `shape` has half-space, sphere, capsule and box; `facet` the facets of a flexible body.

pub mod facet;
mod shape;

pub use shape::{Capsule, Cuboid, Feature, HalfSpace, Nearest, Shape, Sphere, Surface};

use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// A frame that may move: N itself, a rigid body, a port of a mechanism.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame<S> {
    /// Its origin in N (m).
    pub origin: Vec3<S>,
    /// Its axes in N, orthogonal unit vectors.
    pub axes: [Vec3<S>; 3],
    /// Velocity of the origin in N (m/s).
    pub velocity: Vec3<S>,
    /// Angular velocity in N (rad/s).
    pub angular_velocity: Vec3<S>,
}

impl<S: Scalar> Frame<S> {
    /// N itself.
    #[must_use]
    pub fn inertial() -> Frame<S> {
        let (zero, one) = (S::ZERO, S::ONE);
        let axes = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
        Frame { origin: vec3::zero(), axes, velocity: vec3::zero(), angular_velocity: vec3::zero() }
    }

    /// Components in the frame of a vector given in N.
    #[must_use]
    pub fn to_local(&self, a: Vec3<S>) -> Vec3<S> {
        vec3::apply(&self.axes, a)
    }

    /// Components in N of a vector given in the frame.
    #[must_use]
    pub fn to_inertial(&self, a: Vec3<S>) -> Vec3<S> {
        let ([x, y, z], [e1, e2, e3]) = (a, self.axes);
        vec3::axpy(vec3::axpy(vec3::scale(e1, x), y, e2), z, e3)
    }

    /// Coordinates in the frame of a point of N.
    #[must_use]
    pub fn place(&self, point: Vec3<S>) -> Vec3<S> {
        self.to_local(vec3::sub(point, self.origin))
    }

    /// The point of N with these coordinates in the frame.
    #[must_use]
    pub fn point(&self, place: Vec3<S>) -> Vec3<S> {
        vec3::add(self.origin, self.to_inertial(place))
    }

    /// Mean velocity v of the origin and mean angular velocity w from this pose to another within h (s), such that for
    /// every point of the frame x' - x = h (v + w x (r + r')/2), r from the origin (Cayley: |w| h = 2 tan(angle/2)).
    #[must_use]
    pub fn way_to(&self, other: &Frame<S>, h: S) -> (Vec3<S>, Vec3<S>) {
        let axes = || self.axes.into_iter().zip(other.axes);
        let turn = axes().fold(vec3::zero(), |sum, (old, new)| vec3::add(sum, vec3::cross(old, new)));
        let trace = axes().fold(S::ONE, |sum, (old, new)| sum + vec3::dot(old, new));
        let velocity = vec3::scale(vec3::sub(other.origin, self.origin), S::ONE / h);
        (velocity, vec3::scale(turn, S::from_f64(2.0) / (trace * h)))
    }

    /// Velocity in N of the point fixed in the frame that is at a point of N.
    #[must_use]
    pub fn velocity_at(&self, point: Vec3<S>) -> Vec3<S> {
        vec3::add(self.velocity, vec3::cross(self.angular_velocity, vec3::sub(point, self.origin)))
    }
}

/// Nearest point, gap and gap rate of a point and a surface, in N.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Proximity<S> {
    /// g (m), < 0 inside.
    pub gap: S,
    /// n, outwards.
    pub normal: Vec3<S>,
    /// The surface's nearest point (m).
    pub foot: Vec3<S>,
    /// g' (m/s).
    pub gap_rate: S,
    /// The part of g'' that does not depend on accelerations (m/s^2).
    pub bias: S,
}

/// Gap and its rates between a moving point and a surface in a moving frame.
pub fn proximity<S: Scalar>(
    surface: &impl Surface<S>,
    frame: &Frame<S>,
    point: Vec3<S>,
    velocity: Vec3<S>,
) -> Proximity<S> {
    let nearest = surface.nearest(frame.place(point));
    let normal = frame.to_inertial(nearest.normal);
    let (omega, r) = (frame.angular_velocity, vec3::sub(point, frame.origin));
    let carried = vec3::cross(omega, r);
    let relative = vec3::sub(vec3::sub(velocity, frame.velocity), carried);
    let turning = vec3::cross(omega, vec3::axpy(carried, S::from_f64(2.0), relative));
    Proximity {
        gap: nearest.gap,
        normal,
        foot: frame.point(nearest.foot),
        gap_rate: vec3::dot(normal, relative),
        bias: nearest.bend(frame.to_local(relative)) - vec3::dot(normal, turning),
    }
}
