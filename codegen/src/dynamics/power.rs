//! Power of every load and of the weight.
//!
//! In: loads as generalised forces over all unknowns y. Out: F . y for each, the power that it supplies to the
//! mechanism (W). Together with the drive's power they sum to the rate of the kinetic energy, because constraints do no
//! work.

use super::active_force;
use super::mass_and_force::MassAndForce;
use crate::expr::ExprId;
use crate::kinematics::{Kinematics, lower_scalar, lower_vector};
use crate::model::{LoadKind, Model};
use crate::vector::Algebra;

/// Name and power of each load, in terms of the symbols of all unknowns; the weight last.
pub(crate) fn powers(alg: &mut Algebra, model: &Model, k: &Kinematics) -> Vec<(String, ExprId)> {
    let mut found = Vec::new();
    for load in &model.loads {
        let kind = match load.kind {
            LoadKind::Force { .. } => "force",
            LoadKind::Torque { .. } => "torque",
            LoadKind::Spring { .. } | LoadKind::CoordinateSpring { .. } => "spring",
        };
        let mut parts = MassAndForce::default();
        active_force::add(alg, k, &mut parts, &load.kind);
        let mut terms = Vec::new();
        for (unknown, force) in parts.force {
            terms.push(alg.dag.mul(force, k.unknowns[unknown].value));
        }
        found.push((format!("{kind} {}", load.name), alg.dag.sum(&terms)));
    }
    if let Some(gravity) = &model.gravity {
        let gravity = lower_vector(alg, k, gravity);
        let mut terms = Vec::new();
        for body in model.bodies.iter().filter(|body| body.weight) {
            let Some(mass) = &body.mass else { continue };
            let mass = lower_scalar(alg, k, mass);
            let velocity = k.velocities[body.centre].value(alg, k);
            let falling = alg.dot(&velocity, &gravity);
            terms.push(alg.dag.mul(mass, falling));
        }
        found.push(("weight".to_owned(), alg.dag.sum(&terms)));
    }
    found
}
