//! Contact between sheets of neighbouring tiles: a node of one presses on a facet of the other.
//!
//! In: a bed's pairs of neighbours and a state. Out: nodes near facets, each with the shares w_i of the facet's corners
//! in the foot, and the normal n there (the runtime's facets, whose normals are continuous across edges). A depth d = n
//! . (sum w_i b_i - x) > 0 stores k d^2/2; w and n are constant within a pass and renewed together with the friction
//! limits. Forces at node and foot are equal and opposite along one line. Friction between sheets is in `rub`.

use super::bed::{ALONG, Bed};
use super::rub::{Ends, Rub, span};
use super::state::State;
use smartbed_runtime::surface::facet::{Facet, vertex_normals};
use smartbed_runtime::vec3::{Vec3, axpy, dot, norm, scale, sub, tangential};
use std::collections::BTreeMap;

/// Contact stiffness: pressure per depth (Pa/m) of one sheet in another. 5 kPa of air gives a depth of a tenth of a
/// millimetre.
const SHEET: f64 = 5e7;
/// Nodes up to this distance (m) outside a facet are tracked within a pass.
const OUTSIDE: f64 = 0.002;
/// Distance (m) that sheets near each other may move before their contacts are found anew.
pub const FOLLOWED: f64 = 0.5 * OUTSIDE;
/// Largest depth (m) of a node in a neighbour.
const INSIDE: f64 = 0.04;

/// A node near a facet of a neighbouring sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meeting {
    /// The ends of its distance vector D, from the node to its foot.
    pub ends: Ends,
    /// Outward normal of the facet, in the bed's frame.
    pub normal: Vec3<f64>,
    /// Stiffness (N/m).
    pub stiffness: f64,
}

impl Meeting {
    /// Depth (m); negative if they are apart.
    #[must_use]
    pub fn depth(&self, bed: &Bed, sheets: &[Vec<Vec3<f64>>]) -> f64 {
        dot(self.normal, span(&self.ends, bed, sheets))
    }

    /// Repulsive force (N).
    #[must_use]
    pub fn force(&self, bed: &Bed, sheets: &[Vec<Vec3<f64>>]) -> f64 {
        self.stiffness * self.depth(bed, sheets).max(0.0)
    }

    /// Energy (J).
    #[must_use]
    pub fn energy(&self, bed: &Bed, sheets: &[Vec<Vec3<f64>>]) -> f64 {
        0.5 * self.stiffness * self.depth(bed, sheets).max(0.0).powi(2)
    }

    /// Does the tile take part in the contact?
    #[must_use]
    pub fn is_of(&self, tile: usize) -> bool {
        self.ends.iter().any(|end| end.0 == tile)
    }
}

/// A sheet in the bed's frame.
struct Laid {
    places: Vec<Vec3<f64>>,
    low: Vec3<f64>,
    high: Vec3<f64>,
}

impl Laid {
    fn new(bed: &Bed, state: &State, tile: usize) -> Laid {
        let pose = &bed.tiles[tile].pose;
        let places: Vec<Vec3<f64>> = state.sheets[tile].iter().map(|x| pose.outwards(*x)).collect();
        let bound = |start: f64, pick: fn(f64, f64) -> f64| {
            places.iter().fold([start; 3], |b, x| [0, 1, 2].map(|k| pick(b[k], x[k])))
        };
        let (low, high) = (bound(f64::INFINITY, f64::min), bound(f64::NEG_INFINITY, f64::max));
        Laid { places, low, high }
    }

    /// Is a point within its bounding box, extended by a margin?
    fn holds(&self, x: Vec3<f64>) -> bool {
        (0..3).all(|k| self.low[k] - OUTSIDE <= x[k] && x[k] <= self.high[k] + OUTSIDE)
    }

    fn reaches(&self, other: &Laid) -> bool {
        (0..3).all(|k| self.low[k] - OUTSIDE <= other.high[k] && other.low[k] - OUTSIDE <= self.high[k])
    }
}

/// All sheets in the bed's frame, for beds with neighbours.
fn lay(bed: &Bed, state: &State) -> Vec<Laid> {
    if bed.beside.is_empty() {
        return Vec::new();
    }
    (0..bed.tiles.len()).map(|tile| Laid::new(bed, state, tile)).collect()
}

/// Do bounding boxes of neighbouring sheets come so near that these may touch?
pub fn is_near(bed: &Bed, state: &State) -> bool {
    let laid = lay(bed, state);
    bed.beside.iter().any(|[a, b]| laid[*a].reaches(&laid[*b]))
}

/// All nodes near facets of neighbouring sheets.
#[must_use]
pub fn meetings(bed: &Bed, state: &State) -> Vec<Meeting> {
    let mut all = Vec::new();
    let laid = lay(bed, state);
    for [a, b] in &bed.beside {
        if laid[*a].reaches(&laid[*b]) {
            add(bed, [*a, *b], [&laid[*a], &laid[*b]], &mut all);
            add(bed, [*b, *a], [&laid[*b], &laid[*a]], &mut all);
        }
    }
    all
}

/// Adds the nodes of the first sheet that are near facets of the second, each with its nearest facet.
fn add(bed: &Bed, [a, b]: [usize; 2], [nodes, sheet]: [&Laid; 2], all: &mut Vec<Meeting>) {
    let near: Vec<usize> = (0..nodes.places.len())
        .filter(|n| bed.lattice.free(*n).is_some() && sheet.holds(nodes.places[*n]))
        .collect();
    let facets: Vec<[usize; 4]> = bed.lattice.facets().collect();
    let mut normals = vec![[0.0; 3]; sheet.places.len()];
    if !near.is_empty() {
        vertex_normals(&facets, &sheet.places, 0..sheet.places.len(), &mut normals);
    }
    let [wide, long] = bed.lattice.size;
    let [nx, ny] = bed.lattice.intervals;
    let reach = INSIDE + (wide / nx as f64).hypot(long / ny as f64);
    let is_above = |x: Vec3<f64>| bed.tiles[b].pose.inwards(x)[2] > 0.0;
    for node in near.into_iter().filter(|n| is_above(nodes.places[*n])) {
        let x = nodes.places[node];
        let mut best: Option<(f64, Meeting)> = None;
        for corners in facets.iter().filter(|f| norm(sub(sheet.places[f[0]], x)) < 2.0 * reach) {
            let facet =
                Facet { corners: corners.map(|c| sheet.places[c]), normals: corners.map(|c| normals[c]) };
            let Some(found) = facet.nearest(x, 1e-9) else { continue };
            let is_near = (-INSIDE..OUTSIDE).contains(&found.gap) && is_above(found.foot);
            if is_near && best.as_ref().is_none_or(|(gap, _)| found.gap.abs() < gap.abs()) {
                let corner = |k: usize| (b, corners[k], found.weights[k]);
                let ends = [corner(0), corner(1), corner(2), corner(3), (a, node, -1.0)];
                // Nodes of both sheets press on facets of the other: each carries half.
                let stiffness = 0.5 * SHEET * bed.lattice.cell();
                best = Some((found.gap, Meeting { ends, normal: found.normal, stiffness }));
            }
        }
        all.extend(best.map(|(_, meeting)| meeting));
    }
}

/// Contact forces (N) by node, in the bed's frame.
fn pushes(bed: &Bed, state: &State, meetings: &[Meeting]) -> BTreeMap<(usize, usize), Vec3<f64>> {
    let mut all = BTreeMap::new();
    for meeting in meetings {
        let force = meeting.force(bed, &state.sheets);
        for (tile, node, share) in meeting.ends.into_iter().filter(|_| force > 0.0) {
            let sum = all.entry((tile, node)).or_insert([0.0; 3]);
            *sum = axpy(*sum, -share * force, meeting.normal);
        }
    }
    all
}

/// Largest change of the force on a node (N) from the contacts of one pass to those of the next.
pub fn change(bed: &Bed, state: &State, [old, new]: [&[Meeting]; 2]) -> f64 {
    let [old, new] = [old, new].map(|meetings| pushes(bed, state, meetings));
    let of = |all: &BTreeMap<_, Vec3<f64>>, key| all.get(key).copied().unwrap_or_default();
    let keys = old.keys().chain(new.keys());
    keys.map(|key| norm(sub(of(&old, key), of(&new, key)))).fold(0.0, f64::max)
}

/// Identifies a contact: the node, and the neighbour whose sheet it touches.
fn key(ends: &Ends) -> (usize, usize, usize) {
    (ends[4].0, ends[4].1, ends[0].0)
}

/// Rubs with present normals and limits, and the largest change of a limit (N).
pub fn renewed(bed: &Bed, state: &State, met: &[Meeting]) -> (Vec<Rub>, f64) {
    let mut most = 0.0_f64;
    let renew = |rub: &Rub| {
        let now = met.iter().find(|m| key(&m.ends) == key(&rub.ends));
        let limit = now.map_or(0.0, |m| bed.rubbing * m.force(bed, &state.sheets));
        most = most.max((limit - rub.limit).abs());
        Rub { limit, normal: now.map_or(rub.normal, |m| m.normal), ..*rub }
    };
    let rubs = state.rubs.iter().map(renew).collect();
    (rubs, most)
}

/// The friction that may act from this state on, including the force that it holds already.
pub fn anchored(bed: &Bed, state: &State, met: &[Meeting]) -> Vec<Rub> {
    let sheets = &state.sheets;
    let one = |meeting: &Meeting| {
        let limit = bed.rubbing * meeting.force(bed, sheets);
        let old = state.rubs.iter().find(|rub| key(&rub.ends) == key(&meeting.ends));
        let held = old.map_or([0.0; 3], |rub| tangential(rub.drag(bed, sheets), meeting.normal));
        let size = norm(held);
        let force = if size > limit { scale(held, limit / size) } else { held };
        let (ends, normal) = (meeting.ends, meeting.normal);
        let before = span(&ends, bed, sheets);
        (limit > 0.0).then_some(Rub {
            ends,
            before,
            force,
            normal,
            limit,
            stiffness: ALONG * meeting.stiffness,
        })
    };
    met.iter().filter_map(one).collect()
}
