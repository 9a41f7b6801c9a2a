//! Reads and writes files of pressure maps, in formats that sensor makers' programs export.
//!
//! In: a text. Out: a grid and a recording in SI units, or the line at which the text is wrong. [`tekscan`] is the
//! ASCII movie of Tekscan's programs, [`xsensor`] the blocks of keys and rows that XSENSOR's export.

pub mod tekscan;
mod text;
pub mod xsensor;

pub use text::{FileError, Mapped};

/// Reads a text in either format; Tekscan's begin with `DATA_TYPE` and contain `ASCII_DATA`.
///
/// # Errors
/// [`FileError`] at the first line that is wrong.
pub fn read(text: &str) -> Result<Mapped, FileError> {
    let is_tekscan = text.lines().take(100).any(|line| line.starts_with("ASCII_DATA"));
    if is_tekscan { tekscan::read(text) } else { xsensor::read(text) }
}
