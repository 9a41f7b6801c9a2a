//! Rank of the constraints at sampled configurations, from numbers.
//!
//! In: the configuration constraints as scalars, differentiated by the chain rule, and the motion
//! constraints: rows over the speeds. Where a motion constraint speaks of a twist that the derivation lifts, the
//! twists are columns too, and the rows that say what they are stand beside the others. Out: rank at
//! every sample, and the worst conditioning. Rows are scaled by their largest length and orthogonalised, the
//! one with most left first (Gram & Schmidt with pivoting): what is left of a row when its turn comes
//! is the share of it that the rows before do not say already.

use smartbed_codegen::expr::ExprId;
use smartbed_codegen::id::Id;
use smartbed_codegen::kinematics::{Kinematics, Row, eliminate};
use smartbed_codegen::model::{Model, SpeedMeaning};
use std::collections::BTreeMap;

/// A row of which less is left follows from the others.
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
    /// Least that was left of a row that counts, at the worst sample; 1 without constraints.
    pub least_left: f64,
    /// That sample's coordinates.
    pub worst_at: Vec<f64>,
}

impl Rank {
    /// Looks at every sample.
    pub fn over_samples(model: &Model, k: &mut Kinematics) -> Self {
        let mut table = eliminate::sample_table(model, k);
        let (samples, unknowns) = (k.samples.len(), model.speeds.len());
        let mut rank = Self {
            unknowns,
            residuals: k.residuals.len(),
            samples,
            smallest: usize::MAX,
            largest: 0,
            least_left: 1.0,
            worst_at: k.samples.first().cloned().unwrap_or_default(),
        };
        let rows = rows(model, k);
        let highest = rows.iter().flat_map(|row| row.keys()).max().map_or(0, |&column| column + 1);
        let lifted = if unknowns < highest { k.moving_unknowns().len() - unknowns } else { 0 };
        let mut matrices = vec![vec![vec![0.0; unknowns + lifted]; rows.len()]; samples];
        for (r, row) in rows.iter().enumerate() {
            let coefficients: Vec<ExprId> = row.values().copied().collect();
            let errors = |sample| table.rounding_errors(&k.dag, &coefficients, sample);
            let errors: Vec<Vec<f64>> = (0..samples).map(errors).collect();
            for (i, (&column, &coefficient)) in row.iter().enumerate() {
                let values = table.values(&k.dag, coefficient);
                for ((matrix, value), errors) in matrices.iter_mut().zip(values).zip(&errors) {
                    // Scaled, a row of rounding errors would count as any other.
                    matrix[r][column] = if value.abs() <= errors[i] { 0.0 } else { *value };
                }
            }
        }
        scale(&mut matrices, rows.len());
        for (sample, matrix) in matrices.into_iter().enumerate() {
            let (found, left) = numeric_rank(matrix);
            let found = found.saturating_sub(lifted);
            rank.smallest = rank.smallest.min(found);
            rank.largest = rank.largest.max(found);
            if left < rank.least_left {
                rank.least_left = left;
                rank.worst_at.clone_from(&k.samples[sample]);
            }
        }
        rank.smallest = rank.smallest.min(rank.largest);
        rank
    }

    /// Degrees of freedom left by the constraints.
    pub fn freedom(&self) -> usize {
        self.unknowns - self.largest
    }
}

/// Every constraint as coefficients of the speeds.
fn rows(model: &Model, k: &mut Kinematics) -> Vec<BTreeMap<usize, ExprId>> {
    let mut rows = Vec::new();
    for residual in k.residuals.clone() {
        rows.push(gradient(model, k, residual));
    }
    // A coordinate in closed form with a speed of its own: that speed follows from the form.
    for (speed, declared) in model.speeds.enumerate() {
        let SpeedMeaning::RateOf(coordinate) = declared.meaning else { continue };
        if k.coordinate_symbol(coordinate).is_none() {
            let form = k.closed_forms.iter().find(|(c, _)| *c == coordinate).map(|(_, form)| *form);
            let mut row = gradient(model, k, form.unwrap_or(k.q[coordinate]));
            let minus_one = k.dag.constant(-1.0);
            row.insert(speed.index(), minus_one);
            rows.push(row);
        }
    }
    let is_motion = |name: &str| model.motion_constraints.iter().any(|c| c.name == name);
    let clock = k.clock.map(|clock| clock.index());
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

/// The row without the clock's column, which is none of the motion's; those behind it move up.
fn without(row: BTreeMap<usize, ExprId>, clock: usize) -> BTreeMap<usize, ExprId> {
    let moving = row.into_iter().filter(|(column, _)| *column != clock);
    moving.map(|(column, c)| (column - usize::from(clock < column), c)).collect()
}

/// Coefficients of the speeds in the rate of an expression, by the chain rule.
fn gradient(model: &Model, k: &mut Kinematics, of: ExprId) -> BTreeMap<usize, ExprId> {
    let mut row: BTreeMap<usize, ExprId> = BTreeMap::new();
    for coordinate in model.coordinates.ids() {
        let Some(symbol) = k.dag.as_symbol(k.q[coordinate]) else { continue };
        let slope = k.dag.derivative(of, symbol);
        for (&speed, &share) in &k.rates[coordinate].partials {
            let term = k.dag.mul(slope, share);
            let sum = match row.get(&speed.index()) {
                Some(&mine) => k.dag.add(mine, term),
                None => term,
            };
            row.insert(speed.index(), sum);
        }
    }
    row
}

/// Divides every row by its largest length over the samples: a row that vanishes at a sample is small
/// there, and not a direction made of rounding errors.
fn scale(matrices: &mut [Vec<Vec<f64>>], rows: usize) {
    for r in 0..rows {
        let largest = matrices.iter().map(|matrix| norm(&matrix[r])).fold(0.0, f64::max);
        if largest > 0.0 {
            matrices.iter_mut().for_each(|matrix| matrix[r].iter_mut().for_each(|x| *x /= largest));
        }
    }
}

/// Rank, and the least that was left of a row that counts.
fn numeric_rank(mut rows: Vec<Vec<f64>>) -> (usize, f64) {
    let (mut rank, mut least_left) = (0, 1.0_f64);
    while let Some((index, left)) = most_left(&rows).filter(|(_, left)| *left > ZERO) {
        let unit: Vec<f64> = rows.swap_remove(index).iter().map(|x| x / left).collect();
        for row in &mut rows {
            let along: f64 = row.iter().zip(&unit).map(|(x, e)| x * e).sum();
            row.iter_mut().zip(&unit).for_each(|(x, e)| *x -= along * e);
        }
        (rank, least_left) = (rank + 1, least_left.min(left));
    }
    (rank, least_left)
}

fn most_left(rows: &[Vec<f64>]) -> Option<(usize, f64)> {
    rows.iter().map(|row| norm(row)).enumerate().max_by(|a, b| a.1.total_cmp(&b.1))
}

fn norm(row: &[f64]) -> f64 {
    row.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dependent_rows_do_not_count() {
        let rows = vec![vec![0.6, 0.8, 0.0], vec![0.3, 0.4, 0.0], vec![0.0, 0.0, 1.0]];
        let (rank, left) = numeric_rank(rows);
        assert_eq!(rank, 2);
        assert!((left - 1.0).abs() < 1e-15, "{left}");
        // Two directions 0.1 rad apart: sin 0.1 is left of the second.
        let rows = vec![vec![1.0, 0.0], vec![0.1_f64.cos(), 0.1_f64.sin()]];
        let (rank, left) = numeric_rank(rows);
        assert_eq!(rank, 2);
        assert!((left - 0.1_f64.sin()).abs() < 1e-15, "{left}");
    }
}
