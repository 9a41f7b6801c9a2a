//! A plane ground of any orientation: its law and what a point against it does.
//!
//! In: a point's place and velocity; out: gap = n.x - offset (m, > 0 apart) and gap rate = n.v (m/s, < 0 closing).

use crate::real::Scalar;
use crate::vec3::{self, Vec3};

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
    #[inline]
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
