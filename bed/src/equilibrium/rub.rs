//! Friction between neighbouring sheets, from the slip of a node over a facet since the state before.
//!
//! In: a node and a facet that were in contact in the state before, and present positions. Out: energy, forces,
//! stiffness. As between sheet and tissue (`touch`): with D the vector from node to foot, D0 its value in the state
//! before, and P the tangential projection, the trial force t = t0 + k P (D - D0) is held up to the limit mu N; beyond
//! it |t| = mu N. Facet and weights are those of the state before; normal and limit are renewed in each pass.

use super::bed::Bed;
use smartbed_runtime::vec3::{Vec3, axpy, cross, dot, norm, scale, sub, tangential};

/// Tile, node and weight of each end of D, from a node to its foot on a neighbour: weights w_i of the facet's corners,
/// -1 of the node.
pub type Ends = [(usize, usize, f64); 5];

/// D (m), in the bed's frame.
pub fn span(ends: &Ends, bed: &Bed, sheets: &[Vec<Vec3<f64>>]) -> Vec3<f64> {
    let place = |tile: usize, node: usize| bed.tiles[tile].pose.outwards(sheets[tile][node]);
    ends.iter().fold([0.0; 3], |sum, (tile, node, share)| axpy(sum, *share, place(*tile, *node)))
}

/// Friction between a node and a neighbouring sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rub {
    /// Ends of D in the contact of the state before.
    pub ends: Ends,
    /// D0 (m), in the bed's frame.
    pub before: Vec3<f64>,
    /// t0 (N).
    pub force: Vec3<f64>,
    /// Outward normal of the facet.
    pub normal: Vec3<f64>,
    /// mu N (N).
    pub limit: f64,
    /// k (N/m).
    pub stiffness: f64,
}

impl Rub {
    /// Trial force t, as for a spring.
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

    /// Friction force (N), the gradient of the energy with respect to D.
    #[must_use]
    pub fn drag(&self, bed: &Bed, sheets: &[Vec<Vec3<f64>>]) -> Vec3<f64> {
        let t = self.trial(bed, sheets);
        let size = norm(t);
        if size > self.limit { scale(t, self.limit / size) } else { t }
    }

    /// Energy (J) stored in its spring.
    #[must_use]
    pub fn held(&self) -> f64 {
        0.5 * dot(self.force, self.force) / self.stiffness
    }

    /// Energy (J) dissipated by slip since the state before, plus what is still stored: work of friction by the
    /// trapezoidal rule.
    #[must_use]
    pub fn taken(&self, bed: &Bed, sheets: &[Vec<Vec3<f64>>]) -> f64 {
        let slid = tangential(sub(span(&self.ends, bed, sheets), self.before), self.normal);
        self.held() + 0.5 * dot(axpy(self.force, 1.0, self.drag(bed, sheets)), slid)
    }

    /// Tangential directions and the stiffness (N/m) in each. When it slides: zero along t, reduced perpendicular to
    /// it.
    pub(super) fn ways(&self, bed: &Bed, sheets: &[Vec<Vec3<f64>>]) -> [(Vec3<f64>, f64); 2] {
        let t = self.trial(bed, sheets);
        let size = norm(t);
        let is_sliding = size > self.limit;
        let along = if size > 0.0 { scale(t, 1.0 / size) } else { any_across(self.normal) };
        let across = cross(self.normal, along);
        let less = if is_sliding { self.limit / size } else { 1.0 };
        [(along, if is_sliding { 0.0 } else { self.stiffness }), (across, less * self.stiffness)]
    }

    /// Does the tile take part?
    #[must_use]
    pub fn is_of(&self, tile: usize) -> bool {
        self.ends.iter().any(|end| end.0 == tile)
    }
}

/// A unit vector perpendicular to a normal.
fn any_across(normal: Vec3<f64>) -> Vec3<f64> {
    let least = (0..3).min_by(|a, b| normal[*a].abs().total_cmp(&normal[*b].abs())).unwrap_or(0);
    let mut axis = [0.0; 3];
    axis[least] = 1.0;
    let across = cross(normal, axis);
    scale(across, 1.0 / norm(across))
}
