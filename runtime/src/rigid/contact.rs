//! Contacts between bodies of any kind: relative velocities at them, and velocity changes by impulses.
//!
//! In: velocities of the bodies ([`Twist`]), their inverse inertia ([`Inertia`]), contacts that refer to bodies by
//! index. Out: W u and M^-1 W' P, one contact at a time: no matrix over all contacts is formed, so work grows with
//! their number.
//!
//! A [`Side`] of a contact is a weighted sum of points of bodies: no point (fixed in space), a point of a rigid body or
//! of a port, a node (a point without arm), a facet (its corners by weight, each a node or a point of the body that
//! holds it). A point that is off a facet is carried along by the facet's turning: see [`Contact::couple`].

use super::impact::InverseMass;
use super::{RigidBody, RigidState, contact_axes};
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Inverse inertia of a free rigid body; 0 if it is fixed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mobility<S> {
    /// 1/m (1/kg).
    pub inverse_mass: S,
    /// J^-1 in N (1/(kg m^2)), rows; symmetric.
    pub inverse_inertia: [Vec3<S>; 3],
}

/// Velocities, changes of velocities, or accelerations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Twist<S> {
    /// Of the centre of mass, in N.
    pub velocity: Vec3<S>,
    /// Angular velocity in N.
    pub angular: Vec3<S>,
}

/// A point of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point<S> {
    /// Index of the body.
    pub body: usize,
    /// Arm from the body's origin, the reference point of its twist (m, in N).
    pub arm: Vec3<S>,
    /// Weight of the point in the side's velocity, and in the impulse on the side.
    pub weight: S,
}

/// One side of a contact: the weighted sum of its points; without points it is fixed in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Side<S> {
    points: [Point<S>; 4],
    count: usize,
}

/// Response of velocities to impulses at points of bodies.
pub trait Inertia<S: Scalar> {
    /// Change of the velocity of the point `seen` caused by an impulse (N s, in N) at the point `at`; weights are
    /// ignored.
    fn response(&self, at: &Point<S>, impulse: Vec3<S>, seen: &Point<S>) -> Vec3<S>;
    /// Changes the twists of all bodies by an impulse at the point `at`.
    fn push(&self, at: &Point<S>, impulse: Vec3<S>, twists: &mut [Twist<S>]);
}

/// A contact of two bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact<S> {
    /// The two sides; the normal points from the second to the first.
    pub sides: [Side<S>; 2],
    /// n, t1, t2 in N.
    pub axes: [Vec3<S>; 3],
    /// Coulomb's mu, >= 0.
    pub friction: S,
    /// e, 0 to 1.
    pub restitution: S,
    /// Impulse (N s) or force (N) on the first side, along n, t1, t2.
    pub impulse: Vec3<S>,
    /// By point of the second side, c_i = -g a_i, where the first side is a gap g off a facet whose weights change by
    /// a_i along it: the velocity there is sum w_i v_i + c_i (n . v_i), as of a point fixed to the facet's tangent
    /// plane, and an impulse P there is w_i P + n (c_i . P) at the points, so that action and reaction leave no moment.
    /// None where both sides share one point.
    pub couple: Option<[Vec3<S>; 4]>,
}

impl<S: Scalar> Mobility<S> {
    /// Of a body that does not move.
    #[must_use]
    pub fn fixed() -> Mobility<S> {
        Mobility { inverse_mass: S::ZERO, inverse_inertia: [vec3::zero(); 3] }
    }

    /// Of a rigid body at a state.
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

    /// Velocity of the point at r from the centre of mass.
    #[must_use]
    pub fn at(&self, r: Vec3<S>) -> Vec3<S> {
        vec3::add(self.velocity, vec3::cross(self.angular, r))
    }
}

/// Rigid bodies and nodes: an impulse on one does not move another.
impl<S: Scalar> Inertia<S> for [Mobility<S>] {
    fn response(&self, at: &Point<S>, impulse: Vec3<S>, seen: &Point<S>) -> Vec3<S> {
        match self.get(at.body) {
            Some(m) if at.body == seen.body => {
                let turned = vec3::apply(&m.inverse_inertia, vec3::cross(at.arm, impulse));
                vec3::axpy(vec3::cross(turned, seen.arm), m.inverse_mass, impulse)
            }
            _ => vec3::zero(),
        }
    }

    fn push(&self, at: &Point<S>, impulse: Vec3<S>, twists: &mut [Twist<S>]) {
        if let (Some(m), Some(twist)) = (self.get(at.body), twists.get_mut(at.body)) {
            let turned = vec3::apply(&m.inverse_inertia, vec3::cross(at.arm, impulse));
            twist.velocity = vec3::axpy(twist.velocity, m.inverse_mass, impulse);
            twist.angular = vec3::add(twist.angular, turned);
        }
    }
}

impl<S: Scalar> Side<S> {
    /// Fixed in space.
    #[must_use]
    pub fn fixed() -> Side<S> {
        Side { points: [Point { body: 0, arm: vec3::zero(), weight: S::ZERO }; 4], count: 0 }
    }

    /// A point of a body at an arm from its origin (m, in N); a node has arm 0.
    #[must_use]
    pub fn of_body(body: usize, arm: Vec3<S>) -> Side<S> {
        let mut side = Side::fixed();
        (side.points[0], side.count) = (Point { body, arm, weight: S::ONE }, 1);
        side
    }

    /// A weighted sum of points, such as the corners of a facet; None stands for a corner fixed in space.
    #[must_use]
    pub fn blend(points: [Option<Point<S>>; 4]) -> Side<S> {
        let real =
            |point: Option<Point<S>>| point.filter(|point| point.weight != S::ZERO).map(|point| (point, ()));
        Side::blend_with(points.map(real), ()).0
    }

    /// The same with a value beside each point, in the order of the side's points; weights may be 0.
    #[must_use]
    pub fn blend_with<T: Copy>(points: [Option<(Point<S>, T)>; 4], none: T) -> (Side<S>, [T; 4]) {
        let (mut side, mut values) = (Side::fixed(), [none; 4]);
        let places = side.points.iter_mut().zip(&mut values);
        for ((place, beside), (point, value)) in places.zip(points.into_iter().flatten()) {
            (*place, *beside, side.count) = (point, value, side.count + 1);
        }
        (side, values)
    }

    /// The same side with other arms.
    #[must_use]
    pub fn with_arms(mut self, arm: impl Fn(&Point<S>) -> Vec3<S>) -> Side<S> {
        self.points.iter_mut().take(self.count).for_each(|point| point.arm = arm(point));
        self
    }

    /// Its points.
    pub fn points(&self) -> impl Iterator<Item = &Point<S>> {
        self.points.iter().take(self.count)
    }
}

impl<S: Scalar> Contact<S> {
    /// A contact at a point of N with this normal between bodies whose centres of mass are known.
    #[must_use]
    pub fn new(bodies: [usize; 2], point: Vec3<S>, normal: Vec3<S>, centers: [Vec3<S>; 2]) -> Contact<S> {
        let ([a, b], [x, y]) = (bodies, centers.map(|center| vec3::sub(point, center)));
        Contact::between([Side::of_body(a, x), Side::of_body(b, y)], normal)
    }

    /// A contact of two sides; the normal points from the second to the first.
    #[must_use]
    pub fn between(sides: [Side<S>; 2], normal: Vec3<S>) -> Contact<S> {
        Contact {
            sides,
            axes: contact_axes(normal),
            friction: S::ZERO,
            restitution: S::ZERO,
            impulse: vec3::zero(),
            couple: None,
        }
    }

    /// Velocity of the first side relative to the second, along n, t1, t2 (m/s).
    #[must_use]
    pub fn relative(&self, twists: &[Twist<S>]) -> Vec3<S> {
        self.relative_by(|point| twists.get(point.body).copied().unwrap_or_else(Twist::zero).at(point.arm))
    }

    /// The same, given the velocity of each point in N.
    fn relative_by(&self, velocity: impl Fn(&Point<S>) -> Vec3<S>) -> Vec3<S> {
        let sum = |sum, point: &Point<S>| vec3::axpy(sum, point.weight, velocity(point));
        let [one, mut other] = self.sides.each_ref().map(|side| side.points().fold(vec3::zero(), sum));
        if let Some(couple) = &self.couple {
            let points = self.sides[1].points().zip(couple);
            other = points
                .fold(other, |sum, (point, c)| vec3::axpy(sum, vec3::dot(self.axes[0], velocity(point)), *c));
        }
        vec3::apply(&self.axes, vec3::sub(one, other))
    }

    /// The points of a side, each with the impulse on it, given that on the first side in N.
    pub fn on_side(&self, side: usize, impulse: Vec3<S>) -> impl Iterator<Item = (&Point<S>, Vec3<S>)> {
        let couple = self.couple.as_ref().filter(|_| side == 1);
        let impulse = if side == 1 { vec3::scale(impulse, -S::ONE) } else { impulse };
        self.sides[side & 1].points().enumerate().map(move |(k, point)| {
            let own = vec3::scale(impulse, point.weight);
            let turning = couple.and_then(|couple| couple.get(k));
            (point, turning.map_or(own, |c| vec3::axpy(own, vec3::dot(*c, impulse), self.axes[0])))
        })
    }

    /// All points, each with the impulse on it.
    fn dealt(&self, impulse: Vec3<S>) -> impl Iterator<Item = (&Point<S>, Vec3<S>)> {
        self.on_side(0, impulse).chain(self.on_side(1, impulse))
    }

    /// Largest speed of its points (m/s).
    pub(crate) fn fastest(&self, twists: &[Twist<S>]) -> S {
        let speeds =
            self.points().filter_map(|(_, p)| twists.get(p.body).map(|own| vec3::norm(own.at(p.arm))));
        speeds.fold(S::ZERO, S::max)
    }

    /// All points with their weights, negative for those of the second side.
    pub(crate) fn points(&self) -> impl Iterator<Item = (S, &Point<S>)> {
        let [one, other] = &self.sides;
        let theirs = other.points().map(|point| (-point.weight, point));
        one.points().map(|point| (point.weight, point)).chain(theirs)
    }

    /// Whether any point belongs to this body.
    pub(crate) fn touches_body(&self, body: usize) -> bool {
        self.points().any(|(_, point)| point.body == body)
    }

    /// K (1/kg): the change of relative velocity by unit impulses along n, t1, t2.
    #[must_use]
    pub fn inverse_mass(&self, inertia: &(impl Inertia<S> + ?Sized)) -> InverseMass<S> {
        let column = |d: Vec3<S>| {
            self.relative_by(|seen| {
                self.dealt(d)
                    .fold(vec3::zero(), |sum, (at, own)| vec3::add(sum, inertia.response(at, own, seen)))
            })
        };
        let [[nn, xn, yn], [_, xx, yx], [_, _, yy]] = self.axes.map(column);
        [[nn, xn, yn], [xn, xx, yx], [yn, yx, yy]]
    }

    /// Components in N of an impulse given along n, t1, t2.
    #[must_use]
    pub fn to_inertial(&self, impulse: Vec3<S>) -> Vec3<S> {
        let ([n, t1, t2], [pn, p1, p2]) = (self.axes, impulse);
        vec3::axpy(vec3::axpy(vec3::scale(n, pn), p1, t1), p2, t2)
    }

    /// Changes the twists by an impulse along n, t1, t2 on the first side and its opposite on the second.
    pub fn push(&self, inertia: &(impl Inertia<S> + ?Sized), twists: &mut [Twist<S>], impulse: Vec3<S>) {
        for (at, own) in self.dealt(self.to_inertial(impulse)) {
            inertia.push(at, own, twists);
        }
    }

    /// Distributes an impulse along n, t1, t2 to the bodies: calls `give` with body, arm, impulse in N.
    pub fn deal(&self, impulse: Vec3<S>, mut give: impl FnMut(usize, Vec3<S>, Vec3<S>)) {
        for (at, own) in self.dealt(self.to_inertial(impulse)) {
            give(at.body, at.arm, own);
        }
    }
}

/// Solves K_tt x = y for the tangential block; y itself where the block is singular (immovable).
#[must_use]
pub(crate) fn solve_tangential<S: Scalar>(k: &InverseMass<S>, [x, y]: [S; 2]) -> [S; 2] {
    let [_, [_, a, b], [_, _, c]] = *k;
    let determinant = a * c - b * b;
    if determinant > S::ZERO {
        [(c * x - b * y) / determinant, (a * y - b * x) / determinant]
    } else {
        [x, y]
    }
}

/// By how much a contact yields to its force or impulse (1/kg): a share of what it gives its bodies, alike in all
/// directions.
#[must_use]
pub(crate) fn softness<S: Scalar>(share: S, k: &InverseMass<S>) -> S {
    share * (k[0][0] + k[1][1] + k[2][2]) / S::from_f64(3.0)
}

/// Projects a point onto the disc of this radius.
#[must_use]
pub(crate) fn onto_disc<S: Scalar>([x, y]: [S; 2], radius: S) -> [S; 2] {
    let size = (x * x + y * y).sqrt();
    if size > radius { [x * (radius / size), y * (radius / size)] } else { [x, y] }
}

/// One contact's friction that stops the slip that is left; None where that is beyond the friction disc.
pub(crate) fn stopping<S: Scalar>(k: &InverseMass<S>, at: [S; 2], slip: [S; 2], radius: S) -> Option<[S; 2]> {
    let [x, y] = solve_tangential(k, slip);
    let rest = [at[0] - x, at[1] - y];
    (rest[0] * rest[0] + rest[1] * rest[1] <= radius * radius).then_some(rest)
}

/// One contact's friction for the slip that is left: the one that stops it, or one on the rim of the friction disc.
///
/// On the rim: a gradient step of the contact's own energy, scaled by the inverse of the larger eigenvalue of `K_tt`;
/// it is the exact solution where the contact's inverse mass is the same in all tangential directions, as a node's is.
pub(crate) fn rubbed<S: Scalar>(k: &InverseMass<S>, at: [S; 2], slip: [S; 2], radius: S) -> [S; 2] {
    if let Some(rest) = stopping(k, at, slip, radius) {
        return rest;
    }
    let half = S::from_f64(0.5);
    let ([_, [_, a, b], [_, _, c]], difference) = (*k, half * (k[1][1] - k[2][2]));
    let largest = (half * (a + c) + (difference * difference + b * b).sqrt()).max(S::EPSILON);
    onto_disc([at[0] - slip[0] / largest, at[1] - slip[1] / largest], radius)
}
