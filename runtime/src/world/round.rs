//! Balls, and the round ends of capsules, over the facets of a mesh: at every place one contact.
//!
//! In: the centre of a ball, facets. Out: feet on facets and touching nodes, without those that say the same twice.
//!
//! With N_i the normals at a facet's corners and r_i the directions from the corners to the centre, the facet bends
//! with the ball where
//! ```text
//! sum over both diagonals of (N_a - N_c) . (r_a - r_c)  >  1/2 sum of |r_a - r_c|^2
//! ```
//! A node of a facet that bends lies on the ball, and chords to it are inside the ball: it carries, and a foot is left
//! out where it is near such a node or corners are nearer. At any other node the foot carries, and the node is left out
//! where the foot is nearer: the node's gap grows as d^2/(2 R) with the distance d from the foot, and its rate d v/R
//! would stop a rolling ball within d = 2 v h of it. Of a foot on a node, or on the edge of two facets, one contact is
//! kept. Nothing is left out unless what stands for it is a contact itself.

use super::detect::{Found, OF_SHAPE, POINTS, Touch};
use super::scenery::{Beyond, Mesh, Scenery, Standing, edge, shares};
use super::thing::Pair;
use crate::real::Scalar;
use crate::surface::facet::FacetNearest;
use crate::vec3::{self, Vec3};

/// A foot with more than this weight at one corner on the ball is left out in favour of the corner: two contacts there
/// could share one load in any proportion, and sweeps would converge slowly.
const AT_NODE: f64 = 0.75;
/// Least share of the ball's curvature that a facet has that bends with it.
const BENDS: f64 = 0.5;

impl<S: Scalar> Scenery<'_, S> {
    /// Adds the feet of the round point of this number of a shape, and removes nodes, which are listed from `first` on,
    /// for which a foot stands.
    pub(super) fn round_over_mesh(
        &self,
        pair: (usize, &Pair<S>),
        mesh: &Mesh<S>,
        shape: &Standing<S>,
        (number, point, radius): (u32, Vec3<S>, S),
        (first, found): (usize, &mut Found<S>),
    ) {
        let feet = found.count;
        let rounding: S = edge();
        for (facet, corners) in (0..).zip(mesh.facets) {
            let Some(near) = self.over_facet(mesh, corners, (point, radius), Beyond::Edges) else { continue };
            let same = rounding * (radius + vec3::norm(near.foot));
            // A foot on the edge between two facets is on both.
            let twice = |foot: &Touch<S>| vec3::norm(vec3::sub(foot.point, near.foot)) <= same;
            if found.from(feet).iter().any(twice) || self.left_to_corners(mesh, corners, &near, radius, shape)
            {
                continue;
            }
            found.push(
                pair,
                OF_SHAPE + POINTS * facet + number,
                self.shape_over_facet(shape, (corners, near)),
            );
        }
        found.leave_out([first, feet], |node, foot| {
            let facet = mesh.facets.get(((foot.id - OF_SHAPE) / POINTS) as usize);
            let (own, from_centre) =
                (mesh.nodes[0] + node.id as usize, vec3::norm(vec3::sub(node.point, point)));
            // A capsule's node may be nearest to its side or to the other end.
            let of_this_end = from_centre - radius <= node.gap + rounding * radius;
            node.id < OF_SHAPE
                && of_this_end
                && foot.gap <= node.gap
                && facet.is_some_and(|corners| corners.contains(&own))
                && !self.lies_on(mesh, own, shape)
        });
    }

    /// Whether a node lies on a round shape: one of its facets bends with the shape.
    fn lies_on(&self, mesh: &Mesh<S>, node: usize, shape: &Standing<S>) -> bool {
        mesh.facets.iter().any(|facet| facet.contains(&node) && self.bends(facet, shape))
    }

    /// Whether a facet bends with a round shape.
    fn bends(&self, facet: &[usize; 4], shape: &Standing<S>) -> bool {
        let normals = self.corner_normals(facet, &facet.map(|node| vec3::at(self.pos, node)));
        let ways =
            facet.map(|node| vec3::scale(shape.2.to_inertial(self.near_node(node, shape).normal), -S::ONE));
        let across = |[a, b, c, d]: [Vec3<S>; 4]| [vec3::sub(a, c), vec3::sub(b, d)];
        let (mut turned, mut round) = (S::ZERO, S::ZERO);
        for (normal, way) in across(normals).into_iter().zip(across(ways)) {
            (turned, round) = (turned + vec3::dot(normal, way), round + vec3::dot(way, way));
        }
        turned > S::from_f64(BENDS) * round
    }

    /// Whether the contacts of a facet's corners stand for a foot on it. Their gaps are averaged by the foot's weights.
    fn left_to_corners(
        &self,
        mesh: &Mesh<S>,
        facet: &[usize; 4],
        near: &FacetNearest<S>,
        radius: S,
        shape: &Standing<S>,
    ) -> bool {
        let (mut mean, mut nearest) = (S::ZERO, (S::ZERO, 0));
        for (node, weight) in shares(facet, near) {
            let gap = self.near_node(node, shape).gap;
            mean = mean + weight * gap.abs();
            if gap <= self.margin && mesh.has(node) && weight > nearest.0 {
                nearest = (weight, node);
            }
        }
        let (share, node) = nearest;
        let on_it = share > S::ONE - edge();
        let nearer = share > S::from_f64(AT_NODE) || mean < (near.gap - radius).abs();
        on_it || (nearer && share > S::ZERO && self.lies_on(mesh, node, shape))
    }
}
