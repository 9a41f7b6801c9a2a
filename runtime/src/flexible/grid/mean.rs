//! Mean forces over a step on a grid: springs, dampers, pressure on its cells.
//!
//! In: a grid, the pressure, nodes in the middle of the step and their changes over it. Out: sums of forces.

use super::elastic::{Shares, corners, share, sum};
use super::layout::{Family, Grid, WIDTH};
use super::strip::{FIRST, Row, Strip};
use crate::flexible::mean;
use crate::flexible::pressure::{self, PressureForm, Weights};
use crate::kernel::Kernel;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Adds the mean forces on the nodes of a grid (N).
#[derive(Debug)]
pub struct MeanForces<'a, S> {
    /// The grid.
    pub grid: &'a Grid<'a, S>,
    /// How pressure is shared by corners, and its value (Pa).
    pub pressure: Option<(PressureForm, S)>,
    /// Length of the step (s).
    pub h: S,
    /// Positions in the middle of the step, and their changes over it (m).
    pub nodes: [&'a [Vec3<S>]; 2],
    /// The sums of forces (N).
    pub force: &'a mut [Vec3<S>],
}

/// A row of nodes whose forces are being computed, and the values that the row above needs of it.
struct Line<S> {
    /// Positions in the middle of the step, and their changes (m).
    nodes: [Row<S>; 2],
    /// Forces on the tails of the springs to the right (N).
    right: Row<S>,
    /// Forces on the tails of the springs upwards (N).
    up: Row<S>,
    /// Forces on the corners of the cells between this row and the one above (N).
    cells: [Row<S>; 4],
    /// Other forces on the nodes (N).
    besides: Row<S>,
    /// Forces on the nodes (N).
    sums: [Vec3<S>; WIDTH],
}

impl<S: Scalar> Line<S> {
    fn zero() -> Self {
        let row = Row::zero();
        let sums = [[S::ZERO; 3]; WIDTH];
        Line { nodes: [row; 2], right: row, up: row, cells: [row; 4], besides: row, sums }
    }
}

impl<S: Scalar> Kernel for MeanForces<'_, S> {
    type Output = ();

    #[inline(always)]
    fn run(mut self) {
        let grid = self.grid;
        for strip in Strip::all(grid.columns) {
            let [mut even, mut odd] = [Line::zero(), Line::zero()];
            self.read(&strip, 0, &mut even);
            // Two rows at a time, so that each has memory of its own; a row beyond the last has neither springs nor
            // nodes.
            for row in (0..=grid.rows).step_by(2) {
                self.row(&strip, row, &mut even, &mut odd);
                self.row(&strip, row + 1, &mut odd, &mut even);
            }
        }
    }
}

impl<'a, S: Scalar> MeanForces<'a, S> {
    /// Reads the nodes of a row and the other forces on them; no other strip has yet written those that this strip
    /// owns.
    #[inline(always)]
    fn read(&self, strip: &Strip, row: usize, to: &mut Line<S>) {
        let [middle, change] = &mut to.nodes;
        strip.read(self.grid, row, self.nodes[0], middle);
        strip.read(self.grid, row, self.nodes[1], change);
        strip.read(self.grid, row, self.force, &mut to.besides);
    }

    /// The forces on the nodes of a row, in the same order as [`super::ElasticForces`].
    #[inline(always)]
    fn row(&mut self, strip: &Strip, row: usize, line: &mut Line<S>, next: &mut Line<S>) {
        let grid = self.grid;
        self.read(strip, row + 1, next);
        let none = [S::ZERO; WIDTH];
        let part = |list: &'a [S]| strip.part(list, grid, row);
        let family = |Family { stiffness, rest_length, damping }: Family<'a, S>| {
            Some([*part(stiffness)?, *part(rest_length)?, *part(damping).unwrap_or(&none)])
        };
        if let Some(numbers) = family(grid.right) {
            pull(&numbers, self.h, [&line.nodes, &line.nodes], 1, &mut line.right);
        }
        if let (Some((form, pressure)), Some(exists)) = (self.pressure, part(grid.cells)) {
            push(form, exists, pressure, [&line.nodes, &next.nodes], &mut line.cells);
        }
        if let Some(numbers) = family(grid.up) {
            pull(&numbers, self.h, [&line.nodes, &next.nodes], 0, &mut line.up);
        }
        if let Some(below) = row.checked_sub(1) {
            strip.write(grid, below, &next.sums, self.force);
        }
        let Line { right, up, cells, besides, sums, .. } = line;
        let start = |lane: usize| besides.get(FIRST + lane);
        match self.pressure {
            Some(_) => sum::<S, true>(start, [right, up], cells, &next.up, &next.cells, sums),
            None => sum::<S, false>(start, [right, up], cells, &next.up, &next.cells, sums),
        }
    }
}

/// Mean forces (N) on the tails of a row's springs, which join a column of one row to the one `further` columns on of
/// another row.
#[inline(always)]
fn pull<S: Scalar>(
    [stiffness, rest_length, damping]: &[[S; WIDTH]; 3],
    h: S,
    [tails, heads]: [&[Row<S>; 2]; 2],
    further: usize,
    pulls: &mut Row<S>,
) {
    for lane in 0..WIDTH {
        let way = |i: usize| vec3::sub(heads[i].get(FIRST + lane + further), tails[i].get(FIRST + lane));
        let numbers = [stiffness[lane], rest_length[lane], damping[lane]];
        pulls.set(FIRST + lane, mean::pull([way(0), way(1)], numbers, h));
    }
}

/// Mean forces (N) on the corners of the cells between two rows. One loop per form: a choice inside would be made in
/// every lane.
#[inline(always)]
fn push<S: Scalar>(
    form: PressureForm,
    exists: &[S; WIDTH],
    pressure: S,
    rows: [&[Row<S>; 2]; 2],
    cells: &mut [Row<S>; 4],
) {
    match form {
        PressureForm::Fan => {
            share(Means::<S, true> { weights: Weights::of(form, false), rows }, exists, pressure, cells)
        }
        _ => share(Means::<S, false> { weights: Weights::of(form, false), rows }, exists, pressure, cells),
    }
}

/// Mean shares of the cells between two rows. A type, because a closure would be compiled alone, for the oldest
/// machine.
struct Means<'r, S, const FAN: bool> {
    weights: Weights<S>,
    rows: [&'r [Row<S>; 2]; 2],
}

impl<S: Scalar, const FAN: bool> Shares<S> for Means<'_, S, FAN> {
    #[inline(always)]
    fn of(&self, left: usize) -> [Vec3<S>; 4] {
        let [[middle, change], [middle_above, change_above]] = self.rows;
        let middle = corners([middle, middle_above], left);
        let change = corners([change, change_above], left);
        if FAN {
            mean::simpson(pressure::fan_shares(middle), pressure::fan_shares(change))
        } else {
            mean::simpson(pressure::shares(self.weights, middle), pressure::shares(self.weights, change))
        }
    }
}
