//! `--accounts`: the accounts of parts and seams of a world, row by row, and what the summary says of them.

use super::outcome::line;
use crate::csv;
use crate::failure::Failure;
use crate::number::{json_object, worst};
use crate::output::{self, Output};
use crate::world::engine::Engine;
use std::fmt::Write as _;

/// Accounts that are written while a world runs.
pub(super) struct Rows {
    csv: Output,
    /// Stored energy of each part at the start (J); empty before the first row.
    start: Vec<f64>,
    /// The last row by column.
    last: Vec<(String, f64)>,
    /// The largest imbalance so far (J), and whose it is.
    imbalance: f64,
    of: String,
}

impl Rows {
    /// Opens the file and, before it, the accounts.
    ///
    /// # Errors
    /// If it cannot be created, or if `csv` goes to standard output too.
    pub(super) fn open(file: &str, csv: Option<&str>, engine: &mut dyn Engine) -> Result<Rows, Failure> {
        output::one_in_standard_output(&[("--accounts -", file == "-"), ("--csv -", csv == Some("-"))])?;
        engine.keep_accounts();
        let csv = Output::open(file)?;
        Ok(Rows { csv, start: Vec::new(), last: Vec::new(), imbalance: 0.0, of: String::new() })
    }

    /// Writes a row.
    ///
    /// # Errors
    /// The engine's, or if it cannot be written.
    pub(super) fn push(&mut self, t: f64, engine: &mut dyn Engine) -> Result<(), Failure> {
        let is_first = self.last.is_empty();
        let accounts = engine.accounts().map_err(Failure::Wrong)?;
        if is_first {
            self.start = accounts.totals();
        }
        self.last = accounts.columns(&self.start);
        if is_first {
            let names = self.last.iter().map(|(name, _)| name.as_str());
            let names: Vec<&str> = std::iter::once("t").chain(names).collect();
            self.csv.write(&csv::header(&names))?;
        }
        if let Some((name, imbalance)) = accounts.worst(&self.start)
            && worst(self.imbalance, imbalance) != self.imbalance
        {
            self.imbalance = worst(self.imbalance, imbalance);
            name.clone_into(&mut self.of);
        }
        let values: Vec<f64> = std::iter::once(t).chain(self.last.iter().map(|(_, value)| *value)).collect();
        self.csv.write(&line(&values))
    }

    /// Completes the file; returns what the run reports.
    ///
    /// # Errors
    /// If it cannot be written.
    pub(super) fn finish(self) -> Result<Closed, Failure> {
        let Rows { csv, last, imbalance, of, .. } = self;
        csv.finish()?;
        Ok(Closed { last, imbalance, of })
    }
}

/// Accounts at the end of a run.
pub(super) struct Closed {
    last: Vec<(String, f64)>,
    imbalance: f64,
    of: String,
}

impl Closed {
    /// A line of the summary.
    pub(super) fn text(&self) -> String {
        let mut text = String::new();
        if self.of.is_empty() {
            let _ = writeln!(text, "accounts of parts and seams: every one closes exactly");
        } else {
            let _ = writeln!(
                text,
                "accounts of parts and seams: largest imbalance {:.1e} J, that of `{}`",
                self.imbalance, self.of
            );
        }
        text
    }

    /// The last row.
    pub(super) fn json(&self) -> String {
        json_object(self.last.iter().map(|(name, value)| (name.as_str(), *value)))
    }
}
