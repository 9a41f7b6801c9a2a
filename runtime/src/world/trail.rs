//! History of one contact's impulse over the last sweeps, from which `anderson` extrapolates.

use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Differences kept.
pub(super) const DEPTH: usize = 6;

/// One contact's history.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Trail<S> {
    /// f and g of the last sweep.
    pub(super) change: Vec3<S>,
    pub(super) end: Vec3<S>,
    /// df and dg.
    pub(super) changes: [Vec3<S>; DEPTH],
    pub(super) ends: [Vec3<S>; DEPTH],
}

impl<S: Scalar> Trail<S> {
    pub(super) fn empty() -> Self {
        let zero = vec3::zero();
        Trail { change: zero, end: zero, changes: [zero; DEPTH], ends: [zero; DEPTH] }
    }
}
