//! Rigid parts, the pairs that may touch, and what counts as nothing among them.

use crate::real::Scalar;
use crate::rigid::attitude::Attitude;
use crate::rigid::contact::Contact;
use crate::rigid::law::Law;
use crate::rigid::{RigidBody, RigidState};
use crate::surface::{Frame, Shape};
use crate::vec3::{self, Vec3};

/// A rigid part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part<S> {
    /// Its shape, in its principal axes about its centre of mass.
    pub shape: Shape<S>,
    /// Its inertia; None if it is fixed in space where its state says.
    pub body: Option<RigidBody<S>>,
}

/// Two parts that may touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair<S> {
    /// Their numbers.
    pub parts: [usize; 2],
    /// The law between them.
    pub law: Law<S>,
}

/// What does not change.
#[derive(Clone, Copy, Debug)]
pub struct RigidScene<'a, S> {
    /// The parts.
    pub parts: &'a [Part<S>],
    /// The pairs; parts of no pair pass through one another.
    pub pairs: &'a [Pair<S>],
    /// Acceleration of free fall in N (m/s^2).
    pub gravity: Vec3<S>,
}

/// Why a step is refused; the states are left as they were.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Fault {
    /// More contacts than `touching`, `along` or `struck` have room for.
    TooManyContacts,
    /// Slices of other lengths than there are parts, or a pair of parts that do not exist.
    WrongSizes,
    /// The forces of the contacts did not settle: friction jams a sliding body (Painleve's paradox).
    Jammed,
    /// A part turns too far in one step, or a state is no number: take a shorter step.
    TooFast,
}

impl<S: Scalar> RigidState<S> {
    /// At rest at a place, body axes along those of N.
    #[must_use]
    pub fn at_rest(position: Vec3<S>) -> RigidState<S> {
        let (velocity, angular_momentum) = (vec3::zero(), vec3::zero());
        RigidState { position, velocity, attitude: Attitude::identity(), angular_momentum }
    }
}

impl<S: Scalar> Part<S> {
    /// Its frame with its motion.
    #[must_use]
    pub fn frame(&self, state: &RigidState<S>) -> Frame<S> {
        match &self.body {
            Some(body) => body.frame(state),
            None => Frame {
                origin: state.position,
                axes: state.attitude.axes(),
                velocity: vec3::zero(),
                angular_velocity: vec3::zero(),
            },
        }
    }
}

/// What counts as nothing.
#[derive(Clone, Copy)]
pub(super) struct Rounding<S> {
    /// Length (m).
    pub(super) gap: S,
    /// How far a contact that lasts may drift off in one step before it is put back (m).
    pub(super) drift: S,
    /// Speed (m/s).
    pub(super) rate: S,
}

impl<S: Scalar> RigidScene<'_, S> {
    /// Kinetic energy and that in gravity (J).
    #[must_use]
    pub fn energy(&self, states: &[RigidState<S>]) -> S {
        let bodies = self.parts.iter().zip(states).filter_map(|(p, s)| p.body.map(|b| (b, s)));
        bodies.fold(S::ZERO, |sum, (body, state)| {
            sum + body.kinetic(state) - body.mass * vec3::dot(self.gravity, state.position)
        })
    }

    /// What counts as nothing: gaps by the size of what moves, speeds by those at hand and by the lowest bounce.
    pub(super) fn rounding(&self, states: &[RigidState<S>]) -> Rounding<S> {
        let (mut size, mut speed) = (S::ZERO, S::ZERO);
        for (part, state) in self.parts.iter().zip(states) {
            let Some(body) = &part.body else { continue };
            let own = match part.shape {
                Shape::HalfSpace => S::ONE,
                Shape::Sphere(sphere) => sphere.radius,
                Shape::Capsule(capsule) => capsule.radius + capsule.half_length,
                Shape::Cuboid(cuboid) => vec3::norm(cuboid.half),
            };
            let turning = own * vec3::norm(body.angular_velocity(state));
            size = size.max(own).max(vec3::norm(state.position));
            speed = speed.max(vec3::norm(state.velocity) + turning);
        }
        let eps = S::EPSILON;
        // A speed whose bounce is as high as lengths are rounded: v^2/(2 g) = 8 epsilon size.
        let lowest = S::from_f64(4.0) * (eps * vec3::norm(self.gravity) * size).sqrt();
        // epsilon^(2/3): halfway to nothing, and far above what sums of rounding errors reach.
        Rounding {
            gap: (S::from_f64(2.0 / 3.0) * eps.ln()).exp() * size,
            drift: S::from_f64(0.01) * size,
            rate: lowest + S::from_f64(64.0) * eps * speed,
        }
    }

    /// Gives an impulse n, t1, t2 at a contact to both parts' states.
    pub(super) fn push(&self, states: &mut [RigidState<S>], contact: &Contact<S>, impulse: Vec3<S>) {
        contact.deal(impulse, |k, arm, impulse| {
            if let (Some(Part { body: Some(body), .. }), Some(state)) = (self.parts.get(k), states.get_mut(k))
            {
                body.push(state, arm, impulse);
            }
        });
    }
}
