//! A demonstration on a host: the text that the chip sends through semihosting goes to standard output.

use std::io::{Write, stdout};
use std::process::ExitCode;
use std::vec::Vec;

/// Prints what `demonstrate` writes; fails if it reports that a step was refused.
pub fn print(demonstrate: impl FnOnce(&mut Vec<u8>) -> bool) -> ExitCode {
    let mut text = Vec::new();
    let is_done = demonstrate(&mut text);
    let is_written = stdout().write_all(&text).is_ok();
    if is_done && is_written { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
