//! A tile's instruments: for each screw an encoder, an LVDT and two switches; the pressure of its bladder.
//!
//! In: heights of the screws and the gauge pressure, tick by tick. Out: readings, and whether encoder and LVDT agree.
//! Transducers, noise and sampling are the runtime's. Defaults: 1024 lines on the motor, a worm of 30 : 1 and a lead of
//! 4 mm; an LVDT with 0.25 % over 30 mm up and down; pressure within 20 Pa.

use smartbed_runtime::sensor::kinds::{Lvdt, Membrane, Switch, encoder_resolution};
use smartbed_runtime::sensor::noise::Noise;
use smartbed_runtime::sensor::{Channel, Sensor, quantised};

/// Difference between encoder and LVDT (m) above which there is a fault.
pub const APART: f64 = 0.5e-3;
/// Ticks per second.
pub const TICKS: f64 = 1000.0;

/// Time constants after which the pressure sensor has forgotten.
const LAGS: f64 = 20.0;

/// Parameters of a tile's instruments.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Instruments {
    /// Resolution of an encoder (m).
    pub encoder: f64,
    /// Nonlinearity of an LVDT.
    pub lvdt: Lvdt<f64>,
    /// Standard deviation of an LVDT's reading (m), and its resolution (m).
    pub lvdt_noise: [f64; 2],
    /// Distance of the switches above and below the middle (m).
    pub switches: f64,
    /// Time constant of the pressure sensor (s).
    pub lag: f64,
    /// Noise, bias, drift, resolution and range of the pressure (Pa), per tick.
    pub pressure: Channel<f64>,
}

impl Default for Instruments {
    fn default() -> Instruments {
        Instruments {
            encoder: encoder_resolution(1024.0, 30.0, 4e-3),
            lvdt: Lvdt { reach: 30e-3, linearity: 2.5e-3 },
            lvdt_noise: [5e-6, 2e-6],
            switches: 30e-3,
            lag: 0.02,
            pressure: Channel {
                period: 10,
                delay: 10,
                noise: 5.0,
                bias: 10.0,
                drift: 0.0,
                resolution: 1.0,
                range: [-20e3, 40e3],
            },
        }
    }
}

impl Instruments {
    /// Number of ticks before a reading from which on the pressure sensor must follow the pressure: of what was before,
    /// e^-20 remains in it.
    #[must_use]
    pub fn memory(&self) -> u64 {
        let settled = (LAGS * self.lag * TICKS).ceil() as u64;
        settled + u64::from(self.pressure.delay) + u64::from(self.pressure.period)
    }
}

/// The readings of a tile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Readings {
    /// Heights by the encoders (m).
    pub encoders: [f64; 3],
    /// Heights by the LVDTs (m).
    pub lvdts: [f64; 3],
    /// Lower and upper switch of each screw.
    pub switches: [[bool; 2]; 3],
    /// Gauge pressure (Pa).
    pub pressure: f64,
}

impl Readings {
    /// The first screw, counted from 1, whose encoder and LVDT disagree.
    #[must_use]
    pub fn disagree(&self) -> Option<usize> {
        (0..3).find(|k| (self.encoders[*k] - self.lvdts[*k]).abs() > APART).map(|k| k + 1)
    }
}

/// The state of a tile's instruments.
#[derive(Clone, Debug)]
pub struct TileSensors {
    instruments: Instruments,
    noise: [Noise; 3],
    switches: [[Switch<f64>; 2]; 3],
    membrane: Membrane<f64>,
    pressure: Sensor<f64, 4>,
}

impl TileSensors {
    /// Instruments of the tile with this seed; the pressure reads `gauge` (Pa) until the first sample.
    ///
    /// # Errors
    /// A pressure channel with invalid parameters.
    pub fn new(
        instruments: Instruments,
        seed: u64,
        gauge: f64,
    ) -> Result<TileSensors, smartbed_runtime::sensor::ChannelFault> {
        let own = |k: u64| seed.wrapping_mul(16).wrapping_add(k);
        let switch = |k: u64| Switch::new(instruments.switches, 0.2e-3, 5, own(k));
        Ok(TileSensors {
            instruments,
            noise: [0, 1, 2].map(|k| Noise::new(own(k))),
            switches: [3, 5, 7].map(|k| [switch(k), switch(k + 1)]),
            membrane: Membrane::new(instruments.lag * TICKS),
            pressure: Sensor::new(instruments.pressure, own(9), gauge)?,
        })
    }

    /// Lets the pressure sensor alone follow the true gauge pressure (Pa) at a tick.
    pub fn feel(&mut self, tick: u64, gauge: f64) {
        let felt = self.membrane.observe(tick, gauge);
        self.pressure.observe(tick, felt);
    }

    /// Readings at a tick, for these true values.
    pub fn observe(&mut self, tick: u64, heights: [f64; 3], gauge: f64) -> Readings {
        self.feel(tick, gauge);
        let Instruments { encoder, lvdt, lvdt_noise: [noise, step], .. } = self.instruments;
        let mut switches = [[false; 2]; 3];
        for ((own, height), closed) in self.switches.iter_mut().zip(heights).zip(&mut switches) {
            *closed = [own[0].observe(tick, -height), own[1].observe(tick, height)];
        }
        Readings {
            encoders: heights.map(|height| quantised(height, encoder)),
            lvdts: std::array::from_fn(|k| {
                quantised(lvdt.report(heights[k]) + noise * self.noise[k].normal::<f64>(tick), step)
            }),
            switches,
            pressure: self.pressure.reading(tick),
        }
    }
}
