//! Rows of metrics as CSV and for people, and where they are written to.

use crate::failure::Failure;
use crate::output;
use smartbed_bed::metrics::report::Row;
use std::fmt::Write as _;
use std::path::Path;

/// Standard output takes what comes; a file appears whole.
pub(super) fn write(file: &str, text: &str) -> Result<(), Failure> {
    if file == "-" { output::print(text) } else { output::replace(Path::new(file), text) }
}

/// Metrics as CSV.
pub(super) fn csv(metrics: &[(&'static str, Vec<Row>)]) -> String {
    let mut text = String::from("sites,place,metric,value,unit,threshold\n");
    let number = |x: Option<f64>| x.map_or_else(String::new, |x| format!("{x}"));
    for (sites, rows) in metrics {
        for row in rows {
            let (value, threshold) = (number(row.value), number(row.threshold));
            // Names of metrics hold a comma.
            let _ =
                writeln!(text, "{sites},{},\"{}\",{value},{},{threshold}", row.place, row.metric, row.unit);
        }
    }
    text
}

/// Metrics for people.
pub(super) fn table(metrics: &[(&'static str, Vec<Row>)]) -> String {
    let mut text = String::new();
    for (sites, rows) in metrics {
        let _ = writeln!(text, "\n{sites}");
        for row in rows {
            let value = row.value.map_or_else(|| "-".to_owned(), |x| format!("{x:.3}"));
            let limit = row.threshold.map_or_else(String::new, |x| format!("  ({x} {})", row.unit));
            let _ = writeln!(text, "  {:12} {:34} {value:>12} {}{limit}", row.place, row.metric, row.unit);
        }
    }
    text
}
