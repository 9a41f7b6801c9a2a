//! Pose, twist and acceleration of a point and a frame, as linear forms in the independent speeds.
//!
//! In: the motions of points and triads over all unknowns y, and y = T u, y' = T u' + beta from the constraints.
//! Out: components in N. A twist is the velocity of the point over the angular velocity of the frame:
//! `twist = J u + v_t` and `twist' = J u' + bias` (Kane's v_t: what time alone moves).

use super::eliminate::Solution;
use super::lifted::{flatten, point_is_lifted};
use super::quantities::{Kinematics, Motion, UnknownId};
use super::rate::motion_value as value_of;
use crate::expr::ExprId;
use crate::model::{Axis, FrameId, Model, PointId};
use crate::vector::{TriadId, Vector};
use std::collections::BTreeMap;

/// A point, a frame, or a frame with a point in it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Marker {
    /// What moves.
    pub point: Option<PointId>,
    /// What turns.
    pub frame: Option<FrameId>,
}

impl Marker {
    /// A point whose position counts only up to a displacement, because it is located by its velocity.
    #[must_use]
    pub fn unlocated(&self, model: &Model, k: &Kinematics) -> Option<PointId> {
        let points = self.point.into_iter().flat_map(|p| k.positions[p].points.keys().copied());
        points.into_iter().find(|&p| point_is_lifted(model, p) && model.points[p].velocity.is_some())
    }

    /// Position of the point from O.
    pub fn position(&self, k: &mut Kinematics) -> Option<[ExprId; 3]> {
        let position = k.positions[self.point?].clone();
        let position = flatten(k, &position);
        Some(in_n(k, &position))
    }

    /// The matrix whose columns are the frame's axes.
    pub fn rotation(&self, k: &mut Kinematics) -> Option<[[ExprId; 3]; 3]> {
        let triad = k.frame_triad[self.frame?];
        let axes = [Axis::X, Axis::Y, Axis::Z].map(|axis| {
            let axis = Vector::axis(&mut k.dag, triad, axis);
            in_n(k, &axis)
        });
        Some(std::array::from_fn(|i| axes.map(|axis| axis[i])))
    }

    /// Velocity of the point, angular velocity of the frame; each where there is one.
    fn motions(&self, k: &Kinematics) -> Vec<Motion> {
        let velocity = self.point.map(|point| k.velocities[point].clone());
        let angular = self.frame.map(|frame| k.angular[k.frame_triad[frame]].clone());
        velocity.into_iter().chain(angular).collect()
    }

    /// The twist, in the symbols of all unknowns.
    pub fn twist(&self, k: &mut Kinematics) -> Vec<ExprId> {
        let motions = self.motions(k);
        let mut twist = Vec::new();
        for motion in &motions {
            let value = value_of(k, motion);
            twist.extend(in_n(k, &value));
        }
        twist
    }

    /// J, one row a component of the twist, one column an independent speed.
    pub fn jacobian(&self, k: &mut Kinematics, solution: &Solution) -> Vec<Vec<ExprId>> {
        let n = k.independent_unknowns().len();
        let mut rows = Vec::new();
        for motion in self.motions(k) {
            let partials = partials_in_n(k, &motion);
            for axis in 0..3 {
                let row = (0..n).map(|j| {
                    let each = partials.iter().map(|(y, v)| (v[axis], solution.partials[y][j]));
                    let terms: Vec<ExprId> =
                        each.collect::<Vec<_>>().into_iter().map(|(v, t)| k.dag.mul(v, t)).collect();
                    k.dag.sum(&terms)
                });
                rows.push(row.collect());
            }
        }
        rows
    }

    /// The twist's derivative where u' = 0, in the symbols of all unknowns.
    pub fn bias(&self, k: &mut Kinematics, solution: &Solution) -> Vec<ExprId> {
        let beta = solution.derivatives(k, BTreeMap::new());
        let mut bias = Vec::new();
        for motion in self.motions(k) {
            let own = in_n(k, &motion.bias);
            let partials = partials_in_n(k, &motion);
            for axis in 0..3 {
                let mut sum = own[axis];
                for (y, v) in &partials {
                    if let Some(&b) = beta.get(y) {
                        let term = k.dag.mul(v[axis], b);
                        sum = k.dag.add(sum, term);
                    }
                }
                bias.push(sum);
            }
        }
        bias
    }
}

impl Solution {
    /// y' = T u' + beta of all unknowns, from those of u' that are given; beta alone, where none are.
    pub(crate) fn derivatives(
        &self,
        k: &mut Kinematics,
        mut y_dot: BTreeMap<UnknownId, ExprId>,
    ) -> BTreeMap<UnknownId, ExprId> {
        for step in self.steps.iter().rev() {
            let mut sum = step.bias;
            for (z, &c) in &step.coefficients {
                if let Some(&z_dot) = y_dot.get(z) {
                    let term = k.dag.mul(c, z_dot);
                    sum = k.dag.add(sum, term);
                }
            }
            y_dot.insert(step.unknown, sum);
        }
        y_dot
    }
}

fn in_n(k: &mut Kinematics, vector: &Vector) -> [ExprId; 3] {
    k.triads.express(&mut k.dag, vector, TriadId::INERTIAL)
}

fn partials_in_n(k: &mut Kinematics, motion: &Motion) -> Vec<(UnknownId, [ExprId; 3])> {
    motion.partials.iter().map(|(&y, v)| (y, in_n(k, v))).collect()
}
