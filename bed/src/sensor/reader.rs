//! Reads maps through the surface's antennas: noise, frequency steps, drift, and calibration back to kPa.
//!
//! In: a recording of true values. Out: the readings, and their error. Each resonance has its own noise, determined by
//! seed, site and frame number, so that a seed gives the same bytes in any order of evaluation.

use super::array::{Array, SITES};
use super::site::{Calibration, Load, Site, usual_skin};
use super::table::NotMonotone;
use crate::map::{self, Frame, Recording};
use smartbed_runtime::sensor::noise::Noise;
use smartbed_runtime::sensor::quantised;

/// Accuracy of frequencies, relative to them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// Standard deviation of one reading.
    pub noise: f64,
    /// Step of the sweep.
    pub step: f64,
    /// Standard deviation of a site's drift after an hour.
    pub drift: f64,
    /// Seed of all noise.
    pub seed: u64,
}

impl Default for Quality {
    fn default() -> Quality {
        Quality { noise: 1e-5, step: 1e-5, drift: 1e-5, seed: 1 }
    }
}

/// The state of a sensing surface.
#[derive(Clone, Debug)]
pub struct Reader {
    quality: Quality,
    sites: Vec<(Site, Calibration)>,
}

/// Number of resonances of a site that are read for loads.
const CHANNELS: u64 = 3;

impl Reader {
    /// A surface of sites like this one, four per line.
    ///
    /// # Errors
    /// [`NotMonotone`] for a site whose frequencies do not determine the load.
    pub fn new(site: &Site, quality: Quality) -> Result<Reader, NotMonotone> {
        let sites = Array::new(site).sites;
        let calibrated = |site: &Site| Ok((*site, Calibration::new(site)?));
        Ok(Reader { quality, sites: sites.iter().map(calibrated).collect::<Result<_, _>>()? })
    }

    /// The load that a site reads at a time (s) in the frame with this number.
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

    /// Moisture (%) and pH of the skin, as read by the first site at a time (s) in the frame with this number.
    #[must_use]
    pub fn skin(&self, frame: u64, time: f64, skin: [f64; 2]) -> [f64; 2] {
        let (site, calibration) = &self.sites[0];
        let tables = usual_skin();
        let covered = site.covered([0, 1].map(|k| tables[k].at(skin[k])));
        let read = [0, 1].map(|k| self.heard(u64::MAX - k as u64, frame, time, covered[k]));
        calibration.skin(read, &tables)
    }

    /// A resonance (Hz) with the noise and drift of its channel, rounded to the steps of the sweep.
    fn heard(&self, channel: u64, frame: u64, time: f64, frequency: f64) -> f64 {
        let Quality { noise, step, drift, seed } = self.quality;
        let source = Noise::new(seed.wrapping_add(channel.wrapping_mul(0x9e37_79b9)));
        let wrong =
            noise * source.normal::<f64>(frame) + drift * time / 3600.0 * source.normal::<f64>(u64::MAX);
        // Steps are equal on a logarithmic scale.
        quantised((frequency * (1.0 + wrong)).ln(), step).exp()
    }

    /// The reading of a whole frame with this number.
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

    /// The reading of a whole recording.
    ///
    /// # Errors
    /// [`map::MapError`] if the readings are not a valid recording.
    pub fn recording(&self, truth: &Recording) -> Result<Recording, map::MapError> {
        let frames =
            truth.frames().iter().zip(0..).map(|(frame, number)| self.frame(number, frame)).collect();
        Recording::new(truth.sites().to_vec(), frames)
    }
}

/// Relative error of a map: sum |p - p_true| A over sum p_true A; 0 if nothing presses.
#[must_use]
pub fn error(sites: &[map::Site], truth: &[f64], read: &[f64]) -> f64 {
    let all: f64 = sites.iter().zip(truth).map(|(s, p)| s.area * p).sum();
    let apart: f64 = sites.iter().zip(truth.iter().zip(read)).map(|(s, (p, q))| s.area * (p - q).abs()).sum();
    if all > 0.0 { apart / all } else { 0.0 }
}
