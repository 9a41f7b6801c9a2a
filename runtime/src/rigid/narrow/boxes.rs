//! Two boxes: the axis of largest separation, then the corners of their common face, or two crossing edges.
//!
//! Separating axes (Gottschalk, Lin & Manocha 1996): the face normals of both and the cross products of their edges.
//! On a face: the corners of what both faces share, that is corners of either inside the other's, rim included, and
//! crossings of their sides elsewhere, up to eight points.

use super::edges::{Edge, box_edge, crossing};
use super::feature::{Feature, Features, corners};
use crate::real::Scalar;
use crate::surface::{Cuboid, Frame};
use crate::vec3::{self, Vec3};

/// A box and its frame.
type Standing<'a, S> = (&'a Cuboid<S>, &'a Frame<S>);

/// Edges are chosen only if their separation exceeds that of every face by this share of the size.
const EDGE_ADVANTAGE: f64 = 1e-6;
/// Places nearer than this share of the faces' size, or than so many roundings, are one place.
const RIM: f64 = 1e-9;
/// See [`RIM`].
const ROUNDINGS: f64 = 16.0;

/// Adds the features within `margin`; normals point from b to a.
pub(super) fn push_features<S: Scalar>(found: &mut Features<S>, a: Standing<S>, b: Standing<S>, margin: S) {
    let face = farthest_face(a, b);
    let size = a.0.half.iter().chain(&b.0.half).fold(S::ZERO, |m, h| m.max(*h));
    let edge = farthest_edges(a, b);
    if let Some((apart, ..)) = edge
        && apart > face.apart + S::from_f64(EDGE_ADVANTAGE) * size
    {
        push_edges(found, a, b, edge, margin);
    } else if face.apart <= margin {
        push_face(found, &face, a, b, margin);
    }
}

/// Of each side of a face, in the order of [`Plane::sides`], the number in the order of [`Plane::walls`].
const SIDES: [u32; 4] = [3, 0, 2, 1];

/// A face and the separation along its normal.
struct Face<S> {
    /// Separation (m), < 0 where the boxes overlap.
    apart: S,
    /// Whether it belongs to a.
    of_a: bool,
    /// Its axis.
    axis: usize,
    /// Outward normal, from its box to the other.
    normal: Vec3<S>,
}

/// Half the extent of a box along a direction.
fn extent<S: Scalar>((cuboid, frame): Standing<S>, direction: Vec3<S>) -> S {
    let parts = frame.axes.iter().zip(cuboid.half);
    parts.fold(S::ZERO, |sum, (axis, half)| sum + half * vec3::dot(*axis, direction).abs())
}

/// The face normal of largest separation; of equals the first, a's before b's.
fn farthest_face<S: Scalar>(a: Standing<S>, b: Standing<S>) -> Face<S> {
    let between = vec3::sub(b.1.origin, a.1.origin);
    let mut best: Option<Face<S>> = None;
    for (of_a, standing) in [(true, a), (false, b)] {
        for (axis, direction) in standing.1.axes.iter().enumerate() {
            let along = vec3::dot(*direction, between);
            let along = if of_a { along } else { -along };
            let normal = vec3::scale(*direction, if along < S::ZERO { -S::ONE } else { S::ONE });
            let apart = along.abs() - extent(a, normal) - extent(b, normal);
            if best.as_ref().is_none_or(|face| apart > face.apart + S::EPSILON) {
                best = Some(Face { apart, of_a, axis, normal });
            }
        }
    }
    best.unwrap_or(Face { apart: S::ZERO, of_a: true, axis: 0, normal: a.1.axes[0] })
}

/// The pair of edge directions whose cross product has the largest separation: separation, normal from b to a,
/// and the two axes.
fn farthest_edges<S: Scalar>(a: Standing<S>, b: Standing<S>) -> Option<(S, Vec3<S>, usize, usize)> {
    let between = vec3::sub(a.1.origin, b.1.origin);
    let mut best: Option<(S, Vec3<S>, usize, usize)> = None;
    for i in 0..3 {
        for j in 0..3 {
            let (normal, sine) = vec3::direction(vec3::cross(a.1.axes[i], b.1.axes[j]));
            if sine < S::from_f64(1e-4) {
                continue;
            }
            let along = vec3::dot(normal, between);
            let normal = if along < S::ZERO { vec3::scale(normal, -S::ONE) } else { normal };
            let apart = along.abs() - extent(a, normal) - extent(b, normal);
            if best.is_none_or(|(most, ..)| apart > most) {
                best = Some((apart, normal, i, j));
            }
        }
    }
    best
}

/// Adds the crossing of the two edges that lie deepest along the normal.
fn push_edges<S: Scalar>(
    found: &mut Features<S>,
    a: Standing<S>,
    b: Standing<S>,
    edges: Option<(S, Vec3<S>, usize, usize)>,
    margin: S,
) {
    let Some((apart, normal, i, j)) = edges else { return };
    if apart > margin {
        return;
    }
    let (one, first) = deepest(a, i, vec3::scale(normal, -S::ONE));
    let (other, second) = deepest(b, j, normal);
    if let Some(feature) = crossing(&one, &other, Some(normal), 64 + 12 * first + second) {
        found.push(feature);
    }
}

/// Of the four edges along an axis, the one farthest in a direction, and its number.
fn deepest<'a, S: Scalar>(
    (cuboid, frame): Standing<'a, S>,
    axis: usize,
    towards: Vec3<S>,
) -> (Edge<'a, S>, u32) {
    let side = |k: usize| u32::from(vec3::dot(frame.axes[(axis + k) % 3], towards) >= S::ZERO);
    let number = 4 * axis as u32 + side(1) + 2 * side(2);
    (box_edge(cuboid, frame, number).0, number)
}

/// Adds the corners of the intersection of the two faces.
fn push_face<S: Scalar>(found: &mut Features<S>, face: &Face<S>, a: Standing<S>, b: Standing<S>, margin: S) {
    let (reference, incident) = if face.of_a { (a, b) } else { (b, a) };
    let plane = Plane::new(reference, face);
    let mut push = |place: Vec3<S>, id: u32| {
        let gap = plane.height(place);
        if gap <= margin {
            let sense = if face.of_a { -S::ONE } else { S::ONE };
            let normal = vec3::scale(face.normal, sense);
            let rate = vec3::cross(reference.1.angular_velocity, normal);
            let velocity = incident.1.velocity_at(place);
            let (point_rate, normal_rate, curved) = (velocity, rate, 0);
            found.push(Feature { point: place, normal, gap, point_rate, normal_rate, id, curved });
        }
    };
    let of = |own: bool| if face.of_a == own { 0 } else { 8 };
    let facing = Plane::facing(incident, face.normal);
    let share = S::from_f64(RIM).max(S::from_f64(ROUNDINGS) * S::EPSILON);
    let rim = share * plane.size().max(facing.size());
    let (twice, thrice) = (rim + rim, rim + rim + rim);
    // Corners of the incident box over the reference face. What is left out below near a corner lies on one that counts
    // whatever the rounding: each limit is by a rim wider than the one that relies on it.
    for (number, corner) in (0..).zip(corners(incident.0)) {
        let point = incident.1.point(corner);
        if plane.holds(point, thrice) {
            push(point, of(false) + number);
        }
    }
    // Corners of the reference face below the incident face, projected onto it, where that has no corner itself.
    for (number, corner) in (0..).zip(corners(reference.0)) {
        let point = reference.1.point(corner);
        let on_face = plane.height(point).abs() <= rim;
        let raised = facing.pierced(point, face.normal);
        let raised = raised.filter(|x| facing.holds(*x, twice) && !facing.is_corner(*x, rim));
        if on_face && let Some(raised) = raised {
            push(raised, of(true) + number);
        }
    }
    // Sides of the incident face that cross sides of the reference face, numbered alike whichever of them is which; not
    // where either has a corner.
    for ([p, q], i) in facing.sides().into_iter().zip(SIDES) {
        for (j, side) in (0..).zip(plane.walls()) {
            let (from, to) = (plane.beyond(p, side), plane.beyond(q, side));
            let clear = from.abs().min(to.abs()) > twice;
            if clear && (from < S::ZERO) != (to < S::ZERO) {
                let point = vec3::axpy(p, from / (from - to), vec3::sub(q, p));
                let other = if side.0 == 0 { 1 } else { 0 };
                if plane.within(point, other, -rim) {
                    let (of_a, of_b) = if face.of_a { (j, i) } else { (i, j) };
                    push(point, 16 + 4 * of_a + of_b);
                }
            }
        }
    }
}

/// A face of a box as a bounded plane.
struct Plane<S> {
    middle: Vec3<S>,
    normal: Vec3<S>,
    /// Directions and half lengths of the face's sides.
    directions: [Vec3<S>; 2],
    half: [S; 2],
}

impl<S: Scalar> Plane<S> {
    fn new((cuboid, frame): Standing<S>, face: &Face<S>) -> Plane<S> {
        let (p, q) = ((face.axis + 1) % 3, (face.axis + 2) % 3);
        Plane {
            middle: vec3::axpy(frame.origin, vec3::pick(&cuboid.half, face.axis), face.normal),
            normal: face.normal,
            directions: [vec3::pick(&frame.axes, p), vec3::pick(&frame.axes, q)],
            half: [vec3::pick(&cuboid.half, p), vec3::pick(&cuboid.half, q)],
        }
    }

    /// The face of a box whose normal is most opposed to a direction.
    fn facing(standing: Standing<S>, against: Vec3<S>) -> Plane<S> {
        let along = standing.1.axes.map(|axis| vec3::dot(axis, against));
        let mut axis = 0;
        for (i, size) in along.iter().enumerate() {
            if size.abs() > vec3::pick(&along, axis).abs() {
                axis = i;
            }
        }
        let sense = if vec3::pick(&along, axis) > S::ZERO { -S::ONE } else { S::ONE };
        let normal = vec3::scale(vec3::pick(&standing.1.axes, axis), sense);
        Plane::new(standing, &Face { apart: S::ZERO, of_a: true, axis, normal })
    }

    fn size(&self) -> S {
        self.half[0].max(self.half[1])
    }

    fn height(&self, point: Vec3<S>) -> S {
        vec3::dot(self.normal, vec3::sub(point, self.middle))
    }

    /// Direction k, 0 or 1, and half the face's length along it.
    fn across(&self, k: usize) -> (Vec3<S>, S) {
        let ([d, e], [a, b]) = (self.directions, self.half);
        if k == 0 { (d, a) } else { (e, b) }
    }

    /// Whether the point is between the two sides across direction k; `rim` widens the face (m).
    fn within(&self, point: Vec3<S>, k: usize, rim: S) -> bool {
        let (direction, half) = self.across(k);
        vec3::dot(direction, vec3::sub(point, self.middle)).abs() <= half + rim
    }

    fn holds(&self, point: Vec3<S>, rim: S) -> bool {
        self.within(point, 0, rim) && self.within(point, 1, rim)
    }

    /// Whether a point that it holds lies at a corner.
    fn is_corner(&self, point: Vec3<S>, rim: S) -> bool {
        !self.within(point, 0, -rim) && !self.within(point, 1, -rim)
    }

    /// Where the line through a point along a direction intersects the plane.
    fn pierced(&self, point: Vec3<S>, direction: Vec3<S>) -> Option<Vec3<S>> {
        let slope = vec3::dot(self.normal, direction);
        (slope != S::ZERO).then(|| vec3::axpy(point, -(self.height(point) / slope), direction))
    }

    /// The four sides as pairs of corners.
    fn sides(&self) -> [[Vec3<S>; 2]; 4] {
        let corner = |u: S, v: S| {
            let [d, e] = self.directions;
            vec3::axpy(vec3::axpy(self.middle, u * self.half[0], d), v * self.half[1], e)
        };
        let (m, p) = (-S::ONE, S::ONE);
        let [a, b, c, d] = [corner(m, m), corner(p, m), corner(p, p), corner(m, p)];
        [[a, b], [b, c], [c, d], [d, a]]
    }

    /// The four sides as (direction, sign).
    fn walls(&self) -> [(usize, S); 4] {
        [(0, S::ONE), (0, -S::ONE), (1, S::ONE), (1, -S::ONE)]
    }

    /// Distance of a point beyond a side (m), < 0 inside.
    fn beyond(&self, point: Vec3<S>, (k, sense): (usize, S)) -> S {
        let (direction, half) = self.across(k);
        sense * vec3::dot(direction, vec3::sub(point, self.middle)) - half
    }
}
