//! Reads `[view]` of a world: hidden parts, colours, and the quantity that colours facets. No equation depends on it.

use super::value::one_of;
use crate::world::assembly::{Kind, Part, View};
use crate::world::places::whole;
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::Fields;
use smartbed_codegen::model::colour::{self, COLOURS};
use smartbed_codegen::model::document::{Table, Value, wrong_kind};
use smartbed_codegen::source::Span;

/// The name by which the arrows of all contact forces are hidden.
const FORCES: &str = "forces";

/// Reads it.
pub(super) fn read(table: &Table, parts: &[Part], found: &mut Diagnostics) -> View {
    let fields = Fields::of("view", table.span, table);
    let mut view = View::default();
    for item in fields.array("hide", found).map_or(&[][..], |(items, _)| items) {
        match item {
            Value::Text(text) if text.text == FORCES => view.hides_forces = true,
            Value::Text(text) => view.hidden.extend(named(&text.text, text.span, parts, found)),
            other => found.push(wrong_kind("hide", "a list of names in quotes", other)),
        }
    }
    if let Some(by) = fields.text("surfaces", found) {
        let by = one_of(&by.text, by.span, ("colouring of surfaces", &["stretch", "pressure"]), found);
        view.by_pressure = by == Some("pressure");
    }
    for (key, value) in fields.table("colours", found).map_or(&[][..], |table| &table.entries) {
        let of = named(&key.name, key.span, parts, found);
        if of.iter().any(|n| matches!(parts[*n].kind, Kind::Mechanism(_))) {
            let error = Diagnostic::error(format!("`{}` is a mechanism of many bodies", key.name));
            found.push(
                error
                    .label(key.span, "one colour cannot be that of all its bodies")
                    .help("its model's [view] has colours"),
            );
            continue;
        }
        let Value::Text(text) = value else {
            found.push(wrong_kind(&key.name, "a colour in quotes", value));
            continue;
        };
        match colour::parse(&text.text) {
            Some(rgb) => view.colours.extend(of.into_iter().map(|n| (n, rgb))),
            None => {
                let names = COLOURS.map(|(name, _)| name);
                let help = crate::suggest::help(&text.text, names).trim_start_matches("; ").to_owned();
                let error = Diagnostic::error(format!("unknown colour `{}`", text.text));
                found.push(
                    error.label(text.span, "no colour has this name, and it is no \"#rrggbb\"").help(help),
                );
            }
        }
    }
    fields.finish(found);
    view
}

/// Indices of the parts of this name, all copies for a grid.
fn named(name: &str, span: Span, parts: &[Part], found: &mut Diagnostics) -> Vec<usize> {
    let own = |part: &Part| whole(&part.name) == name;
    let numbers: Vec<usize> = (0..parts.len()).filter(|n| own(&parts[*n])).collect();
    if numbers.is_empty() {
        let known = parts.iter().map(|part| whole(&part.name));
        let help = crate::suggest::help(name, known).trim_start_matches("; ").to_owned();
        let error = Diagnostic::error(format!("there is no part `{name}`"));
        found.push(error.label(span, "nothing to show has this name").help(help));
    }
    numbers
}
