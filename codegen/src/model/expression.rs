//! An expression of a model: a tree over the model's own names, with the place of every node.

use super::ids::{CoordinateId, DefinitionId, FrameId, InputId, ParameterId, PointId, SpeedId};
use super::unit::Unit;
use crate::source::Span;

/// A node of an expression and its place in the text.
#[derive(Clone, PartialEq, Debug)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// Where it stands.
    pub span: Span,
    /// Unit of a literal such as `0.12_m`; that of other nodes follows from their parts.
    pub unit: Unit,
}

/// The kinds of expressions. Whether one is a scalar or a vector follows from its parts and has been checked.
#[derive(Clone, PartialEq, Debug)]
pub enum ExprKind {
    /// A literal, already in SI units.
    Number(f64),
    /// Pi.
    Pi,
    /// The literal factor pi/180.
    Degree,
    /// Time t (s).
    Time,
    /// A parameter.
    Parameter(ParameterId),
    /// A coordinate.
    Coordinate(CoordinateId),
    /// The rate of a coordinate, written `q_dot(name)`; only in speed definitions and motion constraints.
    Rate(CoordinateId),
    /// A speed.
    Speed(SpeedId),
    /// An input.
    Input(InputId),
    /// A definition.
    Definition(DefinitionId),
    /// The position vector of a point from O.
    Point(PointId),
    /// The velocity of a point in N, written `velocity(P)`.
    Velocity(PointId),
    /// The angular velocity of a frame in N, written `angular_velocity(F)`.
    AngularVelocity(FrameId),
    /// A unit vector of a frame, written `F.x`.
    Axis(FrameId, Axis),
    /// -a.
    Negate(Box<Expr>),
    /// a + b.
    Add(Box<Expr>, Box<Expr>),
    /// a - b.
    Subtract(Box<Expr>, Box<Expr>),
    /// a * b; at most one is a vector.
    Multiply(Box<Expr>, Box<Expr>),
    /// a / b; b is a scalar.
    Divide(Box<Expr>, Box<Expr>),
    /// Integer power, written `a.powi(n)`.
    Power(Box<Expr>, i32),
    /// A function of scalars.
    Call(Function, Vec<Expr>),
    /// Dot product of two vectors.
    Dot(Box<Expr>, Box<Expr>),
    /// Cross product of two vectors.
    Cross(Box<Expr>, Box<Expr>),
    /// Length of a vector.
    Norm(Box<Expr>),
}

/// An axis of a frame.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Axis {
    /// First.
    X,
    /// Second.
    Y,
    /// Third.
    Z,
}

/// Functions of scalars.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Function {
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Tangent.
    Tan,
    /// Inverse sine.
    Asin,
    /// Inverse cosine.
    Acos,
    /// Angle of (x, y); arguments y, x.
    Atan2,
    /// Square root.
    Sqrt,
    /// Exponential.
    Exp,
    /// Natural logarithm.
    Ln,
    /// Hyperbolic tangent.
    Tanh,
    /// Absolute value.
    Abs,
    /// Sign.
    Sign,
    /// The smaller.
    Min,
    /// The larger.
    Max,
    /// `smooth_step(x, width)`: 0 for x << 0, 1 for x >> 0, cubic in between on [-width, width].
    SmoothStep,
}

impl Expr {
    /// An integer power, at the place of its base.
    #[must_use]
    pub fn power(self, exponent: i32) -> Self {
        let span = self.span;
        Self { kind: ExprKind::Power(Box::new(self), exponent), span, unit: Unit::NONE }
    }

    /// Joins two expressions by `kind`, at the place of the first.
    fn joined(self, other: Self, kind: fn(Box<Self>, Box<Self>) -> ExprKind) -> Self {
        let span = self.span;
        Self { kind: kind(Box::new(self), Box::new(other)), span, unit: Unit::NONE }
    }

    /// The direct parts.
    #[must_use]
    pub fn parts(&self) -> Vec<&Self> {
        match &self.kind {
            ExprKind::Negate(a) | ExprKind::Power(a, _) | ExprKind::Norm(a) => vec![a],
            ExprKind::Add(a, b)
            | ExprKind::Subtract(a, b)
            | ExprKind::Multiply(a, b)
            | ExprKind::Divide(a, b)
            | ExprKind::Dot(a, b)
            | ExprKind::Cross(a, b) => vec![a, b],
            ExprKind::Call(_, arguments) => arguments.iter().collect(),
            _ => Vec::new(),
        }
    }

    /// The expression with nodes replaced: `f` returns the replacement of a node, or `None` to keep it.
    #[must_use]
    pub fn replaced(&self, f: &dyn Fn(&Self) -> Option<Self>) -> Self {
        if let Some(other) = f(self) {
            return other;
        }
        let inner = |part: &Self| Box::new(part.replaced(f));
        let kind = match &self.kind {
            ExprKind::Negate(a) => ExprKind::Negate(inner(a)),
            ExprKind::Norm(a) => ExprKind::Norm(inner(a)),
            ExprKind::Power(a, n) => ExprKind::Power(inner(a), *n),
            ExprKind::Add(a, b) => ExprKind::Add(inner(a), inner(b)),
            ExprKind::Subtract(a, b) => ExprKind::Subtract(inner(a), inner(b)),
            ExprKind::Multiply(a, b) => ExprKind::Multiply(inner(a), inner(b)),
            ExprKind::Divide(a, b) => ExprKind::Divide(inner(a), inner(b)),
            ExprKind::Dot(a, b) => ExprKind::Dot(inner(a), inner(b)),
            ExprKind::Cross(a, b) => ExprKind::Cross(inner(a), inner(b)),
            ExprKind::Call(function, arguments) => {
                ExprKind::Call(*function, arguments.iter().map(|a| a.replaced(f)).collect())
            }
            other => other.clone(),
        };
        Self { kind, ..self.clone() }
    }

    /// Calls `f` on this node and everything below it, each before its parts.
    pub fn visit<'a>(&'a self, f: &mut dyn FnMut(&'a Self)) {
        let mut stack = vec![self];
        while let Some(node) = stack.pop() {
            f(node);
            stack.extend(node.parts().into_iter().rev());
        }
    }
}

impl std::ops::Add for Expr {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.joined(other, ExprKind::Add)
    }
}

impl std::ops::Sub for Expr {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.joined(other, ExprKind::Subtract)
    }
}

impl std::ops::Mul for Expr {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.joined(other, ExprKind::Multiply)
    }
}

impl std::ops::Div for Expr {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        self.joined(other, ExprKind::Divide)
    }
}
