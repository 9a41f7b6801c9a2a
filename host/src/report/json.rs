//! The report as JSON, graphs left out; its points can be read back by [`super::point::Extras`].

use super::peers;
use super::point::{ChipCost, Control, Point, Report, Section, Table};
use serde_json::{Value, json};

/// The file's text.
#[must_use]
pub fn text(report: &Report) -> String {
    let points: Vec<Value> =
        report.sections.iter().flat_map(|s| s.points.iter().map(|p| point(&s.name, p))).collect();
    let value = json!({
        "machine": report.machine,
        "command": report.command,
        "engine": report.engine,
        "chip": report.chip,
        "elapsed": report.elapsed,
        "subjects": report.sections.iter().map(section).collect::<Vec<_>>(),
        "points": points,
        "dominating": peers::dominating(report),
        "tables": report.tables.iter().map(table).collect::<Vec<_>>(),
    });
    format!("{value:#}\n")
}

fn section(section: &Section) -> Value {
    json!({
        "name": section.name,
        "title": section.title,
        "seconds": section.seconds,
        "asked": section.asked,
        "reference": { "text": section.reference.text, "agreement": section.reference.agreement },
        "chip": section.chip.iter().map(chip).collect::<Vec<_>>(),
        "notes": section.notes,
    })
}

fn chip(cost: &ChipCost) -> Value {
    json!({
        "method": cost.method,
        "instructions": cost.instructions,
        "cycles": { "low": cost.cycles[0], "high": cost.cycles[1] },
        "flash": cost.flash,
        "ram": cost.ram,
        "stack": cost.stack,
        "command": cost.command,
    })
}

fn point(subject: &str, point: &Point) -> Value {
    let (step, tolerance) = match point.control {
        Some(Control::Step(h)) => (Some(h), None),
        Some(Control::Tolerance(e)) => (None, Some(e)),
        None => (None, None),
    };
    json!({
        "subject": subject,
        "method": point.method,
        "scalar": point.scalar,
        "step": step,
        "tolerance": tolerance,
        "error": point.error,
        "evaluations": point.evaluations,
        "nanoseconds": point.nanoseconds,
        "front": point.front,
        "peer": point.is_peer,
        "command": point.command,
    })
}

fn table(table: &Table) -> Value {
    json!({ "title": table.title, "columns": table.columns, "rows": table.rows, "command": table.command })
}
