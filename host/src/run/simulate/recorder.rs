//! Rows and the summary of a run.
//!
//! In: states of a plant, with the reports of its steps and the ledger. Out: a [`Row`] for each that is asked for, and
//! at the end a [`Summary`] of all.

use crate::chatter::Chatter;
use crate::columns::of_state;
use crate::engine::{Engine, EngineScalar, explain};
use crate::failure::Failure;
use crate::interrupt;
use crate::limits::Angles;
use crate::number::worst;
use crate::observers::Observers;
use crate::run::health::{Energies, Health, NEARLY_SINGULAR};
use crate::run::ledger::{self, Ledger};
use crate::run::plant::Plant;
use crate::run::settings::Settings;
use smartbed_codegen::{Interpreted, Program};
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::{Ode, Report};
use smartbed_runtime::real::Scalar;

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
    let closed = observers.closed.iter().map(|(name, _)| name);
    names.extend(program.q.iter().map(|q| &q.name).chain(closed).map(|name| of_state("coordinate", name)));
    names.extend(program.speeds.iter().map(|(name, _)| of_state("speed", name)));
    names.extend(ledger::columns(program).into_iter().map(str::to_owned));
    names.extend(observers.outputs.iter().flatten().chain(&observers.inputs).cloned());
    names
}

/// Makes rows, and collects the summary.
pub(super) struct Recorder<'a, F> {
    pub(super) program: &'a Program,
    pub(super) observers: &'a Observers,
    pub(super) places: Interpreted<f64>,
    /// Of the equations and of the laws.
    pub(super) angles: [Angles; 2],
    pub(super) sink: F,
    pub(super) summary: Summary,
    pub(super) columns: Vec<String>,
    pub(super) chatter: Chatter,
}

impl<F: FnMut(&Row) -> Result<(), Failure>> Recorder<'_, F> {
    pub(super) fn row<E, S>(
        &mut self,
        plant: &mut Plant<E, S>,
        t: f64,
        x: &[S],
        ledger: &Ledger,
    ) -> Result<(), Failure>
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
    pub(super) fn refused<E, S>(&mut self, plant: &mut Plant<E, S>, t: f64, x: &[S], fault: Fault) -> Failure
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

    pub(super) fn took<S: Scalar>(&mut self, report: Report<S>, t: f64, x: &[S]) {
        self.summary.steps += 1;
        self.summary.pivot = self.summary.pivot.min(report.pivot.to_f64());
        self.summary.health.pivot(None, report.pivot.to_f64());
        for (quantity, value) in self.program.q.iter().zip(x) {
            self.summary.health.place(&quantity.name, value.to_f64(), t);
        }
        self.summary.residual = worst(self.summary.residual, report.residual.to_f64());
    }
}

pub(super) fn widened<S: Scalar>(x: &[S]) -> Vec<f64> {
    x.iter().map(|x| x.to_f64()).collect()
}

/// Ends the run after a complete step if the user interrupts.
pub(crate) fn interrupted(t: f64) -> Result<(), Failure> {
    match interrupt::is_asked() {
        true => Err(Failure::Wrong(format!("interrupted at t = {t:.6} s"))),
        false => Ok(()),
    }
}

/// The message for a refused step.
pub(super) fn refused(t: f64, fault: Fault) -> Failure {
    let hint = match fault {
        Fault::Singular => "; expected a motion that keeps away from singular configurations",
        Fault::NonFinite | Fault::StepSize | Fault::Unsettled => {
            "; try a smaller --step or another --method; `smartbed check` says where a model is singular"
        }
        Fault::Shape | Fault::TooManyContacts | Fault::Jammed | Fault::Unbalanced => "",
    };
    Failure::Wrong(format!("t = {t:.6} s: {}{hint}", explain(fault)))
}
