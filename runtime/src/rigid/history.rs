//! History of one contact's impulse over the last sweeps, from which `anderson` extrapolates.

use super::contact::Contact;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Differences kept.
pub(crate) const DEPTH: usize = 6;

/// One contact's history.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct History<S> {
    /// f of the present sweep.
    pub(crate) moved: Vec3<S>,
    /// f and g of the last one.
    pub(crate) change: Vec3<S>,
    pub(crate) end: Vec3<S>,
    /// df and dg.
    pub(super) changes: [Vec3<S>; DEPTH],
    pub(super) ends: [Vec3<S>; DEPTH],
}

impl<S: Scalar> History<S> {
    /// Before the first sweep.
    #[must_use]
    pub fn empty() -> Self {
        let zero = vec3::zero();
        History { moved: zero, change: zero, end: zero, changes: [zero; DEPTH], ends: [zero; DEPTH] }
    }
}

/// A contact whose impulse sweeps change.
pub(crate) trait Swept<S> {
    /// The contact, the largest diagonal entry of its K (1/kg), and its history.
    fn parts(&mut self) -> (&mut Contact<S>, S, &mut History<S>);
}
