//! Points behind a facet that are outside the body for all that: nothing went in through the facet.
//!
//! In: a facet, a point deep below it, the other facets, how the point moves. Out: whether it is outside.
//! ```text
//! around a convex edge   it is in front of the facet beside
//! beyond the other side  it is nearer to another facet, in front of that one, or to its edge (a thin or squashed body)
//! around a free edge     carried back along its relative velocity, it meets the facet's plane where no facet is
//! ```
//! A step depends on the state alone, so what a point did before cannot be asked. Only points deeper than a step can
//! bring them are: what has just gone in is caught.

use super::detect::{OF_SHAPE, Touch};
use super::scenery::{Mesh, Scenery, edge};
use super::thing::Pair;
use crate::real::Scalar;
use crate::rigid::narrow::core_points;
use crate::vec3::{self, Vec3};

/// Least rate of closing, relative to the speed along the surface: at less, where a point came from is not known well.
const STEEP: f64 = 1e-3;
/// How near to a facet a point came through the surface, relative to its depth.
const NEAR: f64 = 0.1;
/// How near a point is to an edge, relative to its depth below a facet, if it is not inside by that facet.
const CLOSE: f64 = 0.5;
/// Depth that overlaps left by hard impacts may have, relative to that which the mesh allows.
const LEFT: f64 = 0.01;

impl<'a, S: Scalar> Scenery<'a, S> {
    /// Whether a point deep below a facet is in front of a facet beside that one, beyond their convex edge.
    pub(super) fn is_around_edge(&self, mesh: &Mesh<'a, S>, facet: &[usize; 4], point: Vec3<S>) -> bool {
        let middle = self.middle(facet);
        let shared = |other: &[usize; 4]| other.iter().filter(|node| facet.contains(node)).count();
        mesh.facets.iter().filter(|other| *other != facet && shared(other) >= 2).any(|other| {
            let [a, b, c, d] = other.map(|node| vec3::at(self.pos, node));
            let (normal, own) = (vec3::cross(vec3::sub(c, a), vec3::sub(d, b)), self.middle(other));
            let before = |place: Vec3<S>| vec3::dot(normal, vec3::sub(place, own));
            before(middle) < S::ZERO && before(point) > S::ZERO
        })
    }

    /// Whether the moving point of a contact below a facet is outside, given how far (m) a step of h (s) can bring it.
    pub(super) fn is_outside(&self, pairs: &[Pair<S>], touch: &Touch<S>, (h, way): (S, S)) -> bool {
        if touch.gap >= -way.max(touch.sagitta) {
            return false;
        }
        let Some((mesh, point)) = self.below(pairs, touch) else { return false };
        if touch.gap >= -(S::from_f64(LEFT) * mesh.depth) {
            return false;
        }
        let feet = |point: Vec3<S>, farthest: S| {
            let near = move |facet| Some(self.nearest_on(facet, point, farthest, edge())?.0);
            mesh.facets.iter().filter_map(near).filter(move |near| near.gap.abs() <= farthest)
        };
        let close = S::from_f64(CLOSE) * -touch.gap;
        let is_beside = || mesh.facets.iter().any(|facet| self.distance(facet, point) < close);
        feet(point, -touch.gap).any(|near| near.gap > S::ZERO) || is_beside() || {
            let [rate, x, y] = touch.start;
            let slide = (x * x + y * y).sqrt();
            let closes = -rate > (S::from_f64(STEEP) * slide).max(S::EPSILON.sqrt() * mesh.depth / h);
            let slip = touch.contact.to_inertial([S::ZERO, x, y]);
            let foot = vec3::axpy(point, -touch.gap, touch.contact.axes[0]);
            let came = vec3::axpy(foot, -(touch.gap / rate), slip);
            let near = touch.sagitta.max(S::from_f64(NEAR) * -touch.gap);
            closes && feet(came, near).next().is_none()
        }
    }

    /// The mesh whose facet is below a point of a contact, and that point; None for points of round shapes, which touch
    /// edges before they are below them, and where nodes are over a shape.
    fn below(&self, pairs: &[Pair<S>], touch: &Touch<S>) -> Option<(Mesh<'a, S>, Vec3<S>)> {
        let [one, other] = pairs.get(touch.pair)?.things.map(|thing| self.things.get(thing));
        let (one, other) = (one?, other?);
        match (self.rigid(one), self.rigid(other)) {
            (None, None) => {
                let [_, below] = self.meshes([one, other], touch.id)?;
                Some((below, touch.point))
            }
            (Some((shape, ..)), None) | (None, Some((shape, ..))) => {
                let (.., radius) = core_points(&shape);
                let mesh = self.mesh(one).or_else(|| self.mesh(other))?;
                let corner = vec3::axpy(touch.point, touch.gap, touch.contact.axes[0]);
                (touch.id >= OF_SHAPE && radius <= S::ZERO).then_some((mesh, corner))
            }
            (Some(_), Some(_)) => None,
        }
    }

    /// Distance of a point from a facet, taken as two triangles (m).
    fn distance(&self, facet: &[usize; 4], point: Vec3<S>) -> S {
        let [a, b, c, d] = facet.map(|node| vec3::sub(vec3::at(self.pos, node), point));
        from_triangle([a, b, c]).min(from_triangle([a, c, d]))
    }
}

/// Distance of the origin from a triangle: from its plane if the foot is inside, else from the nearest edge.
fn from_triangle<S: Scalar>(corners: [Vec3<S>; 3]) -> S {
    let [a, b, c] = corners;
    let (normal, area) = vec3::direction(vec3::cross(vec3::sub(b, a), vec3::sub(c, a)));
    let edges = [[a, b], [b, c], [c, a]];
    let inside = |[p, q]: &[Vec3<S>; 2]| vec3::dot(normal, vec3::cross(*p, *q)) >= S::ZERO;
    if area > S::ZERO && edges.iter().all(inside) {
        return vec3::dot(normal, a).abs();
    }
    edges.iter().fold(S::from_f64(f64::INFINITY), |least, [p, q]| {
        let along = vec3::sub(*q, *p);
        let length = vec3::dot(along, along);
        let share = if length > S::ZERO { -vec3::dot(*p, along) / length } else { S::ZERO };
        least.min(vec3::norm(vec3::axpy(*p, share.max(S::ZERO).min(S::ONE), along)))
    })
}
