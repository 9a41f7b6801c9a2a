//! Sensors of a world: readings of numbers of its rows, coarse, late and noisy; they observe and change nothing.
//!
//! In: what a scene says of each, the rows' columns. Out: readings step by step. A tick is a step of the run: the noise
//! of a sample belongs to its number, so that the same seed gives the same readings.

use super::assembly::{Assembly, Sensing, Transducer};
use super::engine::Column;
use smartbed_runtime::sensor::kinds::{Lvdt, Membrane, Switch};
use smartbed_runtime::sensor::{Channel, Sensor};

/// Samples on their way at most.
const DEPTH: usize = 16;
/// A period may miss a whole number of steps by this share of one.
const WHOLE: f64 = 1e-6;

/// A transducer at work.
#[derive(Clone, Debug)]
enum Kind {
    Plain,
    Lvdt(Lvdt<f64>),
    Pressure(Membrane<f64>),
    Switch(Switch<f64>),
}

/// A sensor at work.
#[derive(Clone, Debug)]
struct Probe {
    column: usize,
    kind: Kind,
    sensor: Sensor<f64, DEPTH>,
}

/// All of them.
#[derive(Clone, Debug)]
pub struct Probes {
    list: Vec<Probe>,
}

/// A time as a whole number of steps (s).
///
/// # Errors
/// It is none, in words.
pub(super) fn whole_steps(of: &str, what: &str, seconds: f64, step: f64) -> Result<u32, String> {
    let ticks = seconds / step;
    let whole = (ticks - ticks.round()).abs() < WHOLE && ticks.round() <= f64::from(u32::MAX);
    whole
        .then_some(ticks.round() as u32)
        .ok_or_else(|| format!("{of}: {what} = {seconds} s is no whole number of steps of {step} s"))
}

impl Probes {
    /// For an assembly whose rows have these columns.
    ///
    /// # Errors
    /// What a sensor reads is no column, or its times are no whole numbers of steps.
    pub fn new(assembly: &Assembly, columns: &[Column]) -> Result<Self, String> {
        let probe = |own: &Sensing| {
            let names = columns.iter().map(|c| c.name.as_str());
            let column = columns.iter().position(|c| c.name == own.of).ok_or_else(|| {
                let help = crate::suggest::help(&own.of, names);
                format!("sensors.{}: no number `{}` in the rows{help}", own.name, own.of)
            })?;
            let name = format!("sensors.{}", own.name);
            let ticks = |what: &str, seconds: f64| whole_steps(&name, what, seconds, assembly.run.step);
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
                let help = "period >= one step, delay <= 15 periods, noise, bias and resolution >= 0, range not empty";
                format!("sensors.{}: {fault:?}; expected {help}", own.name)
            })?;
            Ok(Probe { column, kind, sensor })
        };
        Ok(Probes { list: assembly.sensors.iter().map(probe).collect::<Result<_, String>>()? })
    }

    /// Are there none?
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Shows them the state behind a step.
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

    /// What they show.
    pub fn readings(&mut self, tick: u64) -> Vec<f64> {
        self.list.iter_mut().map(|probe| probe.sensor.reading(tick)).collect()
    }
}
