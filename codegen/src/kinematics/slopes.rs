//! Derivatives of the dependent coordinates by the independent ones: P of dq = P dq_i with f_q P = 0.
//!
//! In: configuration constraints f(q, t) = 0. Out: one row per dependent coordinate. Motion constraints play no part.
//! If there are none, and the independent speeds are sums of rates of the independent coordinates, P follows from the
//! elimination of the velocities: q_dependent' = P q_independent'.

use super::eliminate::Solution;
use super::linear;
use super::quantities::Kinematics;
use super::sparse::{self, Equation};
use super::unknowns::{UnknownId, UnknownKind};
use crate::expr::tape::SampleTable;
use crate::expr::{ExprId, SymbolId};
use crate::id::Id;
use crate::model::{CoordinateId, Model, SpeedMeaning};
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

/// The independent speeds in the rates of the independent coordinates: for each coordinate the indices of the speeds
/// that contain its rate, with the coefficients. `None` if a speed contains another rate, if none contains that of a
/// coordinate, or if there are motion constraints: P does not follow from the velocities then.
pub(crate) fn speeds_by_rates(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    solution: &Solution,
    independent: &[CoordinateId],
) -> Option<Vec<Vec<(usize, ExprId)>>> {
    let is_holonomic =
        model.motion_constraints.is_empty() && model.points.iter().all(|point| point.velocity.is_none());
    if !is_holonomic || !solution.ties.is_empty() {
        return None;
    }
    let mut speeds = vec![Vec::new(); independent.len()];
    for (place, unknown) in k.unknowns.independent().into_iter().enumerate() {
        let UnknownKind::Independent(speed) = k.unknowns[unknown].kind else { return None };
        let rates: Vec<(usize, ExprId)> = match model.speeds[speed].meaning {
            SpeedMeaning::RateOf(coordinate) => vec![(coordinate.index(), alg.dag.one())],
            SpeedMeaning::Combination(_) => {
                let (_, form) = k.combinations.iter().find(|(of, _)| *of == unknown)?;
                form.iter().map(|(rate, &coefficient)| (rate.index(), coefficient)).collect()
            }
        };
        for (rate, coefficient) in rates {
            let column = independent.iter().position(|c| c.index() == rate)?;
            speeds[column].push((place, coefficient));
        }
    }
    speeds.iter().all(|column| !column.is_empty()).then_some(speeds)
}

/// P from the partial velocities: q_dependent' = P q_independent'. No pivot but those of the velocities is divided by.
pub(crate) fn slopes_by_speeds(
    alg: &mut Algebra,
    k: &Kinematics,
    solution: &Solution,
    dependent: &[CoordinateId],
    speeds: &[Vec<(usize, ExprId)>],
) -> Vec<Vec<ExprId>> {
    let mut rows = Vec::new();
    for &c in dependent {
        let partials = &k.rates[c].partials;
        let by_speed = |alg: &mut Algebra, place: usize| {
            let each = partials.iter().map(|(unknown, &n)| alg.dag.mul(n, solution.partials[unknown][place]));
            let terms: Vec<ExprId> = each.collect();
            alg.dag.sum(&terms)
        };
        let mut row = Vec::new();
        for column in speeds {
            let mut terms = Vec::new();
            for &(place, coefficient) in column {
                let slope = by_speed(alg, place);
                terms.push(alg.dag.mul(coefficient, slope));
            }
            row.push(alg.dag.sum(&terms));
        }
        rows.push(row);
    }
    rows
}
