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

impl<S> From<NodeFault<S>> for BodyError<S> {
    fn from(fault: NodeFault<S>) -> Self {
        match fault {
            NodeFault::Memory { needed, given } => BodyError::Scratch { needed, given },
            NodeFault::NotFinite { node } => BodyError::NotFinite { point: node },
            NodeFault::NotConverged { step } => BodyError::NotConverged { step },
        }
    }
}
