//! What an observer of a world is shown while a step is taken: forces, contacts, impacts, each with the velocities over
//! which it works. No step reads anything back, so a world moves alike with and without one.
//!
//! ```text
//! work = duration * force . (v + v')/2      v, v': the two lists of velocities that are shown with the force
//! ```

use super::detect::Touch;
use crate::real::Scalar;
use crate::rigid::contact::{Contact, Twist};
use crate::rigid::struck::Struck;
use crate::vec3::Vec3;

/// Velocities of ports, then of nodes, at two ends; what acts between them works over their mean.
pub type Ends<'a, S> = [&'a [Twist<S>]; 2];

/// Forces on all nodes, but those of contacts on nodes that are attached.
#[derive(Clone, Copy, Debug)]
pub struct Forces<'a, S> {
    /// For how long they act (s): the step, or the weight of an instant in a rule of integration.
    pub duration: S,
    /// Forces that depend on positions (N).
    pub elastic: &'a [Vec3<S>],
    /// Forces that depend on speeds (N).
    pub viscous: &'a [Vec3<S>],
    /// Velocities, those of attached nodes included.
    pub ends: Ends<'a, S>,
}

/// What a contact does.
#[derive(Clone, Copy, Debug)]
pub struct Push<'a, S> {
    /// Number of its pair.
    pub pair: usize,
    /// Its sides, axes and force (N) or impulse (N s).
    pub contact: &'a Contact<S>,
    /// For how long the force acts (s); 1 for an impulse.
    pub duration: S,
    /// Velocities.
    pub ends: Ends<'a, S>,
    /// Is the work of the normal force a loss by impact? A lasting contact's normal force does none.
    pub strikes: bool,
    /// Power that a force law takes (W).
    pub taken: S,
}

/// An impact within a step, shown while it happens.
#[derive(Clone, Copy, Debug)]
pub struct Strike<'a, S> {
    /// Time since the start of the step (s).
    pub time: S,
    /// The contacts, with the velocities before.
    pub touches: &'a [Touch<S>],
    /// The same contacts with their impulses.
    pub struck: &'a [Struck<S>],
    /// Velocities before and after.
    pub ends: Ends<'a, S>,
}

/// Sees a world move.
pub trait Observer<S: Scalar> {
    /// Does it see forces and contacts? Nothing is prepared for one that does not.
    fn watches(&self) -> bool;
    /// Forces that act for a while.
    fn forces(&mut self, forces: &Forces<'_, S>);
    /// A node, or the damper whose tail it is, takes energy (J) beyond the viscous forces that were shown.
    fn damped(&mut self, node: usize, energy: S);
    /// The drives of a member of a group of carriers give work, its dampers take energy (J).
    fn carried(&mut self, member: usize, works: [S; 2]);
    /// A contact pushes.
    fn push(&mut self, push: &Push<'_, S>);
    /// An impact, even of a step that is refused in the end.
    fn strike(&mut self, strike: &Strike<'_, S>);
}

/// Nobody watches.
impl<S: Scalar> Observer<S> for () {
    fn watches(&self) -> bool {
        false
    }
    fn forces(&mut self, _: &Forces<'_, S>) {}
    fn damped(&mut self, _: usize, _: S) {}
    fn carried(&mut self, _: usize, _: [S; 2]) {}
    fn push(&mut self, _: &Push<'_, S>) {}
    fn strike(&mut self, _: &Strike<'_, S>) {}
}
