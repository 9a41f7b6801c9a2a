//! Rigid bodies: free motion that conserves energy and angular momentum, and impact with friction.
//!
//! In: mass, principal moments of inertia, pose and momenta. Out: the pose one step later (`motion`), velocities after
//! an impact at a point (`impact`, `swerve`). The state holds the angular momentum in N, so that without moments
//! it stays constant to the bit.

pub(crate) mod anderson;
pub mod attitude;
pub mod contact;
mod held;
pub(crate) mod history;
pub mod hold;
pub mod impact;
pub mod law;
pub mod motion;
pub mod narrow;
pub mod plastic;
pub mod scene;
pub mod several;
pub(crate) mod share;
pub mod struck;
pub(crate) mod sweeps;
mod swerve;
pub mod touch;

use crate::real::Scalar;
use crate::surface::Frame;
use crate::vec3::{self, Vec3};
use attitude::Attitude;
use impact::{Impact, InverseMass, Touch};

/// Constants of a rigid body: mass and inertia in principal axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidBody<S> {
    /// m (kg), > 0.
    pub mass: S,
    /// Principal moments of inertia about the centre of mass (kg m^2), > 0.
    pub inertia: Vec3<S>,
}

/// Pose and momentum of a rigid body; its axes are the principal ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidState<S> {
    /// Centre of mass in N (m).
    pub position: Vec3<S>,
    /// Velocity of the centre of mass in N (m/s).
    pub velocity: Vec3<S>,
    /// Rotation from body axes to N.
    pub attitude: Attitude<S>,
    /// Angular momentum about the centre of mass, in N (kg m^2/s).
    pub angular_momentum: Vec3<S>,
}

impl<S: Scalar> RigidState<S> {
    /// Whether all its numbers are finite.
    pub(crate) fn is_finite(&self) -> bool {
        let [e0, e1, e2, e3] = self.attitude.parameters();
        let vectors = [self.position, self.velocity, [e1, e2, e3], self.angular_momentum];
        e0.is_finite() && vectors.as_flattened().iter().all(|x| x.is_finite())
    }
}

impl<S: Scalar> RigidBody<S> {
    /// J^-1 applied to a moment or angular momentum, both in N.
    #[must_use]
    pub fn inverse_inertia(&self, attitude: &Attitude<S>, moment: Vec3<S>) -> Vec3<S> {
        attitude.to_inertial(self.body_rate(attitude.to_body(moment)))
    }

    /// Angular velocity for an angular momentum, both in body axes.
    pub(crate) fn body_rate(&self, momentum: Vec3<S>) -> Vec3<S> {
        let ([x, y, z], [a, b, c]) = (momentum, self.inertia);
        [x / a, y / b, z / c]
    }

    /// Angular velocity in N (rad/s).
    #[must_use]
    pub fn angular_velocity(&self, state: &RigidState<S>) -> Vec3<S> {
        self.inverse_inertia(&state.attitude, state.angular_momentum)
    }

    /// Velocity in N (m/s) of the point at r (m, in N) from the centre of mass.
    #[must_use]
    pub fn point_velocity(&self, state: &RigidState<S>, r: Vec3<S>) -> Vec3<S> {
        vec3::add(state.velocity, vec3::cross(self.angular_velocity(state), r))
    }

    /// The body's frame with its motion.
    #[must_use]
    pub fn frame(&self, state: &RigidState<S>) -> Frame<S> {
        Frame {
            origin: state.position,
            axes: state.attitude.axes(),
            velocity: state.velocity,
            angular_velocity: self.angular_velocity(state),
        }
    }

    /// Kinetic energy (J).
    #[must_use]
    pub fn kinetic(&self, state: &RigidState<S>) -> S {
        let momentum = state.attitude.to_body(state.angular_momentum);
        let turning = vec3::dot(momentum, self.body_rate(momentum));
        S::from_f64(0.5) * (self.mass * vec3::dot(state.velocity, state.velocity) + turning)
    }

    /// Change of velocity of the point at r under a unit impulse along d there: d/m + (J^-1 (r x d)) x r.
    fn response(&self, attitude: &Attitude<S>, r: Vec3<S>, d: Vec3<S>) -> Vec3<S> {
        let turned = self.inverse_inertia(attitude, vec3::cross(r, d));
        vec3::axpy(vec3::cross(turned, r), S::ONE / self.mass, d)
    }

    /// Applies an impulse (N s, in N) at the point r from the centre of mass.
    pub fn push(&self, state: &mut RigidState<S>, r: Vec3<S>, impulse: Vec3<S>) {
        state.velocity = vec3::axpy(state.velocity, S::ONE / self.mass, impulse);
        state.angular_momentum = vec3::add(state.angular_momentum, vec3::cross(r, impulse));
    }
}

/// A rigid body and the point at which it is struck.
#[derive(Debug)]
pub struct Struck<'a, S> {
    /// The body.
    pub body: &'a RigidBody<S>,
    /// Its state, which the impulse changes.
    pub state: &'a mut RigidState<S>,
    /// The point, in N (m).
    pub point: Vec3<S>,
}

impl<S: Scalar> Struck<'_, S> {
    fn arm(&self) -> Vec3<S> {
        vec3::sub(self.point, self.state.position)
    }

    fn velocity(&self) -> Vec3<S> {
        self.body.point_velocity(self.state, self.arm())
    }
}

/// Impact of a rigid body on the ground, or on another one; n points from the other to `one`.
///
/// The impulse acts on `one`, its opposite on `other`, at the same point: linear and angular momentum of the pair are
/// conserved. Bodies that are not closing are left unchanged. No energy is created for `friction` >= 0, `restitution`
/// from 0 to 1 and a normal of length 1, which the caller sees to: [`law::Law`] checks the two numbers.
pub fn strike<S: Scalar>(
    one: Struck<S>,
    other: Option<Struck<S>>,
    normal: Vec3<S>,
    friction: S,
    restitution: S,
) -> Impact<S> {
    let axes = contact_axes(normal);
    let mut velocity = one.velocity();
    if let Some(other) = &other {
        velocity = vec3::sub(velocity, other.velocity());
    }
    let touch = Touch {
        inverse_mass: inverse_mass(&one, other.as_ref(), &axes),
        velocity: vec3::apply(&axes, velocity),
        friction,
        restitution,
    };
    let impact = impact::resolve(&touch);
    let [n, t1, t2] = axes;
    let [pn, p1, p2] = impact.impulse;
    let impulse = vec3::axpy(vec3::axpy(vec3::scale(n, pn), p1, t1), p2, t2);
    let r = one.arm();
    one.body.push(one.state, r, impulse);
    if let Some(other) = other {
        let r = other.arm();
        other.body.push(other.state, r, vec3::scale(impulse, -S::ONE));
    }
    impact
}

/// K at the point in the axes of the contact: the sum for both bodies.
fn inverse_mass<S: Scalar>(
    one: &Struck<S>,
    other: Option<&Struck<S>>,
    axes: &[Vec3<S>; 3],
) -> InverseMass<S> {
    let column = |d: Vec3<S>| {
        let mine = one.body.response(&one.state.attitude, one.arm(), d);
        let both = match other {
            Some(other) => vec3::add(mine, other.body.response(&other.state.attitude, other.arm(), d)),
            None => mine,
        };
        vec3::apply(axes, both)
    };
    let [[nn, xn, yn], [_, xx, yx], [_, _, yy]] = axes.map(column);
    [[nn, xn, yn], [xn, xx, yx], [yn, yx, yy]]
}

/// n and two unit vectors perpendicular to it (Duff and others 2017: exact for every unit vector).
#[must_use]
pub fn contact_axes<S: Scalar>(n: Vec3<S>) -> [Vec3<S>; 3] {
    let [x, y, z] = n;
    let sign = if z < S::ZERO { -S::ONE } else { S::ONE };
    let a = -S::ONE / (sign + z);
    let b = x * y * a;
    [n, [S::ONE + sign * x * x * a, sign * b, -(sign * x)], [b, sign + y * y * a, -y]]
}
