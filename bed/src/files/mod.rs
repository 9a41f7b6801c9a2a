//! Files of pressure maps: what sensor makers' programs export, read and written.
//!
//! In: a text. Out: a grid and a recording in SI units, or the line at which the text is wrong. [`tekscan`] is the ASCII
//! movie of Tekscan's programs, [`xsensor`] blocks of keys and rows as XSENSOR's export them.

pub mod tekscan;
mod text;
pub mod xsensor;

pub use text::{FileError, Mapped};

/// Reads a text of either kind: Tekscan's begin with `DATA_TYPE` and have `ASCII_DATA`.
///
/// # Errors
/// [`FileError`] at the first line that is wrong.
pub fn read(text: &str) -> Result<Mapped, FileError> {
    let is_tekscan = text.lines().take(100).any(|line| line.starts_with("ASCII_DATA"));
    if is_tekscan { tekscan::read(text) } else { xsensor::read(text) }
}
