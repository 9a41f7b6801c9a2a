//! Settings of a run: the model's `[start]` and `[run]`, changed by the command line.

use super::arguments::Arguments;
use super::health::Range;
use crate::failure::Failure;
use crate::number::{fewest_digits, six_digits};
use crate::{model_argument, suggest};
use clap::ValueEnum;
use smartbed_codegen::ParameterChoice;
use smartbed_codegen::model::{Model, StartRef};
use smartbed_runtime::ode::Method as FixedMethod;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// Most steps of a run.
const MOST_STEPS: f64 = 1e9;
/// Default tolerance of the adaptive method.
const TOLERANCE: f64 = 1e-9;

/// Integration methods by the names of the command line and of models.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum Method {
    /// Explicit Euler, order 1.
    Euler,
    /// Semi-implicit Euler, order 1, energy bounded.
    SemiImplicit,
    /// Kutta's classical method, order 4.
    Rk4,
    /// Dormand and Prince 5(4), adaptive.
    DormandPrince,
}

impl Method {
    /// The method of fixed step; `None` for the adaptive one.
    #[must_use]
    pub fn fixed(self) -> Option<FixedMethod> {
        match self {
            Self::Euler => Some(FixedMethod::ExplicitEuler),
            Self::SemiImplicit => Some(FixedMethod::SemiImplicitEuler),
            Self::Rk4 => Some(FixedMethod::Rk4),
            Self::DormandPrince => None,
        }
    }

    /// Its name.
    #[must_use]
    pub fn name(self) -> String {
        self.to_possible_value().map_or(String::new(), |v| v.get_name().to_owned())
    }
}

/// Numbers of a run.
#[derive(Clone, Debug)]
pub struct Settings {
    /// Simulated time (s).
    pub seconds: f64,
    /// Step (s); the first one of the adaptive method.
    pub step: f64,
    /// Time (s) within which a function of time switches there and back at most once: the step, or the model's own
    /// where that is shorter.
    pub look: f64,
    /// Integration method.
    pub method: Method,
    /// A row is written after every this many steps of `step`.
    pub every: usize,
    /// Error per step of the adaptive method, absolute and relative.
    pub tolerance: f64,
    /// Start values by name: coordinates and independent speeds.
    pub start: BTreeMap<String, f64>,
    /// Changed parameters.
    pub choice: ParameterChoice,
    /// Ranges that the model declares, by coordinate.
    pub ranges: BTreeMap<String, Range>,
}

impl Settings {
    /// The model's settings with those of the command line, and the model with the parameters that `--set` changes.
    ///
    /// # Errors
    /// [`Failure::Wrong`] for a number out of range or an unknown name; [`Failure::Found`] for what follows from a
    /// parameter and has no value then.
    pub fn new<'m>(model: &'m Model, arguments: &Arguments) -> Result<(Cow<'m, Model>, Self), Failure> {
        let (choice, starts) = changes(model, &arguments.set)?;
        let model = choice.applied(model).map_err(|found| model_argument::wrong(&found))?;
        let step = arguments.step.unwrap_or(model.run.step);
        let mut settings = Self {
            seconds: arguments.seconds.unwrap_or(model.run.seconds),
            step,
            look: step.min(model.run.step),
            method: method(&model, arguments)?,
            every: arguments.every.unwrap_or(model.run.every),
            tolerance: arguments.tolerance.unwrap_or(TOLERANCE),
            start: BTreeMap::new(),
            choice,
            ranges: ranges(&model),
        };
        settings.check(arguments.tolerance)?;
        for (owner, value) in &model.start {
            let name = match owner {
                StartRef::Coordinate(id) => &model.coordinates[*id].name,
                StartRef::Speed(id) => &model.speeds[*id].name,
            };
            starts_at(&model, name)?;
            settings.start.insert(name.clone(), *value);
        }
        settings.start.extend(starts);
        Ok((model, settings))
    }
    fn check(&self, tolerance: Option<f64>) -> Result<(), Failure> {
        let wrong = |message: String| Err(Failure::Wrong(message));
        let positive = |x: f64| x > 0.0 && x.is_finite();
        if !(self.seconds >= 0.0 && self.seconds.is_finite()) {
            return wrong(format!("--seconds {}: expected a time of 0 or more", fewest_digits(self.seconds)));
        }
        if !positive(self.step) {
            return wrong(format!(
                "--step {}: expected a time above 0, for example 1e-3",
                fewest_digits(self.step)
            ));
        }
        if self.seconds / self.step > MOST_STEPS {
            return wrong(format!(
                "{} s in steps of {} s are more than {MOST_STEPS:e} steps; take a larger --step",
                fewest_digits(self.seconds),
                fewest_digits(self.step)
            ));
        }
        if self.every == 0 {
            return wrong("--every 0: expected a number of steps of 1 or more".to_owned());
        }
        let fixed = self.method.fixed().is_some();
        if let Some(tolerance) = tolerance.filter(|_| fixed) {
            let name = self.method.name();
            return wrong(format!(
                "--tolerance {tolerance:e}: {name} takes fixed steps; expected --step, or --method dormand-prince"
            ));
        }
        if !positive(self.tolerance) {
            return wrong(format!(
                "--tolerance {}: expected a number above 0, for example 1e-9",
                fewest_digits(self.tolerance)
            ));
        }
        Ok(())
    }

    /// Method and step in words.
    #[must_use]
    pub fn note(&self) -> String {
        match self.method.fixed() {
            Some(_) => format!("{}, step {} s", self.method.name(), fewest_digits(six_digits(self.step))),
            None => format!("{}, tolerance {:e}", self.method.name(), self.tolerance),
        }
    }

    /// Number of intervals of this length in the run, the last one perhaps shorter. A remainder below a thousandth of
    /// one is rounding, but there is at least one interval.
    #[must_use]
    pub fn intervals(&self, length: f64) -> u64 {
        const ROUNDING: f64 = 1e-3;
        let whole = (self.seconds / length - ROUNDING).ceil().max(0.0) as u64;
        if self.seconds > 0.0 { whole.max(1) } else { 0 }
    }

    /// Time between rows (s).
    #[must_use]
    pub fn row_interval(&self) -> f64 {
        self.step * self.every as f64
    }
}

/// What `--set` changes: parameters, and start values by name.
fn changes(model: &Model, set: &[String]) -> Result<(ParameterChoice, BTreeMap<String, f64>), Failure> {
    let (mut choice, mut starts) = (ParameterChoice::default(), BTreeMap::new());
    for change in set {
        let (name, value) = model_argument::assignment("--set", change)?;
        if choice.values.contains_key(&name) || starts.contains_key(&name) {
            return Err(Failure::Wrong(format!(
                "--set {change}: `{name}` is set twice; leave one of them out"
            )));
        }
        if let Some(message) = model.refuses(&name, value) {
            return Err(Failure::Wrong(format!("--set {change}: {message}")));
        }
        let is_parameter = model.parameters.iter().any(|p| p.name == name);
        if !is_parameter {
            starts_at(model, &name)?;
        }
        let list = if is_parameter { &mut choice.values } else { &mut starts };
        list.insert(name, value);
    }
    Ok((choice, starts))
}

/// Checks that a motion starts at a value of this name.
fn starts_at(model: &Model, name: &str) -> Result<(), Failure> {
    let coordinates = model.coordinates.iter().filter(|c| c.closed_form.is_none()).map(|c| &c.name);
    // Dependent ones too: if the independent ones have a dead point, all are state.
    let speeds = model.speeds.iter().map(|s| &s.name);
    let mut starts = coordinates.chain(speeds).map(String::as_str);
    if starts.clone().any(|s| s == name) {
        return Ok(());
    }
    let known = model.parameters.iter().map(|p| p.name.as_str()).chain(&mut starts);
    let help = suggest::help(name, known);
    Err(Failure::Wrong(format!("`{}` has no parameter or start value `{name}`{help}", model.name)))
}

pub(super) fn ranges(model: &Model) -> BTreeMap<String, Range> {
    let declared = model.coordinates.iter().filter(|c| c.written[1].is_some());
    declared
        .map(|c| (c.name.clone(), Range { ends: c.range, unit: c.written_unit.clone(), is_angle: false }))
        .collect()
}

/// The method of the command line; else the adaptive one if a tolerance is given; else the model's.
fn method(model: &Model, arguments: &Arguments) -> Result<Method, Failure> {
    let (place, name) = match (&arguments.method, arguments.tolerance) {
        (Some(name), _) => ("--method", name),
        (None, Some(_)) => return Ok(Method::DormandPrince),
        (None, None) => ("[run] method", &model.run.method),
    };
    // Scenes spell their methods with `_`.
    Method::from_str(&name.replace('_', "-"), false).map_err(|_| {
        let names: Vec<String> = Method::value_variants().iter().map(|m| m.name()).collect();
        let help = suggest::help(name, names.iter().map(String::as_str));
        Failure::Wrong(format!("{place}: there is no method `{name}`{help}"))
    })
}
