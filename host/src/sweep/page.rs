//! The page that compares the cases of a sweep: bars of one metric at a time, and the table.
//!
//! In: the table. Out: self-contained HTML. Names and values are embedded as JSON with `<` escaped, and are inserted
//! into the page as text.

use super::case::Table;
use crate::number::json_string;
use crate::plot::svg::escaped;
use crate::template::filled;
use smartbed_bed::metrics::DISCLAIMER;

const PAGE: &str = include_str!("page.html");

/// The page's text.
pub fn text(plan: &str, table: &Table) -> String {
    let list = |texts: &[String]| {
        let texts: Vec<String> = texts.iter().map(|text| json_string(text)).collect();
        format!("[{}]", texts.join(","))
    };
    let rows: Vec<String> =
        table.rows.iter().map(|[values, numbers]| format!("[{},{}]", list(values), list(numbers))).collect();
    let data = format!(
        "{{\"plan\":{},\"note\":{},\"keys\":{},\"metrics\":{},\"rows\":[{}]}}",
        json_string(plan),
        json_string(DISCLAIMER),
        list(&table.keys),
        list(&table.metrics),
        rows.join(",")
    );
    filled(PAGE, &[("TITLE", escaped(plan)), ("DATA", data.replace('<', "\\u003c"))])
}
