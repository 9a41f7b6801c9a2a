//! Parts common to both formats: numbers with units, rows, and errors with their line.

use crate::map::{Frame, Grid, MMHG, Recording};
use std::fmt;

/// Largest number of values in a file.
const MOST: usize = 100_000_000;

/// A recording with its grid.
#[derive(Clone, Debug, PartialEq)]
pub struct Mapped {
    /// Positions of the sensels.
    pub grid: Grid,
    /// Their readings.
    pub recording: Recording,
}

/// An error in a text, with its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileError {
    /// Line, from 1; 0 for the text as a whole.
    pub line: usize,
    /// What is wrong and what was expected.
    pub message: String,
}

impl FileError {
    pub(super) fn at(line: usize, message: impl Into<String>) -> FileError {
        FileError { line, message: message.into() }
    }
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            0 => f.write_str(&self.message),
            line => write!(f, "line {line}: {}", self.message),
        }
    }
}

impl std::error::Error for FileError {}

/// The value of a unit of pressure in Pascal.
pub(super) fn pascal(unit: &str, line: usize) -> Result<f64, FileError> {
    match unit.trim().to_ascii_lowercase().as_str() {
        "kpa" => Ok(1000.0),
        "pa" => Ok(1.0),
        "mmhg" => Ok(MMHG),
        "psi" => Ok(6_894.757_293_168),
        "n/cm2" | "n/cm^2" => Ok(1e4),
        _ => Err(FileError::at(
            line,
            format!("unit of pressure `{unit}`: expected kPa, Pa, mmHg, PSI or N/cm2"),
        )),
    }
}

/// A length with unit, such as `10.16 mm` or `0.4"`, in metres.
pub(super) fn metres(text: &str, line: usize) -> Result<f64, FileError> {
    let text = text.trim();
    let is_unit = |c: char| c == '"' || c.is_alphabetic() && !matches!(c, 'e' | 'E');
    let split = text.find(is_unit).unwrap_or(text.len());
    let scale = match text[split..].trim().to_ascii_lowercase().as_str() {
        "mm" => 1e-3,
        "cm" => 1e-2,
        "m" => 1.0,
        "in" | "inch" | "inches" | "\"" => 0.0254,
        "" => {
            let what = format!(
                "`{}` has no unit of length: expected mm, cm, m or in, as in `10 mm`",
                shortened(text)
            );
            return Err(FileError::at(line, what));
        }
        other => {
            return Err(FileError::at(line, format!("unit of length `{other}`: expected mm, cm, m or in")));
        }
    };
    let length = number(&text[..split], line)? * scale;
    if length > 0.0 {
        Ok(length)
    } else {
        Err(FileError::at(line, format!("expected a length > 0, found `{text}`")))
    }
}

/// A finite number.
pub(super) fn number(text: &str, line: usize) -> Result<f64, FileError> {
    let value = text.trim().parse::<f64>().ok().filter(|x| x.is_finite());
    value.ok_or_else(|| FileError::at(line, format!("expected a number, found `{}`", shortened(text))))
}

/// A duration.
pub(super) fn seconds(text: &str, line: usize) -> Result<f64, FileError> {
    let value = number(text, line)?;
    if value >= 0.0 {
        return Ok(value);
    }
    Err(FileError::at(line, format!("expected seconds >= 0, found `{}`", text.trim())))
}

/// A count of at least 1.
pub(super) fn count(text: &str, line: usize) -> Result<usize, FileError> {
    let value = text.trim().parse::<usize>().ok().filter(|n| (1..=MOST).contains(n));
    value.ok_or_else(|| FileError::at(line, format!("expected a count from 1, found `{}`", shortened(text))))
}

/// A text shortened for a message.
fn shortened(text: &str) -> String {
    let mut short: String = text.trim().chars().take(40).collect();
    if text.trim().chars().count() > 40 {
        short.push_str("...");
    }
    short
}

/// One row of pressures, separated by commas.
pub(super) fn row(
    text: &str,
    columns: usize,
    unit: f64,
    line: usize,
    into: &mut Vec<f64>,
) -> Result<(), FileError> {
    let before = into.len();
    let trimmed = text.trim().trim_end_matches(',');
    for value in trimmed.split(',') {
        let pressure = number(value, line)? * unit;
        if pressure < 0.0 {
            return Err(FileError::at(line, format!("expected a pressure >= 0, found `{}`", value.trim())));
        }
        into.push(pressure);
        if into.len() > MOST {
            return Err(FileError::at(line, format!("more than {MOST} values; split the file")));
        }
    }
    let found = into.len() - before;
    if found == columns {
        return Ok(());
    }
    Err(FileError::at(line, format!("{found} values, expected {columns}, one for each column")))
}

/// A row as text: values in a unit, with as many digits as are needed to read back the same number.
pub(super) fn row_text(pressures: &[f64], unit: f64) -> String {
    let values: Vec<String> = pressures.iter().map(|p| format!("{}", p / unit)).collect();
    values.join(",")
}

/// Makes a map of the frames that were read.
pub(super) fn mapped(grid: Grid, frames: Vec<Frame>) -> Result<Mapped, FileError> {
    let recording = Recording::new(grid.all(), frames).map_err(|e| FileError::at(0, e.to_string()))?;
    Ok(Mapped { grid, recording })
}
