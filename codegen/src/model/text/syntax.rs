//! Parses an expression's text into a syntax tree, every part with its range of bytes: the subset of Rust that models
//! use.
//!
//! In: text that [`check`](super::lexing::check) has accepted. Out: a tree, or the first thing that cannot be read. By
//! recursive descent: sums of products of signed factors; a factor may be followed by parts `.x`, calls `(..)` and
//! methods `.powi(2)`. Its depth is bounded by [`DEEPEST`](super::lexing::DEEPEST).

use std::ops::Range;

/// A node of the syntax tree.
pub struct Syntax {
    /// What it is.
    pub kind: Kind,
    /// Where it stands.
    pub range: Range<usize>,
}

/// The kinds of nodes.
pub enum Kind {
    /// A number.
    Number(Number),
    /// A single word.
    Word(String),
    /// An expression in parentheses.
    Group(Box<Syntax>),
    /// -a
    Negate(Box<Syntax>),
    /// *a: the second star of Python's a**2, which reads as a*(*2).
    Star,
    /// a + b or another operation, by its sign.
    Binary(char, Box<Syntax>, Box<Syntax>),
    /// a.x
    Part(Box<Syntax>, Word),
    /// f(a, b)
    Call(Box<Syntax>, Vec<Syntax>),
    /// a.f(b); a is the first of the arguments.
    Method(Word, Vec<Syntax>),
}

/// A word and where it stands.
pub struct Word {
    /// The word.
    pub text: String,
    /// Its place.
    pub range: Range<usize>,
}

/// A number as it is written.
pub struct Number {
    /// Digits, point and exponent, without `_`.
    pub digits: String,
    /// The unit behind it.
    pub suffix: String,
    /// Has it neither a point, an exponent nor a unit?
    pub is_integer: bool,
}

/// The reason why a text cannot be read, and where.
pub enum Fault {
    /// A syntax error.
    Broken(&'static str, Range<usize>),
    /// Valid Rust that the language of models does not have.
    Foreign(Range<usize>),
}

/// Words that Rust does not accept as a name.
const KEYWORDS: [&str; 51] = [
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate", "do", "dyn",
    "else", "enum", "extern", "false", "final", "fn", "for", "if", "impl", "in", "let", "loop", "macro",
    "match", "mod", "move", "mut", "override", "priv", "pub", "ref", "return", "Self", "self", "static",
    "struct", "super", "trait", "true", "try", "type", "typeof", "unsafe", "unsized", "use", "virtual",
    "where", "while", "yield",
];

/// Is this a word that Rust does not accept as a name?
#[must_use]
pub fn is_keyword(name: &str) -> bool {
    KEYWORDS.contains(&name)
}

/// Reads a whole text.
pub fn read(text: &str) -> Result<Syntax, Fault> {
    let mut reader = Reader { text, at: 0, end: 0 };
    let syntax = reader.sum()?;
    match reader.next() {
        None => Ok(syntax),
        Some(_) => Err(reader.unread(&syntax)),
    }
}

struct Reader<'t> {
    text: &'t str,
    at: usize,
    /// End of the last token.
    end: usize,
}

impl Reader<'_> {
    /// The next character that is not blank; afterwards it is the one at `at`.
    fn next(&mut self) -> Option<char> {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start().len();
        self.text[self.at..].chars().next()
    }

    /// Consumes this character if it is the next one.
    fn takes(&mut self, wanted: char) -> bool {
        let found = self.next() == Some(wanted);
        if found {
            self.at += wanted.len_utf8();
            self.end = self.at;
        }
        found
    }

    /// The fault for an unexpected token at `at`.
    fn broken(&mut self, why: &'static str) -> Fault {
        match self.next() {
            Some(c) if is_of_word(c) => Fault::Broken(why, self.at..self.end_of(self.at, is_of_word)),
            Some(c) => Fault::Broken(why, self.at..self.at + c.len_utf8()),
            None => Fault::Broken("unexpected end, expected an expression", self.text.len()..self.text.len()),
        }
    }

    /// The fault for text after a complete expression: `a as f64` is Rust, `a b` is a syntax error.
    fn unread(&mut self, before: &Syntax) -> Fault {
        let rest = &self.text[self.at..];
        let word = &rest[..rest.find(|c| !is_of_word(c)).unwrap_or(rest.len())];
        if is_keyword(word) { self.foreign(before.range.start) } else { self.broken("unexpected token") }
    }

    /// The fault for Rust that models do not have, from `start` to the next comma or parenthesis.
    fn foreign(&self, start: usize) -> Fault {
        let end = self.end_of(self.at, |c| !matches!(c, ',' | ')'));
        Fault::Foreign(start..start + self.text[start..end.max(start + 1)].trim_end().len())
    }

    fn end_of(&self, start: usize, belongs: impl Fn(char) -> bool) -> usize {
        let rest = &self.text[start..];
        start + rest.find(|c| !belongs(c)).unwrap_or(rest.len())
    }

    fn made(&self, kind: Kind, start: usize) -> Syntax {
        Syntax { kind, range: start..self.end }
    }

    fn sum(&mut self) -> Result<Syntax, Fault> {
        let mut left = self.product()?;
        while let Some(sign @ ('+' | '-')) = self.next() {
            self.takes(sign);
            let right = self.product()?;
            let start = left.range.start;
            left = self.made(Kind::Binary(sign, Box::new(left), Box::new(right)), start);
        }
        Ok(left)
    }

    fn product(&mut self) -> Result<Syntax, Fault> {
        let mut left = self.signed()?;
        while let Some(sign @ ('*' | '/')) = self.next() {
            self.takes(sign);
            let right = self.signed()?;
            let start = left.range.start;
            left = self.made(Kind::Binary(sign, Box::new(left), Box::new(right)), start);
        }
        Ok(left)
    }

    fn signed(&mut self) -> Result<Syntax, Fault> {
        let sign = self.next();
        let start = self.at;
        match sign {
            Some('-') => {
                self.takes('-');
                let inner = Box::new(self.signed()?);
                Ok(self.made(Kind::Negate(inner), start))
            }
            Some('*') => {
                self.takes('*');
                self.signed()?;
                Ok(self.made(Kind::Star, start))
            }
            _ => self.factor(),
        }
    }

    fn factor(&mut self) -> Result<Syntax, Fault> {
        let mut factor = self.single()?;
        let start = factor.range.start;
        loop {
            if self.next() == Some('(') {
                let arguments = self.arguments()?;
                factor = self.made(Kind::Call(Box::new(factor), arguments), start);
            } else if self.takes('.') {
                if !self.next().is_some_and(is_of_word) {
                    let is_range = self.next() == Some('.');
                    return Err(if is_range { self.foreign(start) } else { self.broken("expected a name") });
                }
                let word = self.word();
                factor = match self.next() {
                    Some('(') => {
                        let mut arguments = vec![factor];
                        arguments.extend(self.arguments()?);
                        self.made(Kind::Method(word, arguments), start)
                    }
                    _ => self.made(Kind::Part(Box::new(factor), word), start),
                };
            } else {
                return Ok(factor);
            }
        }
    }

    /// `(a, b)`; a trailing comma is allowed.
    fn arguments(&mut self) -> Result<Vec<Syntax>, Fault> {
        let mut arguments = Vec::new();
        self.takes('(');
        while !self.takes(')') {
            arguments.push(self.sum()?);
            if self.next() != Some(')') && !self.takes(',') {
                return Err(self.broken("expected `,`"));
            }
        }
        Ok(arguments)
    }

    /// A number, a word, or an expression in parentheses.
    fn single(&mut self) -> Result<Syntax, Fault> {
        let first = self.next();
        let start = self.at;
        match first {
            Some('(') => {
                self.takes('(');
                if self.next() == Some(')') {
                    return Err(self.foreign(start));
                }
                let inner = self.sum()?;
                if self.next() == Some(',') {
                    return Err(self.foreign(start));
                }
                if !self.takes(')') {
                    return Err(self.unread(&inner));
                }
                Ok(self.made(Kind::Group(Box::new(inner)), start))
            }
            Some(c) if c.is_ascii_digit() => {
                let number = self.number();
                Ok(self.made(Kind::Number(number), start))
            }
            Some(c) if is_of_word(c) => {
                let word = self.word();
                if is_keyword(&word.text) || word.text == "_" {
                    return Err(match self.next() {
                        None => self.broken(""),
                        Some(_) => self.foreign(start),
                    });
                }
                Ok(self.made(Kind::Word(word.text), start))
            }
            _ => Err(self.broken("expected an expression")),
        }
    }

    /// The word at `at`.
    fn word(&mut self) -> Word {
        let range = self.at..self.end_of(self.at, is_of_word);
        (self.at, self.end) = (range.end, range.end);
        Word { text: self.text[range.clone()].to_owned(), range }
    }

    /// The number at `at`. A point belongs to it unless a name follows, an exponent only if digits follow.
    fn number(&mut self) -> Number {
        let bytes = self.text.as_bytes();
        let is_digit = |c: char| c.is_ascii_digit() || c == '_';
        let mut end = self.end_of(self.at, is_digit);
        let mut is_integer = true;
        if bytes.get(end) == Some(&b'.') {
            let behind = self.text[end + 1..].chars().next();
            if behind.is_none_or(|c| c.is_ascii_digit() || !is_of_word(c) && c != '.') {
                (end, is_integer) = (self.end_of(end + 1, is_digit), false);
            }
        }
        if matches!(bytes.get(end), Some(b'e' | b'E')) {
            let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
            let power = self.end_of(end + 1 + sign, is_digit);
            if self.text[end + 1 + sign..power].contains(|c: char| c.is_ascii_digit()) {
                (end, is_integer) = (power, false);
            }
        }
        let digits = self.text[self.at..end].replace('_', "");
        let last = self.end_of(end, is_of_word);
        let suffix = self.text[end..last].to_owned();
        (self.at, self.end) = (last, last);
        Number { digits, is_integer: is_integer && suffix.is_empty(), suffix }
    }
}

fn is_of_word(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}
