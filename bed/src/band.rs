//! Symmetric positive definite band matrices: Cholesky factorisation and solution.
//!
//! In: entries on and above the diagonal, at most `width` columns away from it. Out: U with A = U' U, stored in the
//! same place. Rows are slices, so that the update of a row is a sum of slices, `ROWS` at a time (a [`Kernel`]). Width
//! n - 1 gives a full matrix.

use smartbed_runtime::kernel::{self, Kernel};
use smartbed_runtime::real::Scalar;

/// Number of pivot rows that are subtracted from the rows below them in one pass.
const ROWS: usize = 8;
/// Numbers that are processed side by side.
const LANES: usize = 16;

/// The upper band of a symmetric matrix, or of its factor.
#[derive(Clone, Debug)]
pub struct Band<T = f64> {
    size: usize,
    width: usize,
    /// Row by row from the diagonal on; zeros after each row allow a pass to read beyond it.
    entries: Vec<T>,
}

impl<T: Scalar> Band<T> {
    /// A matrix of zeros.
    #[must_use]
    pub fn new(size: usize, width: usize) -> Self {
        let width = width.min(size.saturating_sub(1));
        Band { size, width, entries: vec![T::ZERO; size * Self::stride_of(width)] }
    }

    /// Rows.
    #[must_use]
    pub fn size(&self) -> usize {
        self.size
    }

    /// Distance in memory from a row to the next one.
    fn stride(&self) -> usize {
        Self::stride_of(self.width)
    }

    /// Room for the reach of the last row of a pass, rounded up to a whole number of lanes.
    fn stride_of(width: usize) -> usize {
        width + ROWS + LANES
    }

    /// A row, from the diagonal on.
    #[inline(always)]
    fn row(&self, i: usize) -> &[T] {
        &self.entries[i * self.stride()..][..=self.width]
    }

    /// Adds to the entry of a row and a column on or above the diagonal; an entry below it is ignored, by symmetry.
    pub fn add(&mut self, row: usize, column: usize, value: T) {
        if row <= column {
            let place = row * self.stride() + column - row;
            self.entries[place] = self.entries[place] + value;
        }
    }

    /// Adds a 3 x 3 block between two nodes and, by symmetry, its transpose.
    pub fn add_block(&mut self, row: usize, column: usize, block: &[[T; 3]; 3]) {
        for (i, line) in block.iter().enumerate() {
            for (j, value) in line.iter().enumerate() {
                let (a, b) = (3 * row + i, 3 * column + j);
                if row == column {
                    self.add(a, b, *value);
                } else {
                    self.add(a.min(b), a.max(b), *value);
                }
            }
        }
    }

    /// Adds a number to every diagonal entry.
    pub fn shift(&mut self, value: T) {
        (0..self.size).for_each(|i| self.add(i, i, value));
    }

    /// U of A = U' U; `None` if a pivot is not positive.
    #[must_use]
    pub fn factor(mut self) -> Option<Factor<T>> {
        kernel::run(Factoring(&mut self)).then_some(Factor(self))
    }
}

/// Factors a band in place; returns false if a pivot is not positive.
struct Factoring<'a, T>(&'a mut Band<T>);

impl<T: Scalar> Kernel for Factoring<'_, T> {
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        let Factoring(band) = self;
        let (size, stride) = (band.size, band.stride());
        for first in (0..size).step_by(ROWS) {
            let last = (first + ROWS).min(size);
            for k in first..last {
                if !band.pivot(k) {
                    return false;
                }
                for i in k + 1..last {
                    let (above, below) = band.entries.split_at_mut(i * stride);
                    let row = &above[k * stride + i - k..(k + 1) * stride];
                    take(below, row[0], row);
                }
            }
            // Rows further down are beyond the reach of these pivots.
            for i in last..(last + band.width).min(size) {
                let (above, below) = band.entries.split_at_mut(i * stride);
                let long = (last + band.width - i).next_multiple_of(LANES);
                let others = std::array::from_fn(|k| &above[(first + k) * stride + i - first - k..][..long]);
                take_all(&mut below[..long], others.map(|row| row[0]), others);
            }
        }
        true
    }
}

/// Subtracts a multiple of another row.
#[inline(always)]
fn take<T: Scalar>(row: &mut [T], factor: T, other: &[T]) {
    row.iter_mut().zip(other).for_each(|(own, x)| *own = *own - factor * *x);
}

/// Subtracts multiples of several other rows.
#[inline(always)]
fn take_all<T: Scalar>(row: &mut [T], factors: [T; ROWS], others: [&[T]; ROWS]) {
    let long = row.len();
    let [a, b, c, d, e, f, g, h] = others.map(|other| &other[..long]);
    for k in 0..long {
        let mut sum = row[k];
        sum = sum - factors[0] * a[k];
        sum = sum - factors[1] * b[k];
        sum = sum - factors[2] * c[k];
        sum = sum - factors[3] * d[k];
        sum = sum - factors[4] * e[k];
        sum = sum - factors[5] * f[k];
        sum = sum - factors[6] * g[k];
        sum = sum - factors[7] * h[k];
        row[k] = sum;
    }
}

impl<T: Scalar> Band<T> {
    /// Divides a row by the square root of its pivot; false if the pivot is not positive.
    #[inline(always)]
    fn pivot(&mut self, k: usize) -> bool {
        let stride = self.stride();
        let row = &mut self.entries[k * stride..(k + 1) * stride];
        // Written so that NaN fails too.
        if !(row[0] > T::ZERO && row[0].is_finite()) {
            return false;
        }
        let root = row[0].sqrt();
        row.iter_mut().for_each(|x| *x = *x / root);
        true
    }
}

/// Cholesky's factor.
#[derive(Clone, Debug)]
pub struct Factor<T = f64>(Band<T>);

impl<T: Scalar> Factor<T> {
    /// Solves A x = b in place for several b at once, so that each row of the factor is read once for all of them.
    pub fn solve_all<const N: usize>(&self, b: &mut [[T; N]]) {
        kernel::run(Solving { band: &self.0, b });
    }

    /// Solves A x = b in place.
    pub fn solve(&self, b: &mut [T]) {
        kernel::run(SolvingOne { band: &self.0, b });
    }
}

/// Solves for several right-hand sides.
struct Solving<'a, T, const N: usize> {
    band: &'a Band<T>,
    b: &'a mut [[T; N]],
}

impl<T: Scalar, const N: usize> Kernel for Solving<'_, T, N> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Solving { band, b } = self;
        for i in 0..band.size {
            let row = band.row(i);
            let (known, rest) = b.split_at_mut(i + 1);
            let own = &mut known[i];
            own.iter_mut().for_each(|x| *x = *x / row[0]);
            for (u, x) in row[1..].iter().zip(rest) {
                (0..N).for_each(|k| x[k] = x[k] - *u * own[k]);
            }
        }
        for i in (0..band.size).rev() {
            let row = band.row(i);
            let (rest, known) = b.split_at_mut(i + 1);
            let own = &mut rest[i];
            for (u, x) in row[1..].iter().zip(known.iter()) {
                (0..N).for_each(|k| own[k] = own[k] - *u * x[k]);
            }
            own.iter_mut().for_each(|x| *x = *x / row[0]);
        }
    }
}

/// Solves for one right-hand side.
struct SolvingOne<'a, T> {
    band: &'a Band<T>,
    b: &'a mut [T],
}

impl<T: Scalar> Kernel for SolvingOne<'_, T> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let SolvingOne { band, b } = self;
        for i in 0..band.size {
            let row = band.row(i);
            let (known, rest) = b.split_at_mut(i + 1);
            let x = known[i] / row[0];
            known[i] = x;
            take(rest, x, &row[1..]);
        }
        for i in (0..band.size).rev() {
            let row = band.row(i);
            let long = (band.size - i - 1).min(band.width);
            b[i] = (b[i] - dot(&row[1..=long], &b[i + 1..=i + long])) / row[0];
        }
    }
}

/// Dot product as eight partial sums, which the compiler vectorises.
#[inline(always)]
fn dot<T: Scalar>(a: &[T], b: &[T]) -> T {
    let mut sums = [T::ZERO; 8];
    let (a8, b8) = (a.chunks_exact(8), b.chunks_exact(8));
    let tail = a8.remainder().iter().zip(b8.remainder()).fold(T::ZERO, |sum, (x, y)| sum + *x * *y);
    for (x, y) in a8.zip(b8) {
        for k in 0..8 {
            sums[k] = sums[k] + x[k] * y[k];
        }
    }
    let [a, b, c, d, e, f, g, h] = sums;
    ((a + b) + (c + d)) + ((e + f) + (g + h)) + tail
}
