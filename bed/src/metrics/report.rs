//! All metrics as rows with units and thresholds, for the whole bed and for each region of the body.
//!
//! In: a recording of sensels on their grid, or of points of the skin. Out: [`Row`]s in the units used in care (mmHg,
//! cm^2, mmHg h), which every rendering prints as they are.

use super::tissue::{self, Dose, Sigmoid};
use super::{Thresholds, shear, spatial, time};
use crate::map::{Grid, MMHG, Recording, Region, Site};

/// Area of the window for the peak pressure index (m^2).
pub const WINDOW: f64 = 9e-4;
/// Below this shear (Pa) its direction is not evaluated.
pub const LEAST_SHEAR: f64 = 100.0;

/// The value of one metric for one place.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// `bed` or a region's name.
    pub place: &'static str,
    /// Its name.
    pub metric: &'static str,
    /// Its value; `None` if there is nothing to measure, or the recording is too short.
    pub value: Option<f64>,
    /// Its unit.
    pub unit: &'static str,
    /// Its threshold, in the same unit.
    pub threshold: Option<f64>,
}

/// The data and parameters of a report.
#[derive(Clone, Copy, Debug)]
pub struct Report<'a> {
    /// What was recorded.
    pub recording: &'a Recording,
    /// Positions of the sensels; points of the skin have no grid.
    pub grid: Option<&'a Grid>,
    /// Thresholds.
    pub thresholds: Thresholds,
    /// Friction coefficient of skin on the cover.
    pub friction: f64,
}

impl Report<'_> {
    /// All rows, those of the whole bed first. Metrics of a single map use the last frame, those over time the whole
    /// recording.
    #[must_use]
    pub fn rows(&self) -> Vec<Row> {
        let mut rows = self.of("bed", |_| true);
        rows.push(row(
            "bed",
            "dispersion index of sacrum and seat bones",
            self.dispersion(),
            "%",
            Some(50.0),
        ));
        if let (Some(grid), Some(last)) = (self.grid, self.recording.frames().last()) {
            let ppi = spatial::peak_pressure_index(grid, &last.pressure, WINDOW).map(|p| p / MMHG);
            rows.push(row("bed", "peak pressure index, 9 cm2", ppi, "mmHg", Some(32.0)));
            let steep = spatial::gradient(grid, &last.pressure);
            let per_cm = |x: f64| Some(x / MMHG / 100.0);
            rows.push(row("bed", "largest gradient", per_cm(steep.largest), "mmHg/cm", None));
            rows.push(row(
                "bed",
                "root mean square gradient",
                per_cm(steep.root_mean_square),
                "mmHg/cm",
                None,
            ));
            let path = (self.recording.seconds() > 0.0).then(|| time::mobility(grid, self.recording, 0.02));
            let length = path.map(|p| 100.0 * p.path);
            rows.push(row("bed", "path of the centre of pressure", length, "cm", None));
            rows.push(row("bed", "shifts above 2 cm", path.map(|p| p.shifts as f64), "1", None));
        }
        for region in Region::ALL {
            if self.recording.sites().iter().any(|s| s.region == Some(region)) {
                rows.extend(self.of(region.name(), |s| s.region == Some(region)));
            }
        }
        rows
    }

    /// Share (%) of the pressure in the last map that is on sacrum and ischia; `None` if no site belongs to a region.
    fn dispersion(&self) -> Option<f64> {
        let pressure = &self.recording.frames().last()?.pressure;
        let sites = self.recording.sites();
        sites.iter().find(|site| site.region.is_some())?;
        let is_there = |site: &Site| matches!(site.region, Some(Region::Sacrum | Region::Ischia));
        let there: f64 = sites.iter().zip(pressure).filter(|(s, _)| is_there(s)).map(|(_, p)| p).sum();
        let all: f64 = pressure.iter().sum();
        (all > 0.0).then(|| 100.0 * there / all)
    }

    /// The rows for the sites of one place.
    fn of(&self, place: &'static str, is_there: impl Fn(&Site) -> bool) -> Vec<Row> {
        let part = self.part(&is_there);
        let mut rows = self.at_the_end(place, &part);
        rows.extend(self.over_time(place, &part));
        rows
    }

    /// The recording restricted to some of the sites.
    fn part(&self, is_there: &impl Fn(&Site) -> bool) -> Recording {
        let sites = self.recording.sites();
        let kept: Vec<usize> = (0..sites.len()).filter(|i| is_there(&sites[*i])).collect();
        self.recording.select(&kept)
    }

    /// Metrics of the last map.
    fn at_the_end(&self, place: &'static str, part: &Recording) -> Vec<Row> {
        let Some(last) = part.frames().last() else { return Vec::new() };
        let (sites, p, t) = (part.sites(), &last.pressure, &self.thresholds);
        let spread = spatial::spread(sites, p, t.contact);
        let above = |limit: f64| Some(1e4 * spatial::area_above(sites, p, limit));
        let whole = self.recording.frames().last().map_or(0.0, |f| f.pressure.iter().sum());
        let share = (whole > 0.0).then(|| 100.0 * p.iter().sum::<f64>() / whole);
        let stress = Some(t.muscle_factor * spatial::peak(p) / 1000.0);
        let mut rows = vec![
            row(place, "peak pressure", Some(spatial::peak(p) / MMHG), "mmHg", Some(t.occlusion / MMHG)),
            row(place, "mean pressure", spread.map(|s| s.mean / MMHG), "mmHg", None),
            row(place, "standard deviation", spread.map(|s| s.deviation / MMHG), "mmHg", None),
            row(place, "coefficient of variation", spread.map(|s| s.variation), "1", None),
            row(place, "contact area", above(t.contact), "cm2", None),
            row(place, "area above 32 mmHg", above(32.0 * MMHG), "cm2", None),
            row(place, "area above 60 mmHg", above(60.0 * MMHG), "cm2", None),
            row(place, "area above 120 mmHg", above(120.0 * MMHG), "cm2", None),
            row(place, "share of all pressures", share, "%", None),
            row(place, "peak stress in muscle", stress, "kPa", Some(Sigmoid::default().floor / 1000.0)),
        ];
        if !last.shear.is_empty() {
            let [x, y] = shear::resultant(sites, &last.shear);
            let slip = shear::slip(last, t.contact, self.friction);
            let equivalent =
                shear::equivalent_pressure(last, t.shear_factor, t.shear_reference).map(|p| p / MMHG);
            rows.push(row(place, "peak pressure of the same risk without shear", equivalent, "mmHg", None));
            rows.push(row(place, "peak shear", Some(shear::peak(&last.shear) / 1000.0), "kPa", None));
            rows.push(row(place, "shear resultant", Some(x.hypot(y)), "N", None));
            rows.push(row(place, "slip index", slip, "1", Some(1.0)));
        }
        rows
    }

    /// Metrics over time.
    fn over_time(&self, place: &'static str, part: &Recording) -> Vec<Row> {
        let t = &self.thresholds;
        let hours = |x: Option<f64>| x.map(|x| x / MMHG / 3600.0);
        let integral = largest(&time::pressure_time(part, 0.0));
        let persistent = |cycle: f64| time::persistent_occlusion(part, cycle, t.occlusion).map(|a| 1e4 * a);
        let contrast = time::contrast(part, t.cycle).and_then(|c| largest(&c)).map(|c| c / MMHG);
        let relief = |limit: f64| mean(&time::relief(part, limit * MMHG)).map(|share| 100.0 * share);
        let muscle = Sigmoid::default().shares(part, t.contact, t.muscle_factor);
        let mut rows = vec![
            row(place, "persistent occlusion, last cycle", persistent(t.cycle), "cm2", None),
            row(place, "persistent occlusion, last 2 h", persistent(7200.0), "cm2", None),
            row(place, "always at risk", Some(1e4 * time::always_at_risk(part, 32.0 * MMHG)), "cm2", None),
            row(place, "load and off-load contrast", contrast, "mmHg", None),
            row(place, "pressure time integral", hours(integral), "mmHg h", Some(300.0)),
            row(
                place,
                "excess over 32 mmHg",
                hours(largest(&time::pressure_time(part, 32.0 * MMHG))),
                "mmHg h",
                None,
            ),
            row(place, "time below 30 mmHg", relief(30.0), "%", None),
            row(place, "time below 20 mmHg", relief(20.0), "%", None),
            row(place, "time below 10 mmHg", relief(10.0), "%", None),
            row(place, "Reswick-Rogers margin", integral.map(tissue::reswick_rogers_margin), "1", Some(0.0)),
            row(place, "share of critical time in muscle", largest(&muscle), "1", Some(1.0)),
            row(place, "tissue dose", largest(&Dose::default().largest(part)), "1", None),
        ];
        if part.frames().iter().any(|f| !f.shear.is_empty()) {
            let kilopascal_hours = largest(&shear::shear_time(part)).map(|x| x / 1000.0 / 3600.0);
            let turned = largest(&shear::turning(part, LEAST_SHEAR)).map(f64::to_degrees);
            rows.push(row(place, "shear time integral", kilopascal_hours, "kPa h", None));
            rows.push(row(place, "turning of the shear", turned, "deg", None));
        }
        // A single frame without duration has no history.
        if part.seconds() <= 0.0 {
            rows.iter_mut().for_each(|row| row.value = None);
        }
        rows
    }
}

fn row(
    place: &'static str,
    metric: &'static str,
    value: Option<f64>,
    unit: &'static str,
    threshold: Option<f64>,
) -> Row {
    Row { place, metric, value, unit, threshold }
}

fn largest(numbers: &[f64]) -> Option<f64> {
    numbers.iter().copied().reduce(f64::max)
}

fn mean(numbers: &[f64]) -> Option<f64> {
    (!numbers.is_empty()).then(|| numbers.iter().sum::<f64>() / numbers.len() as f64)
}
