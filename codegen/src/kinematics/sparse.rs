//! Sparse symbolic elimination: equations with few unknowns each, solved by exchanging rows.
//!
//! In: as many equations as unknowns. Out: every unknown in terms of the right-hand sides. Pivots by
//! least fill (Markowitz), never from structure alone: a pivot must be far from zero, relative to
//! its row, at every sample.

use super::UnknownId;
use crate::expr::tape::SampleTable;
use crate::expr::{Dag, ExprId};
use crate::id::Id;
use std::collections::BTreeMap;

/// A pivot relative to the largest entry of its row, at the worst sample.
const SAFE_PIVOT: f64 = 0.05;

/// sum coefficients[y] y = right, for several right-hand sides at once.
#[derive(Clone, Debug)]
pub(super) struct Equation {
    /// Non-zero coefficients.
    pub coefficients: BTreeMap<UnknownId, ExprId>,
    /// Right-hand sides.
    pub right: Vec<ExprId>,
}

/// Values of the unknowns for every right-hand side.
pub(super) type Values = BTreeMap<UnknownId, Vec<ExprId>>;

/// An unknown by those that are eliminated after it: `y = sum coefficients[z] z + right`.
#[derive(Clone, Debug)]
pub(super) struct Elimination {
    /// What is eliminated.
    pub unknown: UnknownId,
    /// The expression divided by.
    pub pivot: ExprId,
    /// Non-zero coefficients.
    pub coefficients: BTreeMap<UnknownId, ExprId>,
    /// Right-hand sides.
    pub right: Vec<ExprId>,
}

/// Triangular form of the equations, in the order of the elimination.
pub(super) fn eliminate(
    dag: &mut Dag,
    table: &mut SampleTable,
    mut equations: Vec<Equation>,
) -> Vec<Elimination> {
    let mut done = Vec::new();
    while let Some((r, column)) = pick(dag, table, &equations) {
        let row = equations.swap_remove(r);
        let pivot = row.coefficients[&column];
        // Its value at the samples, before what follows adds nodes.
        table.values(dag, pivot);
        let step = solved_for(dag, row, column, pivot);
        for other in &mut equations {
            substitute(dag, other, &step);
        }
        done.push(step);
    }
    done
}

/// Solves the equations; also the pivots divided by, in order. None if an equation cancels.
pub(super) fn solve(
    dag: &mut Dag,
    table: &mut SampleTable,
    equations: Vec<Equation>,
) -> Option<(Values, Vec<ExprId>)> {
    let done = eliminate(dag, table, equations);
    let values = back_substitute(dag, &done)?;
    Some((values, done.into_iter().map(|step| step.pivot).collect()))
}

/// (row, column) of least fill among the safe pivots; the safest if none is safe.
fn pick(dag: &Dag, table: &mut SampleTable, equations: &[Equation]) -> Option<(usize, UnknownId)> {
    let mut in_column: BTreeMap<UnknownId, usize> = BTreeMap::new();
    for equation in equations {
        for &column in equation.coefficients.keys() {
            *in_column.entry(column).or_insert(0) += 1;
        }
    }
    let mut candidates = Vec::new();
    for (r, equation) in equations.iter().enumerate() {
        let largest = row_maximum(dag, table, equation);
        for (&column, &entry) in &equation.coefficients {
            let relative = table.values(dag, entry).iter().zip(&largest).map(|(x, m)| x.abs() / m);
            let safety = relative.fold(f64::INFINITY, f64::min);
            let fill = (equation.coefficients.len() - 1) * (in_column[&column] - 1);
            let score = (fill, usize::from(!dag.is_constant(entry)), dag.cone_cost(&[entry]), column.index());
            candidates.push((safety, score, (r, column)));
        }
    }
    let safe = candidates.iter().filter(|(safety, ..)| *safety > SAFE_PIVOT);
    let safest = || candidates.iter().max_by(|a, b| a.0.total_cmp(&b.0));
    safe.min_by_key(|(_, score, _)| *score).or_else(safest).map(|(_, _, place)| *place)
}

fn row_maximum(dag: &Dag, table: &mut SampleTable, equation: &Equation) -> Vec<f64> {
    let mut largest = vec![0.0_f64; table.points()];
    for &entry in equation.coefficients.values() {
        for (m, x) in largest.iter_mut().zip(table.values(dag, entry)) {
            *m = m.max(x.abs());
        }
    }
    largest
}

/// The row divided by its pivot: every later use shares the quotients.
fn solved_for(dag: &mut Dag, row: Equation, unknown: UnknownId, pivot: ExprId) -> Elimination {
    let mut coefficients = row.coefficients;
    coefficients.remove(&unknown);
    for x in coefficients.values_mut() {
        let quotient = dag.div(*x, pivot);
        *x = dag.negate(quotient);
    }
    let right = row.right.into_iter().map(|x| dag.div(x, pivot)).collect();
    Elimination { unknown, pivot, coefficients, right }
}

/// Puts an unknown's expression in its place.
fn substitute(dag: &mut Dag, other: &mut Equation, step: &Elimination) {
    let Some(entry) = other.coefficients.remove(&step.unknown) else { return };
    for (&c, &x) in &step.coefficients {
        let product = dag.mul(entry, x);
        let new = match other.coefficients.get(&c) {
            Some(&mine) => dag.add(mine, product),
            None => product,
        };
        if dag.is_zero(new) {
            other.coefficients.remove(&c);
        } else {
            other.coefficients.insert(c, new);
        }
    }
    for (mine, &x) in other.right.iter_mut().zip(&step.right) {
        let product = dag.mul(entry, x);
        *mine = dag.sub(*mine, product);
    }
}

/// Every unknown by the right-hand sides alone; None if one never had a pivot.
pub(super) fn back_substitute(dag: &mut Dag, done: &[Elimination]) -> Option<Values> {
    let mut known = Values::new();
    for step in done.iter().rev() {
        let mut values = step.right.clone();
        for (other, &coefficient) in &step.coefficients {
            for (value, &x) in values.iter_mut().zip(known.get(other)?) {
                let product = dag.mul(coefficient, x);
                *value = dag.add(*value, product);
            }
        }
        known.insert(step.unknown, values);
    }
    Some(known)
}
