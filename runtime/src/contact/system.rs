//! A body against a ground: which of the ground's laws act on it, and what they leave of an acceleration.
//!
//! A [`Repertoire`] names the laws that a program has at all: what it leaves out is not compiled into an image.

use super::ground::{ContactLaw, ContactState, Ground};
use super::repertoire::{Full, Repertoire};
use super::soft;
use crate::flexible::Body;
use crate::ode::nodes::Motion;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};
use core::marker::PhantomData;

/// Body and ground: everything that stays the same in a run.
#[derive(Clone, Copy, Debug)]
pub struct System<'a, S, R = Full> {
    /// The body.
    pub body: Body<'a, S>,
    /// The ground, if any.
    pub ground: Option<Ground<S>>,
    repertoire: PhantomData<R>,
}

impl<'a, S> System<'a, S> {
    /// A body and its ground, with every method, element and law at hand.
    #[must_use]
    pub fn new(body: Body<'a, S>, ground: Option<Ground<S>>) -> Self {
        System { body, ground, repertoire: PhantomData }
    }
}

impl<'a, S: Scalar, R: Repertoire<S>> System<'a, S, R> {
    /// The same for a program that has no more than `R`.
    #[must_use]
    pub fn restricted(body: Body<'a, S>, ground: Option<Ground<S>>) -> Self {
        System { body, ground, repertoire: PhantomData }
    }

    /// The ground, if touch and release are located in time.
    #[must_use]
    pub fn event_ground(&self) -> Option<Ground<S>> {
        self.ground.filter(|ground| (R::COMPENSATION || R::NEWTON) && ground.has_events())
    }

    /// The ground, if it gives way.
    #[must_use]
    pub fn soft_ground(&self) -> Option<Ground<S>> {
        self.ground.filter(|ground| R::SOFT && !ground.is_rigid())
    }

    /// The ground, if massless points touch it.
    #[must_use]
    pub fn massless_ground(&self) -> Option<Ground<S>> {
        self.ground.filter(|ground| R::MASSLESS && ground.law == ContactLaw::MasslessPoint)
    }

    /// The ground, if points are rubbed on it.
    #[must_use]
    pub fn rough_ground(&self) -> Option<Ground<S>> {
        self.ground.filter(|ground| R::FRICTION && ground.friction > S::ZERO)
    }

    /// The ground, if the step is split where something happens on it: touch and release, or where friction holds a
    /// point in a ground that gives way, turns it round or lets it slip.
    #[must_use]
    pub fn watched_ground(&self) -> Option<Ground<S>> {
        self.event_ground().or_else(|| self.soft_ground().and(self.rough_ground()))
    }

    /// Acceleration of point i (m/s^2) under a force, after what holds it has taken its part.
    #[must_use]
    pub fn acceleration(&self, i: usize, mode: ContactState, force: Vec3<S>) -> Vec3<S> {
        self.admissible(mode, vec3::scale(force, self.body.inverse_mass(i)))
    }

    /// The part of a velocity or acceleration that the contact leaves.
    #[must_use]
    pub fn admissible(&self, mode: ContactState, a: Vec3<S>) -> Vec3<S> {
        match (mode, &self.ground) {
            (ContactState::Free | ContactState::Departing, _) | (_, None) => a,
            (ContactState::Held, Some(ground)) => vec3::tangential(a, ground.normal),
            (ContactState::Stuck, Some(ground)) if R::SOFT && !ground.is_rigid() => {
                vec3::scale(ground.normal, vec3::dot(a, ground.normal))
            }
            (ContactState::Stuck, _) => vec3::zero(),
        }
    }

    /// True where some force depends on speeds: dampers, air, or the ground.
    #[must_use]
    pub fn is_damped(&self) -> bool {
        R::DAMPING && (self.body.is_damped() || self.ground.is_some_and(|ground| ground.is_damped()))
    }

    /// Normal force of the ground on a held point (N), thesis Eq. 4.1: what holds it against `force`.
    #[must_use]
    pub fn normal_force(&self, force: Vec3<S>) -> S {
        self.ground.map_or(S::ZERO, |ground| -vec3::dot(force, ground.normal))
    }

    /// What friction rubs point i with (N): the force that holds it, < 0 if the ground would have to pull, or the push of
    /// a ground that gives way.
    #[must_use]
    pub fn pressure(&self, motion: &Motion<S>, i: usize, mode: ContactState) -> S {
        match self.soft_ground() {
            Some(ground) => soft::normal_force(&ground, vec3::at(motion.pos, i), vec3::at(motion.vel, i)).0,
            None if mode.is_held() => self.normal_force(motion.force(i)),
            None => S::ZERO,
        }
    }
}
