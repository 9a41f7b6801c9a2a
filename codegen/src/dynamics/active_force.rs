//! Generalised active forces F_r of forces, torques and spring-dampers (weight is treated with the inertia).
//!
//! F_k = sum v_k . F + w_k . tau, with v_k and w_k the partial velocities. A spring with tension > 0 pulls its ends
//! together.

use super::mass_and_force::MassAndForce;
use crate::expr::ExprId;
use crate::kinematics::{Kinematics, Motion, flatten, lower_scalar, lower_vector};
use crate::model::{CoordinateId, Expr, LoadKind, Model, PointId};
use crate::vector::{Algebra, Vector};

/// Adds the generalised forces of every load.
pub(super) fn accumulate(alg: &mut Algebra, model: &Model, k: &Kinematics, parts: &mut MassAndForce) {
    for load in &model.loads {
        add(alg, k, parts, &load.kind);
    }
}

/// Adds the generalised forces of one load.
pub(super) fn add(alg: &mut Algebra, k: &Kinematics, parts: &mut MassAndForce, kind: &LoadKind) {
    match kind {
        LoadKind::Force { point, force, reaction } => {
            let force = lower_vector(alg, k, force);
            let motion = &k.velocities[*point];
            apply(alg, parts, motion, &force);
            if let Some(other) = reaction {
                let (motion, force) = (&k.velocities[*other], force.negated(&mut alg.dag));
                apply(alg, parts, motion, &force);
            }
        }
        LoadKind::Torque { frame, torque, reaction } => {
            let torque = lower_vector(alg, k, torque);
            let motion = &k.angular[k.frame_triad[*frame]];
            apply(alg, parts, motion, &torque);
            if let Some(other) = reaction {
                let motion = &k.angular[k.frame_triad[*other]];
                let torque = torque.negated(&mut alg.dag);
                apply(alg, parts, motion, &torque);
            }
        }
        LoadKind::Spring { ends, stiffness, rest_length, damping } => {
            spring(alg, k, parts, *ends, stiffness, rest_length, damping.as_ref());
        }
        LoadKind::CoordinateSpring { coordinate, stiffness, rest, damping } => {
            coordinate_spring(alg, k, parts, *coordinate, stiffness, rest, damping.as_ref());
        }
    }
}

/// F_k += v_k . force for every partial velocity of `motion`.
fn apply(alg: &mut Algebra, parts: &mut MassAndForce, motion: &Motion, force: &Vector) {
    if force.is_zero() {
        return;
    }
    for (&unknown, partial) in &motion.partials {
        let term = alg.dot(partial, force);
        parts.add_force(&mut alg.dag, unknown, term);
    }
}

/// The vector from the first end to the second, and its length.
pub(super) fn spring_line(alg: &mut Algebra, k: &Kinematics, ends: [PointId; 2]) -> (Vector, ExprId) {
    let [a, b] = ends.map(|p| &k.positions[p]);
    let line = b.minus(&mut alg.dag, a);
    let line = flatten(alg, k, &line);
    let square = alg.square(&line);
    (line, alg.dag.sqrt(square))
}

fn spring(
    alg: &mut Algebra,
    k: &Kinematics,
    parts: &mut MassAndForce,
    ends: [PointId; 2],
    stiffness: &Expr,
    rest_length: &Expr,
    damping: Option<&Expr>,
) {
    let (stiffness, rest_length) = (lower_scalar(alg, k, stiffness), lower_scalar(alg, k, rest_length));
    let (line, length) = spring_line(alg, k, ends);
    let one = alg.dag.one();
    let reciprocal = alg.dag.div(one, length);
    let direction = line.scaled(&mut alg.dag, reciprocal);
    let stretch = alg.dag.sub(length, rest_length);
    let mut tension = alg.dag.mul(stiffness, stretch);
    let [first, second] = ends.map(|p| &k.velocities[p]);
    if let Some(damping) = damping.map(|d| lower_scalar(alg, k, d)) {
        let (v_first, v_second) = (first.value(alg, k), second.value(alg, k));
        let opening = v_second.minus(&mut alg.dag, &v_first);
        let length_rate = alg.dot(&opening, &direction);
        let term = alg.dag.mul(damping, length_rate);
        tension = alg.dag.add(tension, term);
    }
    let pull = direction.scaled(&mut alg.dag, tension);
    apply(alg, parts, first, &pull);
    let push = pull.negated(&mut alg.dag);
    apply(alg, parts, second, &push);
}

/// Generalised force -stiffness (q - rest) - damping q', conjugate to the rate of a coordinate.
fn coordinate_spring(
    alg: &mut Algebra,
    k: &Kinematics,
    parts: &mut MassAndForce,
    coordinate: CoordinateId,
    stiffness: &Expr,
    rest: &Expr,
    damping: Option<&Expr>,
) {
    let (stiffness, rest) = (lower_scalar(alg, k, stiffness), lower_scalar(alg, k, rest));
    let stretch = alg.dag.sub(k.q[coordinate], rest);
    let mut force = alg.dag.mul(stiffness, stretch);
    let rate = &k.rates[coordinate];
    if let Some(damping) = damping.map(|d| lower_scalar(alg, k, d)) {
        let q_dot = rate.value(alg, k);
        let term = alg.dag.mul(damping, q_dot);
        force = alg.dag.add(force, term);
    }
    for (&unknown, &partial) in &rate.partials {
        let term = alg.dag.mul(partial, force);
        let term = alg.dag.negate(term);
        parts.add_force(&mut alg.dag, unknown, term);
    }
}
