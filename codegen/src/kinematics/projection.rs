//! Newton's correction of the configuration in models whose motion constraints determine some of the speeds.
//!
//! In: candidate rows. Out: for every unknown y the correction delta of the coordinate of which y is the rate.
//! Configuration constraints alone determine it, J_c delta = -residual: as many coordinates are corrected as these
//! constraints have independent rows. Coordinates whose speeds follow from motion constraints are held, because no
//! constraint restricts their values.

use super::eliminate::{self, Form, Solution, System};
use super::linear_form::LinearForm;
use super::quantities::{Kinematics, Row};
use super::rank;
use super::unknowns::{UnknownId, UnknownKind};
use crate::expr::ExprId;
use crate::expr::tape::SampleTable;
use crate::model::{Model, SpeedMeaning};
use crate::vector::Algebra;

/// A pivot must keep this share of its nominal value at all samples. Otherwise the correction of the velocities'
/// elimination is used, whose pivots are watched in every step.
const HEALTHY: f64 = 0.02;

/// Replaces the corrections of a solution by those of the configuration constraints alone, if it solved motion
/// constraints.
pub fn correct(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    table: &mut SampleTable,
    solution: &mut Solution,
) {
    if let Some(correction) = corrections_apart_from_motion(alg, model, k, table, solution) {
        solution.correction = correction;
    }
}

/// The corrections by unknown; `None` if those of the velocities' elimination are right already: it solved no motion
/// constraint, or the configuration constraints do not determine all coordinates that are not held.
fn corrections_apart_from_motion(
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
    // Rows without held unknowns were solved in the velocities' elimination exactly as they would be by themselves.
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

/// Is the unknown the rate of a coordinate that no configuration constraint determines?
fn is_held(model: &Model, k: &Kinematics, unknown: UnknownId) -> bool {
    match k.unknowns[unknown].kind {
        UnknownKind::Dependent(speed) => match model.speeds[speed].meaning {
            SpeedMeaning::RateOf(coordinate) => model.coordinates[coordinate].independent,
            SpeedMeaning::Combination(_) => false,
        },
        UnknownKind::Independent(_) | UnknownKind::Lifted | UnknownKind::Clock => false,
    }
}

/// Does the pivot keep its sign and the share [`HEALTHY`] of its nominal value at every sample?
fn is_healthy(alg: &Algebra, table: &mut SampleTable, pivot: ExprId) -> bool {
    let values = table.values(&alg.dag, pivot);
    values.iter().all(|x| *x / values[0] >= HEALTHY)
}
