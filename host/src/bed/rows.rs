//! Rows of metrics as CSV and as text, and how they are written.

use crate::failure::Failure;
use crate::number::{json_number_or_word, json_string};
use crate::output;
use smartbed_bed::metrics::report::Row;
use std::fmt::Write as _;
use std::path::Path;

/// Writes to standard output directly, or to a file, which appears only when complete.
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
            // Some names of metrics contain a comma.
            let _ =
                writeln!(text, "{sites},{},\"{}\",{value},{},{threshold}", row.place, row.metric, row.unit);
        }
    }
    text
}

/// Metrics as keys of a JSON object, each with the list of its rows.
pub(super) fn json(metrics: &[(&'static str, Vec<Row>)]) -> Vec<String> {
    let null = |x: Option<f64>| x.map_or_else(|| "null".to_owned(), json_number_or_word);
    let row = |row: &Row| {
        format!(
            "{{\"place\": {}, \"metric\": {}, \"value\": {}, \"unit\": {}, \"threshold\": {}}}",
            json_string(row.place),
            json_string(row.metric),
            null(row.value),
            json_string(row.unit),
            null(row.threshold)
        )
    };
    let list = |(sites, rows): &(&'static str, Vec<Row>)| {
        let rows: Vec<String> = rows.iter().map(row).collect();
        format!("\"{sites}\": [{}]", rows.join(", "))
    };
    metrics.iter().map(list).collect()
}

/// Metrics as a table of text.
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
