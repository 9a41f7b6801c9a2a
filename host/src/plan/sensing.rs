//! `[sensors]`: the sensors of a bed's surface, and their readings of a run.

use crate::world::read::value::{Bound, count, number};
use smartbed_bed::body::mesh::field::AROUND;
use smartbed_bed::equilibrium::Cover;
use smartbed_bed::plan::history::History;
use smartbed_bed::sensor::fine;
use smartbed_bed::sensor::reader::{Quality, Reader, error};
use smartbed_bed::sensor::site::Site;
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::Fields;
use smartbed_codegen::model::document::Table;

/// Most sites of a grid finer than the sheets.
const MOST_SITES: f64 = 4e6;

/// Sensors on the surface of a bed.
#[derive(Clone, Debug)]
pub struct Sensing {
    /// A site of sensors; all are alike.
    pub site: Site,
    /// The reader of maps.
    pub reader: Reader,
    /// Seed of all noise.
    pub seed: u64,
    /// Distance of sites (m); `None` for one per node.
    pub pitch: Option<f64>,
    /// Moisture (%) and pH of the skin.
    pub skin: [f64; 2],
    /// Are they mounted on the sheets, where they add weight and separate sheet and skin?
    pub is_mounted: bool,
}

/// Readings of a run.
#[derive(Clone, Debug)]
pub struct Read {
    /// Rows and columns of sites.
    pub grid: [usize; 2],
    /// Sum of |read - true| over the sum of the true map, in the last frame.
    pub error: f64,
    /// Moisture (%) and pH.
    pub skin: [f64; 2],
    /// Mass of the sensors on the bed (kg).
    pub mass: f64,
}

/// Reads `[sensors]`.
pub(super) fn read(table: &Table, bed: f64, found: &mut Diagnostics) -> Option<Sensing> {
    let fields = Fields::of("sensors", table.span, table);
    let (usual, quality) = (Site::default(), Quality::default());
    let seed = count(&fields, "seed", 0, found).map_or(quality.seed, |seed| seed as u64);
    let mut get = |key: &'static str, of: &str, bound: Bound, left_out: f64| {
        number(&fields, key, of, bound, found).unwrap_or(left_out)
    };
    let site = Site {
        mass: get("mass", "kg", Bound::NotNegative, usual.mass),
        thickness: get("thickness", "m", Bound::Positive, usual.thickness),
        gap: get("gap", "m", Bound::Positive, usual.gap),
        moduli: [
            get("modulus", "Pa", Bound::Positive, usual.moduli[0]),
            get("shear_modulus", "Pa", Bound::Positive, usual.moduli[1]),
        ],
        ..usual
    };
    let quality = Quality {
        noise: get("noise", "", Bound::Share, quality.noise),
        step: get("step", "", Bound::Share, quality.step),
        drift: get("drift", "", Bound::Share, quality.drift),
        seed,
    };
    let skin = [get("moisture", "", Bound::NotNegative, 30.0), get("ph", "", Bound::Positive, 5.0)];
    let pitch = number(&fields, "pitch", "m", Bound::Positive, found);
    let is_mounted = fields.boolean("mounted", found).unwrap_or(false);
    fields.finish(found);
    let mut refuse = |what: String, help: &str| {
        found.push(Diagnostic::error(what).label(table.span, "of these sensors").help(help));
        None
    };
    if pitch.is_some_and(|pitch| bed / (pitch * pitch) > MOST_SITES) {
        return refuse(format!("sensors of more than {MOST_SITES:.0e} sites"), "pitch = \"1_mm\", or more");
    }
    if skin[0] > 100.0 || !(3.0..=9.0).contains(&skin[1]) {
        return refuse("skin has a moisture of 0 to 100 % and a pH of 3 to 9".to_owned(), "moisture = 30");
    }
    // The two substrates and the gap are stacked.
    if site.thickness < site.gap + site.shear.height + site.moisture.height {
        return refuse(
            "`thickness` is less than the gap and two substrates of a sensor".to_owned(),
            "thickness = \"10_mm\", or a smaller `gap`",
        );
    }
    if is_mounted && pitch.is_some_and(|pitch| pitch < site.side) {
        let side = 1e3 * site.side;
        return refuse(
            format!("mounted sensors are {side} mm wide, which is more than their `pitch`"),
            "pitch = \"5_mm\", or more; or mounted = false",
        );
    }
    if is_mounted && site.thickness > AROUND {
        let (found, most) = (1e3 * site.thickness, 1e3 * AROUND);
        return refuse(
            format!("mounted sensors of {found} mm height, expected {most} mm at most"),
            "a smaller `thickness`; or mounted = false",
        );
    }
    match Reader::new(&site, quality) {
        Ok(reader) => Some(Sensing { site, reader, seed, pitch, skin, is_mounted }),
        Err(_) => refuse(
            "these sensors read nearly the same at every load".to_owned(),
            "a softer spacer: a lower `modulus`",
        ),
    }
}

impl Sensing {
    /// Their mass and thickness on sheets with cells of this area (m^2); zero unless they are mounted.
    #[must_use]
    pub fn cover(&self, cell: f64) -> Cover {
        if !self.is_mounted {
            return Cover::default();
        }
        let density = self.site.mass / self.pitch.map_or(cell, |pitch| pitch * pitch);
        Cover { density, thickness: self.site.thickness }
    }

    /// Readings of the last frame, on the sensors' own grid.
    #[must_use]
    pub fn of(&self, history: &History) -> Option<Read> {
        let (number, last) =
            (history.sensels.frames().len().checked_sub(1)?, history.sensels.frames().last()?);
        let sites = history.sensels.sites();
        let (grid, sites, truth) = match self.pitch {
            None => (history.grid, sites.to_vec(), last.clone()),
            Some(pitch) => {
                let parts = fine::parts(&history.grid, pitch);
                let finer = fine::grid(&history.grid, parts);
                (finer, finer.all(), fine::frame(&history.grid, sites, last, parts))
            }
        };
        let read = self.reader.frame(number as u64, &truth);
        Some(Read {
            grid: [grid.rows, grid.columns],
            error: error(&sites, &truth.pressure, &read.pressure),
            skin: self.reader.skin(number as u64, last.time, self.skin),
            mass: self.site.mass * grid.sites() as f64,
        })
    }
}
