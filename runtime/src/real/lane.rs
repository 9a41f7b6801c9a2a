//! Primitive operations from which the functions of a scalar are built, for one number or for SIMD lanes.
//!
//! Sine and cosine are written once over [`Lane`]; a scalar and every lane of a vector then
//! execute the same IEEE operations in the same order, hence give the same bits.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// One IEEE number or several side by side, with access to their bits.
pub trait Lane:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// The scalar of one lane.
    type Element: Copy;
    /// A truth value per lane.
    type Mask: Copy;
    /// The same number in every lane.
    fn splat(x: Self::Element) -> Self;
    /// Whether bit `index` (0 = least significant) of the representation is set.
    fn bit(self, index: u32) -> Self::Mask;
    /// `self < other`; false where either is NaN.
    fn less(self, other: Self) -> Self::Mask;
    /// `yes` where the mask holds, else `no`.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// (sin, cos) of an angle a quarter turn further on, (cos, -sin), where the mask holds.
    #[inline(always)]
    fn quarter_turn(mask: Self::Mask, sin: Self, cos: Self) -> (Self, Self) {
        (Self::select(mask, cos, sin), Self::select(mask, -sin, cos))
    }
    /// Changes the sign where the mask holds.
    fn negate_where(self, mask: Self::Mask) -> Self;
    /// `self == self`: false where NaN.
    fn is_number(self) -> Self::Mask;
}

/// The smaller; NaN where either is NaN; of equal numbers (-0 and 0 too) `b`.
#[inline]
pub fn min<L: Lane>(a: L, b: L) -> L {
    let smaller = L::select(a.less(b), a, b);
    L::select(a.is_number(), smaller, a)
}

/// The larger; NaN where either is NaN; of equal numbers (-0 and 0 too) `b`.
#[inline]
pub fn max<L: Lane>(a: L, b: L) -> L {
    let larger = L::select(b.less(a), a, b);
    L::select(a.is_number(), larger, a)
}

/// -1 or 1; a zero keeps its sign, NaN stays NaN.
#[inline]
pub fn sign<L: Lane>(x: L, zero: L, one: L) -> L {
    let up = L::select(zero.less(x), one, x);
    L::select(x.less(zero), -one, up)
}

macro_rules! scalar_lane {
    ($t:ty, $bits:ty) => {
        impl Lane for $t {
            type Element = $t;
            type Mask = $bits;
            #[inline(always)]
            fn splat(x: $t) -> $t {
                x
            }
            #[inline(always)]
            fn bit(self, index: u32) -> $bits {
                ((self.to_bits() >> (index % <$bits>::BITS)) & 1).wrapping_neg()
            }
            #[inline(always)]
            fn less(self, other: $t) -> $bits {
                <$bits>::from(self < other).wrapping_neg()
            }
            #[inline(always)]
            fn select(mask: $bits, yes: $t, no: $t) -> $t {
                // A select, never a branch: the compiler would sink the computations before a branch into one of its
                // arms.
                core::hint::select_unpredictable(mask != 0, yes, no)
            }
            #[inline(always)]
            fn negate_where(self, mask: $bits) -> $t {
                const SIGN: $bits = 1 << (<$bits>::BITS - 1);
                <$t>::from_bits(self.to_bits() ^ (mask & SIGN))
            }
            #[inline(always)]
            fn is_number(self) -> $bits {
                <$bits>::from(!self.is_nan()).wrapping_neg()
            }
        }
    };
}

scalar_lane!(f32, u32);
scalar_lane!(f64, u64);
