//! Contacts at a state, before anything moves: what a start is checked for.
//!
//! In: a time and a state. Out: the list of contacts in the step's memory, each with its gap (m).

use super::carrier::Carrier;
use super::whole::{StepMemory, World};
use crate::mechanism::Fault;
use crate::real::Scalar;

impl<S: Scalar, C: Carrier<S>> World<'_, S, C> {
    /// Finds the places where the parts of pairs touch or overlap at a state: [`StepMemory::contacts`], of which the
    /// gaps are at most 0.
    ///
    /// # Errors
    /// As [`World::step`].
    pub fn look(&mut self, t: S, x: &[S], memory: &mut StepMemory<'_, S>) -> Result<(), Fault> {
        self.island.place(t, x)?;
        // In no time nothing comes nearer.
        self.find_contacts((t, S::ZERO), x, memory).map(|_| ())
    }
}
