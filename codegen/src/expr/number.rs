//! Constants of the expression DAG: exact where they can be, f64 where they cannot.
//!
//! Exact numbers are (p/q) sqrt(n) with n square-free: closed under products and quotients, and under sums of equal n.
//! That covers 1/2, sqrt(3)/2, 2/sqrt(3) and the like, so that terms that cancel mathematically cancel at derive time.
//! Everything else is an f64, folded in f64.

/// A constant.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Number {
    /// numerator/denominator sqrt(root): denominator > 0, reduced, root square-free, 0 = 0/1 sqrt(1).
    Exact {
        /// Signed numerator.
        numerator: i64,
        /// Positive denominator.
        denominator: i64,
        /// Square-free radicand, 1 for a rational.
        root: u32,
    },
    /// Bits of a finite or non-finite f64.
    Float(u64),
}

/// Largest integer that is taken from an f64 as an exact number.
const EXACT_LIMIT: f64 = 1e9;

/// A sum below this share of its terms is rounding error and becomes 0: some constants result from several operations.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

impl Number {
    /// 0.
    pub const ZERO: Self = Self::integer(0);
    /// 1.
    pub const ONE: Self = Self::integer(1);

    /// An integer.
    #[must_use]
    pub const fn integer(n: i64) -> Self {
        Self::Exact { numerator: n, denominator: 1, root: 1 }
    }

    /// p/q, or its f64 where q = 0 or the reduced parts do not fit.
    #[must_use]
    pub fn rational(p: i64, q: i64) -> Self {
        exact(i128::from(p), i128::from(q), 1).unwrap_or(Self::float(p as f64 / q as f64))
    }

    /// The f64 as it is, or exactly if it is a small dyadic fraction (0.5, 3, -0.125 ...).
    #[must_use]
    pub fn from_f64(x: f64) -> Self {
        const SCALE: f64 = 1024.0;
        let scaled = x * SCALE;
        if scaled.is_finite() && scaled.abs() < EXACT_LIMIT && scaled.fract() == 0.0 {
            return Self::rational(scaled as i64, SCALE as i64);
        }
        Self::float(x)
    }

    const fn float(x: f64) -> Self {
        Self::Float(x.to_bits())
    }

    /// Nearest f64 (within one rounding per factor for surds).
    #[must_use]
    pub fn to_f64(self) -> f64 {
        match self {
            Self::Exact { numerator, denominator, root: 1 } => numerator as f64 / denominator as f64,
            Self::Exact { numerator, denominator, root } => {
                // The square root of the squared value, where that square is representable: fewer roundings than p/q
                // times sqrt(n).
                let square = (numerator as f64) * (numerator as f64) * f64::from(root)
                    / ((denominator as f64) * (denominator as f64));
                square.sqrt().copysign(numerator as f64)
            }
            Self::Float(bits) => f64::from_bits(bits),
        }
    }

    /// Without its sign.
    #[must_use]
    pub fn magnitude(self) -> Self {
        if self.is_negative() { self.negate() } else { self }
    }

    /// Below zero?
    #[must_use]
    pub fn is_negative(self) -> bool {
        match self {
            Self::Exact { numerator, .. } => numerator < 0,
            Self::Float(bits) => f64::from_bits(bits) < 0.0,
        }
    }

    /// -a.
    #[must_use]
    pub fn negate(self) -> Self {
        match self {
            Self::Exact { numerator, denominator, root } => {
                Self::Exact { numerator: -numerator, denominator, root }
            }
            Self::Float(bits) => Self::float(-f64::from_bits(bits)),
        }
    }

    /// a + b.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        if self == Self::ZERO {
            return other;
        }
        if other == Self::ZERO {
            return self;
        }
        if let (
            Self::Exact { numerator: p, denominator: q, root: n },
            Self::Exact { numerator: r, denominator: s, root: m },
        ) = (self, other)
            && n == m
        {
            let (p, q, r, s) = (i128::from(p), i128::from(q), i128::from(r), i128::from(s));
            if let Some(sum) = exact(p * s + r * q, q * s, n) {
                return sum;
            }
        }
        // A sum that cancels up to rounding is 0 everywhere: dividing by the remainder, or pivoting on it, would make
        // no sense.
        let (a, b) = (self.to_f64(), other.to_f64());
        let sum = a + b;
        if sum.abs() <= ROUNDING * a.abs().max(b.abs()) { Self::ZERO } else { Self::float(sum) }
    }

    /// a b.
    #[must_use]
    pub fn multiply(self, other: Self) -> Self {
        if let (
            Self::Exact { numerator: p, denominator: q, root: n },
            Self::Exact { numerator: r, denominator: s, root: m },
        ) = (self, other)
        {
            // sqrt(n) sqrt(m) = g sqrt(nm/g^2) with g = gcd(n, m), both square-free.
            let g = gcd(i128::from(n), i128::from(m));
            let root = i128::from(n) / g * (i128::from(m) / g);
            let numerator = i128::from(p) * i128::from(r) * g;
            if let Some(product) = u32::try_from(root)
                .ok()
                .and_then(|root| exact(numerator, i128::from(q) * i128::from(s), root))
            {
                return product;
            }
        }
        let product = self.to_f64() * other.to_f64();
        if product == 0.0 { Self::ZERO } else { Self::float(product) }
    }

    /// 1/a; infinite for 0.
    #[must_use]
    pub fn reciprocal(self) -> Self {
        if let Self::Exact { numerator, denominator, root } = self
            && let Some(inverse) =
                exact(i128::from(denominator), i128::from(numerator) * i128::from(root), root)
        {
            return inverse;
        }
        Self::float(1.0 / self.to_f64())
    }

    /// Square root; exact for non-negative rationals of moderate size.
    #[must_use]
    pub fn sqrt(self) -> Self {
        if let Self::Exact { numerator, denominator, root: 1 } = self
            && numerator >= 0
            && let Some(radicand) = numerator.checked_mul(denominator)
            && radicand < 1_000_000
        {
            // sqrt(p/q) = sqrt(pq)/q; take the square factors out of pq.
            let (outside, inside) = extract_squares(radicand);
            if let Some(root) =
                exact(i128::from(outside), i128::from(denominator), u32::try_from(inside).unwrap_or(0))
            {
                return root;
            }
        }
        Self::float(self.to_f64().sqrt())
    }
}

/// numerator/denominator sqrt(root) in reduced form; `None` where it does not fit or divides by zero.
fn exact(numerator: i128, denominator: i128, root: u32) -> Option<Number> {
    if denominator == 0 || root == 0 {
        return (numerator == 0 && denominator != 0).then_some(Number::ZERO);
    }
    if numerator == 0 {
        return Some(Number::ZERO);
    }
    let g = gcd(numerator.abs(), denominator.abs()) * denominator.signum();
    let numerator = i64::try_from(numerator / g).ok()?;
    let denominator = i64::try_from(denominator / g).ok()?;
    // Beyond 2^52 the quotient p/q in f64 would be rounded more than once.
    let fits = |n: i64| n.unsigned_abs() < 1 << 52;
    (fits(numerator) && fits(denominator)).then_some(Number::Exact { numerator, denominator, root })
}

fn gcd(mut a: i128, mut b: i128) -> i128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

/// n = outside^2 inside with `inside` square-free (n < 10^6, so at most 1000 trial divisors).
fn extract_squares(n: i64) -> (i64, i64) {
    let (mut outside, mut inside, mut factor) = (1, n, 2);
    while factor * factor <= inside {
        while inside % (factor * factor) == 0 {
            inside /= factor * factor;
            outside *= factor;
        }
        factor += 1;
    }
    (outside, inside)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn surds_are_closed_under_products_and_quotients() {
        let half_root_three = Number::integer(3).sqrt().multiply(Number::rational(1, 2));
        assert_eq!(half_root_three.multiply(half_root_three), Number::rational(3, 4));
        let two_over_root_three = Number::integer(2).multiply(Number::integer(3).sqrt().reciprocal());
        assert_eq!(two_over_root_three.multiply(half_root_three), Number::ONE);
        assert_eq!(Number::integer(12).sqrt(), Number::integer(3).sqrt().multiply(Number::integer(2)));
        assert_eq!(half_root_three.plus(half_root_three.negate()), Number::ZERO);
    }

    #[test]
    fn values_are_the_nearest_f64() {
        assert_eq!(Number::rational(1, 3).to_f64(), 1.0 / 3.0);
        assert_eq!(Number::integer(3).sqrt().to_f64(), 3.0_f64.sqrt());
        assert_eq!(Number::rational(3, 4).sqrt().to_f64(), 0.75_f64.sqrt());
        assert_eq!(Number::from_f64(0.1).to_f64(), 0.1);
        assert_eq!(Number::from_f64(-0.5), Number::rational(-1, 2));
    }

    #[test]
    fn what_does_not_fit_becomes_a_float() {
        let huge = Number::integer(1 << 51);
        assert_eq!(huge.multiply(huge).to_f64(), (1_i64 << 51) as f64 * (1_i64 << 51) as f64);
        assert!(Number::ZERO.reciprocal().to_f64().is_infinite());
    }

    #[test]
    fn floats_that_cancel_are_zero() {
        let tenth = Number::from_f64(0.1);
        assert_eq!(tenth.plus(tenth.negate()), Number::ZERO);
        // 0.1 + 0.2 is not the float 0.3, but what is left is rounding; a part in 10^12 is not.
        let sum = tenth.plus(Number::from_f64(0.2));
        assert_eq!(sum.plus(Number::from_f64(-0.3)), Number::ZERO);
        assert!(sum.plus(Number::from_f64(-0.3 + 3e-13)).to_f64() > 2e-13);
        assert_eq!(tenth.multiply(Number::ZERO), Number::ZERO);
    }
}
