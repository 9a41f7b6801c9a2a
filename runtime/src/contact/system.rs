//! A body against a ground: which of the ground's laws act on it, and how contact states restrict motion.
//!
//! A [`Repertoire`] names the laws that a program is compiled with; an image has no code for the others.

use super::ground::{ContactLaw, ContactState, Ground};
use super::repertoire::{Full, Repertoire};
use super::soft;
use crate::flexible::Body;
use crate::ode::nodes::Motion;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};
use core::marker::PhantomData;

/// Body and ground: everything that is constant in a run.
#[derive(Clone, Copy, Debug)]
pub struct System<'a, S, R = Full> {
    /// The body.
    pub body: Body<'a, S>,
    /// The ground, if any.
    pub ground: Option<Ground<S>>,
    repertoire: PhantomData<R>,
}

impl<'a, S> System<'a, S> {
    /// A body and its ground, with every method, element and law available.
    #[must_use]
    pub fn new(body: Body<'a, S>, ground: Option<Ground<S>>) -> Self {
        System { body, ground, repertoire: PhantomData }
    }
}

impl<'a, S: Scalar, R: Repertoire<S>> System<'a, S, R> {
    /// The same for a program compiled with the repertoire `R`.
    #[must_use]
    pub fn restricted(body: Body<'a, S>, ground: Option<Ground<S>>) -> Self {
        System { body, ground, repertoire: PhantomData }
    }

    /// The ground, if touch and release are located in time.
    #[must_use]
    pub fn event_ground(&self) -> Option<Ground<S>> {
        self.ground.filter(|ground| (R::COMPENSATION || R::NEWTON) && ground.has_events())
    }

    /// The ground, if it is soft.
    #[must_use]
    pub fn soft_ground(&self) -> Option<Ground<S>> {
        self.ground.filter(|ground| R::SOFT && !ground.is_rigid())
    }

    /// The ground, if massless points touch it.
    #[must_use]
    pub fn massless_ground(&self) -> Option<Ground<S>> {
        self.ground.filter(|ground| R::MASSLESS && ground.law == ContactLaw::MasslessPoint)
    }

    /// The ground, if it has friction.
    #[must_use]
    pub fn rough_ground(&self) -> Option<Ground<S>> {
        self.ground.filter(|ground| R::FRICTION && ground.friction > S::ZERO)
    }

    /// The ground, if the step is split at events on it: touch and release, or, in a soft ground, where friction makes
    /// a point stick, reverse or slip.
    #[must_use]
    pub fn watched_ground(&self) -> Option<Ground<S>> {
        self.event_ground().or_else(|| self.soft_ground().and(self.rough_ground()))
    }

    /// Acceleration of point i (m/s^2) under a force, restricted to what its contact state allows.
    #[must_use]
    pub fn acceleration(&self, i: usize, mode: ContactState, force: Vec3<S>) -> Vec3<S> {
        self.admissible(mode, vec3::scale(force, self.body.inverse_mass(i)))
    }

    /// The part of a velocity or acceleration that a contact state allows.
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

    /// Whether any force depends on speeds: dampers, air drag, or the ground.
    #[must_use]
    pub fn is_damped(&self) -> bool {
        R::DAMPING && (self.body.is_damped() || self.ground.is_some_and(|ground| ground.is_damped()))
    }

    /// Normal force of the ground on a held point (N), thesis Eq. 4.1: it balances the normal part of `force`.
    #[must_use]
    pub fn normal_force(&self, force: Vec3<S>) -> S {
        self.ground.map_or(S::ZERO, |ground| -vec3::dot(force, ground.normal))
    }

    /// Normal force that friction on point i depends on (N): the one that holds it, < 0 if the ground would have to
    /// pull, or the push of a soft ground.
    #[must_use]
    pub fn pressure(&self, motion: &Motion<S>, i: usize, mode: ContactState) -> S {
        match self.soft_ground() {
            Some(ground) => soft::normal_force(&ground, vec3::at(motion.pos, i), vec3::at(motion.vel, i)).0,
            None if mode.is_held() => self.normal_force(motion.force(i)),
            None => S::ZERO,
        }
    }
}
