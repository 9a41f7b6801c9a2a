//! The data of what acts on a mechanism: forces, torques, spring-dampers, and the ports at which other parts act.

use super::expression::Expr;
use super::ids::{CoordinateId, FrameId, PointId};
use crate::source::Span;

/// Something that does work on the mechanism.
#[derive(Clone, PartialEq, Debug)]
pub struct Load {
    /// Its name.
    pub name: String,
    /// Its kind, and where it acts.
    pub kind: LoadKind,
    /// Where it is declared.
    pub span: Span,
}

/// Kinds of loads.
#[derive(Clone, PartialEq, Debug)]
pub enum LoadKind {
    /// Force vector (N) at a point; the reaction acts on `reaction` if given, else on the ground.
    Force {
        /// Point of application.
        point: PointId,
        /// Force.
        force: Expr,
        /// Point that feels the reaction.
        reaction: Option<PointId>,
    },
    /// Torque vector (N m) on a frame's body; the reaction on `reaction` if given, else on the ground.
    Torque {
        /// Frame it acts on.
        frame: FrameId,
        /// Torque.
        torque: Expr,
        /// Frame that feels the reaction.
        reaction: Option<FrameId>,
    },
    /// Linear spring-damper between two points. Tension = stiffness (length - rest_length) + damping length_rate.
    Spring {
        /// The two ends.
        ends: [PointId; 2],
        /// Stiffness (N/m).
        stiffness: Expr,
        /// Rest length (m).
        rest_length: Expr,
        /// Damping (N s/m).
        damping: Option<Expr>,
    },
    /// Spring-damper on a coordinate: generalised force -stiffness (q - rest) - damping q_dot.
    CoordinateSpring {
        /// The coordinate.
        coordinate: CoordinateId,
        /// Stiffness (unit of force per unit of q).
        stiffness: Expr,
        /// Value without force.
        rest: Expr,
        /// Damping.
        damping: Option<Expr>,
    },
}

/// A frame with a point at which other parts attach: they follow its pose and push it with a wrench.
#[derive(Clone, PartialEq, Debug)]
pub struct Port {
    /// Its name.
    pub name: String,
    /// Description.
    pub doc: String,
    /// The frame that attached parts turn with.
    pub frame: FrameId,
    /// The point that they move with; moments are about it.
    pub point: PointId,
    /// Where it is declared.
    pub span: Span,
}
