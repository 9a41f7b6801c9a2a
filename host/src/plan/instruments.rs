//! `[instruments]`: the tiles' own instruments, and their readings of a run.

use crate::world::read::value::{Bound, count, number};
use smartbed_bed::plan::Plan;
use smartbed_bed::plan::history::History;
use smartbed_bed::plan::readings::{Reading, readings};
use smartbed_bed::sensor::drive::{Instruments, TICKS};
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::Fields;
use smartbed_codegen::model::document::Table;

/// Most samples of a pressure in transmission at the same time.
const ON_THEIR_WAY: u32 = 3;

/// Longest time (s) before a moment for which a pressure sensor is simulated.
const LONGEST: f64 = 60.0;

/// Instruments of all tiles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Instrumented {
    /// Instruments of each tile.
    pub instruments: Instruments,
    /// Seed of all noise.
    pub seed: u64,
}

/// Reads `[instruments]`.
pub(super) fn read(table: &Table, found: &mut Diagnostics) -> Option<Instrumented> {
    let fields = Fields::of("instruments", table.span, table);
    let usual = Instruments::default();
    let seed = count(&fields, "seed", 0, found).map_or(1, |seed| seed as u64);
    let mut get = |key: &'static str, of: &str, bound: Bound, left_out: f64| {
        number(&fields, key, of, bound, found).unwrap_or(left_out)
    };
    let ticks = |seconds: f64| (seconds * TICKS).round().clamp(0.0, 1e9) as u32;
    let mut instruments = Instruments {
        encoder: get("encoder", "m", Bound::Positive, usual.encoder),
        lvdt_noise: [get("lvdt_noise", "m", Bound::NotNegative, usual.lvdt_noise[0]), usual.lvdt_noise[1]],
        lag: get("lag", "s", Bound::NotNegative, usual.lag),
        ..usual
    };
    let channel = &mut instruments.pressure;
    channel.period = ticks(get("period", "s", Bound::Positive, f64::from(channel.period) / TICKS)).max(1);
    channel.delay = ticks(get("delay", "s", Bound::NotNegative, f64::from(channel.delay) / TICKS));
    channel.noise = get("noise", "Pa", Bound::NotNegative, channel.noise);
    channel.bias = get("bias", "Pa", Bound::NotNegative, channel.bias);
    channel.resolution = get("resolution", "Pa", Bound::NotNegative, channel.resolution);
    let is_late = channel.delay > ON_THEIR_WAY.saturating_mul(channel.period);
    fields.finish(found);
    let memory = instruments.memory() as f64 / TICKS;
    if memory > LONGEST {
        let error = Diagnostic::error(format!(
            "readings depend on the pressure of the last {memory} s, expected {LONGEST} s at most"
        ));
        let place = "20 times `lag`, `delay` and `period` together";
        found.push(error.label(table.span, place).help("a shorter `lag`, `delay` or `period`"));
        return None;
    }
    if is_late {
        let error = Diagnostic::error(format!("`delay` is longer than {ON_THEIR_WAY} times `period`"));
        found.push(
            error.label(table.span, "of these instruments").help("a shorter `delay`, or a longer `period`"),
        );
        return None;
    }
    Some(Instrumented { instruments, seed })
}

impl Instrumented {
    /// Their readings of a run; empty if a sensor is invalid, which has been reported when it was read.
    #[must_use]
    pub fn of(&self, plan: &Plan, history: &History) -> Vec<Reading> {
        readings(plan, history, self.instruments, self.seed).unwrap_or_default()
    }
}
