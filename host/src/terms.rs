//! Expressions that the program writes itself, beside those of a model.
//!
//! In: expressions. Out: sums, products and components of them.

use smartbed_codegen::id::Id;
use smartbed_codegen::model::expression::{Expr, ExprKind};
use smartbed_codegen::model::unit::Unit;
use smartbed_codegen::model::{Axis, FrameId};
use smartbed_codegen::source::Span;

/// A vector's components in N.
pub(crate) fn components(vector: Expr) -> [Expr; 3] {
    let inertial = FrameId::from_index(0);
    [Axis::X, Axis::Y, Axis::Z].map(|axis| dot(vector.clone(), node(ExprKind::Axis(inertial, axis))))
}

/// An expression of this kind, which stands nowhere in a text.
pub(crate) fn node(kind: ExprKind) -> Expr {
    Expr { kind, span: Span::default(), unit: Unit::NONE }
}

/// A number.
pub(crate) fn number(x: f64) -> Expr {
    node(ExprKind::Number(x))
}

/// a + b.
pub(crate) fn add(a: Expr, b: Expr) -> Expr {
    node(ExprKind::Add(Box::new(a), Box::new(b)))
}

/// a b.
pub(crate) fn times(a: Expr, b: Expr) -> Expr {
    node(ExprKind::Multiply(Box::new(a), Box::new(b)))
}

/// -a.
pub(crate) fn negate(a: Expr) -> Expr {
    node(ExprKind::Negate(Box::new(a)))
}

/// a^2.
pub(crate) fn square(a: Expr) -> Expr {
    node(ExprKind::Power(Box::new(a), 2))
}

/// a . b.
pub(crate) fn dot(a: Expr, b: Expr) -> Expr {
    node(ExprKind::Dot(Box::new(a), Box::new(b)))
}
