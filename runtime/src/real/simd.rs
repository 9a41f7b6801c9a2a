//! [`Real`] for the lanes of `wide`: each lane gives the bits that the scalar gives.
//!
//! Arithmetic, square root, sine, cosine, min, max, abs and sign run side by side, the remaining
//! functions lane by lane.

use super::lane::{self, Lane};
use super::{Real, Turn, trig};
use wide::bytemuck::cast;
use wide::{f32x8, f64x4, i32x8, i64x4};

macro_rules! lanes {
    ($lanes:ty, $ints:ty, $t:ty, $bits:literal, $sin_cos:path, $turn_on:path) => {
        impl Lane for $lanes {
            type Element = $t;
            /// All bits of a lane set, or none.
            type Mask = $lanes;
            #[inline(always)]
            fn splat(x: $t) -> Self {
                <$lanes>::splat(x)
            }
            #[inline(always)]
            fn bit(self, index: u32) -> Self {
                let one = <$ints>::splat(1 << (index % $bits));
                let bits: $ints = cast(self);
                cast((bits & one).simd_eq(one))
            }
            #[inline(always)]
            fn less(self, other: Self) -> Self {
                self.simd_lt(other)
            }
            #[inline(always)]
            fn select(mask: Self, yes: Self, no: Self) -> Self {
                mask.bitselect(yes, no)
            }
            #[inline(always)]
            fn negate_where(self, mask: Self) -> Self {
                self ^ (mask & <$lanes>::splat(-0.0))
            }
            #[inline(always)]
            fn is_number(self) -> Self {
                self.simd_eq(self)
            }
        }

        impl Real for $lanes {
            const ZERO: Self = <$lanes>::ZERO;
            const ONE: Self = <$lanes>::ONE;
            #[inline(always)]
            fn from_f64(x: f64) -> Self {
                <$lanes>::splat(<$t as Real>::from_f64(x))
            }
            #[inline(always)]
            fn align_frame() {
                core::hint::black_box(&core::mem::MaybeUninit::<Self>::uninit());
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                <$lanes>::sqrt(self)
            }
            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                $sin_cos(self)
            }
            fn sin_cos_near(self, known: &Turn<Self>) -> (Self, Self) {
                let d = self - known.angle;
                let is_far = <$lanes>::splat(trig::NEAR as $t).simd_lt(Real::abs(d));
                let near = $turn_on((known.sin, known.cos), d);
                let exact = $sin_cos(self);
                (Self::select(is_far, exact.0, near.0), Self::select(is_far, exact.1, near.1))
            }
            fn tan(self) -> Self {
                self.to_array().map(Real::tan).into()
            }
            fn asin(self) -> Self {
                self.to_array().map(Real::asin).into()
            }
            fn acos(self) -> Self {
                self.to_array().map(Real::acos).into()
            }
            fn atan2(self, x: Self) -> Self {
                let mut angle = self.to_array();
                angle.iter_mut().zip(x.to_array()).for_each(|(y, x)| *y = Real::atan2(*y, x));
                angle.into()
            }
            fn exp(self) -> Self {
                self.to_array().map(Real::exp).into()
            }
            fn ln(self) -> Self {
                self.to_array().map(Real::ln).into()
            }
            fn tanh(self) -> Self {
                self.to_array().map(Real::tanh).into()
            }
            #[inline(always)]
            fn abs(self) -> Self {
                <$lanes>::abs(self)
            }
            #[inline(always)]
            fn sign(self) -> Self {
                lane::sign(self, Self::ZERO, Self::ONE)
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                lane::min(self, other)
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                lane::max(self, other)
            }
            #[inline(always)]
            fn min_size(self, other: Self) -> Self {
                let (a, b) = (Real::abs(self), Real::abs(other));
                // fast_min(x, y) is x < y ? x : y, so a NaN survives in one of the two orders; OR keeps it a NaN, and
                // of two numbers both orders give the same one.
                a.fast_min(b) | b.fast_min(a)
            }
        }
    };
}

lanes!(f32x8, i32x8, f32, 32, trig::sin_cos_f32, trig::turn_on_f32);
lanes!(f64x4, i64x4, f64, 64, trig::sin_cos_f64, trig::turn_on_f64);
