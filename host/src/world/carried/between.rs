//! Warnings of pairs in which a long rigid part can fall through between the nodes of a mesh: edges of facets do not
//! touch.

use super::CarriedWorld;
use crate::world::rounding::{wide, wide_shape};
use smartbed_runtime::real::Scalar;
use smartbed_runtime::surface::Shape;
use smartbed_runtime::vec3;
use smartbed_runtime::world::Thing;

impl<S: Scalar> CarriedWorld<S> {
    /// One warning for each pair of a bar that is longer than a mesh, so that its ends need not be over facets, and
    /// narrower than a facet, so that it need not be over a node.
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
                if length > span && width < facet {
                    let [bar, mesh] = [one, other].map(|k| &self.names[parts[k]]);
                    said.push(format!(
                        "`{bar}` is longer than `{mesh}` and narrower than its facets; a bar touches facets with its ends and \
                         corners only, and nodes: between nodes it falls through; take smaller facets"
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

/// Length of a shape's longest straight edge or side, and its width across (m); None for a shape without one.
fn bar(shape: &Shape<f64>) -> Option<[f64; 2]> {
    match shape {
        Shape::Capsule(capsule) => Some([2.0 * capsule.half_length, 2.0 * capsule.radius]),
        Shape::Cuboid(cuboid) => {
            let mut edges = cuboid.half.map(|half| 2.0 * half);
            edges.sort_by(f64::total_cmp);
            Some([edges[2], edges[1]])
        }
        Shape::HalfSpace | Shape::Sphere(_) => None,
    }
}
