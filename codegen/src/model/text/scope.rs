//! Names of a model: what each refers to, and the nearest known name for a misspelt one.

use std::collections::{BTreeMap, BTreeSet};

use super::syntax::is_keyword;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::ids::{
    BodyId, CoordinateId, DefinitionId, FrameId, InputId, ParameterId, PointId, SpeedId,
};
use crate::source::Span;

/// What a name in an expression refers to.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Binding {
    /// A parameter.
    Parameter(ParameterId),
    /// A coordinate.
    Coordinate(CoordinateId),
    /// A speed.
    Speed(SpeedId),
    /// An input.
    Input(InputId),
    /// A definition.
    Definition(DefinitionId),
    /// A point.
    Point(PointId),
}

impl Binding {
    /// What it is, for messages.
    pub fn kind(self) -> &'static str {
        match self {
            Self::Parameter(_) => "a parameter",
            Self::Coordinate(_) => "a coordinate",
            Self::Speed(_) => "a speed",
            Self::Input(_) => "an input",
            Self::Definition(_) => "a definition",
            Self::Point(_) => "a point",
        }
    }
}

/// Words that have a fixed meaning in expressions.
pub const RESERVED: [&str; 3] = ["t", "pi", "deg"];

/// All names of a model.
#[derive(Debug, Default)]
pub struct Scope {
    /// Quantities: they share one name space, because expressions name them without a prefix.
    pub values: BTreeMap<String, (Binding, Span)>,
    /// Frames: expressions name them before `.x`, `.y`, `.z`.
    pub frames: BTreeMap<String, (FrameId, Span)>,
    /// Bodies.
    pub bodies: BTreeMap<String, (BodyId, Span)>,
    /// Names of quantities that are declared twice: it is open which of the two an expression means.
    pub twice: BTreeSet<String>,
}

impl Scope {
    /// Declares a quantity.
    pub fn declare(&mut self, name: &str, span: Span, binding: Binding, found: &mut Diagnostics) {
        check_name(name, span, found);
        match self.values.get(name) {
            Some((first, place)) => {
                found.push(duplicate(name, span, *place, first.kind()));
                self.twice.insert(name.to_owned());
            }
            None => drop(self.values.insert(name.to_owned(), (binding, span))),
        }
    }

    /// Declares a frame.
    pub fn declare_frame(&mut self, name: &str, span: Span, id: FrameId, found: &mut Diagnostics) {
        check_name(name, span, found);
        match self.frames.get(name) {
            Some((_, place)) => found.push(duplicate(name, span, *place, "a frame")),
            None => drop(self.frames.insert(name.to_owned(), (id, span))),
        }
    }

    /// Declares a body.
    pub fn declare_body(&mut self, name: &str, span: Span, id: BodyId, found: &mut Diagnostics) {
        check_name(name, span, found);
        match self.bodies.get(name) {
            Some((_, place)) => found.push(duplicate(name, span, *place, "a body")),
            None => drop(self.bodies.insert(name.to_owned(), (id, span))),
        }
    }
}

/// The error for a name that is given twice.
pub fn duplicate(name: &str, span: Span, first: Span, kind: &str) -> Diagnostic {
    Diagnostic::error(format!("`{name}` is declared twice"))
        .label(span, "declared here again")
        .label(first, format!("already {kind}, declared here"))
        .help("parameters, coordinates, speeds, inputs, definitions and points share one name space; rename one of the two")
}

/// Is it a word: letters, digits and underscores?
fn is_word(name: &str) -> bool {
    let mut letters = name.chars();
    let starts = letters.next().is_some_and(|c| c.is_ascii_alphabetic() || c == '_');
    starts && letters.all(|c| c.is_ascii_alphanumeric() || c == '_') && name != "_" && name.len() <= 64
}

/// Checks a name that no expression refers to: any word is allowed.
pub(super) fn check_word(name: &str, span: Span, found: &mut Diagnostics) {
    if !is_word(name) {
        found.push(
            Diagnostic::error(format!("`{name}` cannot be a name"))
                .label(span, "not an identifier")
                .help("names are at most 64 letters, digits and underscores and start with a letter"),
        );
    }
}

/// Checks the name of a quantity, a frame or a body: a word that has no fixed meaning in expressions.
pub(super) fn check_name(name: &str, span: Span, found: &mut Diagnostics) {
    check_word(name, span, found);
    if RESERVED.contains(&name) {
        found.push(
            Diagnostic::error(format!("`{name}` is a reserved name"))
                .label(span, "cannot be declared")
                .help("t is time, pi the number, deg the factor pi/180: choose another name"),
        );
    } else if is_keyword(name) {
        found.push(
            Diagnostic::error(format!("`{name}` is a reserved word of Rust"))
                .label(span, "cannot be a name in expressions")
                .help("choose another name: expressions follow Rust's notation"),
        );
    }
}

/// `did you mean ...?`, if a known name is near.
pub fn suggestion<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<String> {
    let near = known.into_iter().map(|k| (edit_distance(name, k), k)).min()?;
    // A name of one letter matches only itself in the other case.
    let allowed = (name.chars().count() + 1) / 3;
    (near.0 <= allowed).then(|| format!("did you mean `{}`?", near.1))
}

/// Levenshtein distance, upper and lower case taken as equal.
fn edit_distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) =
        (a.to_lowercase().chars().collect(), b.to_lowercase().chars().collect());
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.iter().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let replace = diagonal + usize::from(x != y);
            diagonal = row[j + 1];
            row[j + 1] = replace.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}

/// The call of a function with placeholders for its arguments, for messages.
pub fn usage(name: &str, count: usize) -> String {
    match name {
        "dot" => {
            "write dot(a, b) for the product of two vectors; the rate of a coordinate q is its speed `u_q`"
                .to_owned()
        }
        "powi" | "pow" => "write x.powi(2) or pow(x, 2)".to_owned(),
        "atan2" => "write atan2(y, x)".to_owned(),
        "smooth_step" => "write smooth_step(x, width)".to_owned(),
        _ if count == 1 => format!("write {name}(a)"),
        _ => format!("write {name}(a, b)"),
    }
}
