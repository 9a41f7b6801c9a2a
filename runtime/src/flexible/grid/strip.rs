//! Strips of columns that are computed together: reads their nodes into rows and writes their sums back.

use super::layout::{Grid, WIDTH, pitch};
use crate::ode::nodes::copy;
use crate::real::Scalar;
use crate::vec3::Vec3;
use core::iter;

/// Runs of at least this many nodes are copied as a whole.
const LONG: usize = 8;
/// Lane of a strip's first column: aligned to a vector register, with lanes to its left.
pub(super) const FIRST: usize = 16;

/// Lanes of a row: a run may begin in any column and is read as if it were as wide as a strip.
const ROOM: usize = FIRST + 2 * WIDTH;

/// Vectors of a row, one array per component.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub(super) struct Row<S>(pub(super) [[S; ROOM]; 3]);

impl<S: Scalar> Row<S> {
    pub(super) fn zero() -> Self {
        Row([[S::ZERO; ROOM]; 3])
    }

    #[inline(always)]
    pub(super) fn lanes_mut(&mut self, first: usize) -> Option<[&mut [S; WIDTH]; 3]> {
        let Row([x, y, z]) = self;
        let from = |lanes| <[S]>::first_chunk_mut(<[S]>::get_mut(lanes, first..)?);
        Some([from(x)?, from(y)?, from(z)?])
    }

    #[inline(always)]
    pub(super) fn get(&self, lane: usize) -> Vec3<S> {
        let Row([x, y, z]) = self;
        [x[lane], y[lane], z[lane]]
    }

    #[inline(always)]
    pub(super) fn set(&mut self, lane: usize, value: Vec3<S>) {
        let Row([x, y, z]) = self;
        [x[lane], y[lane], z[lane]] = value;
    }
}

/// Columns computed together.
pub(super) struct Strip {
    /// First column.
    pub(super) from: usize,
    /// Number of columns.
    pub(super) width: usize,
    /// The columns whose sums it writes, from the first to the one after the last.
    pub(super) own: [usize; 2],
}

impl Strip {
    /// The strips of a grid, from left to right.
    #[inline(always)]
    pub(super) fn all(columns: usize) -> impl Iterator<Item = Strip> {
        let from = move |first: usize| {
            let from = first.saturating_sub(1);
            let width = (columns - from).min(WIDTH);
            let end = if from + width == columns { columns } else { from + width - 1 };
            Strip { from, width, own: [first, end] }
        };
        let next = move |last: &Strip| (last.own[1] < columns).then(|| from(last.own[1]));
        iter::successors((columns > 0).then(|| from(0)), next)
    }

    /// The runs of a row within a range of columns: (column of the first node less the strip's first, index of the
    /// first node, length).
    #[inline(always)]
    pub(super) fn runs<'a, S>(
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

    /// Reads the vectors of a row's nodes. A long run is read [`WIDTH`] nodes at once: lanes beyond its end hold the
    /// nodes that follow in the lists, until the next run overwrites them.
    #[inline(always)]
    pub(super) fn read<S: Scalar>(&self, grid: &Grid<S>, row: usize, from: &[Vec3<S>], to: &mut Row<S>) {
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

    /// Writes the sums of the columns that the strip owns.
    #[inline(always)]
    pub(super) fn write<S: Scalar>(
        &self,
        grid: &Grid<S>,
        row: usize,
        sums: &[Vec3<S>; WIDTH],
        force: &mut [Vec3<S>],
    ) {
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

    /// The strip's part of a list with one number per place of the grid.
    #[inline(always)]
    pub(super) fn part<'a, S>(&self, list: &'a [S], grid: &Grid<S>, row: usize) -> Option<&'a [S; WIDTH]> {
        list.get(row * pitch(grid.columns) + self.from..)?.first_chunk()
    }
}
