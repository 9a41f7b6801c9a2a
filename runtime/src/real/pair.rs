//! Two f64 side by side: sine and cosine of two angles for little more than the time of one.
//!
//! The kernel of [`super::trig`] over a [`Lane`] of two, one vector instruction per operation. Each half executes
//! the scalar's operations and so gives its bits. Written with intrinsics because the compiler vectorised the scalar
//! code or did not with every small change around it (111 or 190 instructions).

use super::lane::Lane;
use super::trig;
use core::arch::x86_64::{
    __m128d, _mm_add_pd, _mm_and_pd, _mm_andnot_pd, _mm_castpd_si128, _mm_castsi128_pd, _mm_cmplt_pd,
    _mm_cmpord_pd, _mm_cvtsd_f64, _mm_cvtsi32_si128, _mm_div_pd, _mm_mul_pd, _mm_or_pd, _mm_set_pd,
    _mm_set1_pd, _mm_shuffle_epi32, _mm_sll_epi64, _mm_srai_epi32, _mm_sub_pd, _mm_unpackhi_pd, _mm_xor_pd,
};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Calls an intrinsic of SSE2.
macro_rules! sse2 {
    ($call:expr) => {{
        // SAFETY: every x86-64 processor has SSE2 (it is part of the base architecture), and this
        // module exists on x86-64 only. None of the intrinsics used here touches memory.
        #[allow(unsafe_code, reason = "SSE2 is always there")]
        unsafe {
            $call
        }
    }};
}
/// (sin, cos) of two angles (rad), bit for bit as one by one.
#[inline]
pub(super) fn sin_cos(a: f64, b: f64) -> [(f64, f64); 2] {
    let (sin, cos) = trig::sin_cos_f64(Pair(sse2!(_mm_set_pd(b, a))));
    [(sin.low(), cos.low()), (sin.high(), cos.high())]
}

/// Two numbers, the first in the low half.
#[derive(Clone, Copy)]
struct Pair(__m128d);

impl Pair {
    #[inline(always)]
    fn low(self) -> f64 {
        sse2!(_mm_cvtsd_f64(self.0))
    }
    #[inline(always)]
    fn high(self) -> f64 {
        sse2!(_mm_cvtsd_f64(_mm_unpackhi_pd(self.0, self.0)))
    }
    #[inline(always)]
    fn xor(self, other: Self) -> Self {
        Self(sse2!(_mm_xor_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn and(self, other: Self) -> Self {
        Self(sse2!(_mm_and_pd(self.0, other.0)))
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident, $intrinsic:ident) => {
        impl $trait for Pair {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(sse2!($intrinsic(self.0, other.0)))
            }
        }
    };
}

operator!(Add, add, _mm_add_pd);
operator!(Sub, sub, _mm_sub_pd);
operator!(Mul, mul, _mm_mul_pd);
operator!(Div, div, _mm_div_pd);

impl Neg for Pair {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.xor(Self::splat(-0.0))
    }
}

impl Lane for Pair {
    type Element = f64;
    /// All bits of a half set, or none.
    type Mask = Self;
    #[inline(always)]
    fn splat(x: f64) -> Self {
        Self(sse2!(_mm_set1_pd(x)))
    }
    #[inline(always)]
    fn bit(self, index: u32) -> Self {
        // Shift the bit to the sign, spread it over the upper word by an arithmetic shift, copy that word to the lower.
        let places = 63 - (index % 64) as i32;
        Self(sse2!({
            let top = _mm_sll_epi64(_mm_castpd_si128(self.0), _mm_cvtsi32_si128(places));
            _mm_castsi128_pd(_mm_shuffle_epi32::<0b11_11_01_01>(_mm_srai_epi32::<31>(top)))
        }))
    }
    #[inline(always)]
    fn less(self, other: Self) -> Self {
        Self(sse2!(_mm_cmplt_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn select(mask: Self, yes: Self, no: Self) -> Self {
        Self(sse2!(_mm_or_pd(_mm_and_pd(mask.0, yes.0), _mm_andnot_pd(mask.0, no.0))))
    }
    #[inline(always)]
    fn quarter_turn(mask: Self, sin: Self, cos: Self) -> (Self, Self) {
        let change = mask.and(sin.xor(cos));
        (sin.xor(change), cos.xor(change).negate_where(mask))
    }
    #[inline(always)]
    fn negate_where(self, mask: Self) -> Self {
        self.xor(mask.and(Self::splat(-0.0)))
    }
    #[inline(always)]
    fn is_number(self) -> Self {
        Self(sse2!(_mm_cmpord_pd(self.0, self.0)))
    }
}
