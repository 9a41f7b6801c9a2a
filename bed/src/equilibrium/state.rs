//! Positions of everything: start and result of a search for equilibrium.

use super::bed::Bed;
use super::rub::Rub;
use super::touch::Anchor;
use crate::pose::Pose;
use smartbed_runtime::vec3::Vec3;

/// Positions of everything, and the friction held there.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Positions of the nodes of each sheet, in its tile's frame (m).
    pub sheets: Vec<Vec<Vec3<f64>>>,
    /// Poses of the segments, in the bed's frame.
    pub segments: Vec<Pose>,
    /// Friction anchors, by tile and node.
    pub anchors: Vec<Vec<Option<Anchor>>>,
    /// Friction between neighbouring sheets.
    pub rubs: Vec<Rub>,
}

impl Bed {
    /// A start with slightly bulged sheets and no friction.
    #[must_use]
    pub fn start(&self, body: Vec<Pose>) -> State {
        // Not the flat sheet, whose bulge has no stiffness.
        let bulged = self.lattice.bulged(0.1 * self.lattice.size[0].min(self.lattice.size[1]));
        let tiles = self.tiles.len();
        let anchors = vec![vec![None; self.lattice.nodes()]; tiles];
        State { sheets: vec![bulged; tiles], segments: body, anchors, rubs: Vec::new() }
    }
}
