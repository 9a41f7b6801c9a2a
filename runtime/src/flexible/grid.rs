//! Forces of springs and facets that form a grid: each node is read and written once, its neighbours stand beside it.
//!
//! In: where the nodes of a grid stand in the lists of a body ([`Grid`]), positions. Out: the sums of forces that the lists
//! give, number for number: a node's terms are added in their order, left, right, below, above, then its four cells. Rows
//! are computed side by side; a row wider than [`WIDTH`] goes in strips, whose borders are computed twice. Where there is no
//! spring or cell its force is 0.

use super::block;
use super::pressure::{self, PressureForm, Weights};
use crate::kernel::Kernel;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Columns from the first to the one before the last.
pub type Span = [usize; 2];

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

/// Springs of one direction, each at its tail; row after row of the grid, and [`WIDTH`] more.
#[derive(Clone, Copy, Debug)]
pub struct Family<'a, S> {
    /// K (N/m); 0 where there is no spring.
    pub stiffness: &'a [S],
    /// L (m).
    pub rest_length: &'a [S],
}

/// Nodes in rows and columns; all springs of the body join neighbours in a row (`right`) or a column (`up`).
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
    /// From a node to the next in its row.
    pub right: Family<'a, S>,
    /// From a node to the one above it in its column.
    pub up: Family<'a, S>,
    /// Facets of four corners, each at its first, row by row.
    pub cells: &'a [Span],
    /// Their number; they come first in the body's list.
    pub facets: usize,
    /// Whether a spring has a damper.
    pub is_damped: bool,
}

/// Adds the forces of a grid (N); returns whether a spring has run away, see [`pressure::STRETCH_LIMIT`].
#[derive(Debug)]
pub struct Weave<'a, S> {
    /// The grid.
    pub grid: &'a Grid<'a, S>,
    /// How pressure acts (Pa).
    pub pressure: Option<(PressureForm, S)>,
    /// Positions (m).
    pub pos: &'a [Vec3<S>],
    /// The sums.
    pub force: &'a mut [Vec3<S>],
}

/// Columns computed at a time: those that a strip owns, and one more on either side where there is one.
pub const WIDTH: usize = 32;
/// Lanes of a row; column i of a strip is lane i + 1, so that all of them have neighbours to read.
const ROOM: usize = WIDTH + 8;

/// Vectors of a row, component by component.
type Row<S> = [[S; ROOM]; 3];

impl<S: Scalar> Kernel for Weave<'_, S> {
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        let Weave { grid, pressure, pos, force } = self;
        let mut runaway = false;
        let mut first = 0;
        while first < grid.columns {
            let from = first.saturating_sub(1);
            let width = (grid.columns - from).min(WIDTH);
            let end = if from + width == grid.columns { grid.columns } else { from + width - 1 };
            runaway |= Strip { from, width, own: [first, end] }.add(grid, pressure, pos, force);
            first = end;
        }
        runaway
    }
}

/// Columns computed together.
struct Strip {
    /// The first.
    from: usize,
    /// How many.
    width: usize,
    /// The columns whose sums it writes.
    own: Span,
}

impl Strip {
    #[inline(always)]
    fn add<S: Scalar>(
        &self,
        grid: &Grid<S>,
        pressure: Option<(PressureForm, S)>,
        pos: &[Vec3<S>],
        force: &mut [Vec3<S>],
    ) -> bool {
        let mut runaway = false;
        let mut rows: [Row<S>; 2] = [[[S::ZERO; ROOM]; 3]; 2];
        let mut up: [Row<S>; 2] = rows;
        let mut cells: [[Row<S>; 4]; 2] = [[rows[0]; 4]; 2];
        let (mut sums, mut right) = (rows[0], rows[0]);
        let [mut here, mut above] = rows.each_mut();
        let [mut up, mut below] = up.each_mut();
        let [mut cells, mut cells_below] = cells.each_mut();
        self.read(grid, 0, pos, here);
        for row in 0..grid.rows {
            self.read(grid, row + 1, pos, above);
            self.read(grid, row, force, &mut sums);
            for lane in 0..WIDTH {
                set(&mut right, lane + 1, vec3::sub(get(here, lane + 2), get(here, lane + 1)));
            }
            runaway |= self.pull(&grid.right, grid.columns, row, &mut right);
            for lane in 0..WIDTH {
                set(up, lane + 1, vec3::sub(get(above, lane + 1), get(here, lane + 1)));
            }
            runaway |= self.pull(&grid.up, grid.columns, row, up);
            weave(&mut sums, &right, below, up);
            if let Some((form, pressure)) = pressure {
                let span = grid.cells.get(row).copied().unwrap_or_default();
                self.push((form, pressure), span, here, above, cells);
                fill(&mut sums, cells_below, cells);
            }
            self.write(grid, row, &sums, force);
            (here, above) = (above, here);
            (up, below) = (below, up);
            (cells, cells_below) = (cells_below, cells);
        }
        runaway
    }

    /// The runs of a row within some columns: lane of the first, number of the first, how many.
    fn runs<'a, S>(
        &self,
        grid: &Grid<'a, S>,
        row: usize,
        [from, end]: Span,
    ) -> impl Iterator<Item = [usize; 3]> + use<'a, S> {
        let first = self.from;
        let range = grid.starts.get(row).copied().zip(grid.starts.get(row + 1).copied());
        let runs = range.and_then(|(from, to)| grid.runs.get(from..to)).unwrap_or_default();
        runs.iter().map(move |run| {
            let start = run.column.max(from);
            let length = (run.column + run.length).min(end).saturating_sub(start);
            [start.saturating_sub(first) + 1, run.node + start - run.column, length]
        })
    }

    /// Vectors of the nodes of a row.
    #[inline(always)]
    fn read<S: Scalar>(&self, grid: &Grid<S>, row: usize, from: &[Vec3<S>], to: &mut Row<S>) {
        for [lane, node, length] in self.runs(grid, row, [self.from, self.from + self.width]) {
            let nodes = from.get(node..node + length).unwrap_or_default();
            let [x, y, z] = to.each_mut().map(|to| to.get_mut(lane..lane + length).unwrap_or_default());
            for (node, ((x, y), z)) in nodes.iter().zip(x.iter_mut().zip(y).zip(z)) {
                [*x, *y, *z] = *node;
            }
        }
    }

    /// Sums of the columns that the strip owns.
    #[inline(always)]
    fn write<S: Scalar>(&self, grid: &Grid<S>, row: usize, sums: &Row<S>, force: &mut [Vec3<S>]) {
        for [lane, node, length] in self.runs(grid, row, self.own) {
            let nodes = force.get_mut(node..node + length).unwrap_or_default();
            let [x, y, z] = sums.each_ref().map(|sum| sum.get(lane..lane + length).unwrap_or_default());
            for (node, ((x, y), z)) in nodes.iter_mut().zip(x.iter().zip(y).zip(z)) {
                *node = [*x, *y, *z];
            }
        }
    }

    /// Turns ways tail -> head (m) into elastic forces on the tails (N).
    #[inline(always)]
    fn pull<S: Scalar>(&self, family: &Family<S>, columns: usize, row: usize, way: &mut Row<S>) -> bool {
        let first = row * columns + self.from;
        let chunk = |list: &[S]| list.get(first..).and_then(|rest| rest.first_chunk::<WIDTH>()).copied();
        let (Some(stiffness), Some(rest_length)) = (chunk(family.stiffness), chunk(family.rest_length))
        else {
            return false;
        };
        let [x, y, z] = way.each_mut().map(|way| way.get_mut(1..=WIDTH).unwrap_or_default());
        block::pull([x, y, z], &stiffness, &rest_length)
    }

    /// Forces (N) on the corners of the cells between a row and the one above.
    #[inline(always)]
    fn push<S: Scalar>(
        &self,
        (form, pressure): (PressureForm, S),
        [from, to]: Span,
        here: &Row<S>,
        above: &Row<S>,
        cells: &mut [Row<S>; 4],
    ) {
        let mut pressures = [S::ZERO; WIDTH];
        let [from, to] = [from, to].map(|column| column.saturating_sub(self.from).min(WIDTH));
        pressures.get_mut(from..to).unwrap_or_default().fill(pressure);
        // One loop a form: a choice within would be made lane by lane.
        match form {
            PressureForm::Fan => share(pressure::fan_shares, &pressures, here, above, cells),
            _ => {
                let weights = Weights::of_quad(form);
                share(|corners| pressure::shares(weights, corners), &pressures, here, above, cells);
            }
        }
    }
}

/// Shares out the pressures of the cells between two rows.
#[inline(always)]
fn share<S: Scalar>(
    shares: impl Fn([Vec3<S>; 4]) -> [Vec3<S>; 4],
    pressures: &[S; WIDTH],
    here: &Row<S>,
    above: &Row<S>,
    [a, b, c, d]: &mut [Row<S>; 4],
) {
    for (lane, pressure) in pressures.iter().enumerate() {
        let (left, right) = (lane + 1, lane + 2);
        let shares = shares([get(here, left), get(here, right), get(above, right), get(above, left)]);
        let [on_a, on_b, on_c, on_d] = shares.map(|share| vec3::scale(share, *pressure));
        set(a, left, on_a);
        set(b, left, on_b);
        set(c, left, on_c);
        set(d, left, on_d);
    }
}

/// Adds the springs' forces to the sums: from the left and to the right, from below and upwards.
#[inline(always)]
fn weave<S: Scalar>(sums: &mut Row<S>, right: &Row<S>, below: &Row<S>, up: &Row<S>) {
    for (((sums, right), below), up) in sums.iter_mut().zip(right).zip(below).zip(up) {
        for left in 0..WIDTH {
            let here = left + 1;
            sums[here] = sums[here] - right[left] + right[here] - below[here] + up[here];
        }
    }
}

/// Adds the pressure's forces to the sums: of the cells below (left, right) and above (left, right).
#[inline(always)]
fn fill<S: Scalar>(sums: &mut Row<S>, [_, _, c, d]: &[Row<S>; 4], [a, b, _, _]: &[Row<S>; 4]) {
    for ((((sums, a), b), c), d) in sums.iter_mut().zip(a).zip(b).zip(c).zip(d) {
        for left in 0..WIDTH {
            let here = left + 1;
            sums[here] = sums[here] + c[left] + d[here] + b[left] + a[here];
        }
    }
}

#[inline(always)]
fn get<S: Scalar>([x, y, z]: &Row<S>, lane: usize) -> Vec3<S> {
    [x[lane], y[lane], z[lane]]
}

#[inline(always)]
fn set<S: Scalar>([x, y, z]: &mut Row<S>, lane: usize, value: Vec3<S>) {
    [x[lane], y[lane], z[lane]] = value;
}
