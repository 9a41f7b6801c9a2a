//! The reasons why a command can fail, with its exit status.

use smartbed_codegen::Diagnostics;
use std::fmt;

/// A failure with the exit status of the command.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Failure {
    /// A model has errors, with their places: exit status 1.
    Found(Box<Diagnostics>),
    /// The input, or a result computed from it, is wrong: exit status 1.
    Wrong(String),
    /// The machine lacks something; the text names the command that installs it: exit status 2.
    Lacking(String),
}

impl Failure {
    /// The failure for a request that needs the feature `whole`, in a program built without it.
    #[cfg(not(feature = "whole"))]
    #[must_use]
    pub fn not_built(what: &str) -> Self {
        Self::Lacking(format!(
            "{what}: this program was built without it; `cargo build --release -p smartbed` makes one that has it"
        ))
    }

    /// Exit status.
    #[must_use]
    pub fn status(&self) -> u8 {
        match self {
            Self::Found(_) | Self::Wrong(_) => 1,
            Self::Lacking(_) => 2,
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            // The caller that prints a failure adds `error: `.
            Self::Found(found) => {
                let text = found.to_string();
                let text = text.trim_end();
                f.write_str(text.strip_prefix("error: ").unwrap_or(text))
            }
            Self::Wrong(text) | Self::Lacking(text) => f.write_str(text),
        }
    }
}

impl std::error::Error for Failure {}

/// The words of a failure, for callers that have no places to show.
impl From<Failure> for String {
    fn from(failure: Failure) -> Self {
        failure.to_string()
    }
}

/// A wrong input.
impl From<String> for Failure {
    fn from(text: String) -> Self {
        Self::Wrong(text)
    }
}
