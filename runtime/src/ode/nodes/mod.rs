//! Newton's equations of nodes, q_dot = u, M u_dot = f(q) + g(q, u) with a diagonal M, and one step of them.
//!
//! In: a [`Motion`], the equations ([`Newton`]), a method ([`method`]), the step. Out: the motion at the end, in the
//! [`Workspace`]; the start is left alone, so a step can be tried, shortened and tried again.
//! Positions and speeds carry what rounding dropped (compensated sums): an f32 node at 10 m moves at 1 mm/s.

pub mod method;
mod midpoint;
mod nystrom;
mod rows;
mod verlet;

pub use method::{Method, Step};

use crate::kernel::{self, Kernel};
use crate::real::Scalar;
use crate::vec3::{self, Vec3};
use rows::Squares;

/// Why a step is refused; its start is untouched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NodeFault<S> {
    /// Less memory than needed.
    Memory {
        /// Vectors needed.
        needed: usize,
        /// Vectors given.
        given: usize,
    },
    /// A position or speed, or its square, left the numbers.
    NotFinite {
        /// The node.
        node: usize,
    },
    /// An implicit step did not settle: it is too long.
    NotConverged {
        /// Its length (s).
        step: S,
    },
}

/// Equations of motion of nodes, what holds some of them frozen over a step.
pub trait Newton<S: Scalar> {
    /// Why an evaluation is refused.
    type Fault: From<NodeFault<S>>;
    /// Number of nodes.
    fn nodes(&self) -> usize;
    /// Writes the forces of positions (N); may move nodes that have no mass and so no state.
    ///
    /// # Errors
    /// Where there is no force.
    fn elastic(&self, pos: &mut [Vec3<S>], force: &mut [Vec3<S>]) -> Result<(), Self::Fault>;
    /// Writes the forces of speeds (N).
    fn viscous(&self, pos: &[Vec3<S>], vel: &[Vec3<S>], force: &mut [Vec3<S>]);
    /// Writes forces whose work over the step is the change of the stored energy, and the dampers' mean forces (N).
    ///
    /// # Errors
    /// Where there is no force.
    fn mean_force(&self, way: &Way<S>, force: &mut [Vec3<S>]) -> Result<(), Self::Fault>;
    /// Whether some force depends on speeds.
    fn is_damped(&self) -> bool;
    /// Whether a node can move: it has a mass and is not fixed.
    fn is_movable(&self, node: usize) -> bool;
    /// Acceleration of a node under a force (m/s^2), after what holds it has taken its part.
    fn acceleration(&self, node: usize, force: Vec3<S>) -> Vec3<S>;
    /// 1/mass (1/kg) of nodes from `first` on, as many as there is memory for, once for each component; 0 for one that
    /// cannot move.
    fn inverse_masses<'a>(&'a self, first: usize, memory: &'a mut [Vec3<S>]) -> &'a [Vec3<S>];
    /// Whether something holds one of so many nodes from `first` on.
    fn holds(&self, first: usize, count: usize) -> bool;
    /// Leaves of velocities or accelerations of the nodes from `first` on what what holds them leaves.
    fn admit(&self, first: usize, rows: &mut [Vec3<S>]);
    /// Largest acceleration that a strain of 1 gives (m/s^2): rounding of positions moves accelerations by about
    /// EPSILON times this, also where all forces balance.
    fn acceleration_of_unit_strain(&self) -> S;
}

/// A step as the energy-momentum method sees it.
#[derive(Clone, Copy, Debug)]
pub struct Way<'a, S> {
    /// Its length (s).
    pub h: S,
    /// Positions at its start, in its middle and at its end.
    pub pos: [&'a [Vec3<S>]; 3],
    /// Change of the positions.
    pub dx: &'a [Vec3<S>],
    /// Mean velocities.
    pub vel: &'a [Vec3<S>],
}

/// Positions, speeds and forces of all nodes at one time.
#[derive(Debug)]
pub struct Motion<'a, S> {
    /// Positions (m).
    pub pos: &'a mut [Vec3<S>],
    /// What rounding dropped from the positions.
    pub pos_rest: &'a mut [Vec3<S>],
    /// Velocities (m/s).
    pub vel: &'a mut [Vec3<S>],
    /// What rounding dropped from the velocities.
    pub vel_rest: &'a mut [Vec3<S>],
    /// Forces of positions (N).
    pub elastic: &'a mut [Vec3<S>],
    /// Forces of speeds (N); where there are none nothing but [`Motion::refresh`] writes their zeros.
    pub viscous: &'a mut [Vec3<S>],
}

/// Vectors per node in a [`Motion`].
pub const MOTION_ROWS: usize = 6;
/// Vectors per node in a [`Workspace`], without the stages.
const WORKSPACE_ROWS: usize = MOTION_ROWS + 6;

impl<'a, S: Scalar> Motion<'a, S> {
    /// Cuts the six rows of n from a buffer; returns what is left.
    ///
    /// # Errors
    /// [`NodeFault::Memory`] if the buffer is too short.
    #[expect(clippy::type_complexity, reason = "the pair is the whole answer")]
    pub fn cut(
        buffer: &'a mut [Vec3<S>],
        n: usize,
    ) -> Result<(Motion<'a, S>, &'a mut [Vec3<S>]), NodeFault<S>> {
        let (pos, buffer) = cut(buffer, n)?;
        let (pos_rest, buffer) = cut(buffer, n)?;
        let (vel, buffer) = cut(buffer, n)?;
        let (vel_rest, buffer) = cut(buffer, n)?;
        let (elastic, buffer) = cut(buffer, n)?;
        let (viscous, buffer) = cut(buffer, n)?;
        Ok((Motion { pos, pos_rest, vel, vel_rest, elastic, viscous }, buffer))
    }

    /// Total force on node i (N).
    #[must_use]
    pub fn force(&self, i: usize) -> Vec3<S> {
        vec3::add(vec3::at(self.elastic, i), vec3::at(self.viscous, i))
    }

    /// Recomputes the forces of these positions and speeds.
    ///
    /// # Errors
    /// From [`Newton::elastic`].
    pub fn refresh<N: Newton<S>>(&mut self, newton: &N) -> Result<(), N::Fault> {
        newton.elastic(self.pos, self.elastic)?;
        newton.viscous(self.pos, self.vel, self.viscous);
        Ok(())
    }

    /// Refuses what left the numbers: squares, because energies and errors are made of them.
    ///
    /// # Errors
    /// [`NodeFault::NotFinite`] for the first such node.
    pub fn check_finite(&self) -> Result<(), NodeFault<S>> {
        self.check_squares(&kernel::run(SumOfSquares { rows: [self.pos, self.vel] }))
    }

    /// The same, where the squares of positions and speeds have been summed: almost always one look at the sums is enough.
    fn check_squares(&self, squares: &Squares<S>) -> Result<(), NodeFault<S>> {
        if squares.are_finite() {
            return Ok(());
        }
        let finite = |x: &Vec3<S>, v: &Vec3<S>| (vec3::dot(*x, *x) + vec3::dot(*v, *v)).is_finite();
        let bad = self.pos.iter().zip(self.vel.iter()).position(|(x, v)| !finite(x, v));
        bad.map_or(Ok(()), |node| Err(NodeFault::NotFinite { node }))
    }
}

/// The squares of rows.
struct SumOfSquares<'a, S> {
    rows: [&'a [Vec3<S>]; 2],
}

impl<S: Scalar> Kernel for SumOfSquares<'_, S> {
    type Output = Squares<S>;

    #[inline(always)]
    fn run(self) -> Squares<S> {
        let mut squares = Squares::none();
        self.rows.into_iter().for_each(|row| squares.add(row));
        squares
    }
}

fn cut<T, S>(buffer: &mut [T], n: usize) -> Result<(&mut [T], &mut [T]), NodeFault<S>> {
    let given = buffer.len();
    buffer.split_at_mut_checked(n).ok_or(NodeFault::Memory { needed: n, given })
}

/// Copies row by row; no panic if the lengths differ.
pub(crate) fn copy<T: Copy>(to: &mut [T], from: &[T]) {
    let n = to.len().min(from.len());
    if let (Some(to), Some(from)) = (to.get_mut(..n), from.get(..n)) {
        to.copy_from_slice(from);
    }
}

fn set<S: Scalar>(rows: &mut [Vec3<S>], i: usize, value: Vec3<S>) {
    if let Some(row) = rows.get_mut(i) {
        *row = value;
    }
}

/// Scratch memory of a step.
#[derive(Debug)]
pub struct Workspace<'a, S> {
    /// The motion at the end of the step tried last.
    pub end: Motion<'a, S>,
    /// Change of position over the step.
    pub dx: &'a mut [Vec3<S>],
    /// Change of velocity over the step.
    pub dv: &'a mut [Vec3<S>],
    /// Positions at a stage.
    pub stage_pos: &'a mut [Vec3<S>],
    /// Velocities at a stage.
    pub stage_vel: &'a mut [Vec3<S>],
    /// Forces at a stage, of positions.
    pub stage_elastic: &'a mut [Vec3<S>],
    /// Forces at a stage, of speeds.
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

    /// The same around memory for the end of a step, which a step taken exchanges with that of the state; the buffer is
    /// shorter by it.
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

    /// end = start + (dx, dv) by compensated sums, then the forces there. A held node keeps no velocity that it must not
    /// have, not even rounding.
    ///
    /// # Errors
    /// From [`Newton::elastic`], or a node that left the numbers.
    pub fn finish<N: Newton<S>>(&mut self, newton: &N, start: &Motion<S>) -> Result<(), N::Fault> {
        let end = &mut self.end;
        kernel::run(Sum { terms: [start.pos, start.pos_rest, self.dx], out: [end.pos, end.pos_rest] });
        kernel::run(Sum { terms: [start.vel, start.vel_rest, self.dv], out: [end.vel, end.vel_rest] });
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
        kernel::run(Sum { terms: [stage_pos, stage_vel, dx], out: [end.pos, end.pos_rest] });
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

/// `v` where the node can move, 0 where no force moves it.
fn movable<S: Scalar>(newton: &impl Newton<S>, node: usize, v: Vec3<S>) -> Vec3<S> {
    if newton.is_movable(node) { v } else { vec3::zero() }
}
