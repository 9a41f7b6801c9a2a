//! Parses TOML into a tree in the author's order, every key and value with its place.
//!
//! In: text. Out: [`Table`]. Strings keep a map back to the bytes of the file, so that a place inside an expression
//! remains a place in the file even after `{placeholders}` were replaced.

use std::num::IntErrorKind;
use std::ops::Range;

use toml::de::{DeTable, DeValue};

use crate::diagnostic::Diagnostic;
use crate::source::Span;

/// A key with its place.
#[derive(Clone, Debug)]
pub struct Key {
    /// The key.
    pub name: String,
    /// Its place.
    pub span: Span,
}

/// A table in the author's order.
#[derive(Clone, Debug, Default)]
pub struct Table {
    /// Keys and values.
    pub entries: Vec<(Key, Value)>,
    /// Place of the table (its header, or its braces).
    pub span: Span,
}

impl Table {
    /// The value under `name`.
    pub fn get(&self, name: &str) -> Option<&Value> {
        self.entries.iter().find(|(key, _)| key.name == name).map(|(_, value)| value)
    }
}

/// A value with its place.
#[derive(Clone, Debug)]
pub enum Value {
    /// A string.
    Text(Text),
    /// An integer or a float.
    Number(f64, Span),
    /// A truth value.
    Boolean(bool, Span),
    /// An array.
    Array(Vec<Value>, Span),
    /// A table.
    Table(Table),
    /// A date or time, which models have no use for.
    Date(Span),
}

impl Value {
    /// Its place.
    pub fn span(&self) -> Span {
        match self {
            Self::Text(text) => text.span,
            Self::Number(_, span) | Self::Boolean(_, span) | Self::Array(_, span) | Self::Date(span) => *span,
            Self::Table(table) => table.span,
        }
    }

    /// What it is, for messages.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Text(_) => "a string",
            Self::Number(..) => "a number",
            Self::Boolean(..) => "a truth value",
            Self::Array(..) => "an array",
            Self::Table(_) => "a table",
            Self::Date(_) => "a date",
        }
    }
}

/// The error for a value of another kind than expected.
pub fn wrong_kind(what: &str, expected: &str, value: &Value) -> Diagnostic {
    let example = match what {
        "inertia" => {
            "inertia = { Ixx = \"I\", Iyy = \"I\", Izz = \"J\" }: about the mass centre, in the body's frame; what is left out is 0"
        }
        "speed" => "speed = \"u1\", or speed = { name = \"u1\", independent = false }, or speed = false",
        "seconds" | "step" => "a time above 0, such as 0.001",
        "every" => "the number of steps from one row to the next: a whole number from 1",
        _ => {
            "correct the kind: text stands in quotes, numbers and true or false do not, tables in { }, lists in [ ]"
        }
    };
    Diagnostic::error(format!("`{what}` must be {expected}"))
        .label(value.span(), format!("this is {}", value.kind()))
        .help(example)
}

/// A run of bytes of a [`Text`] and its origin in the file.
#[derive(Clone, Debug)]
struct Piece {
    /// First byte in the text.
    at: usize,
    /// The bytes of the file it comes from.
    from: Range<usize>,
    /// Is it the same as in the file, byte by byte?
    verbatim: bool,
}

/// A string in which every byte knows its place in the file.
#[derive(Clone, Debug)]
pub struct Text {
    /// The string.
    pub text: String,
    /// Its place, quotes included.
    pub span: Span,
    pieces: Vec<Piece>,
}

impl Text {
    /// A string literal of the file.
    fn literal(text: &str, span: Span, file: &str) -> Self {
        let raw = file.get(span.start..span.end).unwrap_or("");
        // Most stand between two quotes as they are; others are searched for.
        let offset = match raw.get(1..text.len() + 1) == Some(text) {
            true => Some(1),
            false => raw.find(text),
        };
        let offset = offset.filter(|_| !text.is_empty());
        let piece = match offset {
            Some(offset) => {
                Piece { at: 0, from: span.start + offset..span.start + offset + text.len(), verbatim: true }
            }
            None => Piece { at: 0, from: span.start..span.end, verbatim: false },
        };
        Self { text: text.to_owned(), span, pieces: vec![piece] }
    }

    /// A key or other text without quotes.
    pub fn bare(text: &str, span: Span) -> Self {
        let verbatim = span.end - span.start == text.len();
        Self {
            text: text.to_owned(),
            span,
            pieces: vec![Piece { at: 0, from: span.start..span.end, verbatim }],
        }
    }

    /// Generated text, which is given the place of its origin.
    pub fn made(text: &str, span: Span) -> Self {
        let pieces = vec![Piece { at: 0, from: span.start..span.end, verbatim: false }];
        Self { text: text.to_owned(), span, pieces }
    }

    /// The place of a byte range of the text.
    pub fn place(&self, range: Range<usize>) -> Span {
        let piece_of = |byte: usize| self.pieces.iter().rev().find(|piece| piece.at <= byte);
        let start = piece_of(range.start).map_or(self.span.start, |piece| {
            if piece.verbatim {
                (piece.from.start + range.start - piece.at).min(piece.from.end)
            } else {
                piece.from.start
            }
        });
        let last = range.end.max(range.start + 1) - 1;
        let end = piece_of(last).map_or(self.span.end, |piece| {
            if piece.verbatim {
                (piece.from.start + last + 1 - piece.at).min(piece.from.end)
            } else {
                piece.from.end
            }
        });
        Span { start, end: end.max(start), file: self.span.file }
    }

    /// Replaces byte ranges (ascending, disjoint) by other texts; each replacement keeps the place of its range.
    pub fn replace(&self, replacements: &[(Range<usize>, String)]) -> Self {
        let mut result = Self { text: String::new(), span: self.span, pieces: Vec::new() };
        let mut done = 0;
        for (range, by) in replacements {
            result.append(self, done..range.start);
            let place = self.place(range.clone());
            result.pieces.push(Piece {
                at: result.text.len(),
                from: place.start..place.end,
                verbatim: false,
            });
            result.text.push_str(by);
            done = range.end;
        }
        result.append(self, done..self.text.len());
        result
    }

    /// Appends a part of another text of the same file.
    fn append(&mut self, other: &Self, range: Range<usize>) {
        for (i, piece) in other.pieces.iter().enumerate() {
            let end = other.pieces.get(i + 1).map_or(other.text.len(), |next| next.at);
            let (start, end) = (piece.at.max(range.start), end.min(range.end));
            if start < end {
                let from = match piece.verbatim {
                    true => piece.from.start + start - piece.at..piece.from.start + end - piece.at,
                    false => piece.from.clone(),
                };
                self.pieces.push(Piece { at: self.text.len(), from, verbatim: piece.verbatim });
                self.text.push_str(&other.text[start..end]);
            }
        }
    }
}

/// Syntax errors beyond this number are probably consequences of earlier ones.
const MOST_ERRORS: usize = 20;

/// Reads TOML.
///
/// # Errors
/// All syntax errors of the text.
pub fn parse(text: &str, file: u32) -> Result<Table, Vec<Diagnostic>> {
    let (table, errors) = DeTable::parse_recoverable(text);
    let mut wrong = Vec::new();
    wrong_integers(table.get_ref(), &mut wrong);
    if !wrong.is_empty() {
        let report = |range: &Range<usize>| {
            let number = text.get(range.clone()).unwrap_or_default();
            Diagnostic::error(format!("`{number}` is no number"))
                .label(Span { start: range.start, end: range.end, file }, "here")
                .help("a number with a unit stands in quotes: \"15_cm\"")
        };
        return Err(wrong.iter().take(MOST_ERRORS).map(report).collect());
    }
    if errors.is_empty() {
        let span = table.span();
        return Ok(convert_table(table.get_ref(), Span { start: span.start, end: span.end, file }, text));
    }
    let report = |error: &toml::de::Error| {
        let range = error.span().unwrap_or(0..0);
        let span = Span { start: range.start, end: range.end, file };
        let help = match error.message() {
            "duplicate key" => "the name stands twice in this table: rename or remove one of the two",
            m if m.contains("must be quoted") => "names and expressions stand in quotes: \"l*rod.x\"",
            m if m.contains("basic string") => "close the text with a second quote on the same line",
            _ => {
                "entries are `name = value`; names and expressions on the right stand in quotes; see https://toml.io"
            }
        };
        Diagnostic::error(format!("not valid TOML: {}", error.message())).label(span, "here").help(help)
    };
    Err(errors.iter().take(MOST_ERRORS).map(report).collect())
}

/// Finds integers with letters, which the notation lets pass.
fn wrong_integers(table: &DeTable<'_>, found: &mut Vec<Range<usize>>) {
    let mut values: Vec<_> = table.values().collect();
    while let Some(value) = values.pop() {
        match value.get_ref() {
            DeValue::Integer(integer) => {
                let read = i128::from_str_radix(integer.as_str(), integer.radix());
                found.extend(
                    read.is_err_and(|e| *e.kind() == IntErrorKind::InvalidDigit).then(|| value.span()),
                );
            }
            DeValue::Array(items) => values.extend(items.iter()),
            DeValue::Table(inner) => values.extend(inner.values()),
            _ => {}
        }
    }
    found.sort_by_key(|range| range.start);
}

fn convert_table(table: &DeTable<'_>, span: Span, text: &str) -> Table {
    let place = |range: Range<usize>| Span { start: range.start, end: range.end, file: span.file };
    let mut entries: Vec<(Key, Value)> = table
        .iter()
        .map(|(key, value)| {
            let name = key.get_ref().to_string();
            let value_span = place(value.span());
            (Key { name, span: place(key.span()) }, convert_value(value.get_ref(), value_span, text))
        })
        .collect();
    entries.sort_by_key(|(key, _)| key.span.start);
    Table { entries, span }
}

fn convert_value(value: &DeValue<'_>, span: Span, text: &str) -> Value {
    match value {
        DeValue::String(string) => Value::Text(Text::literal(string, span, text)),
        DeValue::Integer(integer) => Value::Number(
            i128::from_str_radix(integer.as_str(), integer.radix()).map_or(f64::NAN, |i| i as f64),
            span,
        ),
        DeValue::Float(float) => Value::Number(float.as_str().parse().unwrap_or(f64::NAN), span),
        DeValue::Boolean(boolean) => Value::Boolean(*boolean, span),
        DeValue::Datetime(_) => Value::Date(span),
        DeValue::Array(array) => {
            let place = |range: Range<usize>| Span { start: range.start, end: range.end, file: span.file };
            let item =
                |item: &toml::Spanned<DeValue<'_>>| convert_value(item.get_ref(), place(item.span()), text);
            Value::Array(array.iter().map(item).collect(), span)
        }
        DeValue::Table(table) => Value::Table(convert_table(table, span, text)),
    }
}
