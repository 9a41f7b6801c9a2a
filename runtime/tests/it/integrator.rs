//! Integrators against closed forms: orders, exact discrete solutions, refusal, energy, control.

use crate::systems::{Bead, Flow, kepler, kepler_exact, oscillator, pendulum, pendulum_period};
use proptest::prelude::*;
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::Ode;
use smartbed_runtime::ode::State;
use smartbed_runtime::ode::step_size::Tolerance;
use smartbed_runtime::ode::{DormandPrince, Method, dormand_prince};
use smartbed_runtime::real::Scalar;

const FIXED: [Method; 6] = [
    Method::ExplicitEuler,
    Method::SemiImplicitEuler,
    Method::Rk4,
    Method::Verlet,
    Method::BlanesMoan4,
    Method::ImplicitMidpoint,
];
/// A tolerance that any step meets, which turns the adaptive method into one of fixed step.
const ANY: f64 = 1e30;
/// Observed orders may miss the theoretical ones by this much at the step sizes used.
const ORDER_MARGIN: f64 = 0.2;
/// Eccentricity of the Kepler problem.
const ECCENTRICITY: f64 = 0.3;

/// `steps` steps of `method` (None: Dormand-Prince without step control) over `seconds`.
fn run<S: Scalar>(method: Option<Method>, system: &mut impl Ode<S>, x: &mut [S], seconds: f64, steps: u32) {
    let (h, mut low) = (S::from_f64(seconds / f64::from(steps)), vec![S::ZERO; x.len()]);
    let time = |step: u32| S::from_f64(f64::from(step)) * h;
    let mut memory = vec![S::ZERO; dormand_prince::scratch(x.len())];
    let n = x.len();
    let mut state = State::new(x, &mut low).unwrap();
    match method {
        Some(method) => {
            for step in 0..steps {
                method.step(system, time(step), h, &mut state, &mut memory[..method.scratch(n)]).unwrap();
            }
        }
        None => {
            let any = Tolerance { absolute: S::from_f64(ANY), relative: S::ZERO };
            let mut solver = DormandPrince::new(n, any, h, &mut memory).unwrap();
            for step in 0..steps {
                assert!(solver.step(system, time(step), h, &mut state).unwrap().h == h);
            }
        }
    }
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

fn kepler_error(method: Option<Method>, steps: u32) -> f64 {
    let mut x = kepler_exact(ECCENTRICITY, 0.0);
    run(method, &mut kepler(), &mut x, 2.0, steps);
    distance(&x, &kepler_exact(ECCENTRICITY, 2.0))
}

fn pendulum_error(method: Option<Method>, steps: u32) -> f64 {
    let mut x = [2.0, 0.0];
    run(method, &mut pendulum(), &mut x, pendulum_period(2.0), steps);
    distance(&x, &[2.0, 0.0])
}

#[test]
fn observed_orders_are_the_nominal_ones() {
    let cases = [
        (Some(Method::ExplicitEuler), 1.0, 16_000),
        (Some(Method::SemiImplicitEuler), 1.0, 16_000),
        (Some(Method::Rk4), 4.0, 400),
        (None, 5.0, 100),
        (Some(Method::Verlet), 2.0, 2000),
        (Some(Method::BlanesMoan4), 4.0, 200),
        (Some(Method::ImplicitMidpoint), 2.0, 2000),
    ];
    for (method, order, steps) in cases {
        let seen = (kepler_error(method, steps) / kepler_error(method, 2 * steps)).log2();
        println!("{method:?}: order {seen:.3} on Kepler's problem");
        assert!((seen - order).abs() < ORDER_MARGIN, "{method:?}: observed order {seen}");
    }
    // A full period returns to a turning point, where a symmetric error hides one order: at least.
    for (method, order, steps) in cases {
        let seen = (pendulum_error(method, steps) / pendulum_error(method, 2 * steps)).log2();
        println!("{method:?}: order {seen:.3} on the pendulum");
        assert!(seen > order - ORDER_MARGIN, "{method:?}: observed order {seen}");
    }
}

#[test]
fn a_linear_oscillator_follows_the_stability_polynomial() {
    /// 200 steps of a few rounded operations each.
    const ROUNDING: f64 = 1e-13;
    // x(N h) = P(i h)^N for q'' = -q, in the complex plane q - i u.
    let factorial: [&[f64]; 3] = [
        &[1.0, 1.0],
        &[1.0, 1.0, 1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0],
        &[1.0, 1.0, 1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0, 1.0 / 120.0, 1.0 / 600.0],
    ];
    let h = 0.1;
    for (method, p) in [Some(Method::ExplicitEuler), Some(Method::Rk4), None].into_iter().zip(factorial) {
        let powers = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
        let term = |(k, p): (usize, &f64)| {
            let scale = p * f64::powi(h, k as i32);
            (scale * powers[k % 4].0, scale * powers[k % 4].1)
        };
        let (re, im) = p.iter().enumerate().map(term).fold((0.0, 0.0), |a, b| (a.0 + b.0, a.1 + b.1));
        let (size, angle) = (re.hypot(im).powi(200), 200.0 * im.atan2(re));
        let mut x = [1.0, 0.0];
        run(method, &mut oscillator(), &mut x, 200.0 * h, 200);
        let error = distance(&x, &[size * angle.cos(), -size * angle.sin()]) / size;
        assert!(error < ROUNDING, "{method:?}: {error:e}");
    }
}

#[test]
fn higher_order_loses_less_energy() {
    let energy = |x: &[f64; 2]| 0.5 * x[1] * x[1] - x[0].cos();
    let drift = |method| {
        let mut x = [1.0, 0.0];
        run(method, &mut pendulum(), &mut x, 50.0, 2500);
        (energy(&x) - energy(&[1.0, 0.0])).abs()
    };
    let [euler, semi, rk4, ..] = FIXED.map(|method| drift(Some(method)));
    let pair = drift(None);
    println!("energy drift: {euler:.1e} {semi:.1e} {rk4:.1e} {pair:.1e}");
    assert!(pair < rk4 && rk4 < semi && semi < euler);
}

#[test]
fn semi_implicit_euler_keeps_the_oscillators_invariant() {
    // q^2 + u^2 - h q u is conserved exactly by u -= h q, q += h u.
    let h = 0.1;
    let invariant = |x: &[f64; 2]| x[0] * x[0] + x[1] * x[1] - h * x[0] * x[1];
    let mut x = [1.0, 0.0];
    run(Some(Method::SemiImplicitEuler), &mut oscillator(), &mut x, 1e4, 100_000);
    assert!((invariant(&x) - 1.0).abs() < 1e-12, "{:e}", invariant(&x) - 1.0);
}

#[test]
fn splittings_keep_what_theory_says_of_the_oscillator() {
    // Verlet in steps of h: q^2 (1 - h^2/4) + u^2; the midpoint rule: q^2 + u^2.
    let h = 0.1;
    for (method, share) in [(Method::Verlet, 1.0 - h * h / 4.0), (Method::ImplicitMidpoint, 1.0)] {
        let invariant = |x: &[f64; 2]| share * x[0] * x[0] + x[1] * x[1];
        let mut x = [1.0, 0.0];
        run(Some(method), &mut oscillator(), &mut x, 1e4, 100_000);
        let moved = (invariant(&x) - share).abs();
        assert!(moved < 1e-12, "{method:?}: {moved:e}");
    }
}

#[test]
fn a_damped_oscillator_has_order_two_with_every_splitting() {
    // q'' = -q - u: q(t) = e^(-t/2) (cos w t + sin w t / (2 w)), w^2 = 3/4.
    let damped = |_, x: &[f64], x_dot: &mut [f64]| {
        x_dot.copy_from_slice(&[x[1], -x[0] - x[1]]);
        Ok(1.0)
    };
    let w = 0.75_f64.sqrt();
    let exact = f64::exp(-1.0) * ((2.0 * w).cos() + (2.0 * w).sin() / (2.0 * w));
    for method in [Method::Verlet, Method::BlanesMoan4, Method::ImplicitMidpoint] {
        let error = |steps| {
            let mut x = [1.0, 0.0];
            run(Some(method), &mut Flow { n: 2, n_q: 1, f: damped }, &mut x, 2.0, steps);
            (x[0] - exact).abs()
        };
        let order = (error(100) / error(200)).log2();
        println!("{method:?}: order {order:.3}");
        assert!(order > 2.0 - ORDER_MARGIN, "{method:?}: {order}");
    }
}

#[test]
fn a_step_too_long_for_an_iteration_is_refused_and_changes_nothing() {
    // Each iteration of the midpoint rule gains the factor h w / 2: at h w = 3 it moves away.
    let mut x = [1.0, 0.5];
    let (mut low, mut memory) = ([0.0; 2], [0.0; 10]);
    let mut state = State::new(&mut x, &mut low).unwrap();
    let outcome = Method::ImplicitMidpoint.step(&mut oscillator(), 0.0, 3.0, &mut state, &mut memory);
    assert_eq!(outcome.map(|_| ()), Err(Fault::Unsettled));
    assert_eq!((x, low), ([1.0, 0.5], [0.0; 2]));
}

#[test]
fn creeping_motion_arrives_in_f32() {
    /// 10 um/s for 100 s from 0.12 m: 1 mm, of which 1e-3 may be missing.
    const MISSING: f64 = 1e-6;
    let creep = |_, _: &[f32], x_dot: &mut [f32]| {
        x_dot.fill(1e-5);
        Ok(1.0)
    };
    for method in FIXED.map(Some).into_iter().chain([None]) {
        let mut x = [0.12_f32];
        run(method, &mut Flow { n: 1, n_q: 1, f: creep }, &mut x, 100.0, 100_000);
        let missing = (f64::from(x[0]) - 0.121).abs();
        println!("{method:?}: {missing:.1e} m missing of 1e-3 m");
        assert!(missing < MISSING, "{method:?}: {missing:e} m");
    }
    let plain = (0..100_000).fold(0.12_f32, |x, _| x + 1e-8);
    assert!((f64::from(plain) - 0.121).abs() > 0.2e-3, "plain sums lose a fifth: the test has teeth");
}

#[test]
fn projections_hold_the_constraint() {
    fn residual<S: Scalar>(projections: u8) -> f64 {
        let mut x = [S::ONE, S::ZERO, S::ZERO];
        run(Some(Method::Rk4), &mut Bead { projections }, &mut x, 100.0, 10_000);
        let [x, y, _] = x.map(|v| v.to_f64());
        (x * x + y * y - 1.0).abs()
    }
    println!("residuals: {:e} {:e} {:e}", residual::<f64>(0), residual::<f64>(1), residual::<f32>(1));
    assert!(residual::<f64>(0) > 1e-10, "without projection the bead drifts");
    assert!(residual::<f64>(1) < 4.0 * f64::EPSILON && residual::<f64>(2) < 4.0 * f64::EPSILON);
    assert!(residual::<f32>(1) < 4.0 * f64::from(f32::EPSILON));
}

#[test]
fn dense_output_is_continuous_and_of_order_four_at_least() {
    let error = |steps: u32| {
        let (mut x, mut low) = (kepler_exact(ECCENTRICITY, 0.0), [0.0; 4]);
        let mut memory = [0.0; dormand_prince::scratch(4)];
        let any = Tolerance { absolute: ANY, relative: 0.0 };
        let h = 2.0 / f64::from(steps);
        let mut solver = DormandPrince::new(4, any, h, &mut memory).unwrap();
        let mut state = State::new(&mut x, &mut low).unwrap();
        let mut worst = 0.0_f64;
        for step in 0..steps {
            let t = f64::from(step) * h;
            let before = state.x().to_vec();
            solver.step(&mut kepler(), t, h, &mut state).unwrap();
            let mut within = [0.0; 4];
            for theta in [0.2, 0.5, 0.8] {
                solver.dense(theta, &mut within).unwrap();
                worst = worst.max(distance(&within, &kepler_exact(ECCENTRICITY, t + theta * h)));
            }
            solver.dense(0.0, &mut within).unwrap();
            assert!(distance(&within, &before) == 0.0);
            solver.dense(1.0, &mut within).unwrap();
            assert!(distance(&within, state.x()) < 1e-15);
        }
        worst
    };
    let seen = (error(50) / error(100)).log2();
    println!("dense output: order {seen:.2}");
    assert!(seen > 4.0 - ORDER_MARGIN, "{seen}");
}

#[test]
fn the_error_follows_the_tolerance() {
    /// n steps err by `tolerance` each in position and velocity; at the pericentre (r = 1/2, v = sqrt 3) that
    /// is up to 5.7 in energy, 2 * 5.7 in the semi-axis, 3 pi times that along the orbit at speed sqrt 3,
    /// thus 190 n if all steps were there and of one sign. A tenth of them may be.
    const PER_STEP: f64 = 19.0;
    /// Each hundredth of the tolerance must bring the error down to a twentieth at least.
    const GAIN: f64 = 20.0;
    let mut last = f64::INFINITY;
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
        let (mut x, mut low) = (kepler_exact(0.5, 0.0), [0.0; 4]);
        let mut memory = [0.0; dormand_prince::scratch(4)];
        let both = Tolerance { absolute: tolerance, relative: tolerance };
        let mut solver = DormandPrince::new(4, both, 1e-3, &mut memory).unwrap();
        let mut state = State::new(&mut x, &mut low).unwrap();
        let (mut t, end) = (0.0, core::f64::consts::TAU);
        let steps = solver.advance_to(&mut kepler(), &mut t, end, 10_000, &mut state).unwrap();
        let error = distance(state.x(), &kepler_exact(0.5, 0.0));
        println!("tolerance {tolerance:e}: error {error:.1e} in {steps} steps");
        assert!(t == end);
        assert!(error < PER_STEP * f64::from(steps) * tolerance, "{error:e} at {tolerance:e}");
        assert!(GAIN * error < last, "{error:e} at {tolerance:e}, {last:e} before");
        last = error;
    }
}

/// An orbit in f32: a tolerance below rounding costs no additional steps, and the accuracy of f32 is reached.
#[test]
fn a_tolerance_finer_than_rounding_costs_no_steps() {
    let steps = |tolerance: f32| {
        let (mut x, mut low) = (kepler_exact(0.5, 0.0).map(|x| x as f32), [0.0; 4]);
        let mut memory = [0.0; dormand_prince::scratch(4)];
        let both = Tolerance { absolute: tolerance, relative: tolerance };
        let mut solver = DormandPrince::new(4, both, 1e-3, &mut memory).unwrap();
        let mut state = State::new(&mut x, &mut low).unwrap();
        let f = |_: f32, x: &[f32], x_dot: &mut [f32]| {
            let r = x[0].hypot(x[1]);
            (x_dot[0], x_dot[1]) = (x[2], x[3]);
            (x_dot[2], x_dot[3]) = (-x[0] / (r * r * r), -x[1] / (r * r * r));
            Ok(1.0)
        };
        let (mut t, end) = (0.0, core::f32::consts::TAU);
        let steps = solver.advance_to(&mut Flow { n: 4, n_q: 2, f }, &mut t, end, 10_000, &mut state);
        let off = state.x().iter().zip(kepler_exact(0.5, 0.0)).map(|(x, y)| (f64::from(*x) - y).abs());
        assert!(off.fold(0.0, f64::max) < 1e-3, "{tolerance:e}");
        steps.unwrap()
    };
    let [rounding, finer] = [10.0 * f32::EPSILON, 1e-14].map(steps);
    println!("{rounding} steps at ten units of rounding, {finer} at 1e-14");
    assert!(finer < 2 * rounding, "{finer} steps, {rounding} at ten units of rounding");
}

#[test]
fn a_stiff_decay_is_followed_at_the_stability_limit() {
    /// Stability alone asks for 606 steps (3.3 / 200 s each); DOPRI5's control, written independently in
    /// another language, takes 1024 in one run to the end: 3 % are left for the two stops between.
    const STEPS: u32 = 1055;
    // y' = -200 (y - cos t) - sin t, y = cos t - exp(-200 t).
    let f = |t: f64, x: &[f64], x_dot: &mut [f64]| {
        x_dot[0] = -200.0 * (x[0] - t.cos()) - t.sin();
        Ok(1.0)
    };
    let (mut x, mut low, mut memory) = ([0.0], [0.0], [0.0; dormand_prince::scratch(1)]);
    let tolerance = Tolerance { absolute: 1e-6, relative: 1e-6 };
    let mut solver = DormandPrince::new(1, tolerance, 1.0, &mut memory).unwrap();
    let mut state = State::new(&mut x, &mut low).unwrap();
    let (mut t, mut steps) = (0.0, 0);
    for end in [1.0, 2.0, 10.0] {
        steps += solver.advance_to(&mut Flow { n: 1, n_q: 1, f }, &mut t, end, 2000, &mut state).unwrap();
        assert!((state.x()[0] - end.cos()).abs() < 1e-5);
    }
    println!("stiff decay: {steps} steps");
    assert!((606..STEPS).contains(&steps), "{steps}");
}

#[test]
fn a_singular_mass_matrix_stops_the_motion_before_it() {
    // [1, c; c, 1] u_dot = [0, 1] with c = cos q: the pivot is sin^2 q, q runs towards 0.
    fn singular<S: Scalar>() -> (Fault, f64) {
        let f = |_, x: &[S], x_dot: &mut [S]| {
            let (s, c) = x[0].sin_cos();
            let pivot = S::ONE - c * c;
            x_dot[0] = -S::ONE;
            x_dot[1] = -c / pivot;
            let _ = s;
            Ok(pivot)
        };
        let (mut x, mut low, mut memory) = ([S::ONE, S::ZERO], [S::ZERO; 2], [S::ZERO; 10]);
        let mut state = State::new(&mut x, &mut low).unwrap();
        let h = S::from_f64(1.0 / 1024.0);
        for step in 0..2000 {
            let t = S::from_f64(f64::from(step)) * h;
            let before = (state.x().to_vec(), state.low().to_vec());
            if let Err(fault) = Method::Rk4.step(&mut Flow { n: 2, n_q: 1, f }, t, h, &mut state, &mut memory)
            {
                assert!(state.x() == before.0 && state.low() == before.1);
                return (fault, state.x()[0].to_f64());
            }
        }
        unreachable!("the singular configuration was passed unseen")
    }
    for (fault, q) in [singular::<f64>(), singular::<f32>()] {
        assert_eq!(fault, Fault::Singular);
        assert!((0.0..0.05).contains(&q), "{q}");
    }
}

/// What can go wrong at one evaluation.
#[derive(Clone, Copy, Debug)]
enum Failure {
    Fault,
    NotANumber,
    Infinite,
    Pivot(f32),
}

proptest! {
    #[test]
    fn a_refused_step_keeps_every_bit(
        start in prop::array::uniform3(-2.0_f32..2.0),
        low in prop::array::uniform3(-1e-9_f32..1e-9),
        at in 0_u32..7,
        entry in 0_usize..3,
        failure in prop_oneof![
            Just(Failure::Fault), Just(Failure::NotANumber), Just(Failure::Infinite),
            Just(Failure::Pivot(0.0)), Just(Failure::Pivot(-1e-5)), Just(Failure::Pivot(f32::NAN)),
        ],
    ) {
        let evaluations = [1, 2, 4, 2, 2, 2, 7];
        for (method, evaluations) in FIXED.map(Some).into_iter().chain([None]).zip(evaluations) {
            let mut count = 0;
            let f = |_, x: &[f32], x_dot: &mut [f32]| {
                x_dot.copy_from_slice(x);
                // Attempts after the failed one fail too.
                let fails = count >= at % evaluations;
                count += 1;
                match failure {
                    _ if !fails => return Ok(1.0),
                    Failure::Fault => return Err(Fault::NonFinite),
                    Failure::NotANumber => x_dot[entry] = f32::NAN,
                    Failure::Infinite => x_dot[entry] = f32::INFINITY,
                    Failure::Pivot(pivot) => return Ok(pivot),
                }
                Ok(1.0)
            };
            let mut system = Flow { n: 3, n_q: 2, f };
            let (mut x, mut rest) = (start, low);
            let mut memory = [0.0; dormand_prince::scratch(3)];
            let mut state = State::resume(&mut x, &mut rest).unwrap();
            let fault = match method {
                Some(method) => method.step(&mut system, 0.0, 0.1, &mut state, &mut memory).err(),
                None => {
                    let tolerance = Tolerance { absolute: 1.0, relative: 1.0 };
                    let mut solver = DormandPrince::new(3, tolerance, 0.1, &mut memory).unwrap();
                    solver.step(&mut system, 0.0, 0.1, &mut state).err()
                }
            };
            // Rates of coordinates in the first evaluation of semi-implicit Euler are not used.
            let unused = matches!(method, Some(Method::SemiImplicitEuler)) && fault.is_none();
            let expected = match failure {
                Failure::Pivot(p) if !p.is_nan() => Fault::Singular,
                _ => Fault::NonFinite,
            };
            prop_assert!(unused || fault == Some(expected), "{method:?}: {fault:?}");
            if fault.is_some() {
                prop_assert_eq!(x.map(f32::to_bits), start.map(f32::to_bits));
                prop_assert_eq!(rest.map(f32::to_bits), low.map(f32::to_bits));
            }
        }
    }

    #[test]
    fn wrong_lengths_are_refused(n in 0_usize..6, scratch in 0_usize..12) {
        for method in FIXED {
            let (mut x, mut low, mut memory) = (vec![0.0; n], vec![0.0; n], vec![0.0; scratch]);
            let mut state = State::new(&mut x, &mut low).unwrap();
            let outcome = method.step(&mut oscillator(), 0.0, 0.1, &mut state, &mut memory);
            let fits = n == 2 && scratch >= method.scratch(2);
            prop_assert_eq!(outcome.err(), if fits { None } else { Some(Fault::Shape) });
        }
    }
}

#[test]
fn an_unmet_tolerance_is_a_fault() {
    // Rates that change their sign at every evaluation have no derivative, however short the step.
    let mut sign = 1.0;
    let f = |_, _: &[f64], x_dot: &mut [f64]| {
        sign = -sign;
        x_dot[0] = sign;
        Ok(1.0)
    };
    let (mut x, mut low, mut memory) = ([0.5], [0.0], [0.0; dormand_prince::scratch(1)]);
    let mut solver =
        DormandPrince::new(1, Tolerance { absolute: 1e-300, relative: 0.0 }, 1.0, &mut memory).unwrap();
    let mut state = State::new(&mut x, &mut low).unwrap();
    let outcome = solver.step(&mut Flow { n: 1, n_q: 1, f }, 0.3, 1.0, &mut state);
    assert_eq!(outcome, Err(Fault::StepSize));
    assert!(state.x() == [0.5] && state.low() == [0.0]);
}

#[test]
fn time_goes_forward_only() {
    let (mut x, mut low, mut memory) = ([1.0, 0.0], [0.0; 2], [0.0; dormand_prince::scratch(2)]);
    let tolerance = Tolerance { absolute: 1e-9, relative: 1e-9 };
    let mut solver = DormandPrince::new(2, tolerance, 0.01, &mut memory).unwrap();
    let mut state = State::new(&mut x, &mut low).unwrap();
    for h_max in [-0.1, 0.0, f64::NAN, f64::NEG_INFINITY] {
        let outcome = solver.step(&mut oscillator(), 1.0, h_max, &mut state);
        assert_eq!(outcome, Err(Fault::StepSize), "{h_max}");
    }
    for end in [0.9, f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
        let mut t = 1.0;
        let outcome = solver.advance_to(&mut oscillator(), &mut t, end, 1000, &mut state);
        assert_eq!((outcome, t), (Err(Fault::StepSize), 1.0), "{end}");
    }
    assert!(state.x() == [1.0, 0.0] && solver.next == 0.01);
    // An end before t by rounding is t.
    let mut t = 1.0 + f64::EPSILON;
    assert_eq!(solver.advance_to(&mut oscillator(), &mut t, 1.0, 0, &mut state), Ok(0));
    // The longest step may be infinite, the next one not as well.
    assert_eq!(solver.step(&mut oscillator(), t, f64::INFINITY, &mut state).unwrap().h, 0.01);
    solver.next = f64::INFINITY;
    assert_eq!(solver.step(&mut oscillator(), t, f64::INFINITY, &mut state), Err(Fault::StepSize));
}

#[test]
fn dense_output_is_that_of_an_accepted_step() {
    let (mut x, mut low, mut memory) = ([1.0], [0.0], [0.0; dormand_prince::scratch(1)]);
    let tolerance = Tolerance { absolute: 1e-6, relative: 1e-6 };
    let mut solver = DormandPrince::new(1, tolerance, 0.1, &mut memory).unwrap();
    let mut state = State::new(&mut x, &mut low).unwrap();
    let growth = |is_known: bool| Flow {
        n: 1,
        n_q: 1,
        f: move |_, x: &[f64], x_dot: &mut [f64]| {
            x_dot[0] = if is_known { x[0] } else { f64::NAN };
            Ok(1.0)
        },
    };
    let mut within = [0.0];
    assert_eq!(solver.dense(0.5, &mut within), Err(Fault::StepSize));
    let h = solver.step(&mut growth(true), 0.0, 0.1, &mut state).unwrap().h;
    // What is refused before it is tried leaves the last step as it is.
    assert_eq!(solver.step(&mut growth(true), h, -1.0, &mut state), Err(Fault::StepSize));
    solver.dense(0.5, &mut within).unwrap();
    assert!((within[0] - (0.5 * h).exp()).abs() < 1e-6, "{within:?}");
    assert_eq!(solver.step(&mut growth(false), h, 0.1, &mut state), Err(Fault::NonFinite));
    assert_eq!(solver.dense(0.5, &mut within), Err(Fault::StepSize));
    assert!((within[0] - (0.5 * h).exp()).abs() < 1e-6, "{within:?}");
}
