//! Is the end of a search an equilibrium?
//!
//! In: rates r and their Jacobian J at a state. Out: nothing, or why the state is no equilibrium. It is one if its
//! equations are regular, and if a step dz of at most [`CLOSE`] of the ranges explains the rates: what is left,
//! ```text
//! |r + J dz|  <=  rounding of the terms that r is summed from, and of unknowns as large as their ranges
//! ```
//! The former is a running bound over all operations at this state. Slopes times ranges alone are no measure: beside a
//! stiff spring every weight is small, though the spring carries nothing.

use super::search::{Fault, Flat, Rates, Search};
use nalgebra::{DMatrix, DVector};
use smartbed_codegen::expr::rounding::Rounded;
use smartbed_runtime::mechanism::Mechanism;
use smartbed_runtime::real::{Real, Scalar};

/// The equilibrium is at most this far away, in units of half the ranges.
const CLOSE: f64 = 1e-9;
/// Dependent coordinates are solved for to this many epsilons of half their ranges.
const SOLVED: f64 = 4.0;
/// What is within this many bounds of its rounding is 0.
pub(super) const BOUNDS: f64 = 4.0;

impl Search<'_> {
    /// Why this is no equilibrium; `None` if it is one.
    pub(super) fn fault(&mut self, here: &Rates) -> Option<Fault> {
        if !self.is_balanced(here) {
            return Some(Fault::Unbalanced);
        }
        // NaN counts as singular.
        let is_regular = here.pivot.abs() >= f64::ROOT_EPSILON;
        (!is_regular).then_some(Fault::Singular(here.pivot))
    }

    /// Does a small step explain the rates?
    pub(super) fn is_balanced(&mut self, here: &Rates) -> bool {
        let rows = self.rows(here);
        let slopes = self.slopes_of_unknowns(here, &rows);
        let rounding = self.rounding();
        let explains = |step: DVector<f64>| {
            let is_close = step.iter().all(|d| d.abs() <= CLOSE);
            is_close
                && (0..rows.len()).all(|i| {
                    let left = here.x_dot[rows[i]] + (slopes.row(i) * &step)[0];
                    // Steps are below the ranges, so that this bounds the rounding of J dz too.
                    let over_ranges: f64 = slopes.row(i).iter().map(|x| x.abs()).sum();
                    left.abs() <= BOUNDS * rounding[rows[i]] + f64::EPSILON * over_ranges
                })
        };
        explains(DVector::zeros(slopes.ncols()))
            || [Flat::Ranges, Flat::Scaled]
                .into_iter()
                .filter_map(|flat| self.newton_step(here, flat))
                .any(explains)
    }

    /// Bounds of the rounding errors of the rates here, by the entries of the state; 0 where there is no finite bound.
    fn rounding(&mut self) -> Vec<f64> {
        let (q, u, inputs) = self.with_rounding();
        let mut q_dot = vec![Rounded::ZERO; q.len()];
        let mut u_dot = vec![Rounded::ZERO; u.len()];
        let zero = Rounded::ZERO;
        if self.rounded.rates(zero, &q, &u, &inputs, &mut q_dot, &mut u_dot).is_err() {
            return vec![0.0; self.state.len()];
        }
        let rates = self.state.iter().map(|e| if e.is_speed { u_dot[e.place] } else { q_dot[e.place] });
        rates.map(|rate| finite(rate.error)).collect()
    }

    /// Bounds of the rounding errors of the slopes by the state. The state counts as exact but for its own last digit: a
    /// spring of length 0 has its direction from a length that is nothing but what is left of the way.
    pub(super) fn slope_errors(&mut self) -> DMatrix<f64> {
        let n = self.state.len();
        let [q, u, inputs] = [&self.q, &self.u, &self.inputs].map(|values| exact(values));
        match self.rounded.function(0, (Rounded::ZERO, &q, &u, &inputs, &[])) {
            Ok(near) => DMatrix::from_row_iterator(n, n, near[..n * n].iter().map(|x| finite(x.error))),
            Err(_) => DMatrix::zeros(n, n),
        }
    }

    /// Outputs here, each with a bound of its rounding error; none if they cannot be computed.
    pub(super) fn rounded_outputs(&mut self) -> Vec<(f64, f64)> {
        let (q, u, inputs) = self.with_rounding();
        let outputs = self.rounded.outputs(Rounded::ZERO, &q, &u, &inputs).unwrap_or_default();
        outputs.iter().map(|x| (x.value, finite(x.error))).collect()
    }

    /// Coordinates, speeds and inputs here, each with its own rounding.
    fn with_rounding(&self) -> (Vec<Rounded>, Vec<Rounded>, Vec<Rounded>) {
        let dependent = |(i, q): (usize, &f64)| match self.configurations.is_independent(i) {
            true => Rounded::from_f64(*q),
            false => Rounded::new(*q, SOLVED * f64::EPSILON * self.half_range(i)),
        };
        (self.q.iter().enumerate().map(dependent).collect(), exact(&self.u), exact(&self.inputs))
    }
}

fn exact(values: &[f64]) -> Vec<Rounded> {
    values.iter().map(|x| Rounded::from_f64(*x)).collect()
}

fn finite(x: f64) -> f64 {
    if x.is_finite() { x } else { 0.0 }
}
