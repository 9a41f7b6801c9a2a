//! Sine and cosine of one angle (rad), in the precision of the argument only.
//!
//! x = n pi/2 + r with n the nearest integer, found by adding and subtracting 1.5 * 2^(p-1), which
//! also leaves n's two lowest bits in the sum's two lowest bits; n pi/2 is subtracted in three parts
//! (Cody & Waite, Software Manual for the Elementary Functions, 1980, ch. 8), so that the first
//! product is exact. Polynomials give sine and cosine on |r| <= pi/4; n mod 4 chooses which of them is which
//! and their signs. No branch, no table, no f64 in f32.
//!
//! Error (measured by `tests/it/functions.rs`): f32 at most 1.6 ulp (1.47) for |x| <= 100 where the result
//! exceeds 1e-3, else 1e-10 absolute (8e-11); f64 at most 0.8 ulp (0.793) for |x| <= 1e5. Beyond the
//! domain accuracy falls off silently: wrap first. An infinity or NaN gives NaN.

use super::lane::Lane;

/// 1.5 * 2^23: numbers of this size have no fraction bits left in f32.
pub(super) const ROUND_F32: f32 = 12_582_912.0;
/// 1.5 * 2^52: numbers of this size have no fraction bits left in f64.
pub(super) const ROUND_F64: f64 = 6_755_399_441_055_744.0;

/// pi/2 in parts of 8, 11 and 24 bits: the product of the first with |n| < 2^16 is exact in f32.
pub(super) const QUARTER_TURN_F32: [f32; 3] = [1.570_312_5, 4.837_513e-4, 7.549_79e-8];
/// pi/2 in parts of 33, 33 and 53 bits: the product of the first two with |n| < 2^20 is exact in f64.
pub(super) const QUARTER_TURN_F64: [f64; 3] =
    [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_795_950_6e-21];

/// r = x - n pi/2 and the sum that holds n in its lowest bits (`tangled`), f32.
#[inline(always)]
pub(super) fn reduce_f32<L: Lane<Element = f32>>(x: L) -> (L, L) {
    let [p1, p2, p3] = QUARTER_TURN_F32.map(L::splat);
    let tangled = x * L::splat(core::f32::consts::FRAC_2_PI) + L::splat(ROUND_F32);
    let n = tangled - L::splat(ROUND_F32);
    (((x - n * p1) - n * p2) - n * p3, tangled)
}

/// (sin x, cos x) in f32; polynomials of Cephes' sinf and cosf (Moshier 1992).
#[inline]
pub fn sin_cos_f32<L: Lane<Element = f32>>(x: L) -> (L, L) {
    let (r, tangled) = reduce_f32(x);
    let z = r * r;
    let s = (L::splat(-1.951_529_6e-4) * z + L::splat(8.332_161e-3)) * z + L::splat(-0.166_666_55);
    let s = s * z * r + r;
    let c = (L::splat(2.443_315_7e-5) * z + L::splat(-1.388_731_6e-3)) * z + L::splat(4.166_664_6e-2);
    let c = (c * z * z - L::splat(0.5) * z) + L::splat(1.0);
    turn(s, c, tangled)
}

/// (sin x, cos x) in f64; polynomials and two-part argument of fdlibm's k_sin.c and k_cos.c (Sun 1993).
#[inline]
pub fn sin_cos_f64<L: Lane<Element = f64>>(x: L) -> (L, L) {
    let [p1, p2, p3] = QUARTER_TURN_F64.map(L::splat);
    let tangled = x * L::splat(core::f64::consts::FRAC_2_PI) + L::splat(ROUND_F64);
    let n = tangled - L::splat(ROUND_F64);
    // r + tail = x - n pi/2. The first difference is exact, and the rounding error of the second is kept exactly:
    // either |b| < |a| (Dekker's fast two-sum), or both are so small that a - b is exact.
    let a = x - n * p1;
    let b = n * p2;
    let r = a - b;
    let tail = ((a - r) - b) - n * p3;
    let z = r * r;
    let s = sine_f64(r, tail, z);
    let c = cosine_f64(r, tail, z);
    turn(s, c, tangled)
}

/// Largest difference of angles (rad) for the addition theorem: the first terms left out, d^3/6 in f32 and d^6/720 in
/// f64, are 1.6e-10 and 1.2e-21 there.
pub const NEAR: f64 = 1.0 / 1024.0;

/// (sin, cos) of an angle further on by d, |d| <= [`NEAR`], from (s, c) of the angle:
/// sin(x + d) = s + (c sin d - s (1 - cos d)), with sin d = d and 1 - cos d = (d/2) d.
#[inline(always)]
pub fn turn_on_f32<L: Lane<Element = f32>>((s, c): (L, L), d: L) -> (L, L) {
    let (s_d, c_d, half) = (s * d, c * d, L::splat(0.5) * d);
    (s + (c_d - half * s_d), c - (s_d + half * c_d))
}

/// The same in f64, with sin d = d - d^3/6 + d^5/120 and 1 - cos d = d^2/2 - d^4/24.
#[inline(always)]
pub fn turn_on_f64<L: Lane<Element = f64>>((s, c): (L, L), d: L) -> (L, L) {
    let z = d * d;
    let sine = d - d * (z * (L::splat(1.0 / 6.0) - z * L::splat(1.0 / 120.0)));
    let versine = z * (L::splat(0.5) - z * L::splat(1.0 / 24.0));
    (s + (c * sine - s * versine), c - (s * sine + c * versine))
}

/// sin(r + tail), |r| <= pi/4, z = r^2.
#[inline(always)]
fn sine_f64<L: Lane<Element = f64>>(r: L, tail: L, z: L) -> L {
    // Coefficients in pairs (Estrin's scheme): a third of the time of Horner's.
    let zz = z * z;
    let low = L::splat(-1.984_126_982_985_795e-4) * z + L::splat(8.333_333_333_322_49e-3);
    let high = L::splat(-2.505_076_025_340_686_3e-8) * z + L::splat(2.755_731_370_707_006_8e-6);
    let p = low + zz * (high + zz * L::splat(1.589_690_995_211_55e-10));
    let p = p * z + L::splat(-0.166_666_666_666_666_32);
    // tail cos r, to second order in r.
    let rest = tail * (L::splat(1.0) - L::splat(0.5) * z);
    r + (z * r * p + rest)
}

/// cos(r + tail), |r| <= pi/4, z = r^2.
#[inline(always)]
fn cosine_f64<L: Lane<Element = f64>>(r: L, tail: L, z: L) -> L {
    let one = L::splat(1.0);
    let zz = z * z;
    let low = L::splat(2.480_158_728_947_673e-5) * z + L::splat(-1.388_888_888_887_411e-3);
    let high = L::splat(2.087_572_321_298_175e-9) * z + L::splat(-2.755_731_435_139_066_3e-7);
    let p = low + zz * (high + zz * L::splat(-1.135_964_755_778_819_5e-11));
    let p = p * z + L::splat(4.166_666_666_666_66e-2);
    let half_z = L::splat(0.5) * z;
    let w = one - half_z;
    w + (((one - w) - half_z) + (zz * p - r * tail))
}

/// Rotates (sine, cosine) of r by n quarter turns; `tangled` carries n mod 4 in its lowest bits.
#[inline(always)]
fn turn<L: Lane>(s: L, c: L, tangled: L) -> (L, L) {
    let odd = tangled.bit(0);
    let half = tangled.bit(1);
    let (sin, cos) = L::quarter_turn(odd, s, c);
    // A half turn negates both.
    (sin.negate_where(half), cos.negate_where(half))
}
