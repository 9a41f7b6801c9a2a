//! Parses the option `--answers`.
//!
//! In: the text after each `--answers`. Out: functions of requests whose names exist. Each `--answers` becomes one
//! function; the answers that it lists, separated by commas, share sub-expressions.

use crate::failure::Failure;
use crate::suggest;
use smartbed_codegen::program::answer::{self, CATALOGUE, Function, Request};

/// Checks one `--answers`: every name in it must exist.
///
/// # Errors
/// The first unknown name, with the most similar known one.
pub fn entry(text: &str) -> Result<String, String> {
    let function = Function::parse(text, 0)?;
    for Request { answer, .. } in &function.requests {
        if answer::find(answer).is_none_or(|kind| kind.name == "augmented") {
            let names = CATALOGUE.iter().map(|kind| kind.name).filter(|name| *name != "augmented");
            return Err(format!("no such answer{}", suggest::help(answer, names)));
        }
    }
    Ok(text.to_owned())
}

/// The functions of all `--answers`.
///
/// # Errors
/// An entry that [`entry`] refuses.
pub fn functions(entries: &[String]) -> Result<Vec<Function>, Failure> {
    let read = |(place, text): (usize, &String)| Function::parse(text, place).map_err(Failure::Wrong);
    entries.iter().enumerate().map(read).collect()
}
