//! Answers by name on the command line.
//!
//! In: what stands behind `--answers`. Out: functions of requests whose names exist. Every `--answers` is one function;
//! what it lists, with commas between, shares what it has in common.

use crate::failure::Failure;
use crate::suggest;
use smartbed_codegen::program::answer::{self, CATALOGUE, Function, Request};

/// One `--answers`, if every name in it is known.
///
/// # Errors
/// The name that is not, with the nearest that is.
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
