//! The data of `[frames]`: how each frame is oriented, and which vectors are stated to be constant in it.

use super::expression::{Axis, Expr};
use super::ids::FrameId;
use crate::source::Span;

/// A reference frame.
#[derive(Clone, PartialEq, Debug)]
pub struct Frame {
    /// Its name.
    pub name: String,
    /// How it is oriented.
    pub orientation: Orientation,
    /// Vectors stated to be constant in this frame: (vector, its x, y, z components here). A consequence of the
    /// constraints that the derivation may use; checked at the sampled configurations.
    pub fixed_vectors: Vec<FixedVector>,
    /// Where it is declared.
    pub span: Span,
}

/// `vector` has the constant components `components` in the frame that states it.
#[derive(Clone, PartialEq, Debug)]
pub struct FixedVector {
    /// The vector, given in other frames.
    pub vector: Expr,
    /// Its components here: expressions of parameters only.
    pub components: [Expr; 3],
    /// Where it is stated.
    pub span: Span,
}

/// Orientation of a frame.
#[derive(Clone, PartialEq, Debug)]
pub enum Orientation {
    /// The inertial frame.
    Inertial,
    /// Successive simple rotations from the parent, each about an axis of the frame reached so far (rad).
    Rotations {
        /// The frame to start from.
        parent: FrameId,
        /// (axis, angle) in order.
        rotations: Vec<(Axis, Expr)>,
    },
    /// Unit vectors given as vector expressions of other frames. Two are enough (the third is
    /// their cross product); they are orthonormal wherever the constraints hold. Angular velocity by Kane's definition.
    Directions {
        /// x, y, z.
        axes: [Option<Expr>; 3],
    },
    /// Euler parameters of the turn from the parent: cos(angle/2) and axis sin(angle/2), of unit length.
    Euler {
        /// The frame to start from.
        parent: FrameId,
        /// e0, e1, e2, e3.
        parameters: Box<[Expr; 4]>,
    },
}

/// The role of an expression of an [`Orientation`]: a number without unit, or a vector of such.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct OrientationPart {
    /// In words.
    pub what: &'static str,
    /// A vector?
    pub is_vector: bool,
}

impl OrientationPart {
    const ANGLE: Self = Self { what: "an angle of rotation", is_vector: false };
    const EULER: Self = Self { what: "an Euler parameter", is_vector: false };
    const DIRECTION: Self = Self { what: "a unit vector", is_vector: true };
}

impl Orientation {
    /// The frame from which the rotations start, whatever frames the expressions name.
    #[must_use]
    pub fn parent(&self) -> Option<FrameId> {
        match self {
            Self::Rotations { parent, .. } | Self::Euler { parent, .. } => Some(*parent),
            Self::Inertial | Self::Directions { .. } => None,
        }
    }

    /// Its expressions. Checks and walks go through these alone: they know of no kind of orientation.
    #[must_use]
    pub fn expressions(&self) -> Vec<(OrientationPart, &Expr)> {
        match self {
            Self::Inertial => Vec::new(),
            Self::Rotations { rotations, .. } => {
                rotations.iter().map(|(_, angle)| (OrientationPart::ANGLE, angle)).collect()
            }
            Self::Euler { parameters, .. } => {
                parameters.iter().map(|e| (OrientationPart::EULER, e)).collect()
            }
            Self::Directions { axes } => {
                axes.iter().flatten().map(|axis| (OrientationPart::DIRECTION, axis)).collect()
            }
        }
    }
}
