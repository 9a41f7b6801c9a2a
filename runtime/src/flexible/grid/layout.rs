//! Where the nodes, springs and cells of a grid stand in the lists of a body, and its numbers row by row.

use core::mem;
use core::ops::Range;

/// Nodes that stand one after the other in a row and in the lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Run {
    /// Column of the first.
    pub column: usize,
    /// Number of the first in the lists.
    pub node: usize,
    /// How many.
    pub length: usize,
}

/// Springs of one direction, each at its tail; [`pitch`] numbers for each row of the grid.
#[derive(Clone, Copy, Debug)]
pub struct Family<'a, S> {
    /// K (N/m); 0 where there is no spring.
    pub stiffness: &'a [S],
    /// L (m).
    pub rest_length: &'a [S],
    /// C (N s/m); no numbers where no spring has a damper.
    pub damping: &'a [S],
}

/// Nodes of a body in rows and columns, and the springs between neighbours in a row (`right`) or a column (`up`). Nothing
/// else of the body meets these nodes, but facets that come later in the lists.
#[derive(Clone, Copy, Debug)]
pub struct Grid<'a, S> {
    /// Length of a row.
    pub columns: usize,
    /// Number of rows.
    pub rows: usize,
    /// Where the nodes are, row by row.
    pub runs: &'a [Run],
    /// Where the runs of each row begin, and at last their number.
    pub starts: &'a [usize],
    /// Masses of the nodes (kg); [`pitch`] numbers for each row, 0 where there is none.
    pub mass: &'a [S],
    /// From a node to the next in its row.
    pub right: Family<'a, S>,
    /// From a node to the one above it in its column.
    pub up: Family<'a, S>,
    /// Facets of four corners, each at its first: 1, or 0 where there is none; [`pitch`] numbers for each row.
    pub cells: &'a [S],
    /// First of its nodes in the body's list, and the one after its last; so for springs and facets, which go row by row.
    pub nodes: [usize; 2],
    /// As for nodes.
    pub springs: [usize; 2],
    /// As for nodes.
    pub facets: [usize; 2],
}

impl<S> Grid<'_, S> {
    /// Whether a spring has a damper.
    #[must_use]
    pub fn is_damped(&self) -> bool {
        !self.right.damping.is_empty()
    }
}

/// What no grid stands for of a list of so many, part by part; grids come in the order of their ranges.
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
/// Numbers of a list for each row of a grid: its columns, and 0 beyond them as far as the last strip reaches.
#[inline]
#[must_use]
pub const fn pitch(columns: usize) -> usize {
    // Two neighbouring strips share two columns.
    columns.saturating_sub(WIDTH).div_ceil(WIDTH - 2) * (WIDTH - 2) + WIDTH
}
