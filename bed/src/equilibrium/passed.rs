//! Parts of a load that have passed through a sheet.
//!
//! In: a state. Out: the point of the load that lies deepest below a sheet. A node in contact is pushed out on the side
//! that is nearer, and nothing holds a node back that lies over a part: contact forces may balance the weight of a load
//! that hangs in the sheets from below.

use super::bed::Bed;
use super::state::State;
use crate::body::Body;
use crate::sheet::Lattice;
use smartbed_runtime::vec3::Vec3;

/// Least depth (m) of a point inside the load below a sheet from which on its part has passed through: tissue yields by
/// millimetres.
const PASSED: f64 = 0.01;
/// Barycentric coordinates down to this count as within a triangle, so that none is missed between two.
const RIM: f64 = 1e-9;

/// A part of a load below a sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Passed {
    /// Segment.
    pub segment: usize,
    /// Tile.
    pub tile: usize,
    /// Depth below its sheet (m).
    pub depth: f64,
}

/// The deepest part of a load, if it has passed through.
#[must_use]
pub fn passed(bed: &Bed, body: &Body, state: &State) -> Option<Passed> {
    let most = allowed(&bed.lattice);
    deepest(bed, body, state).filter(|found| found.depth > most)
}

/// Depth (m) below a sheet at which a part still counts as above it: between nodes, which alone bear it, and beside the
/// rim, which does not, a part reaches below the facets by up to half the diagonal of a cell.
#[must_use]
pub fn allowed(lattice: &Lattice) -> f64 {
    let [a, b] = [0, 1].map(|k| lattice.size[k] / lattice.intervals[k] as f64);
    PASSED.max(0.5 * a.hypot(b))
}

/// The part of a load whose core lies deepest below a sheet, if one does.
#[must_use]
pub fn deepest(bed: &Bed, body: &Body, state: &State) -> Option<Passed> {
    let highest = |sheet: &Vec<Vec3<f64>>| sheet.iter().fold(f64::NEG_INFINITY, |most, x| most.max(x[2]));
    let highest: Vec<f64> = state.sheets.iter().map(highest).collect();
    let mut deepest: Option<Passed> = None;
    for (segment, (part, pose)) in body.segments.iter().zip(&state.segments).enumerate() {
        let core: Vec<Vec3<f64>> = part.shape.core().into_iter().map(|p| pose.outwards(p)).collect();
        for (tile, own) in bed.tiles.iter().enumerate() {
            for point in &core {
                let point = own.pose.inwards(*point);
                if point[2] >= highest[tile] {
                    continue;
                }
                let depth = below(&bed.lattice, &state.sheets[tile], point);
                if depth > deepest.map_or(0.0, |found| found.depth) {
                    deepest = Some(Passed { segment, tile, depth });
                }
            }
        }
    }
    deepest
}

/// Depth (m) of a point below a sheet, in its tile's frame; 0 above it and outside the tile's rim. A point below has an
/// odd number of layers of the sheet over it, of which the lowest counts.
fn below(lattice: &Lattice, sheet: &[Vec3<f64>], point: Vec3<f64>) -> f64 {
    let [a, b] = lattice.size;
    if point[0].abs() >= 0.5 * a || point[1].abs() >= 0.5 * b {
        return 0.0;
    }
    let halves = lattice.facets().flat_map(|[p, q, r, s]| [[p, q, r], [p, r, s]]);
    let over = |corners: [usize; 3]| height(corners.map(|k| sheet[k]), point).map(|z| z - point[2]);
    let mut layers: Vec<f64> = halves.filter_map(over).filter(|z| *z > 0.0).collect();
    layers.sort_by(f64::total_cmp);
    // Triangles that share the edge over the point are one layer.
    layers.dedup_by(|next, last| *next - *last < RIM);
    if layers.len() % 2 == 1 { layers[0] } else { 0.0 }
}

/// Height of a triangle at a point's x and y, if it lies over or below it.
fn height([p, q, r]: [Vec3<f64>; 3], [x, y, _]: Vec3<f64>) -> Option<f64> {
    let area = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
    let from = |corner: Vec3<f64>| [corner[0] - x, corner[1] - y];
    let [to_p, to_q, to_r] = [p, q, r].map(from);
    let shares = [area(to_q, to_r), area(to_r, to_p), area(to_p, to_q)];
    let whole: f64 = shares.iter().sum();
    let shares = shares.map(|share| share / whole);
    let is_within = whole != 0.0 && shares.iter().all(|share| *share >= -RIM);
    is_within.then(|| shares[0] * p[2] + shares[1] * q[2] + shares[2] * r[2])
}
