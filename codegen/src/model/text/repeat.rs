//! Repeated sub-assemblies: `[repeat.<name>]` is written once and copied for each entry of `each`.
//!
//! In: the document. Out: [`Sections`]: for each section of the language its entries in order, with every
//! `{placeholder}` in keys and strings replaced by the entry's text.

use std::collections::BTreeMap;

use super::document::{Key, Table, Text, Value, wrong_kind};
use super::scope::suggestion;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::source::Span;

/// The entries of every section after repetition, in the author's order.
#[derive(Debug, Default)]
pub struct Sections {
    /// Section (dotted for sub-tables, such as `constraints.motion`) -> its entries.
    pub tables: BTreeMap<String, Vec<(Key, Value)>>,
    /// Top-level values that are no tables.
    pub scalars: Vec<(Key, Value)>,
    /// `[[configurations]]`.
    pub configurations: Vec<Table>,
    /// Does the author close loops or give closed forms? Coordinates are then dependent unless they say otherwise.
    pub constrained: bool,
    /// Does the author state motion constraints?
    pub restricted: bool,
}

impl Sections {
    /// Records which constraints the author states, before joints add theirs and mark the dependent coordinates
    /// themselves.
    pub fn note_constraints(&mut self) {
        let entries = |section: &str| self.tables.get(section).map_or(&[][..], Vec::as_slice);
        let has = |section: &str, field: &str| {
            entries(section).iter().any(|(_, v)| matches!(v, Value::Table(t) if t.get(field).is_some()))
        };
        self.constrained = !entries("constraints.configuration").is_empty()
            || has("points", "closures")
            || has("coordinates", "closed_form");
        self.restricted = !entries("constraints.motion").is_empty();
    }
}

/// Sections that are tables of named entries.
pub const SECTIONS: [&str; 21] = [
    "parameters",
    "joints",
    "coordinates",
    "speeds",
    "inputs",
    "definitions",
    "frames",
    "points",
    "bodies",
    "constraints.configuration",
    "constraints.motion",
    "forces",
    "torques",
    "springs",
    "ports",
    "outputs",
    "start",
    "law",
    "commanded",
    "view.shapes",
    "view.colours",
];

/// At most this many entries in all sections together.
const MOST_ENTRIES: usize = 10_000;

/// At most this many copies of sub-assemblies in one model.
const MOST_COPIES: usize = 1000;

/// Expands repetition.
pub fn expand(document: Table, found: &mut Diagnostics) -> Sections {
    // All repeats share one table; each takes the place where it is written.
    let mut items: Vec<(Key, Value, bool)> = Vec::new();
    for (key, value) in document.entries {
        match (key.name.as_str(), value) {
            ("repeat", Value::Table(repeats)) => {
                items.extend(repeats.entries.into_iter().map(|(key, value)| (key, value, true)));
            }
            (_, value) => items.push((key, value, false)),
        }
    }
    items.sort_by_key(|(key, ..)| (key.span.file, key.span.start));
    let mut sections = Sections::default();
    for (key, value, repeated) in items {
        match repeated {
            true => repeat(&key, &value, &mut sections, found),
            false => add(&key, value, &mut sections, found),
        }
    }
    limit(&mut sections, document.span, found);
    sections
}

/// Refuses a text with more entries than any mechanism of this kind has.
pub fn limit(sections: &mut Sections, place: Span, found: &mut Diagnostics) {
    let entries: usize = sections.tables.values().map(Vec::len).sum();
    if MOST_ENTRIES < entries {
        found.push(
            Diagnostic::error(format!("{entries} entries; at most {MOST_ENTRIES} are allowed"))
                .label(place, "this model is too large")
                .help("a mechanism of this size needs a numeric multibody program, not symbolic equations"),
        );
        sections.tables.clear();
    }
}

/// Puts one top-level entry into its section.
fn add(key: &Key, value: Value, sections: &mut Sections, found: &mut Diagnostics) {
    match (key.name.as_str(), value) {
        ("constraints", Value::Table(table)) => {
            for (sub, value) in table.entries {
                let name = format!("constraints.{}", sub.name);
                add_section(&name, &sub, value, sections, found);
            }
        }
        // Sub-tables of `[view]` are sections; its other entries are fields.
        ("view", Value::Table(table)) => {
            for (sub, value) in table.entries {
                match value {
                    Value::Table(_) => {
                        add_section(&format!("view.{}", sub.name), &sub, value, sections, found);
                    }
                    value => sections.tables.entry("view".to_owned()).or_default().push((sub, value)),
                }
            }
        }
        ("configurations", Value::Array(items, _)) => {
            for item in items {
                match item {
                    Value::Table(table) => sections.configurations.push(table),
                    other => found.push(wrong_kind("configuration", "a table", &other)),
                }
            }
        }
        (name, value @ Value::Table(_)) => add_section(name, key, value, sections, found),
        (_, value) => sections.scalars.push((key.clone(), value)),
    }
}

fn add_section(name: &str, key: &Key, value: Value, sections: &mut Sections, found: &mut Diagnostics) {
    if !SECTIONS.contains(&name) && name != "run" {
        let last = |s: &'static str| s.rsplit('.').next().unwrap_or(s);
        let known = SECTIONS.iter().map(|s| last(s)).chain([
            "run",
            "view",
            "repeat",
            "configurations",
            "constraints",
        ]);
        found.push(
            Diagnostic::error(format!("unknown section `{name}`"))
                .label(key.span, "no section of a model has this name")
                .help(suggestion(&key.name, known).unwrap_or_else(|| {
                    match name.starts_with("constraints.") {
                        true => "equations between coordinates stand in [constraints.configuration], \
                             between speeds in [constraints.motion]"
                            .to_owned(),
                        false => format!("sections are {}", SECTIONS.join(", ")),
                    }
                })),
        );
        return;
    }
    match value {
        Value::Table(table) => sections.tables.entry(name.to_owned()).or_default().extend(table.entries),
        other => found.push(wrong_kind(name, "a table", &other)),
    }
}

/// The placeholders of one copy: name and text.
type Copy = Vec<(String, String)>;

fn repeat(name: &Key, body: &Value, sections: &mut Sections, found: &mut Diagnostics) {
    let Value::Table(body) = body else { return found.push(wrong_kind(&name.name, "a table", body)) };
    let Some(Value::Array(each, each_span)) = body.get("each") else {
        return found.push(
            Diagnostic::error(format!("repeat `{}` has no list `each`", name.name))
                .label(name.span, "`each` is missing or no array")
                .help("write each = [{ leg = \"A\" }, { leg = \"B\" }]: one copy per entry"),
        );
    };
    if MOST_COPIES < each.len() {
        return found.push(
            Diagnostic::error(format!("{} copies; at most {MOST_COPIES} are allowed", each.len()))
                .label(*each_span, "too many entries"),
        );
    }
    for entry in each {
        let Some(copy) = placeholders(entry, found) else { continue };
        for (key, value) in body.entries.iter().filter(|(key, _)| key.name != "each") {
            match value {
                Value::Table(_) | Value::Array(..) => {
                    add(key, substitute(value, &copy, found), sections, found);
                }
                other => {
                    let expected =
                        "a section with entries to repeat; what is of the whole model stands outside";
                    found.push(wrong_kind(&key.name, expected, other));
                }
            }
        }
    }
}

fn placeholders(entry: &Value, found: &mut Diagnostics) -> Option<Copy> {
    let Value::Table(table) = entry else {
        found.push(
            Diagnostic::error("a copy is described by a table of placeholders")
                .label(entry.span(), format!("this is {}", entry.kind()))
                .help("each = [{ leg = \"A\" }, { leg = \"B\" }]; {leg} then stands for A, then for B"),
        );
        return None;
    };
    let mut copy = Copy::new();
    for (key, value) in &table.entries {
        match value {
            Value::Text(text) => copy.push((key.name.clone(), text.text.clone())),
            Value::Number(number, _) => copy.push((key.name.clone(), format!("{number}"))),
            other => found.push(wrong_kind(&key.name, "a string or a number", other)),
        }
    }
    Some(copy)
}

fn substitute(value: &Value, copy: &Copy, found: &mut Diagnostics) -> Value {
    match value {
        Value::Text(text) => Value::Text(substitute_text(text, copy, found)),
        Value::Array(items, span) => {
            Value::Array(items.iter().map(|item| substitute(item, copy, found)).collect(), *span)
        }
        Value::Table(table) => {
            let entries = table.entries.iter().map(|(key, value)| {
                let name = match key.name.contains('{') {
                    true => substitute_text(&Text::bare(&key.name, key.span), copy, found).text,
                    false => key.name.clone(),
                };
                (Key { name, span: key.span }, substitute(value, copy, found))
            });
            Value::Table(Table { entries: entries.collect(), span: table.span })
        }
        other => other.clone(),
    }
}

fn substitute_text(text: &Text, copy: &Copy, found: &mut Diagnostics) -> Text {
    let mut replacements = Vec::new();
    let mut from = 0;
    while let Some(open) = text.text[from..].find('{').map(|i| from + i) {
        let Some(close) = text.text[open..].find('}').map(|i| open + i) else { break };
        let name = &text.text[open + 1..close];
        match copy.iter().find(|(known, _)| known == name) {
            Some((_, by)) => {
                let operand = match by.chars().all(is_name) {
                    true => by.clone(),
                    false => {
                        let beside =
                            [&text.text[..open], &text.text[close + 1..]].map(|part| replaced(part, copy));
                        as_operand(by, beside.each_ref().map(String::as_str))
                    }
                };
                replacements.push((open..close + 1, operand));
            }
            None => found.push(
                Diagnostic::error(format!("unknown placeholder `{{{name}}}`"))
                    .label(text.place(open..close + 1), "not among the placeholders of `each`")
                    .help(suggestion(name, copy.iter().map(|(n, _)| n.as_str())).unwrap_or_else(|| {
                        let names: Vec<&str> = copy.iter().map(|(n, _)| n.as_str()).collect();
                        format!("placeholders here are {}", names.join(", "))
                    })),
            ),
        }
        from = close + 1;
    }
    if replacements.is_empty() { text.clone() } else { text.replace(&replacements) }
}

/// Does it belong to a name or a number?
fn is_name(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '_' | '.')
}

/// A text with every placeholder replaced as it is, to see what stands beside one.
fn replaced(text: &str, copy: &Copy) -> String {
    copy.iter().fold(text.to_owned(), |text, (name, by)| text.replace(&format!("{{{name}}}"), by))
}

/// A text to be put between two others: in parentheses where it is a sum, a product or a negative number, and they take
/// it for an operand, such as `{c}.abs()` with c = -3.
fn as_operand(whole: &str, [before, after]: [&str; 2]) -> String {
    let (text, before, after) = (whole.trim(), before.trim_end(), after.trim_start());
    // A whole expression, or a whole argument.
    let stands_alone = (before.is_empty() || before.ends_with(['(', ',']))
        && (after.is_empty() || after.starts_with([')', ',']));
    let is_operand = text.starts_with(|c: char| is_name(c) || c == '-' || c == '(')
        && text.ends_with(|c: char| is_name(c) || c == ')')
        && text.contains(is_name);
    let takes = |c: Option<char>, marks: &str| c.is_none_or(|c| marks.contains(c));
    let is_taken = takes(before.chars().next_back(), "(,+-*/=") && takes(after.chars().next(), "),+-*/.^");
    match !stands_alone && !text.chars().all(is_name) && is_operand && is_taken {
        true => format!("({text})"),
        false => whole.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::as_operand;

    #[test]
    fn a_number_below_zero_and_a_sum_are_operands() {
        for (text, before, after, expected) in [
            ("-3", "", ".abs()*1_N*N.y", "(-3)"),
            ("50+50", "2*", "", "(50+50)"),
            ("-2", "a + ", " * b", "(-2)"),
            ("1 + 2 ", "2*", "", "(1 + 2)"),
            // A whole argument, such as an exponent.
            ("-2", "q.powi(", ")", "-2"),
            ("1 - q", "min(", ", 2)", "1 - q"),
            ("1 - q", "3*(", " + 2)", "(1 - q)"),
            // A whole text, part of a name or of a number with a unit, a sign, what follows a name.
            ("-3", "", "", "-3"),
            ("-3", "", "_N*N.y", "-3"),
            ("-", "", "1_m*N.x", "-"),
            ("-", "", " 1_m*N.x", "-"),
            ("- 3_m*N.x", "P ", "", "- 3_m*N.x"),
            ("3", "2*", "", "3"),
            ("A.x", "2*", "", "A.x"),
        ] {
            assert_eq!(as_operand(text, [before, after]), expected, "{before}{{{text}}}{after}");
        }
    }
}
