//! Kinetic and potential energy (J).
//!
//! T = 1/2 y' M_y y over all unknowns; V = - sum m g . p + sum 1/2 K (stretch)^2.

use super::active_force;
use super::mass_and_force::MassAndForce;
use crate::expr::ExprId;
use crate::expr::number::Number;
use crate::kinematics::{Kinematics, flatten, lower_scalar, lower_vector};
use crate::model::{LoadKind, Model};
use crate::vector::Algebra;

/// 1/2 y' M_y y.
pub(super) fn kinetic(alg: &mut Algebra, k: &Kinematics, parts: &MassAndForce) -> ExprId {
    let half = alg.dag.number(Number::rational(1, 2));
    let mut total = alg.dag.zero();
    for (&(a, b), &mass) in &parts.mass {
        let (y, z) = (k.unknowns[a].value, k.unknowns[b].value);
        let product = alg.dag.mul(y, z);
        let term = alg.dag.mul(mass, product);
        // Each off-diagonal entry stands for two.
        let term = if a == b { alg.dag.mul(half, term) } else { term };
        total = alg.dag.add(total, term);
    }
    total
}

/// Potential energy of gravity and springs; the height of O is zero.
pub(super) fn potential(alg: &mut Algebra, model: &Model, k: &Kinematics) -> ExprId {
    let mut total = alg.dag.zero();
    if let Some(gravity) = &model.gravity {
        let gravity = lower_vector(alg, k, gravity);
        for body in model.bodies.iter().filter(|b| b.weight) {
            if let Some(mass) = body.mass.as_ref().map(|m| lower_scalar(alg, k, m)) {
                let position = flatten(alg, k, &k.positions[body.centre]);
                let height = alg.dot(&gravity, &position);
                let term = alg.dag.mul(mass, height);
                total = alg.dag.sub(total, term);
            }
        }
    }
    let half = alg.dag.number(Number::rational(1, 2));
    for load in &model.loads {
        let (stiffness, stretch) = match &load.kind {
            LoadKind::Spring { ends, stiffness, rest_length, .. } => {
                let (stiffness, rest) = (lower_scalar(alg, k, stiffness), lower_scalar(alg, k, rest_length));
                let (_, length) = active_force::spring_line(alg, k, *ends);
                (stiffness, alg.dag.sub(length, rest))
            }
            LoadKind::CoordinateSpring { coordinate, stiffness, rest, .. } => {
                let (stiffness, rest) = (lower_scalar(alg, k, stiffness), lower_scalar(alg, k, rest));
                (stiffness, alg.dag.sub(k.q[*coordinate], rest))
            }
            LoadKind::Force { .. } | LoadKind::Torque { .. } => continue,
        };
        let square = alg.dag.mul(stretch, stretch);
        let term = alg.dag.mul(stiffness, square);
        let term = alg.dag.mul(half, term);
        total = alg.dag.add(total, term);
    }
    total
}
