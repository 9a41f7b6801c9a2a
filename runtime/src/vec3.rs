//! Vectors of three components in the inertial frame N, and reading and adding by index without a panic.
//!
//! An index out of range reads as the zero vector and adds nowhere, so that no panic branch is compiled.
//! `flexible::Body::new` refuses such indices; lists that may be empty, such as friction's losses, read as zero.

use crate::real::Scalar;

/// Components along n1, n2, n3.
pub type Vec3<S> = [S; 3];

/// 0.
#[must_use]
#[inline(always)]
pub fn zero<S: Scalar>() -> Vec3<S> {
    [S::ZERO; 3]
}

/// a + b.
#[must_use]
#[inline(always)]
pub fn add<S: Scalar>(a: Vec3<S>, b: Vec3<S>) -> Vec3<S> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// a - b.
#[must_use]
#[inline(always)]
pub fn sub<S: Scalar>(a: Vec3<S>, b: Vec3<S>) -> Vec3<S> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// s a.
#[must_use]
#[inline(always)]
pub fn scale<S: Scalar>(a: Vec3<S>, s: S) -> Vec3<S> {
    [a[0] * s, a[1] * s, a[2] * s]
}

/// a + s b.
#[must_use]
#[inline(always)]
pub fn axpy<S: Scalar>(a: Vec3<S>, s: S, b: Vec3<S>) -> Vec3<S> {
    [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]]
}

/// a . b.
#[must_use]
#[inline(always)]
pub fn dot<S: Scalar>(a: Vec3<S>, b: Vec3<S>) -> S {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// a x b.
#[must_use]
#[inline(always)]
pub fn cross<S: Scalar>(a: Vec3<S>, b: Vec3<S>) -> Vec3<S> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The product of a matrix, given by its rows, and a.
#[must_use]
pub fn apply<S: Scalar>(rows: &[Vec3<S>; 3], a: Vec3<S>) -> Vec3<S> {
    rows.map(|row| dot(row, a))
}

/// |a|.
#[must_use]
#[inline(always)]
pub fn norm<S: Scalar>(a: Vec3<S>) -> S {
    dot(a, a).sqrt()
}

/// a without its part along the unit vector n.
#[must_use]
pub fn tangential<S: Scalar>(a: Vec3<S>, n: Vec3<S>) -> Vec3<S> {
    axpy(a, -dot(a, n), n)
}

/// Entry `i` of three; the last one where `i` is out of range.
#[inline(always)]
#[must_use]
pub fn pick<T: Copy>(of: &[T; 3], i: usize) -> T {
    let [a, b, c] = *of;
    match i {
        0 => a,
        1 => b,
        _ => c,
    }
}

/// Row i.
#[must_use]
#[inline(always)]
pub fn at<S: Scalar>(rows: &[Vec3<S>], i: usize) -> Vec3<S> {
    rows.get(i).copied().unwrap_or([S::ZERO; 3])
}

/// Sets row i.
#[inline(always)]
pub fn set_at<S: Scalar>(rows: &mut [Vec3<S>], i: usize, a: Vec3<S>) {
    if let Some(row) = rows.get_mut(i) {
        *row = a;
    }
}

/// Adds a to row i.
#[inline(always)]
pub fn add_at<S: Scalar>(rows: &mut [Vec3<S>], i: usize, a: Vec3<S>) {
    if let Some(row) = rows.get_mut(i) {
        *row = add(*row, a);
    }
}

/// Unit vector and length of a; the zero vector where there is no direction (length 0 or below what squares to 0).
#[must_use]
#[inline(always)]
pub fn direction<S: Scalar>(a: Vec3<S>) -> (Vec3<S>, S) {
    let length = norm(a);
    if length > S::ZERO { (scale(a, S::ONE / length), length) } else { (zero(), S::ZERO) }
}
