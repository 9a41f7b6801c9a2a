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
            for c in rank..columns {
                let size = a[r * columns + c].abs();
                if size > best {
                    (best, at) = (size, (r, c));
                }
            }
        }
        // Written so that a not-a-number ends the elimination too.
        if best.is_nan() || best <= RANK * scale {
            break;
        }
        swap(&mut a, &mut b, &mut order, columns, rank, at);
        for r in rank + 1..rows {
            let factor = a[r * columns + rank] / a[rank * columns + rank];
            for c in rank..columns {
                a[r * columns + c] -= factor * a[rank * columns + c];
            }
            b[r] -= factor * b[rank];
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
    for c in 0..columns {
        a.swap(rank * columns + c, row * columns + c);
    }
    for r in 0..b.len() {
        a.swap(r * columns + rank, r * columns + column);
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
