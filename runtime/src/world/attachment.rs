//! Nodes of flexible bodies that a port holds.
//!
//! In: node, port, place in the port's frame. Such a node moves with the port and has no mass of its own.

use crate::vec3::Vec3;

/// A node that is held in the frame of a port.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attachment<S> {
    /// The node; the body must mark it as fixed and give it no mass.
    pub node: usize,
    /// The port.
    pub port: usize,
    /// Its position in the port's frame (m).
    pub place: Vec3<S>,
    /// What gas pushes the facets beside it with that the same port holds, in the port's frame: force per pressure
    /// (m^2). See [`Wall`](super::Wall).
    pub push: Vec3<S>,
}
