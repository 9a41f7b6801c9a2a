//! What to do about an unknown unit.
//!
//! In: the text that is no unit. Out: a sentence that names the unit that was meant, with the factor to it where it is
//! not the same: a hint that is followed blindly must not change a number.

use super::unit::{named, names};

/// Units written out, as abbreviations of elsewhere, and what they are here.
const WORDS: [(&str, &str); 12] = [
    ("radian", "rad"),
    ("degree", "deg"),
    ("meter", "m"),
    ("metre", "m"),
    ("second", "s"),
    ("kilogram", "kg"),
    ("gram", "g"),
    ("newton", "N"),
    ("joule", "J"),
    ("watt", "W"),
    ("kph", "km/h"),
    ("mp", "m/s"),
];

/// Units of elsewhere that are a number of units here.
const NUMBERS: [(&str, &str, &str); 4] =
    [("rpm", "6", "deg/s"), ("in", "25.4", "mm"), ("inch", "25.4", "mm"), ("psi", "6.894757", "kPa")];

/// SI prefixes, the longer ones first.
const PREFIXES: [(&str, &str); 10] = [
    ("da", "10"),
    ("G", "1e9"),
    ("M", "1e6"),
    ("k", "1e3"),
    ("h", "100"),
    ("d", "0.1"),
    ("c", "0.01"),
    ("m", "1e-3"),
    ("u", "1e-6"),
    ("n", "1e-9"),
];

/// Units that take prefixes.
const PREFIXED: [&str; 13] = ["m", "s", "g", "Hz", "N", "J", "W", "Pa", "bar", "K", "A", "V", "C"];

/// What an unknown unit probably means: as [`single`], or two units without a space between them.
#[must_use]
pub fn unit_hint(name: &str) -> Option<String> {
    let halves = || name.char_indices().skip(1).map(|(i, _)| name.split_at(i));
    let two = || halves().find(|(a, b)| named(a).is_some() && named(b).is_some());
    single(name).or_else(|| two().map(|(a, b)| format!("did you mean `{a} {b}`?")))
}

/// The one unit that an unknown one probably means: of elsewhere, written out, with a prefix that is not known here, or
/// in other letters.
#[must_use]
pub fn single(name: &str) -> Option<String> {
    let means = |unit: &str| format!("did you mean `{unit}`?");
    let is = |number: &str, unit: &str| format!("1 {name} is {number} {unit}: give the value in `{unit}`");
    let lower = name.to_lowercase();
    if let Some((_, number, unit)) = NUMBERS.iter().find(|(word, ..)| *word == lower) {
        return Some(is(number, unit));
    }
    let singular = lower.strip_suffix('s').unwrap_or(&lower);
    if let Some((_, unit)) = WORDS.iter().find(|(word, _)| *word == singular) {
        return Some(means(unit));
    }
    let prefixed = PREFIXES.iter().find_map(|(prefix, number)| {
        let unit = name.strip_prefix(prefix).filter(|unit| PREFIXED.contains(unit))?;
        Some(is(number, unit))
    });
    prefixed.or_else(|| names().find(|unit| unit.to_lowercase() == lower).map(means))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A hint names the same quantity, or says by which number it differs.
    #[test]
    fn no_hint_changes_a_number() {
        for (given, expected) in [
            ("rpm", "1 rpm is 6 deg/s"),
            ("MN", "1 MN is 1e6 N"),
            ("hPa", "1 hPa is 100 Pa"),
            ("mW", "1 mW is 1e-3 W"),
            ("mbar", "1 mbar is 1e-3 bar"),
            ("mps", "did you mean `m/s`?"),
            ("kPA", "did you mean `kPa`?"),
            ("Nm", "did you mean `N m`?"),
            ("newtons", "did you mean `N`?"),
        ] {
            let hint = unit_hint(given).expect(given);
            assert!(hint.starts_with(expected), "{given}: {hint}");
        }
        assert_eq!(unit_hint("quux"), None);
        let known = |(_, unit): &(&str, &str)| super::super::unit::parse(unit).is_ok();
        assert!(WORDS.iter().all(known));
    }
}
