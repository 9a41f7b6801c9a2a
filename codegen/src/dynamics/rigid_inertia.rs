//! A body with the inertia that the equations use for it, which may differ from the model's (`shared_axis`).

use super::spatial::Symmetric;
use crate::model::Body;

/// A body and the inertia that the equations use for it, about its mass centre, in its frame.
#[derive(Clone, Debug)]
pub(super) struct RigidInertia<'m> {
    pub body: &'m Body,
    pub inertia: Symmetric,
}
