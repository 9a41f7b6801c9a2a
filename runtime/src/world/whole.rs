//! A world as a whole: the parts that move together, what of them can touch, and the memory of a step.

use super::detect::Touch;
use super::extent::Extent;
use super::inertia::Inertias;
use super::island::Island;
use super::thing::{Pair, Thing};
use crate::mechanism::Fault;
use crate::real::Scalar;
use crate::rigid::contact::Twist;
use crate::surface::Frame;
use crate::vec3::Vec3;

/// Parts that move together, with the things that can touch and the contact law of each pair.
#[derive(Debug)]
pub struct World<'a, S, C> {
    /// Carriers and flexible bodies.
    pub island: Island<'a, S, C>,
    /// The things that can touch.
    pub things: &'a [Thing<S>],
    /// The pairs of them that may touch, each with its law.
    pub pairs: &'a [Pair<S>],
}

impl<S: Scalar, C> World<'_, S, C> {
    /// Refuses a step of h (s) that does not lead forward in time, and things and pairs that are not there to touch.
    pub(super) fn check(&self, h: S) -> Result<(), Fault> {
        if !(h > S::ZERO && h.is_finite()) {
            return Err(Fault::StepSize);
        }
        let (body, ports) = (&self.island.body, self.island.memory.frames.len());
        let exists = |thing: &Thing<S>| thing.exists(ports, body.points(), body.facets.len());
        let known = |pair: &Pair<S>| pair.things.iter().all(|thing| *thing < self.things.len());
        if !(self.things.iter().all(exists) && self.pairs.iter().all(known)) {
            return Err(Fault::Shape);
        }
        let is_number = |pair: &Pair<S>| {
            let law = pair.force.is_none_or(|law| law.is_sound());
            law && pair.friction.is_finite() && pair.restitution.is_finite()
        };
        if self.pairs.iter().all(is_number) { Ok(()) } else { Err(Fault::NonFinite) }
    }
}

/// Working memory of a step.
#[derive(Debug)]
pub struct StepMemory<'a, S> {
    /// [`StepMemory::scratch`] numbers.
    pub scratch: &'a mut [S],
    /// Frames of the ports at the start and at the end, one entry per port each.
    pub frames: [&'a mut [Frame<S>]; 2],
    /// Velocities at the start, at the end without contacts, at the end: one entry per port and node each. Those of
    /// nodes that touch nothing are written only where someone watches.
    pub twists: [&'a mut [Twist<S>]; 3],
    /// Normals at the nodes; may be empty where no facet is touched.
    pub normals: &'a mut [Vec3<S>],
    /// Inverse inertia of ports and nodes.
    pub inertias: Inertias<'a, S>,
    /// Boxes around the things, one entry per thing; may be empty where there are few pairs.
    pub extents: &'a mut [Extent<S>],
    /// Contacts of this step, and room for those of a search within it: as many as are expected at once.
    pub touches: [&'a mut [Touch<S>]; 2],
    /// Numbers of contacts in both lists.
    pub counts: [usize; 2],
}

impl<S: Scalar> StepMemory<'_, S> {
    /// Numbers of scratch memory for a state of `n` entries.
    #[must_use]
    pub const fn scratch(n: usize) -> usize {
        5 * n
    }

    /// Contacts of the last step.
    #[must_use]
    pub fn contacts(&self) -> &[Touch<S>] {
        self.touches[0].get(..self.counts[0]).unwrap_or_default()
    }
    /// Exchanges the two lists of contacts.
    pub(super) fn swap_lists(&mut self) {
        self.touches.swap(0, 1);
        self.counts.swap(0, 1);
    }
}
