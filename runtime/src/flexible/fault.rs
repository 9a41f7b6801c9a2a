//! Why a body or its motion is refused.

use crate::ode::nodes::NodeFault;

/// Why a body or its motion is refused.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BodyError<S> {
    /// The body has no points.
    Empty,
    /// Slices that must agree differ in length.
    Length {
        /// Number of points.
        expected: usize,
        /// Length found.
        found: usize,
    },
    /// A spring or facet names a point that does not exist.
    UnknownPoint {
        /// The point.
        point: usize,
        /// Number of points.
        points: usize,
    },
    /// A constant of the body, of its ground or of a step is out of range.
    OutOfRange(Quantity),
    /// A mass, stiffness, damping or rest length is negative or not a number.
    Negative {
        /// Index of the point or spring.
        index: usize,
    },
    /// The scratch memory is too small.
    Scratch {
        /// Vectors needed.
        needed: usize,
        /// Vectors given.
        given: usize,
    },
    /// A position or speed, or its square, is not finite; the last good state is kept.
    NotFinite {
        /// The point.
        point: usize,
    },
    /// A point starts below a rigid ground.
    BelowGround {
        /// The point.
        point: usize,
        /// Its depth (m).
        depth: S,
    },
    /// A point with mass went through a ground that carries only massless points; the last good state is kept.
    ThroughGround {
        /// The point.
        point: usize,
    },
    /// The body grows without bound under its pressure; the last good state is kept.
    PressureTooHigh {
        /// Gauge pressure (Pa) that no equilibrium carries.
        pressure: S,
        /// The spring stretched beyond [`super::spring::STRETCH_LIMIT`].
        spring: usize,
    },
    /// The enclosed volume is not positive, so a gas law has no pressure; the last good state is kept.
    Collapsed {
        /// Enclosed volume (m^3).
        volume: S,
    },
    /// The iteration of an implicit step did not converge: the step is too long.
    NotConverged {
        /// Length of the step (s).
        step: S,
    },
}

/// What is out of range.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Quantity {
    /// The length of a step.
    Step,
    /// The body's gravity.
    Gravity,
    /// The body's air drag.
    AirDrag,
    /// Pressure, volume or exponent of the gas.
    Gas,
    /// The list of inverse masses.
    InverseMass,
    /// The list of massless points.
    MasslessPoints,
    /// The list of their springs.
    MasslessSprings,
    /// The ground's normal.
    Normal,
    /// The ground's offset or tolerance.
    Place,
    /// The ground's friction.
    Friction,
    /// A number of the ground's law.
    Law,
}

impl Quantity {
    /// What is expected of it, in words.
    #[must_use]
    pub fn expected(self) -> &'static str {
        match self {
            Quantity::Step => "a step of a finite time above 0 s",
            Quantity::Gravity => "a finite gravity",
            Quantity::AirDrag => "an air drag of 0 or more, finite",
            Quantity::Gas => "a gas of finite pressures, with a volume and an exponent above 0",
            Quantity::InverseMass => {
                "1/mass of each point in `inverse_mass`, 0 where it is fixed or has no mass"
            }
            Quantity::MasslessPoints => "points of mass 0 that are not fixed in `massless.points`",
            Quantity::MasslessSprings => {
                "the springs of each massless point in `massless.springs`, from `first` on"
            }
            Quantity::Normal => "a ground whose normal has length 1",
            Quantity::Place => "a ground of finite offset and tolerance, the tolerance 0 or more",
            Quantity::Friction => "a ground whose friction is 0 or more, finite",
            Quantity::Law => {
                "a law of restitution or share from 0 to 1, stiffness and dissipation 0 or more, finite"
            }
        }
    }
}

impl<S> From<NodeFault<S>> for BodyError<S> {
    fn from(fault: NodeFault<S>) -> Self {
        match fault {
            NodeFault::Memory { needed, given } => BodyError::Scratch { needed, given },
            NodeFault::NotFinite { node } => BodyError::NotFinite { point: node },
            NodeFault::NotConverged { step } => BodyError::NotConverged { step },
        }
    }
}
