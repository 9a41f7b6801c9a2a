//! Kinetic and potential energy (J).
//!
//! T = 1/2 y' M_y y over all unknowns; V = - sum m g . p + sum 1/2 K (stretch)^2.

use super::active_force;
use super::unprojected::Unprojected;
use crate::expr::ExprId;
use crate::expr::number::Number;
use crate::kinematics::{Kinematics, flatten, lower_scalar, lower_vector};
use crate::model::{LoadKind, Model};

/// 1/2 y' M_y y.
pub(super) fn kinetic(k: &mut Kinematics, parts: &Unprojected) -> ExprId {
    let half = k.dag.number(Number::rational(1, 2));
    let mut total = k.dag.zero();
    for (&(a, b), &mass) in &parts.mass {
        let (y, z) = (k.unknowns[a].value, k.unknowns[b].value);
        let product = k.dag.mul(y, z);
        let term = k.dag.mul(mass, product);
        // Off-diagonal entries stand for two.
        let term = if a == b { k.dag.mul(half, term) } else { term };
        total = k.dag.add(total, term);
    }
    total
}

/// Energy of gravity and of springs; zero height is the origin's.
pub(super) fn potential(model: &Model, k: &mut Kinematics) -> ExprId {
    let mut total = k.dag.zero();
    if let Some(gravity) = &model.gravity {
        let gravity = lower_vector(k, gravity);
        for body in model.bodies.iter().filter(|b| b.weight) {
            if let Some(mass) = body.mass.as_ref().map(|m| lower_scalar(k, m)) {
                let position = k.positions[body.centre].clone();
                let position = flatten(k, &position);
                let height = k.triads.dot(&mut k.dag, &gravity, &position);
                let term = k.dag.mul(mass, height);
                total = k.dag.sub(total, term);
            }
        }
    }
    let half = k.dag.number(Number::rational(1, 2));
    for load in &model.loads {
        let (stiffness, stretch) = match &load.kind {
            LoadKind::Spring { ends, stiffness, rest_length, .. } => {
                let (stiffness, rest) = (lower_scalar(k, stiffness), lower_scalar(k, rest_length));
                let (_, length) = active_force::spring_line(k, *ends);
                (stiffness, k.dag.sub(length, rest))
            }
            LoadKind::CoordinateSpring { coordinate, stiffness, rest, .. } => {
                let (stiffness, rest) = (lower_scalar(k, stiffness), lower_scalar(k, rest));
                (stiffness, k.dag.sub(k.q[*coordinate], rest))
            }
            LoadKind::Force { .. } | LoadKind::Torque { .. } => continue,
        };
        let square = k.dag.mul(stretch, stretch);
        let term = k.dag.mul(stiffness, square);
        let term = k.dag.mul(half, term);
        total = k.dag.add(total, term);
    }
    total
}
