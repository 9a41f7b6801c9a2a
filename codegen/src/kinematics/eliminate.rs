//! Dependent speeds and lifted unknowns by one sparse symbolic elimination.
//!
//! In: candidate rows. Out: T, beta and delta with y = T u, y' = T u' + beta for all unknowns y, and
//! Newton's correction delta of the configuration. Rows are taken cheapest first as long as they
//! are independent at every sampled configuration; pivots by least fill (Markowitz), never from
//! structure alone: a pivot must be far from zero, relative to its row, at every sample.

use super::{Kinematics, Row, UnknownId, UnknownKind};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expr::tape::SampleTable;
use crate::expr::{Dag, ExprId, SymbolId};
use crate::id::Id;
use crate::model::Model;
use rustc_hash::{FxHashMap as HashMap, FxHashSet as HashSet};
use std::collections::BTreeMap;

/// A candidate row is independent if this part of its length is left at every sample.
const INDEPENDENT: f64 = 1e-3;
/// A row whose terms cancel to this part of their size is a consequence of the rows taken.
const CONSEQUENCE: f64 = 1e-7;
/// A pivot relative to the largest entry of its row, at the worst sample.
const SAFE_PIVOT: f64 = 0.05;

/// A pivot and its size at the nominal configuration.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Pivot {
    /// The expression divided by.
    pub value: ExprId,
    /// Its absolute value at the nominal configuration.
    pub nominal: f64,
    /// Its smallest absolute value over the samples, relative to nominal.
    pub worst: f64,
}

/// Solution of the constraints at the velocity, acceleration and correction level.
#[derive(Clone, Debug, Default)]
pub struct Solution {
    /// `speeds[y][j]`: coefficient of independent speed j in y. Independent speeds are in it too.
    pub partials: BTreeMap<UnknownId, Vec<ExprId>>,
    /// y' without the independent accelerations.
    pub bias: BTreeMap<UnknownId, ExprId>,
    /// Newton's correction of what y is the rate of.
    pub correction: BTreeMap<UnknownId, ExprId>,
    /// Pivots that are not constants, in order.
    pub pivots: Vec<Pivot>,
    /// The rows that were solved.
    pub rows: Vec<Row>,
}

/// One equation during elimination: sum coefficients y = right.
struct Equation {
    coefficients: BTreeMap<UnknownId, ExprId>,
    /// One entry per independent speed, then bias, then residual.
    right: Vec<ExprId>,
}

/// Solves for every unknown.
///
/// # Errors
/// If the rows do not determine the dependent speeds, or over-determine them.
pub fn solve(model: &Model, k: &mut Kinematics, table: &mut SampleTable) -> Result<Solution, Diagnostics> {
    let independent: Vec<UnknownId> = (k.unknowns.enumerate())
        .filter(|(_, u)| matches!(u.kind, UnknownKind::Independent(_)))
        .map(|(id, _)| id)
        .collect();
    let unknown: Vec<UnknownId> = k.unknowns.ids().filter(|id| !independent.contains(id)).collect();
    let chosen = choose(model, k, table, &unknown)?;
    let mut equations: Vec<Equation> =
        chosen.iter().map(|row| equation(&mut k.dag, row, &independent)).collect();
    let mut solution = Solution::default();
    let mut done: Vec<(UnknownId, ExprId, Equation)> = Vec::new();
    while !equations.is_empty() {
        let (r, column) = pick(&k.dag, table, &equations);
        let row = equations.swap_remove(r);
        let pivot = row.coefficients[&column];
        record(&k.dag, table, pivot, &mut solution.pivots);
        for other in &mut equations {
            subtract(&mut k.dag, other, &row, column, pivot);
        }
        done.push((column, pivot, row));
    }
    for (column, &id) in independent.iter().enumerate() {
        let (zero, one) = (k.dag.zero(), k.dag.one());
        let unit = (0..independent.len()).map(|j| if j == column { one } else { zero }).collect();
        solution.partials.insert(id, unit);
        solution.bias.insert(id, zero);
        solution.correction.insert(id, zero);
    }
    back_substitute(k, done, &mut solution);
    check_consequences(model, k, table, &solution)?;
    solution.rows = chosen;
    Ok(solution)
}

/// Takes independent rows, each time the one that adds the fewest operations to those taken.
fn choose(
    model: &Model,
    k: &Kinematics,
    table: &mut SampleTable,
    unknown: &[UnknownId],
) -> Result<Vec<Row>, Diagnostics> {
    let n = unknown.len();
    let column: HashMap<UnknownId, usize> = unknown.iter().enumerate().map(|(i, &u)| (u, i)).collect();
    let mut bases: Vec<Vec<Vec<f64>>> = vec![Vec::new(); table.points()];
    let mut paid = HashSet::default();
    let mut candidates: Vec<&Row> = k.rows.iter().collect();
    let mut chosen = Vec::new();
    while chosen.len() < n {
        let cheapest = (0..candidates.len()).min_by_key(|&i| added_cost(k, candidates[i], &paid));
        let Some(row) = cheapest.map(|i| candidates.remove(i)) else {
            return Err(under_determined(model, chosen.len(), n));
        };
        let numbers = numeric_row(&k.dag, table, row, &column, n);
        // Most dependent rows show at the first sample: no need to look at the others.
        let remains: Vec<Vec<f64>> = numbers
            .iter()
            .zip(&bases)
            .map(|(v, basis)| orthogonal_part(v, basis))
            .take_while(|v| norm(v) > INDEPENDENT)
            .collect();
        if remains.len() < table.points() {
            continue; // depends on the rows taken, and will depend on any more
        }
        for (basis, v) in bases.iter_mut().zip(remains) {
            let length = norm(&v);
            basis.push(v.into_iter().map(|x| x / length).collect());
        }
        pay(&k.dag, row, &mut paid);
        chosen.push(row.clone());
    }
    Ok(chosen)
}

/// Operations that a row adds to the expressions paid for already, plus what an entry costs later.
fn added_cost(k: &Kinematics, row: &Row, paid: &HashSet<ExprId>) -> usize {
    let dag = &k.dag;
    /// An unknown in a row costs about a product and a sum per right-hand side in the elimination.
    const PER_UNKNOWN: usize = 6;
    /// Two dependent speeds in one row must be taken apart again.
    const COUPLING: usize = 24;
    let mut stack: Vec<ExprId> = row.coefficients.values().copied().chain([row.bias]).collect();
    let mut seen = HashSet::default();
    let mut operations = 0;
    while let Some(id) = stack.pop() {
        if !paid.contains(&id) && seen.insert(id) {
            operations += usize::from(dag.is_operation(id));
            stack.extend(dag.operands(id).into_iter().flatten());
        }
    }
    let own = row.coefficients.keys().filter(|&&u| is_dependent(k, u)).count();
    operations + PER_UNKNOWN * row.coefficients.len() + COUPLING * own.saturating_sub(1)
}

fn is_dependent(k: &Kinematics, unknown: UnknownId) -> bool {
    matches!(k.unknowns[unknown].kind, UnknownKind::Dependent(_))
}

fn pay(dag: &Dag, row: &Row, paid: &mut HashSet<ExprId>) {
    let mut stack: Vec<ExprId> = row.coefficients.values().copied().chain([row.bias]).collect();
    while let Some(id) = stack.pop() {
        if paid.insert(id) {
            stack.extend(dag.operands(id).into_iter().flatten());
        }
    }
}

/// Every candidate row must hold for y = T u: else the independent speeds are not independent.
fn check_consequences(
    model: &Model,
    k: &Kinematics,
    table: &mut SampleTable,
    solution: &Solution,
) -> Result<(), Diagnostics> {
    let n = solution.partials.values().next().map_or(0, Vec::len);
    for row in &k.rows {
        for j in 0..n {
            let mut sum = vec![0.0_f64; table.points()];
            let mut size = vec![0.0_f64; table.points()];
            for (unknown, &coefficient) in &row.coefficients {
                let c = table.values(&k.dag, coefficient).to_vec();
                let t = table.values(&k.dag, solution.partials[unknown][j]);
                for (((sum, size), c), t) in sum.iter_mut().zip(&mut size).zip(&c).zip(t) {
                    *sum += c * t;
                    *size += (c * t).abs();
                }
            }
            if sum.iter().zip(&size).any(|(s, m)| s.abs() > CONSEQUENCE * m.max(CONSEQUENCE)) {
                return Err(over_determined(model, &row.name));
            }
        }
    }
    Ok(())
}

fn over_determined(model: &Model, name: &str) -> Diagnostics {
    let mut error = Diagnostic::error(format!(
        "`{name}` does not follow from the other constraints: the mechanism has fewer degrees of freedom than independent speeds"
    ))
    .help("declare fewer coordinates `independent`, or remove the constraint");
    for speed in model.speeds.iter().filter(|s| s.independent) {
        error = error.label(speed.span, "declared independent");
    }
    Diagnostics { source: model.source.clone(), items: vec![error] }
}

/// Unit rows of the unknown columns at every sample; zero rows stay zero.
fn numeric_row(
    dag: &Dag,
    table: &mut SampleTable,
    row: &Row,
    column: &HashMap<UnknownId, usize>,
    n: usize,
) -> Vec<Vec<f64>> {
    let mut numbers = vec![vec![0.0; n]; table.points()];
    for (unknown, &coefficient) in &row.coefficients {
        if let Some(&c) = column.get(unknown) {
            for (v, &x) in numbers.iter_mut().zip(table.values(dag, coefficient)) {
                v[c] = x;
            }
        }
    }
    for v in &mut numbers {
        let length = norm(v);
        if length > f64::MIN_POSITIVE {
            v.iter_mut().for_each(|x| *x /= length);
        }
    }
    numbers
}

fn norm(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Gram-Schmidt, twice for accuracy.
fn orthogonal_part(v: &[f64], basis: &[Vec<f64>]) -> Vec<f64> {
    let mut rest = v.to_vec();
    for _ in 0..2 {
        for b in basis {
            let projection: f64 = rest.iter().zip(b).map(|(x, y)| x * y).sum();
            rest.iter_mut().zip(b).for_each(|(x, y)| *x -= projection * y);
        }
    }
    rest
}

fn under_determined(model: &Model, rank: usize, needed: usize) -> Diagnostics {
    let mut error = Diagnostic::error(format!(
        "the constraints determine only {rank} of the {needed} dependent unknowns at every sampled configuration"
    ))
    .help(
        "either a constraint is missing, or one is singular: its rate vanishes or follows from the \
         others wherever they hold (state it in another, regular form), or more coordinates are independent than declared",
    );
    for constraint in model.configuration_constraints.iter().chain(&model.motion_constraints) {
        error = error.label(constraint.span, "one of the constraints");
    }
    for point in model.points.iter().filter(|p| !p.closures.is_empty()) {
        error = error.label(point.span, "a closed loop");
    }
    Diagnostics { source: model.source.clone(), items: vec![error] }
}

fn equation(dag: &mut Dag, row: &Row, independent: &[UnknownId]) -> Equation {
    let mut coefficients = row.coefficients.clone();
    let mut right: Vec<ExprId> = Vec::new();
    for id in independent {
        let known = coefficients.remove(id).unwrap_or_else(|| dag.zero());
        right.push(dag.negate(known));
    }
    right.push(dag.negate(row.bias));
    right.push(dag.negate(row.residual));
    Equation { coefficients, right }
}

/// (row, column) of least fill among the safe pivots; the safest if none is safe.
fn pick(dag: &Dag, table: &mut SampleTable, equations: &[Equation]) -> (usize, UnknownId) {
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
    let chosen = safe.min_by_key(|(_, score, _)| *score).or_else(safest);
    chosen.map_or((0, UnknownId::from_index(0)), |(_, _, place)| *place)
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

fn record(dag: &Dag, table: &mut SampleTable, pivot: ExprId, pivots: &mut Vec<Pivot>) {
    if dag.is_constant(pivot) || pivots.iter().any(|p| p.value == pivot) {
        return;
    }
    pivots.push(pivot_of(dag, table, pivot));
}

/// A pivot with its nominal and worst sizes.
pub(crate) fn pivot_of(dag: &Dag, table: &mut SampleTable, value: ExprId) -> Pivot {
    let values = table.values(dag, value);
    let nominal = values[0].abs();
    let smallest = values.iter().fold(f64::INFINITY, |m, x| m.min(x.abs()));
    Pivot { value, nominal, worst: smallest / nominal }
}

/// `other -= (other[column] / pivot) row`.
fn subtract(dag: &mut Dag, other: &mut Equation, row: &Equation, column: UnknownId, pivot: ExprId) {
    let Some(entry) = other.coefficients.remove(&column) else { return };
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
}

fn back_substitute(k: &mut Kinematics, done: Vec<(UnknownId, ExprId, Equation)>, solution: &mut Solution) {
    for (column, pivot, row) in done.into_iter().rev() {
        let n = row.right.len() - 2;
        let mut values = row.right;
        for (other, coefficient) in row.coefficients {
            if other == column {
                continue;
            }
            let known = &solution.partials[&other];
            let all: Vec<ExprId> =
                known.iter().copied().chain([solution.bias[&other], solution.correction[&other]]).collect();
            for (value, x) in values.iter_mut().zip(all) {
                let product = k.dag.mul(coefficient, x);
                *value = k.dag.sub(*value, product);
            }
        }
        let values: Vec<ExprId> = values.into_iter().map(|v| k.dag.div(v, pivot)).collect();
        solution.correction.insert(column, values[n + 1]);
        solution.bias.insert(column, values[n]);
        solution.partials.insert(column, values[..n].to_vec());
    }
}

/// Table of all symbols at the sampled configurations: speeds and inputs random, parameters default.
#[must_use]
pub fn sample_table(model: &Model, k: &Kinematics) -> SampleTable {
    let points = k.samples.len();
    let mut random = super::assemble::Random(0x00C0_FFEE);
    let mut symbols: HashMap<SymbolId, Vec<f64>> = HashMap::default();
    let mut set = |dag: &Dag, expr: ExprId, values: Vec<f64>| {
        if let Some(symbol) = dag.as_symbol(expr) {
            symbols.insert(symbol, values);
        }
    };
    let state: Vec<_> = model.coordinates.ids().filter(|&c| k.coordinate_symbol(c).is_some()).collect();
    for (i, &c) in state.iter().enumerate() {
        set(&k.dag, k.q[c], k.samples.iter().map(|q| q[i]).collect());
    }
    for (id, &expr) in k.parameters.enumerate() {
        set(&k.dag, expr, vec![k.parameter_values[id]; points]);
    }
    set(&k.dag, k.time, vec![0.0; points]);
    for &input in k.inputs.iter() {
        set(&k.dag, input, (0..points).map(|_| random.between((-1.0, 1.0))).collect());
    }
    for unknown in k.unknowns.iter() {
        set(&k.dag, unknown.value, (0..points).map(|_| random.between((-1.0, 1.0))).collect());
    }
    SampleTable::new(symbols, points)
}
