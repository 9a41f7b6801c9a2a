//! Predicts which nodes will touch within a stage, and resolves their impacts before the stage is computed.
//!
//! In: a motion and the formula of its next stage. Out: the motion with velocities after the impacts.

use super::impact::{Sheet, Yields, strike};
use super::motion::{Motion, spin};
use crate::equilibrium::scene::Scene;
use crate::equilibrium::tile::Patch;
use crate::equilibrium::{Bed, State, Touch};
use crate::method::Formula;
use smartbed_runtime::vec3::{axpy, cross, scale, sub};

impl Motion {
    /// Resolves the impacts of nodes that will touch within the stage, sheet after sheet.
    pub(super) fn strike(&mut self, formula: &Formula, bed: &Bed) {
        let ahead = self.ahead(formula, bed);
        let scene = Scene::at_rest(bed, &self.body);
        let coming = |tile: usize| -> Vec<Touch> {
            let is_new = |t: &Touch| !self.layers[tile].contains_key(&(t.node, t.segment));
            Patch::new(&scene, &ahead, tile).touches().into_iter().map(|(t, _)| t).filter(is_new).collect()
        };
        let coming: Vec<Vec<Touch>> = (0..bed.tiles.len()).map(coming).collect();
        if coming.iter().all(Vec::is_empty) {
            return;
        }
        let yields = Yields::new(&self.body, &self.now.state.segments, self.node_mass());
        let lasting = self.lasting(formula.seconds);
        for (tile, touches) in coming.iter().enumerate().filter(|(_, touches)| !touches.is_empty()) {
            let is_touched = |node: usize| self.layers[tile].range((node, 0)..(node + 1, 0)).next().is_some();
            let is_open = |node: usize| bed.lattice.free(node).is_some() && !is_touched(node);
            let is_free: Vec<bool> = (0..bed.lattice.nodes()).map(is_open).collect();
            let sheet = Sheet {
                lattice: &bed.lattice,
                is_free: &is_free,
                seconds: formula.seconds,
                last: self.last,
                lasting,
            };
            let poses = &self.now.state.segments;
            let blow = strike(&sheet, &yields, touches, poses, &mut self.nodes[tile], &mut self.segments);
            self.blows = self.blows.and(blow);
            self.ledger.lost_in_sheets += (1.0 - lasting) * blow.handed_on;
        }
    }

    /// Share of a velocity difference along a spring that its damper leaves at the end of a stage: exp(-2 c h/m) at
    /// most.
    pub(super) fn lasting(&self, seconds: f64) -> f64 {
        let softest = self.bed.lattice.springs.iter().map(|s| s.stiffness).fold(f64::INFINITY, f64::min);
        (-2.0 * self.matter.sheet_loss * softest * seconds / self.node_mass()).exp()
    }

    /// The state at the end of a stage without any contact forces.
    fn ahead(&self, formula: &Formula, bed: &Bed) -> State {
        let mut ahead = self.now.state.clone();
        for (tile, sheet) in ahead.sheets.iter_mut().enumerate() {
            let pose = &bed.tiles[tile].pose;
            for (node, x) in sheet.iter_mut().enumerate().filter(|(n, _)| bed.lattice.free(*n).is_some()) {
                *x = pose.inwards(self.nodes[tile][node].onwards(formula));
            }
        }
        for (pose, tracks) in ahead.segments.iter_mut().zip(&self.segments) {
            let middle = tracks.iter().fold([0.0; 3], |sum, t| axpy(sum, 1.0 / 6.0, t.velocity));
            let turn = scale(spin(tracks), formula.seconds);
            let arm = sub(pose.place, tracks.iter().fold([0.0; 3], |sum, t| axpy(sum, 1.0 / 6.0, t.place)));
            *pose = pose.moved(axpy(cross(turn, arm), formula.seconds, middle), turn);
        }
        ahead
    }
}
