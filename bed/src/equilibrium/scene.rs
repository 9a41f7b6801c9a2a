//! The scene whose energy is minimised.

use super::bed::Bed;
use super::beside::Meeting;
use super::increment::Increment;
use crate::body::Body;

/// Bed and body at one time and, in motion, the terms that a stage of time adds.
#[derive(Clone, Copy)]
pub struct Scene<'a> {
    /// The tiles.
    pub bed: &'a Bed,
    /// What lies on them.
    pub body: &'a Body,
    /// Inertia and dissipation of a stage of time; `None` in equilibrium.
    pub increment: Option<&'a Increment<'a>>,
    /// Contacts between neighbouring sheets.
    pub met: &'a [Meeting],
    /// Criteria of convergence.
    pub accuracy: Accuracy,
}

/// Largest residual forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accuracy {
    /// On a node, relative to the force of a pressure of 1 kPa on its area.
    pub node: f64,
    /// On a segment, relative to the weight; moments count at an arm of 0.1 m.
    pub segment: f64,
    /// Change of friction limits from pass to pass, relative to the weight; `None` keeps the initial limits.
    pub friction: Option<f64>,
}

impl<'a> Scene<'a> {
    /// A scene in equilibrium.
    pub fn at_rest(bed: &'a Bed, body: &'a Body) -> Scene<'a> {
        let accuracy = Accuracy { node: 1e-8, segment: 1e-9, friction: Some(1e-7) };
        Scene { bed, body, increment: None, met: &[], accuracy }
    }

    /// Largest residual force on a node (N).
    pub fn calm(&self) -> f64 {
        self.accuracy.node * 1000.0 * self.bed.lattice.cell()
    }

    /// A scene in motion, for one stage of time.
    pub fn in_motion(bed: &'a Bed, body: &'a Body, increment: &'a Increment<'a>) -> Scene<'a> {
        // Friction limits lag by a stage: they are those at its start.
        let accuracy = Accuracy { node: 1e-6, segment: 1e-7, friction: None };
        Scene { bed, body, increment: Some(increment), met: &[], accuracy }
    }
}
