//! The report as Markdown: a summary, then each subject's points, costs on the chip and notes.

use super::point::{Point, Report, Section, Table};
use smartbed_codegen::escape::{markdown, markdown_code};
use std::fmt::Write as _;

/// Errors (m or rad) for which the summary names the cheapest method.
const TARGETS: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-11];

/// The file's text.
#[must_use]
pub fn text(report: &Report) -> String {
    let mut text = format!(
        "# Speed against error\n\n{}; made by {} in {:.0} s; mechanisms by the {}. \
         Costs on the chip: {}.\n\n\
         Errors are the largest of any coordinate (m or rad) at ten times over the simulated time, against the \
         reference named with each subject. Time is computing time per simulated second, without output. The \
         command of a row makes its numbers again. \
         Hard cases and their bounds: docs/hard-cases.md of the repository.\n\n",
        markdown(&report.machine),
        markdown_code(&report.command),
        report.elapsed,
        markdown(&report.engine),
        markdown(&report.chip)
    );
    tables(&mut text, report);
    report.sections.iter().for_each(|s| section_text(&mut text, s));
    text
}

/// The text without the points.
#[must_use]
pub fn results(report: &Report) -> String {
    let mut text = format!(
        "# Speed against error: {}\n\nMade by {} in {:.0} s; mechanisms by the {}. Costs on the chip: {}.\n\
         What the columns mean is told in docs/report.md; all points are in the command's own report.md and \
         report.csv, those of the fronts in the JSON file beside this one.\n\n",
        markdown(&report.machine),
        markdown_code(&report.command),
        report.elapsed,
        markdown(&report.engine),
        markdown(&report.chip)
    );
    tables(&mut text, report);
    text
}

fn tables(text: &mut String, report: &Report) {
    push(text, &summary(report));
    report.tables.iter().for_each(|t| push(text, t));
}

/// The fastest method for a given error, subject by subject.
#[must_use]
pub fn summary(report: &Report) -> Table {
    let mut columns = vec!["subject".to_owned(), "simulated".to_owned(), "reference sure to".to_owned()];
    columns.extend(TARGETS.map(|e| format!("fastest to {e:.0e}")));
    let row = |section: &Section| {
        let mut row = vec![
            section.name.clone(),
            format!("{} of {} s", short(section.seconds), short(section.asked)),
            format!("{:.0e}", section.reference.agreement),
        ];
        row.extend(TARGETS.map(|e| cheapest(section, e).map_or("-".to_owned(), way)));
        row
    };
    let rows = report.sections.iter().map(row).collect();
    Table { title: "The fastest way to an error".to_owned(), columns, rows, command: report.command.clone() }
}

/// The fastest point with at most this error.
fn cheapest(section: &Section, error: f64) -> Option<&Point> {
    let fits = section.points.iter().filter(|p| p.error <= error);
    fits.min_by(|a, b| a.nanoseconds.total_cmp(&b.nanoseconds))
}

fn way(point: &Point) -> String {
    let control = point.control.map_or(String::new(), |c| format!(" {}", c.text()));
    format!("{} {}{control}: {}", point.method, point.scalar, duration(point.nanoseconds))
}

/// Rounded to at most four digits.
#[must_use]
pub fn short(x: f64) -> f64 {
    format!("{x:.3e}").parse().unwrap_or(x)
}

/// Nanoseconds as text with a suitable unit.
#[must_use]
pub fn duration(nanoseconds: f64) -> String {
    let units = [(1e9, "s"), (1e6, "ms"), (1e3, "us"), (1.0, "ns")];
    let (size, unit) = units.into_iter().find(|(size, _)| nanoseconds >= *size).unwrap_or((1.0, "ns"));
    format!("{:.3} {unit}", nanoseconds / size)
}

fn section_text(text: &mut String, section: &Section) {
    let _ = write!(
        text,
        "## {}\n\n{}\n\n{} of {} s simulated. Reference: {}; they agree to {:.1e}.\n\n",
        markdown(&section.name),
        markdown(&section.title),
        short(section.seconds),
        short(section.asked),
        markdown(&section.reference.text),
        section.reference.agreement
    );
    push_rows(text, &points(section));
    if !section.chip.is_empty() {
        push_rows(text, &chip(section));
    }
    section.notes.iter().for_each(|note| {
        let _ = writeln!(text, "- {}", markdown(note));
    });
    text.push('\n');
}

/// A section's points as a table.
#[must_use]
pub fn points(section: &Section) -> Table {
    let columns =
        ["method", "scalar", "step", "error", "evaluations/s", "time per second", "front", "command"];
    let row = |p: &Point| {
        vec![
            p.method.clone(),
            p.scalar.clone(),
            p.control.map_or("-".to_owned(), |c| c.text()),
            error(p.error, section),
            p.evaluations.map_or("-".to_owned(), |e| format!("{e:.0}")),
            duration(p.nanoseconds),
            standing(p).to_owned(),
            format!("`{}`", p.command),
        ]
    };
    Table {
        title: "Points".to_owned(),
        columns: columns.map(str::to_owned).to_vec(),
        rows: section.points.iter().map(row).collect(),
        command: String::new(),
    }
}

/// The error, or the reference's certainty if that is larger.
fn error(error: f64, section: &Section) -> String {
    let sign = if error <= section.reference.certainty() { "<= " } else { "" };
    format!("{sign}{error:.2e}")
}

/// Marks points on the front and those of other simulators.
fn standing(point: &Point) -> &'static str {
    match (point.front, point.is_peer) {
        (true, true) => "front, peer",
        (true, false) => "front",
        (false, true) => "peer",
        (false, false) => "",
    }
}

/// A section's costs on the chip as a table.
#[must_use]
pub fn chip(section: &Section) -> Table {
    let columns =
        ["on the chip, f32", "instructions per step", "cycles by model", "flash", "RAM", "stack", "command"];
    let row = |c: &super::point::ChipCost| {
        vec![
            c.method.clone(),
            c.instructions.to_string(),
            format!("{}..{}", c.cycles[0], c.cycles[1]),
            c.flash.to_string(),
            c.ram.to_string(),
            c.stack.to_string(),
            format!("`{}`", c.command),
        ]
    };
    Table {
        title: "On the chip".to_owned(),
        columns: columns.map(str::to_owned).to_vec(),
        rows: section.chip.iter().map(row).collect(),
        command: String::new(),
    }
}

fn push(text: &mut String, table: &Table) {
    let _ = write!(text, "## {}\n\n", markdown(&table.title));
    push_rows(text, table);
    let _ = write!(text, "By {}.\n\n", markdown_code(&table.command));
}

fn push_rows(text: &mut String, table: &Table) {
    let line = |cells: &[String]| {
        let cells: Vec<String> = cells.iter().map(|text| cell(text)).collect();
        format!("| {} |\n", cells.join(" | "))
    };
    *text += &line(&table.columns);
    *text += &format!("|{}\n", "---|".repeat(table.columns.len()));
    table.rows.iter().for_each(|row| *text += &line(row));
    text.push('\n');
}

/// Escapes a cell. A bar would end the cell even inside code between backticks.
fn cell(text: &str) -> String {
    match text.strip_prefix('`').and_then(|text| text.strip_suffix('`')) {
        Some(code) => markdown_code(code).replace('|', "\\|"),
        None => markdown(text),
    }
}

#[cfg(test)]
mod tests {
    use super::{Table, push};

    #[test]
    fn a_table_holds_what_its_cells_say_and_nothing_else() {
        let cells = ["<script>", "a | b", "x\ny", "`run a|b\n`", "**5**"].map(str::to_owned).to_vec();
        let table = Table {
            title: "[a](b)\n# c".to_owned(),
            columns: vec!["|".to_owned(); 5],
            rows: vec![cells],
            command: "run `x`".to_owned(),
        };
        let mut text = String::new();
        push(&mut text, &table);
        let lines = [
            r"## \[a](b) # c",
            "",
            r"| \| | \| | \| | \| | \| |",
            "|---|---|---|---|---|",
            r"| \<script> | a \| b | x y | `run a\|bU+000A` | \*\*5\*\* |",
            "",
            "By `` run `x` ``.",
            "",
        ];
        assert_eq!(text.lines().collect::<Vec<_>>(), lines);
    }
}
