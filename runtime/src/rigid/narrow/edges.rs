//! Two straight edges that cross at a distance: axes of capsules or edges of boxes.
//!
//! With directions a, b, nearest points x_1 and x_2, n along x_1 - x_2 and perpendicular to both edges,
//! ```text
//! n' . a = -n . (omega_1 x a),   n' . b = -n . (omega_2 x b),   n' . n = 0
//! v_1 - v_2 + a s' - b t' = d' n + d n'                          s', t': how fast the nearest points run along the edges
//! ```

use super::feature::{Feature, Features, Placed};
use crate::real::Scalar;
use crate::surface::{Cuboid, Frame, Shape};
use crate::vec3::{self, Vec3};

/// A straight edge fixed in a frame, in N.
#[derive(Clone, Copy)]
pub(super) struct Edge<'a, S> {
    pub(super) middle: Vec3<S>,
    /// Unit vector.
    pub(super) direction: Vec3<S>,
    pub(super) half_length: S,
    pub(super) frame: &'a Frame<S>,
}

/// Edges whose angle has a smaller sine than this count as parallel.
const PARALLEL: f64 = 1e-4;

/// Coordinates along both edges, taken as infinite lines, of their nearest points; None if parallel.
fn nearest_places<S: Scalar>(one: &Edge<S>, other: &Edge<S>) -> Option<(S, S)> {
    let (a, b) = (one.direction, other.direction);
    let cos = vec3::dot(a, b);
    let across = vec3::cross(a, b);
    let square = vec3::dot(across, across);
    if square < S::from_f64(PARALLEL * PARALLEL) {
        return None;
    }
    let from = vec3::sub(one.middle, other.middle);
    let (p, q) = (vec3::dot(a, from), vec3::dot(b, from));
    Some(((cos * q - p) / square, (q - cos * p) / square))
}

/// The feature of two edges that cross within their lengths. n points along `outward`; without it, from `other` to
/// `one`.
pub(super) fn crossing<S: Scalar>(
    one: &Edge<S>,
    other: &Edge<S>,
    outward: Option<Vec3<S>>,
    id: u32,
) -> Option<Feature<S>> {
    let (s, t) = nearest_places(one, other)?;
    if s.abs() >= one.half_length || t.abs() >= other.half_length {
        return None;
    }
    let x1 = vec3::axpy(one.middle, s, one.direction);
    let x2 = vec3::axpy(other.middle, t, other.direction);
    let (across, _) = vec3::direction(vec3::cross(one.direction, other.direction));
    let apart = vec3::sub(x1, x2);
    let sense = vec3::dot(across, outward.unwrap_or(apart));
    let normal = if sense < S::ZERO { vec3::scale(across, -S::ONE) } else { across };
    let gap = vec3::dot(normal, apart);
    let (v1, v2) = (one.frame.velocity_at(x1), other.frame.velocity_at(x2));
    let turn = |edge: &Edge<S>| -vec3::dot(normal, vec3::cross(edge.frame.angular_velocity, edge.direction));
    // Components in the plane of a and b, given the scalar products with a and b.
    let (a, b) = (one.direction, other.direction);
    let cos = vec3::dot(a, b);
    let square = S::ONE - cos * cos;
    let from_products = |p: S, q: S| ((p - cos * q) / square, (q - cos * p) / square);
    let (along_a, along_b) = from_products(turn(one), turn(other));
    let normal_rate = vec3::axpy(vec3::scale(a, along_a), along_b, b);
    let left = vec3::sub(vec3::scale(normal_rate, gap), vec3::sub(v1, v2));
    let (run, _) = from_products(vec3::dot(a, left), vec3::dot(b, left));
    let point_rate = vec3::axpy(v1, run, a);
    Some(Feature { point: x1, normal, gap, point_rate, normal_rate, id, curved: 2 })
}

/// The axis of a capsule.
fn axis_of<'a, S: Scalar>(capsule: Placed<'a, S>) -> Option<(Edge<'a, S>, S)> {
    let Shape::Capsule(shape) = capsule.shape else { return None };
    let [_, _, direction] = capsule.frame.axes;
    let edge = Edge {
        middle: capsule.frame.origin,
        direction,
        half_length: shape.half_length,
        frame: capsule.frame,
    };
    Some((edge, shape.radius))
}

/// Number of the feature where axes or edges cross; edges of a box are numbered from the next one on.
const CROSSING: u32 = 16;

/// Converts a feature between cores to one between surfaces: the point moves inwards by the radius of `one`.
fn between_surfaces<S: Scalar>(feature: Feature<S>, radius: S, both: S) -> Feature<S> {
    Feature {
        point: vec3::axpy(feature.point, -radius, feature.normal),
        gap: feature.gap - both,
        point_rate: vec3::axpy(feature.point_rate, -radius, feature.normal_rate),
        ..feature
    }
}

/// Adds the crossing of two capsules' sides.
pub(super) fn push_capsules<S: Scalar>(found: &mut Features<S>, one: Placed<S>, other: Placed<S>, margin: S) {
    if let (Some((a, r1)), Some((b, r2))) = (axis_of(one), axis_of(other))
        && let Some(feature) = crossing(&a, &b, None, CROSSING)
    {
        let feature = between_surfaces(feature, r1, r1 + r2);
        if feature.gap <= margin {
            found.push(feature);
        }
    }
}

/// Adds the crossings of a capsule's side with the edges of a box: where the axis runs over a face, those above the two
/// edges where it enters and leaves; else that of the nearest edge.
pub(super) fn push_capsule_on_box<S: Scalar>(
    found: &mut Features<S>,
    capsule: Placed<S>,
    (cuboid, frame): (&Cuboid<S>, &Frame<S>),
    margin: S,
) {
    let Some((axis, radius)) = axis_of(capsule) else { return };
    let course = course(&axis, cuboid, frame);
    for number in 0..12 {
        let (edge, faces) = box_edge(cuboid, frame, number);
        let below = course.as_ref().filter(|c| c.edges.contains(&Some(number))).map(|c| c.normal);
        let Some(feature) = crossing(&axis, &edge, below, CROSSING + 1 + number) else { continue };
        // Over an edge alone the crossing is nearest only if the normal lies between the normals of the edge's faces.
        let between = faces.iter().all(|face| vec3::dot(*face, feature.normal) >= S::ZERO);
        let feature = between_surfaces(feature, radius, radius);
        if (below.is_some() || between) && feature.gap <= margin {
            found.push(feature);
        }
    }
}

/// The face of a box over which a part of a segment runs.
struct Course<S> {
    /// Height of the lowest point of that part over the face (m), < 0 inside the box.
    height: S,
    /// Outward normal of the face.
    normal: Vec3<S>,
    /// Numbers of the edges over which the segment enters and leaves; None where it ends over the face.
    edges: [Option<u32>; 2],
}

/// The face nearest to the part of a segment between that face's sides, if a face has such a part.
fn course<S: Scalar>(segment: &Edge<S>, cuboid: &Cuboid<S>, frame: &Frame<S>) -> Option<Course<S>> {
    let (middle, direction) = (frame.place(segment.middle), frame.to_local(segment.direction));
    let mut best: Option<Course<S>> = None;
    for face in 0..3 {
        let mut part = [-segment.half_length, segment.half_length];
        let mut sides = [None; 2];
        for across in [(face + 1) % 3, (face + 2) % 3] {
            let [at, slope, half] = [&middle, &direction, &cuboid.half].map(|v| vec3::pick(v, across));
            if slope == S::ZERO {
                // Runs along these two sides: between them, or nowhere over the face.
                part[1] = if at.abs() <= half { part[1] } else { part[0] };
                continue;
            }
            let rises = slope > S::ZERO;
            let half = if rises { half } else { -half };
            let (from, to) = ((-half - at) / slope, (half - at) / slope);
            if from > part[0] {
                (part[0], sides[0]) = (from, Some((across, !rises)));
            }
            if to < part[1] {
                (part[1], sides[1]) = (to, Some((across, rises)));
            }
        }
        let [at, slope, half] = [&middle, &direction, &cuboid.half].map(|v| vec3::pick(v, face));
        let [first, last] = part.map(|s| at + s * slope);
        let above = first + last >= S::ZERO;
        let height = if above { first.min(last) } else { (-first).min(-last) } - half;
        if part[0] < part[1] && best.as_ref().is_none_or(|least| height.abs() < least.height.abs()) {
            let sense = if above { S::ONE } else { -S::ONE };
            let normal = vec3::scale(vec3::pick(&frame.axes, face), sense);
            let edges = sides.map(|side| side.map(|side| edge_between((face, above), side)));
            best = Some(Course { height, normal, edges });
        }
    }
    best
}

/// Number of the edge between two faces, each given by its axis and whether it is the upper one.
fn edge_between(one: (usize, bool), other: (usize, bool)) -> u32 {
    let along = 3 - one.0 - other.0;
    let bit = |(axis, upper): (usize, bool)| u32::from(upper) << if axis == (along + 1) % 3 { 0 } else { 1 };
    4 * along as u32 + bit(one) + bit(other)
}

/// Edge 0 to 11 of a box with the outward normals of its two faces: four along each axis.
pub(super) fn box_edge<'a, S: Scalar>(
    cuboid: &Cuboid<S>,
    frame: &'a Frame<S>,
    number: u32,
) -> (Edge<'a, S>, [Vec3<S>; 2]) {
    let along = (number / 4) as usize % 3;
    let (p, q) = ((along + 1) % 3, (along + 2) % 3);
    let side = |bit: u32| if number & bit == 0 { -S::ONE } else { S::ONE };
    let [one, other] =
        [vec3::scale(vec3::pick(&frame.axes, p), side(1)), vec3::scale(vec3::pick(&frame.axes, q), side(2))];
    let half = |axis: usize| vec3::pick(&cuboid.half, axis);
    let middle = vec3::axpy(vec3::axpy(frame.origin, half(p), one), half(q), other);
    (
        Edge { middle, direction: vec3::pick(&frame.axes, along), half_length: half(along), frame },
        [one, other],
    )
}
