//! What `smartbed check` has found: facts, and warnings with their places.

use serde_json::Value;
use smartbed_codegen::Diagnostics;

/// Everything that is said about a model.
#[derive(Debug)]
pub(crate) struct Report {
    /// The report as JSON; the text is made from it and from the warnings.
    pub facts: Value,
    /// Warnings with their places.
    pub found: Diagnostics,
    /// Warnings that only numbers gave.
    pub numeric: Vec<String>,
}
