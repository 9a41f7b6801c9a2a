//! Reads fields of a scene as numbers, vectors and words: each is asked for once, with its unit and bounds.
//!
//! A plain number is in SI units; a string is a number with its unit (`"20_mm"`, `"9.81 m/s^2"`) or an expression.

use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::document::{Table, Text, Value, wrong_kind};
use smartbed_codegen::model::unit::{self, Unit};
use smartbed_codegen::model::unit_hint::unit_hint;
use smartbed_codegen::model::{Fields, is_plain, quantity};
use smartbed_codegen::source::Span;

/// A condition on a number.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Bound {
    Any,
    NotNegative,
    Positive,
    Share,
}

impl Bound {
    fn holds(self, x: f64) -> bool {
        match self {
            Bound::Any => true,
            Bound::NotNegative => x >= 0.0,
            Bound::Positive => x > 0.0,
            Bound::Share => (0.0..=1.0).contains(&x),
        }
    }

    fn words(self) -> &'static str {
        match self {
            Bound::Any => "a number",
            Bound::NotNegative => "a number >= 0",
            Bound::Positive => "a number > 0",
            Bound::Share => "a number from 0 to 1",
        }
    }
}

/// The unit of a text that is a constant of the program.
pub(crate) fn unit(text: &str) -> Unit {
    unit::parse(text).map_or(Unit::NONE, |scale| scale.unit)
}

/// The field `unit`: its text for the fields that follow it, and its dimension; an empty text and `None` if it is left
/// out.
pub(crate) fn named_unit(fields: &Fields<'_>, found: &mut Diagnostics) -> Option<(String, Option<Unit>)> {
    let Some(text) = fields.text("unit", found) else { return Some((String::new(), None)) };
    match unit::parse(text.text.trim()) {
        Ok(scale) => Some((text.text.clone(), Some(scale.unit))),
        Err((message, _)) => {
            let help = unit_hint(text.text.trim())
                .unwrap_or_else(|| "for example unit = \"mm\", \"kPa\" or \"rad/s\"".to_owned());
            found.push(
                Diagnostic::error(format!("`unit`: {message}")).label(text.span, "in this unit").help(help),
            );
            None
        }
    }
}

/// Refuses a text with a unit under one of these `keys`, whose unit `unit` would say, where that is left out.
pub(crate) fn refuse_unit_unnamed(
    of: &str,
    table: &Table,
    keys: &[&str],
    found: &mut Diagnostics,
) -> Option<()> {
    let given = || keys.iter().filter_map(|key| Some((*key, table.get(key)?)));
    let texts = given().flat_map(|(key, value)| in_unit(value).into_iter().map(move |text| (key, text)));
    let has_unit = |(key, text): &(&str, &Text)| {
        let mut scratch = Diagnostics::new(found.source.clone());
        let is_none = quantity(text, Unit::NONE, key, &mut scratch).is_none();
        is_none && scratch.items.iter().any(|item| item.message.starts_with(&format!("{key} must be")))
    };
    let Some((key, text)) = texts.into_iter().find(has_unit) else { return Some(()) };
    let error = Diagnostic::error(format!("{of} has no `unit`, but `{key}` has one"));
    let help = "say the unit of what it reads, as the rows show it or another of its dimension: for example unit = \"mm\"";
    found.push(error.label(text.span, "in which unit are its readings?").help(help));
    None
}

/// The texts of a value that are in the unit of its field: of a list of pairs `[time, value]` the second ones.
fn in_unit<'v>(value: &'v Value) -> Vec<&'v Text> {
    match value {
        Value::Text(text) => vec![text],
        Value::Array(items, _) => {
            let of = |item: &'v Value| match item {
                Value::Array(pair, _) => pair.get(1).map_or_else(Vec::new, in_unit),
                other => in_unit(other),
            };
            items.iter().flat_map(of).collect()
        }
        _ => Vec::new(),
    }
}

/// A value as a number.
pub(crate) fn scalar(
    value: &Value,
    key: &str,
    of: &str,
    bound: Bound,
    found: &mut Diagnostics,
) -> Option<f64> {
    let number = match value {
        Value::Number(number, _) if number.is_finite() => *number,
        Value::Text(text) => quantity(text, unit(of), &format!("`{key}`"), found)?,
        Value::Number(number, span) => {
            let error = Diagnostic::error(format!("`{key}` must be a finite number"));
            let error = error.label(*span, format!("this is {number}, not a finite number"));
            found.push(error.help(format!("{key} takes {}", bound.words())));
            return None;
        }
        other => {
            let expected = format!("a number in {}, or a text such as \"2 {of}\"", unit_name(of));
            found.push(wrong_kind(key, &expected, other).help(format!("{key} takes {}", bound.words())));
            return None;
        }
    };
    if bound.holds(number) {
        return Some(number);
    }
    let error = Diagnostic::error(format!("`{key}` must be {}", bound.words()));
    found.push(error.label(value.span(), format!("this is {number}")).help("correct the number or its sign"));
    None
}

fn unit_name(of: &str) -> &str {
    if of.is_empty() { "no unit" } else { of }
}

/// An optional number.
pub(crate) fn number(
    fields: &Fields<'_>,
    key: &'static str,
    of: &str,
    bound: Bound,
    found: &mut Diagnostics,
) -> Option<f64> {
    scalar(fields.get(key)?, key, of, bound, found)
}

/// A required number.
pub(crate) fn needed(
    fields: &Fields<'_>,
    key: &'static str,
    (of, example): (&str, &str),
    found: &mut Diagnostics,
) -> Option<f64> {
    scalar(fields.need(key, example, found)?, key, of, Bound::Positive, found)
}

/// Numbers of a list of this length.
pub(crate) fn list<const N: usize>(
    value: &Value,
    key: &str,
    of: &str,
    found: &mut Diagnostics,
) -> Option<[f64; N]> {
    let Value::Array(items, _) = value else {
        found.push(
            wrong_kind(key, &format!("a list of {N} numbers"), value)
                .help("write [x, y, z], each with its unit"),
        );
        return None;
    };
    if items.len() != N {
        let error = Diagnostic::error(format!("`{key}` must be a list of {N} numbers"));
        found.push(
            error.label(value.span(), format!("these are {}", items.len())).help("give one for each axis"),
        );
        return None;
    }
    let numbers: Vec<Option<f64>> = items.iter().map(|x| scalar(x, key, of, Bound::Any, found)).collect();
    numbers.into_iter().collect::<Option<Vec<f64>>>()?.try_into().ok()
}

/// An optional vector.
pub(crate) fn vector(
    fields: &Fields<'_>,
    key: &'static str,
    of: &str,
    found: &mut Diagnostics,
) -> Option<[f64; 3]> {
    list(fields.get(key)?, key, of, found)
}

/// A whole number of at least `least`.
pub(crate) fn count(
    fields: &Fields<'_>,
    key: &'static str,
    least: usize,
    found: &mut Diagnostics,
) -> Option<usize> {
    match fields.get(key)? {
        Value::Number(n, _) if n.fract() == 0.0 && *n >= least as f64 && *n <= 1e9 => Some(*n as usize),
        other => {
            let expected = format!("a whole number >= {least}");
            let error = match other {
                Value::Number(n, span) => Diagnostic::error(format!("`{key}` must be {expected}"))
                    .label(*span, format!("this is {n}")),
                _ => wrong_kind(key, &expected, other),
            };
            found.push(error.help("correct the number"));
            None
        }
    }
}

/// One of several words.
pub(crate) fn one_of<'k>(
    word: &str,
    span: Span,
    (what, known): (&str, &[&'k str]),
    found: &mut Diagnostics,
) -> Option<&'k str> {
    let hit = known.iter().find(|k| **k == word);
    if hit.is_none() {
        let help = crate::suggest::help(word, known.iter().copied());
        let help = if help.is_empty() { format!("known: {}", known.join(", ")) } else { help };
        found.push(
            Diagnostic::error(format!("unknown {what} `{word}`"))
                .label(span, format!("expected one of {}", known.join(", ")))
                .help(help.trim_start_matches("; ").to_owned()),
        );
    }
    hit.copied()
}

/// Refuses a number without unit where the model would read it in another unit than the scene.
pub(super) fn refuse_without_unit(
    name: &str,
    value: &Value,
    (unit, factor): &(String, f64),
    found: &mut Diagnostics,
) {
    let is_zero = |text: &str| text.trim().parse() == Ok(0.0);
    let (is_plain, shown) = match value {
        Value::Number(number, _) => (*number != 0.0, number.to_string()),
        Value::Text(text) => (is_plain(&text.text) && !is_zero(&text.text), text.text.trim().to_owned()),
        _ => return,
    };
    if is_plain && *factor != 1.0 {
        let error = Diagnostic::error(format!(
            "`{name}` needs a unit: numbers of a scene are in SI units, those of its model in {unit}"
        ));
        // The model's own angles and ratios have no unit of SI but rad.
        let si = unit::parse(unit).map_or(Unit::NONE, |scale| scale.unit);
        let si = if si == Unit::NONE { "rad".to_owned() } else { si.to_string() };
        let [si, own] = [si.as_str(), unit.as_str()].map(|unit| with_units(&shown, unit));
        let example = match (si, own) {
            (Some(si), Some(own)) => format!("for example \"{si}\", or \"{own}\" if that is meant"),
            (Some(si), None) => format!("for example \"{si}\""),
            (None, _) => "write it with its unit, as an expression".to_owned(),
        };
        found.push(error.label(value.span(), "without unit").help(example));
    }
}

/// A number with its unit as expressions write it: 2 with `mN m/deg` is `2_mN*1_m/1_deg`; None for a unit with powers
/// that are no whole numbers, or with products within products.
fn with_units(number: &str, unit: &str) -> Option<String> {
    let (above, below) = unit.split_once('/').unwrap_or((unit, ""));
    let below = below.strip_prefix('(').and_then(|inner| inner.strip_suffix(')')).unwrap_or(below);
    if [above, below].iter().any(|part| part.contains(['(', ')', '/', '-'])) {
        return None;
    }
    let mut written = number.to_owned();
    for (part, mark) in [(above, '*'), (below, '/')] {
        for factor in part.split([' ', '*']).filter(|factor| !factor.is_empty() && *factor != "1") {
            let (name, power) = factor.split_once('^').unwrap_or((factor, "1"));
            for _ in 0..power.parse::<u32>().ok()? {
                let is_first = written.len() == number.len() && mark == '*';
                written += &if is_first { format!("_{name}") } else { format!("{mark}1_{name}") };
            }
        }
    }
    Some(written)
}
