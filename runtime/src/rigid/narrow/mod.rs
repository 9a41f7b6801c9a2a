//! Narrow-phase detection of two shapes: contact points, normals, gaps, and the rates of point and normal.
//!
//! In: two shapes with their frames, the margin within which a gap counts. Out: up to [`CAPACITY`] features.
//!
//! A feature is either a point of one core (centre of a ball, end of a capsule, corner of a box) over the surface of
//! the other shape, or two straight edges that cross. For the first, with distance d from the core's point to the
//! surface,
//! ```text
//! n' = omega x n + H w,    c' = v - d' n - d n'         w: velocity of the core's point relative to the other frame
//! ```
//! c is the place of contact, not a material point: for a rolling body c' is not 0 although the material point there is
//! at rest.

mod boxes;
mod edges;
mod feature;

use feature::corners;
pub use feature::{CAPACITY, Feature, Features, Placed};

use crate::real::Scalar;
use crate::surface::{Feature as Core, Frame, Shape, Surface};
use crate::vec3::{self, Vec3};

/// The features of two shapes that are nearer than `margin` (m); the normal points from `other` to `one`.
///
/// Two half-spaces have none.
pub fn features<S: Scalar>(one: Placed<S>, other: Placed<S>, margin: S) -> Features<S> {
    let reach = one.shape.reach().zip(other.shape.reach());
    let apart = vec3::norm(vec3::sub(one.frame.origin, other.frame.origin));
    if reach.is_some_and(|(one, other)| apart > one + other + margin) {
        return Features::none();
    }
    if rank(one.shape) < rank(other.shape) {
        features_in_order(other, one, margin).swapped()
    } else {
        features_in_order(one, other, margin)
    }
}

/// The rounder shape comes first.
fn rank<S>(shape: &Shape<S>) -> u8 {
    match shape {
        Shape::HalfSpace => 0,
        Shape::Cuboid(_) => 1,
        Shape::Capsule(_) => 2,
        Shape::Sphere(_) => 3,
    }
}

fn features_in_order<S: Scalar>(one: Placed<S>, other: Placed<S>, margin: S) -> Features<S> {
    let mut found = Features::none();
    let mut back = Features::none();
    match (one.shape, other.shape) {
        (Shape::HalfSpace, _) => {}
        (Shape::Sphere(ball), _) => {
            push_core(&mut found, one.frame, vec3::zero(), ball.radius, other, margin, 0);
        }
        (Shape::Cuboid(a), Shape::Cuboid(b)) => {
            boxes::push_features(&mut found, (a, one.frame), (b, other.frame), margin);
        }
        (Shape::Cuboid(a), _) => {
            for (id, corner) in (0..).zip(corners(a)) {
                push_core(&mut found, one.frame, corner, S::ZERO, other, margin, id);
            }
        }
        (Shape::Capsule(_), Shape::Cuboid(b)) => {
            push_ends(&mut found, one, other, margin, 0, true);
            for (id, corner) in (2..).zip(corners(b)) {
                push_corner_over_side(&mut back, other.frame, corner, one, margin, id);
            }
            edges::push_capsule_on_box(&mut found, one, (b, other.frame), margin);
        }
        (Shape::Capsule(_), Shape::Capsule(_)) => {
            push_ends(&mut found, one, other, margin, 0, true);
            push_ends(&mut back, other, one, margin, 2, false);
            edges::push_capsules(&mut found, one, other, margin);
        }
        (Shape::Capsule(_), _) => push_ends(&mut found, one, other, margin, 0, true),
    }
    back.swapped().iter().for_each(|feature| found.push(feature));
    found
}

/// A point of a core over the surface of the other shape.
fn core_feature<S: Scalar>(
    frame: &Frame<S>,
    place: Vec3<S>,
    radius: S,
    other: Placed<S>,
    id: u32,
) -> (Feature<S>, Core<S>) {
    let center = frame.point(place);
    let velocity = frame.velocity_at(center);
    let near = other.shape.nearest(other.frame.place(center));
    let normal = other.frame.to_inertial(near.normal);
    let relative = vec3::sub(velocity, other.frame.velocity_at(center));
    let bend = other.frame.to_inertial(near.bend_vector(other.frame.to_local(relative)));
    let normal_rate = vec3::add(vec3::cross(other.frame.angular_velocity, normal), bend);
    let rate = vec3::dot(normal, relative);
    let point_rate = vec3::axpy(vec3::axpy(velocity, -rate, normal), -near.gap, normal_rate);
    let point = other.frame.point(near.foot);
    let curved = match near.feature {
        Core::Face => 0,
        Core::Edge(_) => 1,
        Core::Vertex => 2,
    };
    (Feature { point, normal, gap: near.gap - radius, point_rate, normal_rate, id, curved }, near.feature)
}

fn push_core<S: Scalar>(
    found: &mut Features<S>,
    frame: &Frame<S>,
    place: Vec3<S>,
    radius: S,
    other: Placed<S>,
    margin: S,
    id: u32,
) {
    let (feature, _) = core_feature(frame, place, radius, other, id);
    if feature.gap <= margin {
        found.push(feature);
    }
}

/// Adds the ends of a capsule over the other shape. Over another capsule's end only if `ends` is set, so that two ends
/// that meet are one feature.
fn push_ends<S: Scalar>(
    found: &mut Features<S>,
    capsule: Placed<S>,
    other: Placed<S>,
    margin: S,
    id: u32,
    ends: bool,
) {
    let Shape::Capsule(shape) = capsule.shape else { return };
    for (number, z) in (0..).zip([-shape.half_length, shape.half_length]) {
        let place = [S::ZERO, S::ZERO, z];
        let (feature, core) = core_feature(capsule.frame, place, shape.radius, other, id + number);
        if feature.gap <= margin && (ends || core != Core::Vertex) {
            found.push(feature);
        }
        // A capsule of length 0 is a ball.
        if shape.half_length == S::ZERO {
            break;
        }
    }
}

/// Adds a box's corner over the side of a capsule; the capsule's ends over the box are features of their own.
fn push_corner_over_side<S: Scalar>(
    found: &mut Features<S>,
    frame: &Frame<S>,
    corner: Vec3<S>,
    capsule: Placed<S>,
    margin: S,
    id: u32,
) {
    let (feature, core) = core_feature(frame, corner, S::ZERO, capsule, id);
    if feature.gap <= margin && core != Core::Vertex {
        found.push(feature);
    }
}

/// Points of a shape's core other than on its straight edges (centre of a ball, ends of a capsule, corners of a box),
/// their number, and the radius around them.
pub(crate) fn core_points<S: Scalar>(shape: &Shape<S>) -> ([Vec3<S>; 8], usize, S) {
    let mut points = [vec3::zero(); 8];
    match shape {
        Shape::HalfSpace => (points, 0, S::ZERO),
        Shape::Sphere(ball) => (points, 1, ball.radius),
        Shape::Capsule(capsule) => {
            (points[0][2], points[1][2]) = (-capsule.half_length, capsule.half_length);
            (points, 2, capsule.radius)
        }
        Shape::Cuboid(cuboid) => (corners(cuboid), 8, S::ZERO),
    }
}
