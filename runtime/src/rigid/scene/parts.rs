//! Rigid parts, pairs that may touch, and tolerances.

use crate::real::Scalar;
use crate::rigid::attitude::Attitude;
use crate::rigid::contact::Contact;
use crate::rigid::hold::negligible;
use crate::rigid::law::Law;
use crate::rigid::{RigidBody, RigidState};
use crate::surface::{Frame, Shape};
use crate::vec3::{self, Vec3};

/// An event is located where its gap or speed is within this of zero, relative to what counts as zero.
pub(crate) const NEAR: f64 = 1.0 / 2048.0;

/// A rigid part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part<S> {
    /// Its shape, in its principal axes about its centre of mass.
    pub shape: Shape<S>,
    /// Mass and inertia; None for a part fixed in space at its state.
    pub body: Option<RigidBody<S>>,
}

/// Two parts that may touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair<S> {
    /// Indices of the parts.
    pub parts: [usize; 2],
    /// The law between them.
    pub law: Law<S>,
}

/// Constants of a scene of rigid parts.
#[derive(Clone, Copy, Debug)]
pub struct RigidScene<'a, S> {
    /// The parts.
    pub parts: &'a [Part<S>],
    /// The pairs; parts that form no pair pass through one another.
    pub pairs: &'a [Pair<S>],
    /// Acceleration of free fall in N (m/s^2).
    pub gravity: Vec3<S>,
}

/// Why a step is refused; the states are unchanged.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Fault {
    /// More contacts than `touching`, `along` or `struck` have room for.
    TooManyContacts,
    /// Slices whose lengths differ from the number of parts, or a pair of parts that do not exist.
    WrongSizes,
    /// A part rotates too far in one step, or a state at its end would not be finite: take a shorter step.
    TooFast,
    /// The length of the step is not > 0 and finite.
    StepSize,
    /// Gravity is not finite.
    Gravity,
    /// This part's mass or a moment of inertia is not > 0 and finite, or so small that its inverse is not; or a size is
    /// negative or not finite; or its state is not finite.
    Part(usize),
}

impl<S: Scalar> RigidState<S> {
    /// At rest at a position, with body axes parallel to those of N.
    #[must_use]
    pub fn at_rest(position: Vec3<S>) -> RigidState<S> {
        let (velocity, angular_momentum) = (vec3::zero(), vec3::zero());
        RigidState { position, velocity, attitude: Attitude::identity(), angular_momentum }
    }
}

impl<S: Scalar> Part<S> {
    /// Whether it can move: its sizes and inertia in range, its state finite.
    pub(super) fn is_sound(&self, state: &RigidState<S>) -> bool {
        let positive = |x: S| x > S::ZERO && x.is_finite() && (S::ONE / x).is_finite();
        let moves =
            self.body.is_none_or(|body| positive(body.mass) && body.inertia.iter().all(|i| positive(*i)));
        let size = |x: S| x >= S::ZERO && x.is_finite();
        let sized = match self.shape {
            Shape::HalfSpace => true,
            Shape::Sphere(sphere) => size(sphere.radius),
            Shape::Capsule(capsule) => size(capsule.radius) && size(capsule.half_length),
            Shape::Cuboid(cuboid) => cuboid.half.iter().all(|x| size(*x)),
        };
        moves && sized && state.is_finite()
    }

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

/// Tolerances: lengths, speeds and accelerations that count as zero.
#[derive(Clone, Copy)]
pub(super) struct Rounding<S> {
    /// What a gap differs by where nothing moves (m).
    pub(super) length: S,
    /// Gap (m), and its share of the size of the moving parts.
    pub(super) gap: S,
    pub(super) share: S,
    /// How far a lasting contact may drift in one step before it is projected (m).
    pub(super) drift: S,
    /// Speed (m/s).
    pub(super) rate: S,
    /// Acceleration (m/s^2).
    pub(super) acceleration: S,
}

impl<S: Scalar> RigidScene<'_, S> {
    /// Kinetic and gravitational energy (J).
    #[must_use]
    pub fn energy(&self, states: &[RigidState<S>]) -> S {
        self.energies(states)[0]
    }

    /// The same, and its kinetic part.
    pub(super) fn energies(&self, states: &[RigidState<S>]) -> [S; 2] {
        let bodies = self.parts.iter().zip(states).filter_map(|(p, s)| p.body.map(|b| (b, s)));
        bodies.fold([S::ZERO; 2], |[all, moving], (body, state)| {
            let kinetic = body.kinetic(state);
            let sum = all + kinetic - body.mass * vec3::dot(self.gravity, state.position);
            [sum, moving + kinetic]
        })
    }

    /// Tolerances for a step of h: gaps from the size of the moving parts, speeds from the present ones and from the
    /// lowest bounce.
    pub(super) fn rounding(&self, states: &[RigidState<S>], h: S) -> Rounding<S> {
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
        // The speed whose bounce is as high as the rounding of lengths: v^2/(2 g) = 8 epsilon size.
        let lowest = S::from_f64(4.0) * (eps * vec3::norm(self.gravity) * size).sqrt();
        let rate = lowest + S::from_f64(64.0) * eps * speed;
        // epsilon^(2/3): between the rounding unit and 1, and far above sums of rounding errors.
        let share = (S::from_f64(2.0 / 3.0) * eps.ln()).exp();
        Rounding {
            length: S::from_f64(16.0) * eps * size,
            gap: share * size,
            share,
            drift: S::from_f64(0.01) * size,
            rate,
            acceleration: negligible(rate, h),
        }
    }

    /// Applies an impulse along n, t1, t2 at a contact to both parts' states.
    pub(super) fn push(&self, states: &mut [RigidState<S>], contact: &Contact<S>, impulse: Vec3<S>) {
        contact.deal(impulse, |k, arm, impulse| {
            if let (Some(Part { body: Some(body), .. }), Some(state)) = (self.parts.get(k), states.get_mut(k))
            {
                body.push(state, arm, impulse);
            }
        });
    }
}
