//! Reads maps through the surface's antennas: noise, steps of the frequency, drift, calibration back to kPa.
//!
//! In: a recording of what is true. Out: what is read of it, and how far it is from the truth. Each resonance has noise of
//! its own, by seed, site and number of the frame: the same seed gives the same bytes in any order.

use super::array::{Array, SITES};
use super::site::{Calibration, Load, Site, usual_skin};
use super::table::NotMonotone;
use crate::map::{self, Frame, Recording};
use smartbed_runtime::sensor::noise::Noise;
use smartbed_runtime::sensor::quantised;

/// How well frequencies are read, as shares of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// Standard deviation of one reading.
    pub noise: f64,
    /// Step of the sweep.
    pub step: f64,
    /// Standard deviation of what a site has drifted by after an hour.
    pub drift: f64,
    /// Of all noise.
    pub seed: u64,
}

impl Default for Quality {
    fn default() -> Quality {
        Quality { noise: 1e-5, step: 1e-5, drift: 1e-5, seed: 1 }
    }
}

/// A surface at work.
#[derive(Clone, Debug)]
pub struct Reader {
    quality: Quality,
    sites: Vec<(Site, Calibration)>,
}

/// Resonances of a site that are read for loads.
const CHANNELS: u64 = 3;

impl Reader {
    /// A surface of sites like this one, four on a line.
    ///
    /// # Errors
    /// [`NotMonotone`] for a site that does not tell loads apart.
    pub fn new(site: &Site, quality: Quality) -> Result<Reader, NotMonotone> {
        let sites = Array::new(site).sites;
        let calibrated = |site: &Site| Ok((*site, Calibration::new(site)?));
        Ok(Reader { quality, sites: sites.iter().map(calibrated).collect::<Result<_, _>>()? })
    }

    /// What a site reads at a time (s) in the frame of this number.
    #[must_use]
    pub fn site(&self, number: usize, frame: u64, time: f64, load: &Load) -> Load {
        let (site, calibration) = &self.sites[number % SITES];
        let mut channel = number as u64 * CHANNELS;
        let read = site.loaded(load).map(|frequency| {
            channel += 1;
            self.heard(channel, frame, time, frequency)
        });
        calibration.load(read)
    }

    /// Moisture (%) and pH of skin on the first site, as read at a time (s) in the frame of this number.
    #[must_use]
    pub fn skin(&self, frame: u64, time: f64, skin: [f64; 2]) -> [f64; 2] {
        let (site, calibration) = &self.sites[0];
        let tables = usual_skin();
        let covered = site.covered([0, 1].map(|k| tables[k].at(skin[k])));
        let read = [0, 1].map(|k| self.heard(u64::MAX - k as u64, frame, time, covered[k]));
        calibration.skin(read, &tables)
    }

    /// A resonance (Hz) with noise and drift of its channel, on the steps of the sweep.
    fn heard(&self, channel: u64, frame: u64, time: f64, frequency: f64) -> f64 {
        let Quality { noise, step, drift, seed } = self.quality;
        let source = Noise::new(seed.wrapping_add(channel.wrapping_mul(0x9e37_79b9)));
        let wrong =
            noise * source.normal::<f64>(frame) + drift * time / 3600.0 * source.normal::<f64>(u64::MAX);
        // Steps are equal shares of the frequency.
        quantised((frequency * (1.0 + wrong)).ln(), step).exp()
    }

    /// A whole frame, the `number`-th.
    #[must_use]
    pub fn frame(&self, number: u64, truth: &Frame) -> Frame {
        let load = |site: usize| Load {
            pressure: truth.pressure[site],
            shear: truth.shear.get(site).copied().unwrap_or_default(),
        };
        let read: Vec<Load> =
            (0..truth.pressure.len()).map(|site| self.site(site, number, truth.time, &load(site))).collect();
        let shear = if truth.shear.is_empty() { Vec::new() } else { read.iter().map(|r| r.shear).collect() };
        let pressure = read.iter().map(|r| r.pressure.max(0.0)).collect();
        Frame { time: truth.time, seconds: truth.seconds, pressure, shear }
    }

    /// A whole recording.
    ///
    /// # Errors
    /// [`map::MapError`] if what is read is no recording.
    pub fn recording(&self, truth: &Recording) -> Result<Recording, map::MapError> {
        let frames =
            truth.frames().iter().zip(0..).map(|(frame, number)| self.frame(number, frame)).collect();
        Recording::new(truth.sites().to_vec(), frames)
    }
}

/// How far a map is from the true one: sum |p - p_true| A over sum p_true A; 0 where nothing presses.
#[must_use]
pub fn error(sites: &[map::Site], truth: &[f64], read: &[f64]) -> f64 {
    let all: f64 = sites.iter().zip(truth).map(|(s, p)| s.area * p).sum();
    let apart: f64 = sites.iter().zip(truth.iter().zip(read)).map(|(s, (p, q))| s.area * (p - q).abs()).sum();
    if all > 0.0 { apart / all } else { 0.0 }
}
