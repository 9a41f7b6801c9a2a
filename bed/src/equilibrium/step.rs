//! One Newton step of the whole bed: all sheets eliminated, then the segments, then each sheet.
//!
//! In: the contributions of each tile. Out: steps of nodes, displacements and rotations of segments. With D the
//! segments' own Hessian and Z = (K + c g g')^-1 B of each tile: (D - sum B' Z) y = -(g_y - sum B' K^-1 g_x), x = -K^-1
//! g_x - Z y.

use super::bed::{Bed, GRAVITY};
use super::bridge::Bridge;
use super::scene::Scene;
use super::state::State;
use super::stiffness::product;
use super::tile::Eliminated;
use crate::band::Band;
use crate::body::{Body, Rows};
use smartbed_runtime::vec3::{add, scale};

/// Largest displacement or rotation of a segment in one step (m, rad).
const LONGEST: f64 = 0.02;
/// Smallest stiffness (N/m, N m/rad) added to a segment, because nothing resists a spinning ball. It is increased until
/// the step is short enough, as for a body that touches nothing yet.
const SPIN: f64 = 1e-3;

/// A Newton step of all nodes and segments.
pub struct Ways {
    nodes: Vec<Vec<f64>>,
    segments: Vec<f64>,
}

/// The segments' rows with contact forces, before the sheets are eliminated.
pub fn rows(scene: &Scene, state: &State, tiles: &[Option<Eliminated>]) -> Rows {
    let mut rows = of_body(scene, state);
    for bond in tiles.iter().flatten().flat_map(|t| &t.bonds) {
        rows.add_gradient(bond.segment, bond.arm, bond.pull.gradient, -1.0);
        rows.add_hessian([bond.segment; 2], [bond.arm; 2], &bond.pull.hessian, 1.0);
    }
    rows
}

/// The segments' rows without contact forces.
pub fn of_body(scene: &Scene, state: &State) -> Rows {
    let mut rows = Rows::new(scene.body.segments.len());
    scene.body.add_to(&state.segments, GRAVITY, &mut rows);
    if let Some(increment) = scene.increment {
        increment.add_body(scene.body, &state.segments, &mut rows);
    }
    rows
}

impl Ways {
    /// Computes the step.
    pub fn new(scene: &Scene, rows: &Rows, tiles: &[Option<Eliminated>]) -> Ways {
        let (bed, body) = (scene.bed, scene.body);
        let bridge = Bridge::new(tiles, rows.gradient.len());
        let segments = of_segments(body, rows, tiles, &bridge);
        let size = 3 * bed.lattice.free_nodes();
        let nodes = |tile: &Option<Eliminated>| {
            let Some(tile) = tile else { return vec![0.0; size] };
            let mut way: Vec<f64> = tile.solved.iter().map(|x| -x).collect();
            for coupling in &tile.couplings {
                let y = &segments[6 * coupling.segment..6 * coupling.segment + 6];
                way.iter_mut().zip(&coupling.solved).for_each(|(w, z)| *w -= product(y, z));
            }
            for crossing in &tile.crossings {
                let force = bridge.force(crossing.number, &segments);
                way.iter_mut().zip(&crossing.solved).for_each(|(w, z)| *w -= force * z);
            }
            way
        };
        Ways { nodes: tiles.iter().map(nodes).collect(), segments }
    }

    /// Largest displacement of a node (m).
    pub fn longest(&self) -> f64 {
        self.nodes.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()))
    }

    /// Derivative of the energy along the step, from the gradients with respect to nodes and segments.
    pub fn slope(&self, nodes: &[impl AsRef<[f64]>], rows: &Rows) -> f64 {
        let sheets: f64 = self.nodes.iter().zip(nodes).map(|(way, g)| product(way, g.as_ref())).sum();
        sheets + product(&self.segments, &rows.gradient)
    }

    /// The state after a fraction of the step.
    pub fn taken(&self, bed: &Bed, state: &State, share: f64) -> State {
        let mut next = state.clone();
        for (sheet, way) in next.sheets.iter_mut().zip(&self.nodes) {
            for (node, x) in sheet.iter_mut().enumerate() {
                if let Some(free) = bed.lattice.free(node) {
                    *x = add(*x, scale([way[3 * free], way[3 * free + 1], way[3 * free + 2]], share));
                }
            }
        }
        for (index, pose) in next.segments.iter_mut().enumerate() {
            let part = |k: usize| [0, 1, 2].map(|i| share * self.segments[6 * index + 3 * k + i]);
            *pose = pose.moved(part(0), part(1));
        }
        next
    }
}

/// D - sum B' Z plus the contribution of contacts between sheets, row by row.
pub fn condensed(rows: &Rows, tiles: &[Option<Eliminated>], bridge: &Bridge) -> Vec<f64> {
    let size = rows.gradient.len();
    let mut hessian = rows.hessian.clone();
    for tile in tiles.iter().flatten() {
        for a in &tile.couplings {
            for b in &tile.couplings {
                let mut block = [[0.0; 6]; 6];
                for (column, solved) in a.columns.iter().zip(&b.solved).filter(|(c, _)| **c != [0.0; 6]) {
                    (0..6).for_each(|i| (0..6).for_each(|j| block[i][j] += column[i] * solved[j]));
                }
                for (i, row) in block.iter().enumerate() {
                    let start = (6 * a.segment + i) * size + 6 * b.segment;
                    hessian[start..start + 6].iter_mut().zip(row).for_each(|(h, x)| *h -= x);
                }
            }
        }
    }
    bridge.add_to(&mut hessian);
    hessian
}

/// Displacements and rotations of the segments.
fn of_segments(body: &Body, rows: &Rows, tiles: &[Option<Eliminated>], bridge: &Bridge) -> Vec<f64> {
    let size = rows.gradient.len();
    let hessian = condensed(rows, tiles, bridge);
    let is_held = |row: usize| !body.segments[row / 6].free[row % 6];
    let mut right: Vec<f64> = rows.gradient.iter().map(|g| -g).collect();
    for tile in tiles.iter().flatten() {
        for a in &tile.couplings {
            for (column, x) in a.columns.iter().zip(&tile.solved) {
                (0..6).for_each(|i| right[6 * a.segment + i] += column[i] * x);
            }
        }
    }
    (0..size).for_each(|i| right[i] += bridge.right(i));
    (0..size).filter(|i| is_held(*i)).for_each(|i| right[i] = 0.0);
    let right = right;
    let mut shift = SPIN;
    while shift < 1e12 {
        let mut band = Band::new(size, size);
        for i in 0..size {
            for j in 0..i {
                band.add(j, i, if is_held(i) || is_held(j) { 0.0 } else { hessian[i * size + j] });
            }
            band.add(i, i, shift + if is_held(i) { 1.0 } else { hessian[i * size + i] });
        }
        if let Some(factor) = band.factor() {
            let mut step = right.clone();
            factor.solve(&mut step);
            if step.iter().all(|x| x.abs() <= LONGEST) {
                return step;
            }
        }
        shift *= 10.0;
    }
    vec![0.0; size]
}
