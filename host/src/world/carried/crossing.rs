//! Warnings of two parts whose facets run through one another at the end of a run: edges of facets touch nothing, so
//! that parts without nodes on each other's facets sink into one another (a cube on an equal one that is turned).
//!
//! In: positions of nodes and frames as placed last. Out: one warning per pair, with a place. An edge counts that has
//! both ends clear of a facet's plane and meets it clear of its sides; small overlaps at contacts do not.

use super::CarriedWorld;
use crate::world::rounding::wide;
use smartbed_runtime::real::Scalar;
use smartbed_runtime::surface::{Frame, Shape};
use smartbed_runtime::vec3::{Vec3, axpy, cross, dot, norm, scale, sub};
use smartbed_runtime::world::Thing;
use std::collections::BTreeSet;

/// What is clear of a facet's plane or side: this share of the facet's size.
const CLEAR: f64 = 0.1;

/// Faces of a box over its corners, of which bit i is the side along axis i.
const FACES: [[usize; 4]; 6] =
    [[0, 2, 6, 4], [1, 5, 7, 3], [0, 4, 5, 1], [2, 3, 7, 6], [0, 1, 3, 2], [4, 6, 7, 5]];

/// Corners (m) and facets of a part.
struct Hull {
    points: Vec<Vec3<f64>>,
    facets: Vec<[usize; 4]>,
}

impl<S: Scalar> CarriedWorld<S> {
    /// One warning for each pair of a mesh and a mesh or a box that run through one another.
    pub(super) fn parts_through_parts(&self) -> Vec<String> {
        let Some(touching) = &self.touching else { return Vec::new() };
        let mut said = Vec::new();
        for (pair, parts) in touching.pairs.iter().zip(&touching.parts) {
            let things = pair.things.map(|thing| &touching.things[thing]);
            if !things.iter().any(|thing| matches!(thing, Thing::Mesh { .. })) {
                continue;
            }
            let [Some(one), Some(other)] = things.map(|thing| self.hull(thing)) else { continue };
            let place = one.edge_through(&other).or_else(|| other.edge_through(&one));
            if let Some([x, y, z]) = place {
                let [one, other] = parts.map(|part| &self.names[part]);
                said.push(format!(
                    "`{one}` and `{other}` run through one another at the end, near ({x:.4}, {y:.4}, {z:.4}) m: edges of facets \
                     touch nothing; take smaller facets"
                ));
            }
        }
        said
    }

    fn hull(&self, thing: &Thing<S>) -> Option<Hull> {
        match thing {
            Thing::Mesh { nodes: [first, end], facets: [low, high], .. } => Some(Hull {
                points: self.room.pos[*first..*end].iter().map(|x| wide(*x)).collect(),
                facets: self.fixed.facets[*low..*high].iter().map(|f| f.map(|node| node - first)).collect(),
            }),
            Thing::Rigid { shape, port, place } => {
                let Shape::Cuboid(cuboid) = shape else { return None };
                let carrier = port.map_or(Frame::inertial(), |port| self.room.frames[port]);
                let frame = place.in_frame(&carrier);
                let corner = |k: usize| {
                    let place =
                        std::array::from_fn(
                            |i| if k >> i & 1 == 1 { cuboid.half[i] } else { -cuboid.half[i] },
                        );
                    wide(frame.point(place))
                };
                Some(Hull { points: (0..8).map(corner).collect(), facets: FACES.into() })
            }
        }
    }
}

impl Hull {
    /// A place where one of the edges meets a facet of another hull.
    fn edge_through(&self, other: &Hull) -> Option<Vec3<f64>> {
        let sides = |f: &[usize; 4]| (0..4).map(|k| [f[k], f[(k + 1) % 4]]).collect::<Vec<_>>();
        let edges: BTreeSet<[usize; 2]> = self
            .facets
            .iter()
            .flat_map(sides)
            .filter(|[a, b]| a != b)
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        let halves = |f: &[usize; 4]| [[f[0], f[1], f[2]], [f[0], f[2], f[3]]];
        let triangles: Vec<[Vec3<f64>; 3]> =
            other.facets.iter().flat_map(halves).map(|corners| corners.map(|k| other.points[k])).collect();
        let bound = |i: usize, pick: fn(f64, f64) -> f64, start: f64| {
            other.points.iter().map(|x| x[i]).fold(start, pick)
        };
        let low: [f64; 3] = std::array::from_fn(|i| bound(i, f64::min, f64::INFINITY));
        let high: [f64; 3] = std::array::from_fn(|i| bound(i, f64::max, f64::NEG_INFINITY));
        let near =
            |[p, q]: &[Vec3<f64>; 2]| (0..3).all(|i| p[i].min(q[i]) <= high[i] && p[i].max(q[i]) >= low[i]);
        let mut ends = edges.iter().map(|edge| edge.map(|k| self.points[k])).filter(near);
        ends.find_map(|ends| triangles.iter().find_map(|corners| meets(ends, corners)))
    }
}

/// Where the edge from p to q meets a triangle, if it does so clearly.
fn meets([p, q]: [Vec3<f64>; 2], corners: &[Vec3<f64>; 3]) -> Option<Vec3<f64>> {
    let [a, b, c] = *corners;
    let normal = cross(sub(b, a), sub(c, a));
    let size = norm(normal).sqrt();
    if size <= 0.0 {
        return None;
    }
    let (unit, clear) = (scale(normal, 1.0 / (size * size)), CLEAR * size);
    let [from, to] = [p, q].map(|x| dot(sub(x, a), unit));
    if from * to >= 0.0 || from.abs().min(to.abs()) < clear {
        return None;
    }
    let x = axpy(p, from / (from - to), sub(q, p));
    // Half of a facet has one side within the facet; it is kept clear of too, which misses a little.
    let within = [[a, b], [b, c], [c, a]].iter().all(|[low, high]| {
        let side = sub(*high, *low);
        dot(cross(side, sub(x, *low)), unit) >= clear * norm(side)
    });
    within.then_some(x)
}
