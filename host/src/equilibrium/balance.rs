//! Is the end of a search an equilibrium?
//!
//! In: rates r and their Jacobian J at a state. Out: nothing, or why the state is no equilibrium. It is one if its
//! equations are regular, and if a step dz of at most [`CLOSE`] of the ranges explains the rates: what is left,
//! ```text
//! |r + J dz|  <=  rounding of the terms that r is summed from, and of unknowns as large as their ranges
//! ```
//! The former is a running bound over all operations at this state. Slopes times ranges alone are no measure: beside a
//! stiff spring every weight is small, though the spring carries nothing.
//!
//! The forces f = M u' have to vanish by the same test. Where the speeds stop being independent of one another, u'
//! vanishes by its definition while the coordinates accelerate; f does not vanish there, but grows.

use super::search::{Fault, Flat, Rates, Search};
use nalgebra::{DMatrix, DVector};
use smartbed_codegen::expr::rounding::Rounded;
use smartbed_runtime::mechanism::Mechanism;
use smartbed_runtime::real::{Real, Scalar};

/// The equilibrium is at most this far away, in units of half the ranges.
pub(super) const CLOSE: f64 = 1e-9;
/// Dependent coordinates are solved for to this many epsilons of half their ranges.
const SOLVED: f64 = 4.0;
/// What is within this many bounds of its rounding is 0.
pub(super) const BOUNDS: f64 = 4.0;

/// Place of the mass matrix and the forcing among the functions of the program.
const FORCES: usize = 1;

/// Numbers that vanish at an equilibrium.
struct Vanishing {
    values: Vec<f64>,
    /// Bounds of their rounding errors.
    rounding: Vec<f64>,
    /// Their derivatives by the unknowns, in units of the ranges.
    slopes: DMatrix<f64>,
}

impl Vanishing {
    /// Is what a step leaves of them rounding?
    fn is_left_by(&self, step: &DVector<f64>) -> bool {
        (0..self.values.len()).all(|i| {
            let left = self.values[i] + (self.slopes.row(i) * step)[0];
            // Steps are below the ranges, so that this bounds the rounding of J dz too.
            let over_ranges: f64 = self.slopes.row(i).iter().map(|x| x.abs()).sum();
            left.abs() <= BOUNDS * self.rounding[i] + f64::EPSILON * over_ranges
        })
    }
}

impl Search<'_> {
    /// Why this is no equilibrium; `None` if it is one.
    pub(super) fn fault(&mut self, here: &Rates) -> Option<Fault> {
        if !self.is_balanced(here) {
            let rates = self.vanishing_rates(here);
            let is_still = self.explains(here, &[rates]);
            return Some(if is_still { Fault::Dependent(here.pivot) } else { Fault::Unbalanced });
        }
        // NaN counts as singular.
        let is_regular = here.pivot.abs() >= f64::ROOT_EPSILON;
        (!is_regular).then_some(Fault::Singular(here.pivot))
    }

    /// Does a small step explain the rates, and the forces as well?
    pub(super) fn is_balanced(&mut self, here: &Rates) -> bool {
        let rates = self.vanishing_rates(here);
        if !self.explains(here, std::slice::from_ref(&rates)) {
            return false;
        }
        match self.vanishing_forces(here) {
            Some(forces) => self.explains(here, &[rates, forces]),
            None => true,
        }
    }

    /// Does one small step make all these vanish?
    fn explains(&self, here: &Rates, all: &[Vanishing]) -> bool {
        let unknowns = all.first().map_or(0, |one| one.slopes.ncols());
        let explains = |step: DVector<f64>| {
            let is_close = step.iter().all(|d| d.abs() <= CLOSE);
            is_close && all.iter().all(|one| one.is_left_by(&step))
        };
        explains(DVector::zeros(unknowns))
            || [Flat::Ranges, Flat::Scaled]
                .into_iter()
                .filter_map(|flat| self.newton_step(here, flat))
                .any(explains)
    }

    /// The rates that have to vanish.
    fn vanishing_rates(&mut self, here: &Rates) -> Vanishing {
        let rows = self.rows(here);
        let rounding = self.rounding();
        Vanishing {
            values: rows.iter().map(|&i| here.x_dot[i]).collect(),
            rounding: rows.iter().map(|&i| rounding[i]).collect(),
            slopes: self.slopes_of_unknowns(here, &rows),
        }
    }

    /// The forces on the speeds, f = M u', with their slopes M du'/dz; `None` if they cannot be computed.
    fn vanishing_forces(&mut self, here: &Rates) -> Option<Vanishing> {
        let (q, u, inputs) = self.with_rounding();
        let forces = self.rounded.function(FORCES, (Rounded::ZERO, &q, &u, &inputs, &[])).ok()?;
        let n = u.len();
        let (mass, forcing) = forces.split_at_checked(n * n)?;
        let mass = DMatrix::from_row_iterator(n, n, mass.iter().map(|x| x.value));
        let speeds: Vec<usize> = (0..self.state.len()).filter(|&i| self.state[i].is_speed).collect();
        Some(Vanishing {
            values: forcing.iter().map(|x| x.value).collect(),
            rounding: forcing.iter().map(|x| finite(x.error)).collect(),
            slopes: mass * self.slopes_of_unknowns(here, &speeds),
        })
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

    /// Bounds of the rounding errors of the slopes by the state. The state counts as exact but for its own last digit:
    /// a spring of length 0 has its direction from a length that is nothing but what is left of the way.
    pub(super) fn slope_errors(&mut self) -> DMatrix<f64> {
        let [q, u, inputs] = [&self.q, &self.u, &self.inputs].map(|values| exact(values));
        self.errors_of_slopes([q, u, inputs])
    }

    /// The same with the rounding of dependent coordinates.
    pub(super) fn slope_bounds(&mut self) -> DMatrix<f64> {
        let (q, u, inputs) = self.with_rounding();
        self.errors_of_slopes([q, u, inputs])
    }

    fn errors_of_slopes(&mut self, [q, u, inputs]: [Vec<Rounded>; 3]) -> DMatrix<f64> {
        let n = self.state.len();
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
