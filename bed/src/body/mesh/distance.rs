//! Exact distance of points from a closed surface of triangles, with its sign.
//!
//! In: a mesh. Out: the distance of the nearest point, found in a tree of boxes, below 0 inside. The sign is that of the
//! pseudonormal there: a face's normal, the sum of two on an edge, the sum by angles at a corner (Baerentzen and Aanaes 2005).

use super::triangles::{Mesh, doubled_area};
use smartbed_runtime::vec3::{Vec3, add, axpy, dot, norm, scale, sub};
use std::collections::BTreeMap;

/// Triangles of a leaf.
const LEAF: usize = 4;

/// A tree of boxes over the triangles of a mesh, and its pseudonormals.
#[derive(Clone, Debug, PartialEq)]
pub struct Distance {
    nodes: Vec<Node>,
    /// Triangles, leaf by leaf.
    order: Vec<usize>,
    faces: Vec<Vec3<f64>>,
    edges: BTreeMap<[usize; 2], Vec3<f64>>,
    corners: Vec<Vec3<f64>>,
}

/// A box with what stands in it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Node {
    low: Vec3<f64>,
    high: Vec3<f64>,
    /// Where its triangles stand in the order.
    first: usize,
    count: usize,
    /// Its first half follows it, its second half stands here; 0 for a leaf.
    second: usize,
}

/// On which part of a triangle a point is nearest.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Part {
    Face,
    /// From this corner to the next.
    Edge(usize),
    Corner(usize),
}

impl Distance {
    /// The tree of a closed mesh.
    #[must_use]
    pub(super) fn new(mesh: &Mesh) -> Distance {
        let mut order: Vec<usize> = (0..mesh.triangles.len()).collect();
        let mut nodes = Vec::new();
        grow(mesh, &mut order, 0, &mut nodes);
        let unit = |v: Vec3<f64>| scale(v, 1.0 / norm(v));
        let faces: Vec<Vec3<f64>> =
            (0..mesh.triangles.len()).map(|t| unit(doubled_area(mesh.places(t)))).collect();
        let mut edges: BTreeMap<[usize; 2], Vec3<f64>> = BTreeMap::new();
        let mut corners = vec![[0.0; 3]; mesh.corners.len()];
        for (triangle, normal) in mesh.triangles.iter().zip(&faces) {
            for k in 0..3 {
                let [own, next, last] = [0, 1, 2].map(|n| triangle[(k + n) % 3]);
                let edge = edges.entry([own.min(next), own.max(next)]).or_default();
                *edge = add(*edge, *normal);
                let [a, b] = [next, last].map(|n| unit(sub(mesh.corners[n], mesh.corners[own])));
                let angle = dot(a, b).clamp(-1.0, 1.0).acos();
                corners[own] = axpy(corners[own], angle, *normal);
            }
        }
        Distance { nodes, order, faces, edges, corners }
    }

    /// Distance of a point that is known to be no further than `most` from the surface (m), below 0 inside.
    #[must_use]
    pub(super) fn within(&self, mesh: &Mesh, point: Vec3<f64>, most: f64) -> f64 {
        let mut best = Nearest { square: most * most * (1.0 + 1e-9), ..Nearest::default() };
        let mut waiting = vec![0];
        while let Some(index) = waiting.pop() {
            let node = &self.nodes[index];
            if node.square(point) >= best.square {
                continue;
            }
            if node.second > 0 {
                let [one, other] = [index + 1, node.second];
                let is_one_nearer = self.nodes[one].square(point) < self.nodes[other].square(point);
                waiting.extend(if is_one_nearer { [other, one] } else { [one, other] });
                continue;
            }
            for triangle in &self.order[node.first..node.first + node.count] {
                let (place, part) = nearest(mesh.places(*triangle), point);
                let away = sub(point, place);
                if dot(away, away) < best.square {
                    best = Nearest { square: dot(away, away), away, triangle: *triangle, part };
                }
            }
        }
        let corners = mesh.triangles[best.triangle];
        let normal = match best.part {
            Part::Face => self.faces[best.triangle],
            Part::Edge(k) => {
                let [a, b] = [corners[k], corners[(k + 1) % 3]];
                self.edges[&[a.min(b), a.max(b)]]
            }
            Part::Corner(k) => self.corners[corners[k]],
        };
        best.square.sqrt().copysign(dot(best.away, normal))
    }
}

/// The nearest point so far.
#[derive(Clone, Copy, Debug)]
struct Nearest {
    square: f64,
    away: Vec3<f64>,
    triangle: usize,
    part: Part,
}

impl Default for Nearest {
    fn default() -> Nearest {
        Nearest { square: f64::INFINITY, away: [0.0; 3], triangle: 0, part: Part::Face }
    }
}

impl Node {
    /// Squared distance of a point from the box.
    fn square(&self, point: Vec3<f64>) -> f64 {
        let beyond = [0, 1, 2].map(|k| point[k] - point[k].clamp(self.low[k], self.high[k]));
        dot(beyond, beyond)
    }
}

/// Adds the tree of these triangles, halved along the longest side of their middles' box.
fn grow(mesh: &Mesh, order: &mut [usize], first: usize, nodes: &mut Vec<Node>) {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    let (mut least, mut most) = (low, high);
    let middle = |triangle: usize, k: usize| mesh.places(triangle).iter().map(|p| p[k]).sum::<f64>();
    for triangle in order.iter() {
        for k in 0..3 {
            for place in mesh.places(*triangle) {
                (low[k], high[k]) = (low[k].min(place[k]), high[k].max(place[k]));
            }
            let own = middle(*triangle, k);
            (least[k], most[k]) = (least[k].min(own), most[k].max(own));
        }
    }
    let index = nodes.len();
    nodes.push(Node { low, high, first, count: order.len(), second: 0 });
    if order.len() <= LEAF {
        return;
    }
    let side = |k: usize| most[k] - least[k];
    let axis = (1..3).fold(0, |best, k| if side(k) > side(best) { k } else { best });
    let half = order.len() / 2;
    order.select_nth_unstable_by(half, |a, b| middle(*a, axis).total_cmp(&middle(*b, axis)).then(a.cmp(b)));
    let (one, other) = order.split_at_mut(half);
    grow(mesh, one, first, nodes);
    nodes[index].second = nodes.len();
    grow(mesh, other, first + half, nodes);
}

/// The point of a triangle that is nearest (Ericson, Real-Time Collision Detection, 5.1.5).
fn nearest([a, b, c]: [Vec3<f64>; 3], p: Vec3<f64>) -> (Vec3<f64>, Part) {
    let (ab, ac) = (sub(b, a), sub(c, a));
    let along = |from: Vec3<f64>| [dot(ab, sub(p, from)), dot(ac, sub(p, from))];
    let ([d1, d2], [d3, d4], [d5, d6]) = (along(a), along(b), along(c));
    if d1 <= 0.0 && d2 <= 0.0 {
        return (a, Part::Corner(0));
    }
    if d3 >= 0.0 && d4 <= d3 {
        return (b, Part::Corner(1));
    }
    if d6 >= 0.0 && d5 <= d6 {
        return (c, Part::Corner(2));
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return (axpy(a, d1 / (d1 - d3), ab), Part::Edge(0));
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return (axpy(a, d2 / (d2 - d6), ac), Part::Edge(2));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        return (axpy(b, (d4 - d3) / ((d4 - d3) + (d5 - d6)), sub(c, b)), Part::Edge(1));
    }
    let whole = va + vb + vc;
    (axpy(axpy(a, vb / whole, ab), vc / whole, ac), Part::Face)
}
