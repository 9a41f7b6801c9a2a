//! Four sites on one line of a reader, distinguished by frequency.
//!
//! In: a site. Out: four of them, tuned so that their resonances stay apart at any load and skin: a sweep finds exactly
//! one resonance in each [`Band`].

use super::antenna::Mode;
use super::site::{Load, RANGE, SKIN, SPACER, Site};

/// Sites on one line.
pub const SITES: usize = 4;
/// Lowest frequency of a patch and of a loop (Hz).
const LOWEST: [f64; 2] = [11e9, 0.8e9];
/// Ratio of neighbouring bands: more than the change by loads and skin (2.6 % at most) plus the width of a resonance.
const RATIO: [f64; 2] = [1.045, 1.4];

/// The range of frequencies of one resonance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// Index of the site.
    pub site: usize,
    /// The quantity that it senses.
    pub of: &'static str,
    /// Lowest and highest frequency (Hz).
    pub range: [f64; 2],
}

/// Four sites.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Array {
    /// In the order of their frequencies.
    pub sites: [Site; SITES],
}

impl Array {
    /// Tunes four sites like this one.
    #[must_use]
    pub fn new(site: &Site) -> Array {
        let patch = |n: usize| LOWEST[0] * RATIO[0].powi(n as i32);
        let one = |k: usize| {
            let mut own = *site;
            let frequency = LOWEST[1] * RATIO[1].powi(k as i32);
            let found = own.ring.resonance(own.gap);
            own.ring.capacitance *= (found / frequency) * (found / frequency);
            own.shear = own.shear.tuned([patch(4 * k), patch(4 * k + 1)], SPACER, own.overlap);
            // Only the mode along x is read; the other one is placed between the bands of the next two.
            let aside = |n: usize| [patch(n), patch(n) * RATIO[0].powf(0.5)];
            own.moisture = own.moisture.tuned(aside(4 * k + 2), SPACER, 0.0);
            own.acid = own.acid.tuned(aside(4 * k + 3), SPACER, 0.0);
            own
        };
        Array { sites: std::array::from_fn(one) }
    }

    /// Bands of all resonances that are read, in ascending order.
    #[must_use]
    pub fn bands(&self) -> Vec<Band> {
        let ends = |values: &[f64]| {
            [values.iter().copied().fold(f64::INFINITY, f64::min), values.iter().copied().fold(0.0, f64::max)]
        };
        let loads: Vec<Load> = [0.0, RANGE[0]]
            .into_iter()
            .flat_map(|pressure| [-RANGE[1], RANGE[1]].map(|shear| Load { pressure, shear: [shear; 2] }))
            .collect();
        let of = |k: usize| {
            let site = &self.sites[k];
            let loaded = |n: usize| ends(&loads.iter().map(|load| site.loaded(load)[n]).collect::<Vec<_>>());
            let covered = |n: usize| ends(&SKIN.map(|e| site.covered([e, e])[n]));
            [
                ("pressure", loaded(0)),
                ("shear along y", loaded(1)),
                ("shear along x", loaded(2)),
                ("moisture", covered(0)),
                ("pH", covered(1)),
            ]
            .map(|(of, range)| Band { site: k, of, range })
        };
        let mut bands: Vec<Band> = (0..SITES).flat_map(of).collect();
        bands.sort_by(|a, b| a.range[0].total_cmp(&b.range[0]));
        bands
    }

    /// The band to which a frequency belongs.
    #[must_use]
    pub fn heard(&self, frequency: f64) -> Option<Band> {
        self.bands().into_iter().find(|band| (band.range[0]..=band.range[1]).contains(&frequency))
    }

    /// Resonances (Hz) of the modes that are not used.
    #[must_use]
    pub fn unread(&self) -> Vec<f64> {
        let of =
            |site: &Site| [site.moisture, site.acid].map(|patch| patch.resonance(Mode::Across, SPACER, 0.0));
        self.sites.iter().flat_map(of).collect()
    }
}
