//! Equations of motion for redundant speeds: Lagrange's equations of the first kind.
//!
//! In: M u' = f + J' lambda and the rows J u + j = 0 that tie the speeds, with J u' = -b. Out: u', lambda, and the
//! correction of speeds that violate the rows. M alone may be singular. It is positive on the motions that the rows
//! allow, so that A = M + J' s J is positive definite wherever J has full rank, and so is S = J A^-1 J'. The rows give
//! A u' = f - J' s b + J' lambda, hence u' = A^-1 (f + J' mu) with S mu = -b - J A^-1 f and lambda = mu + s b.
//!
//! Speeds are corrected in the metric of A, which to first order leaves the kinetic energy unchanged.

use super::solve::{Factors, NO_INERTIA};
use crate::expr::tape::SampleTable;
use crate::expr::{Dag, ExprId, SymbolId};
use crate::kinematics::eliminate::{Pivot, pivot_of};
use crate::kinematics::sizes::Sizes;
use crate::kinematics::{Kinematics, Row};
use crate::model::Model;
use crate::vector::Algebra;
use rustc_hash::FxHashMap as HashMap;

/// u' of redundant speeds, with multipliers and corrections.
#[derive(Clone, Debug)]
pub(super) struct Redundant {
    pub u_dot: Vec<ExprId>,
    /// lambda, one per row.
    pub multipliers: Vec<ExprId>,
    /// The correction that is added to the speeds.
    pub correction: Vec<ExprId>,
    pub pivots: Vec<Pivot>,
}

/// The rows as matrices over the speeds.
struct Ties {
    jacobian: Vec<Vec<ExprId>>,
    /// J u + j.
    rate: Vec<ExprId>,
    bias: Vec<ExprId>,
}

/// Solves for u'; `None` if some motion that the rows allow moves no mass.
pub(super) fn solve(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    table: &mut SampleTable,
    (rows, values): (&[Row], &HashMap<SymbolId, ExprId>),
    (mass, forcing): (&[Vec<ExprId>], &[ExprId]),
) -> Option<Redundant> {
    let Ties { jacobian, rate, bias } = ties(alg, k, rows, values);
    let sizes = Sizes::new(alg, model, k);
    let growths = sizes.growth_of_speeds(alg, model, k);
    let dag = &mut alg.dag;
    let scales = scales(dag, table, (&sizes, &growths), mass, &jacobian);
    let a = stiffened(dag, mass, &jacobian, &scales);
    let factors = Factors::new(dag, &a);
    let mut pivots = Vec::new();
    positive(dag, table, &a, &factors, &mut pivots)?;
    let columns: Vec<Vec<ExprId>> = jacobian.iter().map(|row| factors.solve(dag, row)).collect();
    let mut schur = vec![vec![dag.zero(); rows.len()]; rows.len()];
    for i in 0..rows.len() {
        for j in 0..=i {
            schur[i][j] = dot(dag, &jacobian[i], &columns[j]);
            schur[j][i] = schur[i][j];
        }
    }
    let schur_factors = Factors::new(dag, &schur);
    positive(dag, table, &schur, &schur_factors, &mut pivots)?;
    // x + A^-1 J' mu, with S mu = right.
    let along = |dag: &mut Dag, x: Option<&[ExprId]>, right: &[ExprId]| {
        let mu = schur_factors.solve(dag, right);
        let mut sums = Vec::new();
        for i in 0..forcing.len() {
            let mut terms: Vec<ExprId> = x.map(|x| x[i]).into_iter().collect();
            terms.extend(columns.iter().zip(&mu).map(|(column, &m)| dag.mul(column[i], m)));
            sums.push(dag.sum(&terms));
        }
        (sums, mu)
    };
    let free = factors.solve(dag, forcing);
    let mut missing = Vec::new();
    for (row, &b) in jacobian.iter().zip(&bias) {
        let met = dot(dag, row, &free);
        let sum = dag.add(met, b);
        missing.push(dag.negate(sum));
    }
    let (u_dot, mut multipliers) = along(dag, Some(&free), &missing);
    for ((lambda, &b), &scale) in multipliers.iter_mut().zip(&bias).zip(&scales) {
        let term = dag.mul(scale, b);
        *lambda = dag.add(*lambda, term);
    }
    let off: Vec<ExprId> = rate.iter().map(|&e| dag.negate(e)).collect();
    let (correction, _) = along(dag, None, &off);
    Some(Redundant { u_dot, multipliers, correction, pivots })
}

/// Correction of least norm of the speeds, for a model without masses.
pub(super) fn shortest_correction(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    table: &mut SampleTable,
    rows: &[Row],
) -> Option<Vec<ExprId>> {
    let n = k.unknowns.independent().len();
    let values = HashMap::default();
    let (zero, one) = (alg.dag.zero(), alg.dag.one());
    let unit = |i: usize| (0..n).map(|j| if i == j { one } else { zero }).collect();
    let identity: Vec<Vec<ExprId>> = (0..n).map(unit).collect();
    solve(alg, model, k, table, (rows, &values), (&identity, &vec![zero; n])).map(|found| found.correction)
}

/// lambda' j: the part of the drive's power that acts through the parts of the rows without speeds.
pub(super) fn power_of_drive(
    alg: &mut Algebra,
    k: &Kinematics,
    rows: &[Row],
    multipliers: &[ExprId],
) -> Option<ExprId> {
    let clock = k.unknowns.clock()?;
    let mut terms = Vec::new();
    for (row, &lambda) in rows.iter().zip(multipliers) {
        if let Some(&j) = row.coefficients.get(&clock) {
            terms.push(alg.dag.mul(j, lambda));
        }
    }
    Some(alg.dag.sum(&terms))
}

fn ties(alg: &mut Algebra, k: &Kinematics, rows: &[Row], values: &HashMap<SymbolId, ExprId>) -> Ties {
    let speeds = k.unknowns.independent();
    let zero = alg.dag.zero();
    let mut ties = Ties { jacobian: Vec::new(), rate: Vec::new(), bias: Vec::new() };
    for row in rows {
        let entries: Vec<ExprId> =
            speeds.iter().map(|u| row.coefficients.get(u).copied().unwrap_or(zero)).collect();
        let symbols: Vec<ExprId> = speeds.iter().map(|&u| k.unknowns[u].value).collect();
        let own = dot(&mut alg.dag, &entries, &symbols);
        let still =
            k.unknowns.clock().and_then(|clock| row.coefficients.get(&clock)).copied().unwrap_or(zero);
        ties.rate.push(alg.dag.add(own, still));
        ties.bias.push(alg.dag.substitute(&[row.bias], values)[0]);
        ties.jacobian.push(entries);
    }
    ties
}

/// s, one per row: powers of two that make J' s J about as large as M at the nominal configuration and parameters,
/// times the ratio by which M has grown relative to J' J at the parameters that are set. Sizes are sums of the
/// diagonals, with speeds scaled to a common unit.
fn scales(
    dag: &mut Dag,
    table: &mut SampleTable,
    (sizes, growths): (&Sizes, &[ExprId]),
    mass: &[Vec<ExprId>],
    jacobian: &[Vec<ExprId>],
) -> Vec<ExprId> {
    let diagonal: Vec<ExprId> = (0..mass.len()).map(|i| mass[i][i]).collect();
    let squares: Vec<ExprId> = growths.iter().map(|&growth| dag.mul(growth, growth)).collect();
    let mut sums = vec![dot(dag, &diagonal, &squares)];
    for row in jacobian {
        let grown: Vec<ExprId> = row.iter().zip(growths).map(|(&entry, &g)| dag.mul(entry, g)).collect();
        sums.push(dot(dag, &grown, &grown));
    }
    let growth = sizes.growth(dag, &sums);
    let nominal: Vec<f64> = sums.iter().map(|&sum| table.values(dag, sum)[0]).collect();
    let mut scales = Vec::new();
    for row in 1..sums.len() {
        let scale = (nominal[0] / nominal[row]).log2().round().exp2();
        let scale = dag.constant(if scale.is_finite() && scale > 0.0 { scale } else { 1.0 });
        let growth = dag.div(growth[0], growth[row]);
        scales.push(dag.mul(growth, scale));
    }
    scales
}

/// M + J' s J.
fn stiffened(
    dag: &mut Dag,
    mass: &[Vec<ExprId>],
    jacobian: &[Vec<ExprId>],
    scales: &[ExprId],
) -> Vec<Vec<ExprId>> {
    let mut a = mass.to_vec();
    for (row, &scale) in jacobian.iter().zip(scales) {
        for i in 0..row.len() {
            let scaled = dag.mul(scale, row[i]);
            for j in 0..=i {
                let term = dag.mul(scaled, row[j]);
                a[i][j] = dag.add(a[i][j], term);
                a[j][i] = a[i][j];
            }
        }
    }
    a
}

/// Records the pivots; `None` if one of them is not positive at a sample.
fn positive(
    dag: &Dag,
    table: &mut SampleTable,
    matrix: &[Vec<ExprId>],
    factors: &Factors,
    pivots: &mut Vec<Pivot>,
) -> Option<()> {
    for (i, &pivot) in factors.diagonal.iter().enumerate() {
        let reference = table.values(dag, matrix[i][i]).to_vec();
        let values = table.values(dag, pivot);
        if !values.iter().zip(&reference).all(|(d, m)| *d > NO_INERTIA * m.abs()) {
            return None;
        }
        if !dag.is_constant(pivot) {
            pivots.push(pivot_of(dag, table, pivot));
        }
    }
    Some(())
}

fn dot(dag: &mut Dag, a: &[ExprId], b: &[ExprId]) -> ExprId {
    let terms: Vec<ExprId> = a.iter().zip(b).map(|(&x, &y)| dag.mul(x, y)).collect();
    dag.sum(&terms)
}
