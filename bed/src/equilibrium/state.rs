//! Where everything is: what an equilibrium is looked for from, and what it is.

use super::bed::Bed;
use super::rub::Rub;
use super::touch::Anchor;
use crate::pose::Pose;
use smartbed_runtime::vec3::Vec3;

/// Where everything is.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Nodes of each sheet in its tile's frame (m).
    pub sheets: Vec<Vec<Vec3<f64>>>,
    /// Segments in the bed's frame.
    pub segments: Vec<Pose>,
    /// What friction holds, by tile and node.
    pub anchors: Vec<Vec<Option<Anchor>>>,
    /// The same between sheets of neighbours.
    pub rubs: Vec<Rub>,
}

impl Bed {
    /// Sheets that bulge a little, without friction so far.
    #[must_use]
    pub fn start(&self, body: Vec<Pose>) -> State {
        // Away from the flat sheet, where its bulge has no stiffness.
        let bulged = self.lattice.bulged(0.1 * self.lattice.size[0].min(self.lattice.size[1]));
        let tiles = self.tiles.len();
        let anchors = vec![vec![None; self.lattice.nodes()]; tiles];
        State { sheets: vec![bulged; tiles], segments: body, anchors, rubs: Vec::new() }
    }
}
