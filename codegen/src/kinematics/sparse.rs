//! Sparse symbolic elimination of equations with few unknowns each.
//!
//! In: as many equations as unknowns. Out: every unknown in terms of the right-hand sides. Pivots by least fill
//! (Markowitz), but never from structure alone: relative to its row, a pivot must be far from zero at every sample.

use super::linear_form::LinearForm;
use super::unknowns::UnknownId;
use crate::expr::tape::SampleTable;
use crate::expr::{Dag, ExprId};
use crate::id::Id;
use std::collections::BTreeMap;

/// A safe pivot is larger than this, relative to the largest entry of its row, at the worst sample.
const SAFE_PIVOT: f64 = 0.05;

/// sum coefficients[y] y = right, for several right-hand sides at once.
#[derive(Clone, Debug)]
pub(crate) struct Equation {
    /// Non-zero coefficients.
    pub coefficients: LinearForm,
    /// Right-hand sides.
    pub right: Vec<ExprId>,
}

/// By unknown: its value for every right-hand side.
pub(crate) type Values = BTreeMap<UnknownId, Vec<ExprId>>;

/// An unknown in terms of those eliminated after it: `y = (sum coefficients[z] z + right) / divisor`.
#[derive(Clone, Debug)]
pub(crate) struct Elimination {
    /// The unknown that is eliminated.
    pub unknown: UnknownId,
    /// The divisor of the equation.
    pub pivot: ExprId,
    /// Non-zero coefficients.
    pub coefficients: LinearForm,
    /// Right-hand sides.
    pub right: Vec<ExprId>,
    /// 1 if the terms have been divided by the pivot; the pivot if their sum still has to be.
    pub divisor: ExprId,
    /// Index of the equation that it is solved from.
    pub row: usize,
    /// Indices of the other equations that contained the unknown, with its coefficient there.
    pub others: Vec<(usize, ExprId)>,
}

/// Options of an elimination.
pub(crate) struct Screening {
    /// Typical sizes of the unknowns, by which entries are scaled when pivots are compared; 1 where none is given.
    pub sizes: BTreeMap<UnknownId, f64>,
    /// Take the safest entry if none is safe? Otherwise the elimination stops there.
    pub last_resort: bool,
    /// Divide the sum instead of its terms if no other equation contains the unknown: shorter, if only the values are
    /// wanted.
    pub divide_sums: bool,
}

/// Eliminates the equations; returns the steps in order (triangular form).
pub(crate) fn eliminate(
    dag: &mut Dag,
    table: &mut SampleTable,
    equations: Vec<Equation>,
) -> Vec<Elimination> {
    let screening = Screening { sizes: BTreeMap::new(), last_resort: true, divide_sums: false };
    eliminate_screened(dag, table, equations, &screening)
}

/// [`eliminate`] with other options; unknowns without an acceptable pivot are left out.
pub(crate) fn eliminate_screened(
    dag: &mut Dag,
    table: &mut SampleTable,
    mut equations: Vec<Equation>,
    screening: &Screening,
) -> Vec<Elimination> {
    let mut done = Vec::new();
    let mut places: Vec<usize> = (0..equations.len()).collect();
    let mut candidates: Vec<Vec<Candidate>> =
        equations.iter().map(|e| candidates_of(dag, table, e, &screening.sizes)).collect();
    while let Some((r, column)) = pick(&candidates, screening.last_resort) {
        let row = equations.swap_remove(r);
        candidates.swap_remove(r);
        let place = places.swap_remove(r);
        let pivot = row.coefficients[&column];
        // Evaluated now, before the following steps add nodes.
        table.values(dag, pivot);
        let alone = equations.iter().all(|other| !other.coefficients.contains_key(&column));
        let divisor = if alone && screening.divide_sums { pivot } else { dag.one() };
        let mut step = solved_for(dag, row, (column, pivot), divisor, place);
        for ((other, theirs), &place) in equations.iter_mut().zip(&mut candidates).zip(&places) {
            if let Some(entry) = substitute(dag, other, &step) {
                step.others.push((place, entry));
                *theirs = candidates_of(dag, table, other, &screening.sizes);
            }
        }
        done.push(step);
    }
    done
}

/// Eliminates a symmetric positive definite system in which equation i belongs to unknown i: pivots from the diagonal,
/// the equation with the fewest unknowns first. No pivot vanishes where the system is regular.
pub(crate) fn eliminate_definite(
    dag: &mut Dag,
    table: &mut SampleTable,
    mut equations: BTreeMap<UnknownId, Equation>,
) -> Vec<Elimination> {
    let mut done = Vec::new();
    while let Some(column) = equations.iter().min_by_key(|(_, e)| e.coefficients.len()).map(|(&u, _)| u) {
        let Some(row) = equations.remove(&column) else { break };
        let Some(&pivot) = row.coefficients.get(&column) else { break };
        table.values(dag, pivot);
        let one = dag.one();
        let mut step = solved_for(dag, row, (column, pivot), one, column.index());
        for (unknown, other) in &mut equations {
            let entry = substitute(dag, other, &step);
            step.others.extend(entry.map(|entry| (unknown.index(), entry)));
        }
        done.push(step);
    }
    done
}

/// Solves the equations; also returns the pivots in order. `None` if an equation cancels.
pub(crate) fn solve(
    dag: &mut Dag,
    table: &mut SampleTable,
    equations: Vec<Equation>,
) -> Option<(Values, Vec<ExprId>)> {
    let done = eliminate(dag, table, equations);
    let values = back_substitute(dag, &done)?;
    Some((values, done.into_iter().map(|step| step.pivot).collect()))
}

/// An entry that may be taken as pivot.
struct Candidate {
    column: UnknownId,
    /// Size relative to the largest entry of its row, at the worst sample.
    safety: f64,
    varies: bool,
    /// Operations of the entry.
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
        let size = size(column);
        for (m, x) in largest.iter_mut().zip(table.values(dag, entry)) {
            let entry = x.abs() * size;
            *m = if entry > *m { entry } else { *m };
        }
    }
    let candidate = |(&column, &entry): (&UnknownId, &ExprId)| {
        let values = table.values(dag, entry);
        let size = size(&column);
        let relative = values.iter().zip(&largest).map(|(x, m)| x.abs() * size / m);
        let smallest = relative.fold(f64::INFINITY, |least, x| if x < least { x } else { least });
        // An entry that changes its sign vanishes in between.
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

/// (row, column) of least fill among the safe pivots; if none is safe, the safest as a last resort.
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

/// Solves the row for an unknown. Unless the pivot is the divisor, the terms are divided by it, and every later use
/// shares the quotients.
fn solved_for(
    dag: &mut Dag,
    row: Equation,
    (unknown, pivot): (UnknownId, ExprId),
    divisor: ExprId,
    place: usize,
) -> Elimination {
    let mut coefficients = row.coefficients;
    coefficients.remove(&unknown);
    let factor = if dag.is_one(divisor) { pivot } else { dag.one() };
    for x in coefficients.values_mut() {
        let quotient = dag.div(*x, factor);
        *x = dag.negate(quotient);
    }
    let right = row.right.into_iter().map(|x| dag.div(x, factor)).collect();
    Elimination { unknown, pivot, coefficients, right, divisor, row: place, others: Vec::new() }
}

/// Substitutes an unknown by its step; returns the coefficient that it had, if the equation contained it.
fn substitute(dag: &mut Dag, other: &mut Equation, step: &Elimination) -> Option<ExprId> {
    let entry = other.coefficients.substitute(dag, step.unknown, &step.coefficients)?;
    for (mine, &x) in other.right.iter_mut().zip(&step.right) {
        let product = dag.mul(entry, x);
        *mine = dag.sub(*mine, product);
    }
    Some(entry)
}

/// Every unknown in terms of the right-hand sides alone; `None` if one of them never had a pivot.
pub(crate) fn back_substitute(dag: &mut Dag, done: &[Elimination]) -> Option<Values> {
    let mut known = Values::new();
    for step in done.iter().rev() {
        let mut values = step.right.clone();
        for (other, &coefficient) in &step.coefficients {
            for (value, &x) in values.iter_mut().zip(known.get(other)?) {
                let product = dag.mul(coefficient, x);
                *value = dag.add(*value, product);
            }
        }
        known.insert(step.unknown, values.into_iter().map(|v| dag.div(v, step.divisor)).collect());
    }
    Some(known)
}
