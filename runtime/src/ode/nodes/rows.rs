//! Arithmetic on rows of vectors, number by number: loops that the compiler can vectorise.
//!
//! Rows of unequal length are handled as far as the shortest reaches. Every function is inlined into its
//! [`crate::kernel::Kernel`].

use super::newton::Newton;
use crate::kernel::{self, Kernel};
use crate::ode::state::two_sum;
use crate::real::Scalar;
use crate::vec3::Vec3;

/// Nodes handled at a time: few enough for the first-level cache, many enough that starting a block costs little.
pub(super) const BLOCK: usize = if cfg!(target_os = "none") { 4 } else { 128 };

/// Fewer nodes than these are handled one by one: starting a row costs more than its sums.
pub(super) const FEW: usize = if cfg!(target_os = "none") { 0 } else { 7 };

/// Runs a kernel over so many nodes; over few the plain loop where the call stands: wide registers gain nothing there,
/// and to hand over what a kernel borrows costs more than its sums.
#[inline(always)]
pub(super) fn run<K: Kernel>(nodes: usize, kernel: K) -> K::Output {
    if nodes < FEW { kernel.run() } else { kernel::run(kernel) }
}

/// Where the blocks of n nodes begin.
pub(super) fn blocks(n: usize) -> impl Iterator<Item = usize> {
    (0..n.div_ceil(BLOCK)).map(|i| i * BLOCK)
}

/// The block of a row that begins with node `first`.
#[inline(always)]
pub(super) fn block<T>(row: &[T], first: usize) -> &[T] {
    let rest = row.get(first..).unwrap_or_default();
    rest.get(..BLOCK).unwrap_or(rest)
}

/// The same block, mutable.
#[inline(always)]
pub(super) fn block_mut<T>(row: &mut [T], first: usize) -> &mut [T] {
    let rest = row.get_mut(first..).unwrap_or_default();
    let length = rest.len().min(BLOCK);
    rest.get_mut(..length).unwrap_or_default()
}

/// Two rows whose products are the accelerations of the block of nodes from `first` on; the second is 0 where a node
/// cannot move. They are (force, 1/mass), or (acceleration, 1) in a block with a node held by a contact. `memory` is
/// two rows of all nodes.
#[inline(always)]
pub(super) fn accelerations<'a, S: Scalar>(
    newton: &'a impl Newton<S>,
    first: usize,
    force: &'a [Vec3<S>],
    [accelerations, factors]: [&'a mut [Vec3<S>]; 2],
) -> [&'a [Vec3<S>]; 2] {
    let (force, factors) = (block(force, first), block_mut(factors, first));
    if !newton.holds(first, factors.len()) {
        return [force, newton.inverse_masses(first, factors)];
    }
    let accelerations = block_mut(accelerations, first);
    multiply(accelerations, force, newton.inverse_masses(first, factors));
    newton.admit(first, accelerations);
    for (i, factor) in factors.iter_mut().enumerate() {
        *factor = [if newton.is_movable(first + i) { S::ONE } else { S::ZERO }; 3];
    }
    [accelerations, factors]
}

/// y += h a b, component by component.
#[inline(always)]
pub(super) fn add_product<S: Scalar>(y: &mut [Vec3<S>], h: S, a: &[Vec3<S>], b: &[Vec3<S>]) {
    let factors = a.as_flattened().iter().zip(b.as_flattened());
    for (y, (a, b)) in y.as_flattened_mut().iter_mut().zip(factors) {
        *y = *y + h * (*a * *b);
    }
}

/// y += s a.
#[inline(always)]
pub(super) fn add_scaled<S: Scalar>(y: &mut [Vec3<S>], s: S, a: &[Vec3<S>]) {
    for (y, a) in y.as_flattened_mut().iter_mut().zip(a.as_flattened()) {
        *y = *y + s * *a;
    }
}

/// y = (a + b) c, component by component.
#[inline(always)]
pub(super) fn multiply_sum<S: Scalar>(y: &mut [Vec3<S>], [a, b]: [&[Vec3<S>]; 2], c: &[Vec3<S>]) {
    let factors = a.as_flattened().iter().zip(b.as_flattened()).zip(c.as_flattened());
    for (y, ((a, b), c)) in y.as_flattened_mut().iter_mut().zip(factors) {
        *y = (*a + *b) * *c;
    }
}

/// y = a b, component by component.
#[inline(always)]
pub(super) fn multiply<S: Scalar>(y: &mut [Vec3<S>], a: &[Vec3<S>], b: &[Vec3<S>]) {
    let factors = a.as_flattened().iter().zip(b.as_flattened());
    for (y, (a, b)) in y.as_flattened_mut().iter_mut().zip(factors) {
        *y = *a * *b;
    }
}

/// x + (rest + change) as a rounded sum and its rounding error; rest + change is rounded once, which
/// [`advance`](crate::ode::state::advance) does not.
#[inline(always)]
pub(crate) fn add_compensated<S: Scalar>(x: S, rest: S, change: S) -> (S, S) {
    two_sum(x, change + rest)
}

/// out + rest_out = x + rest + dx, by Knuth's exact sum of two.
#[inline(always)]
pub(super) fn sum_compensated<S: Scalar>(
    [x, rest, dx]: [&[Vec3<S>]; 3],
    out: &mut [Vec3<S>],
    rest_out: &mut [Vec3<S>],
) {
    if x.len() < FEW {
        let sums = out.iter_mut().zip(rest_out);
        for (((x, rest), dx), (out, rest_out)) in x.iter().zip(rest).zip(dx).zip(sums) {
            for i in 0..3 {
                (out[i], rest_out[i]) = add_compensated(x[i], rest[i], dx[i]);
            }
        }
        return;
    }
    let terms = x.as_flattened().iter().zip(rest.as_flattened()).zip(dx.as_flattened());
    let sums = out.as_flattened_mut().iter_mut().zip(rest_out.as_flattened_mut());
    for (((x, rest), dx), (out, rest_out)) in terms.zip(sums) {
        (*out, *rest_out) = add_compensated(*x, *rest, *dx);
    }
}

/// Whether squares of vectors with such a component may overflow: |x|^2 + |v|^2 adds six squares.
#[inline(always)]
pub(super) fn is_far<S: Scalar>(x: S) -> bool {
    !(S::from_f64(8.0) * x * x).is_finite()
}

/// Numbers compared at a time.
const SIDE_BY_SIDE: usize = if cfg!(target_os = "none") { 4 } else { 8 };

/// The largest magnitude of some numbers, kept per lane.
#[derive(Clone, Copy)]
pub(super) struct Largest<S> {
    lanes: [S; SIDE_BY_SIDE],
    /// Whether any was NaN; lanes that kept NaN themselves would go through memory.
    is_lost: bool,
}

impl<S: Scalar> Largest<S> {
    /// Of no numbers.
    pub fn none() -> Self {
        Largest { lanes: [S::ZERO; SIDE_BY_SIDE], is_lost: false }
    }

    /// Includes the numbers of a row.
    #[inline(always)]
    pub fn add(&mut self, row: &[Vec3<S>]) {
        let Largest { mut lanes, mut is_lost } = *self;
        let (chunks, rest) = row.as_flattened().as_chunks::<SIDE_BY_SIDE>();
        for chunk in chunks {
            is_lost |= take_larger(&mut lanes, chunk);
        }
        is_lost |= take_larger(&mut lanes, rest);
        *self = Largest { lanes, is_lost };
    }

    /// The largest magnitude; NaN if any number was.
    pub fn size(&self) -> S {
        let largest = self.lanes.iter().fold(S::ZERO, |largest, x| largest.max(*x));
        if self.is_lost { S::from_f64(f64::NAN) } else { largest }
    }
}

/// Raises each lane to the magnitude of its number; returns whether any number is NaN.
#[inline(always)]
fn take_larger<S: Scalar>(lanes: &mut [S; SIDE_BY_SIDE], numbers: &[S]) -> bool {
    let mut is_lost = false;
    for (lane, x) in lanes.iter_mut().zip(numbers) {
        let size = x.abs();
        *lane = if size > *lane { size } else { *lane };
        is_lost |= size.partial_cmp(&size).is_none();
    }
    is_lost
}

/// Partial sums of a product: as many on every machine, so that all round alike.
const SUMS: usize = 8;

/// a.b over rows.
#[inline(always)]
pub(super) fn product<S: Scalar>(a: &[Vec3<S>], b: &[Vec3<S>]) -> S {
    let mut sums = [S::ZERO; SUMS];
    let ((a, rest_a), (b, rest_b)) =
        (a.as_flattened().as_chunks::<SUMS>(), b.as_flattened().as_chunks::<SUMS>());
    let add = |sums: &mut [S; SUMS], a: &[S], b: &[S]| {
        for (sum, (a, b)) in sums.iter_mut().zip(a.iter().zip(b)) {
            *sum = *sum + *a * *b;
        }
    };
    for (a, b) in a.iter().zip(b) {
        add(&mut sums, a, b);
    }
    add(&mut sums, rest_a, rest_b);
    sums.into_iter().fold(S::ZERO, |sum, x| sum + x)
}

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
    // A loop on purpose: a closure called by an iterator would keep the instructions of the oldest machine.
    for (a, b) in a.iter().zip(b) {
        add(a, b);
    }
    add(rest_a, rest_b);
    let sum = |sums: [S; SUMS]| sums.into_iter().fold(S::ZERO, |sum, x| sum + x);
    sum(products) / sum(squares)
}
