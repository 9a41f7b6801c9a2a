//! The findings of `smartbed check`: facts, and warnings with their places.

use serde_json::Value;
use smartbed_codegen::Diagnostics;

/// All findings about a model.
#[derive(Debug)]
pub(crate) struct Report {
    /// The report as JSON; the text is made from it and from the warnings.
    pub facts: Value,
    /// Warnings with their places.
    pub found: Diagnostics,
    /// Warnings that follow from numerical results.
    pub numeric: Vec<String>,
}
