//! Generalised active forces F_r: forces, torques, spring-dampers (weight stands with the inertia).
//!
//! F_k = sum v_k . F + w_k . tau. Sign of a spring: tension > 0 pulls its ends together.

use super::unprojected::Unprojected;
use crate::expr::ExprId;
use crate::kinematics::{Kinematics, Motion, flatten, lower_scalar, lower_vector, value_of};
use crate::model::{CoordinateId, Expr, LoadKind, Model, PointId};
use crate::vector::Vector;

/// Adds every load.
pub(super) fn accumulate(model: &Model, k: &mut Kinematics, parts: &mut Unprojected) {
    for load in &model.loads {
        add(k, parts, &load.kind);
    }
}

/// Adds one load.
pub(super) fn add(k: &mut Kinematics, parts: &mut Unprojected, kind: &LoadKind) {
    match kind {
        LoadKind::Force { point, force, reaction } => {
            let force = lower_vector(k, force);
            let motion = k.velocities[*point].clone();
            apply(k, parts, &motion, &force);
            if let Some(other) = reaction {
                let (motion, force) = (k.velocities[*other].clone(), force.negated(&mut k.dag));
                apply(k, parts, &motion, &force);
            }
        }
        LoadKind::Torque { frame, torque, reaction } => {
            let torque = lower_vector(k, torque);
            let motion = k.angular[k.frame_triad[*frame]].clone();
            apply(k, parts, &motion, &torque);
            if let Some(other) = reaction {
                let motion = k.angular[k.frame_triad[*other]].clone();
                let torque = torque.negated(&mut k.dag);
                apply(k, parts, &motion, &torque);
            }
        }
        LoadKind::Spring { ends, stiffness, rest_length, damping } => {
            spring(k, parts, *ends, stiffness, rest_length, damping.as_ref());
        }
        LoadKind::CoordinateSpring { coordinate, stiffness, rest, damping } => {
            coordinate_spring(k, parts, *coordinate, stiffness, rest, damping.as_ref());
        }
    }
}

/// F_k += v_k . force for every partial velocity of `motion`.
fn apply(k: &mut Kinematics, parts: &mut Unprojected, motion: &Motion, force: &Vector) {
    if force.is_zero() {
        return;
    }
    for (&unknown, partial) in &motion.partials {
        let term = k.triads.dot(&mut k.dag, partial, force);
        parts.add_force(&mut k.dag, unknown, term);
    }
}

/// The line from the first to the second end and its length.
pub(super) fn spring_line(k: &mut Kinematics, ends: [PointId; 2]) -> (Vector, ExprId) {
    let [a, b] = ends.map(|p| k.positions[p].clone());
    let line = b.minus(&mut k.dag, &a);
    let line = flatten(k, &line);
    let square = k.triads.dot(&mut k.dag, &line, &line);
    (line, k.dag.sqrt(square))
}

fn spring(
    k: &mut Kinematics,
    parts: &mut Unprojected,
    ends: [PointId; 2],
    stiffness: &Expr,
    rest_length: &Expr,
    damping: Option<&Expr>,
) {
    let (stiffness, rest_length) = (lower_scalar(k, stiffness), lower_scalar(k, rest_length));
    let (line, length) = spring_line(k, ends);
    let one = k.dag.one();
    let reciprocal = k.dag.div(one, length);
    let direction = line.scaled(&mut k.dag, reciprocal);
    let stretch = k.dag.sub(length, rest_length);
    let mut tension = k.dag.mul(stiffness, stretch);
    let [first, second] = ends.map(|p| k.velocities[p].clone());
    if let Some(damping) = damping.map(|d| lower_scalar(k, d)) {
        let (v_first, v_second) = (value_of(k, &first), value_of(k, &second));
        let opening = v_second.minus(&mut k.dag, &v_first);
        let length_rate = k.triads.dot(&mut k.dag, &opening, &direction);
        let term = k.dag.mul(damping, length_rate);
        tension = k.dag.add(tension, term);
    }
    let pull = direction.scaled(&mut k.dag, tension);
    apply(k, parts, &first, &pull);
    let push = pull.negated(&mut k.dag);
    apply(k, parts, &second, &push);
}

/// Generalised force -stiffness (q - rest) - damping q' on the rate of a coordinate.
fn coordinate_spring(
    k: &mut Kinematics,
    parts: &mut Unprojected,
    coordinate: CoordinateId,
    stiffness: &Expr,
    rest: &Expr,
    damping: Option<&Expr>,
) {
    let (stiffness, rest) = (lower_scalar(k, stiffness), lower_scalar(k, rest));
    let stretch = k.dag.sub(k.q[coordinate], rest);
    let mut force = k.dag.mul(stiffness, stretch);
    let rate = k.rates[coordinate].clone();
    if let Some(damping) = damping.map(|d| lower_scalar(k, d)) {
        let q_dot = crate::kinematics::rate_of(k, &rate);
        let term = k.dag.mul(damping, q_dot);
        force = k.dag.add(force, term);
    }
    for (&unknown, &partial) in &rate.partials {
        let term = k.dag.mul(partial, force);
        let term = k.dag.negate(term);
        parts.add_force(&mut k.dag, unknown, term);
    }
}
