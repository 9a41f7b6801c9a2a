//! `smartbed report`: speed against error, for every scene and mechanism, method, step and scalar.
//!
//! Subjects ([`subject`]: [`body`], [`mechanism`], [`world`]) get a [`mod@reference`], are run over a ladder of steps
//! ([`plan`], [`measure`]), worlds with contacts also with laws of the other kind (`exchange`), and become points
//! ([`point`]), of which the [`front`] is marked; [`order`]s are observed,
//! costs are measured on the [`chip`] and listed in a [`sheet`], other simulators are compared ([`peers`]): `gather` is
//! all of that in order. The renderings use only points: [`markdown`], [`csv`], [`json`], [`work_precision`] plots, one
//! [`page`]; `files` names and writes them.

mod arguments;
pub mod body;
pub mod chip;
pub mod clock;
pub mod closed_form;
pub mod csv;
mod cuts;
mod exchange;
mod files;
pub mod front;
mod gather;
mod integrate;
pub mod json;
pub mod laws;
pub mod markdown;
pub mod measure;
pub mod mechanism;
pub mod open;
pub mod order;
pub mod page;
pub mod peers;
pub mod pick;
pub mod plan;
pub mod point;
pub mod reference;
pub mod sheet;
mod sheet_body;
mod sheet_mechanism;
mod sheet_table;
pub mod subject;
mod whole;
pub mod work_precision;
pub mod world;
mod world_reference;

pub use arguments::Arguments;
pub use gather::{check_name, section};

use crate::failure::Failure;
use crate::output;
use smartbed_codegen::words::count;
use std::path::Path;

/// Runs the command.
///
/// # Errors
/// Status 1 for a wrong scene, model or setting; status 2 without a compiler for `--engine compiled`.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    files::check(Path::new(&arguments.out))?;
    arguments.results.as_ref().map_or(Ok(()), |folder| files::check(Path::new(folder)))?;
    let report = gather::make(arguments)?;
    files::write(&report, Path::new(&arguments.out))?;
    if let Some(folder) = &arguments.results {
        files::write_results(&report, Path::new(folder))?;
    }
    let text = if arguments.json {
        json::text(&report)
    } else if arguments.is_row() {
        markdown::text(&report)
    } else {
        let points: usize = report.sections.iter().map(|s| s.points.len()).sum();
        let (out, subjects) = (&arguments.out, report.sections.len());
        format!(
            "{}, {}, {:.0} s\nwritten to {out}: report.html, report.md, report.csv, report.json, {}\n",
            count(subjects, "subject"),
            count(points, "point"),
            report.elapsed,
            count(subjects, "plot")
        )
    };
    output::print(&text)
}
