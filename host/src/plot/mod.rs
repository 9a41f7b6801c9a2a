//! Plots of a run: coordinates by unit, and energies, over time; SVG or PNG by the file's name.
//!
//! In: recorded rows. [`panels`] decides which curves share a panel, [`chart`] lays them out as a [`Drawing`] of lines,
//! shapes and words, [`side`] adds pictures from the side; [`svg`] and [`png`] (painted by `tiny-skia` with the letters
//! of [`font`]) write the drawing.

mod axis;
pub mod chart;
pub mod drawing;
pub mod energies;
pub mod font;
pub mod motion;
pub mod panels;
pub mod pattern;
#[cfg(feature = "whole")]
pub mod png;
#[cfg(feature = "whole")]
pub mod side;
pub mod svg;

pub use axis::Axis;

use crate::failure::Failure;
use crate::output;
use drawing::Drawing;

/// Rows kept; beyond twice as many every second one is dropped.
const KEPT: usize = 2000;
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

/// The format by the ending of a file's name.
///
/// # Errors
/// [`Failure::Wrong`] for any other ending.
pub fn format_of(file: &str) -> Result<Format, Failure> {
    let ending = file.rsplit('.').next().map(str::to_ascii_lowercase);
    match ending.as_deref() {
        Some("svg") => Ok(Format::Svg),
        Some("png") => Ok(Format::Png),
        _ => Err(Failure::Wrong(format!("{file}: expected a name that ends in .svg or .png"))),
    }
}

/// Writes a drawing.
///
/// # Errors
/// [`Failure::Wrong`] if the file cannot be written or has another ending.
pub fn write(file: &str, drawing: &Drawing) -> Result<(), Failure> {
    match format_of(file)? {
        Format::Svg => output::write(file, svg::text(drawing).as_bytes()),
        #[cfg(not(feature = "whole"))]
        Format::Png => Err(Failure::not_built("a plot as PNG")),
        #[cfg(feature = "whole")]
        Format::Png => {
            let bytes = png::bytes(drawing).map_err(|e| Failure::Wrong(format!("{file}: {e}")))?;
            output::write(file, &bytes)
        }
    }
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
