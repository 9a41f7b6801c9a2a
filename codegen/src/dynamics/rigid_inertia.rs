//! A body with the inertia that the equations take for its own.

use crate::expr::ExprId;
use crate::model::Body;

/// Ixx, Iyy, Izz, Ixy, Ixz, Iyz.
pub(super) type Moments = [ExprId; 6];

/// A body and the inertia that the equations take for its own, about its centre, in its frame.
#[derive(Clone, Debug)]
pub(super) struct RigidInertia<'m> {
    pub body: &'m Body,
    pub inertia: Moments,
}
