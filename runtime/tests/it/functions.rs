//! Accuracy of the runtime's elementary functions, each bound a named constant; exactness of sqrt; NaN; SIMD lanes.

use crate::double_double::{self, DoubleDouble};
use proptest::prelude::*;
use smartbed_runtime::real::{Real, Scalar, Turn, trig};

/// Points of a sweep in f32 for sine and cosine; for the other functions a quarter of it.
const POINTS: usize = 2_000_000;
/// Points against the double-double reference.
const POINTS_F64: usize = 300_000;

/// f32 sine and cosine, |x| <= 100, where the result exceeds [`SMALL`] [ulp].
const SIN_COS_F32_ULP: f64 = 1.6;
/// Below this magnitude the error of the f32 sine is bounded absolutely.
const SMALL: f64 = 1e-3;
/// f32 sine and cosine near their zeros.
const SIN_COS_F32_ABSOLUTE: f64 = 1e-10;
/// f64 sine and cosine, |x| <= 1e5, next to their zeros too [ulp].
const SIN_COS_F64_ULP: f64 = 0.8;
/// Error of sine and cosine of a difference at any cancellation [ulp]: one more rounding.
const DIFFERENCE_ULP: f64 = 1.4;
/// Bounds of the other f32 functions [ulp], everywhere in their domain.
const TAN_ULP: f64 = 2.6;
/// What the f32 tangent has besides next to its zeros and poles, |x| <= 100: the error of its angle.
const TAN_ANGLE: f64 = 1.7e-13;
const ASIN_ULP: f64 = 2.0;
const ACOS_ULP: f64 = 1.5;
const ATAN2_ULP: f64 = 2.3;
const EXP_ULP: f64 = 1.0;
const LN_ULP: f64 = 1.0;
const TANH_ULP: f64 = 1.5;

/// Distance of `got` from `want` in units of the last place of `want` in f32 (subnormals included).
fn ulp_f32(got: f32, want: f64) -> f64 {
    let rounded = (want as f32).abs();
    let place = f64::from(rounded.next_up()) - f64::from(rounded);
    (f64::from(got) - want).abs() / place
}

/// `n` points that fill [low, high], ends included.
fn sweep(low: f64, high: f64, n: usize) -> impl Iterator<Item = f32> {
    (0..n).map(move |i| (low + (high - low) * i as f64 / (n - 1) as f64) as f32)
}

/// Every magnitude of f32 from the smallest subnormal up to `high`, with both signs.
fn magnitudes(high: f32) -> impl Iterator<Item = f32> {
    (0..high.to_bits()).step_by(4099).map(f32::from_bits).flat_map(|x| [x, -x])
}

#[track_caller]
fn check(name: &str, points: impl Iterator<Item = f32>, f: fn(f32) -> f32, g: fn(f64) -> f64, bound: f64) {
    let (mut worst, mut at) = (0.0, 0.0);
    for x in points {
        let error = ulp_f32(f(x), g(f64::from(x)));
        assert!(error.is_finite(), "{name}({x:e}) = {:e}, expected {:e}", f(x), g(f64::from(x)));
        if error > worst {
            (worst, at) = (error, x);
        }
    }
    println!("{name}: {worst:.3} ulp at {at:e}");
    assert!(worst <= bound, "{name}: {worst} ulp at {at:e}, bound {bound}");
}

#[test]
fn sin_cos_f32_stays_within_its_bounds() {
    let (mut worst, mut near_zero) = (0.0_f64, 0.0_f64);
    for x in sweep(-100.0, 100.0, POINTS) {
        let (s, c) = Real::sin_cos(x);
        let (s_want, c_want) = f64::from(x).sin_cos();
        for (got, want) in [(s, s_want), (c, c_want)] {
            if want.abs() > SMALL {
                worst = worst.max(ulp_f32(got, want));
            } else {
                near_zero = near_zero.max((f64::from(got) - want).abs());
            }
        }
    }
    println!("sin_cos f32: {worst:.3} ulp, {near_zero:.2e} absolute near zeros");
    assert!(worst <= SIN_COS_F32_ULP, "{worst} ulp");
    assert!(near_zero <= SIN_COS_F32_ABSOLUTE, "{near_zero}");
}

#[test]
fn small_angles_keep_their_relative_accuracy_in_f32() {
    let sine: fn(f32) -> f32 = |x| Real::sin_cos(x).0;
    check("sin near 0", magnitudes(0.5), sine, f64::sin, SIN_COS_F32_ULP);
}

#[test]
fn sin_cos_f64_stays_within_its_bound() {
    let dense = (0..POINTS_F64).map(|i| -1e5 + 2e5 * i as f64 / (POINTS_F64 - 1) as f64);
    let central = (0..POINTS_F64).map(|i| -7.0 + 14.0 * i as f64 / (POINTS_F64 - 1) as f64);
    let zeros = (-60_000_i32..=60_000).map(|k| f64::from(k) * core::f64::consts::FRAC_PI_2);
    let mut worst = (0.0, 0.0);
    for x in dense.chain(central).chain(zeros) {
        let (s, c) = Real::sin_cos(x);
        let (s_want, c_want) = double_double::sin_cos(x);
        for (got, want) in [(s, s_want), (c, c_want)] {
            let place = want.hi.abs().next_up() - want.hi.abs();
            let error = ((got - want.hi) - want.lo).abs() / place;
            if error > worst.0 {
                worst = (error, x);
            }
        }
    }
    println!("sin_cos f64: {:.4} ulp at {:e}", worst.0, worst.1);
    assert!(worst.0 <= SIN_COS_F64_ULP, "{worst:?}");
}

#[test]
fn other_functions_f32_stay_within_their_bounds() {
    let n = POINTS / 4;
    check("tan", sweep(-100.0, 100.0, n), Real::tan, f64::tan, TAN_ULP);
    let near = |place: f64| {
        (-200..=200).map(move |n| f32::from_bits((place as f32).to_bits().wrapping_add_signed(n)))
    };
    let places = (-63..=63).filter(|n| *n != 0).map(|n| f64::from(n) * std::f64::consts::FRAC_PI_2);
    let mut worst = (0.0, 0.0);
    for x in places.flat_map(near) {
        let want = f64::from(x).tan();
        let place = f64::from((want as f32).abs().next_up()) - f64::from((want as f32).abs());
        let beyond = (f64::from(Real::tan(x)) - want).abs() - TAN_ULP * place;
        let angle = beyond / (1.0 + want * want);
        worst = if angle > worst.0 { (angle, x) } else { worst };
    }
    println!("tan next to zeros and poles: an angle of {:e} at {:e}", worst.0, worst.1);
    assert!(worst.0 <= TAN_ANGLE, "{worst:?}");
    check("asin", sweep(-1.0, 1.0, n).chain(magnitudes(1.0)), Real::asin, f64::asin, ASIN_ULP);
    check("acos", sweep(-1.0, 1.0, n).chain(magnitudes(1.0)), Real::acos, f64::acos, ACOS_ULP);
    check("acos near 1", sweep(0.999, 1.0, n), Real::acos, f64::acos, ACOS_ULP);
    check("exp", sweep(-87.0, 88.7, n).chain(magnitudes(1.0)), Real::exp, f64::exp, EXP_ULP);
    check("exp, subnormal results", sweep(-103.0, -87.0, n), Real::exp, f64::exp, EXP_ULP);
    let positive = magnitudes(f32::MAX).filter(|x| *x > 0.0);
    check("ln", positive.chain(sweep(0.5, 2.0, n)), Real::ln, f64::ln, LN_ULP);
    check("tanh", sweep(-10.0, 10.0, n).chain(magnitudes(20.0)), Real::tanh, f64::tanh, TANH_ULP);
}

#[test]
fn atan2_f32_stays_within_its_bound_all_around() {
    let mut worst = (0.0, 0.0, 0.0);
    for radius in [1e-30_f32, 1e-3, 1.0, 1e30] {
        for angle in sweep(-3.2, 3.2, POINTS / 8) {
            let (y, x) = (radius * f32::sin(angle), radius * f32::cos(angle));
            let error = ulp_f32(Real::atan2(y, x), f64::atan2(y.into(), x.into()));
            if error > worst.0 {
                worst = (error, y, x);
            }
        }
    }
    for y in magnitudes(1.0) {
        let error = ulp_f32(Real::atan2(y, 1.0), f64::atan2(y.into(), 1.0));
        if error > worst.0 {
            worst = (error, y, 1.0);
        }
    }
    println!("atan2: {:.3} ulp at ({:e}, {:e})", worst.0, worst.1, worst.2);
    assert!(worst.0 <= ATAN2_ULP, "{worst:?}");
    for (y, x) in [(0.0, 1.0), (0.0, -1.0), (-0.0, -1.0), (1.0, 0.0), (-1.0, 0.0), (0.0, 0.0), (-0.0, 0.0)] {
        assert_eq!(Real::atan2(y, x), f32::atan2(y, x), "atan2({y}, {x})");
    }
}

#[test]
fn ends_of_the_domains() {
    assert_eq!(Real::exp(200.0_f32), f32::INFINITY);
    assert_eq!(Real::exp(-200.0_f32), 0.0);
    assert_eq!(Real::exp(0.0_f32), 1.0);
    assert_eq!(Real::ln(0.0_f32), f32::NEG_INFINITY);
    assert_eq!(Real::ln(1.0_f32), 0.0);
    assert_eq!(Real::ln(f32::INFINITY), f32::INFINITY);
    assert_eq!(Real::acos(1.0_f32), 0.0);
    assert_eq!(Real::asin(1.0_f32), core::f32::consts::FRAC_PI_2);
    assert_eq!(Real::acos(-1.0_f32), core::f32::consts::PI);
    assert_eq!(Real::tanh(50.0_f32), 1.0);
    for out in [Real::ln(-1.0_f32), Real::asin(1.1_f32), Real::acos(-1.1_f32), Real::sqrt(-1.0_f32)] {
        assert!(out.is_nan());
    }
}

#[test]
fn not_a_number_is_handed_on() {
    fn all<S: Scalar>(bad: S) -> [S; 10] {
        let (s, c) = bad.sin_cos();
        [
            s,
            c,
            bad.tan(),
            bad.asin(),
            bad.acos(),
            bad.atan2(S::ONE),
            S::ONE.atan2(bad),
            bad.exp(),
            bad.ln(),
            bad.tanh(),
        ]
    }
    assert!(all(f32::NAN).iter().all(|x| x.is_nan()));
    assert!(all(f64::NAN).iter().all(|x| x.is_nan()));
    for bad in [f32::INFINITY, f32::NEG_INFINITY] {
        let (s, c) = Real::sin_cos(bad);
        assert!(s.is_nan() && c.is_nan() && Real::tan(bad).is_nan() && bad.wrap_angle().is_nan());
        let (s, c) = Real::sin_cos(f64::from(bad));
        assert!(s.is_nan() && c.is_nan());
    }
    let nan = f64::NAN;
    for out in
        [Real::min(nan, 1.0), Real::min(1.0, nan), Real::max(nan, 1.0), Real::max(1.0, nan), Real::sign(nan)]
    {
        assert!(out.is_nan());
    }
}

#[test]
fn wrapping_takes_off_whole_turns() {
    for x in sweep(-100.0, 100.0, 100_000) {
        let want = f64::from(x) - core::f64::consts::TAU * (f64::from(x) / core::f64::consts::TAU).round();
        let wrapped = x.wrap_angle();
        // Next to half a turn either side may be chosen.
        let away = (f64::from(wrapped) - want).abs();
        assert!(away < 4e-7 || (away - core::f64::consts::TAU).abs() < 4e-7, "{x}: {wrapped}, {want}");
        assert!(wrapped.abs() <= core::f32::consts::PI + 1e-5);
    }
    assert_eq!(1.25_f64.wrap_angle(), 1.25);
}

proptest! {
    #[test]
    fn square_roots_are_exactly_rounded(bits32: u32, bits64: u64) {
        let (x, y) = (f32::from_bits(bits32).abs(), f64::from_bits(bits64).abs());
        prop_assume!(!x.is_nan() && !y.is_nan());
        prop_assert_eq!(Real::sqrt(x).to_bits(), x.sqrt().to_bits());
        prop_assert_eq!(Real::sqrt(y).to_bits(), y.sqrt().to_bits());
    }

    #[test]
    fn min_max_sign_of_numbers(a in -1e3..1e3_f64, b in -1e3..1e3_f64) {
        prop_assert_eq!(Real::min(a, b), f64::min(a, b));
        prop_assert_eq!(Real::max(a, b), f64::max(a, b));
        prop_assert_eq!(Real::sign(a), if a == 0.0 { a } else { a.signum() });
    }

    /// Compared as integers on purpose; here as numbers of f64, in which f32 are exact.
    #[test]
    fn sizes_are_compared_as_numbers_are(bits: [u32; 2], close: u8) {
        let near = f32::from_bits(bits[0].wrapping_add(u32::from(close)));
        let special = [0.0, -0.0, f32::INFINITY, f32::NEG_INFINITY, f32::NAN, f32::MIN_POSITIVE, 1e-45];
        for x in [f32::from_bits(bits[0]), near].into_iter().chain(special) {
            for y in [f32::from_bits(bits[1]), near].into_iter().chain(special) {
                let (least, most) = (Real::min_size(x, y), Real::max_size(x, y));
                if x.is_nan() || y.is_nan() {
                    prop_assert!(least.is_nan() && most.is_nan(), "{x:e}, {y:e}: {least:e}, {most:e}");
                    continue;
                }
                let [a, b] = [x, y].map(|x| f64::from(x).abs());
                prop_assert_eq!(f64::from(least).to_bits(), a.min(b).to_bits(), "{:e}, {:e}", x, y);
                prop_assert_eq!(f64::from(most).to_bits(), a.max(b).to_bits(), "{:e}, {:e}", x, y);
            }
        }
    }

    #[test]
    fn no_bits_make_a_function_panic(bits: u32, other: u32) {
        let (x, y) = (f32::from_bits(bits), f32::from_bits(other));
        let out = [Real::tan(x), Real::asin(x), Real::acos(x), Real::atan2(x, y), Real::exp(x), Real::ln(x), x.wrap_angle()];
        prop_assert_eq!(out.len(), 7);
    }
}

proptest! {
    #[test]
    fn differences_of_angles_are_taken_unrounded(a in -1e4_f64..1e4, near in -10.0_f64..10.0, n in -40_i32..40, power in 0_i32..16) {
        // Close to a multiple of a quarter turn from each other: there the difference cancels, or its sine or cosine.
        let b = a - f64::from(n) * std::f64::consts::FRAC_PI_2 - near * 0.1_f64.powi(power);
        let (a_exact, b_exact) = (double_double::sin_cos(a), double_double::sin_cos(b));
        let minus = |v: DoubleDouble| DoubleDouble { hi: -v.hi, lo: -v.lo };
        let sin = a_exact.0.times(b_exact.1).plus(minus(a_exact.1.times(b_exact.0)));
        let cos = a_exact.1.times(b_exact.1).plus(a_exact.0.times(b_exact.0));
        let got = Real::sin_cos_of_difference(a, b);
        for (got, want) in [(got.0, sin), (got.1, cos)] {
            // The reference itself is good to 1e-31 of 1.
            let place = (want.hi.abs().next_up() - want.hi.abs()).max(1e-29);
            let error = ((got - want.hi) - want.lo).abs() / place;
            prop_assert!(error <= DIFFERENCE_ULP, "{a} - {b}: {error} ulp of {want:?}");
        }
        prop_assert_eq!(Real::sin_cos_of_two_differences(a, b, near, a), [got, Real::sin_cos_of_difference(near, a)]);
    }

    #[test]
    fn differences_of_angles_are_taken_unrounded_in_f32(a in -40.0_f32..40.0, near in -1.0_f32..1.0, power in 0_i32..7) {
        let b = a - near * 0.1_f32.powi(power);
        let (sin, cos) = (f64::from(a) - f64::from(b)).sin_cos();
        let got = Real::sin_cos_of_difference(a, b);
        prop_assert!((f64::from(got.0) - sin).abs() <= 2.0 * f64::from(f32::EPSILON) * sin.abs().max(1e-30), "{a} - {b}: {}", got.0);
        prop_assert!((f64::from(got.1) - cos).abs() <= 2.0 * f64::from(f32::EPSILON), "{a} - {b}: {}", got.1);
    }

    #[test]
    fn two_angles_at_once_give_the_bits_of_each(x in -1e5_f64..1e5, y in -4.0_f64..4.0, bits: [u64; 2]) {
        let special = [0.0, -0.0, f64::INFINITY, f64::NAN, std::f64::consts::FRAC_PI_2];
        let pairs = [[x, y], [y, x], bits.map(f64::from_bits)].into_iter().chain(special.map(|s| [s, x]));
        for [a, b] in pairs {
            let got = Real::sin_cos_of_two(a, b);
            for ((sin, cos), angle) in got.into_iter().zip([a, b]) {
                let (sin_want, cos_want) = Real::sin_cos(angle);
                for (got, want) in [(sin, sin_want), (cos, cos_want)] {
                    let same = got.to_bits() == want.to_bits() || (got.is_nan() && want.is_nan());
                    prop_assert!(same, "{got:e} of two, {want:e} alone, angle {angle:e}");
                }
            }
        }
    }
}

/// Sine and cosine turned on from those of an angle close by [ulp]: those of the angle, and a rounding more.
const NEAR_ULP: f64 = 2.8;
/// Near zeros in f32: the bound of the angle itself, and d^3/6 at the largest turn.
const NEAR_F32_ABSOLUTE: f64 = 3e-10;

fn turned<S: Real>(from: S, to: S) -> (S, S) {
    let (sin, cos) = Real::sin_cos(from);
    Real::sin_cos_near(to, &Turn { angle: from, sin, cos })
}

#[test]
fn sines_turned_on_stay_within_their_bounds() {
    let (mut single, mut near_zero, mut double) = (0.0_f64, 0.0_f64, 0.0_f64);
    for (i, x) in sweep(-7.0, 7.0, POINTS / 4).enumerate() {
        let d = trig::NEAR * ((i * 7919 % 2001) as f64 / 1000.0 - 1.0);
        let to = (f64::from(x) + 0.999 * d) as f32;
        let (s, c) = turned(x, to);
        let (s_want, c_want) = f64::from(to).sin_cos();
        for (got, want) in [(s, s_want), (c, c_want)] {
            if want.abs() > SMALL {
                single = single.max(ulp_f32(got, want));
            } else {
                near_zero = near_zero.max((f64::from(got) - want).abs());
            }
        }
        let (from, to) = (f64::from(x), f64::from(x) + d);
        let (s, c) = turned(from, to);
        let (s_want, c_want) = double_double::sin_cos(to);
        for (got, want) in [(s, s_want), (c, c_want)].into_iter().filter(|(_, want)| want.hi.abs() > SMALL) {
            let place = want.hi.abs().next_up() - want.hi.abs();
            double = double.max(((got - want.hi) - want.lo).abs() / place);
        }
    }
    println!("turned on: f32 {single:.3} ulp, {near_zero:.2e} near zeros, f64 {double:.3} ulp");
    assert!(single <= NEAR_ULP && double <= NEAR_ULP && near_zero <= NEAR_F32_ABSOLUTE);
}

#[test]
fn what_is_not_near_is_computed_from_the_angle() {
    for (from, to) in [(0.3_f32, 0.31), (0.3, -2.0), (0.3, f32::NAN), (f32::NAN, 0.3), (f32::INFINITY, 0.3)] {
        let (got, want) = (turned(from, to), Real::sin_cos(to));
        let same = |a: f32, b: f32| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
        assert!(same(got.0, want.0) && same(got.1, want.1), "{from} {to}");
        assert!(turned(f64::from(from), f64::from(to)).0.is_nan() == to.is_nan());
    }
}

#[test]
fn half_of_the_digits() {
    assert_eq!(f32::ROOT_EPSILON, Real::sqrt(f32::EPSILON));
    assert_eq!(f64::ROOT_EPSILON, Real::sqrt(f64::EPSILON));
}

#[cfg(feature = "simd")]
mod lanes {
    use super::*;
    use wide::{f32x8, f64x4};

    type Binary = fn(f32, f32) -> f32;

    proptest! {
        #[test]
        fn every_lane_gives_the_bits_of_the_scalar(x in prop::array::uniform8(-100.0_f32..100.0), bits: [u32; 8]) {
            for values in [x, bits.map(f32::from_bits)] {
                let (s, c) = f32x8::from(values).sin_cos_own();
                let other = f32x8::from(x);
                let lanes = f32x8::from(values);
                let pairs: [(f32x8, Binary); 9] = [
                    (s, |a, _| Real::sin_cos(a).0),
                    (c, |a, _| Real::sin_cos(a).1),
                    (Real::sqrt(lanes), |a, _| Real::sqrt(a)),
                    (Real::min(lanes, other), Real::min),
                    (Real::max(lanes, other), Real::max),
                    (Real::min_size(lanes, other), Real::min_size),
                    (Real::max_size(lanes, other), Real::max_size),
                    (Real::sign(lanes), |a, _| Real::sign(a)),
                    (Real::atan2(lanes, other), Real::atan2),
                ];
                for (index, (got, scalar)) in pairs.iter().enumerate() {
                    for ((got, a), b) in got.to_array().iter().zip(values).zip(x) {
                        let want = scalar(a, b);
                        let same = got.to_bits() == want.to_bits() || (got.is_nan() && want.is_nan());
                        prop_assert!(same, "function {index}: {got:e} from lanes, {want:e} from {a:e}, {b:e}");
                    }
                }
            }
        }

        #[test]
        fn sines_are_turned_on_in_lanes_as_alone(x in prop::array::uniform8(-7.0_f32..7.0), d in prop::array::uniform8(-2e-3_f32..2e-3)) {
            let to: [f32; 8] = core::array::from_fn(|i| x[i] + d[i]);
            let (s, c) = turned(f32x8::from(x), f32x8::from(to));
            for (i, (s, c)) in s.to_array().into_iter().zip(c.to_array()).enumerate() {
                let want = turned(x[i], to[i]);
                prop_assert_eq!((s.to_bits(), c.to_bits()), (want.0.to_bits(), want.1.to_bits()));
            }
            let [x, to] = [x, to].map(|v| [v[0], v[1], v[2], v[3]].map(f64::from));
            let (s, c) = turned(f64x4::from(x), f64x4::from(to));
            for (i, (s, c)) in s.to_array().into_iter().zip(c.to_array()).enumerate() {
                let want = turned(x[i], to[i]);
                prop_assert_eq!((s.to_bits(), c.to_bits()), (want.0.to_bits(), want.1.to_bits()));
            }
        }

        #[test]
        fn sine_and_cosine_in_f64_lanes(x in prop::array::uniform4(-1e5_f64..1e5)) {
            let (s, c) = Real::sin_cos(f64x4::from(x));
            for ((s, c), x) in s.to_array().iter().zip(c.to_array()).zip(x) {
                let (s_want, c_want) = Real::sin_cos(x);
                prop_assert_eq!((s.to_bits(), c.to_bits()), (s_want.to_bits(), c_want.to_bits()));
            }
        }
    }

    /// `wide` has a `sin_cos` of its own, which a method call would find first.
    trait OwnSinCos: Real {
        fn sin_cos_own(self) -> (Self, Self) {
            Real::sin_cos(self)
        }
    }
    impl OwnSinCos for f32x8 {}
}

#[cfg(feature = "counting")]
#[test]
fn counting_counts_what_is_executed() {
    use smartbed_runtime::real::counting::{Counting, Operations, count};
    let (x, cost) = count(|| {
        let a = Counting(0.5);
        let (s, c) = a.sin_cos();
        -(s * c + a / Counting(2.0) - a).sqrt() + a.exp()
    });
    let want = -(f64::sin(0.5) * f64::cos(0.5) + 0.25 - 0.5_f64).sqrt() + f64::exp(0.5);
    assert!((x.0 - want).abs() < 1e-15);
    assert_eq!(cost, Operations { add: 3, mul: 1, div: 1, sqrt: 1, sin: 1, cos: 1, other: 1 });
    assert_eq!(cost.total(), 8);
}
