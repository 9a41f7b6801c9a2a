//! `Real` and `Scalar` for f32: every function is own code in f32, without branches, in constant time.
//!
//! Polynomials and reductions are those of Cephes' single-precision library (Moshier 1992). Maximal
//! errors, measured against f64 by `tests/it/functions.rs` [ulp]: tan 2.5 (|x| <= 100), asin 1.9, acos 1.3,
//! atan2 2.2, exp 1.0, ln 0.9, tanh 1.3. Next to zeros and poles of tan, an error of 1.6e-13 of its angle
//! adds 1 + tan^2 times as much: 11 ulp at -4.712389, where it is 8e7.

use super::lane::Lane;
use super::sqrt::sqrt_f32;
use super::{Constant, Real, Scalar, Turn, lane, trig};
use core::f32::consts::{FRAC_PI_2, FRAC_PI_4, LOG2_E, PI};
use core::hint::select_unpredictable;

/// pi/2 - `FRAC_PI_2`.
const FRAC_PI_2_LOW: f32 = -4.371_139e-8;
/// pi - `PI`.
const PI_LOW: f32 = -8.742_278e-8;
/// ln 2 = `LN_2_HIGH` + `LN_2_LOW`; the first has 9 bits, its product with an exponent is exact.
const LN_2_HIGH: f32 = 0.693_359_4;
const LN_2_LOW: f32 = -2.121_944_4e-4;
/// tan(pi/8): up to here the arctangent's polynomial is taken directly.
const TAN_PI_8: f32 = 0.414_213_57;
/// Sizes are ordered as the bits without the sign, NaN last. Added to twice these bits, this constant puts infinity
/// last and wraps NaN round to the first place, so that it wins. One comparison of integers takes five instructions of
/// a Cortex-M4; two of floats take nine, and registers of single precision.
const NAN_FIRST: u32 = 0x00FF_FFFF;
/// exp overflows above 88.72 and is 0 below -103.98; the clamp keeps the exponent's arithmetic in range.
const EXP_RANGE: (f32, f32) = (-105.0, 89.0);

impl Real for f32 {
    const ZERO: f32 = 0.0;
    const ONE: f32 = 1.0;

    #[inline(always)]
    fn from_f64(x: f64) -> f32 {
        x as f32
    }
    #[inline(always)]
    fn sqrt(self) -> f32 {
        sqrt_f32(self)
    }
    #[inline]
    fn sin_cos(self) -> (f32, f32) {
        trig::sin_cos_f32(self)
    }
    #[inline(always)]
    fn sin_cos_near(self, known: &Turn<f32>) -> (f32, f32) {
        let d = self - known.angle;
        // NaN fails the comparison, so it takes the general path.
        if f32::abs(d) <= trig::NEAR as f32 {
            trig::turn_on_f32((known.sin, known.cos), d)
        } else {
            Real::sin_cos(self)
        }
    }
    #[inline]
    fn tan(self) -> f32 {
        tan(self)
    }
    #[inline]
    fn asin(self) -> f32 {
        let a = self.abs();
        let (root, arc) = arc_sine(a);
        let far = (FRAC_PI_2 - 2.0 * arc) + FRAC_PI_2_LOW;
        let magnitude = if root { far } else { arc };
        magnitude.copysign(self)
    }
    #[inline]
    fn acos(self) -> f32 {
        let (root, arc) = arc_sine(self.abs());
        let twice = 2.0 * arc;
        let far = if self < 0.0 { (PI - twice) + PI_LOW } else { twice };
        let near = (FRAC_PI_2 - arc.copysign(self)) + FRAC_PI_2_LOW;
        if root { far } else { near }
    }
    #[inline]
    fn atan2(self, x: f32) -> f32 {
        atan2(self, x)
    }
    #[inline]
    fn exp(self) -> f32 {
        exp(self)
    }
    #[inline]
    fn ln(self) -> f32 {
        ln(self)
    }
    #[inline]
    fn tanh(self) -> f32 {
        tanh(self)
    }
    #[inline(always)]
    fn abs(self) -> f32 {
        f32::abs(self)
    }
    #[inline(always)]
    fn sign(self) -> f32 {
        lane::sign(self, 0.0, 1.0)
    }
    #[inline(always)]
    fn min(self, other: f32) -> f32 {
        lane::min(self, other)
    }
    #[inline(always)]
    fn max(self, other: f32) -> f32 {
        lane::max(self, other)
    }
    #[inline(always)]
    fn min_size(self, other: f32) -> f32 {
        let [a, b] = [self, other].map(|x| (x.to_bits() << 1).wrapping_add(NAN_FIRST));
        f32::from_bits(select_unpredictable(a < b, a, b).wrapping_sub(NAN_FIRST) >> 1)
    }
    #[inline(always)]
    fn max_size(self, other: f32) -> f32 {
        let [a, b] = [self, other].map(|x| x.to_bits() << 1);
        f32::from_bits(select_unpredictable(b < a, a, b) >> 1)
    }
}

impl Scalar for f32 {
    const EPSILON: f32 = f32::EPSILON;
    const ROOT_EPSILON: f32 = 3.452_669_8e-4;
    const FAR: f32 = 4.6e18;
    /// 2^16 quarter turns: so far the first product of the reduction is exact.
    const LARGEST_ANGLE: f32 = 1e5;
    #[inline(always)]
    fn constant(constant: Constant) -> f32 {
        constant.single
    }
    /// Exact multiples of the quarter turn's parts.
    const TURN: [f32; 3] = {
        let [a, b, c] = trig::QUARTER_TURN_F32;
        [4.0 * a, 4.0 * b, 4.0 * c]
    };

    #[inline(always)]
    fn is_finite(self) -> bool {
        f32::is_finite(self)
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        f64::from(self)
    }
    #[inline(always)]
    fn turns(self) -> f32 {
        (self * (0.5 * core::f32::consts::FRAC_1_PI) + trig::ROUND_F32) - trig::ROUND_F32
    }
}

/// tan r by polynomial on a quarter turn, -1 / tan r on the odd quarters.
#[inline]
fn tan(x: f32) -> f32 {
    let (r, tangled) = trig::reduce_f32(x);
    let z = r * r;
    let p = (9.385_402e-3 * z + 3.119_922_2e-3) * z + 2.443_013_5e-2;
    let p = ((p * z + 5.341_128e-2) * z + 0.133_388) * z + 0.333_331_56;
    let t = p * z * r + r;
    if tangled.bit(0) == 0 { t } else { -1.0 / t }
}

/// For 0 <= a <= 1: (false, asin a) up to one half, else (true, asin sqrt((1 - a)/2)).
/// The second keeps relative accuracy near 1; above 1 it is NaN.
#[inline(always)]
fn arc_sine(a: f32) -> (bool, f32) {
    let far = a > 0.5;
    let complement = 0.5 * (1.0 - a);
    let z = if far { complement } else { a * a };
    let s = if far { sqrt_f32(complement) } else { a };
    let p = (4.216_32e-2 * z + 2.418_131_2e-2) * z + 4.547_002_5e-2;
    let p = (p * z + 7.495_300_5e-2) * z + 0.166_667_52;
    (far, p * z * s + s)
}

/// Angle of (x, y): arctangent of the smaller over the larger magnitude, then the octant.
/// atan2(0, 0) = 0 with y's sign (pi with it for x = -0); two infinities give NaN.
#[inline]
fn atan2(y: f32, x: f32) -> f32 {
    let (ax, ay) = (x.abs(), y.abs());
    let steep = ax < ay;
    let (small, large) = if steep { (ax, ay) } else { (ay, ax) };
    let upper = small > TAN_PI_8 * large;
    let numerator = if upper { small - large } else { small };
    let denominator = if upper { small + large } else { large };
    let denominator = if denominator == 0.0 { 1.0 } else { denominator };
    let t = numerator / denominator;
    let z = t * t;
    let p = (8.053_745e-2 * z - 0.138_776_85) * z + 0.199_777_11;
    let p = (p * z - 0.333_329_5) * z * t + t;
    let octant = if upper { FRAC_PI_4 + (p + 0.5 * FRAC_PI_2_LOW) } else { p };
    let quarter = if steep { (FRAC_PI_2 - octant) + FRAC_PI_2_LOW } else { octant };
    let half = if x.is_sign_negative() { (PI - quarter) + PI_LOW } else { quarter };
    half.copysign(y)
}

/// 2^n e^r with n the nearest integer to x / ln 2; 2^n is applied in two factors, so that results
/// next to overflow and below the normal range are right.
#[inline]
fn exp(x: f32) -> f32 {
    let x = if x < EXP_RANGE.0 { EXP_RANGE.0 } else { x };
    let x = if x > EXP_RANGE.1 { EXP_RANGE.1 } else { x };
    let tangled = x * LOG2_E + trig::ROUND_F32;
    let n = tangled - trig::ROUND_F32;
    let r = (x - n * LN_2_HIGH) - n * LN_2_LOW;
    let p = (1.987_569_1e-4 * r + 1.398_199_9e-3) * r + 8.333_452e-3;
    let p = ((p * r + 4.166_579_6e-2) * r + 0.166_666_66) * r + 0.5;
    let e = p * (r * r) + r + 1.0;
    let exponent = tangled.to_bits().wrapping_sub(trig::ROUND_F32.to_bits()).cast_signed();
    let half = exponent >> 1;
    e * power_of_two(half) * power_of_two(exponent.wrapping_sub(half))
}

/// 2^n for -126 <= n <= 127.
#[inline(always)]
fn power_of_two(n: i32) -> f32 {
    f32::from_bits(n.wrapping_add(127).cast_unsigned() << 23)
}

/// x = 2^e m with m in [sqrt(1/2), sqrt 2): e ln 2 + ln m. ln 0 is -infinity, below 0 NaN.
#[inline]
fn ln(x: f32) -> f32 {
    const TWO_23: f32 = 8_388_608.0;
    let subnormal = x < f32::MIN_POSITIVE;
    let scaled = if subnormal { x * TWO_23 } else { x };
    let shift = if subnormal { 23.0 } else { 0.0 };
    // Offsetting by sqrt(1/2) makes the exponent field count from m = sqrt(1/2).
    let offset = core::f32::consts::FRAC_1_SQRT_2.to_bits();
    let bits = scaled.to_bits().wrapping_sub(offset);
    let exponent = bits.cast_signed() >> 23;
    let m = f32::from_bits((bits & 0x007F_FFFF).wrapping_add(offset));
    let e = exponent as f32 - shift;
    let f = m - 1.0;
    let z = f * f;
    let p = (7.037_683_6e-2 * f - 0.115_146_1) * f + 0.116_769_984;
    let p = ((p * f - 0.124_204_14) * f + 0.142_493_23) * f - 0.166_680_57;
    let p = ((p * f + 0.200_007_14) * f - 0.249_999_94) * f + 0.333_333_3;
    let low = p * f * z + e * LN_2_LOW - 0.5 * z;
    let value = (f + low) + e * LN_2_HIGH;
    let value = if x < f32::INFINITY { value } else { x };
    let value = if x == 0.0 { f32::NEG_INFINITY } else { value };
    if x < 0.0 { f32::NAN } else { value }
}

/// x + x^3 P(x^2) below 0.625, else 1 - 2 / (e^2x + 1).
#[inline]
fn tanh(x: f32) -> f32 {
    let a = x.abs();
    let z = a * a;
    let p = (-5.704_988_7e-3 * z + 2.063_908_8e-2) * z - 5.373_971_6e-2;
    let p = (p * z + 0.133_314_42) * z - 0.333_332_8;
    let near = p * z * a + a;
    let far = 1.0 - 2.0 / (exp(a + a) + 1.0);
    (if a < 0.625 { near } else { far }).copysign(x)
}
