//! Strips of columns that are computed together: their nodes are read into rows, their sums written back.

use super::layout::{Grid, WIDTH, pitch};
use crate::ode::nodes::copy;
use crate::real::Scalar;
use crate::vec3::Vec3;
use core::iter;

/// A run of so many nodes or more is handled as a whole.
const LONG: usize = 8;
/// Lane of a strip's first column: where a register's worth of numbers begins, with a lane to its left.
pub(super) const FIRST: usize = 16;

/// Lanes of a row: a run may begin in any column and is read as if it were as wide as a strip.
const ROOM: usize = FIRST + 2 * WIDTH;

/// Vectors of a row, component by component.
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
    /// The first.
    pub(super) from: usize,
    /// How many.
    pub(super) width: usize,
    /// The columns whose sums it writes, from the first to the one before the last.
    pub(super) own: [usize; 2],
}

impl Strip {
    /// Those of a grid, from left to right.
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

    /// The runs of a row within some columns: column of the first less the strip's, number of the first, how many.
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

    /// Vectors of the nodes of a row. A long run is taken apart [`WIDTH`] nodes at once: lanes beyond its end hold nodes
    /// that follow in the lists, until the next run comes.
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

    /// Sums of the columns that the strip owns.
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

    /// The strip's part of a list with a number for each place of the grid.
    #[inline(always)]
    pub(super) fn part<'a, S>(&self, list: &'a [S], grid: &Grid<S>, row: usize) -> Option<&'a [S; WIDTH]> {
        list.get(row * pitch(grid.columns) + self.from..)?.first_chunk()
    }
}
