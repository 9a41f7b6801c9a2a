//! Speed-dependent forces on a grid: air drag and dampers.
//!
//! In: a grid, positions and velocities. Out: sums of forces.

use super::layout::{Grid, WIDTH};
use super::strip::{FIRST, Row, Strip};
use crate::kernel::Kernel;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Writes the speed-dependent forces on the nodes of a grid (N), including air drag.
#[derive(Debug)]
pub struct DampingForces<'a, S> {
    /// The grid.
    pub grid: &'a Grid<'a, S>,
    /// Positions (m).
    pub pos: &'a [Vec3<S>],
    /// Velocities (m/s).
    pub vel: &'a [Vec3<S>],
    /// Viscous force of the air per point and speed (N s/m).
    pub air_drag: S,
    /// The sums of forces (N).
    pub force: &'a mut [Vec3<S>],
}

/// Positions (m) and velocities (m/s) of a row of nodes.
struct Nodes<S> {
    pos: Row<S>,
    vel: Row<S>,
}

/// A row of nodes whose forces are being computed, and the values that the row above needs of it.
struct Line<S> {
    nodes: Nodes<S>,
    /// Forces on the tails of the dampers to the right (N).
    right: Row<S>,
    /// Forces on the tails of the dampers upwards (N).
    up: Row<S>,
    /// Forces on the nodes (N).
    sums: [Vec3<S>; WIDTH],
}

impl<S: Scalar> Line<S> {
    fn zero() -> Self {
        let row = Row::zero();
        Line { nodes: Nodes { pos: row, vel: row }, right: row, up: row, sums: [[S::ZERO; 3]; WIDTH] }
    }
}

impl<S: Scalar> Kernel for DampingForces<'_, S> {
    type Output = ();

    #[inline(always)]
    fn run(mut self) {
        let grid = self.grid;
        for strip in Strip::all(grid.columns) {
            let [mut even, mut odd] = [Line::zero(), Line::zero()];
            self.read(&strip, 0, &mut even.nodes);
            // Two rows at a time, so that each has memory of its own; a row beyond the last has neither dampers nor
            // nodes.
            for row in (0..=grid.rows).step_by(2) {
                self.row(&strip, row, &mut even, &mut odd);
                self.row(&strip, row + 1, &mut odd, &mut even);
            }
        }
    }
}

impl<S: Scalar> DampingForces<'_, S> {
    #[inline(always)]
    fn read(&self, strip: &Strip, row: usize, to: &mut Nodes<S>) {
        strip.read(self.grid, row, self.pos, &mut to.pos);
        strip.read(self.grid, row, self.vel, &mut to.vel);
    }

    /// The forces on the nodes of a row, in the same order as [`super::ElasticForces`].
    #[inline(always)]
    fn row(&mut self, strip: &Strip, row: usize, line: &mut Line<S>, next: &mut Line<S>) {
        let grid = self.grid;
        self.read(strip, row + 1, &mut next.nodes);
        if let Some(damping) = strip.part(grid.right.damping, grid, row) {
            pull(damping, [&line.nodes, &line.nodes], 1, &mut line.right);
        }
        if let Some(damping) = strip.part(grid.up.damping, grid, row) {
            pull(damping, [&line.nodes, &next.nodes], 0, &mut line.up);
        }
        if let Some(below) = row.checked_sub(1) {
            strip.write(grid, below, &next.sums, self.force);
        }
        sum(self.air_drag, line, &next.up);
    }
}

/// Forces (N) on the tails of a row's dampers, which join a column of one row to the one `further` columns on of
/// another row.
#[inline(always)]
fn pull<S: Scalar>(damping: &[S; WIDTH], [tails, heads]: [&Nodes<S>; 2], further: usize, pulls: &mut Row<S>) {
    for (lane, damping) in damping.iter().enumerate() {
        let (tail, head) = (FIRST + lane, FIRST + lane + further);
        let (direction, _) = vec3::direction(vec3::sub(heads.pos.get(head), tails.pos.get(tail)));
        let rate = vec3::dot(vec3::sub(heads.vel.get(head), tails.vel.get(tail)), direction);
        pulls.set(tail, vec3::scale(direction, *damping * rate));
    }
}

/// Sums on the nodes of a row: air drag, dampers from the left and to the right, from below and upwards.
#[inline(always)]
fn sum<S: Scalar>(air_drag: S, Line { nodes, right, up, sums }: &mut Line<S>, below: &Row<S>) {
    for (lane, place) in sums.iter_mut().enumerate() {
        let (left, here) = (FIRST + lane - 1, FIRST + lane);
        let sum = vec3::scale(nodes.vel.get(here), -air_drag);
        let sum = vec3::add(vec3::sub(sum, right.get(left)), right.get(here));
        *place = vec3::add(vec3::sub(sum, below.get(here)), up.get(here));
    }
}
