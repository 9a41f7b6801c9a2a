//! Reads the fields of an entry: expressions, quantities, units, names of other entries.

use super::builder::{Builder, si, unreadable};
use super::document::wrong_kind;
use super::document::{Text, Value};
use super::expression;
use super::fields::Fields;
use super::scope::{Binding, Scope, suggestion};
use crate::diagnostic::Diagnostic;
use crate::model::expression::{Axis, Expr, ExprKind};
use crate::model::ids::*;
use crate::model::unit::{self, Scale, Unit};
use crate::model::unit_hint::unit_hint;
use crate::source::Span;

impl Builder<'_> {
    /// An expression whose numbers carry their own units.
    pub(super) fn expression(&mut self, value: &Value) -> Expr {
        match value {
            Value::Text(text) => {
                expression::parse(text, self.scope, self.found).unwrap_or_else(|| unreadable(text.span))
            }
            Value::Number(number, span) => {
                self.finite(*number, *span);
                Expr { kind: ExprKind::Number(*number), span: *span, unit: Unit::NONE }
            }
            other => {
                let help = match other {
                    Value::Array(..) => {
                        "a vector is a sum of its components, such as \"0.1_m*N.x + 0.2_m*N.y\""
                    }
                    _ => "a number, such as 0.1, or an expression in quotes, such as \"2*l\"",
                };
                self.found.push(
                    Diagnostic::error("expected a number or an expression in quotes")
                        .label(other.span(), format!("this is {}", other.kind()))
                        .help(help),
                );
                unreadable(other.span())
            }
        }
    }

    fn finite(&mut self, number: f64, span: Span) {
        if !number.is_finite() {
            self.found.push(
                Diagnostic::error("the number is not finite")
                    .label(span, "here")
                    .help("write a finite number"),
            );
        }
    }

    /// A quantity: plain numbers, quoted or not, are in the declared unit; an expression with names carries its own
    /// units.
    pub(super) fn quantity(&mut self, value: &Value, scale: Scale) -> Expr {
        let of_unit = |number: f64, scale: Scale| Expr {
            kind: ExprKind::Number(number * scale.factor),
            span: value.span(),
            unit: scale.unit,
        };
        let (is_plain, number) = match value {
            Value::Number(number, _) => (true, Some(*number)),
            Value::Text(text) if is_plain(&text.text) => (true, text.text.trim().parse().ok()),
            _ => (false, None),
        };
        let expr = number.map_or_else(|| self.expression(value), |number| of_unit(number, si(Unit::NONE)));
        let Some(number) = fold(&expr).filter(|_| is_plain) else { return expr };
        self.finite(number, value.span());
        of_unit(number, scale)
    }

    /// An optional field: a vector or scalar.
    pub(super) fn optional(&mut self, fields: &Fields<'_>, name: &'static str, unit: Unit) -> Option<Expr> {
        fields.get(name).map(|value| self.quantity(value, si(unit)))
    }

    /// A required field: a vector or scalar.
    pub(super) fn needed(
        &mut self,
        fields: &Fields<'_>,
        name: &'static str,
        unit: Unit,
        example: &str,
    ) -> Expr {
        match fields.need(name, example, self.found) {
            Some(value) => self.quantity(value, si(unit)),
            None => unreadable(fields.span),
        }
    }

    /// The field `unit`: its text (coherent SI) and its scale; no dimension if missing.
    pub(super) fn unit(&mut self, fields: &Fields<'_>) -> (String, Option<Scale>) {
        let Some(text) = fields.text("unit", self.found) else { return ("1".to_owned(), None) };
        match unit::parse(text.text.trim()) {
            Ok(scale) if scale.factor == 1.0 => (text.text.trim().to_owned(), Some(scale)),
            Ok(scale) if scale.unit == Unit::NONE => ("rad".to_owned(), Some(scale)),
            Ok(scale) => (scale.unit.to_string(), Some(scale)),
            Err((message, range)) => {
                let name = text.text.get(range.clone()).unwrap_or("");
                let help = unit_hint(name)
                    .unwrap_or_else(|| "units are products of powers: kg m^2, N s/m, m/s^2, deg".to_owned());
                self.found
                    .push(Diagnostic::error(message).label(text.place(range), "in this unit").help(help));
                ("1".to_owned(), None)
            }
        }
    }

    /// The field `unit` as written; without it the coherent one.
    pub(super) fn written_unit(fields: &Fields<'_>, unit: &str) -> String {
        match fields.get("unit") {
            Some(Value::Text(text)) => text.text.trim().to_owned(),
            _ => unit.to_owned(),
        }
    }

    /// The name in a field, resolved.
    pub(super) fn name_of<T: Copy>(
        &mut self,
        value: Option<&Value>,
        kind: &str,
        look_up: impl Fn(&Scope, &str) -> Option<T>,
        known: impl Fn(&Scope) -> Vec<String>,
    ) -> Option<T> {
        let text = match value? {
            Value::Text(text) => text,
            other => {
                self.found.push(wrong_kind(kind, "a name in quotes", other));
                return None;
            }
        };
        let result = look_up(self.scope, &text.text);
        let is_name = text.text.chars().all(|c| c.is_alphanumeric() || c == '_');
        if result.is_none() && !is_name {
            self.found.push(
                Diagnostic::error(format!("expected the name of a {kind}, found an expression"))
                    .label(text.span, "this is no name")
                    .help(format!(
                        "declare the {kind} in [{kind}s] under a name of its own, and write that name here"
                    )),
            );
        } else if result.is_none() && !self.scope.twice.contains(&text.text) {
            let known = known(self.scope);
            self.found.push(
                Diagnostic::error(format!("unknown {kind} `{}`", text.text))
                    .label(text.span, format!("no {kind} of this model has this name"))
                    .help(suggestion(&text.text, known.iter().map(String::as_str)).unwrap_or_else(|| {
                        format!(
                            "known: {}",
                            if known.is_empty() { "none".to_owned() } else { known.join(", ") }
                        )
                    })),
            );
        }
        result
    }

    pub(super) fn frame_of(&mut self, value: Option<&Value>) -> Option<FrameId> {
        self.name_of(
            value,
            "frame",
            |scope, name| scope.frames.get(name).map(|(id, _)| *id),
            |scope| scope.frames.keys().cloned().collect(),
        )
    }

    pub(super) fn point_of(&mut self, value: Option<&Value>) -> Option<PointId> {
        let point = |binding: &Binding| if let Binding::Point(id) = binding { Some(*id) } else { None };
        self.name_of(
            value,
            "point",
            |scope, name| scope.values.get(name).and_then(|(b, _)| point(b)),
            |scope| {
                scope.values.iter().filter(|(_, (b, _))| point(b).is_some()).map(|(n, _)| n.clone()).collect()
            },
        )
    }

    pub(super) fn coordinate_of(&mut self, value: Option<&Value>) -> Option<CoordinateId> {
        let coordinate =
            |binding: &Binding| if let Binding::Coordinate(id) = binding { Some(*id) } else { None };
        self.name_of(
            value,
            "coordinate",
            |scope, name| scope.values.get(name).and_then(|(b, _)| coordinate(b)),
            |scope| {
                scope
                    .values
                    .iter()
                    .filter(|(_, (b, _))| coordinate(b).is_some())
                    .map(|(n, _)| n.clone())
                    .collect()
            },
        )
    }

    /// An axis by its letter.
    pub(super) fn axis_of(&mut self, value: &Value) -> Option<Axis> {
        let letter = if let Value::Text(Text { text, .. }) = value { text.as_str() } else { "" };
        match letter {
            "x" => Some(Axis::X),
            "y" => Some(Axis::Y),
            "z" => Some(Axis::Z),
            _ => {
                self.found.push(
                    Diagnostic::error(format!("unknown axis `{letter}`"))
                        .label(value.span(), "expected \"x\", \"y\" or \"z\"")
                        .help("rotations = [[\"z\", \"angle\"]]; for another axis, rotate by constant angles first"),
                );
                None
            }
        }
    }
}

/// Is the text a mere number: no name and no unit (`1e-3` has a letter, `2_m` a unit)?
#[must_use]
pub fn is_plain(text: &str) -> bool {
    let is_digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit() || c == '.');
    let mut before = None;
    text.chars().all(|c| {
        let last = before.replace(c);
        match c {
            'e' | 'E' => is_digit(last),
            '_' => false,
            _ => !c.is_alphabetic(),
        }
    })
}

/// The value of an expression of literals alone.
fn fold(expr: &Expr) -> Option<f64> {
    Some(match &expr.kind {
        ExprKind::Number(x) => *x,
        ExprKind::Negate(a) => -fold(a)?,
        ExprKind::Add(a, b) => fold(a)? + fold(b)?,
        ExprKind::Subtract(a, b) => fold(a)? - fold(b)?,
        ExprKind::Multiply(a, b) => fold(a)? * fold(b)?,
        ExprKind::Divide(a, b) => fold(a)? / fold(b)?,
        _ => return None,
    })
}
