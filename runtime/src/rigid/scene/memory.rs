//! Working memory of a step, and its report.

use super::touching::Touching;
use crate::rigid::RigidState;
use crate::rigid::contact::{Mobility, Twist};
use crate::rigid::struck::Struck;

/// Working memory; its contents mean nothing between steps. One entry per part, except for `touching`, `along` and
/// `struck`: as many as contacts are expected at once.
#[derive(Debug)]
pub struct Memory<'a, S> {
    /// States so far within the step, at the end of the trial piece, and in its middle.
    pub states: [&'a mut [RigidState<S>]; 3],
    /// Velocities or accelerations.
    pub twists: &'a mut [Twist<S>],
    /// Velocities or accelerations.
    pub spare: &'a mut [Twist<S>],
    /// Inverse inertia of the parts.
    pub mobilities: &'a mut [Mobility<S>],
    /// Contacts at the start of the piece.
    pub touching: &'a mut [Touching<S>],
    /// Contacts in the middle of the piece.
    pub along: &'a mut [Touching<S>],
    /// Contacts of an impact.
    pub struck: &'a mut [Struck<S>],
}

/// An impact within a step, shown while it happens.
#[derive(Clone, Copy, Debug)]
pub struct Strike<'a, S> {
    /// Time since the start of the step (s).
    pub time: S,
    /// Energy lost (J).
    pub loss: S,
    /// Features that took part, with the velocities before.
    pub touching: &'a [Touching<S>],
    /// The same contacts with their impulses.
    pub struck: &'a [Struck<S>],
    /// Velocities of the parts before and after.
    pub ends: [&'a [Twist<S>]; 2],
}

/// A piece of a step between events, shown when it is accepted.
#[derive(Clone, Copy, Debug)]
pub struct Piece<'a, S> {
    /// Its length (s).
    pub length: S,
    /// Lasting contacts with their mean forces; those without a normal force do nothing.
    pub along: &'a [Touching<S>],
    /// Velocities of the parts in its middle.
    pub twists: &'a [Twist<S>],
    /// Whether these forces are impulses over the piece, divided by its length: normal ones do work, too.
    pub strikes: bool,
}

/// Diagnostics of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Report<S> {
    /// Number of impacts.
    pub impacts: usize,
    /// Pieces the step was split into.
    pub splits: usize,
    /// Contacts that push at the end.
    pub held: usize,
    /// Sum of their normal forces (N).
    pub pressing: S,
    /// Energy lost to impacts (J).
    pub impact_loss: S,
    /// Energy lost to friction between impacts (J).
    pub friction_loss: S,
    /// Whether splits were used up: the rest of the step then went with e = 0.
    pub forced: bool,
    /// Whether contact forces were not found in a piece: contacts then acted by impulses over it.
    pub impulsive: bool,
}
