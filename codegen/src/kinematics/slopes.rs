//! Derivatives of the dependent coordinates by the independent ones: P of dq = P dq_i with f_q P = 0.
//!
//! In: configuration constraints f(q, t) = 0. Out: one row per dependent coordinate. Motion constraints play no part.
//! If there are none, and the independent speeds are the rates of the independent coordinates, P follows from the
//! elimination of the velocities: q_dependent' = P q_independent'.

use super::eliminate::Solution;
use super::linear;
use super::quantities::Kinematics;
use super::sparse::{self, Equation};
use super::unknowns::UnknownId;
use crate::expr::tape::SampleTable;
use crate::expr::{ExprId, SymbolId};
use crate::id::Id;
use crate::model::{CoordinateId, Model};
use crate::vector::Algebra;

/// Derivatives of the dependent coordinates; `None` if the constraints do not determine them.
pub(crate) fn dependent_slopes(
    alg: &mut Algebra,
    k: &Kinematics,
    table: &mut SampleTable,
    dependent: &[SymbolId],
    independent: &[SymbolId],
) -> Option<Vec<Vec<ExprId>>> {
    let n = dependent.len();
    let mut equations: Vec<Equation> = Vec::new();
    let mut numbers: Vec<Vec<f64>> = vec![Vec::new(); table.points()];
    for &residual in &k.residuals {
        if equations.len() == n {
            break;
        }
        let slopes: Vec<ExprId> =
            dependent.iter().map(|&symbol| alg.dag.derivative(residual, symbol)).collect();
        // A row is taken only if it is independent of those taken before, at every sample.
        let mut is_new = true;
        for (sample, taken) in numbers.iter_mut().enumerate() {
            let row = slopes.iter().map(|&e| table.values(&alg.dag, e)[sample]);
            taken.extend(row.collect::<Vec<_>>());
            let rows = equations.len() + 1;
            is_new &= linear::solve(taken, &mut vec![0.0; rows], n).1 == rows;
        }
        if !is_new {
            numbers.iter_mut().for_each(|taken| taken.truncate(equations.len() * n));
            continue;
        }
        let entries = slopes.into_iter().enumerate().filter(|(_, e)| !alg.dag.is_zero(*e));
        let coefficients = entries.map(|(j, e)| (UnknownId::from_index(j), e)).collect();
        let mut right = Vec::new();
        for &symbol in independent {
            let slope = alg.dag.derivative(residual, symbol);
            right.push(alg.dag.negate(slope));
        }
        equations.push(Equation { coefficients, right });
    }
    if equations.len() < n {
        return None;
    }
    let (values, _) = sparse::solve(&mut alg.dag, table, equations)?;
    (0..n).map(|j| values.get(&UnknownId::from_index(j)).cloned()).collect()
}

/// The index of the independent speed that is the rate of each of these coordinates. `None` if one of them has another
/// kind of rate or if there are motion constraints: P does not follow from the velocities then.
pub(crate) fn speeds_of(
    alg: &Algebra,
    model: &Model,
    k: &Kinematics,
    solution: &Solution,
    independent: &[CoordinateId],
) -> Option<Vec<usize>> {
    let is_holonomic =
        model.motion_constraints.is_empty() && model.points.iter().all(|point| point.velocity.is_none());
    if !is_holonomic || !solution.ties.is_empty() {
        return None;
    }
    let speeds = k.unknowns.independent();
    let mut places = Vec::new();
    for &c in independent {
        let mut partials = k.rates[c].partials.iter();
        let (Some((unknown, &factor)), None) = (partials.next(), partials.next()) else { return None };
        let place = speeds.iter().position(|speed| speed == unknown)?;
        if !alg.dag.is_one(factor) || places.contains(&place) {
            return None;
        }
        places.push(place);
    }
    Some(places)
}

/// P from the partial velocities: q_dependent' = P q_independent'.
pub(crate) fn slopes_by_speeds(
    alg: &mut Algebra,
    k: &Kinematics,
    solution: &Solution,
    dependent: &[CoordinateId],
    speeds: &[usize],
) -> Vec<Vec<ExprId>> {
    let mut rows = Vec::new();
    for &c in dependent {
        let partials = &k.rates[c].partials;
        let mut row = Vec::new();
        for &speed in speeds {
            let each = partials.iter().map(|(unknown, &n)| alg.dag.mul(n, solution.partials[unknown][speed]));
            let terms: Vec<ExprId> = each.collect();
            row.push(alg.dag.sum(&terms));
        }
        rows.push(row);
    }
    rows
}
