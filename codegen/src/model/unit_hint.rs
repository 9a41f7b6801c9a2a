//! What to do about an unknown unit.
//!
//! In: the text that is no unit. Out: a sentence that names the unit that was meant, with the factor to it where it is
//! not the same: a hint that is followed blindly must not change a number.

use super::unit::names;

/// Units written out, as abbreviations of elsewhere, and what they are here.
const WORDS: [(&str, &str); 18] = [
    ("sec", "s"),
    ("minute", "min"),
    ("hour", "h"),
    ("pascal", "Pa"),
    ("volt", "V"),
    ("hertz", "Hz"),
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
const NUMBERS: [(&str, &str, &str); 8] = [
    ("rpm", "6", "deg/s"),
    ("in", "25.4", "mm"),
    ("inch", "25.4", "mm"),
    ("ft", "0.3048", "m"),
    ("lb", "0.45359237", "kg"),
    ("psi", "6.894757", "kPa"),
    ("atm", "101.325", "kPa"),
    ("torr", "1", "mmHg"),
];

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

/// Units of a product written without a space, such as `Nm` and `Pas`: of others, such as `degC`, nothing is known.
const FIRST: [&str; 13] = ["N", "mN", "kN", "Pa", "kPa", "J", "kJ", "W", "kW", "A", "V", "kg", "C"];
const SECOND: [&str; 5] = ["m", "mm", "cm", "s", "h"];

/// Units whose plural has an s.
const PLURAL: [&str; 8] = ["kg", "rad", "deg", "min", "bar", "mm", "cm", "km"];

/// What an unknown unit probably means: as [`single`], or two units without a space between them.
#[must_use]
pub fn unit_hint(name: &str) -> Option<String> {
    let halves = || name.char_indices().skip(1).map(|(i, _)| name.split_at(i));
    let two = || halves().find(|(a, b)| FIRST.contains(a) && SECOND.contains(b));
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
    if let Some(unit) = name.strip_suffix('s').filter(|unit| PLURAL.contains(unit)) {
        return Some(means(unit));
    }
    let prefixed = PREFIXES.iter().find_map(|(prefix, number)| {
        let unit = name.strip_prefix(prefix).filter(|unit| PREFIXED.contains(unit))?;
        Some(is(number, unit))
    });
    // In other letters, where they decide nothing: `mpa` may be `MPa` or a thousandth of `Pa`, `M` is not `m`.
    let rest = lower.get(1..).unwrap_or_default();
    let decides =
        rest.is_empty() || lower.starts_with('m') && PREFIXED.iter().any(|unit| unit.to_lowercase() == rest);
    prefixed.or_else(|| names().find(|unit| unit.to_lowercase() == lower && !decides).map(means))
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
            ("kgs", "did you mean `kg`?"),
            ("Ns", "did you mean `N s`?"),
            ("Pas", "did you mean `Pa s`?"),
            ("hours", "did you mean `h`?"),
            ("khz", "did you mean `kHz`?"),
        ] {
            let hint = unit_hint(given).expect(given);
            assert!(hint.starts_with(expected), "{given}: {hint}");
        }
        for unknown in ["quux", "degC", "grad", "H", "gm", "Nms", "M", "mpa", "mn"] {
            assert_eq!(unit_hint(unknown), None, "{unknown}");
        }
        let known = |(_, unit): &(&str, &str)| super::super::unit::parse(unit).is_ok();
        assert!(WORDS.iter().all(known));
    }
}
