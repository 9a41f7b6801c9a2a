//! Readings of the instruments of all tiles during a run.
//!
//! In: a run, the instruments of a tile, a seed. Out: readings at each moment, with delay, hold and noise. Screws are
//! assumed to stand at their orders, and regulated air to have its pressure; that of sealed air is interpolated linearly
//! between moments. Instruments are simulated for the last quarter of a second before each moment, a pressure sensor
//! for as long as it remembers.

use super::Plan;
use super::history::History;
use crate::sensor::drive::{Instruments, Readings, TICKS, TileSensors};
use crate::tile;
use smartbed_runtime::sensor::ChannelFault;

/// Number of ticks before a moment for which all instruments are simulated.
const WATCHED: u64 = 250;

/// A reading and the true values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Time (s).
    pub time: f64,
    /// Index of the tile, from 0.
    pub tile: usize,
    /// Readings of the instruments.
    pub read: Readings,
    /// True heights of the screws (m).
    pub heights: [f64; 3],
    /// True gauge pressure (Pa).
    pub gauge: f64,
}

/// Largest errors over all readings.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Errors {
    /// Of encoders (m).
    pub encoder: f64,
    /// Of LVDTs (m).
    pub lvdt: f64,
    /// Of pressures (Pa).
    pub pressure: f64,
    /// Number of readings in which encoder and LVDT disagree.
    pub disagree: usize,
}

/// Readings of all tiles at each moment of a run.
///
/// # Errors
/// [`ChannelFault`] for a pressure sensor that cannot be.
pub fn readings(
    plan: &Plan,
    history: &History,
    instruments: Instruments,
    seed: u64,
) -> Result<Vec<Reading>, ChannelFault> {
    let told = Plan { moves: history.moves.clone(), ..plan.clone() };
    let mut found = Vec::new();
    for tile in 0..plan.layout.count() {
        let gauge = history.moments.first().map_or(0.0, |moment| moment.gauges[tile]);
        let own = seed.wrapping_mul(64).wrapping_add(tile as u64);
        let mut sensors = TileSensors::new(instruments, own, gauge)?;
        let mut before: Option<(f64, f64)> = None;
        let mut last = None;
        for moment in &history.moments {
            let (end, now) = ((moment.time * TICKS).round() as u64, moment.gauges[tile]);
            let since = before.map_or(end, |(time, _)| (time * TICKS).round() as u64 + 1);
            let (then, old) = before.unwrap_or((moment.time, now));
            let watched = since.max(end.saturating_sub(WATCHED));
            let at = |tick: u64| {
                let time = tick as f64 / TICKS;
                if !plan.layout.is_sealed {
                    return (time, told.order(tile, time).pressure);
                }
                let share = if moment.time > then { (time - then) / (moment.time - then) } else { 1.0 };
                (time, old + share * (now - old))
            };
            for tick in since.max(end.saturating_sub(instruments.memory()))..watched {
                sensors.feel(tick, at(tick).1);
            }
            for tick in watched..=end {
                let (time, gauge) = at(tick);
                let heights = tile::heights(&told.order(tile, time).command, plan.layout.circle);
                let read = sensors.observe(tick, heights, gauge);
                last = Some(Reading { time: moment.time, tile, read, heights, gauge });
            }
            // Moments closer than a tick have the same reading.
            found.extend(last.map(|last| Reading { time: moment.time, ..last }));
            before = Some((moment.time, now));
        }
    }
    found.sort_by(|a, b| a.time.total_cmp(&b.time).then(a.tile.cmp(&b.tile)));
    Ok(found)
}

impl Errors {
    /// The largest errors of these readings.
    #[must_use]
    pub fn of(readings: &[Reading]) -> Errors {
        let apart = |a: &[f64; 3], b: &[f64; 3]| (0..3).map(|k| (a[k] - b[k]).abs()).fold(0.0, f64::max);
        let mut errors = Errors::default();
        for Reading { read, heights, gauge, .. } in readings {
            errors.encoder = errors.encoder.max(apart(&read.encoders, heights));
            errors.lvdt = errors.lvdt.max(apart(&read.lvdts, heights));
            errors.pressure = errors.pressure.max((read.pressure - gauge).abs());
            errors.disagree += usize::from(read.disagree().is_some());
        }
        errors
    }
}
