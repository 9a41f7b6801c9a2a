//! What can be touched in a world, and which two may touch by which law.

use crate::real::Scalar;
use crate::surface::{Frame, Shape};
use crate::vec3::{self, Vec3};

/// Something with a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Thing<S> {
    /// A rigid shape.
    Rigid {
        /// The shape, in axes of its own.
        shape: Shape<S>,
        /// The port that carries it; None if it is fixed in space.
        port: Option<usize>,
        /// Its own axes in the port's, or in N.
        place: Place<S>,
    },
    /// A flexible body: its nodes touch, its facets are touched.
    Mesh {
        /// First node and the one after the last.
        nodes: [usize; 2],
        /// First facet and the one after the last; none where only nodes touch.
        facets: [usize; 2],
        /// How deep (m) something may be below a facet and still be outside the body's other facets.
        depth: S,
    },
}

/// Where axes stand in other axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place<S> {
    /// Their origin (m).
    pub origin: Vec3<S>,
    /// The axes, unit vectors at right angles.
    pub axes: [Vec3<S>; 3],
}

impl<S: Scalar> Place<S> {
    /// The same axes.
    #[must_use]
    pub fn same() -> Place<S> {
        Place { origin: vec3::zero(), axes: Frame::inertial().axes }
    }

    /// The same axes, elsewhere.
    #[must_use]
    pub fn at(origin: Vec3<S>) -> Place<S> {
        Place { origin, ..Place::same() }
    }

    /// These axes with the motion of the frame in which they stand.
    #[must_use]
    pub fn in_frame(&self, frame: &Frame<S>) -> Frame<S> {
        let origin = frame.point(self.origin);
        let axes = self.axes.map(|axis| frame.to_inertial(axis));
        Frame { origin, axes, velocity: frame.velocity_at(origin), ..*frame }
    }
}

/// Two things that may touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair<S> {
    /// Their numbers.
    pub things: [usize; 2],
    /// Coulomb's mu, >= 0.
    pub friction: S,
    /// Newton's e at each point, 0 to 1; energy falls whatever it is.
    pub restitution: S,
}
