//! Contacts of several rigid bodies: relative velocities at them, and what impulses at them do.
//!
//! In: bodies as [`Mobility`] (what they yield) and [`Twist`] (how they move), contacts by number of body. Out: W u and
//! M^-1 W' P, one contact at a time: no matrix over all contacts is formed, work grows with their number.

use super::impact::InverseMass;
use super::{RigidBody, RigidState, contact_axes};
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// What a body yields to an impulse; nothing, if it is fixed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mobility<S> {
    /// 1/m (1/kg).
    pub inverse_mass: S,
    /// J^-1 in N (1/(kg m^2)), rows; symmetric.
    pub inverse_inertia: [Vec3<S>; 3],
}

/// Velocities, or changes of them, or accelerations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Twist<S> {
    /// Of the centre of mass, in N.
    pub velocity: Vec3<S>,
    /// Angular, in N.
    pub angular: Vec3<S>,
}

/// A contact of two bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact<S> {
    /// Numbers of the bodies; the normal points from the second to the first.
    pub bodies: [usize; 2],
    /// n, t1, t2 in N.
    pub axes: [Vec3<S>; 3],
    /// The point from the two centres of mass (m, in N).
    pub arms: [Vec3<S>; 2],
    /// Coulomb's mu, >= 0.
    pub friction: S,
    /// e, 0 to 1.
    pub restitution: S,
    /// Impulse (N s) or force (N) on the first body: n, t1, t2.
    pub impulse: Vec3<S>,
}

impl<S: Scalar> Mobility<S> {
    /// Of a body that nothing moves.
    #[must_use]
    pub fn fixed() -> Mobility<S> {
        Mobility { inverse_mass: S::ZERO, inverse_inertia: [vec3::zero(); 3] }
    }

    /// Of a body at a state.
    #[must_use]
    pub fn of(body: &RigidBody<S>, state: &RigidState<S>) -> Mobility<S> {
        let (zero, one) = (S::ZERO, S::ONE);
        let axes = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
        let inverse_inertia = axes.map(|axis| body.inverse_inertia(&state.attitude, axis));
        Mobility { inverse_mass: one / body.mass, inverse_inertia }
    }
}

impl<S: Scalar> Twist<S> {
    /// At rest.
    #[must_use]
    pub fn zero() -> Twist<S> {
        Twist { velocity: vec3::zero(), angular: vec3::zero() }
    }

    /// Of the point at r from the centre of mass.
    #[must_use]
    pub fn at(&self, r: Vec3<S>) -> Vec3<S> {
        vec3::add(self.velocity, vec3::cross(self.angular, r))
    }
}

impl<S: Scalar> Contact<S> {
    /// A contact at a point of N with this normal between bodies whose centres of mass are known.
    #[must_use]
    pub fn new(bodies: [usize; 2], point: Vec3<S>, normal: Vec3<S>, centers: [Vec3<S>; 2]) -> Contact<S> {
        Contact {
            bodies,
            axes: contact_axes(normal),
            arms: centers.map(|center| vec3::sub(point, center)),
            friction: S::ZERO,
            restitution: S::ZERO,
            impulse: vec3::zero(),
        }
    }

    /// The velocity of the first body relative to the second at the point: n, t1, t2 (m/s).
    #[must_use]
    pub fn relative(&self, twists: &[Twist<S>]) -> Vec3<S> {
        let [one, other] = self.bodies.map(|k| twists.get(k).copied().unwrap_or_else(Twist::zero));
        let [r, s] = self.arms;
        vec3::apply(&self.axes, vec3::sub(one.at(r), other.at(s)))
    }

    /// K (1/kg): the change of the relative velocity under unit impulses along n, t1, t2.
    #[must_use]
    pub fn inverse_mass(&self, mobilities: &[Mobility<S>]) -> InverseMass<S> {
        let column = |d: Vec3<S>| {
            let mut sum = vec3::zero();
            for (body, arm) in self.bodies.iter().zip(self.arms) {
                if let Some(m) = mobilities.get(*body) {
                    let turned = vec3::apply(&m.inverse_inertia, vec3::cross(arm, d));
                    sum = vec3::add(sum, vec3::axpy(vec3::cross(turned, arm), m.inverse_mass, d));
                }
            }
            vec3::apply(&self.axes, sum)
        };
        let [[nn, xn, yn], [_, xx, yx], [_, _, yy]] = self.axes.map(column);
        [[nn, xn, yn], [xn, xx, yx], [yn, yx, yy]]
    }

    /// Components in N of an impulse n, t1, t2.
    #[must_use]
    pub fn to_inertial(&self, impulse: Vec3<S>) -> Vec3<S> {
        let ([n, t1, t2], [pn, p1, p2]) = (self.axes, impulse);
        vec3::axpy(vec3::axpy(vec3::scale(n, pn), p1, t1), p2, t2)
    }

    /// Changes the twists of both bodies by an impulse n, t1, t2 on the first and its opposite on the second.
    pub fn push(&self, mobilities: &[Mobility<S>], twists: &mut [Twist<S>], impulse: Vec3<S>) {
        let impulse = self.to_inertial(impulse);
        for (number, sense) in [S::ONE, -S::ONE].into_iter().enumerate() {
            let (body, arm) = (self.bodies[number], self.arms[number]);
            if let (Some(m), Some(twist)) = (mobilities.get(body), twists.get_mut(body)) {
                let turned = vec3::apply(&m.inverse_inertia, vec3::cross(arm, impulse));
                twist.velocity = vec3::axpy(twist.velocity, sense * m.inverse_mass, impulse);
                twist.angular = vec3::axpy(twist.angular, sense, turned);
            }
        }
    }
}

/// Solves K_tt x = y for the tangential block; y itself where the block is singular (nothing moves).
#[must_use]
pub(super) fn solve_tangential<S: Scalar>(k: &InverseMass<S>, [x, y]: [S; 2]) -> [S; 2] {
    let [_, [_, a, b], [_, _, c]] = *k;
    let determinant = a * c - b * b;
    if determinant > S::ZERO {
        [(c * x - b * y) / determinant, (a * y - b * x) / determinant]
    } else {
        [x, y]
    }
}

/// The nearest point of the disc of this radius.
#[must_use]
pub(super) fn onto_disc<S: Scalar>([x, y]: [S; 2], radius: S) -> [S; 2] {
    let size = (x * x + y * y).sqrt();
    if size > radius { [x * (radius / size), y * (radius / size)] } else { [x, y] }
}
