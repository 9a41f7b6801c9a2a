//! Newton's correction of the configuration where motion constraints give some of the speeds.
//!
//! In: candidate rows. Out: for every unknown y the correction delta of what y is the rate of. Configuration
//! constraints restrict coordinates by their own Jacobian alone, J_c delta = -residual: as many coordinates are
//! corrected as these constraints have rows. The others, whose speeds motion constraints give, stay where they are:
//! no constraint says that they are wrong.

use super::eliminate::{self, Form, Solution, System};
use super::linear_form::LinearForm;
use super::quantities::{Kinematics, Row};
use super::rank;
use super::unknowns::{UnknownId, UnknownKind};
use crate::expr::ExprId;
use crate::expr::tape::SampleTable;
use crate::model::{Model, SpeedMeaning};
use crate::vector::Algebra;

/// A pivot must keep this share of its nominal size at all samples: else the elimination of the velocities, whose
/// pivots every step watches, serves for the correction too.
const HEALTHY: f64 = 0.02;

/// Gives a solution the corrections of the configuration constraints alone, where its own are those of rows of motion too.
pub fn correct(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    table: &mut SampleTable,
    solution: &mut Solution,
) {
    if let Some(correction) = beside_motion(alg, model, k, table, solution) {
        solution.correction = correction;
    }
}

/// The corrections by unknown; none where those of the elimination of the velocities serve: it has solved no motion
/// constraint, or the configuration constraints do not determine what is not held.
fn beside_motion(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    table: &mut SampleTable,
    solution: &Solution,
) -> Option<LinearForm> {
    let (held, unknown): (Vec<UnknownId>, Vec<UnknownId>) =
        k.unknowns.dependent().into_iter().partition(|&y| is_held(model, k, y));
    let is_motion = |row: &&Row| model.motion_constraints.iter().any(|c| c.name == row.name);
    let rows: Vec<Row> = k.rows.iter().filter(|row| !is_motion(row)).cloned().collect();
    if !solution.rows.iter().any(|row| is_motion(&row)) || rows.is_empty() {
        return None;
    }
    let zero = alg.dag.zero();
    // Rows that do not read what is held have been solved beside the motion constraints as they would be alone.
    let reads_held = rows.iter().any(|row| row.coefficients.keys().any(|y| held.contains(y)));
    if !reads_held && solution.rows.iter().filter(|row| !is_motion(row)).count() == unknown.len() {
        let mut corrections = solution.correction.clone();
        corrections.extend(held.into_iter().map(|y| (y, zero)));
        return Some(corrections);
    }
    let all = rank::ranks(alg, table, &rows, &k.unknowns.moving());
    if all.iter().any(|&rank| rank != unknown.len()) {
        return None;
    }
    let restricted = |rows: Vec<Row>| -> Vec<Row> {
        let restrict = |mut row: Row| {
            row.coefficients.retain(|y, _| unknown.contains(y));
            Row { bias: zero, ..row }
        };
        rows.into_iter().map(restrict).filter(|row| !row.coefficients.is_empty()).collect()
    };
    let (rows, spare) = (restricted(rows), restricted(k.spare_rows.clone()));
    let system = System { rows, spare, unknown, known: Vec::new() };
    let form = eliminate::form(alg, model, k, table, &system)?;
    if form.pivots().iter().any(|&pivot| !is_healthy(alg, table, pivot)) {
        return None;
    }
    let Form { values, .. } = form;
    let mut corrections: LinearForm = k.unknowns.ids().map(|y| (y, zero)).collect();
    corrections.extend(values.into_iter().filter_map(|(y, values)| Some((y, *values.last()?))));
    Some(corrections)
}

/// Is the unknown the rate of a coordinate that no configuration constraint gives?
fn is_held(model: &Model, k: &Kinematics, unknown: UnknownId) -> bool {
    match k.unknowns[unknown].kind {
        UnknownKind::Dependent(speed) => match model.speeds[speed].meaning {
            SpeedMeaning::RateOf(coordinate) => model.coordinates[coordinate].independent,
            SpeedMeaning::Combination(_) => false,
        },
        UnknownKind::Independent(_) | UnknownKind::Lifted | UnknownKind::Clock => false,
    }
}

/// Has the pivot one sign and a good part of its nominal size at every sample?
fn is_healthy(alg: &Algebra, table: &mut SampleTable, pivot: ExprId) -> bool {
    let values = table.values(&alg.dag, pivot);
    values.iter().all(|x| *x / values[0] >= HEALTHY)
}
