//! Checks the characters and the nesting of an expression before any recursive parser reads it.
//!
//! In: text. Out: nothing, or what is wrong and where. Only the characters of the language pass: letters, digits, `_ .
//! , + - * / ( )` and white space. So no comment, attribute, block or closure of Rust reaches the parser, and its
//! recursion is bounded by [`DEEPEST`].

use std::ops::Range;

/// Parentheses and signs nest at most this deep.
pub const DEEPEST: usize = 128;
/// An expression has at most this many names, numbers and operators.
pub const MOST_TOKENS: usize = 2000;

/// A fault: message, place, help.
pub type Fault = (String, Range<usize>, &'static str);

/// Checks an expression's text.
///
/// # Errors
/// The first thing that is outside the language or beyond a limit.
pub fn check(text: &str) -> Result<(), Fault> {
    let bytes = text.as_bytes();
    // `depth` counts open parentheses; `signs` counts operators in a row, each of which nests the parser once more.
    let (mut at, mut depth, mut signs, mut tokens) = (0, 0_usize, 0_usize, 0_usize);
    let mut open: Vec<usize> = Vec::new();
    while let Some(c) = text[at..].chars().next() {
        let start = at;
        at += c.len_utf8();
        match c {
            ' ' | '\t' | '\n' | '\r' => continue,
            'a'..='z' | 'A'..='Z' | '_' | '0'..='9' => {
                let word = |b: &u8| b.is_ascii_alphanumeric() || *b == b'_';
                while bytes.get(at).is_some_and(word) {
                    at += 1;
                }
                signs = 0;
            }
            '(' => {
                open.push(start);
                depth += 1 + signs;
                signs = 0;
            }
            ')' if open.pop().is_none() => {
                return Err((
                    "`)` without `(`".to_owned(),
                    start..at,
                    "remove it, or add the opening parenthesis",
                ));
            }
            ')' => depth = depth.saturating_sub(1),
            '/' if matches!(bytes.get(at), Some(b'/' | b'*')) => {
                return Err((
                    "comments do not belong into an expression".to_owned(),
                    start..at + 1,
                    "comments of TOML start with # and stand outside the quotes",
                ));
            }
            '+' | '-' | '*' | '/' => signs += 1,
            '.' | ',' => signs = 0,
            other => return Err((format!("unexpected `{other}`"), start..at, character_help(other))),
        }
        tokens += 1;
        if DEEPEST < depth + signs {
            return Err((
                format!("nested more than {DEEPEST} deep"),
                start..at,
                "split it with intermediate [definitions]",
            ));
        }
        if MOST_TOKENS < tokens {
            return Err((
                format!("more than {MOST_TOKENS} names, numbers and operators"),
                start..at,
                "split it with intermediate [definitions]",
            ));
        }
    }
    match open.first() {
        Some(start) => {
            Err(("`(` is never closed".to_owned(), *start..*start + 1, "add the closing parenthesis"))
        }
        None if tokens == 0 => {
            Err(("the expression is empty".to_owned(), 0..text.len(), "write a number or an expression"))
        }
        None => Ok(()),
    }
}

/// What to write instead of a character that is not in the language.
fn character_help(c: char) -> &'static str {
    match c {
        '^' => "powers are written x.powi(2)",
        '{' | '}' => "placeholders in braces are replaced inside [repeat] only",
        '[' | ']' => "vectors are sums of a scalar times a unit vector: 2*N.x + 3*N.y",
        '=' | '<' | '>' | '!' => {
            "an expression has no comparisons; constraints are written as expression = 0, the zero left out"
        }
        '\'' => "rates are written q_dot(name)",
        _ => "expressions consist of names, numbers, + - * / ( ) , and calls such as sin(q)",
    }
}
