//! The report of `check` as text.

use super::report::Report;
use crate::grouped;
use crate::output::Stream;
use serde_json::Value;
use smartbed_codegen::words::count;
use std::fmt::Write as _;

/// Most rows of a list that are shown without `--all`; a table of units with at most this many is shown whole.
const SHOWN: usize = 12;
const UNITS: usize = 60;

/// Tables and sentences; with `all` nothing is left out.
pub(super) fn render(report: &Report, all: bool) -> String {
    let facts = &report.facts;
    let mut text = String::new();
    let _ = writeln!(text, "{} ({})", word(&facts["model"]), word(&facts["path"]));
    if !word(&facts["doc"]).is_empty() {
        let _ = writeln!(text, "{}", word(&facts["doc"]));
    }
    counts(&facts["counts"], &mut text);
    freedom(facts, all, &mut text);
    pivots(&facts["pivots"], all, &mut text);
    cost(&facts["cost"], &mut text);
    rounding(&facts["rounding"], &mut text);
    units(&facts["units"], all, &mut text);
    let warnings =
        grouped::text(&report.found, Stream::Out, all) + &grouped::lines(&report.numeric, Stream::Out, all);
    if warnings.is_empty() {
        text.push_str("\nno warnings\n");
    } else {
        let _ = write!(text, "\n{warnings}");
    }
    text
}

/// Number of rows shown, and the line about those left out.
fn shown(count: usize, all: bool) -> (usize, String) {
    match count.saturating_sub(SHOWN) {
        more if more > 0 && !all => (SHOWN, format!("and {more} more: --all\n")),
        _ => (count, String::new()),
    }
}

fn word(value: &Value) -> String {
    value
        .as_str()
        .map_or_else(|| if value.is_null() { String::new() } else { value.to_string() }, str::to_owned)
}

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

/// A configuration, coordinate by coordinate.
fn place(value: &Value) -> String {
    list(value).iter().map(word).collect::<Vec<String>>().join(", ")
}

fn counts(counts: &Value, text: &mut String) {
    text.push('\n');
    for (name, n) in counts.as_object().into_iter().flatten() {
        if n.as_u64() != Some(0) {
            let _ = writeln!(text, "{:<26}{:>5}", name.replace('_', " "), n.to_string());
        }
    }
}

fn freedom(facts: &Value, all: bool, text: &mut String) {
    let (dof, rank) = (&facts["dof"], &facts["constraints"]);
    let stated = if dof["stated"].is_null() { "none".to_owned() } else { dof["stated"].to_string() };
    let _ = writeln!(text, "\ndegrees of freedom: {} found, {stated} stated", dof["found"]);
    if rank["largest_rank"].as_u64() != Some(0) {
        let _ = writeln!(
            text,
            "constraints: rank {} among {} at {}",
            rank["rank"],
            count(&rank["speeds"], "speed"),
            count(&rank["samples"], "sample")
        );
        let conditioning = rank["conditioning"].as_f64().unwrap_or(1.0);
        let _ = writeln!(
            text,
            "worst conditioning: the smallest singular value of the constraints is {conditioning:.1e} of the largest, at {}",
            place(&rank["worst_at"])
        );
    }
    let nearest = &facts["nearest_to_singular"];
    if let Some(pivot) = nearest["pivot"].as_f64() {
        let _ = writeln!(
            text,
            "nearest to singular within the ranges: a pivot is {pivot:.2e} of nominal, at {}",
            place(&nearest["at"])
        );
    }
    let speeds = list(&facts["independent_speeds"]);
    let (count, more) = shown(speeds.len(), all);
    for speed in &speeds[..count] {
        let _ = writeln!(
            text,
            "independent: {} = {} ({})",
            word(&speed["name"]),
            word(&speed["meaning"]),
            word(&speed["why"])
        );
    }
    text.push_str(&more);
}

fn pivots(pivots: &Value, all: bool, text: &mut String) {
    if list(pivots).is_empty() {
        return;
    }
    let mut worst_first: Vec<&Value> = list(pivots).iter().collect();
    let number = |pivot: &Value, key: &str| pivot[key].as_f64().unwrap_or(f64::NAN);
    let (count, more) = shown(worst_first.len(), all);
    if !more.is_empty() {
        worst_first.sort_by(|a, b| number(a, "worst").total_cmp(&number(b, "worst")));
    }
    text.push_str("\npivots         nominal  worst/nominal\n");
    for pivot in &worst_first[..count] {
        let (nominal, worst) = (number(pivot, "nominal"), number(pivot, "worst"));
        let _ = writeln!(text, "{nominal:>22.4e} {worst:>14.4}  {}", word(&pivot["expression"]));
    }
    text.push_str(&more);
}

fn cost(cost: &Value, text: &mut String) {
    text.push_str("\nanswer       operations\n");
    for answer in list(cost) {
        let kinds: Vec<String> =
            answer["by_kind"].as_object().into_iter().flatten().map(|(k, n)| format!("{n} {k}")).collect();
        let _ = writeln!(
            text,
            "{:<12} {:>10}  {}",
            word(&answer["answer"]),
            answer["operations"].to_string(),
            kinds.join(", ")
        );
    }
}

fn rounding(rounding: &Value, text: &mut String) {
    if list(rounding).is_empty() {
        return;
    }
    text.push_str("\nrounding in f32, over the output's largest value\n");
    let _ = writeln!(text, "{:<18}{:>10}{:>12}  by rounding", "output", "error", "of it");
    for row in list(rounding) {
        let number = |key: &str| row[key].as_f64().unwrap_or(f64::NAN);
        let (output, error, moves) = (word(&row["output"]), number("error"), number("moves"));
        let _ = writeln!(text, "{output:<18}{error:>10.1e}{moves:>12.1e}  {}", word(&row["operation"]));
    }
}

fn units(units: &Value, all: bool, text: &mut String) {
    let widest = |key: &str| list(units).iter().map(|row| word(&row[key]).chars().count()).max().unwrap_or(0);
    let (kind, name, unit) = (widest("kind"), widest("name"), widest("unit"));
    text.push_str("\nunits (SI, as in tables, plots and states files)\n");
    let is_long = list(units).len() > UNITS && !all;
    let (mut last, mut of_kind) = (String::new(), 0);
    for row in list(units) {
        let this = word(&row["kind"]);
        of_kind = if this == last { of_kind + 1 } else { 1 };
        last = this;
        if is_long && of_kind > SHOWN {
            continue;
        }
        let line = format!(
            "  {:<kind$}  {:<name$}  {:<unit$}  {}",
            word(&row["kind"]),
            word(&row["name"]),
            word(&row["unit"]),
            word(&row["doc"])
        );
        let _ = writeln!(text, "{}", line.trim_end());
    }
    if is_long {
        text.push_str("  of more than 12 of a kind the first: --all shows the rest\n");
    }
}
