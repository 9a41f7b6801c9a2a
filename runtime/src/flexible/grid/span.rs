//! What a march is asked for: so many steps of a body that is one grid under constant pressure.
//!
//! In: the motion at the start. Out: the motion at the end, from the rows in which a march keeps it.

use super::layout::{Grid, WIDTH};
use super::line::{Corner, Line, add_sizes, sum};
use super::strip::Row;
use crate::flexible::pressure::PressureForm;
use crate::ode::nodes::Motion;
use crate::real::Scalar;
use crate::vec3::Vec3;

/// Steps of a body.
#[derive(Debug)]
pub struct Span<'a, 'm, S> {
    /// The grid: no wider than [`WIDTH`], without dampers, all nodes and springs of the body.
    pub grid: &'a Grid<'a, S>,
    /// How a facet's force is shared; not [`PressureForm::Fan`].
    pub form: PressureForm,
    /// Gauge pressure (Pa).
    pub pressure: S,
    /// Facets that are no cells of the grid.
    pub beside: &'a [[Corner; 4]],
    /// Acceleration of gravity (m/s^2).
    pub gravity: Vec3<S>,
    /// Length of a step (s), > 0.
    pub h: S,
    /// How many steps, at least one.
    pub steps: usize,
    /// The motion, forces included.
    pub motion: &'a mut Motion<'m, S>,
    /// Whether the rows hold the motion at the start, as a march that took its steps leaves them.
    pub goes_on: bool,
}

impl<S: Scalar> Span<'_, '_, S> {
    /// Takes the motion over into the rows, unless they hold it.
    #[inline(always)]
    pub(super) fn begin<'l>(&self, lines: impl Iterator<Item = &'l mut Line<S>>) {
        if !self.goes_on {
            let mut memory = [Row::zero(); 5];
            for (row, line) in lines.enumerate() {
                line.read(self.grid, row, self.motion, &mut memory);
            }
        }
    }

    /// Puts the rows into the motion; returns whether all are numbers and not too large, or leaves the motion as it is.
    #[inline(always)]
    pub(super) fn end<'l>(&mut self, lines: impl Iterator<Item = &'l Line<S>> + Clone) -> bool {
        let mut ends = [S::ZERO; WIDTH];
        for line in lines.clone() {
            add_sizes(&line.pos, &mut ends);
            add_sizes(&line.vel, &mut ends);
        }
        // What is no number once stays so to the end.
        let taken = sum(&ends) <= S::FAR;
        if taken {
            for (row, line) in lines.enumerate() {
                line.write(self.grid, row, self.motion);
            }
        }
        taken
    }
}
