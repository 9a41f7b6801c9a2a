//! Working memory of a step, and what it has to say.

use super::touching::Touching;
use crate::rigid::RigidState;
use crate::rigid::contact::{Mobility, Twist};
use crate::rigid::several::Struck;

/// Working memory, its contents without meaning between steps. One entry per part, but of `touching`, `along` and
/// `struck`: as many as contacts are expected at once.
#[derive(Debug)]
pub struct Memory<'a, S> {
    /// States so far within the step, at the end of the way on trial, and in the middle of it.
    pub states: [&'a mut [RigidState<S>]; 3],
    /// Velocities or accelerations.
    pub twists: &'a mut [Twist<S>],
    /// The same.
    pub spare: &'a mut [Twist<S>],
    /// What the parts yield.
    pub mobilities: &'a mut [Mobility<S>],
    /// Contacts at the start of the way.
    pub touching: &'a mut [Touching<S>],
    /// Contacts along the way.
    pub along: &'a mut [Touching<S>],
    /// Contacts of an impact.
    pub struck: &'a mut [Struck<S>],
}

/// An impact within a step, shown while it happens.
#[derive(Clone, Copy, Debug)]
pub struct Strike<'a, S> {
    /// Time since the start of the step (s).
    pub time: S,
    /// Energy it took (J).
    pub loss: S,
    /// Features that took part, their velocities those before.
    pub touching: &'a [Touching<S>],
    /// The same with their impulses.
    pub struck: &'a [Struck<S>],
}

/// What a step did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Report<S> {
    /// Impacts.
    pub impacts: usize,
    /// Pieces the step was split into.
    pub splits: usize,
    /// Contacts that press at the end.
    pub held: usize,
    /// Sum of their normal forces (N).
    pub pressing: S,
    /// Energy taken by impacts (J).
    pub impact_loss: S,
    /// Energy taken by friction between impacts (J).
    pub friction_loss: S,
    /// Splits were used up: the rest of the step went with e = 0.
    pub forced: bool,
}
