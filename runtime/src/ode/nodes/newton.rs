//! Newton's equations of nodes: what a method asks of them, and why a step is refused.

use crate::real::Scalar;
use crate::vec3::{self, Vec3};

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

/// `v` where the node can move, 0 where no force moves it.
pub(super) fn movable<S: Scalar>(newton: &impl Newton<S>, node: usize, v: Vec3<S>) -> Vec3<S> {
    if newton.is_movable(node) { v } else { vec3::zero() }
}
