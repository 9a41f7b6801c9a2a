//! Exact arithmetic modulo a prime p: tests identities without a tolerance.
//!
//! Two rational expressions that agree at a random point of the field are equal as functions, except with a probability
//! of degree / p, about 1e-15. The prime is chosen such that 2, 3, 5, 7, 11 and 13 have square roots, so that the
//! square roots in a model's directions are elements of the field.

use crate::expr::number::Number;
use std::ops::{Add, Mul, Neg, Sub};

/// P is 2^61 minus this. Small, so that two folds reduce a product.
const DEFECT: u64 = 11_913;
const BITS: u32 = 61;
/// The prime.
const P: u64 = (1 << BITS) - DEFECT;
/// Primes whose square roots are in the field.
const WITH_ROOT: [u64; 6] = [2, 3, 5, 7, 11, 13];

/// An element of the field.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(crate) struct Field(u64);

impl Field {
    pub const ZERO: Self = Self(0);
    pub const ONE: Self = Self(1);

    /// The element of an integer.
    #[inline]
    pub fn new(n: u64) -> Self {
        Self(n % P)
    }

    /// The representative in 0..P.
    #[inline]
    pub fn bits(self) -> u64 {
        self.0
    }

    /// One of x and -x is "upper", the other one is the canonical sign.
    #[inline]
    pub fn is_upper(self) -> bool {
        self.0 > P / 2
    }

    /// Whichever of x and -x is not "upper".
    #[inline]
    pub fn canonical(self) -> Self {
        if self.is_upper() { -self } else { self }
    }

    pub fn power(self, mut exponent: u64) -> Self {
        let (mut base, mut result) = (self, Self::ONE);
        while exponent > 0 {
            if exponent & 1 == 1 {
                result = result * base;
            }
            base = base * base;
            exponent >>= 1;
        }
        result
    }

    /// 1/x; `None` for 0.
    #[inline]
    pub fn inverse(self) -> Option<Self> {
        // Extended Euclidean algorithm: a third of the time of x^(P - 2).
        let (mut r, mut s) = ((P, self.0), (0_i128, 1_i128));
        while r.1 != 0 {
            let quotient = r.0 / r.1;
            r = (r.1, r.0 - quotient * r.1);
            s = (s.1, s.0 - i128::from(quotient) * s.1);
        }
        (r.0 == 1).then(|| Self(s.0.rem_euclid(i128::from(P)) as u64))
    }

    /// 1/x for each element, 0 for 0, by one inversion and three products per element (Montgomery 1987, section
    /// 10.3.1).
    pub fn inverses(elements: &[Self]) -> Vec<Self> {
        let factor = |x: Self| if x == Self::ZERO { Self::ONE } else { x };
        let mut product = Self::ONE;
        let mut inverses: Vec<Self> = Vec::with_capacity(elements.len());
        for &x in elements {
            inverses.push(product);
            product = product * factor(x);
        }
        // The inverse of the product of all elements up to the current one.
        let mut inverse = product.inverse().unwrap_or(Self::ZERO);
        for (before, &x) in inverses.iter_mut().zip(elements).rev() {
            *before = if x == Self::ZERO { Self::ZERO } else { inverse * *before };
            inverse = inverse * factor(x);
        }
        inverses
    }

    /// A constant, exactly; `None` if its root is not in the field or it is not finite.
    pub fn from_number(number: Number) -> Option<Self> {
        match number {
            Number::Exact { numerator, denominator, root } => {
                let size = Self::new(numerator.unsigned_abs());
                let value = size * Self::new(denominator.unsigned_abs()).inverse()? * Self::root_of(root)?;
                Some(if numerator < 0 { -value } else { value })
            }
            Number::Float(bits) => Self::from_f64(f64::from_bits(bits)),
        }
    }

    /// The exact value of an f64, which is an integer times a power of two.
    fn from_f64(x: f64) -> Option<Self> {
        const MANTISSA: u32 = f64::MANTISSA_DIGITS - 1;
        if !x.is_finite() {
            return None;
        }
        let raw = (x.to_bits() >> MANTISSA) & 0x7ff;
        let fraction = x.to_bits() & ((1 << MANTISSA) - 1);
        let (integer, exponent) =
            if raw == 0 { (fraction, -1074) } else { (fraction | 1 << MANTISSA, raw as i64 - 1075) };
        let base = if exponent < 0 { Self(2).inverse()? } else { Self(2) };
        let value = Self(integer) * base.power(exponent.unsigned_abs());
        Some(if x < 0.0 { -value } else { value })
    }

    /// Square root of a square-free integer, multiplicative over its prime factors.
    fn root_of(mut n: u32) -> Option<Self> {
        let mut root = Self::ONE;
        for prime in WITH_ROOT {
            if u64::from(n) % prime == 0 {
                n /= prime as u32;
                root = root * Self(prime).power(P.div_ceil(4)); // P = 3 mod 4
            }
        }
        (n == 1).then_some(root)
    }

    /// A point of the unit circle, (sin, cos) = (2 t, 1 - t^2)/(1 + t^2).
    pub fn circle(t: Self) -> Option<(Self, Self)> {
        let square = t * t;
        let scale = (Self::ONE + square).inverse()?;
        Some(((t + t) * scale, (Self::ONE - square) * scale))
    }
}

impl Add for Field {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        let sum = self.0 + other.0;
        Self(if sum >= P { sum - P } else { sum })
    }
}

impl Sub for Field {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        let (difference, below) = self.0.overflowing_sub(other.0);
        Self(if below { difference.wrapping_add(P) } else { difference })
    }
}

impl Neg for Field {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self(if self.0 == 0 { 0 } else { P - self.0 })
    }
}

impl Mul for Field {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        const LOW: u64 = (1 << BITS) - 1;
        let product = u128::from(self.0) * u128::from(other.0);
        // x = high 2^61 + low = high DEFECT + low (mod P); applied twice the result is below 2 P.
        let fold = |x: u128| u128::from((x as u64) & LOW) + (x >> BITS) * u128::from(DEFECT);
        let rest = fold(fold(product)) as u64;
        Self(if rest >= P { rest - P } else { rest })
    }
}

/// SplitMix64's finaliser: the same hash on every machine.
#[inline]
pub(crate) fn mix(seed: u64) -> u64 {
    let mut z = seed.wrapping_add(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inverses_and_products_agree() {
        for seed in 1..1000 {
            let (x, y, z) =
                (Field::new(mix(seed)), Field::new(mix(seed + 5000)), Field::new(mix(seed + 9000)));
            assert_eq!(x * x.inverse().expect("not 0"), Field::ONE);
            assert_eq!(x * (y + z), x * y + x * z);
            assert_eq!((x * y) * z, x * (y * z));
            assert_eq!(x.power(P - 1), Field::ONE, "Fermat");
        }
        assert_eq!(Field::ZERO.inverse(), None);
    }

    #[test]
    fn many_are_inverted_at_once() {
        let mut elements: Vec<Field> = (0..50).map(|seed| Field::new(mix(seed))).collect();
        elements[7] = Field::ZERO;
        for (x, inverse) in elements.iter().zip(Field::inverses(&elements)) {
            assert_eq!(inverse, x.inverse().unwrap_or(Field::ZERO));
        }
        assert_eq!(Field::inverses(&[]), []);
    }

    #[test]
    fn surds_multiply_as_they_should() {
        let of = |n: Number| Field::from_number(n).expect("in the field");
        for (a, b) in [(2, 3), (3, 5), (6, 2), (10, 6)] {
            let (x, y) = (Number::integer(a).sqrt(), Number::integer(b).sqrt());
            assert_eq!(of(x) * of(y), of(x.multiply(y)), "{a} {b}");
        }
        assert_eq!(Field::from_number(Number::integer(17).sqrt()), None);
    }

    #[test]
    fn floats_are_exact() {
        let of = |x: f64| Field::from_f64(x).expect("finite");
        assert_eq!(of(0.1) * of(1024.0), of(102.4));
        assert_eq!(of(-3.0) + of(3.0), Field::ZERO);
        assert_eq!(of(1e300) * of(2.0), of(2e300));
        assert_ne!(of(0.1) * of(3.0), of(0.3), "0.1 and 0.3 are rounded: three times one is not the other");
        assert_eq!(Field::from_f64(f64::NAN), None);
    }

    #[test]
    fn circle_points_lie_on_the_circle() {
        for seed in 0..100 {
            let (s, c) = Field::circle(Field::new(mix(seed))).expect("1 + t^2 is not 0: -1 has no root");
            assert_eq!(s * s + c * c, Field::ONE);
        }
    }
}
