//! Plots of a run: coordinates by unit, and energies, over time; SVG or PNG by the file's name.
//!
//! In: recorded rows. Out: a [`Drawing`] of lines and words ([`chart`]), which [`svg`] and [`png`] write.

pub mod chart;
pub mod drawing;
pub mod png;
pub mod svg;

use crate::failure::Failure;
use crate::output;
use chart::{Curve, Panel};
use drawing::Drawing;
use smartbed_codegen::Program;

/// Rows kept; beyond twice as many every second one is dropped.
const KEPT: usize = 2000;
/// Curves in one panel that a reader can tell apart.
const CURVES: usize = 8;

/// Rows for a plot, thinned out as they become many.
#[derive(Clone, Debug)]
pub struct Recording {
    columns: Vec<Vec<f64>>,
    stride: usize,
    seen: usize,
}

impl Recording {
    /// For rows of `n` numbers.
    #[must_use]
    pub fn new(n: usize) -> Self {
        Self { columns: vec![Vec::new(); n], stride: 1, seen: 0 }
    }

    /// Records a row.
    pub fn push(&mut self, row: &[f64]) {
        if self.seen.is_multiple_of(self.stride) {
            self.columns.iter_mut().zip(row).for_each(|(column, x)| column.push(*x));
        }
        self.seen += 1;
        if self.columns.first().is_some_and(|c| c.len() > 2 * KEPT) {
            self.stride *= 2;
            for column in &mut self.columns {
                let mut n = 0;
                column.retain(|_| {
                    n += 1;
                    n % 2 == 1
                });
            }
        }
    }

    /// Values of one column.
    #[must_use]
    pub fn column(&self, index: usize) -> Vec<f64> {
        self.columns.get(index).cloned().unwrap_or_default()
    }
}

/// Formats of pictures.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Format {
    /// Lines and words.
    Svg,
    /// Pixels.
    Png,
}

/// The format that a file's name asks for.
///
/// # Errors
/// [`Failure::Wrong`] for any other ending.
pub fn format_of(file: &str) -> Result<Format, Failure> {
    let ending = file.rsplit('.').next().map(str::to_ascii_lowercase);
    match ending.as_deref() {
        Some("svg") => Ok(Format::Svg),
        Some("png") => Ok(Format::Png),
        _ => Err(Failure::Wrong(format!("--plot {file}: expected a name that ends in .svg or .png"))),
    }
}

/// Writes a drawing.
///
/// # Errors
/// [`Failure::Wrong`] if the file cannot be written or has another ending.
pub fn write(file: &str, drawing: &Drawing) -> Result<(), Failure> {
    match format_of(file)? {
        Format::Svg => output::write(file, svg::text(drawing).as_bytes()),
        Format::Png => output::write(file, &png::bytes(drawing)),
    }
}

/// Coordinates and outputs by unit, and the energies of the ledger; `more` are the names and units of what is
/// no state, `names` the columns of the recording.
#[must_use]
pub fn motion(
    program: &Program,
    more: &[(String, String)],
    names: &[String],
    recording: &Recording,
) -> Drawing {
    let curve = |name: &str| {
        let index = names.iter().position(|n| n == name)?;
        Some(Curve { name: name.to_owned(), values: recording.column(index), color: None, across: None })
    };
    let mut panels: Vec<Panel> = Vec::new();
    let states = program.q.iter().map(|q| (q.name.as_str(), q.unit.as_str()));
    for (name, unit) in states.chain(more.iter().map(|(name, unit)| (name.as_str(), unit.as_str()))) {
        let label = match unit {
            "rad" => "angle [rad]".to_owned(),
            "m" => "length [m]".to_owned(),
            "" | "1" => "number [1]".to_owned(),
            "m/s" => "speed [m/s]".to_owned(),
            "rad/s" => "rate [rad/s]".to_owned(),
            "N" => "force [N]".to_owned(),
            "N m" => "torque [N m]".to_owned(),
            unit => format!("[{unit}]"),
        };
        let Some(curve) = curve(name) else { continue };
        match panels.iter_mut().find(|p| p.label == label && p.curves.len() < CURVES) {
            Some(panel) => panel.curves.push(curve),
            None => panels.push(Panel { label, curves: vec![curve] }),
        }
    }
    let energies = ["kinetic", "gravity", "spring", "damping", "actuator", "external", "drive", "total"];
    let curves: Vec<Curve> = energies.into_iter().filter_map(curve).collect();
    // An account that nothing was booked to tells nothing.
    let curves: Vec<Curve> = curves.into_iter().filter(|c| c.values.iter().any(|x| *x != 0.0)).collect();
    if !curves.is_empty() {
        panels.push(Panel { label: "energy [J]".to_owned(), curves });
    }
    let title = if program.doc.is_empty() { &program.name } else { &program.doc };
    chart::draw(title, "time [s]", &recording.column(0), &panels)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_recording_stays_short() {
        let mut recording = Recording::new(2);
        for n in 0..100_000 {
            recording.push(&[f64::from(n), 0.0]);
        }
        let t = recording.column(0);
        assert!(t.len() > KEPT && t.len() <= 2 * KEPT, "{}", t.len());
        assert!(t.windows(2).all(|w| w[1] - w[0] == t[1] - t[0]), "equal intervals");
    }

    #[test]
    fn formats() {
        assert_eq!(format_of("a.b.SVG"), Ok(Format::Svg));
        assert!(format_of("plot.pdf").is_err());
    }
}
