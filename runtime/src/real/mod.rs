//! Scalars of all computations: [`Real`] has arithmetic only (SIMD lanes too), [`Scalar`] compares as well.
//!
//! - sine, cosine, square root: own code for every scalar, one algorithm, the same bits on host,
//!   microcontroller and in SIMD lanes ([`trig`], `sqrt`);
//! - other functions: own code in f32 (libm's would compute in f64), libm in f64;
//! - no fused multiply-add, no remainder operator, no table, no panic;
//! - with std in scope, `x.sin_cos()` on a plain f32 means std's method, not this one: outside generic
//!   code write `Real::sin_cos(x)`;
//! - NaN: arithmetic, `min`, `max`, `abs` and `sign` propagate it, so that one check at the end of a step
//!   finds it. Sign and payload of a NaN are not specified.

#[cfg(feature = "counting")]
pub mod counting;
mod double;
pub mod lane;
#[cfg(target_arch = "x86_64")]
mod pair;
#[cfg(feature = "simd")]
mod simd;
mod single;
mod sqrt;
pub mod trig;

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
    /// The nearest representable number, rounded once. Free for constants; on a machine without
    /// double precision a library call for anything else.
    fn from_f64(x: f64) -> Self;
    /// Makes the compiler align the caller's stack frame like this scalar. Registers of lanes that overflow to the
    /// stack do not make it do so; every second one then lies across two cache lines.
    #[inline(always)]
    fn align_frame() {}
    /// Square root, exactly rounded; NaN below 0.
    #[must_use]
    fn sqrt(self) -> Self;
    /// (sin, cos) of an angle (rad) up to [`Scalar::LARGEST_ANGLE`]; wrap larger ones first.
    fn sin_cos(self) -> (Self, Self);
    /// (sin, cos) of two angles (rad), the bits of [`Real::sin_cos`] of each; x86-64 computes f64 side by side.
    #[inline]
    fn sin_cos_of_two(a: Self, b: Self) -> [(Self, Self); 2] {
        [a.sin_cos(), b.sin_cos()]
    }
    /// (sin, cos) of a - b (rad), corrected for the rounding error of the difference: as accurate as for one angle,
    /// however many turns both have made and however close they are to each other or to half a turn apart.
    #[inline]
    fn sin_cos_of_difference(a: Self, b: Self) -> (Self, Self) {
        let (difference, lost) = exact_difference(a, b);
        turn_further(difference.sin_cos(), lost)
    }
    /// (sin, cos) of a - b and of c - d, bit for bit as one by one; x86-64 computes f64 side by side.
    #[inline]
    fn sin_cos_of_two_differences(a: Self, b: Self, c: Self, d: Self) -> [(Self, Self); 2] {
        [Self::sin_cos_of_difference(a, b), Self::sin_cos_of_difference(c, d)]
    }
    /// (sin, cos) of an angle (rad) close to one whose sine and cosine are known: by the addition theorem where the
    /// angles differ by at most [`trig::NEAR`], else as [`Real::sin_cos`]. Less accurate than that by one unit in the
    /// last place.
    #[inline]
    fn sin_cos_near(self, known: &Turn<Self>) -> (Self, Self) {
        let _ = known;
        self.sin_cos()
    }
    /// Tangent (rad), same domain.
    #[must_use]
    fn tan(self) -> Self;
    /// Inverse sine (rad); NaN outside [-1, 1].
    #[must_use]
    fn asin(self) -> Self;
    /// Inverse cosine (rad); NaN outside [-1, 1].
    #[must_use]
    fn acos(self) -> Self;
    /// Angle (rad) in [-pi, pi] of the vector (x, y) with y = `self`; 0 (or pi) for the zero vector.
    #[must_use]
    fn atan2(self, x: Self) -> Self;
    /// Exponential.
    #[must_use]
    fn exp(self) -> Self;
    /// Natural logarithm; NaN below 0, -infinity at 0.
    #[must_use]
    fn ln(self) -> Self;
    /// Hyperbolic tangent.
    #[must_use]
    fn tanh(self) -> Self;
    /// Absolute value; of NaN, NaN.
    #[must_use]
    fn abs(self) -> Self;
    /// Sign: -1 or 1; a zero keeps its sign; of NaN, NaN.
    #[must_use]
    fn sign(self) -> Self;
    /// The smaller of two; NaN if either is; of equals (-0 and 0 included) `other`.
    #[must_use]
    fn min(self, other: Self) -> Self;
    /// The larger of two; NaN if either is; of equals (-0 and 0 included) `other`.
    #[must_use]
    fn max(self, other: Self) -> Self;
    /// The smaller of two sizes, min(|self|, |other|); NaN if either is.
    #[must_use]
    #[inline(always)]
    fn min_size(self, other: Self) -> Self {
        Real::min(Real::abs(self), Real::abs(other))
    }
    /// The larger of two sizes, max(|self|, |other|); NaN if either is.
    #[must_use]
    #[inline(always)]
    fn max_size(self, other: Self) -> Self {
        Real::max(Real::abs(self), Real::abs(other))
    }
}

/// An angle (rad) with its sine and cosine.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Turn<S> {
    /// The angle.
    pub angle: S,
    /// Its sine.
    pub sin: S,
    /// Its cosine.
    pub cos: S,
}

/// a - b as (rounded difference, rounding error) (Knuth, The Art of Computer Programming 2, 4.2.2).
#[inline(always)]
fn exact_difference<R: Real>(a: R, b: R) -> (R, R) {
    let difference = a - b;
    let minus_b = difference - a;
    (difference, (a - (difference - minus_b)) - (b + minus_b))
}

/// (sin, cos) of an angle further on by a rounding error `little`: first order is enough, its square is below rounding.
#[inline(always)]
fn turn_further<R: Real>((sin, cos): (R, R), little: R) -> (R, R) {
    (sin + little * cos, cos - little * sin)
}

/// A constant rounded to both scalars at compile time: tables of such numbers need no conversion at run time on a
/// machine without double precision.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Constant {
    double: f64,
    single: f32,
}

impl Constant {
    /// The constant nearest to a number.
    #[must_use]
    pub const fn new(x: f64) -> Self {
        Self { double: x, single: x as f32 }
    }
}

/// A single real number that can be compared: f32 or f64.
pub trait Scalar: Real + PartialOrd {
    /// Distance from 1 to the next number.
    const EPSILON: Self;
    /// Square root of [`Scalar::EPSILON`], rounded: half of the digits.
    const ROOT_EPSILON: Self;
    /// Not quite a quarter of the square root of the largest number: the sum of eight squares up to it is a number.
    const FAR: Self;
    /// The largest angle (rad) of which sine and cosine are taken: up to it the error is that of `trig`, f32 adds 3e-11
    /// of the angle, a thousandth of the angle's own rounding. Far beyond they are not even between -1 and 1.
    const LARGEST_ANGLE: Self;
    /// 2 pi in three parts, the first so short that whole multiples of it are exact.
    const TURN: [Self; 3];
    /// The same number as [`Real::from_f64()`] gives, rounded at compile time.
    #[inline(always)]
    #[must_use]
    fn constant(constant: Constant) -> Self {
        Self::from_f64(constant.double)
    }
    /// Neither infinite nor not-a-number.
    fn is_finite(self) -> bool;
    /// Exact widening.
    fn to_f64(self) -> f64;
    /// The whole number of turns nearest to an angle (rad).
    #[must_use]
    fn turns(self) -> Self;
    /// The angle (rad) less whole turns, in [-pi, pi], exact to rounding however large it is; computed in f64, so not
    /// meant for machines without it. An infinity or NaN gives NaN.
    #[must_use]
    fn less_whole_turns(self) -> Self {
        let (sin, cos) = libm::sincos(self.to_f64());
        Self::from_f64(libm::atan2(sin, cos))
    }
    /// The angle (rad) less whole turns, in [-pi, pi] up to rounding; exact to rounding for less
    /// than 2^14 turns. An infinity or NaN gives NaN.
    #[inline]
    #[must_use]
    fn wrap_angle(self) -> Self {
        let [a, b, c] = Self::TURN;
        let n = self.turns();
        ((self - n * a) - n * b) - n * c
    }
}
