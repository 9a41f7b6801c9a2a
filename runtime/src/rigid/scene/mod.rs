//! Rigid bodies that fall, strike, rest, slide and roll: the whole step.
//!
//! In: parts (shape, body or fixed), pairs that may touch with their laws, gravity, states. Out: the states a step later.
//! ```text
//! detect      features of every pair that touch
//! strike      if some close: impact of all that touch, by the pairs' laws
//! advance     forces of the contacts that last at the start and in the middle of the way: order 2
//! shorten     to the first new touch, or to where a slip stops
//! project     gaps and rates of the contacts that press back to 0
//! ```
//! A step is split at most [`SPLITS`] times; what is left is gone in 16 pieces with e = 0, and the report says so. There are no
//! stiffnesses and no tolerances to choose: lengths and speeds of rounding follow from the bodies and from gravity.

mod advance;
mod detect;

pub use detect::Touching;

use advance::Start;

use super::attitude::Attitude;
use super::contact::{Mobility, Twist};
use super::law::{Kind, Law};
use super::several::{Struck, compensate_all, stop, strike_all};
use super::{RigidBody, RigidState};
use crate::ode::root::locate;
use crate::real::Scalar;
use crate::surface::{Frame, Shape};
use crate::vec3::{self, Vec3};

/// Splits of one step at most.
pub const SPLITS: usize = 64;
/// Pieces of equal length in which the rest goes then, touches looked for between them only.
const REST: u32 = 16;

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

/// Working memory, its contents without meaning between steps. One entry per part, but of `touching`, `along` and
/// `struck`: as many as contacts are expected at once.
#[derive(Debug)]
pub struct Memory<'a, S> {
    /// States so far within the step, at the end of the way on trial, and in the middle of it.
    pub states: [&'a mut [RigidState<S>]; 3],
    /// Velocities or accelerations.
    pub twists: &'a mut [Twist<S>],
    /// The same.
    pub spare: &'a mut [Twist<S>],
    /// What the parts yield.
    pub mobilities: &'a mut [Mobility<S>],
    /// Contacts at the start of the way.
    pub touching: &'a mut [Touching<S>],
    /// Contacts along the way.
    pub along: &'a mut [Touching<S>],
    /// Contacts of an impact.
    pub struck: &'a mut [Struck<S>],
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

/// An impact within a step, shown while it happens.
#[derive(Clone, Copy, Debug)]
pub struct Strike<'a, S> {
    /// Time since the start of the step (s).
    pub time: S,
    /// Energy it took (J).
    pub loss: S,
    /// Features that took part, their velocities those before.
    pub touching: &'a [Touching<S>],
    /// The same with their impulses.
    pub struck: &'a [Struck<S>],
}

/// What a step did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Report<S> {
    /// Impacts.
    pub impacts: usize,
    /// Pieces the step was split into.
    pub splits: usize,
    /// Contacts that press at the end.
    pub held: usize,
    /// Sum of their normal forces (N).
    pub pressing: S,
    /// Energy taken by impacts (J).
    pub impact_loss: S,
    /// Energy taken by friction between impacts (J).
    pub friction_loss: S,
    /// Splits were used up: the rest of the step went with e = 0.
    pub forced: bool,
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
struct Rounding<S> {
    /// Length (m).
    gap: S,
    /// How far a contact that lasts may drift off in one step before it is put back (m).
    drift: S,
    /// Speed (m/s).
    rate: S,
}

/// A small whole number.
fn whole<S: Scalar>(n: u32) -> S {
    S::from_f64(f64::from(n))
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

    /// Advances the states by h (s), > 0.
    ///
    /// # Errors
    /// [`Fault`]; the states are then those before the step.
    pub fn step(
        &self,
        states: &mut [RigidState<S>],
        h: S,
        memory: &mut Memory<S>,
    ) -> Result<Report<S>, Fault> {
        self.step_watched(states, h, memory, |_| {})
    }

    /// As [`RigidScene::step`]; shows every impact, those of a step refused in the end too.
    ///
    /// # Errors
    /// As [`RigidScene::step`].
    pub fn step_watched(
        &self,
        states: &mut [RigidState<S>],
        h: S,
        memory: &mut Memory<S>,
        mut watch: impl FnMut(Strike<'_, S>),
    ) -> Result<Report<S>, Fault> {
        self.check_sizes(states, memory)?;
        let mut report = Report {
            impacts: 0,
            splits: 0,
            held: 0,
            pressing: S::ZERO,
            impact_loss: S::ZERO,
            friction_loss: S::ZERO,
            forced: false,
        };
        let [now, ..] = &mut memory.states;
        now.iter_mut().zip(states.iter()).for_each(|(to, from)| *to = *from);
        self.go(h, memory, &mut report, &mut watch)?;
        states.iter_mut().zip(memory.states[0].iter()).for_each(|(to, from)| *to = *from);
        Ok(report)
    }

    fn check_sizes(&self, states: &[RigidState<S>], memory: &Memory<S>) -> Result<(), Fault> {
        let n = self.parts.len();
        let [a, b, c] = &memory.states;
        let sizes = [states.len(), a.len(), b.len(), c.len(), memory.twists.len(), memory.spare.len()];
        let all = sizes.iter().all(|size| *size == n) && memory.mobilities.len() == n;
        let pairs = self.pairs.iter().flat_map(|pair| pair.parts).all(|part| part < n);
        if all && pairs { Ok(()) } else { Err(Fault::WrongSizes) }
    }

    /// The stages, on the first of the memory's states.
    fn go(
        &self,
        h: S,
        memory: &mut Memory<S>,
        report: &mut Report<S>,
        watch: &mut impl FnMut(Strike<'_, S>),
    ) -> Result<(), Fault> {
        let (mut left, mut rest) = (h, REST);
        for split in 0..SPLITS + REST as usize {
            let last = split >= SPLITS;
            let rounding = self.rounding(memory.states[0]);
            self.strike(memory, rounding, last, report, |touching, struck, loss| {
                watch(Strike { time: h - left, loss, touching, struck });
            })?;
            let start = self.hold_at_start(memory, rounding)?;
            let (length, pressing) = if last {
                let piece = left / whole(rest);
                rest -= 1;
                (piece, self.advance(memory, piece, start.held, rounding)?)
            } else {
                self.shorten(memory, left, start, rounding)?
            };
            self.commit(memory, length, pressing, report);
            self.project(memory, pressing, rounding)?;
            (report.splits, report.forced) = (split + 1, last);
            left = left - length;
            if left <= S::ZERO || rest == 0 {
                break;
            }
        }
        Ok(())
    }

    /// What counts as nothing: gaps by the size of what moves, speeds by those at hand and by the lowest bounce.
    fn rounding(&self, states: &[RigidState<S>]) -> Rounding<S> {
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

    /// Impact of all that touch, if some of them close.
    fn strike(
        &self,
        memory: &mut Memory<S>,
        rounding: Rounding<S>,
        last: bool,
        report: &mut Report<S>,
        show: impl FnOnce(&[Touching<S>], &[Struck<S>], S),
    ) -> Result<(), Fault> {
        let Memory { states: [now, ..], twists, spare, mobilities, touching, struck, .. } = memory;
        let count = self.detect(now, twists, mobilities, touching, rounding.gap, |_| true)?;
        let touching = touching.get(..count).unwrap_or_default();
        if !touching.iter().any(|t| t.velocity[0] < -rounding.rate) {
            return Ok(());
        }
        let struck = struck.get_mut(..count).ok_or(Fault::TooManyContacts)?;
        for (s, t) in struck.iter_mut().zip(touching) {
            *s = Struck::new(t.held.contact, &**mobilities);
        }
        let before = self.energy(now);
        let law_of = |t: &Touching<S>| self.pairs.get(t.pair).map(|pair| pair.law);
        let law = touching.first().and_then(law_of);
        let alike = touching.iter().all(|t| law_of(t) == law);
        match law {
            _ if last => {
                // Whether or not it settled, what it did takes energy only.
                let _ = stop(struck, &**mobilities, twists);
            }
            Some(law) if alike && law.kind() != Kind::Stronge => {
                // Newton's e alike at all points without friction is compensation of e^2.
                compensate_all(struck, law.restitution() * law.restitution(), &**mobilities, twists);
            }
            _ => {
                strike_all(struck, &**mobilities, twists, spare);
            }
        }
        for s in struck.iter() {
            self.push(now, &s.contact, s.contact.impulse);
        }
        let loss = before - self.energy(now);
        report.impacts += 1;
        report.impact_loss = report.impact_loss + loss;
        show(touching, struck, loss);
        Ok(())
    }

    /// Gives an impulse n, t1, t2 at a contact to both parts' states.
    fn push(&self, states: &mut [RigidState<S>], contact: &super::contact::Contact<S>, impulse: Vec3<S>) {
        contact.deal(impulse, |k, arm, impulse| {
            if let (Some(Part { body: Some(body), .. }), Some(state)) = (self.parts.get(k), states.get_mut(k))
            {
                body.push(state, arm, impulse);
            }
        });
    }

    /// Goes all that is left, or to the first new touch or end of a slip: how far, and the contacts `along`.
    fn shorten(
        &self,
        memory: &mut Memory<S>,
        left: S,
        start: Start,
        rounding: Rounding<S>,
    ) -> Result<(S, usize), Fault> {
        let pressing = self.advance(memory, left, start.held, rounding)?;
        let clear = self.clearance(memory, start, rounding);
        if clear.gap >= -rounding.gap && clear.slip >= -rounding.rate {
            return Ok((left, pressing));
        }
        let mut fault = None;
        let guard = |length: S| {
            // At the start nothing new touches and nothing has turned back.
            if length <= S::ZERO {
                return S::ZERO;
            }
            match self.advance(memory, length, start.held, rounding) {
                Ok(_) => {
                    let clear = self.clearance(memory, start, rounding);
                    clear.gap.min(clear.slip)
                }
                Err(why) => {
                    fault = Some(why);
                    S::ZERO
                }
            }
        };
        let found = locate(guard, S::ZERO, left, S::from_f64(4.0) * S::EPSILON * left);
        if let Some(why) = fault {
            return Err(why);
        }
        // To the far side: what touches does so within rounding, a slip has just stopped.
        let length = found.map_or(left, |(_, beyond)| beyond);
        Ok((length, self.advance(memory, length, start.held, rounding)?))
    }
}
