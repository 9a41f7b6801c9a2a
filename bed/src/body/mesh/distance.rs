//! Exact signed distance of points from a closed surface of triangles.
//!
//! In: a mesh. Out: the distance to the nearest point, found in its tree of boxes, negative inside. The sign is that of
//! the pseudonormal there: a face's normal, the sum of two on an edge, the angle-weighted sum at a corner (Baerentzen
//! and Aanaes 2005).

use super::tree::Tree;
use super::triangles::{Mesh, doubled_area};
use smartbed_runtime::vec3::{Vec3, add, axpy, dot, norm, scale, sub};
use std::collections::BTreeMap;

/// A tree of boxes over the triangles of a mesh, and its pseudonormals.
#[derive(Clone, Debug, PartialEq)]
pub struct Distance {
    tree: Tree,
    faces: Vec<Vec3<f64>>,
    edges: BTreeMap<[usize; 2], Vec3<f64>>,
    corners: Vec<Vec3<f64>>,
}

/// The part of a triangle on which the nearest point lies.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Part {
    Face,
    /// The edge from this corner to the next one.
    Edge(usize),
    Corner(usize),
}

impl Distance {
    /// The tree of a closed mesh.
    #[must_use]
    pub(super) fn new(mesh: &Mesh) -> Distance {
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
        Distance { tree: Tree::new(mesh), faces, edges, corners }
    }

    /// Signed distance of a point (m), negative inside; the point must be no farther than `most` from the surface.
    #[must_use]
    pub(super) fn within(&self, mesh: &Mesh, point: Vec3<f64>, most: f64) -> f64 {
        let mut best = Nearest { square: most * most * (1.0 + 1e-9), ..Nearest::default() };
        let mut waiting = vec![0];
        while let Some(index) = waiting.pop() {
            let square = |node: usize| self.tree.nodes[node].square(point);
            if square(index) >= best.square {
                continue;
            }
            if let Some([one, other]) = self.tree.halves(index) {
                waiting.extend(if square(one) < square(other) { [other, one] } else { [one, other] });
                continue;
            }
            for triangle in self.tree.triangles(index) {
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

/// The nearest point of a triangle (Ericson, Real-Time Collision Detection, 5.1.5).
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
