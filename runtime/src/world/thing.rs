//! The things that can touch in a world, and which pairs of them may, by which law.

use super::extent::Extent;
use crate::contact::ForceLaw;
use crate::real::Scalar;
use crate::surface::{Frame, Shape};
use crate::vec3::{self, Vec3};

/// A thing with a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Thing<S> {
    /// A rigid shape.
    Rigid {
        /// The shape, in axes of its own.
        shape: Shape<S>,
        /// The port that carries it; None if it is fixed in space.
        port: Option<usize>,
        /// The shape's axes in those of the port, or in N.
        place: Place<S>,
    },
    /// A flexible body: its nodes touch other things, other things touch its facets.
    Mesh {
        /// First node and the one after the last.
        nodes: [usize; 2],
        /// First facet and the one after the last; no facets where only its nodes touch.
        facets: [usize; 2],
        /// Largest depth (m) below a facet that counts as contact with it: less than the distance to the body's
        /// opposite facets.
        depth: S,
    },
}

/// Position and orientation of axes in other axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place<S> {
    /// Their origin (m).
    pub origin: Vec3<S>,
    /// The axes: three orthogonal unit vectors.
    pub axes: [Vec3<S>; 3],
}

impl<S: Scalar> Place<S> {
    /// The other axes themselves.
    #[must_use]
    pub fn same() -> Place<S> {
        Place { origin: vec3::zero(), axes: Frame::inertial().axes }
    }

    /// Parallel axes with another origin.
    #[must_use]
    pub fn at(origin: Vec3<S>) -> Place<S> {
        Place { origin, ..Place::same() }
    }

    /// These axes as a frame in N, moving with the frame in which they are fixed.
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
    /// Indices of the things.
    pub things: [usize; 2],
    /// Coulomb's mu, >= 0.
    pub friction: S,
    /// Newton's e at each contact, 0 to 1; energy never rises.
    pub restitution: S,
    /// The law of the force by which they push where they overlap; then no impulse acts between them, and neither of
    /// the two numbers above.
    pub force: Option<ForceLaw<S>>,
}

impl<S: Scalar> Thing<S> {
    /// Whether its port, or its nodes and facets, are among so many.
    pub(super) fn exists(&self, ports: usize, nodes: usize, facets: usize) -> bool {
        let within = |[first, end]: [usize; 2], all: usize| first <= end && end <= all;
        match self {
            Thing::Rigid { port, .. } => port.is_none_or(|port| port < ports),
            Thing::Mesh { nodes: own, facets: of_it, .. } => within(*own, nodes) && within(*of_it, facets),
        }
    }
}

impl<S: Scalar> Pair<S> {
    /// Of things between which impulses act.
    #[must_use]
    pub fn striking(things: [usize; 2], restitution: S, friction: S) -> Pair<S> {
        Pair { things, friction, restitution, force: None }
    }

    /// Of things that push by a force.
    #[must_use]
    pub fn yielding(things: [usize; 2], law: ForceLaw<S>) -> Pair<S> {
        Pair { things, friction: S::ZERO, restitution: S::ZERO, force: Some(law) }
    }

    /// Whether the boxes around its things are within `margin` (m) of each other; true where there are no boxes.
    pub(super) fn may_meet(&self, extents: &[Extent<S>], margin: S) -> bool {
        let [Some(one), Some(other)] = self.things.map(|thing| extents.get(thing)) else { return true };
        one.is_near(other, margin)
    }
}
