//! Double-double arithmetic: twice the digits of f64, for the reference values of the final check.
//!
//! A value is the unevaluated sum of two f64, the second smaller than the spacing of the first: 106 bits. Algorithms of
//! Dekker (1971) and Knuth; relative error of an operation about 1e-31.

use crate::expr::number::Number;
use crate::expr::{Binary, Dag, ExprId, Node, SymbolId, Unary, evaluate};
use crate::id::Id;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// high + low.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Double2 {
    pub high: f64,
    low: f64,
}

/// pi/2.
const QUARTER_TURN: Double2 = Double2 { high: std::f64::consts::FRAC_PI_2, low: 6.123_233_995_736_766e-17 };
/// Number of terms in the series of sine and cosine up to a quarter turn: 0.8^29/29! is 1e-34.
const TERMS: u32 = 29;

impl Double2 {
    pub const ZERO: Self = Self::new(0.0);
    pub const ONE: Self = Self::new(1.0);

    pub const fn new(x: f64) -> Self {
        Self { high: x, low: 0.0 }
    }

    /// a + b exactly.
    fn two_sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let part = high - a;
        Self { high, low: (a - (high - part)) + (b - part) }
    }

    /// a + b exactly for |a| >= |b|.
    fn quick_sum(a: f64, b: f64) -> Self {
        let high = a + b;
        Self { high, low: b - (high - a) }
    }

    /// a b exactly, by halves of 26 bits.
    fn two_product(a: f64, b: f64) -> Self {
        const SPLIT: f64 = 134_217_729.0; // 2^27 + 1
        let halves = |x: f64| {
            let c = SPLIT * x;
            let high = c - (c - x);
            (high, x - high)
        };
        let (high, (a1, a2), (b1, b2)) = (a * b, halves(a), halves(b));
        Self { high, low: ((a1 * b1 - high) + a1 * b2 + a2 * b1) + a2 * b2 }
    }

    /// |a - b| in f64 for a number of single length.
    pub fn distance(self, x: f64) -> f64 {
        (self - Self::new(x)).high.abs()
    }

    pub fn sqrt(self) -> Self {
        if self.high <= 0.0 {
            return Self::new(evaluate::unary(Unary::Sqrt, self.high));
        }
        let x = Self::new(evaluate::unary(Unary::Sqrt, self.high));
        // One Newton step doubles the digits.
        Self::new(0.5) * (x + self / x)
    }

    /// Sine and cosine: reduction by whole quarter turns, then power series.
    pub fn sin_cos(self) -> (Self, Self) {
        let turns = (self.high / QUARTER_TURN.high).round();
        let x = self - QUARTER_TURN * Self::new(turns);
        let (mut term, mut sin, mut cos) = (Self::ONE, Self::ZERO, Self::ZERO);
        for k in 0..TERMS {
            match k % 4 {
                0 => cos = cos + term,
                1 => sin = sin + term,
                2 => cos = cos - term,
                _ => sin = sin - term,
            }
            term = term * x / Self::new(f64::from(k + 1));
        }
        match (turns as i64).rem_euclid(4) {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        }
    }

    /// e^x as (e^(x/2^7))^(2^7), the inner one by its series.
    pub fn exp(self) -> Self {
        const HALVINGS: u32 = 7;
        let x = self * Self::new(1.0 / f64::from(1_u32 << HALVINGS));
        let (mut term, mut sum) = (Self::ONE, Self::ZERO);
        for k in 1..TERMS {
            sum = sum + term;
            term = term * x / Self::new(f64::from(k));
        }
        (0..HALVINGS).fold(sum, |power, _| power * power)
    }

    /// A function of one argument; inverse functions by one Newton step from the f64 value.
    pub fn unary(function: Unary, x: Self) -> Self {
        let start = Self::new(evaluate::unary(function, x.high));
        match function {
            Unary::Sqrt => x.sqrt(),
            Unary::Sin => x.sin_cos().0,
            Unary::Cos => x.sin_cos().1,
            Unary::Tan => {
                let (sin, cos) = x.sin_cos();
                sin / cos
            }
            Unary::Asin => {
                let (sin, cos) = start.sin_cos();
                start + (x - sin) / cos
            }
            Unary::Acos => {
                let (sin, cos) = start.sin_cos();
                start + (cos - x) / sin
            }
            Unary::Exp => x.exp(),
            Unary::Ln => start + (x / start.exp() - Self::ONE),
            Unary::Tanh => {
                let square = (x + x).exp();
                if square.high.is_finite() { (square - Self::ONE) / (square + Self::ONE) } else { start }
            }
            Unary::Abs => {
                if x.high < 0.0 {
                    -x
                } else {
                    x
                }
            }
            Unary::Sign => start,
        }
    }

    /// A function of two arguments.
    pub fn binary(operator: Binary, a: Self, b: Self) -> Self {
        match operator {
            Binary::Add => a + b,
            Binary::Sub => a - b,
            Binary::Mul => a * b,
            Binary::Div => a / b,
            Binary::Atan2 => {
                // Rotates the point back by the f64 angle; the remaining angle is small.
                let start = Self::new(evaluate::binary(operator, a.high, b.high));
                let (sin, cos) = start.sin_cos();
                start + (a * cos - b * sin) / (a * sin + b * cos)
            }
            Binary::Min => {
                if (a - b).high < 0.0 {
                    a
                } else {
                    b
                }
            }
            Binary::Max => {
                if (a - b).high < 0.0 {
                    b
                } else {
                    a
                }
            }
        }
    }

    /// A constant; square roots to all digits.
    pub fn number(number: Number) -> Self {
        match number {
            Number::Exact { numerator, denominator, root } => {
                let whole = |n: i64| Self::new(n as f64); // below 2^52: exact
                whole(numerator) / whole(denominator) * Self::new(f64::from(root)).sqrt()
            }
            Number::Float(bits) => Self::new(f64::from_bits(bits)),
        }
    }
}

impl Add for Double2 {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (high, low) = (Self::two_sum(self.high, other.high), Self::two_sum(self.low, other.low));
        let sum = Self::quick_sum(high.high, high.low + low.high);
        Self::quick_sum(sum.high, sum.low + low.low)
    }
}

impl Neg for Double2 {
    type Output = Self;
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for Double2 {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Double2 {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = Self::two_product(self.high, other.high);
        Self::quick_sum(product.high, product.low + (self.high * other.low + self.low * other.high))
    }
}

impl Div for Double2 {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self - other * Self::new(first);
        let second = rest.high / other.high;
        let rest = rest - other * Self::new(second);
        Self::quick_sum(first, second) + Self::new(rest.high / other.high)
    }
}

/// Values of `roots` at several points; `value_of` gives the symbols' values there.
pub(super) fn evaluate_at(
    dag: &Dag,
    roots: &[ExprId],
    points: usize,
    value_of: impl Fn(SymbolId, usize) -> f64,
) -> Vec<Vec<Double2>> {
    let order = dag.reachable(roots);
    let mut values = vec![Double2::ZERO; order.last().map_or(0, |id| id.index() + 1)];
    let mut at = |point: usize| {
        // Sine and cosine of an angle usually follow each other and are computed together.
        let mut turned: Option<(ExprId, (Double2, Double2))> = None;
        for &id in &order {
            let of = |a: ExprId| values[a.index()];
            values[id.index()] = match dag.node(id) {
                // The same at every point.
                Node::Number(_) | Node::Pi if point > 0 => continue,
                Node::Number(c) => Double2::number(c),
                Node::Pi => Double2::new(std::f64::consts::PI),
                Node::Symbol(symbol) => Double2::new(value_of(symbol, point)),
                Node::Negate(a) => -of(a),
                Node::Unary(function @ (Unary::Sin | Unary::Cos), a) => {
                    let known = turned.filter(|(angle, _)| *angle == a);
                    let (_, (sin, cos)) = *turned.insert(known.unwrap_or_else(|| (a, of(a).sin_cos())));
                    if function == Unary::Sin { sin } else { cos }
                }
                Node::Unary(function, a) => Double2::unary(function, of(a)),
                Node::Binary(operator, a, b) => Double2::binary(operator, of(a), of(b)),
            };
        }
        roots.iter().map(|r| values[r.index()]).collect()
    };
    (0..points).map(&mut at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Some hundred operations of 106 bits.
    const CLOSE: f64 = 1e-29;

    fn close(a: Double2, b: Double2) {
        assert!((a - b).high.abs() <= CLOSE * (1.0 + a.high.abs()), "{a:?} {b:?}");
    }

    #[test]
    fn arithmetic_keeps_twice_the_digits() {
        let third = Double2::ONE / Double2::new(3.0);
        close(third + third + third, Double2::ONE);
        let root = Double2::new(2.0).sqrt();
        close(root * root, Double2::new(2.0));
        assert!(root.low != 0.0);
    }

    #[test]
    fn functions_and_their_inverses_agree() {
        for k in -20..20 {
            let x = Double2::new(0.049 * f64::from(k)) / Double2::new(1.1);
            let (sin, cos) = x.sin_cos();
            close(sin * sin + cos * cos, Double2::ONE);
            close(Double2::unary(Unary::Asin, sin), x);
            close(Double2::binary(Binary::Atan2, sin, cos), x);
            close(Double2::unary(Unary::Ln, x.exp()), x);
            let far = x + QUARTER_TURN * Double2::new(4.0 * f64::from(k));
            close(far.sin_cos().0, sin);
        }
        close(Double2::unary(Unary::Acos, Double2::new(0.5)) * Double2::new(1.5), QUARTER_TURN);
        let (e, f) = (Double2::ONE.exp(), (-Double2::ONE).exp());
        close(Double2::unary(Unary::Tanh, Double2::ONE), (e - f) / (e + f));
    }

    #[test]
    fn the_sine_of_one_has_its_digits() {
        // 0.84147098480789650665250232163029899962256306079837...
        close(
            Double2::ONE.sin_cos().0,
            Double2 { high: 0.841_470_984_807_896_5, low: 1.776_845_092_935_536e-18 },
        );
    }
}
