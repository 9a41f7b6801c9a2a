//! The fields of one entry: each is read once by name; a field that nobody read is unknown and an error.

use std::cell::RefCell;

use super::document::wrong_kind;
use super::document::{Key, Table, Text, Value};
use super::scope::suggestion;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::source::Span;

/// Room for the names of the fields of most entries.
const MOST_FIELDS: usize = 8;

/// An entry such as `hA = { unit = "m", nominal = 0 }`.
pub struct Fields<'a> {
    /// The entry's name.
    pub name: &'a str,
    /// Place of the name.
    pub span: Span,
    table: &'a Table,
    /// Field names read so far, to compare an unknown field with.
    known: RefCell<Vec<&'static str>>,
}

impl<'a> Fields<'a> {
    /// The entry's table; an error if it is something else.
    pub fn new(key: &'a Key, value: &'a Value, found: &mut Diagnostics) -> Option<Self> {
        match value {
            Value::Table(table) => Some(Self::of(&key.name, key.span, table)),
            other => {
                found.push(wrong_kind(&key.name, "a table { ... }", other));
                None
            }
        }
    }

    /// Fields of a table without a key of its own.
    pub fn of(name: &'a str, span: Span, table: &'a Table) -> Self {
        Self { name, span, table, known: RefCell::new(Vec::with_capacity(MOST_FIELDS)) }
    }

    /// A field that may be missing.
    pub fn get(&self, field: &'static str) -> Option<&'a Value> {
        self.known.borrow_mut().push(field);
        self.table.get(field)
    }

    /// A field that must be there.
    pub fn need(&self, field: &'static str, example: &str, found: &mut Diagnostics) -> Option<&'a Value> {
        let value = self.get(field);
        if value.is_none() {
            found.push(
                Diagnostic::error(format!("`{}` has no `{field}`", self.name))
                    .label(self.span, format!("`{field}` is missing"))
                    .help(format!("add {field} = {example}")),
            );
        }
        value
    }

    /// A string.
    pub fn text(&self, field: &'static str, found: &mut Diagnostics) -> Option<&'a Text> {
        match self.get(field)? {
            Value::Text(text) => Some(text),
            other => {
                found.push(wrong_kind(field, "a string", other));
                None
            }
        }
    }

    /// A documentation string, empty if missing.
    pub fn doc(&self, found: &mut Diagnostics) -> String {
        self.text("doc", found).map_or_else(String::new, |text| text.text.clone())
    }

    /// A truth value.
    pub fn boolean(&self, field: &'static str, found: &mut Diagnostics) -> Option<bool> {
        match self.get(field)? {
            Value::Boolean(boolean, _) => Some(*boolean),
            other => {
                found.push(wrong_kind(field, "true or false", other));
                None
            }
        }
    }

    /// A table inside.
    pub fn table(&self, field: &'static str, found: &mut Diagnostics) -> Option<&'a Table> {
        match self.get(field)? {
            Value::Table(table) => Some(table),
            other => {
                found.push(wrong_kind(field, "a table { ... }", other));
                None
            }
        }
    }

    /// An array.
    pub fn array(&self, field: &'static str, found: &mut Diagnostics) -> Option<(&'a [Value], Span)> {
        match self.get(field)? {
            Value::Array(items, span) => Some((items, *span)),
            other => {
                found.push(wrong_kind(field, "an array [ ... ]", other));
                None
            }
        }
    }

    /// Reports every field that was never asked for.
    pub fn finish(self, found: &mut Diagnostics) {
        let mut known = self.known.into_inner();
        known.sort_unstable();
        known.dedup();
        for (key, _) in &self.table.entries {
            if !known.contains(&key.name.as_str()) {
                let all = || format!("fields here are {}", known.join(", "));
                found.push(
                    Diagnostic::error(format!("`{}` has no field `{}`", self.name, key.name))
                        .label(key.span, "unknown field")
                        .help(suggestion(&key.name, known.iter().copied()).unwrap_or_else(all)),
                );
            }
        }
    }
}
