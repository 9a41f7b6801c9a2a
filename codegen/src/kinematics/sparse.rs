//! Sparse symbolic elimination: equations with few unknowns each, solved by exchanging rows.
//!
//! In: as many equations as unknowns. Out: every unknown in terms of the right-hand sides. Pivots by
//! least fill (Markowitz), never from structure alone: a pivot must be far from zero, relative to
//! its row, at every sample.

use super::UnknownId;
use crate::expr::tape::SampleTable;
use crate::expr::{Dag, ExprId};
use std::collections::BTreeMap;

/// A pivot relative to the largest entry of its row, at the worst sample.
const SAFE_PIVOT: f64 = 0.05;

/// sum coefficients[y] y = right, for several right-hand sides at once.
#[derive(Clone, Debug)]
pub(crate) struct Equation {
    /// Non-zero coefficients.
    pub coefficients: BTreeMap<UnknownId, ExprId>,
    /// Right-hand sides.
    pub right: Vec<ExprId>,
}

/// Values of the unknowns for every right-hand side.
pub(crate) type Values = BTreeMap<UnknownId, Vec<ExprId>>;

/// Solves the equations; also the pivots divided by, in order. None if an equation cancels.
pub(crate) fn solve(
    dag: &mut Dag,
    table: &mut SampleTable,
    equations: Vec<Equation>,
) -> Option<(Values, Vec<ExprId>)> {
    let screening = Screening { sizes: BTreeMap::new(), last_resort: true };
    solve_screened(dag, table, equations, &screening)
}

/// What a pivot must pass.
pub(crate) struct Screening {
    /// Typical sizes of the unknowns, 1 where none is given: an entry counts with its unknown's size.
    pub sizes: BTreeMap<UnknownId, f64>,
    /// Take the safest entry where none is safe? Else there is no solution.
    pub last_resort: bool,
}

/// [`solve`] with pivots screened in another way.
pub(crate) fn solve_screened(
    dag: &mut Dag,
    table: &mut SampleTable,
    mut equations: Vec<Equation>,
    screening: &Screening,
) -> Option<(Values, Vec<ExprId>)> {
    let mut done: Vec<(UnknownId, ExprId, Equation)> = Vec::new();
    let mut pivots = Vec::new();
    let mut candidates: Vec<Vec<Candidate>> =
        equations.iter().map(|e| candidates_of(dag, table, e, &screening.sizes)).collect();
    while !equations.is_empty() {
        let (r, column) = pick(&candidates, screening.last_resort)?;
        let row = equations.swap_remove(r);
        candidates.swap_remove(r);
        let pivot = row.coefficients[&column];
        // Its value at the samples, before what follows adds nodes.
        table.values(dag, pivot);
        pivots.push(pivot);
        for (other, theirs) in equations.iter_mut().zip(&mut candidates) {
            if subtract(dag, other, &row, column, pivot) {
                *theirs = candidates_of(dag, table, other, &screening.sizes);
            }
        }
        done.push((column, pivot, row));
    }
    Some((back_substitute(dag, done)?, pivots))
}

/// An entry as a pivot.
struct Candidate {
    column: UnknownId,
    /// Size relative to the largest entry of its row, at the worst sample.
    safety: f64,
    varies: bool,
    /// Operations that it takes.
    cost: usize,
}

fn candidates_of(
    dag: &Dag,
    table: &mut SampleTable,
    equation: &Equation,
    sizes: &BTreeMap<UnknownId, f64>,
) -> Vec<Candidate> {
    let size = |column: &UnknownId| sizes.get(column).copied().unwrap_or(1.0);
    let mut largest = vec![0.0_f64; table.points()];
    for (column, &entry) in &equation.coefficients {
        for (m, x) in largest.iter_mut().zip(table.values(dag, entry)) {
            *m = m.max(x.abs() * size(column));
        }
    }
    let candidate = |(&column, &entry): (&UnknownId, &ExprId)| {
        let values = table.values(dag, entry);
        let relative = values.iter().zip(&largest).map(|(x, m)| x.abs() * size(&column) / m);
        let smallest = relative.fold(f64::INFINITY, f64::min);
        // What has two signs vanishes in between.
        let one_sign = values.iter().all(|x| *x > 0.0) || values.iter().all(|x| *x < 0.0);
        Candidate {
            column,
            safety: if one_sign { smallest } else { 0.0 },
            varies: !dag.is_constant(entry),
            cost: dag.cone_cost(&[entry]),
        }
    };
    equation.coefficients.iter().map(candidate).collect()
}

/// (row, column) of least fill among the safe pivots; as a last resort the safest, if none is safe.
fn pick(rows: &[Vec<Candidate>], last_resort: bool) -> Option<(usize, UnknownId)> {
    let mut in_column: BTreeMap<UnknownId, usize> = BTreeMap::new();
    for candidate in rows.iter().flatten() {
        *in_column.entry(candidate.column).or_insert(0) += 1;
    }
    let all = || rows.iter().enumerate().flat_map(|(r, row)| row.iter().map(move |c| (r, row.len(), c)));
    let score = |(_, width, c): &(usize, usize, &Candidate)| {
        let fill = (width - 1) * (in_column[&c.column] - 1);
        (fill, c.varies, c.cost, c.column)
    };
    let safe = all().filter(|(_, _, c)| c.safety > SAFE_PIVOT);
    let safest = || all().filter(|_| last_resort).max_by(|a, b| a.2.safety.total_cmp(&b.2.safety));
    safe.min_by_key(score).or_else(safest).map(|(r, _, c)| (r, c.column))
}

/// `other -= (other[column] / pivot) row`; false if there is nothing to subtract.
fn subtract(dag: &mut Dag, other: &mut Equation, row: &Equation, column: UnknownId, pivot: ExprId) -> bool {
    let Some(entry) = other.coefficients.remove(&column) else { return false };
    let factor = dag.div(entry, pivot);
    for (&c, &x) in &row.coefficients {
        if c == column {
            continue;
        }
        let product = dag.mul(factor, x);
        let new = match other.coefficients.get(&c) {
            Some(&mine) => dag.sub(mine, product),
            None => dag.negate(product),
        };
        if dag.is_zero(new) {
            other.coefficients.remove(&c);
        } else {
            other.coefficients.insert(c, new);
        }
    }
    for (mine, &x) in other.right.iter_mut().zip(&row.right) {
        let product = dag.mul(factor, x);
        *mine = dag.sub(*mine, product);
    }
    true
}

fn back_substitute(dag: &mut Dag, done: Vec<(UnknownId, ExprId, Equation)>) -> Option<Values> {
    let mut known = Values::new();
    for (column, pivot, row) in done.into_iter().rev() {
        let mut values = row.right;
        for (other, coefficient) in row.coefficients {
            if other == column {
                continue;
            }
            for (value, &x) in values.iter_mut().zip(known.get(&other)?) {
                let product = dag.mul(coefficient, x);
                *value = dag.sub(*value, product);
            }
        }
        known.insert(column, values.into_iter().map(|v| dag.div(v, pivot)).collect());
    }
    Some(known)
}
