//! Controllers of a world: at their own period they read a value, compare it with a target and hold an output until the
//! next sample.
//!
//! In: the scene's description of each, the rows' columns, the sensors' readings. Out: values of an engine's inputs.
//! ```text
//! e = target(t) - reading,   I += integral * period * e  (not further than to where the output is at a limit)
//! output = bias + gain * e + I, within the limits
//! ```
//! They act through inputs alone: valves of gas, and inputs of mechanisms for which the model has no law.

use super::assembly::{Assembly, Controlling, Transducer};
use super::engine::{Column, Engine};
use super::sensors::{agree, known, unread, whole_steps};
use crate::failure::Failure;
use smartbed_codegen::diagnostic::Diagnostic;

/// The value that a controller reads.
#[derive(Clone, Copy, Debug)]
enum Source {
    Column(usize),
    Sensor(usize),
}

/// The state of a controller.
#[derive(Clone, Debug)]
struct Controller {
    own: Controlling,
    source: Source,
    input: usize,
    /// Number of steps between samples.
    period: u64,
    integral: f64,
    /// Its output until the next sample.
    held: f64,
}

/// The controllers of a world.
#[derive(Clone, Debug)]
pub struct Controllers {
    list: Vec<Controller>,
    step: f64,
}

impl Controllers {
    /// For an assembly whose rows have these columns and whose engine takes these inputs.
    ///
    /// # Errors
    /// The error with its place if a controller reads no existing value or drives no existing input, two drive the same
    /// input, or a period is not a whole number of steps.
    pub fn new(assembly: &Assembly, columns: &[Column], inputs: &[String]) -> Result<Self, Failure> {
        let mut list: Vec<Controller> = Vec::new();
        for own in &assembly.controllers {
            let name = &own.name;
            let place = |of: &str, key: &str| assembly.places.key(&["controllers", of, key]);
            let at = |key: &str, label: &str, error: Diagnostic| {
                assembly.places.failure(error.label(place(name, key), label))
            };
            let source = source(own, assembly, columns)
                .map_err(|error| at("reads", "neither a column of a part nor a sensor", error))?;
            agree(&format!("controllers.{name}"), own.unit, &own.reads, unit(source, assembly, columns))
                .map_err(|error| at("unit", "of another dimension", error))?;
            let input = inputs.iter().position(|input| *input == own.drives).ok_or_else(|| {
                let help = match inputs.is_empty() {
                    true => {
                        "give gas lines (supply, vent), or a mechanism an input that no law gives".to_owned()
                    }
                    false => known(&own.drives, inputs.iter().map(String::as_str)),
                };
                let message = format!("controllers.{name}: `{}` is no valve and no free input", own.drives);
                at("drives", "cannot be driven", Diagnostic::error(message).help(help))
            })?;
            let both = |other: &&Controller| {
                let [one, two] = [&other.own.drives, &own.drives];
                let valves =
                    |a: &str, b: &str| a.strip_suffix("valves").is_some_and(|part| b.starts_with(part));
                one == two || valves(one, two) || valves(two, one)
            };
            if let Some(Controller { own: first, .. }) = list.iter().find(both) {
                let error = Diagnostic::error(format!(
                    "controllers.{name}: `{}` is driven by controllers.{} already",
                    own.drives, first.name
                ));
                let error = error.label(place(name, "drives"), "driven here, too");
                let error = error.label(place(&first.name, "drives"), "first driven here");
                return Err(assembly.places.failure(error.help("leave it to one of them")));
            }
            if let Some((part, line)) = assembly.opened(&own.drives) {
                let error = Diagnostic::error(format!(
                    "controllers.{name}: it drives `{}`, so that `opening` has no effect",
                    own.drives
                ));
                let opened = assembly.places.key(&["parts", part, "gas", line, "opening"]);
                let error = error.label(opened, "replaced by the controller's output from the start on");
                return Err(assembly
                    .places
                    .failure(error.help("leave `opening` out; `bias` is the output at target")));
            }
            let period = whole_steps(&format!("controllers.{name}"), "period", own.period, assembly.run.step)
                .map_err(|error| at("period", "between two steps", error))?;
            list.push(Controller {
                own: own.clone(),
                source,
                input,
                period: u64::from(period.max(1)),
                integral: 0.0,
                held: 0.0,
            });
        }
        Ok(Self { list, step: assembly.run.step })
    }

    /// Are there none?
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The state of all controllers, for a checkpoint.
    #[must_use]
    pub fn save(&self) -> Vec<f64> {
        self.list.iter().flat_map(|own| [own.integral, own.held]).collect()
    }

    /// Restores the state of [`Controllers::save`] and holds their outputs; `None` if numbers are missing.
    pub fn load(&mut self, numbers: &mut impl Iterator<Item = f64>, engine: &mut dyn Engine) -> Option<()> {
        self.list.iter_mut().try_for_each(|own| {
            (own.integral, own.held) = (numbers.next()?, numbers.next()?);
            engine.set_input(own.input, own.held);
            Some(())
        })
    }

    /// After step `tick`: controllers whose sampling time it is set their outputs in the engine.
    ///
    /// # Errors
    /// If a reading is not finite.
    pub fn act(
        &mut self,
        tick: u64,
        state: &[f64],
        readings: &[f64],
        engine: &mut dyn Engine,
    ) -> Result<(), String> {
        for controller in self.list.iter_mut().filter(|own| tick.is_multiple_of(own.period)) {
            let reading = match controller.source {
                Source::Column(column) => state[column],
                Source::Sensor(sensor) => readings[sensor],
            };
            if !reading.is_finite() {
                return Err(format!("controllers.{}: it reads no number", controller.own.name));
            }
            controller.held = controller.output(tick as f64 * self.step, reading, self.step);
            engine.set_input(controller.input, controller.held);
        }
        Ok(())
    }
}

impl Controller {
    /// The output for a reading at a time (s).
    fn output(&mut self, t: f64, reading: f64, step: f64) -> f64 {
        let Controlling { gain, integral, bias, limits: [low, high], .. } = self.own;
        let error = self.own.target_at(t) - reading;
        let added = integral * self.period as f64 * step * error;
        let output = |sum: f64| bias + gain * error + sum;
        // Up to the limit, and no further: what would be beyond is not wound up.
        let kept = output(self.integral);
        self.integral += match added > 0.0 {
            true => added.min((high - kept).max(0.0)),
            false => added.max((low - kept).min(0.0)),
        };
        output(self.integral).clamp(low, high)
    }
}

/// The unit of what it reads; a switch reads 0 or 1.
fn unit<'c>(source: Source, assembly: &Assembly, columns: &'c [Column]) -> &'c str {
    let column = match source {
        Source::Column(column) => Some(&columns[column]),
        Source::Sensor(sensor) => {
            let sensor = &assembly.sensors[sensor];
            let is_switch = matches!(sensor.transducer, Transducer::Switch { .. });
            columns.iter().find(|column| !is_switch && column.name == sensor.of)
        }
    };
    column.map_or("", |column| column.unit.as_str())
}

/// The source of its reading: a value of the rows, or a sensor; else an error without a place.
fn source(own: &Controlling, assembly: &Assembly, columns: &[Column]) -> Result<Source, Diagnostic> {
    let sensor = own.reads.strip_prefix("sensors.");
    let place = match sensor {
        Some(name) => assembly.sensors.iter().position(|sensor| sensor.name == name).map(Source::Sensor),
        None => columns.iter().position(|column| column.name == own.reads).map(Source::Column),
    };
    place.ok_or_else(|| {
        let sensors: Vec<String> =
            assembly.sensors.iter().map(|sensor| format!("sensors.{}", sensor.name)).collect();
        let names =
            columns.iter().map(|column| column.name.as_str()).chain(sensors.iter().map(String::as_str));
        let help = unread(&own.reads).unwrap_or_else(|| known(&own.reads, names));
        let message =
            format!("controllers.{}: no number `{}` in the rows or of a sensor", own.name, own.reads);
        Diagnostic::error(message).help(help)
    })
}
