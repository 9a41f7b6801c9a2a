//! Simulated readings of a board: counts of encoders and converters, with gain errors and noise.
//!
//! In: heights, currents, pressure. Out: [`Readings`]. Noise is the runtime's, determined by the sample number, so
//! runs repeat to the bit.

use super::Defect;
use crate::tile::board::{COUNTS, CURRENT, DISPLACEMENT, NO_PRESSURE, PRESSURE, Readings, SUPPLY};
use crate::tile::design::SWITCH;
use crate::tile::drive::DRIVE;
use smartbed_runtime::sensor::noise::Noise;

/// Gains of the displacement sensors, with errors up to 0.25 %.
const GAINS: [f32; 3] = [1.0025, 0.9975, 1.0015];
/// Offsets of the switches from their nominal heights (m).
const PLAY: [f32; 3] = [2e-5, -3e-5, 1e-5];

/// Quantities to be read.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Place {
    /// Heights of the legs (m).
    pub heights: [f32; 3],
    /// Currents of the motors (A).
    pub currents: [f32; 3],
    /// Pressure over ambient (Pa).
    pub pressure: f32,
    /// Supply (V).
    pub supply: f32,
}

/// Converters with their noise.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Converters {
    noise: Noise,
    /// Samples taken so far, of all converters.
    samples: u64,
    /// Counts at the start: an encoder is incremental.
    start: Option<[i32; 3]>,
    /// The last readings, which a stuck sensor keeps.
    last: Option<Readings>,
    drift: i32,
}

impl Default for Converters {
    fn default() -> Self {
        Self { noise: Noise::new(1), samples: 0, start: None, last: None, drift: 0 }
    }
}

impl Converters {
    /// Converts the quantities to readings, with the defect.
    pub fn read(&mut self, place: &Place, defect: Option<Defect>) -> Readings {
        let per_height = COUNTS * DRIVE.gear() / core::f32::consts::TAU;
        let counts = place.heights.map(|height| floor(height * per_height));
        let start = *self.start.get_or_insert(counts);
        let mut readings = Readings::at_rest();
        readings.encoder = core::array::from_fn(|leg| counts[leg] - start[leg]);
        readings.displacement = core::array::from_fn(|leg| {
            self.converter(place.heights[leg] * GAINS[leg] / DISPLACEMENT + 2048.5)
        });
        readings.current = place.currents.map(|current| self.converter(current / CURRENT + 2048.5));
        readings.pressure =
            [(); 2].map(|()| self.converter(place.pressure / PRESSURE + NO_PRESSURE as f32 + 0.5));
        readings.supply = self.converter(place.supply / SUPPLY + 0.5);
        readings.low_closed = core::array::from_fn(|leg| place.heights[leg] > -SWITCH + PLAY[leg]);
        readings.high_closed = core::array::from_fn(|leg| place.heights[leg] < SWITCH + PLAY[leg]);
        self.spoil(&mut readings, defect);
        self.last = Some(readings);
        readings
    }

    fn spoil(&mut self, readings: &mut Readings, defect: Option<Defect>) {
        let last = self.last.unwrap_or(*readings);
        let put = |to: &mut [i32; 3], leg: u8, value: i32| {
            to.get_mut(usize::from(leg)).into_iter().for_each(|count| *count = value);
        };
        let set = |to: &mut [u16; 3], leg: u8, value: u16| {
            to.get_mut(usize::from(leg)).into_iter().for_each(|count| *count = value);
        };
        match defect {
            Some(Defect::EncoderStuck(leg)) => {
                put(&mut readings.encoder, leg, at(&last.encoder, leg).unwrap_or(0));
            }
            Some(Defect::EncoderDrift(leg, rate)) => {
                self.drift = self.drift.wrapping_add(rate);
                let count = at(&readings.encoder, leg).unwrap_or(0);
                put(&mut readings.encoder, leg, count.wrapping_add(self.drift));
            }
            Some(Defect::DisplacementStuck(leg)) => {
                set(&mut readings.displacement, leg, at(&last.displacement, leg).unwrap_or(0));
            }
            Some(Defect::DisplacementOpen(leg)) => set(&mut readings.displacement, leg, 0),
            Some(Defect::SwitchOpen { leg, high }) => {
                let switches = if high { &mut readings.high_closed } else { &mut readings.low_closed };
                switches.get_mut(usize::from(leg)).into_iter().for_each(|closed| *closed = false);
            }
            Some(Defect::PressureBias(sensor, factor)) => {
                if let Some(count) = readings.pressure.get_mut(usize::from(sensor)) {
                    let above = (i32::from(*count) - NO_PRESSURE) as f32;
                    *count = (above * factor + NO_PRESSURE as f32) as u16;
                }
            }
            _ => (),
        }
    }

    /// A count of a converter of twelve bits, off by -1, 0 or 1.
    fn converter(&mut self, count: f32) -> u16 {
        self.samples = self.samples.wrapping_add(1);
        let off = i32::from(self.noise.bits(self.samples) as u8 % 3) - 1;
        (floor(count) + off).clamp(0, 4095) as u16
    }
}

fn at<T: Copy>(counts: &[T; 3], leg: u8) -> Option<T> {
    counts.get(usize::from(leg)).copied()
}

/// The largest whole number not above x.
fn floor(x: f32) -> i32 {
    let whole = x as i32;
    whole - i32::from((whole as f32) > x)
}
