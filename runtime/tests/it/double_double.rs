//! Sine and cosine to about 100 bits, the reference for f64: a number is hi + lo, two f64.
//!
//! Error-free transformations of Knuth and Dekker; argument reduction with pi/2 to 160 bits; Taylor
//! series. Shares nothing with the code under test.

/// An unevaluated sum, |lo| <= ulp(hi) / 2.
#[derive(Clone, Copy, Debug)]
pub struct DoubleDouble {
    pub hi: f64,
    pub lo: f64,
}

/// pi/2 in three parts of 53 bits.
const HALF_PI: [f64; 3] =
    [core::f64::consts::FRAC_PI_2, 6.123_233_995_736_766e-17, -1.497_384_904_859_169_8e-33];

fn two_sum(a: f64, b: f64) -> DoubleDouble {
    let hi = a + b;
    let b_seen = hi - a;
    DoubleDouble { hi, lo: (a - (hi - b_seen)) + (b - b_seen) }
}

fn halves(a: f64) -> (f64, f64) {
    let c = 134_217_729.0 * a; // 2^27 + 1
    let high = c - (c - a);
    (high, a - high)
}

fn two_product(a: f64, b: f64) -> DoubleDouble {
    let hi = a * b;
    let ((ah, al), (bh, bl)) = (halves(a), halves(b));
    DoubleDouble { hi, lo: ((ah * bh - hi) + ah * bl + al * bh) + al * bl }
}

impl DoubleDouble {
    pub const fn of(hi: f64) -> Self {
        Self { hi, lo: 0.0 }
    }
    pub fn plus(self, other: Self) -> Self {
        let s = two_sum(self.hi, other.hi);
        let t = two_sum(self.lo, other.lo);
        let s = two_sum(s.hi, s.lo + t.hi);
        two_sum(s.hi, s.lo + t.lo)
    }
    pub fn times(self, other: Self) -> Self {
        let p = two_product(self.hi, other.hi);
        two_sum(p.hi, p.lo + (self.hi * other.lo + self.lo * other.hi))
    }
    pub fn over(self, divisor: f64) -> Self {
        let q = self.hi / divisor;
        let p = two_product(q, divisor);
        two_sum(q, (((self.hi - p.hi) - p.lo) + self.lo) / divisor)
    }
}

/// (sin x, cos x) for |x| up to about 1e6.
pub fn sin_cos(x: f64) -> (DoubleDouble, DoubleDouble) {
    let n = (x / HALF_PI[0]).round();
    let r = HALF_PI.iter().fold(DoubleDouble::of(x), |r, part| r.plus(two_product(-n, *part)));
    let (s, c) = (series(r, 1), series(r, 0));
    let minus = |v: DoubleDouble| DoubleDouble { hi: -v.hi, lo: -v.lo };
    match n.rem_euclid(4.0) as u8 {
        0 => (s, c),
        1 => (c, minus(s)),
        2 => (minus(s), minus(c)),
        _ => (minus(c), s),
    }
}

/// sum over k of (-1)^k r^(2k + odd) / (2k + odd)!; |r| <= 0.8 leaves less than 1e-33 after 15 terms.
fn series(r: DoubleDouble, odd: u8) -> DoubleDouble {
    let minus_square = {
        let z = r.times(r);
        DoubleDouble { hi: -z.hi, lo: -z.lo }
    };
    let first = if odd == 1 { r } else { DoubleDouble::of(1.0) };
    let (mut term, mut sum) = (first, first);
    for k in 1..=15 {
        let m = f64::from(2 * k + odd);
        term = term.times(minus_square).over(m * (m - 1.0));
        sum = sum.plus(term);
    }
    sum
}
