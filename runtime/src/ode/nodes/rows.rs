//! Sums over rows of vectors, number by number: loops that the compiler lays side by side.
//!
//! Rows of unequal length are handled as far as the shortest reaches. Every function is inlined into its
//! [`crate::kernel::Kernel`].

use crate::real::Scalar;
use crate::vec3::Vec3;

/// Nodes handled at a time: few enough for the nearest cache, many enough that to begin a block costs little.
pub(super) const BLOCK: usize = if cfg!(target_os = "none") { 4 } else { 128 };

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

/// y + h a b into y, component by component.
#[inline(always)]
pub(super) fn add_product<S: Scalar>(y: &mut [Vec3<S>], h: S, a: &[Vec3<S>], b: &[Vec3<S>]) {
    let factors = a.as_flattened().iter().zip(b.as_flattened());
    for (y, (a, b)) in y.as_flattened_mut().iter_mut().zip(factors) {
        *y = *y + h * (*a * *b);
    }
}

/// y + s a into y.
#[inline(always)]
pub(super) fn add_scaled<S: Scalar>(y: &mut [Vec3<S>], s: S, a: &[Vec3<S>]) {
    for (y, a) in y.as_flattened_mut().iter_mut().zip(a.as_flattened()) {
        *y = *y + s * *a;
    }
}

/// (a + b) c into y, component by component.
#[inline(always)]
pub(super) fn multiply_sum<S: Scalar>(y: &mut [Vec3<S>], [a, b]: [&[Vec3<S>]; 2], c: &[Vec3<S>]) {
    let factors = a.as_flattened().iter().zip(b.as_flattened()).zip(c.as_flattened());
    for (y, ((a, b), c)) in y.as_flattened_mut().iter_mut().zip(factors) {
        *y = (*a + *b) * *c;
    }
}

/// a b into y, component by component.
#[inline(always)]
pub(super) fn multiply<S: Scalar>(y: &mut [Vec3<S>], a: &[Vec3<S>], b: &[Vec3<S>]) {
    let factors = a.as_flattened().iter().zip(b.as_flattened());
    for (y, (a, b)) in y.as_flattened_mut().iter_mut().zip(factors) {
        *y = *a * *b;
    }
}

/// x + rest + change as a sum and what rounding drops from it, with Knuth's exact sum of two.
#[inline(always)]
pub(super) fn add_exactly<S: Scalar>(x: S, rest: S, change: S) -> (S, S) {
    let change = change + rest;
    let sum = x + change;
    let part = sum - x;
    (sum, (x - (sum - part)) + (change - part))
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
        (*out, *rest_out) = add_exactly(*x, *rest, *dx);
    }
}

/// Whether the square of a place or a velocity with such a component may leave the numbers: six such squares are added there.
#[inline(always)]
pub(super) fn is_far<S: Scalar>(x: S) -> bool {
    !(S::from_f64(8.0) * x * x).is_finite()
}

/// Numbers looked at side by side.
const SIDE_BY_SIDE: usize = if cfg!(target_os = "none") { 4 } else { 32 };

/// Takes each number of a row into the lane it falls to.
#[inline(always)]
fn gather<S: Scalar>(lanes: &mut [S; SIDE_BY_SIDE], row: &[Vec3<S>], with: impl Fn(S, S) -> S) {
    let (chunks, rest) = row.as_flattened().as_chunks::<SIDE_BY_SIDE>();
    for chunk in chunks {
        lanes.iter_mut().zip(chunk).for_each(|(lane, x)| *lane = with(*lane, *x));
    }
    lanes.iter_mut().zip(rest).for_each(|(lane, x)| *lane = with(*lane, *x));
}

/// The largest sizes of numbers, side by side.
#[derive(Clone, Copy)]
pub(super) struct Largest<S>([S; SIDE_BY_SIDE]);

impl<S: Scalar> Largest<S> {
    /// Of nothing.
    pub fn none() -> Self {
        Largest([S::ZERO; SIDE_BY_SIDE])
    }

    /// Looks at those of a row.
    #[inline(always)]
    pub fn add(&mut self, row: &[Vec3<S>]) {
        gather(&mut self.0, row, |largest, x| largest.max(x.abs()));
    }

    /// The largest; no number if one was none.
    pub fn size(&self) -> S {
        self.0.iter().fold(S::ZERO, |largest, x| largest.max(*x))
    }
}

/// Sums of products added side by side: as many on every machine, so that all have the same bits.
const SUMS: usize = 8;

/// a.b/b.b over rows.
#[inline(always)]
pub(super) fn quotient<S: Scalar>(a: &[Vec3<S>], b: &[Vec3<S>]) -> S {
    let (mut products, mut squares) = ([S::ZERO; SUMS], [S::ZERO; SUMS]);
    let mut add = |a: &[S], b: &[S]| {
        for ((product, square), (a, b)) in products.iter_mut().zip(&mut squares).zip(a.iter().zip(b)) {
            (*product, *square) = (*product + *a * *b, *square + *b * *b);
        }
    };
    let ((a, rest_a), (b, rest_b)) =
        (a.as_flattened().as_chunks::<SUMS>(), b.as_flattened().as_chunks::<SUMS>());
    a.iter().zip(b).for_each(|(a, b)| add(a, b));
    add(rest_a, rest_b);
    let sum = |sums: [S; SUMS]| sums.into_iter().fold(S::ZERO, |sum, x| sum + x);
    sum(products) / sum(squares)
}
