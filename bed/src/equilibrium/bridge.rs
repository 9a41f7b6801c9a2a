//! Contact forces between sheets in a Newton step: the forces mu of their springs are unknowns beside the segments'
//! steps y.
//!
//! In: the contributions of each tile. Out: what they add to the segments' rows, and mu. With W the directions of the
//! springs, x = -K^-1 g - Z y - K^-1 W mu and W' x = mu/k give R mu = -W' K^-1 g - Q' y, where R = 1/k + W' K^-1 W and
//! Q = B' K^-1 W; the segments' matrix grows by Q R^-1 Q' (Schur complement).

use super::stiffness::product;
use super::tile::{Crossing, Eliminated};
use crate::band::Band;
use std::collections::BTreeMap;

/// The springs between sheets, and R factored.
pub struct Bridge {
    /// Numbers of the springs, ascending.
    numbers: Vec<usize>,
    /// Rows of Q', by spring.
    coupled: Vec<Vec<f64>>,
    /// R^-1 Q', by row of the segments.
    solved: Vec<Vec<f64>>,
    /// R^-1 (-W' K^-1 g).
    alone: Vec<f64>,
}

impl Bridge {
    /// The springs of all tiles; `size` is the number of rows of the segments.
    pub fn new(tiles: &[Option<Eliminated>], size: usize) -> Bridge {
        // Each spring is listed by both of its tiles.
        let crossings = tiles.iter().flatten().flat_map(|t| &t.crossings);
        let springs: BTreeMap<usize, f64> = crossings.map(|c| (c.number, c.stiffness)).collect();
        let numbers: Vec<usize> = springs.keys().copied().collect();
        let place = |c: &Crossing| numbers.partition_point(|n| *n < c.number);
        let count = numbers.len();
        let mut matrix = Band::new(count, count);
        springs.values().enumerate().for_each(|(i, stiffness)| matrix.add(i, i, 1.0 / stiffness));
        let (mut coupled, mut alone) = (vec![vec![0.0; size]; count], vec![0.0; count]);
        for tile in tiles.iter().flatten() {
            for a in &tile.crossings {
                let i = place(a);
                alone[i] -= a.along(&tile.solved);
                tile.crossings.iter().for_each(|b| matrix.add(i, place(b), a.along(&b.solved)));
                for coupling in &tile.couplings {
                    let rows = &mut coupled[i][6 * coupling.segment..6 * coupling.segment + 6];
                    for (column, x) in coupling.columns.iter().zip(&a.solved) {
                        rows.iter_mut().zip(column).for_each(|(row, c)| *row += c * x);
                    }
                }
            }
        }
        let mut solved = vec![vec![0.0; count]; size];
        // K^-1 is positive definite, hence R is too.
        if let Some(factor) = matrix.factor().filter(|_| count > 0) {
            factor.solve(&mut alone);
            for (row, own) in solved.iter_mut().enumerate() {
                own.iter_mut().zip(&coupled).for_each(|(x, q)| *x = q[row]);
                factor.solve(own);
            }
        }
        Bridge { numbers, coupled, solved, alone }
    }

    /// Adds Q R^-1 Q' to the segments' matrix.
    pub fn add_to(&self, matrix: &mut [f64]) {
        let size = self.solved.len();
        for (i, q) in self.coupled.iter().enumerate() {
            for row in (0..size).filter(|row| q[*row] != 0.0) {
                (0..size).for_each(|j| matrix[row * size + j] += q[row] * self.solved[j][i]);
            }
        }
    }

    /// Q R^-1 (-W' K^-1 g), to be subtracted from the right-hand side of a segment's row.
    pub fn right(&self, row: usize) -> f64 {
        self.coupled.iter().zip(&self.alone).map(|(q, mu)| q[row] * mu).sum()
    }

    /// mu of a spring, from the segments' steps.
    pub fn force(&self, number: usize, segments: &[f64]) -> f64 {
        let i = self.numbers.partition_point(|n| *n < number);
        let by_ways: Vec<f64> = self.solved.iter().map(|row| row[i]).collect();
        self.alone[i] - product(&by_ways, segments)
    }
}
