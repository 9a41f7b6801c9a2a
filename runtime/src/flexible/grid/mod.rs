//! Forces of springs and facets that form a grid: each node is read and written once, its neighbours stand beside it.
//!
//! In: where the nodes of a grid stand in the lists of a body ([`Grid`]), positions. Out: the sums of forces that the lists
//! give, number for number: a node's terms are added in their order, left, right, below, above, then its four cells;
//! [`weave`] has the forces of positions, [`damp`] those of speeds, [`mean`] the means over a step. Rows are computed side by side; a row wider than
//! [`WIDTH`] goes in strips, whose borders are computed twice. Where there is no spring or cell its force is 0.

pub mod damp;
pub mod mean;
pub mod weave;

use crate::ode::nodes::copy;
use crate::real::Scalar;
use crate::vec3::Vec3;
use core::iter;
use core::ops::Range;
pub use damp::Damp;
pub use mean::Mean;
pub use weave::Weave;

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
    let starts = iter::once(0).chain(grids.iter().map(move |grid| range(grid)[1]));
    let ends = grids.iter().map(move |grid| range(grid)[0]).chain(iter::once(count));
    starts.zip(ends).map(|(from, to)| from..to)
}

/// Columns computed at a time: those that a strip owns, and one more on either side where there is one.
pub const WIDTH: usize = 32;
/// Numbers of a list for each row of a grid: its columns, and 0 beyond them as far as the last strip reaches.
#[must_use]
pub const fn pitch(columns: usize) -> usize {
    // Two neighbouring strips share two columns.
    columns.saturating_sub(WIDTH).div_ceil(WIDTH - 2) * (WIDTH - 2) + WIDTH
}

/// A run of so many nodes or more is handled as a whole.
const LONG: usize = 8;
/// Lane of a strip's first column: where a register's worth of numbers begins, with a lane to its left.
const FIRST: usize = 16;

/// Lanes of a row: a run may begin in any column and is read as if it were as wide as a strip.
const ROOM: usize = FIRST + 2 * WIDTH;

/// Vectors of a row, component by component.
#[derive(Clone, Copy)]
#[repr(align(64))]
struct Row<S>([[S; ROOM]; 3]);

impl<S: Scalar> Row<S> {
    fn zero() -> Self {
        Row([[S::ZERO; ROOM]; 3])
    }

    #[inline(always)]
    fn lanes_mut(&mut self, first: usize) -> Option<[&mut [S; WIDTH]; 3]> {
        let Row([x, y, z]) = self;
        let from = |lanes| <[S]>::first_chunk_mut(<[S]>::get_mut(lanes, first..)?);
        Some([from(x)?, from(y)?, from(z)?])
    }

    #[inline(always)]
    fn get(&self, lane: usize) -> Vec3<S> {
        let Row([x, y, z]) = self;
        [x[lane], y[lane], z[lane]]
    }

    #[inline(always)]
    fn set(&mut self, lane: usize, value: Vec3<S>) {
        let Row([x, y, z]) = self;
        [x[lane], y[lane], z[lane]] = value;
    }
}

/// Columns computed together.
struct Strip {
    /// The first.
    from: usize,
    /// How many.
    width: usize,
    /// The columns whose sums it writes, from the first to the one before the last.
    own: [usize; 2],
}

impl Strip {
    /// Those of a grid, from left to right.
    #[inline(always)]
    fn all(columns: usize) -> impl Iterator<Item = Strip> {
        let from = move |first: usize| {
            let from = first.saturating_sub(1);
            let width = (columns - from).min(WIDTH);
            let end = if from + width == columns { columns } else { from + width - 1 };
            Strip { from, width, own: [first, end] }
        };
        let next = move |last: &Strip| (last.own[1] < columns).then(|| from(last.own[1]));
        iter::successors((columns > 0).then(|| from(0)), next)
    }

    /// The runs of a row within some columns: column of the first less the strip's, number of the first, how many.
    #[inline(always)]
    fn runs<'a, S>(
        &self,
        grid: &Grid<'a, S>,
        row: usize,
        [from, end]: [usize; 2],
    ) -> impl Iterator<Item = [usize; 3]> + use<'a, S> {
        let first = self.from;
        let range = grid.starts.get(row).copied().zip(grid.starts.get(row + 1).copied());
        let runs = range.and_then(|(from, to)| grid.runs.get(from..to)).unwrap_or_default();
        runs.iter().map(move |run| {
            let start = run.column.max(from);
            let length = (run.column + run.length).min(end).saturating_sub(start);
            [start.saturating_sub(first), run.node + start - run.column, length]
        })
    }

    /// Vectors of the nodes of a row. A long run is taken apart [`WIDTH`] nodes at once: lanes beyond its end hold nodes
    /// that follow in the lists, until the next run comes.
    #[inline(always)]
    fn read<S: Scalar>(&self, grid: &Grid<S>, row: usize, from: &[Vec3<S>], to: &mut Row<S>) {
        for [column, node, length] in self.runs(grid, row, [self.from, self.from + self.width]) {
            let rest = from.get(node..).unwrap_or_default();
            match (rest.first_chunk::<WIDTH>(), to.lanes_mut(FIRST + column)) {
                (Some(nodes), Some([x, y, z])) if length >= LONG => {
                    for lane in 0..WIDTH {
                        [x[lane], y[lane], z[lane]] = nodes[lane];
                    }
                }
                _ => {
                    for (lane, node) in rest.iter().enumerate().take(length) {
                        to.set((FIRST + column + lane) % ROOM, *node);
                    }
                }
            }
        }
    }

    /// Sums of the columns that the strip owns.
    #[inline(always)]
    fn write<S: Scalar>(&self, grid: &Grid<S>, row: usize, sums: &[Vec3<S>; WIDTH], force: &mut [Vec3<S>]) {
        for [column, node, length] in self.runs(grid, row, self.own) {
            let place = force.get_mut(node..node + length).unwrap_or_default();
            let nodes = sums.get(column..column + length).unwrap_or_default();
            if length < LONG {
                place.iter_mut().zip(nodes).for_each(|(place, node)| *place = *node);
            } else {
                copy(place, nodes);
            }
        }
    }

    /// The strip's part of a list with a number for each place of the grid.
    #[inline(always)]
    fn part<'a, S>(&self, list: &'a [S], grid: &Grid<S>, row: usize) -> Option<&'a [S; WIDTH]> {
        list.get(row * pitch(grid.columns) + self.from..)?.first_chunk()
    }
}
