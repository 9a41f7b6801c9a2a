//! Reads one number with its unit outside of any model: `"5_kg"`, `"9.81 m/s^2"`, `"2*pi*3_mm"`.
//!
//! In: the text, and the unit it must have. Out: the value in SI units, or findings at the place within the text.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::id::IdVec;
use crate::model::draft::Draft;
use crate::model::text::document::Text;
use crate::model::text::expression;
use crate::model::text::scope::Scope;
use crate::model::unit::{self, Unit};
use crate::model::unit_hint::unit_hint;

use super::evaluate::Constants;
use super::infer::{Checker, Type};

/// The value in SI units; `None` if an error was found. `what` names the quantity in messages.
pub fn quantity(text: &Text, unit: Unit, what: &str, found: &mut Diagnostics) -> Option<f64> {
    if let Some(value) = number_and_unit(text, unit, what, found) {
        return value;
    }
    let before = found.items.len();
    let expr = expression::parse(text, &Scope::default(), found)?;
    let draft = Draft::empty(&found.source);
    let mut checker = Checker { draft: &draft, definitions: Vec::new(), found };
    checker.expect(&expr, Type::scalar(unit), what);
    if found.items.len() > before {
        return None;
    }
    let value = Constants { parameters: IdVec::default(), definitions: IdVec::default() }.value(&expr);
    if !value.is_finite() {
        let error = Diagnostic::error(format!("{what} has no finite constant value"));
        let help = "look for the time t, a division by 0, a root of a negative number, or a number too large";
        found.push(error.label(text.span, format!("evaluates to {value}")).help(help));
        return None;
    }
    Some(value)
}

/// Reads the short form `5 N s/m` or `5_kN/m`: a number, a blank or `_`, and a unit. The outer `None` means that the
/// text has another form, the inner one that its unit is wrong or unknown (reported).
fn number_and_unit(text: &Text, wanted: Unit, what: &str, found: &mut Diagnostics) -> Option<Option<f64>> {
    let whole = text.text.trim();
    let (number, rest) = whole.split_once([' ', '_'])?;
    let number: f64 = number.parse().ok().filter(|x: &f64| x.is_finite())?;
    let rest = rest.trim();
    let scale = match unit::parse(rest) {
        Ok(scale) => scale,
        // No expression goes on with a word behind a number and a blank.
        Err((message, _)) if !whole.contains('_') && rest.starts_with(char::is_alphabetic) => {
            let help = unit_hint(rest)
                .unwrap_or_else(|| format!("give it as a number in {wanted}, or with such a unit"));
            let error = Diagnostic::error(format!("{what}: {message}"));
            found.push(error.label(text.span, "in this unit").help(help));
            return Some(None);
        }
        Err(_) => return None,
    };
    if scale.unit == wanted {
        return Some(Some(number * scale.factor));
    }
    let error = Diagnostic::error(format!("{what} must be in {wanted}"));
    let label = format!("this is in {}", scale.unit);
    found.push(
        error.label(text.span, label).help(format!("give it as a number in {wanted}, or with such a unit")),
    );
    Some(None)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::{Source, Span};

    fn read(text: &str, unit: &str) -> Result<f64, String> {
        let span = Span { start: 0, end: text.len(), file: 0 };
        let mut found = Diagnostics::new(Source::new("s.toml", text));
        let unit = unit::parse(unit).expect("a unit").unit;
        let value = quantity(&Text::bare(text, span), unit, "the mass", &mut found);
        value.ok_or_else(|| found.to_string())
    }

    #[test]
    fn quantities_carry_units() {
        for (text, unit, value) in [
            ("5_kg", "kg", 5.0),
            ("20_mm", "m", 0.02),
            ("9.81 m/s^2", "m/s^2", 9.81),
            ("2 kN/m", "N/m", 2000.0),
            ("2_kN/m", "N/m", 2000.0),
            ("3_mm*4", "m", 0.012),
            ("30_deg", "rad", std::f64::consts::PI / 6.0),
            ("0", "kg", 0.0),
        ] {
            let read = read(text, unit).unwrap_or_else(|found| panic!("{text}: {found}"));
            assert!((read - value).abs() <= 1e-15 * value, "{text}: {read}");
        }
    }

    #[test]
    fn wrong_quantities_are_refused_with_both_units() {
        for (text, words) in [
            ("5_m", "the mass must be in kg"),
            ("5 m/s", "this is in m/s"),
            ("5_kg/m", "this is in kg/m"),
            ("5", "the mass must be in kg"),
            ("5_kgg", "unknown unit `kgg`"),
            ("3 rev/s", "the mass: unknown unit `rev`"),
            ("m + 1", "unknown name `m`"),
            ("1_kg/0", "no finite constant value"),
            ("t*1_kg/1_s", "no finite constant value"),
            ("5_kg +", "not an expression"),
        ] {
            let found = read(text, "kg").expect_err(text);
            assert!(found.contains(words) && found.contains("s.toml:1:"), "{text}: {found}");
        }
    }
}
