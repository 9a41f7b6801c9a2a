//! Rank and conditioning of the constraints, computed numerically.
//!
//! In: the configuration constraints as scalars, differentiated by the chain rule, and the motion constraints: rows
//! over the speeds. If a motion constraint contains a twist that the derivation lifts, the twists are columns too, and
//! the rows that define them are included. Out: rank at every sample, and the worst conditioning: the smallest non-zero
//! singular value of the Jacobian over the largest. Rows and columns are scaled first, so that neither units nor
//! factors of equations matter.

use nalgebra::DMatrix;
use smartbed_codegen::expr::ExprId;
use smartbed_codegen::id::Id;
use smartbed_codegen::kinematics::{Kinematics, LinearForm, Row, sampling};
use smartbed_codegen::model::{Model, SpeedMeaning};
use smartbed_codegen::vector::Algebra;
use std::collections::BTreeMap;

/// A singular value below this fraction of the largest is zero: a row depends on the others.
const ZERO: f64 = 1e-8;

/// What the samples say.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Rank {
    /// Speeds.
    pub unknowns: usize,
    /// Scalar configuration constraints.
    pub residuals: usize,
    /// Configurations looked at.
    pub samples: usize,
    /// Smallest rank over the samples.
    pub smallest: usize,
    /// Largest rank over the samples.
    pub largest: usize,
    /// Of the Jacobian with the columns of all speeds.
    pub conditioning: Conditioning,
    /// Of its columns of dependent speeds: poor at a dead point of the independent ones even if the whole Jacobian's is
    /// good.
    pub of_dependent: Conditioning,
}

/// A smallest singular value over the largest; 1 without constraints.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Conditioning {
    /// At the nominal configuration.
    pub nominal: f64,
    /// At the worst sample.
    pub worst: f64,
    /// That sample's coordinates.
    pub worst_at: Vec<f64>,
}

impl Conditioning {
    /// Nominal and worst value; `values` has one per sample.
    fn new(values: &[f64], samples: &[Vec<f64>]) -> Self {
        let worst = values.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1));
        let (place, worst) = worst.map_or((0, 1.0), |(place, value)| (place, *value));
        let worst_at = samples.get(place).cloned().unwrap_or_default();
        Self { nominal: values.first().copied().unwrap_or(1.0), worst, worst_at }
    }

    /// Is it below this fraction of nominal, or of the largest singular value?
    pub fn is_lost(&self, of_nominal: f64, of_largest: f64) -> bool {
        self.worst < of_nominal * self.nominal || self.worst < of_largest
    }
}

impl Rank {
    /// Looks at every sample.
    pub fn over_samples(alg: &mut Algebra, model: &Model, k: &Kinematics) -> Self {
        let unknowns = model.speeds.len();
        let rows = rows(alg, model, k);
        let highest = rows.iter().flat_map(|row| row.keys()).max().map_or(0, |&column| column + 1);
        let lifted = if unknowns < highest { k.unknowns.moving().len() - unknowns } else { 0 };
        let mut matrices = jacobians(alg, model, k, &rows, unknowns + lifted);
        scale(&mut matrices);
        let free: Vec<usize> =
            model.speeds.iter().enumerate().filter(|(_, s)| s.independent).map(|(i, _)| i).collect();
        let n_dependent = unknowns + lifted - free.len();
        let least_dependent = |matrix: &DMatrix<f64>| match n_dependent {
            0 => 1.0,
            n => nth_singular_value(&matrix.clone().remove_columns_at(&free), n),
        };
        let dependent: Vec<f64> = matrices.iter().map(least_dependent).collect();
        let (found, values): (Vec<usize>, Vec<f64>) = matrices.into_iter().map(rank_and_conditioning).unzip();
        let ranks = || found.iter().map(|rank| rank.saturating_sub(lifted));
        Self {
            unknowns,
            residuals: k.residuals.len(),
            samples: k.samples.len(),
            smallest: ranks().min().unwrap_or(0),
            largest: ranks().max().unwrap_or(0),
            conditioning: Conditioning::new(&values, &k.samples),
            of_dependent: Conditioning::new(&dependent, &k.samples),
        }
    }

    /// Degrees of freedom left by the constraints.
    pub fn freedom(&self) -> usize {
        self.unknowns - self.largest
    }
}

/// The rows in numbers at every sample.
fn jacobians(
    alg: &Algebra,
    model: &Model,
    k: &Kinematics,
    rows: &[BTreeMap<usize, ExprId>],
    columns: usize,
) -> Vec<DMatrix<f64>> {
    let mut table = sampling::sample_table(alg, model, k);
    let samples = k.samples.len();
    let mut matrices = vec![DMatrix::zeros(rows.len(), columns); samples];
    for (r, row) in rows.iter().enumerate() {
        let coefficients: Vec<ExprId> = row.values().copied().collect();
        let errors = |sample| table.rounding_errors(&alg.dag, &coefficients, sample);
        let errors: Vec<Vec<f64>> = (0..samples).map(errors).collect();
        for (i, (&column, &coefficient)) in row.iter().enumerate() {
            let values = table.values(&alg.dag, coefficient);
            for ((matrix, value), errors) in matrices.iter_mut().zip(values).zip(&errors) {
                // Otherwise the scaling would make a row of rounding errors as large as any other.
                matrix[(r, column)] = if value.abs() <= errors[i] { 0.0 } else { *value };
            }
        }
    }
    matrices
}

/// Every constraint as coefficients of the speeds.
fn rows(alg: &mut Algebra, model: &Model, k: &Kinematics) -> Vec<BTreeMap<usize, ExprId>> {
    let mut rows = Vec::new();
    for &residual in &k.residuals {
        rows.push(gradient(alg, model, k, residual));
    }
    // A coordinate in closed form with a speed of its own: the derivative of the form gives that speed.
    for (speed, declared) in model.speeds.enumerate() {
        let SpeedMeaning::RateOf(coordinate) = declared.meaning else { continue };
        if k.coordinate_symbol(&alg.dag, coordinate).is_none() {
            let form = k.closed_forms.iter().find(|(c, _)| *c == coordinate).map(|(_, form)| *form);
            let mut row = gradient(alg, model, k, form.unwrap_or(k.q[coordinate]));
            let minus_one = alg.dag.constant(-1.0);
            row.insert(speed.index(), minus_one);
            rows.push(row);
        }
    }
    let is_motion = |name: &str| model.motion_constraints.iter().any(|c| c.name == name);
    let clock = k.unknowns.clock().map(|clock| clock.index());
    let is_twist = |unknown: usize| model.speeds.len() <= unknown && Some(unknown) != clock;
    let of_twist = |row: &Row| row.coefficients.keys().any(|unknown| is_twist(unknown.index()));
    let lifted = k.rows.iter().any(|row| is_motion(&row.name) && of_twist(row));
    for row in k.rows.iter().filter(|row| is_motion(&row.name) || (lifted && of_twist(row))) {
        rows.push(row.coefficients.iter().map(|(unknown, &c)| (unknown.index(), c)).collect());
    }
    match clock {
        Some(clock) => rows.into_iter().map(|row| without(row, clock)).collect(),
        None => rows,
    }
}

/// The row without the column of time, which is known; later columns move up by one.
fn without(row: BTreeMap<usize, ExprId>, clock: usize) -> BTreeMap<usize, ExprId> {
    let moving = row.into_iter().filter(|(column, _)| *column != clock);
    moving.map(|(column, c)| (column - usize::from(clock < column), c)).collect()
}

/// Coefficients of the speeds in the rate of an expression, by the chain rule.
fn gradient(alg: &mut Algebra, model: &Model, k: &Kinematics, of: ExprId) -> BTreeMap<usize, ExprId> {
    let mut row = LinearForm::default();
    for coordinate in model.coordinates.ids() {
        let Some(symbol) = alg.dag.as_symbol(k.q[coordinate]) else { continue };
        let slope = alg.dag.derivative(of, symbol);
        row.add(&mut alg.dag, slope, &k.rates[coordinate].partials);
    }
    row.into_iter().map(|(speed, coefficient)| (speed.index(), coefficient)).collect()
}

/// Scales rows and columns by factors common to all samples until the entries of each (root mean squares over the
/// samples) have geometric mean 1. Entries that vanish at a sample are then small there, and neither units nor factors
/// of equations matter. Unlike sums, geometric means can be reached for any pattern of zeros (Curtis & Reid 1972).
fn scale(matrices: &mut [DMatrix<f64>]) {
    /// Sweeps over rows and columns at most; they converge geometrically.
    const SWEEPS: usize = 1000;
    /// Converged if no logarithm changes by more.
    const STANDS: f64 = 1e-9;
    let (rows, columns) = matrices.first().map_or((0, 0), DMatrix::shape);
    let squares = matrices.iter().fold(DMatrix::zeros(rows, columns), |sum: DMatrix<f64>, matrix| {
        sum + matrix.component_mul(matrix) / matrices.len() as f64
    });
    let (mut of_rows, mut of_columns) = (vec![0.0_f64; rows], vec![0.0_f64; columns]);
    let logarithm = |r: usize, c: usize| Some(0.5 * squares[(r, c)].ln()).filter(|log| log.is_finite());
    for _ in 0..SWEEPS {
        let mut change = 0.0_f64;
        for (r, factor) in of_rows.iter_mut().enumerate() {
            let new = -mean((0..columns).filter_map(|c| Some(logarithm(r, c)? + of_columns[c])));
            change = change.max((new - *factor).abs());
            *factor = new;
        }
        for (c, factor) in of_columns.iter_mut().enumerate() {
            *factor = -mean((0..rows).filter_map(|r| Some(logarithm(r, c)? + of_rows[r])));
        }
        if change < STANDS {
            break;
        }
    }
    for matrix in matrices {
        for (c, mut column) in matrix.column_iter_mut().enumerate() {
            column.iter_mut().zip(&of_rows).for_each(|(x, factor)| *x *= (factor + of_columns[c]).exp());
        }
    }
}

/// Arithmetic mean; 0 if there are no values.
fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0), |(sum, count), value| (sum + value, count + 1));
    if count > 0 { sum / f64::from(count) } else { 0.0 }
}

/// Rank, and the smallest non-zero singular value over the largest.
fn rank_and_conditioning(matrix: DMatrix<f64>) -> (usize, f64) {
    if matrix.is_empty() {
        return (0, 1.0);
    }
    let values = matrix.singular_values();
    let largest = values.iter().fold(0.0_f64, |most, x| most.max(*x));
    let counting: Vec<f64> = values.iter().copied().filter(|x| *x > ZERO * largest).collect();
    (counting.len(), counting.iter().fold(1.0, |least, x| least.min(x / largest)))
}

/// The n-th largest singular value over the largest; 0 if there are fewer.
fn nth_singular_value(matrix: &DMatrix<f64>, n: usize) -> f64 {
    if matrix.is_empty() {
        return 0.0;
    }
    let mut values: Vec<f64> = matrix.singular_values().iter().copied().collect();
    values.sort_by(|a, b| b.total_cmp(a));
    let largest = values.first().copied().unwrap_or(0.0);
    if largest > 0.0 { values.get(n - 1).map_or(0.0, |x| x / largest) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dependent_rows_do_not_count() {
        let rows = DMatrix::from_row_slice(3, 3, &[0.6, 0.8, 0.0, 0.3, 0.4, 0.0, 0.0, 0.0, 1.0]);
        let (rank, _) = rank_and_conditioning(rows);
        assert_eq!(rank, 2);
        // Unit vectors at the angle a have singular values sqrt(1 +- cos a): their ratio is tan(a/2).
        let rows = DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 0.1_f64.cos(), 0.1_f64.sin()]);
        let (rank, conditioning) = rank_and_conditioning(rows);
        assert_eq!(rank, 2);
        assert!((conditioning - 0.05_f64.tan()).abs() < 1e-12, "{conditioning}");
    }

    #[test]
    fn neither_units_of_rows_nor_of_columns_matter() {
        let [a, b] = [[1.0, 0.2, 0.3, 0.9], [0.8, 0.1, 0.4, 1.1]];
        let plain = [a, b].map(|m| DMatrix::from_row_slice(2, 2, &m));
        let scaled =
            [a, b].map(|[x, y, z, w]| DMatrix::from_row_slice(2, 2, &[x, 1e3 * y, 1e-6 * z, 1e-3 * w]));
        let conditioning = |matrices: [DMatrix<f64>; 2]| {
            let mut matrices = matrices.to_vec();
            scale(&mut matrices);
            matrices.into_iter().map(|matrix| rank_and_conditioning(matrix).1).collect::<Vec<_>>()
        };
        for (x, y) in conditioning(plain).iter().zip(conditioning(scaled)) {
            assert!((x - y).abs() < 1e-6 * x, "{x} {y}");
        }
    }

    #[test]
    fn a_pattern_of_zeros_does_not_make_columns_vanish() {
        // Sums of rows and columns cannot be equal here but with nothing on the diagonal's left.
        let mut matrices = vec![DMatrix::from_row_slice(2, 3, &[1.0, 1.0, 0.0, 0.0, 1.0, 1.0])];
        scale(&mut matrices);
        let dependent = matrices[0].clone().remove_columns_at(&[0]);
        assert!(nth_singular_value(&dependent, 2) > 0.3, "{dependent}");
    }
}
