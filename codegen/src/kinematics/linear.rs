//! A small dense solver for use at derive time: Gaussian elimination with full pivoting.
//!
//! A x = b, rows x columns, row-major. Rank-revealing: pivots below a relative threshold end the elimination and their
//! unknowns stay 0, so that consistent redundant equations do no harm.

/// A pivot below this share of the largest entry counts as zero.
const RANK: f64 = 1e-10;

/// Entries processed together; a row is padded with zeros to a multiple of this.
const LANES: usize = 2;

/// A basic solution of A x = b and the rank of A; `b` is overwritten.
#[must_use]
pub fn solve(a: &[f64], b: &mut [f64], columns: usize) -> (Vec<f64>, usize) {
    solve_to(a, b, columns, RANK)
}

/// [`solve`] with another rank threshold, relative to the largest entry.
#[must_use]
pub fn solve_to(a: &[f64], b: &mut [f64], columns: usize, zero: f64) -> (Vec<f64>, usize) {
    let mut solver = Solver::default();
    let rank = solver.solve(a, b, columns, zero);
    (solver.x, rank)
}

/// Some entries of a row.
pub(super) type Block = [f64; LANES];

/// Working memory for many systems one after the other.
#[derive(Clone, Debug, Default)]
pub(super) struct Solver {
    /// The matrix, row after row.
    blocks: Vec<Block>,
    /// Largest entry of each row; updated only when the row changes.
    sizes: Vec<f64>,
    /// The columns, those of pivots first.
    order: Vec<usize>,
    x: Vec<f64>,
}

impl Solver {
    /// [`solve`], without the rank.
    pub fn basic(&mut self, a: &[f64], b: &mut [f64], columns: usize) -> &[f64] {
        self.solve(a, b, columns, RANK);
        &self.x
    }

    fn solve(&mut self, a: &[f64], b: &mut [f64], columns: usize, zero: f64) -> usize {
        let width = columns.div_ceil(LANES).max(1);
        let mut blocks = std::mem::take(&mut self.blocks);
        blocks.clear();
        blocks.resize(b.len() * width, [0.0; LANES]);
        for (to, from) in blocks.chunks_exact_mut(width).zip(a.chunks_exact(columns.max(1))) {
            to.as_flattened_mut()[..columns].copy_from_slice(from);
        }
        self.order.clear();
        self.order.extend(0..columns);
        // Where the compiler knows the width, it needs no loop over the blocks of a row.
        let rank = match width {
            1 => self.solve_rows(blocks.as_chunks_mut::<1>().0, b, zero),
            2 => self.solve_rows(blocks.as_chunks_mut::<2>().0, b, zero),
            3 => self.solve_rows(blocks.as_chunks_mut::<3>().0, b, zero),
            4 => self.solve_rows(blocks.as_chunks_mut::<4>().0, b, zero),
            5 => self.solve_rows(blocks.as_chunks_mut::<5>().0, b, zero),
            6 => self.solve_rows(blocks.as_chunks_mut::<6>().0, b, zero),
            7 => self.solve_rows(blocks.as_chunks_mut::<7>().0, b, zero),
            8 => self.solve_rows(blocks.as_chunks_mut::<8>().0, b, zero),
            _ => self.solve_rows(&mut blocks.chunks_exact_mut(width).collect::<Vec<_>>(), b, zero),
        };
        self.blocks = blocks;
        rank
    }

    fn solve_rows<R: AsRef<[Block]> + AsMut<[Block]>>(
        &mut self,
        rows: &mut [R],
        b: &mut [f64],
        zero: f64,
    ) -> usize {
        self.sizes.clear();
        self.sizes.extend(rows.iter().map(|row| largest(row.as_ref())));
        let rank = self.eliminate(rows, b, zero);
        self.x.clear();
        self.x.resize(self.order.len(), 0.0);
        for (r, row) in rows[..rank].iter().enumerate().rev() {
            let row = row.as_ref().as_flattened();
            let (own, later) = b[r..rank].split_at_mut(1);
            let solved = self.order[r + 1..rank].iter().zip(later);
            let known: f64 = solved.map(|(&column, x)| row[column] * *x).sum();
            own[0] = (own[0] - known) / row[self.order[r]];
            self.x[self.order[r]] = own[0];
        }
        rank
    }

    /// Brings the matrix to triangular form; returns the number of pivots.
    fn eliminate<R: AsRef<[Block]> + AsMut<[Block]>>(
        &mut self,
        rows: &mut [R],
        b: &mut [f64],
        zero: f64,
    ) -> usize {
        let scale = self.sizes.iter().fold(0.0, |most: f64, size| most.max(*size));
        let most = rows.len().min(self.order.len());
        for rank in 0..most {
            let (mut best, mut size) = (rank, self.sizes[rank]);
            for (r, &other) in (rank + 1..).zip(&self.sizes[rank + 1..]) {
                (best, size) = if other > size { (r, other) } else { (best, size) };
            }
            // Also ends the elimination if the entry is NaN.
            if size.is_nan() || size <= zero * scale {
                return rank;
            }
            if rank != best {
                self.sizes.swap(rank, best);
                b.swap(rank, best);
                rows.swap(rank, best);
            }
            let (done, below) = rows.split_at_mut(rank + 1);
            let pivot_row = done[rank].as_mut();
            let entries = pivot_row.as_flattened_mut();
            let place = self.order[rank..].iter().position(|&column| entries[column].abs() == size);
            self.order.swap(rank, rank + place.unwrap_or(0));
            let column = self.order[rank];
            // With 0 in the place of the pivot an entry that is 0 already stays so.
            let pivot = std::mem::replace(&mut entries[column], 0.0);
            let (solved, right) = b.split_at_mut(rank + 1);
            for ((row, right), size) in below.iter_mut().zip(right).zip(&mut self.sizes[rank + 1..]) {
                // A loop's equations are sparse: many rows have no part in the unknown at hand.
                let row = row.as_mut();
                let entry = std::mem::replace(&mut row.as_flattened_mut()[column], 0.0);
                if entry != 0.0 {
                    let factor = entry / pivot;
                    *size = subtract(row, factor, pivot_row);
                    *right -= factor * solved[rank];
                }
            }
            pivot_row.as_flattened_mut()[column] = pivot;
        }
        most
    }
}

/// Subtracts a multiple of another row; returns the size of the largest entry.
#[inline(always)]
fn subtract(row: &mut [Block], factor: f64, other: &[Block]) -> f64 {
    let mut most = [0.0; LANES];
    for (row, other) in row.iter_mut().zip(other) {
        for ((x, y), most) in row.iter_mut().zip(other).zip(&mut most) {
            *x -= factor * y;
            *most = larger(*most, *x);
        }
    }
    most.into_iter().fold(0.0, larger)
}

/// The larger size; what is not a number counts as 0. The comparison is one instruction, where `f64::max` is six.
#[inline(always)]
pub(super) fn larger(most: f64, x: f64) -> f64 {
    if x.abs() > most { x.abs() } else { most }
}

/// The size of the largest entry, several side by side.
#[inline(always)]
pub(super) fn largest(row: &[Block]) -> f64 {
    let mut most = [0.0; LANES];
    for block in row {
        for (most, x) in most.iter_mut().zip(block) {
            *most = larger(*most, *x);
        }
    }
    most.into_iter().fold(0.0, larger)
}

/// The determinant of an n x n matrix, row by row, by elimination with partial pivoting.
#[must_use]
pub fn determinant(mut a: Vec<f64>, n: usize) -> f64 {
    let mut product = 1.0;
    for c in 0..n {
        let by_size = |&i: &usize, &j: &usize| a[i * n + c].abs().total_cmp(&a[j * n + c].abs());
        let Some(best) = (c..n).max_by(by_size) else { break };
        if best != c {
            (0..n).for_each(|j| a.swap(c * n + j, best * n + j));
            product = -product;
        }
        let pivot = a[c * n + c];
        product *= pivot;
        if product == 0.0 {
            break;
        }
        for i in c + 1..n {
            let factor = a[i * n + c] / pivot;
            (c..n).for_each(|j| a[i * n + j] -= factor * a[c * n + j]);
        }
    }
    product
}

#[cfg(test)]
mod tests {
    use super::{determinant, solve};

    #[test]
    fn determinants_know_their_sign() {
        assert_eq!(determinant(vec![0.0, 2.0, 3.0, 1.0], 2), -6.0);
        assert_eq!(determinant(vec![1.0, 2.0, 2.0, 4.0], 2), 0.0);
        assert_eq!(determinant(vec![2.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 3.0, 0.0], 3), -6.0);
    }

    #[test]
    fn square_and_redundant_systems() {
        let (x, rank) = solve(&[0.0, 2.0, 3.0, 1.0], &mut [4.0, 5.0], 2);
        assert_eq!((x, rank), (vec![1.0, 2.0], 2));
        // The second equation repeats the first.
        let (x, rank) = solve(&[1.0, 1.0, 2.0, 2.0, 1.0, -1.0], &mut [3.0, 6.0, 1.0], 2);
        assert_eq!((x, rank), (vec![2.0, 1.0], 2));
        assert_eq!(solve(&[0.0; 4], &mut [0.0; 2], 2).1, 0);
    }

    #[test]
    fn the_rank_does_not_hang_on_the_scale() {
        for scale in [1e-9, 1.0, 1e9] {
            let rank = |last: f64| solve(&[1.0, 1.0, 1.0, last].map(|x| x * scale), &mut [0.0; 2], 2).1;
            assert_eq!([rank(1.0 + 1e-14), rank(1.0 + 1e-6)], [1, 2], "{scale}");
        }
    }
}
