//! All points as CSV: one row per run, its command in the last column.

use super::point::{Control, Report};
use crate::csv::field;
use crate::number::digits;
use std::fmt::Write as _;

/// The file's text.
#[must_use]
pub fn text(report: &Report) -> String {
    let mut text = String::from(
        "subject,seconds,method,scalar,step,tolerance,error,evaluations_per_second,nanoseconds_per_second,front,peer,\
         reference_agreement,command\n",
    );
    for section in &report.sections {
        for p in &section.points {
            let (step, tolerance) = match p.control {
                Some(Control::Step(h)) => (digits(h), String::new()),
                Some(Control::Tolerance(e)) => (String::new(), digits(e)),
                None => Default::default(),
            };
            let evaluations = p.evaluations.map(digits).unwrap_or_default();
            let _ = writeln!(
                text,
                "{},{},{},{},{step},{tolerance},{},{evaluations},{},{},{},{},{}",
                field(&section.name),
                digits(section.seconds),
                field(&p.method),
                field(&p.scalar),
                digits(p.error),
                digits(p.nanoseconds),
                p.front,
                p.is_peer,
                digits(section.reference.agreement),
                field(&p.command)
            );
        }
    }
    text
}
