//! Sums over rows of vectors, number by number: loops that the compiler lays side by side.
//!
//! Rows of unequal length are handled as far as the shortest reaches. Every function is inlined into its
//! [`crate::kernel::Kernel`].

use crate::kernel::BLOCK;
use crate::real::Scalar;
use crate::vec3::Vec3;

/// Where the blocks of n nodes begin.
pub(super) fn blocks(n: usize) -> impl Iterator<Item = usize> {
    (0..n).step_by(BLOCK)
}

/// The block of a row that begins with node `first`.
#[inline(always)]
pub(super) fn block<T>(row: &[T], first: usize) -> &[T] {
    let rest = row.get(first..).unwrap_or_default();
    rest.get(..BLOCK).unwrap_or(rest)
}

/// The same, to be written.
#[inline(always)]
pub(super) fn block_mut<T>(row: &mut [T], first: usize) -> &mut [T] {
    let rest = row.get_mut(first..).unwrap_or_default();
    let length = rest.len().min(BLOCK);
    rest.get_mut(..length).unwrap_or_default()
}

/// y + h x into y.
#[inline(always)]
pub(super) fn add_scaled<S: Scalar>(y: &mut [Vec3<S>], h: S, x: &[Vec3<S>]) {
    for (y, x) in y.as_flattened_mut().iter_mut().zip(x.as_flattened()) {
        *y = *y + h * *x;
    }
}

/// h x into y; 0 where the weight is 0.
#[inline(always)]
pub(super) fn scale_weighty<S: Scalar>(y: &mut [Vec3<S>], x: &[Vec3<S>], h: S, weights: &[Vec3<S>]) {
    let terms = x.as_flattened().iter().zip(weights.as_flattened());
    for (y, (x, weight)) in y.as_flattened_mut().iter_mut().zip(terms) {
        let moved = *x * h;
        *y = if *weight > S::ZERO { moved } else { S::ZERO };
    }
}

/// x times weights, component by component, into y.
#[inline(always)]
pub(super) fn weigh<S: Scalar>(y: &mut [Vec3<S>], x: &[Vec3<S>], weights: &[Vec3<S>]) {
    let terms = x.as_flattened().iter().zip(weights.as_flattened());
    for (y, (x, weight)) in y.as_flattened_mut().iter_mut().zip(terms) {
        *y = *x * *weight;
    }
}

/// a - b into y.
#[inline(always)]
pub(super) fn subtract<S: Scalar>(y: &mut [Vec3<S>], a: &[Vec3<S>], b: &[Vec3<S>]) {
    let terms = a.as_flattened().iter().zip(b.as_flattened());
    for (y, (a, b)) in y.as_flattened_mut().iter_mut().zip(terms) {
        *y = *a - *b;
    }
}

/// out + rest_out = x + rest + dx, with Knuth's exact sum of two.
#[inline(always)]
pub(super) fn sum_compensated<S: Scalar>(
    [x, rest, dx]: [&[Vec3<S>]; 3],
    out: &mut [Vec3<S>],
    rest_out: &mut [Vec3<S>],
) {
    let terms = x.as_flattened().iter().zip(rest.as_flattened()).zip(dx.as_flattened());
    let sums = out.as_flattened_mut().iter_mut().zip(rest_out.as_flattened_mut());
    for (((x, rest), dx), (out, rest_out)) in terms.zip(sums) {
        let change = *dx + *rest;
        let sum = *x + change;
        let part = sum - *x;
        *rest_out = (*x - (sum - part)) + (change - part);
        *out = sum;
    }
}
