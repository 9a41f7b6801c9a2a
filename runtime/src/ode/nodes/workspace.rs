//! Memory of a step of nodes: the motion at its end, its stages, and its sums.

use super::motion::{MOTION_ROWS, Motion, copy, cut};
use super::newton::{Newton, NodeFault};
use super::rows;
use crate::kernel::Kernel;
use crate::real::Scalar;
use crate::vec3::Vec3;

/// Vectors per node in a [`Workspace`], without the stages.
const WORKSPACE_ROWS: usize = MOTION_ROWS + 6;

/// Scratch memory of a step.
#[derive(Debug)]
pub struct Workspace<'a, S> {
    /// The motion at the end of the last step tried.
    pub end: Motion<'a, S>,
    /// Change of position over the step.
    pub dx: &'a mut [Vec3<S>],
    /// Change of velocity over the step.
    pub dv: &'a mut [Vec3<S>],
    /// Positions at a stage.
    pub stage_pos: &'a mut [Vec3<S>],
    /// Velocities at a stage.
    pub stage_vel: &'a mut [Vec3<S>],
    /// Forces at a stage that depend on positions.
    pub stage_elastic: &'a mut [Vec3<S>],
    /// Forces at a stage that depend on speeds.
    pub stage_viscous: &'a mut [Vec3<S>],
    /// Accelerations of all stages, n per stage.
    pub stages: &'a mut [Vec3<S>],
    /// Evaluations of all forces so far.
    pub evaluations: usize,
}

/// Vectors that a [`Workspace`] needs for n nodes and a method of so many stages.
#[must_use]
pub const fn workspace_len(n: usize, stages: usize) -> usize {
    n * (WORKSPACE_ROWS + stages)
}

impl<'a, S: Scalar> Workspace<'a, S> {
    /// Cuts the workspace from the caller's memory.
    ///
    /// # Errors
    /// [`NodeFault::Memory`] if it is shorter than [`workspace_len`].
    pub fn new(buffer: &'a mut [Vec3<S>], n: usize, stages: usize) -> Result<Workspace<'a, S>, NodeFault<S>> {
        let (end, buffer) = Motion::cut(buffer, n)?;
        Workspace::around(end, buffer, n, stages)
    }

    /// The same around given memory for the end of a step, which an accepted step swaps with that of the state; the
    /// buffer is shorter by it.
    ///
    /// # Errors
    /// [`NodeFault::Memory`] if the buffer is too short.
    pub fn around(
        end: Motion<'a, S>,
        buffer: &'a mut [Vec3<S>],
        n: usize,
        stages: usize,
    ) -> Result<Workspace<'a, S>, NodeFault<S>> {
        let (dx, buffer) = cut(buffer, n)?;
        let (dv, buffer) = cut(buffer, n)?;
        let (stage_pos, buffer) = cut(buffer, n)?;
        let (stage_vel, buffer) = cut(buffer, n)?;
        let (stage_elastic, buffer) = cut(buffer, n)?;
        let (stage_viscous, buffer) = cut(buffer, n)?;
        let (stages, _) = cut(buffer, n * stages)?;
        let evaluations = 0;
        Ok(Workspace { end, dx, dv, stage_pos, stage_vel, stage_elastic, stage_viscous, stages, evaluations })
    }

    /// Recomputes the forces at the end of the step.
    ///
    /// # Errors
    /// From [`Newton::elastic`].
    pub fn refresh_end<N: Newton<S>>(&mut self, newton: &N) -> Result<(), N::Fault> {
        self.evaluations += 1;
        self.end.refresh(newton)
    }

    /// Sets end = start + (dx, dv) by compensated sums, then the forces there. A held node keeps no velocity against
    /// its contact, not even a rounding error.
    ///
    /// # Errors
    /// From [`Newton::elastic`], or a node whose position or speed is not finite.
    pub fn finish<N: Newton<S>>(&mut self, newton: &N, start: &Motion<S>) -> Result<(), N::Fault> {
        let end = &mut self.end;
        rows::run(
            start.pos.len(),
            Sum { terms: [start.pos, start.pos_rest, self.dx], out: [end.pos, end.pos_rest] },
        );
        rows::run(
            start.pos.len(),
            Sum { terms: [start.vel, start.vel_rest, self.dv], out: [end.vel, end.vel_rest] },
        );
        newton.admit(0, end.vel);
        newton.admit(0, end.vel_rest);
        self.refresh_end(newton)?;
        Ok(self.end.check_finite()?)
    }

    /// Moves the end's positions by `dx`, by compensated sums.
    pub fn shift_positions(&mut self) {
        let Workspace { end, dx, stage_pos, stage_vel, .. } = self;
        copy(stage_pos, end.pos);
        copy(stage_vel, end.pos_rest);
        rows::run(dx.len(), Sum { terms: [stage_pos, stage_vel, dx], out: [end.pos, end.pos_rest] });
    }
}

/// A compensated sum of rows.
struct Sum<'a, S> {
    terms: [&'a [Vec3<S>]; 3],
    out: [&'a mut [Vec3<S>]; 2],
}

impl<S: Scalar> Kernel for Sum<'_, S> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let [out, rest] = self.out;
        rows::sum_compensated(self.terms, out, rest);
    }
}
