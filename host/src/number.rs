//! Numbers as text: 17 significant digits, which read back as the same f64.

use std::fmt::Write as _;

/// `x` with 17 significant digits; valid in JSON and CSV if `x` is finite.
#[must_use]
pub fn digits(x: f64) -> String {
    format!("{x:.16e}")
}

/// Rounds to six significant digits: a third of a hundredth is written 0.00333333.
#[must_use]
pub fn six_digits(x: f64) -> f64 {
    format!("{x:.5e}").parse().unwrap_or(x)
}

/// For people: six decimals, or an exponent if these would show too few or too many digits.
#[must_use]
pub fn short(x: f64) -> String {
    if x == 0.0 || (1e-2..1e7).contains(&x.abs()) { format!("{x:.6}") } else { format!("{x:.6e}") }
}

/// The fewest digits that read back as the same number, with an exponent in place of many zeros.
#[must_use]
pub fn fewest_digits(x: f64) -> String {
    if x == 0.0 || (1e-6..1e15).contains(&x.abs()) { format!("{x}") } else { format!("{x:e}") }
}

/// `{"name": value, ...}` in the given order; a value that is not finite becomes `null`.
pub fn json_object<'a>(entries: impl IntoIterator<Item = (&'a str, f64)>) -> String {
    let mut text = String::from("{");
    for (n, (name, value)) in entries.into_iter().enumerate() {
        let separator = if n == 0 { "" } else { ", " };
        let _ = write!(text, "{separator}{}: {}", json_string(name), json_number(value));
    }
    text + "}"
}

/// A JSON number; the word `"inf"` or `"-inf"` for what is infinite, `null` for no number.
pub fn json_number_or_word(x: f64) -> String {
    if x.is_infinite() { format!("\"{x}\"") } else { json_number(x) }
}

/// A JSON number, or `null`.
#[must_use]
pub fn json_number(x: f64) -> String {
    if x.is_finite() { digits(x) } else { "null".to_owned() }
}

/// A JSON string with its quotes.
#[must_use]
pub fn json_string(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}

/// The maximum of the worst value so far and a magnitude. NaN counts as the worst and is kept; `max` would drop it.
#[must_use]
pub fn worst(so_far: f64, x: f64) -> f64 {
    if so_far.is_nan() || so_far >= x.abs() { so_far } else { x.abs() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn not_a_number_is_the_worst_and_stays() {
        let of = |list: &[f64]| list.iter().fold(0.0, |sum, x| worst(sum, *x));
        assert_eq!(of(&[1.0, -3.0, 2.0]), 3.0);
        assert!(of(&[1.0, f64::NAN, 2.0]).is_nan());
        assert!(of(&[f64::NAN]).is_nan());
        assert_eq!(of(&[]), 0.0);
    }

    #[test]
    fn digits_read_back() {
        for x in [0.1, -1.0 / 3.0, 5e-324, f64::MAX, 0.0, -0.0] {
            assert_eq!(digits(x).parse::<f64>().map(f64::to_bits), Ok(x.to_bits()));
        }
        assert_eq!(digits(0.1), "1.0000000000000001e-1");
    }

    #[test]
    fn short_numbers_have_their_points_below_one_another() {
        let texts = [0.0, -1.25, 1e-5, 2e9, f64::NAN].map(short);
        assert_eq!(texts, ["0.000000", "-1.250000", "1.000000e-5", "2.000000e9", "NaN"]);
    }

    #[test]
    fn json_is_json() {
        let text = json_object([("a\"b", 0.5), ("c", f64::NAN)]);
        let value: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        assert_eq!(value["a\"b"], 0.5);
        assert!(value["c"].is_null());
    }
}
