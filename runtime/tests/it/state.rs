//! Compensated sums, wrapping, and root location.

use proptest::prelude::*;
use smartbed_runtime::ode::root::{RootFault, locate};
use smartbed_runtime::ode::state::{State, advance, two_sum, wrap};

#[test]
fn ten_million_small_increments_arrive() {
    let (x, low) = (0..10_000_000).fold((1.0_f32, 0.0), |(x, low), _| advance(x, low, 1e-9));
    let want = 1.0 + 1e7 * f64::from(1e-9_f32);
    assert!((f64::from(x) + f64::from(low) - want).abs() < 1e-9);
}

#[test]
fn a_million_turns_lose_nothing() {
    /// 2 pi is off by 7e-15 a turn; 1.6e7 sums round `low` to 2^-49.
    const DRIFT: f64 = 5e-8;
    let step = 0.4_f32;
    let (mut x, mut low) = (0.0_f32, 0.0_f32);
    let n = 16_000_000;
    for _ in 0..n {
        (x, low) = advance(x, low, step);
        (x, low) = wrap(x, low);
    }
    let want = f64::from(step) * f64::from(n);
    let turns = ((want - f64::from(x)) / core::f64::consts::TAU).round();
    let drift = (want - turns * core::f64::consts::TAU) - (f64::from(x) + f64::from(low));
    println!("drift after {turns} turns: {drift:e}");
    assert!(turns > 1e6 && x.abs() < core::f32::consts::PI + 1e-5 && drift.abs() < DRIFT, "{x}, {drift:e}");
}

#[test]
fn setting_and_shapes() {
    let (mut x, mut low) = ([1.0, 2.0], [3.0, 4.0]);
    let mut state = State::new(&mut x, &mut low).unwrap();
    assert_eq!(state.low(), [0.0, 0.0]);
    assert!(state.set(&[1.0]).is_err());
    state.set(&[5.0, 6.0]).unwrap();
    assert_eq!(state.x(), [5.0, 6.0]);
    assert!(State::new(&mut [1.0], &mut [0.0, 0.0]).is_err());
}

#[test]
fn roots_are_bracketed_tightly() {
    let (low, high) = locate(|t: f64| t.cos() - t, 0.0, 1.0, 1e-14).unwrap();
    assert!(low.cos() - low >= 0.0 && high.cos() - high <= 0.0 && high - low <= 1e-14);
    let (low, high) = locate(|t: f32| t * t * t - 2e-5, -1.0, 1.0, 0.0).unwrap();
    assert!(low.next_up() == high, "neighbouring numbers: {low:e} {high:e}");
    assert_eq!(locate(|t: f64| t, 1.0, 2.0, 1e-9), Err(RootFault::NotBracketed));
    assert_eq!(locate(|_| f64::NAN, 1.0, 2.0, 1e-9), Err(RootFault::NotBracketed));
    let hole = |t: f64| if t == 0.0 || t == 1.0 { t - 0.5 } else { f64::NAN };
    assert_eq!(locate(hole, 0.0, 1.0, 1e-9), Err(RootFault::NonFinite));
}

#[test]
fn brackets_too_long_to_be_narrowed_are_refused() {
    let found = |low: f64, high: f64| locate(|t: f64| if t < 1.0 { 1.0 } else { -1.0 }, low, high, 1e-9);
    for (low, high) in [(0.0, f64::INFINITY), (f64::NEG_INFINITY, 2.0), (-1e308, 1e308), (0.0, f64::NAN)] {
        assert_eq!(found(low, high), Err(RootFault::NotBracketed), "{low} {high}");
    }
    let mut given_up = 0;
    for size in [1e100, 1e200, 8e307] {
        for low in [0.0, -size, -0.1 * size] {
            match found(low, size) {
                Ok((low, high)) => assert!(low < 1.0 && 1.0 <= high && high - low <= 1e-9, "{low} {high}"),
                fault => {
                    assert_eq!(fault, Err(RootFault::NotConverged));
                    given_up += 1;
                }
            }
        }
    }
    assert!(given_up > 0);
}

/// The root search needs few evaluations: for smooth, steep and kinked event functions, also from a wide bracket.
#[test]
fn roots_of_smooth_guards_take_few_evaluations() {
    let mean = |guard: fn(f64, f64) -> f64, width: f64| {
        let mut all = 0;
        for n in 0..1000 {
            let root = (f64::from(n) + 0.5) / 1000.0;
            let mut count = 0;
            let counted = |t: f64| {
                count += 1;
                guard(t, root)
            };
            let (low, high) = locate(counted, 0.0, 1.0, width).unwrap();
            assert!(low <= root + 1e-13 && root - 1e-13 <= high, "{root} is not within {low} and {high}");
            assert!(high - low <= width, "{width} {low} {high}");
            all += count;
        }
        f64::from(all) / 1000.0
    };
    let parabola: fn(f64, f64) -> f64 = |t, root| (root - t) * (1.0 + root + t);
    let exponential: fn(f64, f64) -> f64 = |t, root| (3.0 * root).exp() - (3.0 * t).exp();
    let kinked: fn(f64, f64) -> f64 = |t, root| if t < root { root - t } else { 1e3 * (root - t) };
    let jump: fn(f64, f64) -> f64 = |t, root| if t < root { 1.0 } else { 100.0 * (root - t) };
    // Halvings alone are 40.
    let step: fn(f64, f64) -> f64 = |t, root| if t < root { 5e-5 * (1.0 + 0.1 * t) } else { -1.0 };
    let flat: fn(f64, f64) -> f64 = |t, root| if t < root { 1.0 } else { -1e-12 * (t - root) * (t - root) };
    // What is near is seen only behind the root.
    let far: fn(f64, f64) -> f64 =
        |t, root| if t < root { 1.0 / f64::EPSILON } else { 1e6 * (root - t) * (1.0 + root + t) };
    for (name, guard, width, most) in [
        ("parabola", parabola, 1e-12, 11.2),
        ("exponential", exponential, 1e-12, 12.6),
        ("kink", kinked, 1e-12, 10.9),
        ("jump", jump, 1e-12, 20.6),
        ("step", step, 1e-12, 52.0),
        ("flat", flat, 1e-12, 52.0),
        ("far", far, 1e-12, 12.0),
        ("exponential, wide", exponential, 1e-3, 8.0),
    ] {
        let found = mean(guard, width);
        println!("{name}: {found} evaluations");
        assert!(found <= most, "{name}: {found} evaluations");
    }
    // A guard that ends at 0 has its root there.
    for sign in [1.0, -1.0] {
        let (low, high) = locate(|t: f64| sign * (t - 1.0), 0.0, 1.0, 1e-9).unwrap();
        assert!(high == 1.0 && low >= 1.0 - 1e-9, "{low} {high}");
    }
}

proptest! {
    #[test]
    fn the_sum_of_two_is_exact(a in -1e6_f32..1e6, b in -1e6_f32..1e6) {
        let (sum, error) = two_sum(a, b);
        prop_assert_eq!(sum, a + b);
        // Two f32 within 2^20 of each other, or nearly so, add exactly in f64.
        prop_assume!(a.abs() > 1e-3 && b.abs() > 1e-3);
        prop_assert_eq!(f64::from(sum) + f64::from(error), f64::from(a) + f64::from(b));
    }

    #[test]
    fn an_angle_within_half_a_turn_is_left_alone(x in -3.1_f32..3.1, low in -1e-7_f32..1e-7) {
        let low = low * x.abs().min(1.0);
        let (x, low) = two_sum(x, low);
        let (wrapped, rest) = wrap(x, low);
        prop_assert_eq!((wrapped.to_bits(), rest), (x.to_bits(), low));
    }
}
