//! Layout of a grid: where its nodes, springs and cells are in the lists of a body, and its numbers row by row.

use core::mem;
use core::ops::Range;

/// Nodes that are consecutive both in a row and in the lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Run {
    /// Column of the first.
    pub column: usize,
    /// Number of the first in the lists.
    pub node: usize,
    /// How many.
    pub length: usize,
}

/// Springs of one direction, each stored at its tail; [`pitch`] numbers per row of the grid.
#[derive(Clone, Copy, Debug)]
pub struct Family<'a, S> {
    /// K (N/m); 0 where there is no spring.
    pub stiffness: &'a [S],
    /// L (m).
    pub rest_length: &'a [S],
    /// C (N s/m); empty if no spring has a damper.
    pub damping: &'a [S],
}

/// Nodes of a body in rows and columns, and the springs between neighbours in a row (`right`) or a column (`up`). No
/// other element of the body touches these nodes, except facets that come later in the lists.
#[derive(Clone, Copy, Debug)]
pub struct Grid<'a, S> {
    /// Length of a row.
    pub columns: usize,
    /// Number of rows.
    pub rows: usize,
    /// Runs of nodes, row by row.
    pub runs: &'a [Run],
    /// Index of the first run of each row, and finally the number of runs.
    pub starts: &'a [usize],
    /// Masses of the nodes (kg); [`pitch`] numbers per row, 0 where there is no node.
    pub mass: &'a [S],
    /// From a node to the next in its row.
    pub right: Family<'a, S>,
    /// From a node to the one above it in its column.
    pub up: Family<'a, S>,
    /// 1 for each four-cornered facet, stored at its first corner, 0 where there is none; [`pitch`] numbers per row.
    pub cells: &'a [S],
    /// First of its nodes in the body's list and the one after its last; springs and facets likewise, all ordered row
    /// by row.
    pub nodes: [usize; 2],
    /// As for `nodes`.
    pub springs: [usize; 2],
    /// As for `nodes`.
    pub facets: [usize; 2],
}

impl<S> Grid<'_, S> {
    /// Whether any spring has a damper.
    #[must_use]
    pub fn is_damped(&self) -> bool {
        !self.right.damping.is_empty()
    }
}

/// The parts of a list of `count` entries that no grid covers, range by range; grids come in the order of their ranges.
pub fn beside<'g, S>(
    grids: &'g [Grid<'_, S>],
    range: impl Fn(&Grid<'_, S>) -> [usize; 2] + Copy + 'g,
    count: usize,
) -> impl Iterator<Item = Range<usize>> + 'g {
    let mut from = 0;
    (0..=grids.len()).map(move |i| {
        let [to, next] = grids.get(i).map_or([count; 2], range);
        mem::replace(&mut from, next)..to
    })
}

/// Columns computed at a time: those that a strip owns, and one more on either side where there is one.
pub const WIDTH: usize = 32;
/// Numbers per row of a grid in a list: one per column, padded with 0 to where the last strip ends.
#[inline]
#[must_use]
pub const fn pitch(columns: usize) -> usize {
    // Two neighbouring strips share two columns.
    columns.saturating_sub(WIDTH).div_ceil(WIDTH - 2) * (WIDTH - 2) + WIDTH
}
