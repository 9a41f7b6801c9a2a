//! Position-dependent forces on a grid: weight, springs, pressure on its cells.
//!
//! In: a grid, the pressure, positions. Out: sums of forces.

use super::layout::{Grid, WIDTH};
use super::strip::{FIRST, Row, Strip};
use crate::flexible::pressure::{self, PressureForm, Weights};
use crate::flexible::spring::is_runaway;
use crate::kernel::Kernel;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Writes the forces on the nodes of a grid (N), including their weight; returns whether any spring is a runaway, see
/// [`crate::flexible::spring::STRETCH_LIMIT`].
#[derive(Debug)]
pub struct ElasticForces<'a, S> {
    /// The grid.
    pub grid: &'a Grid<'a, S>,
    /// How pressure is shared by corners, and its value (Pa).
    pub pressure: Option<(PressureForm, S)>,
    /// Positions (m).
    pub pos: &'a [Vec3<S>],
    /// Acceleration of gravity (m/s^2).
    pub gravity: Vec3<S>,
    /// The sums of forces (N).
    pub force: &'a mut [Vec3<S>],
}

/// A row of nodes whose forces are being computed, and the values that the row above needs of it.
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

impl<S: Scalar> Kernel for ElasticForces<'_, S> {
    type Output = bool;

    #[inline(always)]
    fn run(mut self) -> bool {
        let (mut runaway, grid) = (false, self.grid);
        for strip in Strip::all(grid.columns) {
            let [mut even, mut odd] = [Line::zero(), Line::zero()];
            strip.read(grid, 0, self.pos, &mut even.nodes);
            // Two rows at a time, so that each has memory of its own; a row beyond the last has neither springs nor
            // nodes.
            for row in (0..=grid.rows).step_by(2) {
                runaway |= self.row(&strip, row, &mut even, &mut odd);
                runaway |= self.row(&strip, row + 1, &mut odd, &mut even);
            }
        }
        runaway
    }
}

impl<S: Scalar> ElasticForces<'_, S> {
    /// The forces on the nodes of a row. `next` holds the values of the row below and receives the nodes of the row
    /// above. Writes the sums of the row below: the processor would have to wait for those just computed.
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
            let Line { right, up, cells, sums, .. } = line;
            let weight = |lane: usize| vec3::scale(self.gravity, mass[lane]);
            match self.pressure {
                Some(_) => sum::<S, true>(weight, [right, up], cells, &next.up, &next.cells, sums),
                None => sum::<S, false>(weight, [right, up], cells, &next.up, &next.cells, sums),
            }
        }
        runaway
    }
}

/// Elastic forces (N) on the tails of a row's springs, which join a column of one row to the one `further` columns on
/// of another row.
#[inline(always)]
fn pull<S: Scalar>(
    stiffness: &[S; WIDTH],
    rest_length: &[S; WIDTH],
    [tails, heads]: [&Row<S>; 2],
    further: usize,
    pulls: &mut Row<S>,
) -> bool {
    // An integer as wide as a lane: a bool would be moved out of its vector register.
    let mut runaway = 0_u32;
    for lane in 0..WIDTH {
        let (tail, head) = (tails.get(FIRST + lane), heads.get(FIRST + lane + further));
        let (direction, length) = vec3::direction(vec3::sub(head, tail));
        let tension = stiffness[lane] * (length - rest_length[lane]);
        pulls.set(FIRST + lane, vec3::scale(direction, tension));
        runaway |= u32::from(is_runaway(rest_length[lane], length));
    }
    runaway > 0
}

/// Forces (N) on the corners of the cells between two rows. One loop per form: a choice inside would be made in every
/// lane.
#[inline(always)]
fn push<S: Scalar>(
    form: PressureForm,
    exists: &[S; WIDTH],
    pressure: S,
    rows: [&Row<S>; 2],
    cells: &mut [Row<S>; 4],
) {
    match form {
        PressureForm::Fan => {
            share(|left| pressure::fan_shares(corners(rows, left)), exists, pressure, cells);
        }
        _ => {
            let weights = Weights::of(form, false);
            share(|left| pressure::shares(weights, corners(rows, left)), exists, pressure, cells);
        }
    }
}

/// Corners of the cell to the right of a column, between two rows.
#[inline(always)]
pub(super) fn corners<S: Scalar>([here, above]: [&Row<S>; 2], left: usize) -> [Vec3<S>; 4] {
    let right = left + 1;
    [here.get(left), here.get(right), above.get(right), above.get(left)]
}

/// Outward vectors (m^2) at the corners of a cell; times the pressure they are forces.
pub(super) trait Shares<S> {
    /// The vectors of the cell to the right of a column.
    fn of(&self, left: usize) -> [Vec3<S>; 4];
}

impl<S, F: Fn(usize) -> [Vec3<S>; 4]> Shares<S> for F {
    #[inline(always)]
    fn of(&self, left: usize) -> [Vec3<S>; 4] {
        self(left)
    }
}

/// Writes the pressure forces of the cells between two rows, given the corner vectors of the cell to the right of a
/// column.
#[inline(always)]
pub(super) fn share<S: Scalar>(
    shares: impl Shares<S>,
    exists: &[S; WIDTH],
    pressure: S,
    [a, b, c, d]: &mut [Row<S>; 4],
) {
    // A cell that does not exist has force 0.
    let pressures = exists.map(|exists| exists * pressure);
    for left in FIRST..FIRST + WIDTH {
        let pressure = pressures[left - FIRST];
        let [on_a, on_b, on_c, on_d] = shares.of(left).map(|share| vec3::scale(share, pressure));
        a.set(left, on_a);
        b.set(left, on_b);
        c.set(left, on_c);
        d.set(left, on_d);
    }
}

/// Sums on the nodes of a row: the start value, springs from the left and to the right, from below and upwards, then,
/// with gas, the cells below (left, right) and above (left, right).
#[inline(always)]
pub(super) fn sum<S: Scalar, const GAS: bool>(
    start: impl Fn(usize) -> Vec3<S>,
    [right, up]: [&Row<S>; 2],
    [a, b, _, _]: &[Row<S>; 4],
    up_below: &Row<S>,
    [_, _, c, d]: &[Row<S>; 4],
    sums: &mut [Vec3<S>; WIDTH],
) {
    for (lane, place) in sums.iter_mut().enumerate() {
        let (left, here) = (FIRST + lane - 1, FIRST + lane);
        let mut sum = start(lane);
        sum = vec3::add(vec3::sub(sum, right.get(left)), right.get(here));
        sum = vec3::add(vec3::sub(sum, up_below.get(here)), up.get(here));
        if GAS {
            sum = vec3::add(vec3::add(sum, c.get(left)), d.get(here));
            sum = vec3::add(vec3::add(sum, b.get(left)), a.get(here));
        }
        *place = sum;
    }
}
