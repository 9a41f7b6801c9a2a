//! Solves the constraints for the dependent speeds and lifted unknowns by one sparse symbolic elimination.
//!
//! In: candidate rows. Out: for every dependent unknown y one step y = sum c z, y' = sum c z' + b; the partial
//! velocities T of y = T u; Newton's correction of the configuration. Takes the cheapest rows that are independent at
//! every sampled configuration and whose pivots vanish only where the constraints lose rank (`Regularity`).

use super::basis::NumericRow;
use super::choose;
use super::least_squares;
use super::linear_form::LinearForm;
use super::quantities::{Kinematics, Row};
use super::rank;
use super::regular::{self, Regularity};
use super::sampling::{sample_table, table_at};
use super::sparse::{self, Equation};
use super::unknowns::UnknownId;
use crate::diagnostic::Diagnostics;
use crate::expr::tape::SampleTable;
use crate::expr::{Dag, ExprId};
use crate::model::Model;
use crate::sorted::Sorted;
use crate::vector::{Algebra, TriadId};
use std::collections::BTreeMap;

/// A row whose terms cancel to this share of their size is a consequence of the rows taken.
const CONSEQUENCE: f64 = 1e-7;

/// Most attempts to choose rows whose pivots vanish only where the constraints are singular.
const ROUNDS: usize = 6;

/// A pivot and its size at the nominal configuration.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Pivot {
    /// The divisor.
    pub value: ExprId,
    /// Its absolute value at the nominal configuration.
    pub nominal: f64,
    /// Its smallest absolute value over the samples, relative to nominal.
    pub worst: f64,
}

/// Solution of the constraints at the velocity, acceleration and correction level.
#[derive(Clone, Debug, Default)]
pub struct Solution {
    /// `partials[y][j]`: coefficient of independent speed j in y; in a driven model the last one is that of the clock.
    /// Holds rows for the independent speeds and the clock themselves too.
    pub partials: Sorted<UnknownId, Vec<ExprId>>,
    /// Newton's correction of the coordinate (or position) of which y is the rate.
    pub correction: LinearForm,
    /// Pivots that are not constants, in order.
    pub pivots: Vec<Pivot>,
    /// The same solution in triangular form, in the order of the elimination: each unknown by later ones and
    /// independent ones.
    pub steps: Vec<Step>,
    /// The rows that were solved.
    pub rows: Vec<Row>,
    /// Rows between the independent speeds, if these are redundant (`redundant`); otherwise empty.
    pub ties: Vec<Row>,
}

impl Solution {
    /// The rows that were not solved: those of scalars, and components of vector motion constraints, in the triad in
    /// which they are fewest.
    pub(crate) fn not_solved<'k>(&self, model: &Model, k: &'k Kinematics) -> Vec<&'k Row> {
        let mut left: Vec<&Row> = Vec::new();
        left.extend(k.rows.iter().filter(|row| row.along.is_none() && !self.has_solved(row)));
        for constraint in &model.motion_constraints {
            let mut by_triad: BTreeMap<TriadId, Vec<&Row>> = BTreeMap::new();
            for row in k.rows.iter().filter(|row| row.name == constraint.name) {
                let Some(along) = row.along else { continue };
                let components = by_triad.entry(along.triad).or_default();
                // A component is listed for the equation and once more for its rate.
                if !self.has_solved(row) && components.iter().all(|other| other.along != row.along) {
                    components.push(row);
                }
            }
            left.extend(by_triad.into_values().min_by_key(Vec::len).unwrap_or_default());
        }
        left
    }

    fn has_solved(&self, row: &Row) -> bool {
        self.rows.iter().any(|solved| solved.name == row.name && solved.along == row.along)
    }
}

/// A dependent unknown in terms of unknowns eliminated after it and of independent ones: `y = sum coefficients[z] z`,
/// `y' = sum coefficients[z] z' + bias`.
#[derive(Clone, Debug)]
pub struct Step {
    /// The dependent unknown y.
    pub unknown: UnknownId,
    /// Non-zero coefficients.
    pub coefficients: LinearForm,
    /// The part of y' that does not depend on any z'.
    pub bias: ExprId,
}

/// Solves for every unknown.
///
/// # Errors
/// If the rows do not determine the dependent speeds, or over-determine them.
pub fn solve(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    table: &mut SampleTable,
) -> Result<Solution, Diagnostics> {
    let known: Vec<UnknownId> = k.unknowns.independent().into_iter().chain(k.unknowns.clock()).collect();
    let unknown = k.unknowns.dependent();
    let system = System { rows: k.rows.clone(), spare: k.spare_rows.clone(), unknown, known };
    let Some(form) = form(alg, model, k, table, &system) else {
        return Err(rank::explain(alg, model, k, table, None));
    };
    let solution = recorded(alg, k, table, &system.known, form);
    check_consequences(alg, model, k, table, &solution)?;
    Ok(solution)
}

/// The solution from exactly these rows; `None` if one of them cancels, so that no pivot is left in it.
pub(super) fn solution_of(
    alg: &mut Algebra,
    k: &Kinematics,
    table: &mut SampleTable,
    system: &System,
    rows: Vec<Row>,
) -> Option<Solution> {
    let form = eliminated(alg, table, rows, &system.known)?;
    Some(recorded(alg, k, table, &system.known, form))
}

/// Turns a form into the solution of the constraints.
fn recorded(
    alg: &mut Algebra,
    k: &Kinematics,
    table: &mut SampleTable,
    known: &[UnknownId],
    form: Form,
) -> Solution {
    let Form { rows, eliminations, values } = form;
    let mut solution = Solution { rows, ..Solution::default() };
    for pivot in k.rate_pivots.iter().copied().chain(eliminations.iter().map(|e| e.pivot)) {
        record(&alg.dag, table, pivot, &mut solution.pivots);
    }
    let n = known.len();
    for (column, &id) in known.iter().enumerate() {
        let (zero, one) = (alg.dag.zero(), alg.dag.one());
        let unit = (0..n).map(|j| if j == column { one } else { zero }).collect();
        solution.partials.insert(id, unit);
        solution.correction.insert(id, zero);
    }
    solution.steps = eliminations.into_iter().map(|e| step(&alg.dag, e, known)).collect();
    for (id, mut values) in values {
        solution.correction.insert(id, values[n + 1]);
        values.truncate(n);
        solution.partials.insert(id, values);
    }
    solution
}

/// The equations and unknowns of an elimination.
pub(super) struct System {
    /// Candidate rows.
    pub rows: Vec<Row>,
    /// Rows that follow from these, used only if these do not suffice.
    pub spare: Vec<Row>,
    /// Columns: the unknowns to be solved for.
    pub unknown: Vec<UnknownId>,
    /// The other unknowns: their values are given.
    pub known: Vec<UnknownId>,
}

/// The rows that were chosen, and their elimination.
pub(super) struct Form {
    /// The rows that are solved.
    pub rows: Vec<Row>,
    eliminations: Vec<sparse::Elimination>,
    /// By unknown: its coefficients of the known unknowns, its bias, Newton's correction.
    pub values: sparse::Values,
}

impl Form {
    /// The divisors, in the order of the elimination.
    pub fn pivots(&self) -> Vec<ExprId> {
        self.eliminations.iter().map(|e| e.pivot).collect()
    }
}

/// The cheapest form whose pivots vanish only where the constraints are singular. Tries the cheapest rows; then rows
/// chosen with the configurations added at which the first ones fail; finally the normal equations, which fail nowhere
/// else.
pub(super) fn form(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    table: &mut SampleTable,
    System { rows, spare, unknown, known }: &System,
) -> Option<Form> {
    let choice = choose::Choice { rows, unknown, count: unknown.len(), independent: choose::INDEPENDENT };
    let cheapest = choose::rows(alg, k, table, &choice);
    let first = match cheapest {
        Some(rows) => Some(eliminated(alg, table, rows, known)?),
        None if rank::determine(alg, &mut sample_table(alg, model, k), rows, unknown) => None,
        None => return None,
    };
    if unknown.is_empty() {
        return first;
    }
    let all: Vec<Row> = rows.iter().chain(spare).cloned().collect();
    let mut samples = k.sampled();
    let mut rows = Vec::new();
    let mut found = first;
    for _ in 0..ROUNDS {
        match found {
            Some(form) => {
                let mut wider = (samples.len() > k.samples.len()).then(|| table_at(alg, model, k, &samples));
                let screened = wider.as_mut().unwrap_or(table);
                let mut lost = regular::suspects(alg, model, k, screened, &samples, &form.pivots());
                if !lost.is_empty() {
                    lost = Regularity::new(alg, model, k, &all, unknown, table).regular(lost);
                }
                if lost.is_empty() {
                    return Some(form);
                }
                samples.extend(lost);
                rows = if rows.is_empty() { form.rows } else { rows };
            }
            None if samples.len() > k.samples.len() => break,
            None => {}
        }
        let mut wider = table_at(alg, model, k, &samples);
        let choice = choose::Choice {
            rows: &all,
            unknown,
            count: unknown.len(),
            independent: choose::WELL_INDEPENDENT,
        };
        let chosen = choose::rows(alg, k, &mut wider, &choice);
        found = chosen.and_then(|rows| eliminated(alg, &mut wider, rows, known));
        if found.is_none() {
            break;
        }
    }
    let mut wider = table_at(alg, model, k, &samples);
    let rows = Regularity::new(alg, model, k, &all, unknown, table).complete(&mut wider, rows);
    let equations: Vec<Equation> = rows.iter().map(|row| equation(&mut alg.dag, row, known)).collect();
    let normal = least_squares::normal_equations(&mut alg.dag, &equations);
    let eliminations = sparse::eliminate_definite(&mut alg.dag, table, normal);
    let values = sparse::back_substitute(&mut alg.dag, &eliminations)?;
    (values.len() == unknown.len()).then_some(Form { rows, eliminations, values })
}

/// Eliminates as many rows as unknowns; `None` if a row cancels.
fn eliminated(
    alg: &mut Algebra,
    table: &mut SampleTable,
    rows: Vec<Row>,
    known: &[UnknownId],
) -> Option<Form> {
    let equations = rows.iter().map(|row| equation(&mut alg.dag, row, known)).collect();
    let eliminations = sparse::eliminate(&mut alg.dag, table, equations);
    let values = sparse::back_substitute(&mut alg.dag, &eliminations)?;
    Some(Form { rows, eliminations, values })
}

/// Converts an elimination to a step: the right-hand sides of the known unknowns become coefficients.
fn step(dag: &Dag, elimination: sparse::Elimination, known: &[UnknownId]) -> Step {
    let mut coefficients = elimination.coefficients;
    coefficients.extend(known.iter().copied().zip(elimination.right.iter().copied()));
    coefficients.retain(|_, c| !dag.is_zero(*c));
    Step { unknown: elimination.unknown, coefficients, bias: elimination.right[known.len()] }
}

/// Checks that every candidate row holds for y = T u; otherwise the independent speeds are not independent.
fn check_consequences(
    alg: &Algebra,
    model: &Model,
    k: &Kinematics,
    table: &mut SampleTable,
    solution: &Solution,
) -> Result<(), Diagnostics> {
    let n = solution.partials.values().next().map_or(0, Vec::len);
    let coefficients = k.rows.iter().flat_map(|row| row.coefficients.values());
    for &e in coefficients.chain(solution.partials.values().flatten()) {
        table.compute(&alg.dag, e);
    }
    let (mut sum, mut size) = (vec![0.0_f64; table.points()], vec![0.0_f64; table.points()]);
    for row in &k.rows {
        for j in 0..n {
            sum.fill(0.0);
            size.fill(0.0);
            for (unknown, &coefficient) in &row.coefficients {
                let partial = solution.partials[unknown][j];
                if alg.dag.is_zero(partial) {
                    continue;
                }
                add_products(&mut sum, &mut size, table.computed(coefficient), table.computed(partial));
            }
            let is_off = |(sum, size): (&f64, &f64)| sum.abs() > CONSEQUENCE * size;
            // Without an exit from the loop, which then takes several samples at a time.
            if !sum.iter().zip(&size).fold(false, |any, pair| any | is_off(pair)) {
                continue;
            }
            let off: Vec<usize> = (0..sum.len()).filter(|&s| is_off((&sum[s], &size[s]))).collect();
            let is_clock = k.unknowns.clock().is_some() && j + 1 == n;
            match is_small(alg, table, (row, &solution.partials, j), &off, &sum) {
                Small::Sum => {}
                Small::Row => break,
                Small::Neither if is_clock => return Err(rank::contradiction(model, &row.name)),
                Small::Neither => return Err(rank::explain(alg, model, k, table, Some(&row.name))),
            }
        }
    }
    Ok(())
}

/// Adds products to sums and their sizes to the sums of sizes, one per sample. A function of its own, in which the
/// lists are known not to overlap, so that several samples are taken at a time.
#[inline(never)]
fn add_products(sums: &mut [f64], sizes: &mut [f64], a: &[f64], b: &[f64]) {
    for (((sum, size), a), b) in sums.iter_mut().zip(sizes).zip(a).zip(b) {
        *sum += a * b;
        *size += (a * b).abs();
    }
}

/// Which quantity of a doubtful row is within its rounding error.
enum Small {
    /// The sum of products, at the samples in question.
    Sum,
    /// The row itself, at every sample.
    Row,
    Neither,
}

/// Examines a row whose product with column j of the partial velocities is not 0.
fn is_small(
    alg: &Algebra,
    table: &mut SampleTable,
    (row, partials, j): (&Row, &Sorted<UnknownId, Vec<ExprId>>, usize),
    samples: &[usize],
    sum: &[f64],
) -> Small {
    let column = row.coefficients.keys().enumerate().map(|(i, &unknown)| (unknown, i)).collect();
    let points = table.points();
    let numeric = NumericRow::new(&alg.dag, table, row, &column);
    let lengths = (0..points).map(|sample| (sample, numeric.length(sample)));
    let Some((longest, length)) = lengths.max_by(|a, b| a.1.total_cmp(&b.1)) else { return Small::Row };
    let is_large = |s: usize| sum[s].abs() > CONSEQUENCE * CONSEQUENCE * length;
    if !samples.iter().any(|&s| is_large(s)) {
        return Small::Sum;
    }
    if length <= numeric.rounding(&alg.dag, longest) {
        return Small::Row;
    }
    let is_long = |s: usize| is_large(s) && numeric.length(s) > numeric.rounding(&alg.dag, s);
    let long: Vec<usize> = samples.iter().copied().filter(|&s| is_long(s)).collect();
    let terms: Vec<[ExprId; 2]> = row.coefficients.iter().map(|(y, &c)| [c, partials[y][j]]).collect();
    match long.iter().any(|&s| sum[s].abs() > rounding_of_products(&alg.dag, table, &terms, s)) {
        true => Small::Neither,
        false => Small::Sum,
    }
}

/// Bound of the rounding error of a sum of products at a sample. It is large where pivots are small, because the
/// partial velocities then have large errors.
fn rounding_of_products(dag: &Dag, table: &mut SampleTable, terms: &[[ExprId; 2]], sample: usize) -> f64 {
    let values: Vec<f64> = terms.as_flattened().iter().map(|&e| table.values(dag, e)[sample].abs()).collect();
    let errors = table.rounding_errors(dag, terms.as_flattened(), sample);
    let pairs = values.chunks_exact(2).zip(errors.chunks_exact(2));
    pairs.map(|(value, error)| value[0] * error[1] + error[0] * value[1]).sum()
}

fn equation(dag: &mut Dag, row: &Row, known: &[UnknownId]) -> Equation {
    let mut coefficients = row.coefficients.clone();
    let mut right: Vec<ExprId> = Vec::new();
    for id in known {
        let coefficient = coefficients.remove(id).unwrap_or_else(|| dag.zero());
        right.push(dag.negate(coefficient));
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

/// A pivot with its nominal value and its smallest value over the samples.
pub(crate) fn pivot_of(dag: &Dag, table: &mut SampleTable, value: ExprId) -> Pivot {
    let values = table.values(dag, value);
    let nominal = values[0].abs();
    let smallest = values.iter().fold(f64::INFINITY, |m, x| m.min(x.abs()));
    Pivot { value, nominal, worst: smallest / nominal }
}
