//! The report as one HTML page without anything from outside: every plot, every graph, every table.

use super::markdown;
use super::point::{Report, Section, Table};
use super::work_precision::{COSTS, draw};
use crate::plot::svg::{self, escaped};
use std::fmt::Write as _;

const PAGE: &str = include_str!("page.html");

/// The page's text.
#[must_use]
pub fn text(report: &Report) -> String {
    let head = format!(
        "{}; made by <code>{}</code> in {:.0} s; mechanisms by the {}. Costs on the chip: {}.",
        escaped(&report.machine),
        escaped(&report.command),
        report.elapsed,
        escaped(&report.engine),
        escaped(&report.chip)
    );
    let mut links = String::from("<a href=\"#summary\">summary</a>\n");
    let mut sections = format!("<section id=\"summary\">\n{}", table(&markdown::summary(report)));
    report.tables.iter().for_each(|t| sections += &table(t));
    sections += "</section>\n";
    for section in &report.sections {
        let name = escaped(&section.name);
        let _ = writeln!(links, "<a href=\"#{name}\">{name}</a>");
        sections += &section_text(section);
    }
    // Each part once, in the page's order: what a part says is not looked through for the next.
    let (before, rest) = PAGE.split_once("LINKS").unwrap_or((PAGE, ""));
    let (between, rest) = rest.split_once("HEAD").unwrap_or((rest, ""));
    let (then, after) = rest.split_once("SECTIONS").unwrap_or((rest, ""));
    [before, &links, between, &head, then, &sections, after].concat()
}

fn section_text(section: &Section) -> String {
    let mut text = format!(
        "<section id=\"{0}\">\n<h2>{0}</h2>\n<p>{1}. {2} of {3} s simulated. Reference: {4}; they agree to {5:.1e}.</p>\n",
        escaped(&section.name),
        escaped(&section.title),
        markdown::short(section.seconds),
        markdown::short(section.asked),
        escaped(&section.reference.text),
        section.reference.agreement
    );
    for drawing in COSTS.into_iter().filter_map(|cost| draw(section, cost)) {
        let _ = writeln!(text, "<div class=\"plot\">{}</div>", svg::text(&drawing));
    }
    if !section.graph.is_empty() {
        let _ = writeln!(text, "<h3>Motion and energies at its own settings</h3>");
        let _ = writeln!(text, "<div class=\"plot wide\">{}</div>", section.graph);
    }
    if !section.chip.is_empty() {
        text += &table(&markdown::chip(section));
    }
    text += &table(&markdown::points(section));
    for note in &section.notes {
        let _ = writeln!(text, "<p class=\"note\">{}</p>", escaped(note));
    }
    text + "</section>\n"
}

fn table(table: &Table) -> String {
    let mut text = format!("<h3>{}</h3>\n<table>\n<tr>", escaped(&table.title));
    table.columns.iter().for_each(|c| text += &format!("<th>{}</th>", escaped(c)));
    text += "</tr>\n";
    for row in &table.rows {
        let standing = row.iter().find(|cell| ["front", "peer", "front, peer"].contains(&cell.as_str()));
        let class = standing.map(|s| format!(" class=\"{}\"", s.replace(',', ""))).unwrap_or_default();
        text += &format!("<tr{class}>");
        row.iter().for_each(|cell| text += &format!("<td>{}</td>", code(cell)));
        text += "</tr>\n";
    }
    text += "</table>\n";
    if !table.command.is_empty() {
        let _ = writeln!(text, "<p>By <code>{}</code>.</p>", escaped(&table.command));
    }
    text
}

/// What stands between back ticks is code.
fn code(cell: &str) -> String {
    match cell.strip_prefix('`').and_then(|c| c.strip_suffix('`')) {
        Some(inner) => format!("<code>{}</code>", escaped(inner)),
        None => escaped(cell),
    }
}
