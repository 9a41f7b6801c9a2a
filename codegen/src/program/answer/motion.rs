//! Answers about a place (a port, a point or a frame): its pose, its motion, and its effective inertia.

use super::part::Part;
use super::stages::{Stages, Target};
use crate::diagnostic::Diagnostic;
use crate::dynamics;
use crate::expr::ExprId;

type Parts = Result<Vec<Part>, Diagnostic>;

/// Names of the components of a twist.
fn components(target: &Target) -> Vec<String> {
    let marker = target.marker;
    let velocity = marker.and_then(|p| p.point).map(|_| ["v_x", "v_y", "v_z"]);
    let angular = marker.and_then(|p| p.frame).map(|_| ["w_x", "w_y", "w_z"]);
    velocity.into_iter().chain(angular).flatten().map(str::to_owned).collect()
}

pub(super) fn pose(stages: &mut Stages, target: &Target) -> Parts {
    let Some(marker) = target.marker else { return Ok(Vec::new()) };
    let mut parts = Vec::new();
    if let Some(point) = marker.unlocated(stages.model, stages.k) {
        let name = &stages.model.points[point].name;
        return Err(Diagnostic::error(format!(
            "`{}`: the position of `{name}` is not known: the model states its velocity",
            target.request
        ))
        .help("ask for its twist, or locate the point by coordinates"));
    }
    if let Some(position) = marker.position(stages.alg, stages.k) {
        let labels = ["x", "y", "z"].map(str::to_owned).to_vec();
        let values = stages.solved(&position);
        parts.push(Part::list("position", "from O, along N's axes (m)", labels, values));
    }
    if let Some(rotation) = marker.rotation(stages.alg, stages.k) {
        let rows: Vec<Vec<ExprId>> = rotation.iter().map(|row| stages.solved(row)).collect();
        let doc = "columns: the frame's axes along N's";
        parts.push(Part::matrix("rotation", doc, Vec::new(), 3, &rows));
    }
    Ok(parts)
}

pub(super) fn twist(stages: &mut Stages, target: &Target) -> Parts {
    let Some(marker) = target.marker else { return Ok(Vec::new()) };
    let twist = marker.twist(stages.alg, stages.k);
    let twist = stages.solved(&twist);
    let doc = "velocity of the point (m/s), angular velocity of the frame (rad/s), along N's axes";
    Ok(vec![Part::list("twist", doc, components(target), twist)])
}

pub(super) fn bias_acceleration(stages: &mut Stages, target: &Target) -> Parts {
    let Some(marker) = target.marker else { return Ok(Vec::new()) };
    let bias = marker.bias(stages.alg, stages.k, stages.solution);
    let bias = stages.solved(&bias);
    let doc = "twist' where u' = 0, along N's axes (m/s^2, rad/s^2)";
    Ok(vec![Part::list("bias_acceleration", doc, components(target), bias)])
}

pub(super) fn jacobian(stages: &mut Stages, target: &Target) -> Parts {
    let rows = jacobian_rows(stages, target);
    let doc = "J of twist = J u, and what time alone moves; one column an independent speed";
    Ok(vec![Part::matrix("jacobian", doc, components(target), stages.n_speeds(), &rows)])
}

fn jacobian_rows(stages: &mut Stages, target: &Target) -> Vec<Vec<ExprId>> {
    let rows = target
        .marker
        .map(|marker| marker.jacobian(stages.alg, stages.k, stages.solution))
        .unwrap_or_default();
    rows.iter().map(|row| stages.solved(row)).collect()
}

pub(super) fn inverse_inertia(stages: &mut Stages, target: &Target) -> Parts {
    let rows = jacobian_rows(stages, target);
    let inverse = dynamics::inverse_inertia(&mut stages.alg.dag, &stages.dynamics.mass_matrix, &rows);
    let doc = "J M^-1 J': how the twist changes by an impulse and a moment of impulse there (1/kg, 1/(kg m), 1/(kg m^2))";
    Ok(vec![Part::matrix("inverse_inertia", doc, components(target), rows.len(), &inverse)])
}

/// All answers about a port.
pub(super) fn port(stages: &mut Stages, target: &Target) -> Parts {
    let mut parts = Vec::new();
    for derive in [pose, twist, bias_acceleration, jacobian, inverse_inertia] {
        parts.extend(derive(stages, target)?);
    }
    Ok(parts)
}
