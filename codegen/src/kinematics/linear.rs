//! A small dense solver for derive time: Gaussian elimination with full pivoting.
//!
//! A x = b, rows x columns, row-major. Rank-revealing: pivots below a relative threshold end the
//! elimination and their unknowns stay 0, so consistent redundant equations do no harm.

/// A pivot below this part of the largest entry counts as zero.
const RANK: f64 = 1e-10;

/// A basic solution of A x = b and the rank of A.
#[must_use]
pub fn solve(mut a: Vec<f64>, mut b: Vec<f64>, columns: usize) -> (Vec<f64>, usize) {
    let rows = b.len();
    let mut x = vec![0.0; columns];
    let scale = a.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let mut order: Vec<usize> = (0..columns).collect();
    let mut rank = 0;
    while rank < rows.min(columns) {
        let (mut best, mut at) = (0.0, (rank, rank));
        for r in rank..rows {
            for (c, entry) in a[r * columns + rank..(r + 1) * columns].iter().enumerate() {
                if entry.abs() > best {
                    (best, at) = (entry.abs(), (r, rank + c));
                }
            }
        }
        // Written so that a not-a-number ends the elimination too.
        if best.is_nan() || best <= RANK * scale {
            break;
        }
        swap(&mut a, &mut b, &mut order, columns, rank, at);
        let (done, below) = a.split_at_mut((rank + 1) * columns);
        let pivot_row = &done[rank * columns + rank..];
        for (r, row) in below.chunks_exact_mut(columns).enumerate() {
            let row = &mut row[rank..];
            // A loop's equations are sparse: most rows have no part in the unknown at hand.
            if row[0] != 0.0 {
                let factor = row[0] / pivot_row[0];
                row.iter_mut().zip(pivot_row).for_each(|(x, p)| *x -= factor * p);
                b[rank + 1 + r] -= factor * b[rank];
            }
        }
        rank += 1;
    }
    for r in (0..rank).rev() {
        let known: f64 = (r + 1..rank).map(|c| a[r * columns + c] * x[order[c]]).sum();
        x[order[r]] = (b[r] - known) / a[r * columns + r];
    }
    (x, rank)
}

/// Brings the entry at `at` to the diagonal place `rank`.
fn swap(
    a: &mut [f64],
    b: &mut [f64],
    order: &mut [usize],
    columns: usize,
    rank: usize,
    (row, column): (usize, usize),
) {
    b.swap(rank, row);
    order.swap(rank, column);
    let (above, below) = a.split_at_mut(row * columns);
    if rank != row {
        above[rank * columns..(rank + 1) * columns].swap_with_slice(&mut below[..columns]);
    }
    if rank != column {
        a.chunks_exact_mut(columns).for_each(|entries| entries.swap(rank, column));
    }
}

#[cfg(test)]
mod tests {
    use super::solve;

    #[test]
    fn square_and_redundant_systems() {
        let (x, rank) = solve(vec![0.0, 2.0, 3.0, 1.0], vec![4.0, 5.0], 2);
        assert_eq!((x, rank), (vec![1.0, 2.0], 2));
        // The second equation repeats the first.
        let (x, rank) = solve(vec![1.0, 1.0, 2.0, 2.0, 1.0, -1.0], vec![3.0, 6.0, 1.0], 2);
        assert_eq!((x, rank), (vec![2.0, 1.0], 2));
        assert_eq!(solve(vec![0.0; 4], vec![0.0; 2], 2).1, 0);
    }
}
