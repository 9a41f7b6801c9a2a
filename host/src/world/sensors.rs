//! Sensors of a world: readings of its columns with resolution, delay and noise; they do not influence the motion.
//!
//! In: the scene's description of each, the rows' columns. Out: readings step by step. A tick is a step of the run. The
//! noise of a sample depends on its number and the seed alone, so that the same seed gives the same readings.

use super::assembly::{Assembly, Sensing, Transducer};
use super::engine::{ACCOUNTS, Column};
use crate::failure::Failure;
use crate::number::six_digits;
use smartbed_codegen::diagnostic::Diagnostic;
use smartbed_codegen::model::unit::{self, Unit};
use smartbed_runtime::sensor::kinds::{Lvdt, Membrane, Switch};
use smartbed_runtime::sensor::{Channel, ChannelFault, Remembered, Sensor};

/// Most samples in transit.
const DEPTH: usize = 16;
/// Tolerance for a period that is not a whole number of steps, as a share of a step.
const WHOLE: f64 = 1e-6;

/// The state of a transducer.
#[derive(Clone, Copy, Debug)]
enum Kind {
    Plain,
    Lvdt(Lvdt<f64>),
    Pressure(Membrane<f64>),
    Switch(Switch<f64>),
}

/// The state of a sensor.
#[derive(Clone, Debug)]
struct Probe {
    column: usize,
    kind: Kind,
    sensor: Sensor<f64, DEPTH>,
}

/// The sensors of a world.
#[derive(Clone, Debug)]
pub struct Probes {
    list: Vec<Probe>,
}

/// A time (s) as a whole number of steps.
///
/// # Errors
/// An error without a place if it is not one.
pub(super) fn whole_steps(of: &str, what: &str, seconds: f64, step: f64) -> Result<u32, Diagnostic> {
    let ticks = seconds / step;
    let whole = (ticks - ticks.round()).abs() < WHOLE && ticks.round() <= f64::from(u32::MAX);
    whole.then_some(ticks.round() as u32).ok_or_else(|| {
        let message = format!("{of}: {what} = {seconds} s is no whole number of steps of {step} s");
        let near = six_digits(ticks.round().clamp(1.0, f64::from(u32::MAX)) * step);
        Diagnostic::error(message)
            .help(format!("take {near} s or another multiple of run.step, or another step"))
    })
}

/// The help for an unknown name: the most similar one, or all.
pub(super) fn known<'n>(name: &str, names: impl IntoIterator<Item = &'n str>) -> String {
    crate::suggest::help(name, names).trim_start_matches("; ").to_owned()
}

/// The help for a column that stands in the rows but is no state of a part; `None` for any other name.
pub(super) fn unread(name: &str) -> Option<String> {
    let is_told = name == "t" || ACCOUNTS.contains(&name);
    is_told.then(|| {
        "times and energies are written, not sensed; read a number of a part: PART.x or another".to_owned()
    })
}

/// Checks the dimension of the `unit` that a sensor or controller names against the unit of the value `read`.
///
/// # Errors
/// An error without a place with both units, if they are of different dimensions.
pub(super) fn agree(of: &str, own: Option<Unit>, read: &str, unit: &str) -> Result<(), Diagnostic> {
    // A column's unit that cannot be read says nothing against any other.
    let (Some(own), Ok(column)) = (own, unit::parse(unit.trim())) else { return Ok(()) };
    if own == column.unit {
        return Ok(());
    }
    let (is, wanted) = match column.unit == Unit::NONE {
        true => ("without unit".to_owned(), "leave `unit` out".to_owned()),
        false => (format!("in {unit}"), format!("expected unit = \"{unit}\" or another of this dimension")),
    };
    let message = format!("{of}: `unit` is that of a number in {own}, but `{read}` is {is}");
    Err(Diagnostic::error(message).help(wanted))
}

/// The key of a channel that is refused, and the error.
fn refused(of: &str, fault: ChannelFault, channel: &Channel<f64>) -> (&'static str, Diagnostic) {
    let (key, message, help) = match fault {
        ChannelFault::NoPeriod => {
            ("period", "`period` is shorter than a step".to_owned(), "take a step or more".to_owned())
        }
        ChannelFault::TooLate => (
            "delay",
            format!("`delay` is {} steps, `period` {}", channel.delay, channel.period),
            format!("take a delay of at most {} periods: samples wait in so many places", DEPTH - 1),
        ),
        ChannelFault::OutOfRange => (
            "",
            "a number of it is out of range".to_owned(),
            "`noise`, `bias` and `resolution` are >= 0 and finite, `drift` is finite, the first number of `range` is not \
             above its second"
                .to_owned(),
        ),
    };
    (key, Diagnostic::error(format!("{of}: {message}")).help(help))
}

impl Probes {
    /// For an assembly whose rows have these columns.
    ///
    /// # Errors
    /// The error with its place if a sensor reads a column that does not exist, or its times are not whole numbers of
    /// steps.
    pub fn new(assembly: &Assembly, columns: &[Column]) -> Result<Self, Failure> {
        let probe = |own: &Sensing| {
            let at = |key: &str, label: &str, error: Diagnostic| {
                let place = assembly.places.key(&["sensors", &own.name, key]);
                assembly.places.failure(error.label(place, label))
            };
            let name = format!("sensors.{}", own.name);
            let column = columns.iter().position(|c| c.name == own.of).ok_or_else(|| {
                let error = Diagnostic::error(format!("{name}: no number `{}` in the rows", own.of));
                let names = columns.iter().map(|c| c.name.as_str());
                at(
                    "of",
                    "no column of a part",
                    error.help(unread(&own.of).unwrap_or_else(|| known(&own.of, names))),
                )
            })?;
            agree(&name, own.unit, &own.of, &columns[column].unit)
                .map_err(|error| at("unit", "of another dimension", error))?;
            let ticks = |what: &str, seconds: f64| {
                let whole = whole_steps(&name, what, seconds, assembly.run.step);
                whole.map_err(|error| at(what, "between two steps", error))
            };
            let channel = Channel {
                period: ticks("period", own.period.unwrap_or(assembly.run.step))?,
                delay: ticks("delay", own.delay)?,
                noise: own.noise,
                bias: own.bias,
                drift: own.drift,
                resolution: own.resolution,
                range: own.range,
            };
            let kind = match own.transducer {
                Transducer::Plain => Kind::Plain,
                Transducer::Lvdt { reach, linearity } => Kind::Lvdt(Lvdt { reach, linearity }),
                Transducer::Pressure { lag } => Kind::Pressure(Membrane::new(lag / assembly.run.step)),
                Transducer::Switch { closes, hysteresis, chatter } => {
                    Kind::Switch(Switch::new(closes, hysteresis, ticks("chatter", chatter)?, own.seed))
                }
            };
            let sensor = Sensor::new(channel, own.seed, 0.0).map_err(|fault| {
                let (key, error) = refused(&name, fault, &channel);
                at(key, "refused", error)
            })?;
            // Else controllers would act on a number that nobody measured.
            Ok(Probe { column, kind, sensor: sensor.showing_first() })
        };
        Ok(Probes { list: assembly.sensors.iter().map(probe).collect::<Result<_, Failure>>()? })
    }

    /// Are there none?
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Updates them with the state after a step.
    pub fn observe(&mut self, tick: u64, state: &[f64]) {
        for probe in &mut self.list {
            let quantity = state[probe.column];
            let seen = match &mut probe.kind {
                Kind::Plain => quantity,
                Kind::Lvdt(lvdt) => lvdt.report(quantity),
                Kind::Pressure(membrane) => membrane.observe(tick, quantity),
                Kind::Switch(switch) => f64::from(u8::from(switch.observe(tick, quantity))),
            };
            probe.sensor.observe(tick, seen);
        }
    }

    /// The state of all sensors, for a checkpoint.
    #[must_use]
    pub fn save(&self) -> Vec<f64> {
        self.list.iter().flat_map(Probe::save).collect()
    }

    /// Restores the state of [`Probes::save`]; `None` if numbers are missing.
    pub fn load(&mut self, numbers: &mut impl Iterator<Item = f64>) -> Option<()> {
        self.list.iter_mut().try_for_each(|probe| probe.load(numbers))
    }

    /// The readings after a step.
    pub fn readings(&mut self, tick: u64) -> Vec<f64> {
        self.list.iter_mut().map(|probe| probe.sensor.reading(tick)).collect()
    }
}

/// A tick as a number, with a special value for `None`.
fn tick_number(tick: Option<u64>) -> f64 {
    tick.map_or(-1.0, |tick| tick as f64)
}

fn tick(number: f64) -> Option<u64> {
    (number >= 0.0).then_some(number as u64)
}

impl Probe {
    fn save(&self) -> Vec<f64> {
        let memory = self.sensor.memory();
        let felt = match self.kind {
            Kind::Switch(switch) => [tick_number(switch.changed), f64::from(u8::from(switch.closed)), 0.0],
            Kind::Pressure(Membrane { follows: Some((at, [pressure, felt])), .. }) => {
                [tick_number(Some(at)), felt, pressure]
            }
            _ => [tick_number(None), 0.0, 0.0],
        };
        let pending = memory.pending.iter().flat_map(|sample| match sample {
            Some((at, reading)) => [tick_number(Some(*at)), *reading],
            None => [tick_number(None), 0.0],
        });
        [memory.drifted, tick_number(memory.last), memory.shown]
            .into_iter()
            .chain(felt)
            .chain(pending)
            .collect()
    }

    fn load(&mut self, numbers: &mut impl Iterator<Item = f64>) -> Option<()> {
        let [drifted, last, shown, at, felt, pressure] = [(); 6].map(|()| numbers.next());
        let (at, felt, pressure) = (tick(at?), felt?, pressure?);
        match &mut self.kind {
            Kind::Switch(switch) => (switch.changed, switch.closed) = (at, felt != 0.0),
            Kind::Pressure(membrane) => membrane.follows = at.map(|at| (at, [pressure, felt])),
            Kind::Plain | Kind::Lvdt(_) => {}
        }
        let mut pending = [None; DEPTH];
        for sample in &mut pending {
            let (at, reading) = (tick(numbers.next()?), numbers.next()?);
            *sample = at.map(|at| (at, reading));
        }
        self.sensor.resume(Remembered { drifted: drifted?, last: tick(last?), pending, shown: shown? });
        Some(())
    }
}
