//! Friction between sheets of neighbours: what a node has slid over a facet since the state before.
//!
//! In: a node and a facet that met in the state before, places of now. Out: energy, forces, stiffness. As between sheet and
//! tissue (`touch`): with D from node to foot and D0 in the state before, t = t0 + k P (D - D0) is held up to the limit mu N
//! of the meeting, beyond it |t| stays there. Facet and shares stay those of the state before; normal and limit are renewed.

use super::bed::Bed;
use smartbed_runtime::vec3::{Vec3, axpy, cross, dot, norm, scale, sub, tangential};

/// Tile, node and share of each end of D, from a node to its foot on a neighbour: the facet's corners w_i, the node -1.
pub type Ends = [(usize, usize, f64); 5];

/// D (m), in the bed's frame.
pub fn span(ends: &Ends, bed: &Bed, sheets: &[Vec<Vec3<f64>>]) -> Vec3<f64> {
    let place = |tile: usize, node: usize| bed.tiles[tile].pose.outwards(sheets[tile][node]);
    ends.iter().fold([0.0; 3], |sum, (tile, node, share)| axpy(sum, *share, place(*tile, *node)))
}

/// What friction holds between a node and a neighbour's sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rub {
    /// Those of the meeting in the state before.
    pub ends: Ends,
    /// D0 (m), in the bed's frame.
    pub before: Vec3<f64>,
    /// t0 (N).
    pub force: Vec3<f64>,
    /// Out of the facet.
    pub normal: Vec3<f64>,
    /// mu N (N).
    pub limit: f64,
    /// k (N/m).
    pub stiffness: f64,
}

impl Rub {
    /// t as a spring would have it.
    fn trial(&self, bed: &Bed, sheets: &[Vec<Vec3<f64>>]) -> Vec3<f64> {
        let slid = sub(span(&self.ends, bed, sheets), self.before);
        tangential(axpy(self.force, self.stiffness, slid), self.normal)
    }

    /// Energy (J) of the increment.
    #[must_use]
    pub fn energy(&self, bed: &Bed, sheets: &[Vec<Vec3<f64>>]) -> f64 {
        let t = norm(self.trial(bed, sheets));
        let energy = if t <= self.limit { 0.5 * t * t } else { self.limit * (t - 0.5 * self.limit) };
        energy / self.stiffness
    }

    /// Force (N): the energy's gradient by D.
    #[must_use]
    pub fn drag(&self, bed: &Bed, sheets: &[Vec<Vec3<f64>>]) -> Vec3<f64> {
        let t = self.trial(bed, sheets);
        let size = norm(t);
        if size > self.limit { scale(t, self.limit / size) } else { t }
    }

    /// Energy (J) that it holds.
    #[must_use]
    pub fn held(&self) -> f64 {
        0.5 * dot(self.force, self.force) / self.stiffness
    }

    /// Energy (J) that slip has taken since the state before, but for what is still held: work of friction by the trapezoid rule.
    #[must_use]
    pub fn taken(&self, bed: &Bed, sheets: &[Vec<Vec3<f64>>]) -> f64 {
        let slid = tangential(sub(span(&self.ends, bed, sheets), self.before), self.normal);
        self.held() + 0.5 * dot(axpy(self.force, 1.0, self.drag(bed, sheets)), slid)
    }

    /// Directions along the facet and the stiffness (N/m) in each: along t none where it slides, across it less.
    pub(super) fn ways(&self, bed: &Bed, sheets: &[Vec<Vec3<f64>>]) -> [(Vec3<f64>, f64); 2] {
        let t = self.trial(bed, sheets);
        let size = norm(t);
        let is_sliding = size > self.limit;
        let along = if size > 0.0 { scale(t, 1.0 / size) } else { any_across(self.normal) };
        let across = cross(self.normal, along);
        let less = if is_sliding { self.limit / size } else { 1.0 };
        [(along, if is_sliding { 0.0 } else { self.stiffness }), (across, less * self.stiffness)]
    }

    /// One of its ends is a tile's.
    #[must_use]
    pub fn is_of(&self, tile: usize) -> bool {
        self.ends.iter().any(|end| end.0 == tile)
    }
}

/// Some direction across a normal.
fn any_across(normal: Vec3<f64>) -> Vec3<f64> {
    let least = (0..3).min_by(|a, b| normal[*a].abs().total_cmp(&normal[*b].abs())).unwrap_or(0);
    let mut axis = [0.0; 3];
    axis[least] = 1.0;
    let across = cross(normal, axis);
    scale(across, 1.0 / norm(across))
}
