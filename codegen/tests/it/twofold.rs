//! A scalar of twice the digits of f64, for oracles: an unevaluated sum of two f64 (Dekker 1971, Knuth 4.2.2).

use smartbed_runtime::real::Real;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// high + low, the second below the spacing of the first: an operation errs by some 1e-31.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Twofold {
    pub high: f64,
    low: f64,
}

const QUARTER_TURN: Twofold = Twofold { high: std::f64::consts::FRAC_PI_2, low: 6.123_233_995_736_766e-17 };
/// Terms of the series of sine and cosine up to an eighth of a turn: 0.8^27/27! is 2e-31.
const TERMS: u32 = 28;

impl Twofold {
    pub const fn new(x: f64) -> Self {
        Self { high: x, low: 0.0 }
    }

    /// a + b, exactly.
    fn two_sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let part = high - a;
        Self { high, low: (a - (high - part)) + (b - part) }
    }

    fn normal(high: f64, low: f64) -> Self {
        Self::two_sum(high, low)
    }
}

impl Add for Twofold {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (high, low) = (Self::two_sum(self.high, other.high), Self::two_sum(self.low, other.low));
        let sum = Self::normal(high.high, high.low + low.high);
        Self::normal(sum.high, sum.low + low.low)
    }
}

impl Neg for Twofold {
    type Output = Self;
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for Twofold {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Twofold {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let high = self.high * other.high;
        let lost = self.high.mul_add(other.high, -high);
        Self::normal(high, lost + (self.high * other.low + self.low * other.high))
    }
}

impl Div for Twofold {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        // Long division by three digits of 53 bits.
        let mut rest = self;
        let mut digits = [0.0; 3];
        for digit in &mut digits {
            *digit = rest.high / other.high;
            rest = rest - other * Self::new(*digit);
        }
        Self::new(digits[0]) + Self::new(digits[1]) + Self::new(digits[2])
    }
}

impl Real for Twofold {
    const ZERO: Self = Self::new(0.0);
    const ONE: Self = Self::new(1.0);

    fn from_f64(x: f64) -> Self {
        Self::new(x)
    }

    fn sqrt(self) -> Self {
        if self.high <= 0.0 {
            return Self::new(self.high.sqrt());
        }
        // A step of Newton's doubles the digits.
        let root = Self::new(self.high.sqrt());
        Self::new(0.5) * (root + self / root)
    }

    fn sin_cos(self) -> (Self, Self) {
        let turns = (self.high / QUARTER_TURN.high).round();
        let x = self - QUARTER_TURN * Self::new(turns);
        let (mut sin, mut cos, mut term) = (Self::ZERO, Self::ZERO, Self::ONE);
        for n in 0..TERMS {
            let sum = if n % 2 == 0 { &mut cos } else { &mut sin };
            *sum = if n % 4 < 2 { *sum + term } else { *sum - term };
            term = term * x / Self::new(f64::from(n + 1));
        }
        match turns.rem_euclid(4.0) as u8 {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        }
    }

    fn tan(self) -> Self {
        let (sin, cos) = self.sin_cos();
        sin / cos
    }

    fn abs(self) -> Self {
        if self.high < 0.0 { -self } else { self }
    }

    fn sign(self) -> Self {
        Self::new(Real::sign(self.high))
    }

    fn min(self, other: Self) -> Self {
        if (self - other).high < 0.0 { self } else { other }
    }

    fn max(self, other: Self) -> Self {
        if (self - other).high > 0.0 { self } else { other }
    }

    fn asin(self) -> Self {
        self.atan2(((Self::ONE - self) * (Self::ONE + self)).sqrt())
    }

    fn acos(self) -> Self {
        ((Self::ONE - self) * (Self::ONE + self)).sqrt().atan2(self)
    }

    fn atan2(self, x: Self) -> Self {
        // A turn by the angle in f64 leaves an angle so small that it is its tangent to twice the digits.
        let first = Self::new(self.high.atan2(x.high));
        let (sin, cos) = first.sin_cos();
        first + (self * cos - x * sin) / (x * cos + self * sin)
    }

    fn exp(self) -> Self {
        // e^x = (e^(x/1024))^1024: ten squarings.
        let x = self * Self::new(1.0 / 1024.0);
        let (mut sum, mut term) = (Self::ZERO, Self::ONE);
        for n in 0..TERMS {
            sum = sum + term;
            term = term * x / Self::new(f64::from(n + 1));
        }
        (0..10).fold(sum, |power, _| power * power)
    }

    fn ln(self) -> Self {
        // e^-y x = 1 + d with d so small that its square counts no more.
        let y = Self::new(self.high.ln());
        let rest = self * (-y).exp() - Self::ONE;
        y + rest - Self::new(0.5) * rest * rest
    }

    fn tanh(self) -> Self {
        let square = (self + self).exp();
        (square - Self::ONE) / (square + Self::ONE)
    }
}

/// sin^2 + cos^2 = 1, sqrt(x)^2 = x and the like: wrong digits would show.
#[test]
fn identities_hold_to_twice_the_digits() {
    for n in 0..40 {
        let x = Twofold::new(0.37 * f64::from(n) - 6.0) / Twofold::new(1.7);
        let (sin, cos) = x.sin_cos();
        let (double_sin, double_cos) = (x + x).sin_cos();
        let square = x * x + Twofold::ONE;
        let quotient = x / square;
        let off = [
            sin * sin + cos * cos - Twofold::ONE,
            double_sin - Twofold::new(2.0) * sin * cos,
            double_cos - (cos * cos - sin * sin),
            (square.sqrt() * square.sqrt() - square) / square,
            quotient * square - x,
            sin.asin().sin_cos().0 - sin,
            cos.acos().sin_cos().1 - cos,
            square.ln().exp() / square - Twofold::ONE,
            x.exp() * (-x).exp() - Twofold::ONE,
        ];
        assert!(off.iter().all(|off| off.high.abs() < 1e-28), "{n}: {off:?}");
    }
}
