//! One site of the sensing surface: converts loads and skin to resonances of its antennas, and back by a calibration.
//!
//! In: pressure, two shears, moisture and pH at a site. Out: five frequencies, and from frequencies the loads. A soft
//! spacer of thickness g is compressed to g (1 - p/E), which changes the loop's gap, and sheared by tau g/G, which
//! moves the slots under the patch. Moisture and pH change the permittivity of what covers two further patches, behind
//! a film.

use super::antenna::{Loop, Mode, Patch};
use super::table::{NotMonotone, Table};

/// The design of a site. Dimensions are the thesis' where it states them (5 mm square, 10 mm high), others are ours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Site {
    /// Side of its square (m).
    pub side: f64,
    /// Height (m).
    pub thickness: f64,
    /// Mass (kg).
    pub mass: f64,
    /// Gap of the loop without load (m).
    pub gap: f64,
    /// Young's and shear modulus of the spacer (Pa).
    pub moduli: [f64; 2],
    /// Length of a slot under the patch without shear (m).
    pub overlap: f64,
    /// Senses pressure.
    pub ring: Loop,
    /// Senses shear.
    pub shear: Patch,
    /// Senses moisture.
    pub moisture: Patch,
    /// Senses pH.
    pub acid: Patch,
}

/// The load on a site.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Load {
    /// Pressure (Pa).
    pub pressure: f64,
    /// Shear (Pa), along x and y.
    pub shear: [f64; 2],
}

/// Permittivity of the cover of a patch without skin, that of the spacer.
pub const SPACER: f64 = 3.0;
/// Share of the cover's depth that is skin or gel behind the film.
const BEHIND: f64 = 0.3;
/// Largest pressure (Pa) and shear (Pa) within the calibration.
pub const RANGE: [f64; 2] = [30e3, 10e3];
/// Range of the permittivities of skin and gel within the calibration.
pub const SKIN: [f64; 2] = [3.0, 50.0];
/// Number of points of a calibration.
const POINTS: usize = 64;

impl Default for Site {
    fn default() -> Site {
        let patch =
            Patch { sides: [4e-3, 3.6e-3], height: 0.64e-3, permittivity: 10.2, slot: [0.4e-3, 0.3e-3] };
        Site {
            side: 5e-3,
            thickness: 10e-3,
            mass: 0.5e-3,
            gap: 0.5e-3,
            moduli: [100e3, 35e3],
            overlap: 1e-3,
            ring: Loop { radius: 2e-3, wire: 0.1e-3, capacitance: 4e-12 },
            shear: patch,
            moisture: patch,
            acid: patch,
        }
    }
}

/// Permittivity of the outer skin by its moisture (%), and of a gel that swells with pH: estimates of ours, of the
/// order of published values for skin (Gabriel 1996) and pH gels, to be replaced by a maker's tables.
///
/// # Panics
/// Never: both are monotone.
#[must_use]
pub fn usual_skin() -> [Table; 2] {
    let moisture = vec![[0.0, 4.0], [20.0, 8.0], [40.0, 14.0], [60.0, 22.0], [80.0, 31.0], [100.0, 40.0]];
    let acid = vec![[3.0, 12.0], [4.0, 15.0], [5.0, 20.0], [6.0, 27.0], [7.0, 35.0], [9.0, 48.0]];
    [moisture, acid].map(|pairs| Table::new(pairs).expect("monotone"))
}

/// Effective permittivity of a film with something behind it, in series.
fn behind_film(permittivity: f64) -> f64 {
    1.0 / ((1.0 - BEHIND) / SPACER + BEHIND / permittivity)
}

impl Site {
    /// Gap of the loop (m) under a pressure (Pa).
    fn gap(&self, pressure: f64) -> f64 {
        self.gap * (1.0 - (pressure / self.moduli[0]).min(0.9))
    }

    /// Frequencies (Hz): loop, patch along x, along y. The slot across the current along x is covered by displacement
    /// along y, and vice versa.
    #[must_use]
    pub fn loaded(&self, load: &Load) -> [f64; 3] {
        let gap = self.gap(load.pressure);
        let moved = load.shear.map(|shear| shear / self.moduli[1] * gap);
        let patch = |mode: Mode, way: f64| self.shear.resonance(mode, SPACER, (self.overlap + way).max(0.0));
        [self.ring.resonance(gap), patch(Mode::Along, moved[1]), patch(Mode::Across, moved[0])]
    }

    /// Frequencies (Hz) of the patches for moisture and pH, from the permittivities of skin and gel.
    #[must_use]
    pub fn covered(&self, permittivities: [f64; 2]) -> [f64; 2] {
        let [skin, gel] = permittivities.map(behind_film);
        [self.moisture.resonance(Mode::Along, skin, 0.0), self.acid.resonance(Mode::Along, gel, 0.0)]
    }

    /// Mass of a sheet's node with area (m^2) that carries sensors at a pitch (m), given its `own` mass (kg).
    #[must_use]
    pub fn borne(&self, own: f64, area: f64, pitch: Option<f64>) -> f64 {
        own + self.mass * pitch.map_or(1.0, |pitch| area / (pitch * pitch))
    }
}

/// The calibration: tables of measured points that convert frequencies back.
#[derive(Clone, Debug)]
pub struct Calibration {
    site: Site,
    pressure: Table,
    overlap: [Table; 2],
    skin: [Table; 2],
}

impl Calibration {
    /// Calibrates a site.
    ///
    /// # Errors
    /// [`NotMonotone`] for a site whose resonances do not determine the load.
    pub fn new(site: &Site) -> Result<Calibration, NotMonotone> {
        let pressed = |p: f64| site.ring.resonance(site.gap(p));
        let way = RANGE[1] / site.moduli[1] * site.gap;
        let range = [(site.overlap - way).max(0.0), site.overlap + way];
        let slot = |mode: Mode| move |overlap: f64| site.shear.resonance(mode, SPACER, overlap);
        Ok(Calibration {
            site: *site,
            pressure: Table::sampled([0.0, RANGE[0]], POINTS, pressed)?,
            overlap: [
                Table::sampled(range, POINTS, slot(Mode::Across))?,
                Table::sampled(range, POINTS, slot(Mode::Along))?,
            ],
            skin: [
                Table::sampled(SKIN, 8 * POINTS, |e| site.covered([e, 1.0])[0])?,
                Table::sampled(SKIN, 8 * POINTS, |e| site.covered([1.0, e])[1])?,
            ],
        })
    }

    /// The load at these frequencies. Pressure comes first, because it determines the thickness of the spacer.
    #[must_use]
    pub fn load(&self, [ring, along, across]: [f64; 3]) -> Load {
        let pressure = self.pressure.back(ring);
        let gap = self.site.gap(pressure);
        let shear = |k: usize, frequency: f64| {
            (self.overlap[k].back(frequency) - self.site.overlap) / gap * self.site.moduli[1]
        };
        Load { pressure, shear: [shear(0, across), shear(1, along)] }
    }

    /// Moisture (%) and pH at these frequencies.
    #[must_use]
    pub fn skin(&self, frequencies: [f64; 2], tables: &[Table; 2]) -> [f64; 2] {
        [0, 1].map(|k| tables[k].back(self.skin[k].back(frequencies[k])))
    }
}
