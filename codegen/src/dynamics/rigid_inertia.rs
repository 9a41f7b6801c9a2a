//! A body with the inertia that the equations take for its own.

use super::spatial::Symmetric;
use crate::model::Body;

/// A body and the inertia that the equations take for its own, about its centre, in its frame.
#[derive(Clone, Debug)]
pub(super) struct RigidInertia<'m> {
    pub body: &'m Body,
    pub inertia: Symmetric,
}
