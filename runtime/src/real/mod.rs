//! The scalar of all kernels: `Real` for arithmetic (lanes included), `Scalar` for what compares.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A real number, or lanes of them. No comparison: code over `Real` is branch-free.
pub trait Real:
    Copy
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + 'static
{
    /// 0.
    const ZERO: Self;
    /// 1.
    const ONE: Self;
    /// The nearest representable number, rounded once.
    fn from_f64(x: f64) -> Self;
    /// Square root.
    #[must_use]
    fn sqrt(self) -> Self;
    /// (sin, cos) of an angle [rad].
    fn sin_cos(self) -> (Self, Self);
    /// Tangent.
    #[must_use]
    fn tan(self) -> Self;
    /// Inverse sine.
    #[must_use]
    fn asin(self) -> Self;
    /// Inverse cosine.
    #[must_use]
    fn acos(self) -> Self;
    /// Angle of the vector (x, y) with y = `self`.
    #[must_use]
    fn atan2(self, x: Self) -> Self;
    /// Exponential.
    #[must_use]
    fn exp(self) -> Self;
    /// Natural logarithm.
    #[must_use]
    fn ln(self) -> Self;
    /// Hyperbolic tangent.
    #[must_use]
    fn tanh(self) -> Self;
    /// Absolute value.
    #[must_use]
    fn abs(self) -> Self;
    /// Sign: -1, 0 or 1.
    #[must_use]
    fn sign(self) -> Self;
    /// The smaller of two.
    #[must_use]
    fn min(self, other: Self) -> Self;
    /// The larger of two.
    #[must_use]
    fn max(self, other: Self) -> Self;
}

/// A single real number that compares: f32 or f64.
pub trait Scalar: Real + PartialOrd {
    /// Distance from 1 to the next number.
    const EPSILON: Self;
    /// Neither infinite nor not-a-number.
    fn is_finite(self) -> bool;
    /// Exact widening.
    fn to_f64(self) -> f64;
}
