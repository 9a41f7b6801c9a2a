//! The report as one self-contained HTML page with all plots, graphs and tables.

use super::markdown;
use super::point::{Point, Report, Section, Table};
use super::work_precision::{COSTS, Layer, Plot, plot};
use crate::plot::svg::{self, escaped};
use crate::template::filled;
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
    filled(PAGE, &[("LINKS", links), ("HEAD", head), ("SECTIONS", sections)])
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
    text += "<p class=\"filter\"></p>\n";
    for plot in COSTS.into_iter().filter_map(|cost| plot(section, cost)) {
        let _ = writeln!(text, "<div class=\"plot\">{}</div>", drawn(&plot));
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

/// A plot in which methods can be hidden, and every point shows its numbers and its command.
fn drawn(plot: &Plot<'_>) -> String {
    let base = svg::text(&plot.base);
    let mut text = base.trim_end().strip_suffix("</svg>").unwrap_or(&base).to_owned();
    for Layer { method, scalar, items, places } in &plot.layers {
        let is_peer = places.iter().any(|(_, point)| point.is_peer);
        let _ = writeln!(
            text,
            "<g data-method=\"{}\" data-scalar=\"{}\" data-peer=\"{is_peer}\">",
            escaped(method),
            escaped(scalar)
        );
        text += &svg::items(items);
        for ((x, y), point) in places {
            let _ = writeln!(
                text,
                "<circle class=\"at\" cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"7\" data-tip=\"{}\" data-command=\"{}\"/>",
                escaped(&tip(point)),
                escaped(&point.command)
            );
        }
        text += "</g>\n";
    }
    text + "</svg>\n"
}

/// The text that a point shows.
fn tip(point: &Point) -> String {
    let control = point.control.map_or_else(String::new, |control| format!(", {}", control.text()));
    let evaluations = point.evaluations.map_or_else(String::new, |e| format!(", {e:.0} evaluations/s"));
    let front = if point.front { "; on the front" } else { "" };
    format!(
        "{} {}{control}: error {:.2e}, {} per simulated second{evaluations}{front}",
        point.method,
        point.scalar,
        point.error,
        markdown::duration(point.nanoseconds)
    )
}

fn table(table: &Table) -> String {
    let mut text = format!("<h3>{}</h3>\n<table>\n<tr>", escaped(&table.title));
    // Names of methods may wrap, so that a table with all of them is no wider than the page.
    let heads = table.columns.iter().map(|c| unbroken(c).replace('_', "_<wbr>"));
    heads.for_each(|head| text += &format!("<th>{head}</th>"));
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

/// Marks up text between backticks as code.
fn code(cell: &str) -> String {
    match cell.strip_prefix('`').and_then(|c| c.strip_suffix('`')) {
        Some(inner) => format!("<code>{}</code>", escaped(inner)),
        None => unbroken(cell),
    }
}

/// A cell that wraps only between words, never between a number and its unit; browsers would also wrap `1e-6` at its
/// sign.
fn unbroken(cell: &str) -> String {
    let mut text = String::new();
    for word in cell.split(' ') {
        let follows_number =
            text.ends_with(|c: char| c.is_ascii_digit()) && word.starts_with(char::is_alphabetic);
        if !text.is_empty() {
            text += if follows_number { "\u{a0}" } else { " " };
        }
        text += &escaped(word).replace('-', "-\u{2060}");
    }
    text
}
