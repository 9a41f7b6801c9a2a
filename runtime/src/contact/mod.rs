//! Contact of a body's points with a plane ground of any orientation (thesis chapter 4).
//!
//! gap = n.x - offset, > 0 apart; gap rate = n.v, < 0 closing; n is the outward normal of the ground.
//! A point is free, departing (just let go: its guard sleeps until the gap is clearly open), held
//! (gap rate 0, the ground pushes) or stuck (held, and friction holds it sideways too). In a ground that gives way it is
//! free or, held sideways alone, stuck.

pub mod compensation;
pub mod friction;
pub mod frozen;
pub mod massless;
pub mod pair;
pub mod repertoire;
pub mod restitution;
pub mod soft;
pub mod stable_step;

use crate::flexible::Body;
use crate::ode::nodes::Motion;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};
use core::marker::PhantomData;
pub use frozen::{Frozen, Start, advance};
pub use repertoire::{Full, Repertoire};

/// What happens between a point and the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ContactLaw<S> {
    /// Energy compensation along the springs.
    Compensation {
        /// Share of the lost energy that is given back: 1 is the thesis, 0 plastic.
        eta: S,
        /// Corrects the drift of the total energy at each touch (undamped bodies, small steps).
        anchor: bool,
        /// Points without a receiver lose their energy instead of rebounding.
        plastic_alone: bool,
        /// Points from this number on may take energy: 0 for all, the first centre for thesis 5.9.
        first_receiver: usize,
    },
    /// v+ = -e v- at the instant of touch, point by point.
    Newton {
        /// Coefficient of restitution e, 0 to 1.
        restitution: S,
    },
    /// Moreau's time stepping: the law v+ >= -e v- holds over each step, events are not located.
    Moreau {
        /// Coefficient of restitution e, 0 to 1.
        restitution: S,
    },
    /// The points that may touch have no mass; their place follows from statics. No event, no impact.
    MasslessPoint,
    /// Linear spring of the ground on the depth.
    Penalty {
        /// Stiffness of the ground (N/m).
        stiffness: S,
    },
    /// N = k depth^1.5 (1 + a depth_rate), never pulling.
    HuntCrossley {
        /// k [N/m^1.5].
        stiffness: S,
        /// a (s/m).
        dissipation: S,
    },
}

/// A plane ground and its law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ground<S> {
    /// Outward unit normal.
    pub normal: Vec3<S>,
    /// n.x of the surface (m).
    pub offset: S,
    /// Law between ground and points.
    pub law: ContactLaw<S>,
    /// Coulomb's coefficient, >= 0.
    pub friction: S,
    /// Points within this gap (m) of one that touches, and closing, touch together; also the gap from
    /// which a released point's guard is armed.
    pub tolerance: S,
}

/// State of one point against the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum ContactState {
    /// Apart, guard armed.
    #[default]
    Free,
    /// Let go at the surface; the guard is armed once the gap exceeds the tolerance.
    Departing,
    /// On the surface, sliding or without friction.
    Held,
    /// On the surface, or in a ground that gives way, and held sideways by friction.
    Stuck,
}

impl ContactState {
    /// On the surface.
    #[must_use]
    pub fn is_held(self) -> bool {
        matches!(self, ContactState::Held | ContactState::Stuck)
    }
}

impl<S: Scalar> Ground<S> {
    /// gap (m).
    #[must_use]
    pub fn gap(&self, x: Vec3<S>) -> S {
        vec3::dot(self.normal, x) - self.offset
    }

    /// Is the place clearly below the surface? Returns are located at -tolerance, give or take rounding: which of two
    /// points alike lies beyond it says nothing.
    #[must_use]
    pub fn is_deep(&self, x: Vec3<S>) -> bool {
        self.gap(x) < -(S::from_f64(2.0) * self.tolerance)
    }

    /// gap rate (m/s).
    #[must_use]
    pub fn gap_rate(&self, v: Vec3<S>) -> S {
        vec3::dot(self.normal, v)
    }

    /// Is there no slip but what rounding makes of the speed along a sloping normal?
    #[must_use]
    pub fn is_still(&self, v: Vec3<S>) -> bool {
        let rounding = S::from_f64(4.0) * S::EPSILON * self.gap_rate(v).abs();
        vec3::norm(vec3::tangential(v, self.normal)) <= rounding
    }

    /// True where touch and release are located in time and the step is split there.
    #[must_use]
    pub fn has_events(&self) -> bool {
        matches!(self.law, ContactLaw::Compensation { .. } | ContactLaw::Newton { .. })
    }

    /// True where no point may be below the surface: the ground does not give way.
    #[must_use]
    pub fn is_rigid(&self) -> bool {
        !matches!(self.law, ContactLaw::Penalty { .. } | ContactLaw::HuntCrossley { .. })
    }

    /// True where the ground's force depends on speeds.
    #[must_use]
    pub fn is_damped(&self) -> bool {
        matches!(self.law, ContactLaw::HuntCrossley { dissipation, .. } if dissipation > S::ZERO)
    }
}

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
