//! Numbers of a world in another scalar: each rounded once, or widened.

use smartbed_runtime::real::Scalar;
use smartbed_runtime::surface::{Capsule, Cuboid, Frame, Shape, Sphere};
use smartbed_runtime::vec3::Vec3;

/// A vector in f64.
#[must_use]
pub fn wide<S: Scalar>(x: Vec3<S>) -> Vec3<f64> {
    x.map(S::to_f64)
}

/// A shape in f64.
#[must_use]
pub fn wide_shape<S: Scalar>(shape: &Shape<S>) -> Shape<f64> {
    shape_by(shape, S::to_f64)
}

/// A shape in another scalar.
#[must_use]
pub fn shape<S: Scalar>(of: &Shape<f64>) -> Shape<S> {
    shape_by(of, S::from_f64)
}

fn shape_by<A: Copy, B>(shape: &Shape<A>, by: impl Fn(A) -> B) -> Shape<B> {
    match shape {
        Shape::HalfSpace => Shape::HalfSpace,
        Shape::Sphere(Sphere { radius }) => Shape::Sphere(Sphere { radius: by(*radius) }),
        Shape::Capsule(Capsule { radius, half_length }) => {
            Shape::Capsule(Capsule { radius: by(*radius), half_length: by(*half_length) })
        }
        Shape::Cuboid(Cuboid { half }) => Shape::Cuboid(Cuboid { half: half.map(by) }),
    }
}

/// A vector in another scalar.
#[must_use]
pub fn vector<S: Scalar>(x: Vec3<f64>) -> Vec3<S> {
    x.map(S::from_f64)
}

/// Numbers in another scalar.
#[must_use]
pub fn numbers<S: Scalar>(list: &[f64]) -> Vec<S> {
    list.iter().map(|x| S::from_f64(*x)).collect()
}

/// A frame in another scalar.
#[must_use]
pub fn frame<S: Scalar>(of: &Frame<f64>) -> Frame<S> {
    Frame {
        origin: vector(of.origin),
        axes: of.axes.map(vector),
        velocity: vector(of.velocity),
        angular_velocity: vector(of.angular_velocity),
    }
}
