//! Configurations that satisfy the constraints: Newton on the plain residuals, and continuation.
//!
//! In: independent coordinates and the time (given), dependent ones (guesses). Out: dependent coordinates with
//! all residuals at round-off. Far targets are reached from the nominal configuration along a
//! straight line of the independent coordinates, so the branch connected to nominal is found.

use super::{Kinematics, linear, speed_map};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expr::SymbolId;
use crate::expr::rounding::Rounded;
use crate::expr::tape::Tape;
use crate::id::IdVec;
use crate::model::{CoordinateId, Model, ParameterId};

/// Random configurations sampled besides the nominal and the stated ones.
const RANDOM_SAMPLES: usize = 64;
/// Most steps of a continuation.
const MAX_STEPS: usize = 64;
/// Most steps of a continuation in time, through which a driven mechanism may turn many times.
const MAX_TIME_STEPS: usize = 4096;
/// Most Newton corrections per step.
const MAX_CORRECTIONS: usize = 25;
/// Residual, of equations with terms of order 1, that counts as satisfied: some thousand rounding errors.
const SATISFIED: f64 = 1e-12;
/// A residual of closed forms that is more than rounding.
const CONTRADICTION: f64 = 1e-9;
/// Largest correction of one Newton step: farther means another branch or a singularity.
const LARGEST_CORRECTION: f64 = 0.5;

/// Solves for dependent coordinates.
#[derive(Clone, Debug)]
pub struct Assembly {
    tape: Tape<f64>,
    /// By what every residual is divided: an equation says the same if all of it is multiplied.
    scales: Vec<f64>,
    dependent: Vec<usize>,
    independent: Vec<usize>,
    /// Values of the tape's inputs: coordinates, then parameters, then the time.
    arguments: Vec<f64>,
    n_q: usize,
}

/// The dependent coordinates could not be found.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Unreachable {
    /// Smallest residual reached.
    pub residual: f64,
}

impl Assembly {
    /// Prepares the solver.
    #[must_use]
    pub fn new(model: &Model, k: &mut Kinematics) -> Self {
        let state = |c: &CoordinateId| k.coordinate_symbol(*c).is_some();
        let coordinates: Vec<_> = model.coordinates.ids().filter(state).collect();
        let symbols: Vec<SymbolId> = coordinates.iter().filter_map(|&c| k.coordinate_symbol(c)).collect();
        let split = |wanted: bool| -> Vec<usize> {
            (0..coordinates.len())
                .filter(|&i| model.coordinates[coordinates[i]].independent == wanted)
                .collect()
        };
        let (independent, dependent) = (split(true), split(false));
        let mut roots = k.residuals.clone();
        for residual in k.residuals.clone() {
            for &column in &dependent {
                let slope = k.dag.derivative(residual, symbols[column]);
                roots.push(slope);
            }
        }
        let mut inputs = symbols;
        let mut arguments: Vec<f64> = coordinates.iter().map(|&c| model.coordinates[c].nominal).collect();
        for (id, &expr) in k.parameters.enumerate() {
            if let Some(symbol) = k.dag.as_symbol(expr) {
                inputs.push(symbol);
                arguments.push(k.parameter_values[id]);
            }
        }
        inputs.extend(k.dag.as_symbol(k.time));
        arguments.push(0.0);
        let argument = |symbol: SymbolId| {
            let known = inputs.iter().position(|s| *s == symbol);
            Rounded::new(known.map_or(f64::NAN, |i| arguments[i]), 0.0)
        };
        let scales = k.dag.evaluate(&k.residuals, &argument).into_iter().map(|r| scale(r.size())).collect();
        Self {
            tape: Tape::new(&k.dag, &roots, &inputs),
            scales,
            dependent,
            independent,
            arguments,
            n_q: coordinates.len(),
        }
    }

    /// Sets the values of the tunable parameters, in the order of their declaration.
    pub fn set_parameters(&mut self, tunable: &[f64]) {
        for (mine, &value) in self.arguments[self.n_q..].iter_mut().zip(tunable) {
            *mine = value;
        }
    }

    /// The time (s) at which the constraints are taken; 0 at first.
    pub fn set_time(&mut self, t: f64) {
        if let Some(time) = self.arguments.last_mut() {
            *time = t;
        }
    }

    /// From the configuration `from`, satisfied at the time last set, to time `t`, independent coordinates held.
    ///
    /// # Errors
    /// If no number of steps gets there.
    pub fn continue_in_time(&mut self, from: &[f64], t: f64) -> Result<Vec<f64>, Unreachable> {
        let start = self.arguments.last().copied().unwrap_or(0.0);
        let mut last = Unreachable { residual: f64::INFINITY };
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

    /// Newton from the given guesses; all coordinates in the state's order.
    ///
    /// # Errors
    /// If it does not converge.
    pub fn correct(&mut self, q: &mut [f64]) -> Result<(), Unreachable> {
        let mut best = f64::INFINITY;
        for _ in 0..MAX_CORRECTIONS {
            let (residual, scaled, correction) = self.newton_step(q);
            best = best.min(residual);
            // The last correction has brought the error to the square of a small number.
            for (&i, d) in self.dependent.iter().zip(correction.iter()) {
                q[i] += d;
            }
            let size =
                correction.iter().fold(0.0_f64, |m, d| if d.is_nan() { f64::NAN } else { m.max(d.abs()) });
            if scaled < SATISFIED && size < SATISFIED.sqrt() {
                return Ok(());
            }
            if size.is_nan() || size >= LARGEST_CORRECTION {
                break;
            }
        }
        Err(Unreachable { residual: best })
    }

    /// Largest residual, as it is and scaled, and Newton's correction of the dependent coordinates.
    fn newton_step(&mut self, q: &[f64]) -> (f64, f64, Vec<f64>) {
        let mut outputs = vec![0.0; self.tape.n_outputs()];
        self.arguments[..self.n_q].copy_from_slice(&q[..self.n_q]);
        self.tape.run(&self.arguments, &mut outputs);
        let (residual, jacobian) = outputs.split_at_mut(self.scales.len());
        let largest = |residual: &[f64]| {
            residual.iter().fold(0.0, |m: f64, r| if r.is_nan() { f64::NAN } else { m.max(r.abs()) })
        };
        let absolute = largest(residual);
        let n = self.dependent.len();
        for (i, scale) in self.scales.iter().enumerate().filter(|(_, scale)| **scale != 1.0) {
            residual[i] /= scale;
            jacobian[i * n..(i + 1) * n].iter_mut().for_each(|slope| *slope /= scale);
        }
        let scaled = largest(residual);
        residual.iter_mut().for_each(|r| *r = -*r);
        let (correction, _) = linear::solve(jacobian, residual, n);
        (absolute, scaled, correction)
    }

    /// From the configuration `from` (satisfied) to the independent coordinates of `target`.
    ///
    /// # Errors
    /// If no number of steps up to 64 gets there.
    pub fn continue_to(&mut self, from: &[f64], target: &[f64]) -> Result<Vec<f64>, Unreachable> {
        let mut last = Unreachable { residual: f64::INFINITY };
        let mut steps = 1;
        while steps <= MAX_STEPS {
            match self.walk(from, target, steps) {
                Ok(q) => return Ok(q),
                Err(unreachable) => last = unreachable,
            }
            steps *= 4;
        }
        Err(last)
    }

    fn walk(&mut self, from: &[f64], target: &[f64], steps: usize) -> Result<Vec<f64>, Unreachable> {
        let mut q = from.to_vec();
        for step in 1..=steps {
            let part = step as f64 / steps as f64;
            for &i in &self.independent {
                q[i] = if step == steps { target[i] } else { from[i] + part * (target[i] - from[i]) };
            }
            self.correct(&mut q)?;
        }
        Ok(q)
    }
}

/// A power of two near the size of an equation's terms, in steps of a thousand: exact, and 1 for equations of order 1.
fn scale(size: f64) -> f64 {
    /// Binary places of a step.
    const STEP: f64 = 10.0;
    (STEP * (size.log2() / STEP).round()).exp2()
}

/// Fills the samples: nominal, stated configurations, random ones.
pub(super) fn derive(model: &Model, k: &mut Kinematics) -> Result<(), Diagnostics> {
    closed_forms(model, k)?;
    let mut assembly = Assembly::new(model, k);
    let state: Vec<CoordinateId> =
        model.coordinates.ids().filter(|&c| k.coordinate_symbol(c).is_some()).collect();
    let mut nominal: Vec<f64> = state.iter().map(|&c| model.coordinates[c].nominal).collect();
    if let Err(unreachable) = assembly.correct(&mut nominal) {
        return Err(nominal_unreachable(model, unreachable));
    }
    let mut samples = vec![nominal.clone()];
    let mut times = vec![0.0];
    for configuration in &model.configurations {
        let mut target = nominal.clone();
        for (coordinate, value) in &configuration.values {
            if let Some(i) = state.iter().position(|c| c == coordinate) {
                target[i] = *value;
            }
        }
        samples.extend(assembly.continue_to(&nominal, &target));
    }
    times.resize(samples.len(), 0.0);
    // Rejected targets (outside the reachable range) are drawn again, a bounded number of times.
    let mut random = Random(0x5EED_0F5A_3B1E);
    let wanted = samples.len() + RANDOM_SAMPLES;
    for _ in 0..4 * RANDOM_SAMPLES {
        if samples.len() == wanted {
            break;
        }
        let t = if k.clock.is_some() { random.between((0.0, model.run.seconds)) } else { 0.0 };
        let Ok(nominal) = at_time(&mut assembly, &nominal, t) else { continue };
        let mut target = nominal.clone();
        for (i, &c) in state.iter().enumerate() {
            let coordinate = &model.coordinates[c];
            if coordinate.independent {
                target[i] = random.between(coordinate.range);
            }
        }
        if let Ok(q) = assembly.continue_to(&nominal, &target)
            && in_range(model, &state, &q)
        {
            samples.push(q);
            times.push(t);
        }
    }
    (k.samples, k.sample_times) = (samples, times);
    Ok(())
}

/// The nominal configuration at another time.
fn at_time(assembly: &mut Assembly, nominal: &[f64], t: f64) -> Result<Vec<f64>, Unreachable> {
    assembly.set_time(0.0);
    if t == 0.0 { Ok(nominal.to_vec()) } else { assembly.continue_in_time(nominal, t) }
}

/// Puts closed forms into the residuals. Those that hold by the forms alone are solved already.
///
/// # Errors
/// If closed forms contradict a constraint that nothing else could satisfy.
fn closed_forms(model: &Model, k: &mut Kinematics) -> Result<(), Diagnostics> {
    if k.closed_forms.is_empty() || k.residuals.is_empty() {
        return Ok(());
    }
    let forms = k.closed_form_values();
    let residuals = k.dag.substitute(&k.residuals.clone(), &forms);
    let mut table = speed_map::screening_table(model, k);
    let free: Vec<SymbolId> = (model.coordinates.enumerate())
        .filter(|(_, c)| !c.independent)
        .filter_map(|(id, _)| k.coordinate_symbol(id))
        .collect();
    let mut found = Diagnostics::new(model.source.clone());
    let mut kept = Vec::new();
    for (residual, place) in residuals.into_iter().zip(std::mem::take(&mut k.residual_names)) {
        if k.dag.symbols_of(residual).iter().any(|symbol| free.contains(symbol)) {
            kept.push((residual, place));
            continue;
        }
        // Outside the reachable range a form may be no number.
        let values = table.values(&k.dag, residual).iter().filter(|r| r.is_finite());
        let worst = values.fold(0.0_f64, |worst, r| worst.max(r.abs()));
        if CONTRADICTION < worst {
            found.push(
                Diagnostic::error(format!("the closed forms contradict `{}`", place.name))
                    .label(
                        place.span,
                        format!("off by up to {worst:.1e} within the ranges of the coordinates"),
                    )
                    .help("correct the closed forms of the coordinates that occur here, or the constraint"),
            );
        }
    }
    (k.residuals, k.residual_names) = kept.into_iter().unzip();
    found.finish(())
}

fn in_range(model: &Model, state: &[CoordinateId], q: &[f64]) -> bool {
    state.iter().zip(q).all(|(&c, &value)| {
        let (low, high) = model.coordinates[c].range;
        model.coordinates[c].independent || (low <= value && value <= high)
    })
}

fn nominal_unreachable(model: &Model, unreachable: Unreachable) -> Diagnostics {
    let mut error = Diagnostic::error("the nominal configuration cannot be assembled").help(format!(
        "give nominal values nearer to a configuration that satisfies every constraint (residual reached: {:.1e})",
        unreachable.residual
    ));
    for constraint in &model.configuration_constraints {
        error = error.label(constraint.span, "this constraint, among others, must hold there");
    }
    for point in model.points.iter().filter(|p| !p.closures.is_empty()) {
        error = error.label(point.span, "this loop must close there");
    }
    Diagnostics { source: model.source.clone(), items: vec![error] }
}

/// A small deterministic generator (SplitMix64): the same samples on every machine.
pub(crate) struct Random(pub u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Uniform in a range.
    pub(crate) fn between(&mut self, (low, high): (f64, f64)) -> f64 {
        low + (high - low) * ((self.next() >> 11) as f64 / (1_u64 << 53) as f64)
    }
}

/// Values of the tunable parameters in the order of their declaration.
#[must_use]
pub fn tunable_values(k: &Kinematics, values: &IdVec<ParameterId, f64>) -> Vec<f64> {
    k.parameters
        .enumerate()
        .filter(|(_, e)| k.dag.as_symbol(**e).is_some())
        .map(|(id, _)| values[id])
        .collect()
}
