//! Names of emitted items: turns every name of a model into a Rust identifier that is unique where it stands.
//!
//! In: names of a model. Out: identifiers. A [`Scope`] is a place in which names must differ: the fields of a struct,
//! the values of a function, the types of the file. It starts with the names that the emitted text itself uses there
//! and gives out every name once, so that no two can collide, whatever the model contains.

use crate::escape;
use crate::program::Program;
use rustc_hash::FxHashSet as HashSet;
use std::borrow::Cow;

/// Words that Rust does not accept as names, in any edition.
const KEYWORDS: [&str; 53] = [
    "Self", "_", "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate",
    "do", "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let",
    "loop", "macro", "match", "mod", "move", "mut", "override", "priv", "pub", "ref", "return", "self",
    "static", "struct", "super", "trait", "true", "try", "type", "typeof", "unsafe", "unsized", "use",
    "virtual", "where", "while", "yield",
];

/// Arguments of the emitted functions: time, coordinates, speeds, inputs, given derivatives of the speeds, prepared
/// values.
pub(super) const ARGUMENTS: [&str; 6] = ["t", "q", "u", "inputs", "u_dot", "p"];

/// The arguments to which a function writes the rates of coordinates and speeds.
pub(super) const RATES: [&str; 2] = ["q_dot", "u_dot"];

/// The argument, and the field of the return value, that hold sines and cosines of angles close by.
pub(super) const NEAR: &str = "near";

/// Constants of the emitted file. A `let` pattern with such a name would match against the constant.
const CONSTANTS: [&str; 17] = [
    "N_NEAR",
    "NQ",
    "NU",
    "N_INPUTS",
    "Q_NAMES",
    "U_NAMES",
    "INPUT_NAMES",
    "PARAMETER_NAMES",
    "SPEED_NAMES",
    "OUTPUT_NAMES",
    "UNKNOWN_NAMES",
    "CORRECTED",
    "IS_ANGLE",
    "NOMINAL",
    "START_Q",
    "START_U",
    "PARAMETER_RANGES",
];

/// Types and traits of the emitted file and of the runtime module that it uses.
const TYPES: [&str; 7] = ["S", "Real", "Parameters", "Prepared", "Mechanism", "Fault", "Model"];

/// Types, traits and variants that every Rust file has in scope. A type with such a name would hide them in the emitted
/// file and in the module that includes it, and a `let` cannot have the name of a variant.
const PRELUDE: [&str; 41] = [
    "Option",
    "Some",
    "None",
    "Result",
    "Ok",
    "Err",
    "Default",
    "Clone",
    "Copy",
    "Debug",
    "Send",
    "Sync",
    "Sized",
    "Unpin",
    "Drop",
    "Fn",
    "FnMut",
    "FnOnce",
    "AsyncFn",
    "AsyncFnMut",
    "AsyncFnOnce",
    "AsRef",
    "AsMut",
    "From",
    "Into",
    "TryFrom",
    "TryInto",
    "FromIterator",
    "Iterator",
    "IntoIterator",
    "Extend",
    "DoubleEndedIterator",
    "ExactSizeIterator",
    "Future",
    "IntoFuture",
    "ToOwned",
    "ToString",
    "String",
    "Vec",
    "Box",
    "Hash",
];

/// A name as an identifier: other characters become underscores, and keywords are changed.
fn identifier(name: &str) -> String {
    let fits = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut text = match name.bytes().all(|byte| fits(char::from(byte))) {
        true => name.to_owned(),
        false => name.chars().map(|c| if fits(c) { c } else { '_' }).collect(),
    };
    if text.is_empty() || text.starts_with(|c: char| c.is_ascii_digit()) || text.chars().all(|c| c == '_') {
        text.insert(0, 'x');
    }
    if KEYWORDS.binary_search(&text.as_str()).is_ok() {
        text.push('_');
    }
    text
}

/// `my_tile` -> `MyTile`, or another name if a type of the file or of the prelude has that one.
#[must_use]
pub(super) fn type_name(name: &str) -> String {
    let camel: String = identifier(name)
        .split('_')
        .flat_map(|word| {
            let mut letters = word.chars();
            letters.next().map(|c| c.to_ascii_uppercase()).into_iter().chain(letters).collect::<Vec<_>>()
        })
        .collect();
    let is_own = camel.starts_with(|c: char| c.is_ascii_alphabetic())
        && !TYPES.iter().chain(&PRELUDE).chain(&KEYWORDS).any(|taken| *taken == camel);
    if is_own { camel } else { format!("Model{camel}") }
}

/// Fields of `Parameters`, in the order of the parameters.
#[must_use]
pub(super) fn fields(program: &Program) -> Vec<String> {
    let mut fields = Scope::default();
    program.parameters.iter().map(|p| fields.unique(&p.name)).collect()
}

/// Documentation of something that the model names: its description, or what it is and its name as written, then the
/// rest of the sentence.
#[must_use]
pub(super) fn documented((kind, name): (&str, &str), doc: &str, rest: &str) -> String {
    let is_plain = name.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
    match doc.is_empty() {
        true if is_plain => format!("The {kind} `{name}` {}", escape::markdown(rest)),
        true => escape::markdown(&format!("The {kind} {name} {rest}")),
        false => escape::markdown(&format!("{} {rest}", sentence(doc, name))),
    }
}

/// The description, capitalised, or the name if there is none.
#[must_use]
pub(super) fn sentence(doc: &str, name: &str) -> String {
    let text = if doc.is_empty() { name } else { doc };
    let mut letters = text.chars();
    let mut sentence = String::with_capacity(text.len());
    sentence.extend(letters.next().into_iter().flat_map(char::to_uppercase));
    sentence + letters.as_str()
}

/// The names in use at one place: the fields of a struct, the values of a function.
#[derive(Default)]
pub(super) struct Scope {
    /// All names except those of temporaries, which are numbered and need no list.
    taken: HashSet<Cow<'static, str>>,
    temporaries: usize,
    /// Is there a name among them that looks like a temporary?
    numbered: bool,
}

impl Scope {
    /// A place in which these names are in use.
    fn of(names: impl Iterator<Item = &'static &'static str>) -> Self {
        Self { taken: names.map(|&name| Cow::Borrowed(name)).collect(), ..Self::default() }
    }

    /// The functions of the emitted file.
    pub fn of_functions() -> Self {
        Self::of(["prepare"].iter().chain(&CONSTANTS).chain(&TYPES).chain(&PRELUDE))
    }

    /// The types of the emitted file.
    pub fn of_types(program: &Program) -> Self {
        let mut scope = Self::of(TYPES.iter().chain(&PRELUDE).chain(&KEYWORDS));
        scope.taken.insert(type_name(&program.name).into());
        scope
    }

    /// The wished name for a type, with the first free number appended if it is taken.
    pub fn unique_type(&mut self, wished: &str) -> String {
        let mut number = 2;
        let mut name = wished.to_owned();
        while !self.taken.insert(name.clone().into()) {
            name = format!("{wished}{number}");
            number += 1;
        }
        name
    }

    /// The values of a function of the emitted file.
    pub fn of_function() -> Self {
        Self::of(
            ARGUMENTS.iter().chain(&RATES).chain(&[NEAR]).chain(&CONSTANTS).chain(&TYPES).chain(&PRELUDE),
        )
    }

    /// The wished name, with the first free number appended if it is taken.
    pub fn unique(&mut self, wished: &str) -> String {
        self.free(identifier(wished))
    }

    fn free(&mut self, wished: String) -> String {
        let mut suffix = 2;
        let mut other: Option<String> = None;
        while self.is_taken(other.as_deref().unwrap_or(&wished)) {
            other = Some(format!("{wished}_{suffix}"));
            suffix += 1;
        }
        let name = other.unwrap_or(wished);
        self.numbered |= number(&name).is_some();
        self.taken.insert(name.clone().into());
        name
    }

    fn is_taken(&self, name: &str) -> bool {
        self.taken.contains(name) || self.is_temporary(name)
    }

    /// Is it one of the temporaries t1, t2, ... given out so far?
    fn is_temporary(&self, name: &str) -> bool {
        number(name).is_some_and(|n| n <= self.temporaries)
    }

    /// A new temporary, for a value without a name in the model, in place of what `name` holds.
    pub fn temporary(&mut self, name: &mut String) {
        name.clear();
        name.push('t');
        push_number(name, self.temporaries + 1);
        if self.numbered && self.taken.contains(name.as_str()) {
            *name = self.free(std::mem::take(name));
        }
        self.temporaries += 1;
    }
}

/// Names, one after the other in one text: most are those of temporaries, a few letters long.
#[derive(Default)]
pub(super) struct Idents {
    text: String,
    /// Where each ends, which is where the next begins.
    ends: Vec<usize>,
}

impl Idents {
    pub fn push(&mut self, ident: &str) {
        self.text.push_str(ident);
        self.ends.push(self.text.len());
    }

    pub fn at(&self, place: usize) -> &str {
        let start = place.checked_sub(1).map_or(0, |before| self.ends[before]);
        &self.text[start..self.ends[place]]
    }

    pub fn len(&self) -> usize {
        self.ends.len()
    }
}

/// The number in a name of a temporary's form.
fn number(name: &str) -> Option<usize> {
    let digits = name.strip_prefix('t').filter(|digits| digits.starts_with(|c| matches!(c, '1'..='9')));
    digits.and_then(|digits| digits.parse().ok())
}

/// Appends decimal digits. The standard formatter would take as long as the rest of a short statement.
fn push_number(text: &mut String, n: usize) {
    if n >= 10 {
        push_number(text, n / 10);
    }
    text.push(char::from(b'0' + (n % 10) as u8));
}

#[cfg(test)]
mod tests {
    use super::{KEYWORDS, Scope};

    #[test]
    fn keywords_are_in_order() {
        assert!(KEYWORDS.is_sorted());
    }

    #[test]
    fn no_name_is_given_out_twice() {
        let mut scope = Scope::default();
        let temporary = |scope: &mut Scope| {
            let mut name = String::new();
            scope.temporary(&mut name);
            name
        };
        assert_eq!([scope.unique("t2"), temporary(&mut scope), temporary(&mut scope)], ["t2", "t1", "t2_2"]);
        assert_eq!([scope.unique("t1"), scope.unique("t2"), scope.unique("t3")], ["t1_2", "t2_3", "t3"]);
        assert_eq!([temporary(&mut scope), scope.unique("t01")], ["t3_2", "t01"]);
    }
}
