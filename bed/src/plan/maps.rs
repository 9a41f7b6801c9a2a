//! Maps of an equilibrium, at sensels on the sheets' nodes and at points of the skin.
//!
//! In: a solution. Out: pressure and shear by site. A node is a sensel: its pressure is force over the area that the
//! sheet has there at that time. The skin is a grid of points on each segment, projected along the axis nearest to the
//! normal; the load on a point is interpolated between the nodes of the sheet below it.

use super::{Layout, Load};
use crate::body::mesh::Patch;
use crate::body::{Shape, Surface};
use crate::equilibrium::{Bed, Solution};
use crate::map::{Grid, Site};
use crate::pose::Pose;
use crate::sheet::membrane;
use smartbed_runtime::vec3::{Vec3, norm};

/// Distance of points of the skin (m).
const SKIN: f64 = 0.02;
/// A point of the skin farther than this (m) above a sheet is not in contact with it.
const NEAR: f64 = 0.03;

/// Pressure and shear at all sites.
#[derive(Clone, Debug, Default)]
pub struct Map {
    /// Pressure (Pa).
    pub pressure: Vec<f64>,
    /// Shear (Pa), along x and y.
    pub shear: Vec<[f64; 2]>,
}

/// The grid of all sensels of the bed.
pub fn grid(layout: &Layout) -> Grid {
    let [nx, ny] = layout.intervals;
    Grid {
        rows: layout.rows * ny,
        columns: layout.columns * nx,
        row_pitch: layout.pitch[1] / ny as f64,
        column_pitch: layout.pitch[0] / nx as f64,
    }
}

/// The sensel of a tile's node; nodes on the far rims belong to the next tile.
#[must_use]
pub fn sensel(layout: &Layout, tile: usize, node: usize) -> Option<usize> {
    let [nx, ny] = layout.intervals;
    let (i, j) = (node % (nx + 1), node / (nx + 1));
    let (row, column) = (tile / layout.columns, tile % layout.columns);
    let line = (layout.rows - 1 - row) * ny + j;
    (i < nx && j < ny).then_some(line * layout.columns * nx + column * nx + i)
}

/// The sites of all sensels, with the present areas of the stretched sheets.
pub fn sensels(layout: &Layout, bed: &Bed, solution: &Solution) -> Vec<Site> {
    let mut sites = grid(layout).all();
    for (tile, sheet) in solution.state.sheets.iter().enumerate() {
        let areas = membrane::areas(&bed.lattice, sheet);
        for (node, area) in areas.iter().enumerate().filter(|(node, _)| bed.lattice.free(*node).is_some()) {
            if let Some(site) = sensel(layout, tile, node) {
                sites[site].area = norm(*area);
            }
        }
    }
    sites
}

/// True readings of the sensels: forces over their own areas; shear along the bed's x and y.
pub fn felt(layout: &Layout, solution: &Solution, sites: &[Site]) -> Map {
    let count = sites.len();
    let mut map = Map { pressure: vec![0.0; count], shear: vec![[0.0; 2]; count] };
    for (tile, contacts) in solution.contacts.iter().enumerate() {
        for contact in contacts {
            if let Some(site) = sensel(layout, tile, contact.touch.node) {
                map.pressure[site] += contact.touch.force() / sites[site].area;
                (0..2).for_each(|k| map.shear[site][k] += contact.drag[k] / sites[site].area);
            }
        }
    }
    map
}

/// A point of the skin.
#[derive(Clone, Copy, Debug)]
pub struct SkinPoint {
    /// Index of its segment.
    pub segment: usize,
    /// Position in the segment's axes (m).
    pub place: Vec3<f64>,
    /// Outward normal in the segment's axes.
    pub normal: Vec3<f64>,
}

/// Points of a load's skin with their sites, except on the front of boxes.
#[must_use]
pub fn skin(load: &Load) -> (Vec<SkinPoint>, Vec<Site>) {
    let (mut points, mut sites) = (Vec::new(), Vec::new());
    for (segment, part) in load.body.segments.iter().enumerate() {
        let patches = match &part.shape {
            Surface::Round(shape) => round(shape),
            Surface::Mesh(solid) => solid.skin(SKIN),
        };
        for Patch { place, normal, area } in patches {
            let region = load.figure.as_ref().and_then(|f| f.region(segment, place, normal));
            points.push(SkinPoint { segment, place, normal });
            sites.push(Site { area, region });
        }
    }
    (points, sites)
}

/// Patches of a box with round edges, projected along each axis from both sides; the upward side, away from the bed, is
/// omitted.
fn round(shape: &Shape) -> Vec<Patch> {
    let Shape { half, radius } = *shape;
    let mut patches = Vec::new();
    for (axis, side) in [(0, -1.0), (0, 1.0), (1, -1.0), (1, 1.0), (2, -1.0)] {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let count = |k: usize| ((2.0 * (half[k] + radius)) / SKIN).ceil() as usize;
        let at = |n: usize, k: usize| (n as f64 + 0.5) * SKIN - 0.5 * count(k) as f64 * SKIN;
        for n in 0..count(u) * count(v) {
            let (a, b) = (at(n % count(u), u), at(n / count(u), v));
            let beyond = |x: f64, k: usize| x - x.clamp(-half[k], half[k]);
            let mut normal = [0.0; 3];
            (normal[u], normal[v]) = (beyond(a, u) / radius, beyond(b, v) / radius);
            let left = 1.0 - normal[u] * normal[u] - normal[v] * normal[v];
            normal[axis] = side * left.max(0.0).sqrt();
            if left <= 0.0 || normal[axis].abs() < normal[u].abs().max(normal[v].abs()) {
                continue;
            }
            let mut place = [0.0; 3];
            (place[u], place[v]) = (a, b);
            place[axis] = side * half[axis] + radius * normal[axis];
            patches.push(Patch { place, normal, area: SKIN * SKIN / normal[axis].abs() });
        }
    }
    patches
}

/// True readings of the points of the skin.
pub fn on_skin(bed: &Bed, solution: &Solution, points: &[SkinPoint]) -> Map {
    let fields: Vec<Vec<[f64; 3]>> = (0..bed.tiles.len()).map(|tile| field(bed, solution, tile)).collect();
    let one = |point: &SkinPoint| {
        let pose: &Pose = &solution.state.segments[point.segment];
        if pose.attitude.to_inertial(point.normal)[2] >= 0.0 {
            return [0.0; 3];
        }
        let place = pose.outwards(point.place);
        let hit = bed.tiles.iter().enumerate().find_map(|(tile, own)| {
            let [x, y, z] = own.pose.inwards(place);
            let [a, b] = bed.lattice.size;
            let (u, v) = (x / a + 0.5, y / b + 0.5);
            ((0.0..1.0).contains(&u) && (0.0..1.0).contains(&v)).then_some((tile, u, v, z))
        });
        let Some((tile, u, v, z)) = hit else { return [0.0; 3] };
        let height = between(bed, u, v, |node| [solution.state.sheets[tile][node][2], 0.0, 0.0])[0];
        if (z - bed.cover.thickness - height).abs() > NEAR {
            return [0.0; 3];
        }
        between(bed, u, v, |node| fields[tile][node])
    };
    let values: Vec<[f64; 3]> = points.iter().map(one).collect();
    Map {
        pressure: values.iter().map(|v| v[0].max(0.0)).collect(),
        shear: values.iter().map(|v| [v[1], v[2]]).collect(),
    }
}

/// Pressure and shear at each node of a tile.
fn field(bed: &Bed, solution: &Solution, tile: usize) -> Vec<[f64; 3]> {
    let mut field = vec![[0.0; 3]; bed.lattice.nodes()];
    for contact in &solution.contacts[tile] {
        let own = &mut field[contact.touch.node];
        own[0] += contact.pressure();
        own[1] += contact.drag[0] / contact.area;
        own[2] += contact.drag[1] / contact.area;
    }
    field
}

/// Bilinear interpolation between nodes, at fractions of the sheet's sides.
fn between(bed: &Bed, u: f64, v: f64, value: impl Fn(usize) -> [f64; 3]) -> [f64; 3] {
    let [nx, ny] = bed.lattice.intervals;
    let split = |x: f64, n: usize| {
        let at = x * n as f64;
        let whole = (at.floor().max(0.0) as usize).min(n - 1);
        (whole, at - whole as f64)
    };
    let ((i, s), (j, t)) = (split(u, nx), split(v, ny));
    let node = |di: usize, dj: usize| value((j + dj) * (nx + 1) + i + di);
    let corners = [node(0, 0), node(1, 0), node(0, 1), node(1, 1)];
    let weights = [(1.0 - s) * (1.0 - t), s * (1.0 - t), (1.0 - s) * t, s * t];
    [0, 1, 2].map(|k| corners.iter().zip(weights).map(|(c, w)| c[k] * w).sum())
}
