//! Dependent speeds and lifted unknowns by one sparse symbolic elimination.
//!
//! In: candidate rows. Out: for every unknown y one step y = sum c z, y' = sum c z' + b; T with y = T u; and
//! Newton's correction delta of the configuration. Rows are taken cheapest first as long as they
//! are independent at every sampled configuration.

use super::sparse::{self, Equation};
use super::{Kinematics, Row, UnknownId, UnknownKind, rank};
use crate::diagnostic::Diagnostics;
use crate::expr::tape::SampleTable;
use crate::expr::{Dag, ExprId, SymbolId};
use crate::model::Model;
use rustc_hash::{FxHashMap as HashMap, FxHashSet as HashSet};
use std::collections::BTreeMap;

/// A candidate row is independent if this part of its length is left at every sample.
const INDEPENDENT: f64 = 1e-3;
/// A row that adds more operations than this is worth a search for a cheaper one.
const DEAR: usize = 100;
/// A row whose terms cancel to this part of their size is a consequence of the rows taken.
const CONSEQUENCE: f64 = 1e-7;

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
    /// Newton's correction of what y is the rate of.
    pub correction: BTreeMap<UnknownId, ExprId>,
    /// Pivots that are not constants, in order.
    pub pivots: Vec<Pivot>,
    /// The same, each unknown by those after it and the independent ones, in the order of the elimination.
    pub steps: Vec<Step>,
    /// The rows that were solved.
    pub rows: Vec<Row>,
}

/// A dependent unknown by unknowns that are eliminated after it and by independent ones:
/// `y = sum coefficients[z] z`, `y' = sum coefficients[z] z' + bias`.
#[derive(Clone, Debug)]
pub struct Step {
    /// The dependent unknown y.
    pub unknown: UnknownId,
    /// Non-zero coefficients.
    pub coefficients: BTreeMap<UnknownId, ExprId>,
    /// Acceleration level: what the speeds contribute.
    pub bias: ExprId,
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
    let equations = chosen.iter().map(|row| equation(&mut k.dag, row, &independent)).collect();
    let eliminations = sparse::eliminate(&mut k.dag, table, equations);
    let Some(values) = sparse::back_substitute(&mut k.dag, &eliminations) else {
        return Err(rank::explain(model, k, table, None));
    };
    let mut solution = Solution::default();
    for pivot in k.rate_pivots.iter().copied().chain(eliminations.iter().map(|e| e.pivot)) {
        record(&k.dag, table, pivot, &mut solution.pivots);
    }
    let n = independent.len();
    for (column, &id) in independent.iter().enumerate() {
        let (zero, one) = (k.dag.zero(), k.dag.one());
        let unit = (0..n).map(|j| if j == column { one } else { zero }).collect();
        solution.partials.insert(id, unit);
        solution.correction.insert(id, zero);
    }
    solution.steps = eliminations.into_iter().map(|e| step(&k.dag, e, &independent)).collect();
    for (id, mut values) in values {
        solution.correction.insert(id, values[n + 1]);
        values.truncate(n);
        solution.partials.insert(id, values);
    }
    check_consequences(model, k, table, &solution)?;
    solution.rows = chosen;
    Ok(solution)
}

/// An elimination with the right-hand sides of the independent speeds among the coefficients.
fn step(dag: &Dag, elimination: sparse::Elimination, independent: &[UnknownId]) -> Step {
    let mut coefficients = elimination.coefficients;
    coefficients.extend(independent.iter().copied().zip(elimination.right.iter().copied()));
    coefficients.retain(|_, c| !dag.is_zero(*c));
    Step { unknown: elimination.unknown, coefficients, bias: elimination.right[independent.len()] }
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
            return Err(rank::explain(model, k, table, None));
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
    exchange(k, table, &column, &mut chosen);
    Ok(chosen)
}

/// Exchanges dear rows for cheaper ones as long as that saves, the dearest first: a row taken early was
/// dear where others bring what it needs.
fn exchange(k: &Kinematics, table: &mut SampleTable, column: &HashMap<UnknownId, usize>, chosen: &mut [Row]) {
    for _ in 0..chosen.len() {
        let without = |i: usize| {
            let mut paid = HashSet::default();
            chosen
                .iter()
                .enumerate()
                .filter(|(j, _)| *j != i)
                .for_each(|(_, row)| pay(&k.dag, row, &mut paid));
            paid
        };
        let mut prices: Vec<(usize, usize)> =
            (0..chosen.len()).map(|i| (added_cost(k, &chosen[i], &without(i)), i)).collect();
        prices.retain(|(price, _)| *price > DEAR);
        prices.sort_by_key(|&(price, i)| (std::cmp::Reverse(price), i));
        let better = prices.iter().find_map(|&(price, i)| {
            let others: Vec<&Row> =
                chosen.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, row)| row).collect();
            cheaper(k, table, column, &others, &without(i), price).map(|row| (i, row))
        });
        let Some((i, row)) = better else { return };
        chosen[i] = row;
    }
}

/// The cheapest row below `price` that is independent of `others`.
fn cheaper(
    k: &Kinematics,
    table: &mut SampleTable,
    column: &HashMap<UnknownId, usize>,
    others: &[&Row],
    paid: &HashSet<ExprId>,
    price: usize,
) -> Option<Row> {
    let mut list: Vec<(usize, &Row)> = (k.rows.iter())
        .map(|row| (added_cost(k, row, paid), row))
        .filter(|(cost, _)| *cost < price)
        .collect();
    list.sort_by_key(|(cost, _)| *cost);
    list.into_iter().map(|(_, row)| row).find(|row| is_independent(k, table, column, others, row)).cloned()
}

/// Is `row` independent of `others` at every sample?
fn is_independent(
    k: &Kinematics,
    table: &mut SampleTable,
    column: &HashMap<UnknownId, usize>,
    others: &[&Row],
    row: &Row,
) -> bool {
    let n = column.len();
    let mut bases: Vec<Vec<Vec<f64>>> = vec![Vec::new(); table.points()];
    for other in others {
        let numbers = numeric_row(&k.dag, table, other, column, n);
        for (basis, v) in bases.iter_mut().zip(numbers) {
            let rest = orthogonal_part(&v, basis);
            let length = norm(&rest);
            basis.push(rest.into_iter().map(|x| x / length).collect());
        }
    }
    let numbers = numeric_row(&k.dag, table, row, column, n);
    numbers.iter().zip(&bases).all(|(v, basis)| norm(&orthogonal_part(v, basis)) > INDEPENDENT)
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
                return Err(rank::explain(model, k, table, Some(&row.name)));
            }
        }
    }
    Ok(())
}

/// Unit rows of the unknown columns at every sample; zero rows stay zero.
pub(super) fn numeric_row(
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

pub(super) fn norm(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Gram-Schmidt, twice for accuracy.
pub(super) fn orthogonal_part(v: &[f64], basis: &[Vec<f64>]) -> Vec<f64> {
    let mut rest = v.to_vec();
    for _ in 0..2 {
        for b in basis {
            let projection: f64 = rest.iter().zip(b).map(|(x, y)| x * y).sum();
            rest.iter_mut().zip(b).for_each(|(x, y)| *x -= projection * y);
        }
    }
    rest
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
    for &(coordinate, form) in &k.closed_forms {
        let values = SampleTable::new(symbols.clone(), points).values(&k.dag, form).to_vec();
        symbols.extend(k.dag.as_symbol(k.q[coordinate]).map(|symbol| (symbol, values)));
    }
    SampleTable::new(symbols, points)
}
