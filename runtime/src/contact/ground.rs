//! A plane ground of any orientation: its contact law, and the contact states of a point.
//!
//! In: a point's position and velocity. Out: gap = n.x - offset (m, > 0 apart), gap rate = n.v (m/s, < 0 closing).

use super::force::ForceLaw;
use crate::flexible::{BodyError, Quantity};
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// The law of contact between a point and the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ContactLaw<S> {
    /// Energy compensation along the springs.
    Compensation {
        /// Share of the lost energy that is given back: 1 as in the thesis, 0 plastic.
        eta: S,
        /// Whether each touch corrects the drift of the total energy (undamped bodies, small steps).
        anchor: bool,
        /// Whether points without a receiver lose their energy instead of rebounding.
        plastic_alone: bool,
        /// First point that may take energy: 0 for all, the first centre for thesis 5.9.
        first_receiver: usize,
    },
    /// v+ = -e v- at the instant of touch, for each point by itself.
    Newton {
        /// Coefficient of restitution e, 0 to 1.
        restitution: S,
    },
    /// Moreau's time stepping: v+ >= -e v- over each step; events are not located.
    Moreau {
        /// Coefficient of restitution e, 0 to 1.
        restitution: S,
    },
    /// Points that may touch have no mass; their position follows from statics. No event, no impact.
    MasslessPoint,
    /// A soft ground.
    Force(ForceLaw<S>),
}

/// A plane ground and its law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ground<S> {
    /// Outward unit normal.
    pub normal: Vec3<S>,
    /// n.x of the points on the surface (m).
    pub offset: S,
    /// Law between ground and points.
    pub law: ContactLaw<S>,
    /// Coulomb's coefficient, >= 0.
    pub friction: S,
    /// Other points within this gap (m), and closing, touch together with one that touches; also the gap from
    /// which the guard of a released point is armed.
    pub tolerance: S,
}

/// Contact state of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum ContactState {
    /// Apart from the ground; the guard on its gap is armed.
    #[default]
    Free,
    /// Just released at the surface; its guard is armed once the gap exceeds the tolerance.
    Departing,
    /// On the surface, sliding or without friction.
    Held,
    /// On the surface, or in a soft ground, and kept from sliding by friction.
    Stuck,
}

impl ContactState {
    /// Whether the point is held on the surface.
    #[inline]
    #[must_use]
    pub fn is_held(self) -> bool {
        matches!(self, ContactState::Held | ContactState::Stuck)
    }
}

impl<S: Scalar> Ground<S> {
    /// Checks its numbers, as the start of a run does on a host.
    ///
    /// # Errors
    /// The first that is out of range.
    pub fn check(&self) -> Result<(), BodyError<S>> {
        let size = |x: S| x >= S::ZERO && x.is_finite();
        let share = |x: S| S::ZERO <= x && x <= S::ONE;
        // Half of the digits, for a normal that was written out.
        let is_unit = (vec3::norm(self.normal) - S::ONE).abs() <= S::ROOT_EPSILON;
        let is_law = match self.law {
            ContactLaw::Compensation { eta, .. } => share(eta),
            ContactLaw::Newton { restitution } | ContactLaw::Moreau { restitution } => share(restitution),
            ContactLaw::MasslessPoint => true,
            ContactLaw::Force(law) => law.is_sound(),
        };
        let checks = [
            (is_unit, Quantity::Normal),
            (self.offset.is_finite() && size(self.tolerance), Quantity::Place),
            (size(self.friction), Quantity::Friction),
            (is_law, Quantity::Law),
        ];
        match checks.iter().find(|(is_sound, _)| !is_sound) {
            Some((_, quantity)) => Err(BodyError::OutOfRange(*quantity)),
            None => Ok(()),
        }
    }

    /// gap (m).
    #[must_use]
    pub fn gap(&self, x: Vec3<S>) -> S {
        vec3::dot(self.normal, x) - self.offset
    }

    /// Whether a position is clearly below the surface. Returns are located at -tolerance, up to rounding, so a depth
    /// of the tolerance alone proves nothing.
    #[must_use]
    pub fn is_deep(&self, x: Vec3<S>) -> bool {
        self.gap(x) < -(S::from_f64(2.0) * self.tolerance)
    }

    /// gap rate (m/s).
    #[must_use]
    pub fn gap_rate(&self, v: Vec3<S>) -> S {
        vec3::dot(self.normal, v)
    }

    /// Whether there is no slip beyond what rounding makes of the speed along a sloping normal.
    #[must_use]
    pub fn is_still(&self, v: Vec3<S>) -> bool {
        let rounding = S::from_f64(4.0) * S::EPSILON * self.gap_rate(v).abs();
        vec3::norm(vec3::tangential(v, self.normal)) <= rounding
    }

    /// Whether touch and release are located in time and the step is split there.
    #[must_use]
    pub fn has_events(&self) -> bool {
        matches!(self.law, ContactLaw::Compensation { .. } | ContactLaw::Newton { .. })
    }

    /// Whether the ground is rigid: no point may be below the surface.
    #[must_use]
    pub fn is_rigid(&self) -> bool {
        !matches!(self.law, ContactLaw::Force(_))
    }

    /// Whether the ground's force depends on speeds.
    #[must_use]
    pub fn is_damped(&self) -> bool {
        matches!(self.law, ContactLaw::Force(law) if law.dissipation() > S::ZERO)
    }
}
