//! `Real` and `Scalar` for f64: own sine, cosine and square root; the rest is libm, which is plain Rust
//! and therefore the same on every machine.

use super::sqrt::sqrt_f64;
use super::{Real, Scalar, Turn, lane, trig};
#[cfg(target_arch = "x86_64")]
use super::{exact_difference, turn_further};

impl Real for f64 {
    const ZERO: f64 = 0.0;
    const ONE: f64 = 1.0;

    #[inline(always)]
    fn from_f64(x: f64) -> f64 {
        x
    }
    #[inline(always)]
    fn sqrt(self) -> f64 {
        sqrt_f64(self)
    }
    #[inline]
    fn sin_cos(self) -> (f64, f64) {
        trig::sin_cos_f64(self)
    }
    #[cfg(target_arch = "x86_64")]
    #[inline]
    fn sin_cos_of_two(a: f64, b: f64) -> [(f64, f64); 2] {
        super::pair::sin_cos(a, b)
    }
    #[cfg(target_arch = "x86_64")]
    #[inline]
    fn sin_cos_of_two_differences(a: f64, b: f64, c: f64, d: f64) -> [(f64, f64); 2] {
        let ((one, lost), (two, lost_of_two)) = (exact_difference(a, b), exact_difference(c, d));
        let [first, second] = super::pair::sin_cos(one, two);
        [turn_further(first, lost), turn_further(second, lost_of_two)]
    }
    #[inline(always)]
    fn sin_cos_near(self, known: &Turn<f64>) -> (f64, f64) {
        let d = self - known.angle;
        // NaN fails the comparison, so it takes the general path.
        if f64::abs(d) <= trig::NEAR {
            trig::turn_on_f64((known.sin, known.cos), d)
        } else {
            Real::sin_cos(self)
        }
    }
    fn tan(self) -> f64 {
        libm::tan(self)
    }
    fn asin(self) -> f64 {
        libm::asin(self)
    }
    fn acos(self) -> f64 {
        libm::acos(self)
    }
    fn atan2(self, x: f64) -> f64 {
        libm::atan2(self, x)
    }
    fn exp(self) -> f64 {
        libm::exp(self)
    }
    fn ln(self) -> f64 {
        libm::log(self)
    }
    fn tanh(self) -> f64 {
        libm::tanh(self)
    }
    #[inline(always)]
    fn abs(self) -> f64 {
        f64::abs(self)
    }
    #[inline(always)]
    fn sign(self) -> f64 {
        lane::sign(self, 0.0, 1.0)
    }
    #[inline(always)]
    fn min(self, other: f64) -> f64 {
        lane::min(self, other)
    }
    #[inline(always)]
    fn max(self, other: f64) -> f64 {
        lane::max(self, other)
    }
}

impl Scalar for f64 {
    const EPSILON: f64 = f64::EPSILON;
    const ROOT_EPSILON: f64 = 1.490_116_119_384_765_6e-8;
    const FAR: f64 = 3.35e153;
    /// 2^20 quarter turns: so far both products of the reduction are exact.
    const LARGEST_ANGLE: f64 = 1.6e6;
    /// Exact multiples of the quarter turn's parts.
    const TURN: [f64; 3] = {
        let [a, b, c] = trig::QUARTER_TURN_F64;
        [4.0 * a, 4.0 * b, 4.0 * c]
    };

    #[inline(always)]
    fn is_finite(self) -> bool {
        f64::is_finite(self)
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        self
    }
    #[inline(always)]
    fn turns(self) -> f64 {
        (self * (0.5 * core::f64::consts::FRAC_1_PI) + trig::ROUND_F64) - trig::ROUND_F64
    }
}
