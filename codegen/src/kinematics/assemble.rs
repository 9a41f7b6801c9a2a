//! Finds configurations that satisfy the constraints: Newton's method on the residuals, and continuation.
//!
//! In: independent coordinates and the time (given), dependent ones (guesses). Out: dependent coordinates with all
//! residuals at round-off, those of implied constraints included. A distant target is approached from the nominal
//! configuration along a straight line of the independent coordinates (Euler parameters: a great circle), so that the
//! branch connected to nominal is found.

mod search;

use super::linear;
use super::quantities::Kinematics;
use super::unit_vectors::UnitVectors;
use super::unreachable::Unreachable;
use crate::expr::rounding::Rounded;
use crate::expr::tape::Tape;
use crate::expr::{ExprId, SymbolId};
use crate::id::IdVec;
use crate::model::{CoordinateId, Model, ParameterId};
use crate::vector::Algebra;

/// Most steps of a continuation.
const MAX_STEPS: usize = 64;
/// Most steps of a continuation in time, through which a driven mechanism may turn many times.
const MAX_TIME_STEPS: usize = 4096;
/// Most Newton corrections per step.
const MAX_CORRECTIONS: usize = 25;
/// Residual, of equations with terms of order 1, that counts as satisfied: some thousand rounding errors.
const SATISFIED: f64 = 1e-12;
/// Largest correction in one Newton step; a larger one leads to another branch or comes from a singularity.
const LARGEST_CORRECTION: f64 = 0.5;
/// Rank threshold for counting degrees of freedom: a row with less than this left beside the others counts as
/// dependent.
const LOCKED: f64 = 1e-6;

/// Solves for dependent coordinates.
#[derive(Clone, Debug)]
pub struct Assembly {
    tape: Tape<f64>,
    /// Divisor of each residual, so that multiplying an equation by a number changes nothing.
    scales: Vec<f64>,
    /// The largest size of an equation's terms, at the nominal configuration; 1 without equations.
    size: f64,
    /// Names of the constraints that the residuals belong to.
    names: Vec<String>,
    /// Number of residuals, the last ones, that follow from the others at the default parameters.
    implied: usize,
    dependent: Vec<usize>,
    independent: Vec<usize>,
    /// Coordinates of unit length, such as Euler parameters, that are all held or all solved for.
    unit_vectors: UnitVectors,
    /// By coordinate: whether it is an angle, and its range.
    kinds: Vec<(bool, (f64, f64))>,
    /// Values of the tape's inputs: coordinates, then parameters, then the time.
    arguments: Vec<f64>,
    n_q: usize,
    /// Working memory of [`Assembly::correct`], which is called some hundred times.
    equations: Linearised,
    solver: linear::Solver,
}

/// Residuals and their derivatives at a configuration, each divided by its scale.
#[derive(Clone, Debug, Default)]
struct Linearised {
    /// Largest residual before scaling, and the index of its equation.
    absolute: (f64, usize),
    /// The residuals, one per equation; then their derivatives, one row per equation, one column per dependent
    /// coordinate.
    values: Vec<f64>,
    equations: usize,
}

impl Linearised {
    fn residual(&self) -> &[f64] {
        &self.values[..self.equations]
    }

    fn jacobian(&self) -> &[f64] {
        &self.values[self.equations..]
    }
}

/// The largest absolute value and its index; NaN if any entry is NaN.
fn largest(residual: &[f64]) -> (f64, usize) {
    let sizes = residual.iter().map(|r| r.abs()).enumerate();
    sizes.fold((0.0, 0), |m, (i, r)| if r > m.0 || r.is_nan() { (r, i) } else { m })
}

impl Assembly {
    /// Prepares the solver.
    #[must_use]
    pub fn new(alg: &mut Algebra, model: &Model, k: &Kinematics) -> Self {
        Self::holding(alg, model, k, |c| model.coordinates[c].independent)
    }

    /// [`Self::new`] with no coordinate held: all of them are solved for.
    pub(super) fn free(alg: &mut Algebra, model: &Model, k: &Kinematics) -> Self {
        Self::holding(alg, model, k, |_| false)
    }

    fn holding(
        alg: &mut Algebra,
        model: &Model,
        k: &Kinematics,
        is_held: impl Fn(CoordinateId) -> bool,
    ) -> Self {
        let state = |c: &CoordinateId| k.coordinate_symbol(&alg.dag, *c).is_some();
        let coordinates: Vec<_> = model.coordinates.ids().filter(state).collect();
        let symbols: Vec<SymbolId> =
            coordinates.iter().filter_map(|&c| k.coordinate_symbol(&alg.dag, c)).collect();
        let split = |wanted: bool| -> Vec<usize> {
            (0..coordinates.len()).filter(|&i| is_held(coordinates[i]) == wanted).collect()
        };
        let (independent, dependent) = (split(true), split(false));
        let residuals = [&k.residuals[..], &k.implied].concat();
        let mut roots = residuals.clone();
        let slopes = |alg: &mut Algebra, columns: &[usize]| -> Vec<ExprId> {
            let each = residuals.iter().flat_map(|&r| columns.iter().map(move |&c| (r, c)));
            each.map(|(residual, column)| alg.dag.derivative(residual, symbols[column])).collect()
        };
        roots.extend(slopes(alg, &dependent));
        if !k.implied.is_empty() {
            roots.extend(slopes(alg, &independent));
        }
        let mut inputs = symbols.clone();
        let mut arguments: Vec<f64> = coordinates.iter().map(|&c| model.coordinates[c].nominal).collect();
        for (id, &expr) in k.parameters.enumerate() {
            if let Some(symbol) = alg.dag.as_symbol(expr) {
                inputs.push(symbol);
                arguments.push(k.parameter_values[id]);
            }
        }
        inputs.extend(alg.dag.as_symbol(k.time));
        arguments.push(0.0);
        let argument = |symbol: SymbolId| {
            let known = inputs.iter().position(|s| *s == symbol);
            Rounded::new(known.map_or(f64::NAN, |i| arguments[i]), 0.0)
        };
        let sizes: Vec<f64> = alg.dag.evaluate(&residuals, &argument).into_iter().map(|r| r.size()).collect();
        let declared = coordinates.iter().map(|&c| &model.coordinates[c]);
        let together = |places: &[usize]| {
            let held = places.iter().filter(|place| independent.contains(place)).count();
            held == places.len() || independent.is_empty()
        };
        let unit_vectors = UnitVectors::find(&alg.dag, &residuals, &symbols).of(together);
        Self {
            tape: Tape::new(&alg.dag, &roots, &inputs),
            scales: sizes.iter().map(|size| scale(*size)).collect(),
            size: sizes.into_iter().reduce(f64::max).unwrap_or(1.0),
            names: k.residual_names.iter().chain(&k.implied_names).map(|p| p.name.clone()).collect(),
            implied: k.implied.len(),
            unit_vectors,
            kinds: declared.map(|c| (c.unit == "rad", c.range)).collect(),
            dependent,
            independent,
            arguments,
            n_q: coordinates.len(),
            equations: Linearised::default(),
            solver: linear::Solver::default(),
        }
    }

    /// The largest size of an equation's terms, at the nominal configuration; 1 without equations.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.size
    }

    /// Sets the values of the tunable parameters, in the order of their declaration.
    pub fn set_parameters(&mut self, tunable: &[f64]) {
        for (mine, &value) in self.arguments[self.n_q..].iter_mut().zip(tunable) {
            *mine = value;
        }
    }

    /// Sets the time (s) at which the constraints are evaluated; 0 at first.
    pub fn set_time(&mut self, t: f64) {
        if let Some(time) = self.arguments.last_mut() {
            *time = t;
        }
    }

    /// Continues from the configuration `from`, satisfied at the time last set, to time `t`; independent coordinates
    /// are held.
    ///
    /// # Errors
    /// If it does not converge with any number of steps up to `MAX_TIME_STEPS`.
    pub fn continue_in_time(&mut self, from: &[f64], t: f64) -> Result<Vec<f64>, Unreachable> {
        let start = self.arguments.last().copied().unwrap_or(0.0);
        let mut last = Unreachable::default();
        let mut steps = 1;
        while steps <= MAX_TIME_STEPS {
            let mut q = from.to_vec();
            let mut walk = (1..=steps).map(|step| {
                self.set_time(if step == steps {
                    t
                } else {
                    start + (t - start) * (step as f64 / steps as f64)
                });
                self.correct(&mut q)
            });
            match walk.find_map(Result::err) {
                None => return Ok(q),
                Some(unreachable) => last = unreachable,
            }
            steps *= 4;
        }
        self.set_time(t);
        Err(last)
    }

    /// Newton's method from the given guesses; `q` holds all coordinates in the state's order.
    ///
    /// # Errors
    /// If it does not converge.
    pub fn correct(&mut self, q: &mut [f64]) -> Result<(), Unreachable> {
        self.correct_by(q, self.scales.len())
    }

    /// The implied constraint that is violated where Newton's method from `q` meets the others; `None` if it does not,
    /// or if all are met.
    pub fn no_longer_implied(&mut self, q: &[f64]) -> Option<Unreachable> {
        let kept = self.scales.len() - self.implied;
        let mut q = q.to_vec();
        if self.implied == 0 || self.correct_by(&mut q, kept).is_err() {
            return None;
        }
        self.linearise(&q);
        let left = &self.equations.residual()[kept..];
        let (scaled, place) = largest(left);
        let constraint = self.names.get(kept + place).cloned();
        let residual = scaled * self.scales[kept + place];
        let found = Unreachable { residual, constraint, locked: true, ..Unreachable::default() };
        (scaled > SATISFIED.sqrt()).then_some(found)
    }

    /// [`Self::correct`] by the first `count` equations alone.
    fn correct_by(&mut self, q: &mut [f64], count: usize) -> Result<(), Unreachable> {
        let mut best = (f64::INFINITY, 0);
        for _ in 0..MAX_CORRECTIONS {
            self.linearise(q);
            best = if self.equations.absolute.0 < best.0 { self.equations.absolute } else { best };
            let scaled = largest(&self.equations.residual()[..count]).0;
            let size = self.take_step(q, count);
            if scaled < SATISFIED && size < SATISFIED.sqrt() {
                return Ok(());
            }
            if size.is_nan() || size >= LARGEST_CORRECTION {
                break;
            }
        }
        let constraint = self.names.get(best.1).cloned();
        Err(Unreachable { residual: best.0, constraint, ..Unreachable::default() })
    }

    /// Corrects `q` by the solution of the first `count` linearised equations; returns the size of the correction, NaN
    /// if it is not finite. Applied even in the last iteration: convergence is quadratic, so it brings the error far
    /// below the tolerance.
    fn take_step(&mut self, q: &mut [f64], count: usize) -> f64 {
        let (residual, jacobian) = self.equations.values.split_at_mut(self.equations.equations);
        let (residual, jacobian) = (&mut residual[..count], &jacobian[..count * self.dependent.len()]);
        residual.iter_mut().for_each(|r| *r = -*r);
        let correction = self.solver.basic(jacobian, residual, self.dependent.len());
        let mut size = 0.0_f64;
        for (&i, &d) in self.dependent.iter().zip(correction) {
            let part = if self.kinds[i].0 { d.abs() } else { (d / unit(q[i])).abs() };
            // What is no number is taken too.
            size = if part <= size { size } else { part };
            q[i] += d;
        }
        size
    }

    /// The equations, and their derivatives with respect to the dependent coordinates.
    fn linearised(&mut self, q: &[f64]) -> Linearised {
        self.linearise(q);
        std::mem::take(&mut self.equations)
    }

    /// [`Self::linearised`] in the working memory.
    fn linearise(&mut self, q: &[f64]) {
        let equations = &mut self.equations;
        let (m, n) = (self.scales.len(), self.dependent.len());
        equations.equations = m;
        equations.values.resize(m + m * n, 0.0);
        self.arguments[..self.n_q].copy_from_slice(&q[..self.n_q]);
        self.tape.run(&self.arguments, &mut equations.values);
        let (residual, jacobian) = equations.values.split_at_mut(m);
        equations.absolute = largest(residual);
        for (i, scale) in self.scales.iter().enumerate().filter(|(_, scale)| **scale != 1.0) {
            residual[i] /= scale;
            jacobian[i * n..(i + 1) * n].iter_mut().for_each(|slope| *slope /= scale);
        }
    }

    /// Returns an implied constraint that no longer follows from the others, if at this configuration, which satisfies
    /// all constraints, the mechanism has fewer degrees of freedom than independent coordinates.
    pub fn locked(&mut self, q: &[f64]) -> Option<Unreachable> {
        if self.implied == 0 {
            return None;
        }
        let mut values = vec![0.0; self.tape.n_outputs()];
        self.arguments[..self.n_q].copy_from_slice(&q[..self.n_q]);
        self.tape.run(&self.arguments, &mut values);
        let (m, n) = (self.scales.len(), self.dependent.len());
        let (dependent, independent) = values[m..].split_at(m * n);
        let free = self.independent.len();
        let mut all: Vec<f64> = Vec::new();
        for (i, scale) in self.scales.iter().enumerate() {
            all.extend(dependent[i * n..(i + 1) * n].iter().map(|x| x / scale));
            all.extend(independent[i * free..(i + 1) * free].iter().map(|x| x / scale));
        }
        let (_, rank) = linear::solve_to(&all, &mut vec![0.0; m], n + free, LOCKED);
        let name = self.names.get(m - self.implied).cloned();
        let locked = Unreachable { residual: 0.0, constraint: name, locked: true, ..Unreachable::default() };
        (rank > n).then_some(locked)
    }

    /// The constraint that a configuration violates most, for what its terms are: its name, its residual, and the share
    /// of its terms that this is. Terms are how far the residual moves with each dependent coordinate, angles by one
    /// radian, others by their own value.
    pub fn violation(&mut self, q: &[f64]) -> Option<(String, f64, f64)> {
        /// Terms of scaled equations that are smaller than this at `q` happen to vanish there.
        const LEAST: f64 = 1e-3;
        self.linearise(q);
        let n = self.dependent.len();
        let moves: Vec<f64> =
            self.dependent.iter().map(|&i| if self.kinds[i].0 { 1.0 } else { q[i].abs() }).collect();
        let share = |(i, residual): (usize, &f64)| {
            let slopes = &self.equations.jacobian()[i * n..(i + 1) * n];
            let terms: f64 = slopes.iter().zip(&moves).map(|(slope, by)| (slope * by).abs()).sum();
            (residual.abs() / terms.max(LEAST), i)
        };
        let shares = self.equations.residual().iter().enumerate().filter(|(_, r)| **r != 0.0).map(share);
        let (worst, i) = shares.max_by(|a, b| a.0.total_cmp(&b.0))?;
        Some((self.names.get(i)?.clone(), self.equations.residual()[i].abs() * self.scales[i], worst))
    }

    /// The held coordinates that a constraint ties to unit length, such as Euler parameters: the places of each vector.
    #[must_use]
    pub fn unit_vectors(&self) -> &[Vec<usize>] {
        self.unit_vectors.places()
    }

    /// Scales those of the held coordinates that are not given and that a constraint ties to unit length with others,
    /// such as Euler parameters, so that it is met; all of them if none is given.
    pub fn to_unit_length(&self, q: &mut [f64], is_given: impl Fn(usize) -> bool) {
        self.unit_vectors.complete(q, is_given);
    }

    /// Continues from the configuration `from` (satisfied) to the independent coordinates of `target`.
    ///
    /// # Errors
    /// If it does not converge with any number of steps up to `MAX_STEPS`.
    pub fn continue_to(&mut self, from: &[f64], target: &[f64]) -> Result<Vec<f64>, Unreachable> {
        let mut last = Unreachable::default();
        let mut steps = 1;
        while steps <= MAX_STEPS {
            match self.walk(from, target, steps, false) {
                Ok(q) => return Ok(q),
                Err(unreachable) => last = unreachable,
            }
            steps *= 4;
        }
        // With extrapolated guesses, which pass straight through points where branches cross.
        match self.walk(from, target, MAX_STEPS, true) {
            Ok(q) => Ok(q),
            Err(_) => Err(last),
        }
    }

    /// Continues in `steps` steps. The guess of each is the configuration before or, if `straight`, extrapolated from
    /// two.
    fn walk(
        &mut self,
        from: &[f64],
        target: &[f64],
        steps: usize,
        straight: bool,
    ) -> Result<Vec<f64>, Unreachable> {
        let mut q = from.to_vec();
        let [mut before, mut here] = [q.clone(), q.clone()];
        for step in 1..=steps {
            let part = step as f64 / steps as f64;
            here.copy_from_slice(&q);
            if straight {
                self.dependent.iter().for_each(|&i| q[i] += here[i] - before[i]);
            }
            for &i in &self.independent {
                q[i] = if step == steps { target[i] } else { from[i] + part * (target[i] - from[i]) };
            }
            if step < steps {
                self.to_unit_length(&mut q, |_| false);
            }
            self.correct(&mut q)?;
            std::mem::swap(&mut before, &mut here);
        }
        Ok(q)
    }
}

/// What corrections of a coordinate that is no angle are measured by: its length if that is above 1, else 1.
fn unit(value: f64) -> f64 {
    value.abs().max(1.0)
}

/// A power of 1024 near the size of an equation's terms: division by it is exact, and 1 for terms of order 1.
fn scale(size: f64) -> f64 {
    /// Exponents are multiples of this (binary places).
    const STEP: f64 = 10.0;
    (STEP * (size.log2() / STEP).round()).exp2()
}

/// Values of the tunable parameters in the order of their declaration.
#[must_use]
pub fn tunable_values(alg: &Algebra, k: &Kinematics, values: &IdVec<ParameterId, f64>) -> Vec<f64> {
    k.parameters
        .enumerate()
        .filter(|(_, e)| alg.dag.as_symbol(**e).is_some())
        .map(|(id, _)| values[id])
        .collect()
}
