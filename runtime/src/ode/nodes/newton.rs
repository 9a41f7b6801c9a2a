//! Newton's equations of nodes: the interface that a method needs, and the reasons to refuse a step.

use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Why a step is refused; the state at its start is unchanged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NodeFault<S> {
    /// Less memory than needed.
    Memory {
        /// Vectors needed.
        needed: usize,
        /// Vectors given.
        given: usize,
    },
    /// A position or speed, or its square, is infinite or NaN.
    NotFinite {
        /// The node.
        node: usize,
    },
    /// The iteration of an implicit step did not converge: the step is too long.
    NotConverged {
        /// Its length (s).
        step: S,
    },
}

/// Equations of motion of nodes, with the contacts that hold some of them frozen over a step.
pub trait Newton<S: Scalar> {
    /// Why an evaluation is refused.
    type Fault: From<NodeFault<S>>;
    /// Number of nodes.
    fn nodes(&self) -> usize;
    /// Writes the forces that depend on positions (N); may move nodes without mass, which are no state.
    ///
    /// # Errors
    /// If a force is not defined at these positions.
    fn elastic(&self, pos: &mut [Vec3<S>], force: &mut [Vec3<S>]) -> Result<(), Self::Fault>;
    /// Writes the forces that depend on speeds (N).
    fn viscous(&self, pos: &[Vec3<S>], vel: &[Vec3<S>], force: &mut [Vec3<S>]);
    /// Writes forces whose work over the step is the change of the stored energy, and the dampers' mean forces (N).
    ///
    /// # Errors
    /// If a force is not defined at these positions.
    fn mean_force(&self, way: &MeanStep<S>, force: &mut [Vec3<S>]) -> Result<(), Self::Fault>;
    /// Whether some force depends on speeds.
    fn is_damped(&self) -> bool;
    /// Whether a node can move: it has a mass and is not fixed.
    fn is_movable(&self, node: usize) -> bool;
    /// Acceleration of a node under a force (m/s^2), restricted to what its contact allows.
    fn acceleration(&self, node: usize, force: Vec3<S>) -> Vec3<S>;
    /// 1/mass (1/kg) of the nodes from `first` on, as many as there is memory for, once for each component; 0 for a
    /// node that cannot move.
    fn inverse_masses<'a>(&'a self, first: usize, memory: &'a mut [Vec3<S>]) -> &'a [Vec3<S>];
    /// Whether a contact holds any of the `count` nodes from `first` on.
    fn holds(&self, first: usize, count: usize) -> bool;
    /// Restricts velocities or accelerations of the nodes from `first` on to what their contacts allow.
    fn admit(&self, first: usize, rows: &mut [Vec3<S>]);
    /// Largest acceleration caused by a strain of 1 (m/s^2): the rounding of positions changes accelerations by about
    /// EPSILON times this, even where all forces balance.
    fn acceleration_of_unit_strain(&self) -> S;
}

/// A step as the energy-momentum method needs it.
#[derive(Clone, Copy, Debug)]
pub struct MeanStep<'a, S> {
    /// Its length (s).
    pub h: S,
    /// Positions at its start, in its middle and at its end.
    pub pos: [&'a [Vec3<S>]; 3],
    /// Change of the positions.
    pub dx: &'a [Vec3<S>],
    /// Mean velocities.
    pub vel: &'a [Vec3<S>],
}

/// `v` if the node can move, else 0.
pub(super) fn movable<S: Scalar>(newton: &impl Newton<S>, node: usize, v: Vec3<S>) -> Vec3<S> {
    if newton.is_movable(node) { v } else { vec3::zero() }
}
