//! Volume under the cells of a grid, row by row.
//!
//! In: a grid, positions, the sum over the facets before its own. Out: the sum over these and its cells, in the order
//! of the list and so with its bits: products of a row are computed side by side and added one after the other.

use super::elastic::corners;
use super::layout::{Grid, WIDTH};
use super::strip::{FIRST, Row, Strip};
use crate::flexible::pressure;
use crate::kernel::Kernel;
use crate::real::Scalar;
use crate::vec3::Vec3;

/// Adds 24 times the volume between each cell and the origin to `sum` (m^3).
#[derive(Debug)]
pub struct CellVolume<'a, S> {
    /// The grid.
    pub grid: &'a Grid<'a, S>,
    /// Positions (m).
    pub pos: &'a [Vec3<S>],
    /// The sum so far.
    pub sum: S,
}

impl<S: Scalar> Kernel for CellVolume<'_, S> {
    type Output = S;

    #[inline(always)]
    fn run(self) -> S {
        let CellVolume { grid, pos, mut sum } = self;
        let (mut here, mut above, mut products) = (Row::zero(), Row::zero(), [S::ZERO; WIDTH]);
        for row in 0..grid.rows.saturating_sub(1) {
            for strip in Strip::all(grid.columns) {
                let Some(exists) = strip.part(grid.cells, grid, row) else { continue };
                strip.read(grid, row, pos, &mut here);
                strip.read(grid, row + 1, pos, &mut above);
                for (lane, product) in products.iter_mut().enumerate() {
                    let volume = pressure::quad_volume(corners([&here, &above], FIRST + lane));
                    *product = if exists[lane] > S::ZERO { volume } else { S::ZERO };
                }
                let [from, end] = strip.own.map(|column| column - strip.from);
                let own = products.get(from..end).unwrap_or_default();
                sum = own.iter().fold(sum, |sum, product| sum + *product);
            }
        }
        sum
    }
}
