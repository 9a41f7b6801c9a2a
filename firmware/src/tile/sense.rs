//! Estimates of the tile's state: heights and speeds of the legs, pressure, currents.
//!
//! In: raw readings, offsets of the calibration. Out: SI values, smoothed where a check needs it. A height is that of
//! the last reference plus the encoder counts since. The reference is the displacement sensor after a start, and the
//! lower end switch after homing. References are lost with power; the displacement sensor needs none.

use super::board::{COUNTS, Measured, Readings};
use super::drive::DRIVE;
use super::motion::{Heights, pose};
use super::profile::TICK;
use crate::command::Pose;
use crate::link::message::Trim;

/// Weight of a new reading in the smoothed speed: 4 ticks.
const SPEED_SHARE: f32 = 0.25;
/// Weight of a new reading in the smoothed displacement and slope rate: 16 ticks.
const SLOW_SHARE: f32 = 0.0625;

/// Estimates of the tile's state.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Sense {
    /// Heights at the references (m).
    base: Heights,
    /// Counts at the references.
    reference: [i32; 3],
    /// Counts of the last tick.
    last: [i32; 3],
    is_begun: bool,
    /// Heights of the legs (m).
    pub heights: Heights,
    /// Their speeds (m/s), smoothed over 4 ticks.
    pub speeds: [f32; 3],
    /// Speeds in this tick alone (m/s).
    pub raw_speeds: [f32; 3],
    /// Heights by displacement sensor (m), smoothed over 16 ticks.
    pub displaced: Heights,
    /// Rate of the slopes (1/s), smoothed over 16 ticks.
    pub slope_rate: [f32; 2],
    /// Measurements of this tick.
    pub measured: Measured,
}

impl Default for Sense {
    fn default() -> Self {
        let measured =
            Measured { displaced: [0.0; 3], pressure: [0.0; 2], current: [0.0; 3], supply: DRIVE.supply };
        let zero = [0.0; 3];
        Self {
            base: zero,
            reference: [0; 3],
            last: [0; 3],
            is_begun: false,
            heights: zero,
            speeds: zero,
            raw_speeds: zero,
            displaced: zero,
            slope_rate: [0.0; 2],
            measured,
        }
    }
}

impl Sense {
    /// Takes the readings of a tick.
    pub fn take(&mut self, readings: &Readings, trim: &Trim) {
        let measured = readings.measure();
        self.measured = Measured {
            displaced: sum(measured.displaced, trim.height),
            pressure: measured.pressure.map(|p| p + trim.pressure),
            ..measured
        };
        if !self.is_begun {
            self.is_begun = true;
            self.displaced = self.measured.displaced;
            self.last = readings.encoder;
            self.reference = readings.encoder;
            self.base = self.displaced;
            self.heights = self.displaced;
        }
        let before = pose(self.heights);
        let counted = |from: &[i32; 3]| -> [f32; 3] {
            core::array::from_fn(|leg| readings.encoder[leg].wrapping_sub(from[leg]) as f32 * per_count())
        };
        self.heights = sum(self.base, counted(&self.reference));
        self.raw_speeds = counted(&self.last).map(|way| way / TICK);
        self.last = readings.encoder;
        for (smooth, raw) in self.speeds.iter_mut().zip(self.raw_speeds) {
            *smooth += SPEED_SHARE * (raw - *smooth);
        }
        for (smooth, raw) in self.displaced.iter_mut().zip(self.measured.displaced) {
            *smooth += SLOW_SHARE * (raw - *smooth);
        }
        let after = pose(self.heights);
        let rate = [(after.tx - before.tx) / TICK, (after.ty - before.ty) / TICK];
        for (smooth, raw) in self.slope_rate.iter_mut().zip(rate) {
            *smooth += SLOW_SHARE * (raw - *smooth);
        }
    }

    /// Begins anew with the next readings; until then the heights are the present ones.
    #[must_use]
    pub fn anew(self) -> Self {
        Self { is_begun: false, ..self }
    }

    /// Resets the heights to those of the displacement sensors.
    pub fn recover(&mut self) {
        (self.base, self.reference, self.heights) = (self.displaced, self.last, self.displaced);
        self.slope_rate = [0.0; 2];
    }

    /// Sets the reference of a leg that has just pressed its switch: it is at this height (m).
    pub fn refer(&mut self, leg: usize, height: f32) {
        let places = self.base.iter_mut().zip(&mut self.reference).zip(&mut self.heights).zip(self.last);
        if let Some((((base, reference), known), last)) = places.into_iter().nth(leg) {
            (*base, *reference, *known) = (height, last, height);
        }
    }

    /// Pressure over ambient (Pa): the mean of both sensors.
    #[must_use]
    pub fn pressure(&self) -> f32 {
        let [a, b] = self.measured.pressure;
        0.5 * (a + b)
    }

    /// Heave and slopes.
    #[must_use]
    pub fn pose(&self) -> Pose {
        pose(self.heights)
    }
}

/// Height per count of an encoder (m).
#[must_use]
pub fn per_count() -> f32 {
    core::f32::consts::TAU / (COUNTS * DRIVE.gear())
}

fn sum(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    core::array::from_fn(|leg| a[leg] + b[leg])
}

#[cfg(test)]
mod tests {
    use super::{Sense, per_count};
    use crate::link::message::Trim;
    use crate::tile::board::Readings;

    #[test]
    fn a_height_is_the_reference_and_what_was_counted() {
        let (mut sense, trim) = (Sense::default(), Trim { height: [1e-3, 0.0, 0.0], pressure: 20.0 });
        // 2048 + 640 counts of the displacement sensor are 10 mm.
        let mut readings = Readings { encoder: [i32::MAX - 10, 0, 0], ..Readings::at_rest() };
        readings.displacement = [2688, 2048, 2048];
        sense.take(&readings, &trim);
        assert!((sense.heights[0] - 0.011).abs() < 1e-6 && sense.speeds == [0.0; 3]);
        assert!((sense.pressure() - 20.0).abs() < 1e-3);
        // A thousand counts are 32.55 um; the counter goes round.
        readings.encoder[0] = readings.encoder[0].wrapping_add(1000);
        sense.take(&readings, &trim);
        assert!((sense.heights[0] - 0.011 - 1000.0 * 0.004 / 30.0 / 4096.0).abs() < 2e-9);
        assert!((sense.raw_speeds[0] - 1000.0 * per_count() * 1e3).abs() < 1e-6);
        sense.refer(0, -0.0295);
        readings.encoder[0] = readings.encoder[0].wrapping_sub(500);
        sense.take(&readings, &trim);
        assert!((sense.heights[0] + 0.0295 + 500.0 * per_count()).abs() < 2e-9);
        sense.recover();
        assert!((sense.heights[0] - 0.011).abs() < 1e-6);
    }
}
