//! Warnings of pairs in which a rigid part and a mesh can pass one another: a bar between the nodes, since edges of
//! facets do not touch; nodes in the plane of a box's side, which rounding puts over its face or beside it.

use super::CarriedWorld;
use super::methods::Contacts;
use crate::world::rounding::{wide, wide_shape};
use smartbed_runtime::real::Scalar;
use smartbed_runtime::surface::{Cuboid, Frame, Shape};
use smartbed_runtime::vec3::{self, Vec3};
use smartbed_runtime::world::Thing;

/// A node nearer than this share of a box's size to the plane of its side is neither over the face nor beside it.
const RIM: f64 = 1e-9;

impl<S: Scalar> CarriedWorld<S> {
    /// One warning for each pair of a bar that is longer than a mesh, so that its ends need not be over facets, and
    /// no wider than a facet, so that it need not be over a node; with a force law, which acts at nodes only, of any
    /// shape that is no wider than a facet.
    pub(super) fn bars_between_nodes(&self) -> Vec<String> {
        let Some(touching) = &self.touching else { return Vec::new() };
        let mut said = Vec::new();
        for (pair, parts) in touching.pairs.iter().zip(&touching.parts) {
            for [one, other] in [[0, 1], [1, 0]] {
                let things = [one, other].map(|k| &touching.things[pair.things[k]]);
                let [Thing::Rigid { shape, .. }, Thing::Mesh { facets: [first, end], .. }] = things else {
                    continue;
                };
                let (Some([length, width]), [span, facet]) =
                    (bar(&wide_shape(shape)), self.sizes(*first..*end))
                else {
                    continue;
                };
                if (length > span || pair.force.is_some()) && width <= facet * (1.0 + RIM) {
                    let [bar, mesh] = [one, other].map(|k| &self.names[parts[k]]);
                    said.push(match pair.force {
                        Some(_) => format!(
                            "`{bar}` is no wider than the facets of `{mesh}`, and a force law acts at nodes only: between them it falls \
                             through; take smaller facets, or a law of impact"
                        ),
                        None => format!(
                            "`{bar}` is longer than `{mesh}` and no wider than its facets; a bar touches facets with its ends and \
                             corners only, and nodes: between nodes it falls through; take smaller facets"
                        ),
                    });
                }
            }
        }
        said
    }

    /// One warning for each pair of a mesh that has nodes over the rim of a face of a box now, where touches are
    /// located.
    pub(super) fn nodes_over_rims(&self) -> Vec<String> {
        let Some(touching) = self.touching.as_ref().filter(|_| matches!(self.contacts, Contacts::Located))
        else {
            return Vec::new();
        };
        let mut said = Vec::new();
        for (pair, parts) in touching.pairs.iter().zip(&touching.parts) {
            for [one, other] in [[0, 1], [1, 0]].into_iter().filter(|_| pair.force.is_none()) {
                let things = [one, other].map(|k| &touching.things[pair.things[k]]);
                let [Thing::Rigid { shape, port, place }, Thing::Mesh { nodes: [first, end], .. }] = things
                else {
                    continue;
                };
                let Shape::Cuboid(cuboid) = wide_shape(shape) else { continue };
                let base = port.map_or(Frame::inertial(), |port| self.room.frames[port]);
                let (origin, axes) =
                    (base.point(place.origin), place.axes.map(|axis| base.to_inertial(axis)));
                let local = |x: Vec3<S>| axes.map(|axis| vec3::dot(axis, vec3::sub(x, origin)).to_f64());
                let over = |x: &Vec3<S>| is_over_rim(&cuboid, local(*x));
                if self.room.pos[*first..*end].iter().any(over) {
                    let [block, mesh] = [one, other].map(|k| &self.names[parts[k]]);
                    said.push(format!(
                        "nodes of `{mesh}` lie in the plane of a side of `{block}`, over the rim of its face: rounding decides whether they \
                         are over it or fall past it; shift one part by 1e-6 of its size, take another size, or impact = \"moreau\""
                    ));
                }
            }
        }
        said
    }

    /// Of some facets: the second largest extent along the axes, the longest edge (m).
    fn sizes(&self, facets: std::ops::Range<usize>) -> [f64; 2] {
        let (mut low, mut high, mut edge) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3], 0.0_f64);
        for facet in &self.fixed.facets[facets] {
            let corners = facet.map(|node| wide(self.room.pos[node]));
            for (k, x) in corners.iter().enumerate() {
                edge = edge.max(vec3::norm(vec3::sub(*x, corners[(k + 1) % 4])));
                for i in 0..3 {
                    (low[i], high[i]) = (low[i].min(x[i]), high[i].max(x[i]));
                }
            }
        }
        let mut extents: [f64; 3] = std::array::from_fn(|i| high[i] - low[i]);
        extents.sort_by(f64::total_cmp);
        [extents[1], edge]
    }
}

/// Whether a place is outside a box over a face, and in the plane of a side of that face.
fn is_over_rim(cuboid: &Cuboid<f64>, place: [f64; 3]) -> bool {
    let rim = RIM * cuboid.half.iter().fold(0.0, |most: f64, half| most.max(*half));
    let beyond: [f64; 3] = std::array::from_fn(|i| place[i].abs() - cuboid.half[i]);
    let over = |i: usize| {
        let others = || (0..3).filter(move |j| *j != i).map(|j| beyond[j]);
        beyond[i] >= -rim && others().all(|x| x <= rim) && others().any(|x| x >= -rim)
    };
    (0..3).any(over)
}

/// Length of a shape along its longest straight edge or side, and its width across (m); None for one without an end.
fn bar(shape: &Shape<f64>) -> Option<[f64; 2]> {
    match shape {
        Shape::Capsule(capsule) => Some([2.0 * capsule.half_length, 2.0 * capsule.radius]),
        Shape::Cuboid(cuboid) => {
            let mut edges = cuboid.half.map(|half| 2.0 * half);
            edges.sort_by(f64::total_cmp);
            Some([edges[2], edges[1]])
        }
        Shape::Sphere(ball) => Some([2.0 * ball.radius; 2]),
        Shape::HalfSpace => None,
    }
}
