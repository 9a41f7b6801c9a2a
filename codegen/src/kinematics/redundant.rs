//! Redundant speeds: if the motion passes dead points of the independent speeds, all speeds become state.
//!
//! In: the candidate rows. Out: nothing if the independent speeds determine the dependent ones all along the motion;
//! otherwise every speed as an independent unknown, the lifted unknowns eliminated, and the rows J u = 0 that remain
//! between the speeds. The equations of motion keep these by multipliers (Lagrange's equations of the first kind;
//! `dynamics/redundant.rs`), which needs only that the rows have full rank.
//!
//! At a dead point the Jacobian has full rank, but its columns of the dependent unknowns are singular: their
//! determinant changes its sign there. To find one, a walk follows the motion within the ranges of the coordinates
//! (`walk.rs`).

use super::assemble::Assembly;
use super::eliminate::{self, Pivot, Solution, System};
use super::linear_form::LinearForm;
use super::quantities::{Kinematics, Row, Sample};
use super::regular::Regularity;
use super::sampling::{sample_table, table_at};
use super::sparse::{self, Equation};
use super::unknowns::UnknownId;
use super::walk::{self, Walker};
use super::{choose, linear, rank};
use crate::expr::tape::SampleTable;
use crate::expr::{ExprId, SymbolId};
use crate::id::Id;
use crate::model::{CoordinateId, Model};
use crate::vector::Algebra;
use std::collections::BTreeMap;

/// Halvings of a step in which the determinant changes its sign.
const HALVINGS: usize = 40;
/// At a dead point the least determined direction of the dependent unknowns keeps no more than this.
const DEAD: f64 = 1e-6;
/// A pivot with less than this share of its nominal value, or of the other sign, may be near a dead point.
const HEALTHY: f64 = 0.05;
/// If one has less than this share on the walk, places where it is weaker still are looked for from there.
const SUSPECT: f64 = 0.3;
/// If all pivots keep this share of their largest value at all samples, no dead point is near.
const STEADY: f64 = 0.5;
/// Most dead points that are added to the samples.
const KEPT: usize = 4;

/// The derivation with all speeds as state and the rows between them, if the motion passes a dead point of the
/// independent speeds. `minimal` is the solution in the independent speeds, if they determine the others at every
/// sample. `None` if all speeds need not or cannot be state.
pub fn solve(
    alg: &Algebra,
    model: &Model,
    k: &Kinematics,
    table: &mut SampleTable,
    minimal: Option<&Solution>,
) -> Option<(Algebra, Kinematics, Solution, SampleTable)> {
    let dependent = k.unknowns.dependent();
    if dependent.is_empty() || minimal.is_some_and(|solution| is_steady(alg, table, &solution.pivots)) {
        return None;
    }
    let (mut alg, mut k) = (alg.clone(), k.clone());
    let mut walker = Walker::new(&mut alg, model, &k);
    let mut walked = walker.walk();
    let mut along = table_at(&alg, model, &k, &walked);
    if let Some(solution) = minimal {
        let pivots = &solution.pivots;
        let (place, share) = weakest(&shares(&alg, &mut along, pivots));
        if share > SUSPECT {
            return None;
        }
        // A share below 0 says that the walk has passed a dead point already.
        if share > 0.0 {
            let nominal = walked[0].clone();
            walked.extend(walker.descend(walked[place].clone(), share, |steps| {
                let places = [std::slice::from_ref(&nominal), steps].concat();
                shares(&alg, &mut table_at(&alg, model, &k, &places), pivots).split_off(1)
            }));
            along = table_at(&alg, model, &k, &walked);
        }
        if weakest(&shares(&alg, &mut along, pivots)).1 > HEALTHY {
            return None;
        }
    }
    let places: Vec<Sample> = k.sampled().into_iter().chain(walked.iter().cloned()).collect();
    let mut table = table_at(&alg, model, &k, &places);
    let rows = full_rank(&alg, &k, &mut table, dependent.len())?;
    let dead = dead_points(&mut alg, model, &k, &rows, &dependent, (&walked, &mut along));
    if minimal.is_some() && dead.is_empty() {
        return None;
    }
    k.samples = places.iter().chain(&dead).map(|sample| sample.q.clone()).collect();
    k.sample_times = places.iter().chain(&dead).map(|sample| sample.t).collect();
    k.unknowns = k.unknowns.all_speeds_independent();
    let mut table = sample_table(&alg, model, &k);
    let solution = between_speeds(&mut alg, &k, &mut table, rows)?;
    Some((alg, k, solution, table))
}

/// Do the pivots hardly vary over the samples? Towards a dead point within the ranges a pivot would fall to zero, at
/// least as fast as the square root of the distance.
fn is_steady(alg: &Algebra, table: &mut SampleTable, pivots: &[Pivot]) -> bool {
    pivots.iter().all(|pivot| {
        let values = table.values(&alg.dag, pivot.value).iter();
        let (least, most) =
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, m), x| (l.min(*x), m.max(*x)));
        least > STEADY * most && least > 0.0 || most < STEADY * least && most < 0.0
    })
}

/// By sample: the least share of its value at the first sample that a pivot has there; below 0 for another sign.
fn shares(alg: &Algebra, table: &mut SampleTable, pivots: &[Pivot]) -> Vec<f64> {
    let mut least = vec![f64::INFINITY; table.points()];
    for pivot in pivots {
        let values = table.values(&alg.dag, pivot.value);
        // What is no number counts as none.
        least.iter_mut().zip(values).for_each(|(least, x)| {
            let share = x / values[0];
            *least = if share.is_nan() { f64::NEG_INFINITY } else { least.min(share) };
        });
    }
    least
}

/// The least share, with the index of its sample.
fn weakest(shares: &[f64]) -> (usize, f64) {
    let places = shares.iter().copied().enumerate();
    places.min_by(|(_, a), (_, b)| a.total_cmp(b)).unwrap_or((0, f64::INFINITY))
}

/// As many rows as there are dependent unknowns, independent over all speeds at every sample; `None` if at some sample
/// the constraints do not leave the stated number of degrees of freedom.
fn full_rank(alg: &Algebra, k: &Kinematics, table: &mut SampleTable, count: usize) -> Option<Vec<Row>> {
    let moving = k.unknowns.moving();
    // With the clock as a column too, so that rows that contradict each other in time are found.
    let all: Vec<UnknownId> = k.unknowns.ids().collect();
    let fits = |columns: &[UnknownId], table: &mut SampleTable| {
        rank::ranks(alg, table, &k.rows, columns).iter().all(|&rank| rank == count)
    };
    if !fits(&moving, table) || (k.unknowns.clock().is_some() && !fits(&all, table)) {
        return None;
    }
    let rows: Vec<Row> = k.rows.iter().chain(&k.spare_rows).cloned().collect();
    let choice =
        choose::Choice { rows: &rows, unknown: &moving, count, independent: choose::WELL_INDEPENDENT };
    choose::rows(alg, k, table, &choice).or_else(|| {
        let choice = choose::Choice { independent: choose::INDEPENDENT, ..choice };
        choose::rows(alg, k, table, &choice)
    })
}

/// Configurations on the walk at which the rows do not determine the dependent unknowns although they have full rank.
fn dead_points(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    rows: &[Row],
    dependent: &[UnknownId],
    (walked, along): (&[Sample], &mut SampleTable),
) -> Vec<Sample> {
    let mut assembly = Assembly::free(alg, model, k);
    let signs = signs(alg, along, rows, dependent);
    let sign = |sample: &Sample| {
        let mut table = table_at(alg, model, k, std::slice::from_ref(sample));
        self::signs(alg, &mut table, rows, dependent)[0]
    };
    let ranges = walk::ranges(alg, model, k);
    let mut found = Vec::new();
    for (pair, signs) in walked.windows(2).zip(signs.windows(2)) {
        if signs[0] == signs[1] || found.len() == KEPT {
            continue;
        }
        let [mut from, mut to] = [pair[0].clone(), pair[1].clone()];
        for _ in 0..HALVINGS {
            let q = from.q.iter().zip(&to.q).map(|(a, b)| 0.5 * (a + b)).collect();
            let mut place = Sample { q, t: 0.5 * (from.t + to.t) };
            assembly.set_time(place.t);
            if assembly.correct(&mut place.q).is_err() {
                break;
            }
            if sign(&place) == signs[0] { from = place } else { to = place }
        }
        if walk::is_inside(&ranges, &to.q) {
            found.push(to);
        }
    }
    if found.is_empty() {
        return found;
    }
    let mut samples = table_at(alg, model, k, &k.sampled());
    let moving = k.unknowns.moving();
    let dead = Regularity::new(alg, model, k, rows, dependent, &mut samples).at(&found);
    let regular = Regularity::of_rank(alg, model, k, rows, (&moving, dependent.len()), &mut samples)
        .regular(found.clone());
    let places = found.into_iter().zip(dead);
    places.filter(|(q, left)| *left < DEAD && regular.contains(q)).map(|(q, _)| q).collect()
}

/// By sample: is the determinant of the columns of these unknowns positive?
fn signs(alg: &Algebra, table: &mut SampleTable, rows: &[Row], unknown: &[UnknownId]) -> Vec<bool> {
    let n = unknown.len();
    let mut matrices = vec![vec![0.0; n * n]; table.points()];
    for (i, row) in rows.iter().enumerate() {
        for (j, u) in unknown.iter().enumerate() {
            let Some(&entry) = row.coefficients.get(u) else { continue };
            let values = table.values(&alg.dag, entry);
            matrices.iter_mut().zip(values).for_each(|(matrix, x)| matrix[i * n + j] = *x);
        }
    }
    matrices.into_iter().map(|matrix| linear::determinant(matrix, n) > 0.0).collect()
}

/// Solves for the lifted unknowns from rows that determine them, and reduces the other rows to the speeds.
fn between_speeds(
    alg: &mut Algebra,
    k: &Kinematics,
    table: &mut SampleTable,
    rows: Vec<Row>,
) -> Option<Solution> {
    let lifted = k.unknowns.dependent();
    let known: Vec<UnknownId> = k.unknowns.independent().into_iter().chain(k.unknowns.clock()).collect();
    let choice = choose::Choice {
        rows: &rows,
        unknown: &lifted,
        count: lifted.len(),
        independent: choose::INDEPENDENT,
    };
    let taken = choose::rows(alg, k, table, &choice)?;
    let is_taken =
        |row: &&Row| taken.iter().any(|t| t.name == row.name && t.coefficients == row.coefficients);
    let left: Vec<Row> = rows.iter().filter(|row| !is_taken(row)).cloned().collect();
    let system = System { rows: taken.clone(), spare: Vec::new(), unknown: lifted, known };
    let mut solution = eliminate::solution_of(alg, k, table, &system, taken)?;
    solution.ties = left.into_iter().map(|row| tie(alg, &solution, &system.known, row)).collect();
    solution.rows = rows;
    Some(solution)
}

/// Substitutes the lifted unknowns in a row by the speeds.
fn tie(alg: &mut Algebra, solution: &Solution, known: &[UnknownId], mut row: Row) -> Row {
    for step in &solution.steps {
        let substituted = row.coefficients.substitute(&mut alg.dag, step.unknown, &step.coefficients);
        let Some(entry) = substituted else { continue };
        let product = alg.dag.mul(entry, step.bias);
        row.bias = alg.dag.add(row.bias, product);
    }
    let coefficients = known.iter().filter_map(|u| Some((*u, *row.coefficients.get(u)?))).collect();
    Row { coefficients, residual: alg.dag.zero(), ..row }
}

/// Newton's correction of least norm, one entry per coordinate of the state: J' (J J')^-1 (-f), where f(q) = 0 are the
/// configuration constraints. No coordinate is held.
pub fn correction(
    alg: &mut Algebra,
    k: &Kinematics,
    table: &mut SampleTable,
    state: &[CoordinateId],
) -> Vec<ExprId> {
    let symbols: Vec<SymbolId> = state.iter().filter_map(|&c| k.coordinate_symbol(&alg.dag, c)).collect();
    let mut rows: Vec<Vec<ExprId>> = Vec::new();
    for &residual in &k.residuals {
        rows.push(symbols.iter().map(|&symbol| alg.dag.derivative(residual, symbol)).collect());
    }
    let mut gram: BTreeMap<UnknownId, Equation> = BTreeMap::new();
    for (i, row) in rows.iter().enumerate() {
        let mut coefficients = LinearForm::default();
        for (j, other) in rows.iter().enumerate() {
            let terms: Vec<ExprId> = row.iter().zip(other).map(|(&x, &y)| alg.dag.mul(x, y)).collect();
            let sum = alg.dag.sum(&terms);
            if !alg.dag.is_zero(sum) {
                coefficients.insert(UnknownId::from_index(j), sum);
            }
        }
        let right = vec![alg.dag.negate(k.residuals[i])];
        gram.insert(UnknownId::from_index(i), Equation { coefficients, right });
    }
    let done = sparse::eliminate_definite(&mut alg.dag, table, gram);
    let values = sparse::back_substitute(&mut alg.dag, &done).unwrap_or_default();
    let mut corrections = Vec::new();
    for column in 0..symbols.len() {
        let mut terms = Vec::new();
        for (row, value) in rows.iter().zip(values.values()) {
            terms.push(alg.dag.mul(row[column], value[0]));
        }
        corrections.push(alg.dag.sum(&terms));
    }
    corrections
}
