//! Steps a mechanism from start to end and hands out its rows.
//!
//! In: a program, its observers, settings, the start. Out: rows at equal intervals, each a list of numbers named by
//! [`columns`], and a [`Summary`]. Observers only read states; without them the motion is the same bit for bit.

use super::health::{Energies, Health, NEARLY_SINGULAR, Range};
use super::kink::pass;
use super::ledger::{self, Ledger};
pub use super::plant::Plant;
use super::settings::Settings;
use crate::chatter::Chatter;
use crate::engine::{Engine, EngineScalar, explain};
use crate::failure::Failure;
use crate::interrupt;
use crate::limits::{Angles, check_numbers};
use crate::number::worst;
use crate::observers::Observers;
use crate::progress::Progress;
use crate::switches::{MOST, rounding, too_many};
use smartbed_codegen::{Interpreted, Program};
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::Ode;
use smartbed_runtime::ode::State;
use smartbed_runtime::ode::step_size::Tolerance;
use smartbed_runtime::ode::{DormandPrince, Method, Report, dormand_prince};
use smartbed_runtime::real::Scalar;
use std::collections::BTreeMap;

/// Most steps of the adaptive method.
const MOST_STEPS: u64 = 100_000_000;
/// Intervals of Simpson's rule in an adaptive step: an even number.
const PARTS: usize = 8;
/// A remainder of the time below this fraction of a step is rounding.
const ROUNDING: f64 = 1e-3;

/// One row of a run.
#[derive(Clone, PartialEq, Debug)]
pub struct Row {
    /// Numbers under the names of [`columns`].
    pub values: Vec<f64>,
    /// Values for a picture, see [`Observers::places`].
    pub places: Vec<f64>,
}

/// The summary of a run.
#[derive(Clone, PartialEq, Debug)]
pub struct Summary {
    /// Steps taken.
    pub steps: u64,
    /// Evaluations of the equations of motion.
    pub evaluations: u64,
    /// Rows handed out.
    pub rows: u64,
    /// Smallest pivot so far, relative to nominal.
    pub pivot: f64,
    /// Largest constraint residual before a projection.
    pub residual: f64,
    /// Largest absolute imbalance of the ledger at any row (J).
    pub imbalance: f64,
    /// Findings of the run.
    pub health: Health,
    /// The last row.
    pub last: Vec<f64>,
}

/// All arguments of a run.
#[derive(Clone, Copy, Debug)]
pub struct Setup<'a> {
    /// The equations.
    pub program: &'a Program,
    /// Observed quantities.
    pub observers: &'a Observers,
    /// Settings.
    pub settings: &'a Settings,
    /// Coordinates and independent speeds at the start.
    pub start: &'a [f64],
}

/// Names of a row's numbers.
#[must_use]
pub fn columns(program: &Program, observers: &Observers) -> Vec<String> {
    let mut names = vec!["t".to_owned()];
    names.extend(program.q.iter().map(|q| q.name.clone()));
    names.extend(observers.closed.iter().map(|(name, _)| name.clone()));
    names.extend(program.speeds.iter().map(|(name, _)| name.clone()));
    names.extend(ledger::columns(program).into_iter().map(str::to_owned));
    names.extend(observers.outputs.iter().flatten().chain(&observers.inputs).cloned());
    names
}

/// Makes rows, and collects the summary.
struct Recorder<'a, F> {
    program: &'a Program,
    observers: &'a Observers,
    places: Interpreted<f64>,
    /// Of the equations and of the laws.
    angles: [Angles; 2],
    sink: F,
    summary: Summary,
    columns: Vec<String>,
    chatter: Chatter,
}

impl<F: FnMut(&Row) -> Result<(), Failure>> Recorder<'_, F> {
    fn row<E, S>(&mut self, plant: &mut Plant<E, S>, t: f64, x: &[S], ledger: &Ledger) -> Result<(), Failure>
    where
        E: std::ops::DerefMut<Target = dyn Engine<S>>,
        S: EngineScalar,
    {
        let failure = |fault| Failure::Wrong(format!("t = {t} s: {}", explain(fault)));
        let n_q = self.program.q.len();
        let (q, u) = x.split_at(n_q);
        let now = plant.switches.moment(S::from_f64(t)).map_err(failure)?;
        plant.command(now, x).map_err(failure)?;
        plant.engine.set_time(now);
        let speeds = plant.engine.speeds(q, u).map_err(failure)?;
        let outputs = plant.engine.outputs(now, q, u, &plant.inputs).map_err(failure)?;
        // What a singular configuration throws beyond all bounds is no fault of the numbers.
        let is_singular = self.summary.pivot.is_nan() || self.summary.pivot < NEARLY_SINGULAR;
        let beyond = |why| match is_singular {
            true => refused(t, Fault::Singular),
            false => Failure::Wrong(format!("t = {t:.6} s: {why}")),
        };
        let inputs = widened(&plant.inputs);
        for angles in &mut self.angles {
            angles.check(t, &widened(q), &widened(u), &inputs).map_err(beyond)?;
        }
        let accounts = ledger.accounts();
        if !accounts.imbalance().is_finite() {
            return Err(refused(t, if is_singular { Fault::Singular } else { Fault::NonFinite }));
        }
        let closed = plant.closed_forms(S::from_f64(t), x).map_err(failure)?;
        let mut values = vec![t];
        values
            .extend(q.iter().chain(closed.iter().map(|[value, _]| value)).chain(&speeds).map(|x| x.to_f64()));
        values.extend(accounts.columns());
        for ((name, _), value) in self.program.outputs.iter().zip(&outputs) {
            self.summary.health.output(name, value.to_f64(), t);
        }
        let shown = outputs.iter().zip(&self.observers.outputs).filter(|(_, name)| name.is_some());
        values.extend(shown.map(|(value, _)| value).chain(&plant.inputs).map(|value| value.to_f64()));
        let (wide_q, wide_u): (Vec<f64>, Vec<f64>) =
            (q.iter().map(|x| x.to_f64()).collect(), u.iter().map(|x| x.to_f64()).collect());
        let no_inputs = vec![0.0; plant.inputs.len()];
        let places = self.places.outputs(now.to_f64(), &wide_q, &wide_u, &no_inputs).map_err(failure)?;
        self.summary.rows += 1;
        self.summary.imbalance = worst(self.summary.imbalance, accounts.imbalance());
        let stored = [accounts.kinetic, accounts.gravity, accounts.spring];
        let change = accounts.total() - accounts.start;
        let moved = [change, accounts.damping, accounts.actuator, accounts.external];
        self.summary.health.energies(Energies {
            stored: &stored,
            moved: &moved,
            imbalance: accounts.imbalance(),
        });
        let coordinates = 1..1 + q.len() + closed.len();
        for (name, value) in self.columns[coordinates.clone()].iter().zip(&values[coordinates]) {
            self.summary.health.place(name, *value, t);
        }
        self.summary.last.clone_from(&values);
        (self.sink)(&Row { values, places })
    }

    /// The message for a step refused at a state: what is not finite is told with its cause where that is known.
    fn refused<E, S>(&mut self, plant: &mut Plant<E, S>, t: f64, x: &[S], fault: Fault) -> Failure
    where
        E: std::ops::DerefMut<Target = dyn Engine<S>>,
        S: EngineScalar,
    {
        if fault != Fault::NonFinite {
            return refused(t, fault);
        }
        let mut x_dot = vec![S::ZERO; x.len()];
        // A pivot of 0 may leave those after it without a number.
        let is_singular = |pivot: S| pivot.to_f64().is_nan() || pivot.to_f64().abs() < NEARLY_SINGULAR;
        let was_singular = self.summary.pivot < NEARLY_SINGULAR;
        if was_singular || plant.rates(S::from_f64(t), x, &mut x_dot).is_ok_and(is_singular) {
            return refused(t, Fault::Singular);
        }
        let (wide, inputs) = (widened(x), widened(&plant.inputs));
        let (q, u) = wide.split_at(self.program.q.len());
        let places = self.places.outputs(t, q, u, &inputs).unwrap_or_default();
        let place = |point: usize| match point {
            0 => Some(&[0.0; 3][..]),
            _ => places.get(3 * (point - 1)..3 * point),
        };
        match self.observers.springs.iter().find(|(_, [a, b])| place(*a) == place(*b)) {
            Some((name, _)) => Failure::Wrong(format!(
                "t = {t:.6} s: the spring `{name}` has no length, hence its force no direction; start with its ends apart, \
                 and let nothing bring them together"
            )),
            None => refused(t, fault),
        }
    }

    fn took<S: Scalar>(&mut self, report: Report<S>, t: f64, x: &[S]) {
        self.summary.steps += 1;
        self.summary.pivot = self.summary.pivot.min(report.pivot.to_f64());
        self.summary.health.pivot(None, report.pivot.to_f64());
        for (quantity, value) in self.program.q.iter().zip(x) {
            self.summary.health.place(&quantity.name, value.to_f64(), t);
        }
        self.summary.residual = worst(self.summary.residual, report.residual.to_f64());
    }
}

/// Runs from start to end.
///
/// # Errors
/// [`Failure::Wrong`] with the time, if a step is refused; the sink's own failures.
pub fn simulate<S: EngineScalar>(
    setup: Setup<'_>,
    engine: Box<dyn Engine<S>>,
    sink: impl FnMut(&Row) -> Result<(), Failure>,
) -> Result<Summary, Failure> {
    let mut plant = Plant::new(engine, setup.program, setup.observers);
    let state = setup.program.q.iter().chain(&setup.program.u).map(|quantity| quantity.name.as_str());
    check_numbers::<S>(state.zip(setup.start.iter().copied())).map_err(Failure::Wrong)?;
    let mut x: Vec<S> = setup.start.iter().map(|&x| S::from_f64(x)).collect();
    let mut low = vec![S::ZERO; x.len()];
    let mut recorder = Recorder {
        program: setup.program,
        observers: setup.observers,
        places: Interpreted::new(&setup.observers.places()),
        angles: [setup.program, &setup.observers.laws()].map(Angles::new::<S>),
        sink,
        summary: Summary {
            steps: 0,
            evaluations: 0,
            rows: 0,
            pivot: 1.0,
            residual: 0.0,
            imbalance: 0.0,
            health: Health::new(ranges(setup), S::EPSILON.to_f64()),
            last: Vec::new(),
        },
        columns: columns(setup.program, setup.observers),
        chatter: Chatter::new(setup.observers),
    };
    let ledger = Ledger::open(setup.program, setup.observers, 0.0, &widened(&x))
        .map_err(|fault| Failure::Wrong(format!("t = 0 s: {}", explain(fault))))?;
    let mut state = State::new(&mut x, &mut low).map_err(|f| Failure::Wrong(explain(f).to_owned()))?;
    recorder.row(&mut plant, 0.0, state.x(), &ledger)?;
    // If time determines every coordinate there is nothing to integrate: any method only makes rows.
    let stateless = state.x().is_empty().then_some(Method::Rk4);
    match setup.settings.method.fixed().or(stateless) {
        Some(method) => fixed(setup, method, &mut plant, &mut state, ledger, &mut recorder)?,
        None => adaptive(setup, &mut plant, &mut state, ledger, &mut recorder)?,
    }
    recorder.summary.evaluations = plant.evaluations();
    recorder.summary.health.chatter(recorder.chatter.warning(None));
    Ok(recorder.summary)
}

/// The declared ranges; those of angles that appear only inside sines and cosines count modulo whole turns.
pub(super) fn ranges(setup: Setup<'_>) -> BTreeMap<String, Range> {
    let mut ranges = setup.settings.ranges.clone();
    for angle in setup.program.q.iter().filter(|q| q.is_angle) {
        ranges.entry(angle.name.clone()).and_modify(|range| range.is_angle = true);
    }
    ranges
}

fn widened<S: Scalar>(x: &[S]) -> Vec<f64> {
    x.iter().map(|x| x.to_f64()).collect()
}

/// Ends the run after a complete step if the user interrupts.
pub(super) fn interrupted(t: f64) -> Result<(), Failure> {
    match interrupt::is_asked() {
        true => Err(Failure::Wrong(format!("interrupted at t = {t:.6} s"))),
        false => Ok(()),
    }
}

/// The message for a refused step.
fn refused(t: f64, fault: Fault) -> Failure {
    let hint = match fault {
        Fault::Singular => "; expected a motion that keeps away from singular configurations",
        Fault::NonFinite | Fault::StepSize | Fault::Unsettled => {
            "; try a smaller --step or another --method; `smartbed check` says where a model is singular"
        }
        Fault::Shape | Fault::TooManyContacts | Fault::Jammed | Fault::Unbalanced => "",
    };
    Failure::Wrong(format!("t = {t:.6} s: {}{hint}", explain(fault)))
}

fn fixed<E, S, F>(
    setup: Setup<'_>,
    method: Method,
    plant: &mut Plant<E, S>,
    state: &mut State<'_, S>,
    mut ledger: Ledger,
    recorder: &mut Recorder<'_, F>,
) -> Result<(), Failure>
where
    E: std::ops::DerefMut<Target = dyn Engine<S>>,
    S: EngineScalar,
    F: FnMut(&Row) -> Result<(), Failure>,
{
    let Settings { seconds, step, every, .. } = *setup.settings;
    let steps = setup.settings.intervals(step);
    let mut scratch = vec![S::ZERO; method.scratch(state.x().len())];
    let mut progress = Progress::new("running");
    for n in 1..=steps {
        let t = (n - 1) as f64 * step;
        let is_short = seconds - t < (1.0 - ROUNDING) * step;
        let (h, end) = if is_short { (seconds - t, seconds) } else { (step, n as f64 * step) };
        let mut from = t;
        for cut in 0.. {
            let kink = plant.switches.first(from, end).map_err(|fault| refused(from, fault))?;
            let to = kink.map_or(end, |[before, _]| before);
            let part = if from == t && to == end { h } else { to - from };
            if part > rounding::<S>(to) {
                let report = match state.x().is_empty() {
                    true => Report { pivot: S::ONE, residual: S::ZERO },
                    false => method
                        .step(plant, S::from_f64(from), S::from_f64(part), state, &mut scratch)
                        .map_err(|fault| recorder.refused(plant, from, state.x(), fault))?,
                };
                recorder.took(report, to, state.x());
                ledger.step(to, &widened(state.x())).map_err(|fault| refused(to, fault))?;
                recorder.chatter.observe(to, state.x(), &plant.inputs).map_err(|fault| refused(to, fault))?;
            }
            let Some(kink) = kink else { break };
            if cut == MOST {
                return Err(Failure::Wrong(format!("t = {from:.6} s: {}", too_many())));
            }
            pass(setup.program, plant, kink, state, &mut ledger)?;
            from = kink[1];
        }
        if n % every as u64 == 0 || n == steps {
            recorder.row(plant, end, state.x(), &ledger)?;
        }
        progress.at(n as f64 / steps as f64);
        interrupted(end)?;
    }
    Ok(())
}

fn adaptive<E, S, F>(
    setup: Setup<'_>,
    plant: &mut Plant<E, S>,
    state: &mut State<'_, S>,
    mut ledger: Ledger,
    recorder: &mut Recorder<'_, F>,
) -> Result<(), Failure>
where
    E: std::ops::DerefMut<Target = dyn Engine<S>>,
    S: EngineScalar,
    F: FnMut(&Row) -> Result<(), Failure>,
{
    let Settings { seconds, step, tolerance, .. } = *setup.settings;
    let n = state.x().len();
    let mut memory = vec![S::ZERO; dormand_prince::scratch(n)];
    let tolerance = Tolerance { absolute: S::from_f64(tolerance), relative: S::from_f64(tolerance) };
    let mut method = DormandPrince::new(n, tolerance, S::from_f64(step), &mut memory)
        .map_err(|fault| refused(0.0, fault))?;
    let interval = setup.settings.row_interval();
    let rows = setup.settings.intervals(interval);
    let mut progress = Progress::new("running");
    let (mut t, mut next_row) = (0.0_f64, 1_u64);
    let mut inside = vec![S::ZERO; n];
    let mut dense = |method: &DormandPrince<'_, S>, plant: &mut Plant<E, S>, t: f64, theta: f64| {
        method.dense(S::from_f64(theta), &mut inside)?;
        plant.set_time(S::from_f64(t));
        // The interpolant between two states on the constraints does not satisfy them exactly.
        plant.project(&mut inside)?;
        Ok::<Vec<S>, Fault>(inside.clone())
    };
    let mut next_kink = plant.switches.next(t, seconds, interval).map_err(|f| refused(t, f))?;
    for _ in 0..MOST_STEPS {
        if next_row > rows {
            return Ok(());
        }
        let kink = next_kink;
        let to = kink.map_or(seconds, |[before, _]| before);
        let left = to - t;
        if let Some(kink) = kink.filter(|_| left <= rounding::<S>(to)) {
            pass(setup.program, plant, kink, state, &mut ledger)?;
            method.restart();
            t = kink[1];
            next_kink = plant.switches.next(t, seconds, interval).map_err(|f| refused(t, f))?;
            if seconds - t <= rounding::<S>(seconds) {
                return recorder.row(plant, seconds, state.x(), &ledger);
            }
            continue;
        }
        let taken = method.step(plant, S::from_f64(t), S::from_f64(left), state);
        let taken = taken.map_err(|fault| recorder.refused(plant, t, state.x(), fault))?;
        let h = taken.h.to_f64();
        let end = if h >= left * (1.0 - f64::from(f32::EPSILON)) { to } else { t + h };
        recorder.took(taken.report, end, state.x());
        recorder.chatter.observe(end, state.x(), &plant.inputs).map_err(|fault| refused(end, fault))?;
        // Rows that lie between a kink's moments belong to the side on which time is for what it commands.
        let behind = kink.filter(|_| end == to).map_or(end, |[_, behind]| behind);
        // A step is booked in parts if rows lie inside it.
        let mut from = 0.0;
        while next_row <= rows {
            let at = if next_row == rows { seconds } else { next_row as f64 * interval };
            if at > behind
                || at > end && plant.switches.first(end, at).map_err(|fault| refused(at, fault))?.is_some()
            {
                break;
            }
            let theta = ((at - t) / h).clamp(0.0, 1.0);
            let x = if theta < 1.0 {
                dense(&method, plant, at, theta).map_err(|f| refused(at, f))?
            } else {
                state.x().to_vec()
            };
            book(&mut ledger, (from, theta), at, &x, |th| dense(&method, plant, t + th * h, th))
                .map_err(|f| refused(at, f))?;
            recorder.row(plant, at, &x, &ledger)?;
            (from, next_row) = (theta, next_row + 1);
        }
        if from < 1.0 {
            let x = state.x().to_vec();
            book(&mut ledger, (from, 1.0), end, &x, |th| dense(&method, plant, t + th * h, th))
                .map_err(|f| refused(end, f))?;
        }
        t = end;
        progress.at(t / seconds);
        interrupted(t)?;
    }
    Err(Failure::Wrong(format!(
        "t = {t:.6} s: {MOST_STEPS} steps were not enough; allow a larger --tolerance"
    )))
}

/// Books the part `from..to` (fractions) of a step, which ends at time `t` with `x`.
fn book<S: Scalar>(
    ledger: &mut Ledger,
    (from, to): (f64, f64),
    t: f64,
    x: &[S],
    mut dense: impl FnMut(f64) -> Result<Vec<S>, Fault>,
) -> Result<(), Fault> {
    let mut between = Vec::with_capacity(PARTS - 1);
    for part in 1..PARTS {
        let theta = from + (to - from) * part as f64 / PARTS as f64;
        between.push(widened(&dense(theta)?));
    }
    ledger.step_through(&between, t, &widened(x))
}
