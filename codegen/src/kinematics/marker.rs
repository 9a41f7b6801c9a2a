//! Pose, twist and acceleration of a point and a frame, as linear forms in the independent speeds.
//!
//! In: the motions of points and triads over all unknowns y, and y = T u, y' = T u' + beta from the constraints. Out:
//! components in N. A twist is the velocity of the point followed by the angular velocity of the frame: `twist = J u +
//! v_t` and `twist' = J u' + bias`, where v_t (Kane) is the part without speeds in a driven model.

use super::eliminate::Solution;
use super::lifted::{flatten, point_is_lifted};
use super::linear_form::LinearForm;
use super::quantities::{Kinematics, Motion};
use super::unknowns::UnknownId;
use crate::expr::ExprId;
use crate::model::{Axis, FrameId, Model, PointId};
use crate::vector::{Algebra, TriadId, Vector};

/// A point, a frame, or a frame with a point in it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Marker {
    /// The point whose position and velocity are asked for.
    pub point: Option<PointId>,
    /// The frame whose attitude and angular velocity are asked for.
    pub frame: Option<FrameId>,
}

impl Marker {
    /// The point, if its position is known only up to a displacement because the model states its velocity.
    #[must_use]
    pub fn unlocated(&self, model: &Model, k: &Kinematics) -> Option<PointId> {
        let points = self.point.into_iter().flat_map(|p| k.positions[p].points.keys().copied());
        points.into_iter().find(|&p| point_is_lifted(model, p) && model.points[p].velocity.is_some())
    }

    /// Position of the point from O.
    pub fn position(&self, alg: &mut Algebra, k: &Kinematics) -> Option<[ExprId; 3]> {
        let position = flatten(alg, k, &k.positions[self.point?]);
        Some(in_n(alg, &position))
    }

    /// The matrix whose columns are the frame's axes.
    pub fn rotation(&self, alg: &mut Algebra, k: &Kinematics) -> Option<[[ExprId; 3]; 3]> {
        let triad = k.frame_triad[self.frame?];
        let axes = [Axis::X, Axis::Y, Axis::Z].map(|axis| {
            let axis = Vector::axis(&mut alg.dag, triad, axis);
            in_n(alg, &axis)
        });
        Some(std::array::from_fn(|i| axes.map(|axis| axis[i])))
    }

    /// Motion of the point and of the frame, those that exist.
    fn motions<'k>(&self, k: &'k Kinematics) -> Vec<&'k Motion> {
        let velocity = self.point.map(|point| &k.velocities[point]);
        let angular = self.frame.map(|frame| &k.angular[k.frame_triad[frame]]);
        velocity.into_iter().chain(angular).collect()
    }

    /// The twist, in terms of the symbols of all unknowns.
    pub fn twist(&self, alg: &mut Algebra, k: &Kinematics) -> Vec<ExprId> {
        let motions = self.motions(k);
        let mut twist = Vec::new();
        for motion in motions {
            let value = motion.value(alg, k);
            twist.extend(in_n(alg, &value));
        }
        twist
    }

    /// J: one row per component of the twist, one column per independent speed.
    pub fn jacobian(&self, alg: &mut Algebra, k: &Kinematics, solution: &Solution) -> Vec<Vec<ExprId>> {
        let n = k.unknowns.independent().len();
        let mut rows = Vec::new();
        for motion in self.motions(k) {
            let partials = partials_in_n(alg, motion);
            for axis in 0..3 {
                let row = (0..n).map(|j| {
                    let each = partials.iter().map(|(y, v)| (v[axis], solution.partials[y][j]));
                    let terms: Vec<ExprId> =
                        each.collect::<Vec<_>>().into_iter().map(|(v, t)| alg.dag.mul(v, t)).collect();
                    alg.dag.sum(&terms)
                });
                rows.push(row.collect());
            }
        }
        rows
    }

    /// The derivative of the twist at u' = 0, in terms of the symbols of all unknowns.
    pub fn bias(&self, alg: &mut Algebra, k: &Kinematics, solution: &Solution) -> Vec<ExprId> {
        let beta = solution.derivatives(alg, LinearForm::default());
        let mut bias = Vec::new();
        for motion in self.motions(k) {
            let own = in_n(alg, &motion.bias);
            let partials = partials_in_n(alg, motion);
            for axis in 0..3 {
                let mut sum = own[axis];
                for (y, v) in &partials {
                    if let Some(&b) = beta.get(y) {
                        let term = alg.dag.mul(v[axis], b);
                        sum = alg.dag.add(sum, term);
                    }
                }
                bias.push(sum);
            }
        }
        bias
    }
}

impl Solution {
    /// Completes y' = T u' + beta from the given u'; with none given the result is beta.
    pub(crate) fn derivatives(&self, alg: &mut Algebra, mut y_dot: LinearForm) -> LinearForm {
        for step in self.steps.iter().rev() {
            let mut sum = step.bias;
            for (z, &c) in &step.coefficients {
                if let Some(&z_dot) = y_dot.get(z) {
                    let term = alg.dag.mul(c, z_dot);
                    sum = alg.dag.add(sum, term);
                }
            }
            y_dot.insert(step.unknown, sum);
        }
        y_dot
    }
}

fn in_n(alg: &mut Algebra, vector: &Vector) -> [ExprId; 3] {
    alg.express(vector, TriadId::INERTIAL)
}

fn partials_in_n(alg: &mut Algebra, motion: &Motion) -> Vec<(UnknownId, [ExprId; 3])> {
    motion.partials.iter().map(|(&y, v)| (y, in_n(alg, v))).collect()
}
