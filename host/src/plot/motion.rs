//! The chart of a mechanism's run: coordinates and outputs, or what `--show` names, in the model's own units;
//! and the energies of the ledger.

use super::chart::{self, Chart, Curve};
use super::drawing::Drawing;
use super::energies;
use super::panels::{self, Shown};
use super::pattern;
use super::{Recording, chart::Panel};
use crate::columns::{of_state, told_apart};
use crate::failure::Failure;
use smartbed_codegen::model::{Coordinate, Model, SpeedMeaning};

/// Runs count as at least so long (s) for the size of a speed.
const SHORTEST: f64 = 1e-3;
/// Columns of the ledger that are drawn.
pub const ENERGIES: [&str; 8] =
    ["kinetic", "gravity", "spring", "damping", "actuator", "external", "drive", "total"];

/// Contents of the chart of a run.
#[derive(Clone, Copy, Debug)]
pub struct Motion<'a> {
    /// The model.
    pub model: &'a Model,
    /// Names of the rows' columns.
    pub names: &'a [String],
    /// The rows.
    pub recording: &'a Recording,
    /// A note on how the run was made.
    pub note: &'a str,
    /// Times at which a coordinate leaves its declared range or returns.
    pub crossings: &'a [f64],
    /// Patterns of `--show`; `None` for coordinates and outputs.
    pub show: Option<&'a str>,
    /// Rounding error of a number of size 1.
    pub noise: f64,
}

/// Draws it.
///
/// # Errors
/// [`Failure::Wrong`] for a pattern that names nothing.
pub fn draw(motion: &Motion<'_>) -> Result<Drawing, Failure> {
    let time = motion.recording.column(0);
    let seconds = time.last().copied().filter(|t| *t > 0.0).unwrap_or(1.0);
    let model = motion.model;
    let columns: Vec<Column> = columns(model, seconds);
    let known: Vec<&str> =
        columns.iter().map(|c| c.name.as_str()).filter(|n| index(motion, n).is_some()).collect();
    let wanted = match motion.show {
        Some(patterns) => pattern::chosen(patterns, &known)?,
        None => columns.iter().filter(|c| c.by_default).map(|c| c.name.as_str()).collect(),
    };
    let shown = columns.iter().filter(|c| wanted.contains(&c.name.as_str()));
    let shown = shown.filter_map(|column| {
        let values = motion.recording.column(index(motion, &column.name)?);
        let values = values.into_iter().map(|x| x / column.factor).collect();
        let curve = Curve { name: column.name.clone(), values, color: None, across: None };
        Some(Shown { curve, unit: column.unit.clone(), natural: column.natural / column.factor })
    });
    let mut panels = panels::of(shown.collect(), motion.noise);
    panels.extend(accounts(motion));
    let title = if model.doc.is_empty() { &model.name } else { &model.doc };
    let note = match motion.crossings {
        [] => motion.note.to_owned(),
        _ => format!("{}; grey: a coordinate leaves its range or returns", motion.note),
    };
    let (note, events) = (note.as_str(), motion.crossings);
    Ok(chart::draw(&Chart { title, note, across: "time [s]", time: &time, panels: &panels, events }))
}

fn index(motion: &Motion<'_>, name: &str) -> Option<usize> {
    motion.names.iter().position(|n| n == name)
}

/// A column of a run that can be drawn.
pub(crate) struct Column {
    pub(crate) name: String,
    /// As the model writes it.
    pub(crate) unit: String,
    /// SI units per such unit.
    pub(crate) factor: f64,
    /// Typical size in SI units; 0 if unknown.
    pub(crate) natural: f64,
    by_default: bool,
}

/// Coordinates, speeds, outputs, inputs.
pub(crate) fn columns(model: &Model, seconds: f64) -> Vec<Column> {
    let natural = |c: &Coordinate| if c.unit == "rad" { 1.0 } else { 0.0 };
    let coordinates = model.coordinates.iter().map(|c| {
        let (unit, factor) = (c.written_unit.0.clone(), c.written_unit.1);
        Column { name: of_state("coordinate", &c.name), unit, factor, natural: natural(c), by_default: true }
    });
    let speeds = model.speeds.iter().map(|s| match &s.meaning {
        // A rate in the unit of its coordinate.
        SpeedMeaning::RateOf(id) => {
            let coordinate = &model.coordinates[*id];
            let (written, factor) = &coordinate.written_unit;
            let unit = if written == "1" { "1/s".to_owned() } else { format!("{written}/s") };
            let natural = natural(coordinate) / seconds.max(SHORTEST);
            Column { name: of_state("speed", &s.name), unit, factor: *factor, natural, by_default: false }
        }
        SpeedMeaning::Combination(_) => plain(&of_state("speed", &s.name), &s.unit, false),
    });
    let (outputs, inputs) = told_apart(model);
    let outputs = outputs.into_iter().zip(model.outputs.iter());
    let outputs = outputs.filter_map(|(name, o)| Some(plain(&name?, &o.unit, true)));
    let inputs = inputs.iter().zip(model.inputs.iter()).map(|(name, i)| plain(name, &i.unit, false));
    coordinates.chain(speeds).chain(outputs).chain(inputs).collect()
}

fn plain(name: &str, unit: &str, by_default: bool) -> Column {
    let natural = if unit == "rad" { 1.0 } else { 0.0 };
    Column { name: name.to_owned(), unit: unit.to_owned(), factor: 1.0, natural, by_default }
}

/// Panels of the ledger's accounts that are not zero.
fn accounts(motion: &Motion<'_>) -> Vec<Panel> {
    let curve = |name: &str| {
        let values = motion.recording.column(index(motion, name)?);
        let told = values.iter().any(|x| *x != 0.0);
        let curve = Curve { name: name.to_owned(), values, color: energies::color(name), across: None };
        told.then(|| Shown { curve, unit: "J".to_owned(), natural: 0.0 })
    };
    panels::of(ENERGIES.into_iter().filter_map(curve).collect(), motion.noise)
}
