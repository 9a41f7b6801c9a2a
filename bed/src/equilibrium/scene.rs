//! What a state of least energy is looked for in.

use super::bed::Bed;
use super::beside::Meeting;
use super::increment::Increment;
use crate::body::Body;

/// Bed and body at a time, and what a stage of time adds.
#[derive(Clone, Copy)]
pub struct Scene<'a> {
    /// Tiles.
    pub bed: &'a Bed,
    /// What lies on them.
    pub body: &'a Body,
    /// Inertia and losses of a stage of time; none in equilibrium.
    pub increment: Option<&'a Increment<'a>>,
    /// Where sheets of neighbours meet.
    pub met: &'a [Meeting],
    /// When a state is good enough.
    pub accuracy: Accuracy,
}

/// Forces that may be left over.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accuracy {
    /// On a node, of what a pressure of 1 kPa does to it.
    pub node: f64,
    /// On a segment, of the weight; moments at an arm of 0.1 m.
    pub segment: f64,
    /// Change of friction's limits from pass to pass, of the weight; none keeps those of the start.
    pub friction: Option<f64>,
}

impl<'a> Scene<'a> {
    /// Where nothing moves.
    pub fn at_rest(bed: &'a Bed, body: &'a Body) -> Scene<'a> {
        let accuracy = Accuracy { node: 1e-8, segment: 1e-9, friction: Some(1e-7) };
        Scene { bed, body, increment: None, met: &[], accuracy }
    }

    /// Force (N) that may be left over on a node.
    pub fn calm(&self) -> f64 {
        self.accuracy.node * 1000.0 * self.bed.lattice.cell()
    }

    /// A stage of time.
    pub fn in_motion(bed: &'a Bed, body: &'a Body, increment: &'a Increment<'a>) -> Scene<'a> {
        // Limits of friction lag by a stage: they are those of its start.
        let accuracy = Accuracy { node: 1e-6, segment: 1e-7, friction: None };
        Scene { bed, body, increment: Some(increment), met: &[], accuracy }
    }
}
