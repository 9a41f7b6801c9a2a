//! Numbers with a bound of their rounding error: tells a small number from one that is nothing but rounding error.
//!
//! Running error analysis, first order: every operation propagates the errors of its operands by its derivatives and
//! adds its own; products of two errors are neglected.

use super::{Unary, evaluate};
use smartbed_runtime::real::Real;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Rounding error of one operation relative to its result: half a unit in the last place, doubled because functions are
/// not rounded correctly.
const UNIT: f64 = f64::EPSILON;

/// A number and a bound of its rounding error.
#[derive(Clone, Copy, Debug)]
pub struct Rounded {
    /// The number.
    pub value: f64,
    /// Absolute bound.
    pub error: f64,
}

impl Rounded {
    /// A number with an error that is known, plus the rounding of the number itself.
    #[must_use]
    pub fn new(value: f64, error: f64) -> Self {
        Self { value, error: error + UNIT * value.abs() }
    }

    /// The size of the terms that the number is made of, to which its rounding error is relative; 1 if there are none
    /// or the error is not finite.
    pub(crate) fn size(self) -> f64 {
        let size = self.error / UNIT;
        if size.is_finite() && size > 0.0 { size } else { 1.0 }
    }

    /// The number, or 0 if it is within its rounding error.
    pub(crate) fn cleaned(self) -> f64 {
        if self.value.abs() <= self.error { 0.0 } else { self.value }
    }

    /// f(x); its error is |f'(x)| times that of x.
    fn function(self, function: Unary) -> Self {
        let value = evaluate::unary(function, self.value);
        Self::new(value, evaluate::steepness(function, self.value, value) * self.error)
    }
}

impl Add for Rounded {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        Self::new(self.value + b.value, self.error + b.error)
    }
}

impl Sub for Rounded {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        self + -b
    }
}

impl Mul for Rounded {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        Self::new(self.value * b.value, self.value.abs() * b.error + self.error * b.value.abs())
    }
}

impl Div for Rounded {
    type Output = Self;
    fn div(self, b: Self) -> Self {
        let quotient = self.value / b.value;
        Self::new(quotient, (self.error + quotient.abs() * b.error) / b.value.abs())
    }
}

impl Neg for Rounded {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, error: self.error }
    }
}

impl Real for Rounded {
    const ZERO: Self = Self { value: 0.0, error: 0.0 };
    const ONE: Self = Self { value: 1.0, error: 0.0 };

    fn from_f64(x: f64) -> Self {
        Self::new(x, 0.0)
    }
    /// At 0 the slope is infinite, yet the root of an error is finite.
    fn sqrt(self) -> Self {
        let root = Real::sqrt(self.value);
        Self::new(root, self.error / root.max(self.error.sqrt()).max(f64::MIN_POSITIVE))
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = Real::sin_cos(self.value);
        (Self::new(sin, cos.abs() * self.error), Self::new(cos, sin.abs() * self.error))
    }
    fn tan(self) -> Self {
        self.function(Unary::Tan)
    }
    fn asin(self) -> Self {
        self.function(Unary::Asin)
    }
    fn acos(self) -> Self {
        self.function(Unary::Acos)
    }
    fn atan2(self, x: Self) -> Self {
        let square = self.value * self.value + x.value * x.value;
        let error = (x.value.abs() * self.error + self.value.abs() * x.error) / square;
        Self::new(Real::atan2(self.value, x.value), error)
    }
    fn exp(self) -> Self {
        self.function(Unary::Exp)
    }
    fn ln(self) -> Self {
        self.function(Unary::Ln)
    }
    fn tanh(self) -> Self {
        self.function(Unary::Tanh)
    }
    fn abs(self) -> Self {
        Self { value: self.value.abs(), ..self }
    }
    fn sign(self) -> Self {
        Self { value: Real::sign(self.value), error: 0.0 }
    }
    fn min(self, b: Self) -> Self {
        Self { value: Real::min(self.value, b.value), error: self.error.max(b.error) }
    }
    fn max(self, b: Self) -> Self {
        Self { value: Real::max(self.value, b.value), error: self.error.max(b.error) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// sin^2 + cos^2 - 1 is 0, scaled or not: what is left of it is within the bound, and the bound is small.
    #[test]
    fn what_cancels_is_within_the_bound() {
        for scale in [1e-9, 1.0, 1e9] {
            for i in 1..200 {
                let (sin, cos) = Rounded::from_f64(0.37 * f64::from(i)).sin_cos();
                let rest = Rounded::from_f64(scale) * (sin * sin + cos * cos - Rounded::ONE);
                assert!(rest.value.abs() <= rest.error, "{rest:?}");
                assert!(rest.error < 1e-13 * scale * f64::from(i), "{rest:?}");
            }
        }
        let (sin, _) = Rounded::from_f64(1e-9).sin_cos();
        assert!(sin.error < 1e-6 * sin.value, "{sin:?}: a small number is no rounding error");
    }
}
