//! The data of `[view]`: what pictures of a model show. No equation depends on it.

use super::expression::{Axis, Expr};
use super::ids::{BodyId, PointId};

/// `[view]`: options of pictures. No equation depends on it.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct View {
    /// Shapes in place of inertia ellipsoids.
    pub shapes: Vec<(BodyId, Shape)>,
    /// Colours (red, green, blue).
    pub colours: Vec<(Shown, [u8; 3])>,
    /// Items that are left out.
    pub hidden: Vec<Shown>,
    /// Rods between points; `None` for those that the points' expressions suggest.
    pub links: Option<Vec<[PointId; 2]>>,
}

/// An item of a picture.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Shown {
    /// A body.
    Body(BodyId),
    /// A point.
    Point(PointId),
    /// A spring, by its index among the loads.
    Spring(usize),
}

/// The shape of a body, along the axes of its frame.
#[derive(Clone, PartialEq, Debug)]
pub struct Shape {
    /// Its kind.
    pub kind: ShapeKind,
    /// Its lengths (m), in the order of [`ShapeKind`].
    pub sizes: Vec<Expr>,
    /// Axis of a cylinder.
    pub axis: Axis,
    /// Its middle, if that is not the mass centre.
    pub at: Option<PointId>,
}

/// Kinds of shapes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ShapeKind {
    /// Edges along x, y, z.
    Box,
    /// Radius, length.
    Cylinder,
    /// Radius.
    Ball,
}
