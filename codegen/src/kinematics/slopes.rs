//! How dependent coordinates follow the independent ones: P of dq = P dq_i with f_q P = 0.
//!
//! In: configuration constraints f(q, t) = 0. Out: one row a dependent coordinate. Motion constraints have no part in it.

use super::linear;
use super::quantities::{Kinematics, UnknownId};
use super::sparse::{self, Equation};
use crate::expr::tape::SampleTable;
use crate::expr::{ExprId, SymbolId};
use crate::id::Id;

/// Slopes of the dependent coordinates; none where the constraints do not determine them.
pub(crate) fn dependent_slopes(
    k: &mut Kinematics,
    table: &mut SampleTable,
    dependent: &[SymbolId],
    independent: &[SymbolId],
) -> Option<Vec<Vec<ExprId>>> {
    let n = dependent.len();
    let mut equations: Vec<Equation> = Vec::new();
    let mut numbers: Vec<Vec<f64>> = vec![Vec::new(); table.points()];
    for residual in k.residuals.clone() {
        if equations.len() == n {
            break;
        }
        let slopes: Vec<ExprId> =
            dependent.iter().map(|&symbol| k.dag.derivative(residual, symbol)).collect();
        // Another row only if it is independent of those taken, at every sample.
        let mut is_new = true;
        for (sample, taken) in numbers.iter_mut().enumerate() {
            let row = slopes.iter().map(|&e| table.values(&k.dag, e)[sample]);
            taken.extend(row.collect::<Vec<_>>());
            let rows = equations.len() + 1;
            is_new &= linear::solve(taken, &mut vec![0.0; rows], n).1 == rows;
        }
        if !is_new {
            numbers.iter_mut().for_each(|taken| taken.truncate(equations.len() * n));
            continue;
        }
        let entries = slopes.into_iter().enumerate().filter(|(_, e)| !k.dag.is_zero(*e));
        let coefficients = entries.map(|(j, e)| (UnknownId::from_index(j), e)).collect();
        let mut right = Vec::new();
        for &symbol in independent {
            let slope = k.dag.derivative(residual, symbol);
            right.push(k.dag.negate(slope));
        }
        equations.push(Equation { coefficients, right });
    }
    if equations.len() < n {
        return None;
    }
    let (values, _) = sparse::solve(&mut k.dag, table, equations)?;
    (0..n).map(|j| values.get(&UnknownId::from_index(j)).cloned()).collect()
}
