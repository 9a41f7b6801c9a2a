//! Power of every load and of the weight.
//!
//! In: loads as generalised forces over all unknowns y. Out: F . y for each, what it puts into the mechanism (W). With
//! the drive's power they sum to the rate of the kinetic energy: constraints do no work.

use super::active_force;
use super::unprojected::Unprojected;
use crate::expr::ExprId;
use crate::kinematics::{Kinematics, lower_scalar, lower_vector, value_of};
use crate::model::{LoadKind, Model};

/// What each load is called, with its power in the symbols of all unknowns; the weight last.
pub(crate) fn powers(model: &Model, k: &mut Kinematics) -> Vec<(String, ExprId)> {
    let mut found = Vec::new();
    for load in &model.loads {
        let kind = match load.kind {
            LoadKind::Force { .. } => "force",
            LoadKind::Torque { .. } => "torque",
            LoadKind::Spring { .. } | LoadKind::CoordinateSpring { .. } => "spring",
        };
        let mut parts = Unprojected::default();
        active_force::add(k, &mut parts, &load.kind);
        let mut terms = Vec::new();
        for (unknown, force) in parts.force {
            terms.push(k.dag.mul(force, k.unknowns[unknown].value));
        }
        found.push((format!("{kind} {}", load.name), k.dag.sum(&terms)));
    }
    if let Some(gravity) = &model.gravity {
        let gravity = lower_vector(k, gravity);
        let mut terms = Vec::new();
        for body in model.bodies.iter().filter(|body| body.weight) {
            let Some(mass) = &body.mass else { continue };
            let mass = lower_scalar(k, mass);
            let motion = k.velocities[body.centre].clone();
            let velocity = value_of(k, &motion);
            let falling = k.triads.dot(&mut k.dag, &velocity, &gravity);
            terms.push(k.dag.mul(mass, falling));
        }
        found.push(("weight".to_owned(), k.dag.sum(&terms)));
    }
    found
}
