//! The guard: admits a new definition only if it rounds off hardly more than the old one.
//!
//! At a list of states every class carries its value and a first-order bound of its round-off error, both in f64. An
//! identity keeps the value, but may change the round-off error by cancellation. So a definition is admitted only if
//! its bound stays close to that of the class.

use crate::expr::{Binary, Unary, evaluate};

/// Half the spacing of f64 at 1: relative error of one rounding.
const ROUNDING: f64 = f64::EPSILON / 2.0;
/// A new definition's bound may be this many times the old one, plus [`MORE_ROUNDINGS`].
const WORSE: f64 = 2.0;
/// Roundings of the value that a new definition's bound may have in addition.
const MORE_ROUNDINGS: f64 = 4.0;
/// A sum below this share of its terms cancels: admitted only if its bound is no larger than the old one.
const CANCELS: f64 = 1e-3;

/// A value at one state, with a bound of its round-off error.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Estimate {
    /// The value in f64.
    pub value: f64,
    /// First-order bound of its absolute error.
    pub error: f64,
    /// Is it a sum that cancels most of its terms?
    pub cancels: bool,
}

impl Estimate {
    /// A number that is known exactly.
    #[inline]
    pub fn exact(value: f64) -> Self {
        Self { value, error: 0.0, cancels: false }
    }

    /// A constant rounded once.
    #[inline]
    pub fn rounded(value: f64) -> Self {
        Self::computed(value, 0.0)
    }

    /// Result of an operation; `inherited` is the error propagated from the operands.
    #[inline]
    fn computed(value: f64, inherited: f64) -> Self {
        Self { value, error: inherited + ROUNDING * value.abs(), cancels: false }
    }

    #[inline]
    pub fn signed(self, negative: bool) -> Self {
        Self { value: if negative { -self.value } else { self.value }, ..self }
    }

    #[inline]
    pub fn sum(a: Self, b: Self) -> Self {
        let value = a.value + b.value;
        let cancels = value.abs() < CANCELS * a.value.abs().max(b.value.abs());
        Self { cancels, ..Self::computed(value, a.error + b.error) }
    }

    #[inline]
    pub fn product(a: Self, b: Self) -> Self {
        Self::computed(a.value * b.value, a.value.abs() * b.error + b.value.abs() * a.error)
    }

    #[inline]
    pub fn quotient(a: Self, b: Self) -> Self {
        let value = a.value / b.value;
        Self::computed(value, (a.error + value.abs() * b.error) / b.value.abs())
    }

    /// f(a): the operand's error times the derivative.
    pub fn unary(function: Unary, a: Self) -> Self {
        let (x, value) = (a.value, evaluate::unary(function, a.value));
        let inherited = if a.error == 0.0 { 0.0 } else { evaluate::steepness(function, x, value) * a.error };
        Self::computed(value, inherited)
    }

    /// The functions of two arguments.
    pub fn binary(operator: Binary, a: Self, b: Self) -> Self {
        let value = evaluate::binary(operator, a.value, b.value);
        let inherited = match operator {
            Binary::Atan2 => {
                let square = a.value * a.value + b.value * b.value;
                (b.value.abs() * a.error + a.value.abs() * b.error) / square
            }
            _ => a.error.max(b.error),
        };
        Self::computed(value, inherited)
    }

    /// May `new` replace this? Both are the same function of the state.
    #[inline]
    pub fn admits(&self, new: &Self) -> bool {
        if !self.error.is_finite() || !self.value.is_finite() {
            return true; // a pole: the old definition is no better there
        }
        let limit = if new.cancels {
            self.error
        } else {
            WORSE * self.error + MORE_ROUNDINGS * ROUNDING * self.value.abs()
        };
        // Values that differ by more than their errors do not belong to the same function.
        let apart = (self.value - new.value).abs();
        new.error <= limit && apart <= WORSE * (self.error + new.error)
    }
}

/// The largest ratio of new to old bound over all states (at least 1), or `None` if some state does not admit the new
/// one.
#[inline]
pub(crate) fn admits(
    old: impl Iterator<Item = Estimate>,
    new: impl Iterator<Item = Estimate>,
) -> Option<f64> {
    let mut most = 1.0_f64;
    for (old, new) in old.zip(new) {
        if !old.admits(&new) {
            return None;
        }
        if new.error > old.error {
            let rounding = ROUNDING * old.value.abs();
            most = most.max((new.error + rounding) / (old.error + rounding));
        }
    }
    Some(most)
}

#[cfg(test)]
mod tests {
    use super::*;

    const ONE: Estimate = Estimate { value: 1.0, error: 0.0, cancels: false };

    /// 1 - cos x near zero against 2 sin(x/2)^2, as it was.
    #[test]
    fn a_cancelling_form_is_refused_and_the_product_form_admitted() {
        for x in [1e-2, 1e-4, 1e-6] {
            let half = Estimate::unary(Unary::Sin, Estimate::exact(0.5 * x));
            let product = Estimate::product(Estimate::exact(2.0), Estimate::product(half, half));
            let difference = Estimate::sum(ONE, Estimate::unary(Unary::Cos, Estimate::exact(x)).signed(true));
            assert!(!product.admits(&difference), "{x}: {product:?} {difference:?}");
            assert!(difference.admits(&product), "{x}");
        }
    }

    /// To first order: the derivative times the operand's error.
    #[test]
    fn functions_hand_on_the_error_of_their_operand() {
        for (function, x, slope) in
            [(Unary::Sqrt, 4.0, 0.25), (Unary::Sin, 0.3, 0.3_f64.cos()), (Unary::Cos, 1.0, 1.0_f64.sin())]
        {
            let found = Estimate::unary(function, Estimate { value: x, error: 1e-9, cancels: false });
            assert!((found.error / (slope * 1e-9) - 1.0).abs() < 1e-3, "{function:?}: {found:?}");
        }
        // The root is steep without bound at 0, where it is exact.
        assert_eq!(Estimate::unary(Unary::Sqrt, Estimate::exact(0.0)).error, 0.0);
    }

    #[test]
    fn away_from_zero_both_forms_are_admitted() {
        let x = 2.0;
        let half = Estimate::unary(Unary::Sin, Estimate::exact(0.5 * x));
        let product = Estimate::product(Estimate::exact(2.0), Estimate::product(half, half));
        let difference = Estimate::sum(ONE, Estimate::unary(Unary::Cos, Estimate::exact(x)).signed(true));
        assert!(product.admits(&difference) && difference.admits(&product));
    }

    /// a^2 - b^2 against (a + b)(a - b) for nearly equal sides of a linkage.
    #[test]
    fn the_difference_of_squares_is_refused_where_the_factors_are_near() {
        let (a, b) = (Estimate::exact(1.0), Estimate::exact(1.0 + 1e-7));
        let factored = Estimate::product(Estimate::sum(a, b), Estimate::sum(a, b.signed(true)));
        let squares = Estimate::sum(Estimate::product(a, a), Estimate::product(b, b).signed(true));
        assert!(!factored.admits(&squares) && squares.admits(&factored));
    }

    #[test]
    fn the_bound_holds_what_rounding_does() {
        for k in 1..200 {
            let x = f64::from(k) * 0.0137;
            let tenth = Estimate::rounded(0.1);
            let y = Estimate::product(Estimate::sum(Estimate::exact(x), tenth), tenth);
            // In units of 2^-70, exactly, through integers: (x + 0.1) 0.1 of the decimal 0.1.
            let exact = (x + 0.1) * 0.1;
            assert!((y.value - exact).abs() <= y.error, "{x}");
        }
    }

    #[test]
    fn a_function_that_differs_is_refused() {
        assert!(!ONE.admits(&Estimate::exact(1.0 + 1e-9)));
        assert!(!ONE.admits(&Estimate::exact(f64::NAN)));
    }
}
