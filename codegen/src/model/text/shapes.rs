//! Mass and inertia of a body from its shape and density, in closed form.
//!
//! In: the fields of a body. Out: its amount (the volume, area or length to which the density refers) and its moments
//! of inertia about the mass centre per unit of mass, along the frame's axes. Formulas: Beer & Johnston, Vector
//! Mechanics, inside back cover.

use super::builder::{Builder, si};
use super::document::{Value, wrong_kind};
use super::fields::Fields;
use crate::diagnostic::Diagnostic;
use crate::model::data::ShapeKind;
use crate::model::expression::{Axis, Expr, ExprKind};
use crate::model::unit::Unit;
use crate::source::Span;

/// A shape's contribution to mass and inertia.
pub(super) struct Solid {
    /// Volume; for a disc its area, for a rod its length.
    pub amount: Expr,
    /// Unit of the density: mass per amount.
    pub density: Unit,
    /// Moments of inertia per unit of mass about x, y, z; `None` where 0.
    pub moments: [Option<Expr>; 3],
    /// Its lengths, and the difference of the radii of a hollow one.
    pub lengths: Vec<Expr>,
    /// The shape for pictures: its kind, its lengths, its axis.
    pub picture: Option<(ShapeKind, Vec<Expr>, Axis)>,
}

/// Amount, moment about the axis, and moment about a perpendicular to it.
type Round = (Expr, Option<Expr>, Expr);

/// The shapes of the language: word, number of lengths, example.
const WORDS: [(&str, usize, &str); 8] = [
    ("box", 3, "the lengths of three edges: box = [1, 0.5, \"20_mm\"]"),
    ("ball", 1, "a radius: ball = 0.02"),
    ("shell", 2, "outer and inner radius: shell = [\"R\", \"R - 2_mm\"]"),
    ("cylinder", 2, "radius and length: cylinder = [\"R\", 0.1]"),
    ("tube", 3, "outer radius, inner radius and length: tube = [\"R\", \"R - 2_mm\", 0.1]"),
    ("capsule", 2, "radius and length between the centres of the caps: capsule = [\"R\", 0.1]"),
    ("disc", 1, "the radius of a thin disc: disc = 0.2"),
    ("rod", 1, "the length of a thin rod: rod = \"l\""),
];

impl Builder<'_> {
    /// The shape of a body, if it has one; `Err` if an error has been reported.
    pub(super) fn solid(&mut self, fields: &Fields<'_>) -> Result<Option<Solid>, ()> {
        let given: Vec<_> =
            WORDS.into_iter().filter_map(|word| fields.get(word.0).map(|value| (word, value))).collect();
        let Some(&((word, count, example), value)) = given.first() else { return Ok(None) };
        // A box has no axis: to it, and to a body without a shape, `axis` is an unknown field.
        let axis = if word == "box" { None } else { fields.get("axis") };
        let axis = axis.and_then(|axis| self.axis_of(axis)).unwrap_or(Axis::Z);
        if let Some(((other, ..), value)) = given.get(1) {
            self.found.push(
                Diagnostic::error(format!("body `{}` has two shapes", fields.name))
                    .label(value.span(), format!("{other} beside {word}"))
                    .help("a body of several parts is several bodies on one frame"),
            );
            return Err(());
        }
        let items = match value {
            Value::Array(items, _) if items.len() == count => items.as_slice(),
            one @ (Value::Number(..) | Value::Text(_)) if count == 1 => std::slice::from_ref(one),
            other => {
                self.found.push(wrong_kind(word, example, other));
                return Err(());
            }
        };
        let sizes: Vec<Expr> = items.iter().map(|item| self.quantity(item, si(Unit::LENGTH))).collect();
        Ok(Some(of(word, sizes, axis, value.span())))
    }
}

/// The unit of a density: kg per some power of m.
fn per_length(power: usize) -> Unit {
    (0..power).fold(Unit::MASS, |unit, _| unit.per(Unit::LENGTH).unwrap_or(unit))
}

/// The shape called `word`.
fn of(word: &str, sizes: Vec<Expr>, axis: Axis, span: Span) -> Solid {
    let n = |x: f64| Expr { kind: ExprKind::Number(x), span, unit: Unit::NONE };
    let pi = || Expr { kind: ExprKind::Pi, span, unit: Unit::NONE };
    let s = |i: usize| sizes[i].clone();
    let of_fifths = |numerator: Expr| numerator * n(2.0) / n(5.0);
    if word == "box" {
        let squares = |a: usize, b: usize| Some((s(a).power(2) + s(b).power(2)) / n(12.0));
        let moments = [squares(1, 2), squares(0, 2), squares(0, 1)];
        let amount = s(0) * s(1) * s(2);
        return Solid {
            amount,
            density: per_length(3),
            moments,
            lengths: sizes.clone(),
            picture: Some((ShapeKind::Box, sizes, axis)),
        };
    }
    let (amount, along, across): Round = match word {
        "ball" => {
            let moment = of_fifths(s(0).power(2));
            (n(4.0) * pi() * s(0).power(3) / n(3.0), Some(moment.clone()), moment)
        }
        "shell" => {
            let of = |k: i32| s(0).power(k) - s(1).power(k);
            let moment = of_fifths(of(5)) / of(3);
            (n(4.0) * pi() * of(3) / n(3.0), Some(moment.clone()), moment)
        }
        "cylinder" => (
            pi() * s(0).power(2) * s(1),
            Some(s(0).power(2) / n(2.0)),
            (n(3.0) * s(0).power(2) + s(1).power(2)) / n(12.0),
        ),
        "tube" => {
            let squares = || s(0).power(2) + s(1).power(2);
            let across = (n(3.0) * squares() + s(2).power(2)) / n(12.0);
            (pi() * (s(0).power(2) - s(1).power(2)) * s(2), Some(squares() / n(2.0)), across)
        }
        "capsule" => {
            // The cylinder has the share l/(l + 4r/3) of the mass; the rest is two half balls, centred 3r/8 outside its
            // ends.
            let (square, ends) = (|| s(0).power(2), || n(4.0) * s(0) / n(3.0));
            let whole = || s(1) + ends();
            let along = (s(1) * square() / n(2.0) + ends() * of_fifths(square())) / whole();
            let cylinder = s(1).power(2) / n(12.0) + square() / n(4.0);
            let caps = of_fifths(square()) + s(1).power(2) / n(4.0) + n(3.0) * s(1) * s(0) / n(8.0);
            let across = (s(1) * cylinder + ends() * caps) / whole();
            (pi() * square() * whole(), Some(along), across)
        }
        "disc" => (pi() * s(0).power(2), Some(s(0).power(2) / n(2.0)), s(0).power(2) / n(4.0)),
        _ => (s(0), None, s(0).power(2) / n(12.0)),
    };
    let picture = match word {
        "cylinder" => Some((ShapeKind::Cylinder, vec![s(0), s(1)], axis)),
        "tube" => Some((ShapeKind::Cylinder, vec![s(0), s(2)], axis)),
        "ball" | "shell" => Some((ShapeKind::Ball, vec![s(0)], axis)),
        _ => None,
    };
    let moments =
        [Axis::X, Axis::Y, Axis::Z].map(|a| if a == axis { along.clone() } else { Some(across.clone()) });
    let density = per_length(if word == "disc" {
        2
    } else if word == "rod" {
        1
    } else {
        3
    });
    let wall = matches!(word, "shell" | "tube").then(|| s(0) - s(1));
    let lengths = sizes.iter().cloned().chain(wall).collect();
    Solid { amount, density, moments, lengths, picture }
}
