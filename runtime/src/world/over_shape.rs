//! Nodes of a mesh over rigid shapes: the gap, over a face that the normals of the node's own facets point to.
//!
//! In: a node, its facets, a shape. Out: gap, place and axes of their contact.
//!
//! The shape's surface point nearest to a node gives the normal of a round shape or a plane. A box has edges: a node
//! that is flush with its lower face and just ahead of its side is nearest to the side, which would stop a box that
//! slides over a floor of facets (an internal edge). So the direction from the node to a box must lie in the cone of
//! the normals of the node's facets,
//! ```text
//! w = sum l_j n_j,  l_j >= 0
//! ```
//! or behind all of them (a sheet is touched from both sides); at a rim it must not point into the mesh. Otherwise the
//! face counts by which a line along a facet's normal enters the box, the nearest of them: gap and normal are those of
//! its plane, but a node outside the box is no nearer to it than to its surface, however near to that plane. A box that
//! no such line meets does not touch the node.

use super::detect::Meeting;
use super::scenery::{Mesh, Scenery, Standing};
use crate::real::Scalar;
use crate::rigid::contact::Contact;
use crate::surface::{Cuboid, Feature, Shape};
use crate::vec3::{self, Vec3};

/// Most facets of a node that are looked at.
const FACETS: usize = 12;
/// Cosine of the angle between a node's mean normal and a face below which the directions of its facets decide.
const FLUSH: f64 = 0.85;
/// Sweeps that resolve a direction along the normals of a cone.
const SWEEPS: usize = 64;

/// The facets around a node: unit normals, and in-plane directions out of the mesh at the edges of its rim.
struct Around<S> {
    normals: [Vec3<S>; FACETS],
    count: usize,
    rim: [Vec3<S>; 2],
    edges: usize,
}

impl<S: Scalar> Around<S> {
    /// Whether a contact may act on the node along this unit vector, from the node to what touches it.
    fn allows(&self, way: Vec3<S>) -> bool {
        let rounding = S::EPSILON.sqrt();
        let on_rim = self.edges > 0;
        if on_rim && self.rim.iter().take(self.edges).all(|out| vec3::dot(*out, way) >= -rounding) {
            return true;
        }
        let behind = self.normals.iter().take(self.count).all(|n| vec3::dot(*n, way) < -rounding);
        self.contains(if behind { vec3::scale(way, -S::ONE) } else { way }, rounding)
    }

    /// Whether a unit vector is a sum of the normals with no negative share: what is left of it after least squares
    /// (Hildreth 1957) is rounding.
    fn contains(&self, way: Vec3<S>, rounding: S) -> bool {
        let (mut shares, mut left) = ([S::ZERO; FACETS], way);
        for _ in 0..SWEEPS {
            for (share, normal) in shares.iter_mut().zip(&self.normals).take(self.count) {
                let new = (*share + vec3::dot(left, *normal)).max(S::ZERO);
                left = vec3::axpy(left, *share - new, *normal);
                *share = new;
            }
            if vec3::norm(left) <= rounding {
                return true;
            }
        }
        false
    }
}

impl<S: Scalar> Scenery<'_, S> {
    /// The contact of a node with the surface of a shape, if the node's facets can have one there.
    pub(super) fn node_over_shape(
        &self,
        mesh: &Mesh<S>,
        node: usize,
        standing: &Standing<S>,
    ) -> Option<Meeting<S>> {
        let (x, near, (shape, port, frame)) =
            (vec3::at(self.pos, node), self.near_node(node, standing), standing);
        let (mut gap, mut normal) = (near.gap, frame.to_inertial(near.normal));
        let mut sharp = false;
        if let Shape::Cuboid(cuboid) = shape {
            sharp = near.feature != Feature::Face;
            let way = vec3::scale(normal, -S::ONE);
            let flush = vec3::dot(way, vec3::at(self.normals, node)).abs() > S::from_f64(FLUSH);
            if !(flush && near.feature == Feature::Face) {
                let around = self.around(mesh, node);
                if around.count > 0 && !around.allows(way) {
                    let (height, face) = self.over_a_face(&around, x, cuboid, standing)?;
                    (gap, normal) = (if near.gap > S::ZERO { height.max(near.gap) } else { height }, face);
                    sharp = false;
                }
            }
        }
        let sides = [self.side_of_node(node), self.side_of_port(*port, x)];
        Some(Meeting { sharp, ..Meeting::exact(gap, x, Contact::between(sides, normal)) })
    }

    /// Gap and normal of a node over that face of a box by which a line along a normal of the node's facets, to either
    /// side of them, enters it; the nearest of these faces.
    fn over_a_face(
        &self,
        around: &Around<S>,
        x: Vec3<S>,
        cuboid: &Cuboid<S>,
        (_, _, frame): &Standing<S>,
    ) -> Option<(S, Vec3<S>)> {
        let mut best: Option<(S, Vec3<S>)> = None;
        for normal in around.normals.iter().take(around.count) {
            for way in [*normal, vec3::scale(*normal, -S::ONE)] {
                let Some((gap, face)) = cuboid.entered(frame.place(x), frame.to_local(way)) else { continue };
                if best.is_none_or(|(least, _)| gap.abs() < least.abs()) {
                    best = Some((gap, frame.to_inertial(face)));
                }
            }
        }
        best
    }

    /// The facets around a node.
    fn around(&self, mesh: &Mesh<S>, node: usize) -> Around<S> {
        let mut around =
            Around { normals: [vec3::zero(); FACETS], count: 0, rim: [vec3::zero(); 2], edges: 0 };
        let mut own = [[usize::MAX; 4]; FACETS];
        let mut count = 0;
        for (place, facet) in own.iter_mut().zip(mesh.facets.iter().filter(|facet| facet.contains(&node))) {
            (*place, count) = (*facet, count + 1);
        }
        let own = own.get(..count).unwrap_or_default();
        for facet in own {
            let [p, q, r, s] = facet.map(|k| vec3::at(self.pos, k));
            let (normal, area) = vec3::direction(vec3::cross(vec3::sub(r, p), vec3::sub(s, q)));
            let Some(place) = around.normals.get_mut(around.count).filter(|_| area > S::ZERO) else {
                continue;
            };
            (*place, around.count) = (normal, around.count + 1);
            let [a, b, c, d] = *facet;
            // A triangle repeats its third corner.
            for [tail, head] in [[a, b], [b, c], [c, d], [d, a]] {
                let ends = tail != head && (tail == node || head == node);
                if !ends || own.iter().any(|other| has_edge(other, [head, tail])) {
                    continue;
                }
                let along = vec3::sub(vec3::at(self.pos, head), vec3::at(self.pos, tail));
                if let Some(out) = around.rim.get_mut(around.edges) {
                    (*out, around.edges) = (vec3::direction(vec3::cross(along, normal)).0, around.edges + 1);
                }
            }
        }
        around
    }
}

/// Whether a facet has this edge, from tail to head.
fn has_edge([a, b, c, d]: &[usize; 4], edge: [usize; 2]) -> bool {
    [[*a, *b], [*b, *c], [*c, *d], [*d, *a]].contains(&edge)
}
