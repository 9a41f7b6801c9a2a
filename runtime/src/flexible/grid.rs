//! Forces of springs and facets that form a grid: each node is read and written once, its neighbours stand beside it.
//!
//! In: where the nodes of a grid stand in the lists of a body ([`Grid`]), positions. Out: the sums of forces that the lists
//! give, number for number: a node's terms are added in their order, left, right, below, above, then its four cells. Rows
//! are computed side by side; a row wider than [`WIDTH`] goes in strips, whose borders are computed twice. Where there is no
//! spring or cell its force is 0.

use super::pressure::{self, PressureForm, Weights};
use crate::kernel::Kernel;
use crate::ode::nodes::copy;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

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
}

/// All nodes of a body in rows and columns; all springs of the body join neighbours in a row (`right`) or a column (`up`).
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
    /// Their number; they come first in the body's list, row by row.
    pub facets: usize,
    /// Whether a spring has a damper.
    pub is_damped: bool,
}

/// Writes the forces on the nodes of a grid (N), their weight among them; returns whether a spring has run away, see [`pressure::STRETCH_LIMIT`].
#[derive(Debug)]
pub struct Weave<'a, S> {
    /// The grid.
    pub grid: &'a Grid<'a, S>,
    /// How pressure acts (Pa).
    pub pressure: Option<(PressureForm, S)>,
    /// Positions (m).
    pub pos: &'a [Vec3<S>],
    /// Acceleration of gravity (m/s^2).
    pub gravity: Vec3<S>,
    /// The sums.
    pub force: &'a mut [Vec3<S>],
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

/// A row of nodes as its forces are computed, and what the row above needs of it.
struct Line<S> {
    /// Positions (m).
    nodes: Row<S>,
    /// Forces on the tails of the springs to the right (N).
    right: Row<S>,
    /// Forces on the tails of the springs upwards (N).
    up: Row<S>,
    /// Forces on the corners of the cells between this row and the one above (N).
    cells: [Row<S>; 4],
    /// Forces on the nodes (N).
    sums: [Vec3<S>; WIDTH],
}

impl<S: Scalar> Line<S> {
    fn zero() -> Self {
        let row = Row::zero();
        Line { nodes: row, right: row, up: row, cells: [row; 4], sums: [[S::ZERO; 3]; WIDTH] }
    }
}

impl<S: Scalar> Kernel for Weave<'_, S> {
    type Output = bool;

    #[inline(always)]
    fn run(mut self) -> bool {
        let (mut runaway, mut first) = (false, 0);
        while first < self.grid.columns {
            let from = first.saturating_sub(1);
            let width = (self.grid.columns - from).min(WIDTH);
            let end = if from + width == self.grid.columns { self.grid.columns } else { from + width - 1 };
            let strip = Strip { from, width, own: [first, end] };
            let [mut even, mut odd] = [Line::zero(), Line::zero()];
            strip.read(self.grid, 0, self.pos, &mut even.nodes);
            // Two rows at a time, so that each has a memory of its own; one beyond the last has neither springs nor nodes.
            for row in (0..=self.grid.rows).step_by(2) {
                runaway |= self.row(&strip, row, &mut even, &mut odd);
                runaway |= self.row(&strip, row + 1, &mut odd, &mut even);
            }
            first = end;
        }
        runaway
    }
}

impl<S: Scalar> Weave<'_, S> {
    /// The forces on the nodes of a row; `next` holds what the row below has left and takes the nodes of the row above. The
    /// sums of the row below are written: those just computed the processor would have to wait for.
    #[inline(always)]
    fn row(&mut self, strip: &Strip, row: usize, line: &mut Line<S>, next: &mut Line<S>) -> bool {
        let grid = self.grid;
        strip.read(grid, row + 1, self.pos, &mut next.nodes);
        let part = |list| strip.part(list, grid, row);
        let mut runaway = false;
        if let (Some(stiffness), Some(rest_length)) =
            (part(grid.right.stiffness), part(grid.right.rest_length))
        {
            runaway |= pull(stiffness, rest_length, [&line.nodes, &line.nodes], 1, &mut line.right);
        }
        if let (Some((form, pressure)), Some(exists)) = (self.pressure, part(grid.cells)) {
            push(form, exists, pressure, [&line.nodes, &next.nodes], &mut line.cells);
        }
        if let (Some(stiffness), Some(rest_length)) = (part(grid.up.stiffness), part(grid.up.rest_length)) {
            runaway |= pull(stiffness, rest_length, [&line.nodes, &next.nodes], 0, &mut line.up);
        }
        if let Some(below) = row.checked_sub(1) {
            strip.write(grid, below, &next.sums, self.force);
        }
        if let Some(mass) = part(grid.mass) {
            match self.pressure {
                Some(_) => sum::<S, true>(self.gravity, mass, line, next),
                None => sum::<S, false>(self.gravity, mass, line, next),
            }
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
    /// The columns whose sums it writes, from the first to the one before the last.
    own: [usize; 2],
}

impl Strip {
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

/// Elastic forces (N) on the tails of a row's springs, which join a column of one row to one `further` of another.
#[inline(always)]
fn pull<S: Scalar>(
    stiffness: &[S; WIDTH],
    rest_length: &[S; WIDTH],
    [tails, heads]: [&Row<S>; 2],
    further: usize,
    pulls: &mut Row<S>,
) -> bool {
    // A number as wide as a lane: a truth value would be taken out of its register.
    let mut runaway = 0_u32;
    for lane in 0..WIDTH {
        let (tail, head) = (tails.get(FIRST + lane), heads.get(FIRST + lane + further));
        let (direction, length) = vec3::direction(vec3::sub(head, tail));
        let tension = stiffness[lane] * (length - rest_length[lane]);
        pulls.set(FIRST + lane, vec3::scale(direction, tension));
        runaway |= u32::from(pressure::is_runaway(rest_length[lane], length));
    }
    runaway > 0
}

/// Forces (N) on the corners of the cells between two rows. One loop a form: a choice within would be made lane by lane.
#[inline(always)]
fn push<S: Scalar>(
    form: PressureForm,
    exists: &[S; WIDTH],
    pressure: S,
    rows: [&Row<S>; 2],
    cells: &mut [Row<S>; 4],
) {
    match form {
        PressureForm::Fan => share(pressure::fan_shares, exists, pressure, rows, cells),
        _ => {
            let weights = Weights::of_quad(form);
            share(|corners| pressure::shares(weights, corners), exists, pressure, rows, cells);
        }
    }
}

/// Shares out the pressure on the cells between two rows.
#[inline(always)]
fn share<S: Scalar>(
    shares: impl Fn([Vec3<S>; 4]) -> [Vec3<S>; 4],
    exists: &[S; WIDTH],
    pressure: S,
    [here, above]: [&Row<S>; 2],
    [a, b, c, d]: &mut [Row<S>; 4],
) {
    // The force of a cell that does not exist is 0.
    let pressures = exists.map(|exists| exists * pressure);
    for left in FIRST..FIRST + WIDTH {
        let right = left + 1;
        let shares = shares([here.get(left), here.get(right), above.get(right), above.get(left)]);
        let pressure = pressures[left - FIRST];
        let [on_a, on_b, on_c, on_d] = shares.map(|share| vec3::scale(share, pressure));
        a.set(left, on_a);
        b.set(left, on_b);
        c.set(left, on_c);
        d.set(left, on_d);
    }
}

/// Sums on the nodes of a row: weight, springs from the left and to the right, from below and upwards, then, where there
/// is gas, the cells below (left, right) and above (left, right).
#[inline(always)]
fn sum<S: Scalar, const GAS: bool>(
    gravity: Vec3<S>,
    mass: &[S; WIDTH],
    Line { up, right, cells: [a, b, _, _], sums, .. }: &mut Line<S>,
    below: &Line<S>,
) {
    let [_, _, c, d] = &below.cells;
    for lane in 0..WIDTH {
        let (left, here) = (FIRST + lane - 1, FIRST + lane);
        let mut sum = vec3::scale(gravity, mass[lane]);
        sum = vec3::add(vec3::sub(sum, right.get(left)), right.get(here));
        sum = vec3::add(vec3::sub(sum, below.up.get(here)), up.get(here));
        if GAS {
            sum = vec3::add(vec3::add(sum, c.get(left)), d.get(here));
            sum = vec3::add(vec3::add(sum, b.get(left)), a.get(here));
        }
        sums[lane] = sum;
    }
}
