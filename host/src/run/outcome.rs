//! The results of a run: its summary, complete rows, a note on how it was made.

use super::arguments::Arguments;
use crate::engine::ScalarKind;
use crate::failure::Failure;
use crate::number::digits;
use crate::output::Output;
use smartbed_codegen::words::count;
use std::fmt::Write as _;

/// The results of a run, apart from its files.
pub(super) struct Outcome {
    /// The summary.
    pub(super) text: String,
    /// The data of the page.
    pub(super) film: Option<String>,
    /// Findings of [`super::health`].
    pub(super) findings: Vec<String>,
}

/// Completes a run that ended early: writes its rows and adds a note to the failure.
pub(super) fn ended_early(failure: Failure, csv: Option<Output>, rows: u64, file: &str) -> Failure {
    let (Some(csv), Failure::Wrong(why)) = (csv, &failure) else { return failure };
    match csv.finish() {
        Ok(()) if file != "-" => {
            Failure::Wrong(format!("{why}; {} up to there in {file}", count(rows, "row")))
        }
        Ok(()) => failure,
        Err(full) => full,
    }
}

/// A note on how a run was made: method and step, the scalar if it is not the usual one, changed settings.
pub(super) fn noted(method: String, arguments: &Arguments) -> String {
    let scalar = (arguments.scalar != ScalarKind::default()).then(|| "f32".to_owned());
    let changed = arguments.set.iter().map(|change| change.replacen('=', " = ", 1));
    std::iter::once(method).chain(scalar).chain(changed).collect::<Vec<_>>().join(", ")
}

pub(super) fn line(values: &[f64]) -> String {
    let mut text = String::with_capacity(24 * values.len());
    for (n, &value) in values.iter().enumerate() {
        let separator = if n == 0 { "" } else { "," };
        let _ = write!(text, "{separator}{}", digits(value));
    }
    text + "\n"
}
