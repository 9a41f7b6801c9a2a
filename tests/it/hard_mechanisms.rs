//! Hard cases of mechanisms, each with a stated outcome, in f64 and in f32. The table of all of them, with those
//! of bodies, is docs/hard-cases.md.

use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::state::{advance, wrap};
use smartbed_tests::cases;
use smartbed_tests::closed_form::{fourbar, tile};
use smartbed_tests::loop_equations;
use smartbed_tests::stepping::Run;
use smartbed_tests::subject::{self, Built, Engine, State, Subject, named};
use smartbed_tests::tolerance::relative_error;
use std::f64::consts::{PI, TAU};

/// A model under the interpreter, with parameters.
fn model<S: Built>(name: &str, parameters: &[(&str, f64)]) -> Box<dyn Subject<S>> {
    let mut subject = S::subject(Engine::Interpreted, name);
    parameters.iter().for_each(|(name, value)| subject.set_parameter(name, *value));
    subject
}

/// Accelerations at a state.
fn accelerations<S: Built>(name: &str, parameters: &[(&str, f64)], state: &State) -> Vec<f64> {
    subject::evaluate(model::<S>(name, parameters).as_mut(), state).u_dot
}

/// No input.
fn none<S: Built>(_: S, _: &[S], _: &[S], inputs: &mut [S]) {
    inputs.fill(S::ZERO);
}

/// Steps of `h` until one is refused, at most `most`. Every state on the way is finite; a refused step changes
/// no bit.
fn until_refused<S: Built>(run: &mut Run<'_, S>, h: f64, most: usize) -> Option<Fault> {
    for step in 0..most {
        let before = run.state().map(<[S]>::to_vec);
        assert!(before.iter().flatten().all(|x| x.is_finite()), "step {step}: {before:?}");
        if let Err(fault) = run.try_rk4(h) {
            assert!(run.state() == [&before[0][..], &before[1][..]], "step {step} moved the state");
            return Some(fault);
        }
    }
    None
}

/// Largest change of the energy over `steps` steps of `h`, relative to the largest kinetic energy.
fn energy_change<S: Built>(run: &mut Run<'_, S>, h: f64, steps: usize) -> f64 {
    let start: f64 = run.energy().iter().sum();
    let [mut worst, mut swing]: [f64; 2] = [0.0; 2];
    for _ in 0..steps {
        run.rk4(h);
        let [kinetic, potential] = run.energy();
        worst = worst.max((kinetic + potential - start).abs());
        swing = swing.max(kinetic);
    }
    worst / swing
}

/// Radius of the tile's circle of screws (m).
const R: f64 = 0.2;
/// Tilt at which a rod can vanish: its cosine is a third.
const VANISHING: f64 = 1.0 / 3.0;

/// Outcome: at a tilt of 70.5 degrees the rod of leg A has no length, and closed forms that divide by it have no
/// direction. The equations of both tile models hold in this configuration and agree; no step is refused.
#[test]
fn a_rod_of_the_tile_loses_its_length() {
    // hA = 0, hB = -hC: s_A = R (1 - tan^2/2/(q + 1)) with q = 1/cos(tilt) vanishes at q = 3.
    let vanishing = R * 6.0_f64.sqrt();
    for off in [-1e-2, -1e-5, -1e-8, -1e-11, 1e-11, 1e-8, 1e-5, 1e-2] {
        let h = [0.0, vanishing + off, -vanishing - off];
        let (h_dot, thrust) = ([0.1, 0.2, 0.3], [10.0, 20.0, 30.0]);
        let [full, minimal] =
            [cases::tile_state(R, h, h_dot, thrust), cases::heights_state(h, h_dot, thrust)];
        let expected = accelerations::<f64>("tile_minimal", &[], &minimal);
        let error = relative_error(&accelerations::<f64>("tile", &[], &full), &expected);
        let single = relative_error(&accelerations::<f32>("tile", &[], &full), &expected);
        println!(
            "s_A {:.1e} m: the tiles differ by {error:.1e}, f32 by {single:.1e}",
            tile::posture(R, h).s[0]
        );
        assert!(error <= 1e-13 && single <= 2e-6, "{off:e} m: {error:e}, {single:e}");
    }
    tilt_through::<f64>(1e-12);
    tilt_through::<f32>(2e-6);
}

/// Constant forces tilt the tile until its rod has passed through length 0.
fn tilt_through<S: Built>(residual: f64) {
    let mut subject = model::<S>("tile", &[]);
    let push = |_: S, _: &[S], _: &[S], f: &mut [S]| {
        f.copy_from_slice(&[60.0, 200.0, -140.0].map(S::from_f64));
    };
    let start = cases::tile_state(R, [0.0, 0.3, -0.3], [0.0; 3], [0.0; 3]);
    let mut run = Run::new(subject.as_mut(), &start, &push);
    let cosine = |q: &[f64]| tile::posture(R, [q[0], q[4], q[8]]).tilt().cos();
    assert!(cosine(&run.coordinates()) > VANISHING);
    assert_eq!(until_refused(&mut run, 1e-3, 400), None);
    let q = run.coordinates();
    let left = loop_equations::largest_residual(R, &q);
    println!("cosine of the tilt {:.3}, s_A {:.3} m, residual {left:.1e}", cosine(&q), q[3]);
    assert!(cosine(&q) < VANISHING && q[3] < 0.0, "{q:?}");
    assert!(left <= residual, "{left:e}");
}

/// Lengths of a parallelogram linkage: at q1 = 0 all links lie on one line and it may fold two ways.
const PARALLELOGRAM: [(&str, f64); 4] = [("l1", 1.0), ("l2", 2.0), ("l3", 1.0), ("l4", 2.0)];

/// The parallelogram `angle` away from its change point.
fn parallelogram(angle: f64, speed: f64) -> State {
    State {
        q: named(&["q1", "q2", "q3"], &[angle, 0.0, angle - PI]),
        u: named(&["u1"], &[speed]),
        inputs: Vec::new(),
    }
}

/// Outcome: f32's error grows as 1/angle^2, some 2.5e-8 of it; a step that starts within 2.5e-4 rad is refused in f32,
/// within 1e-8 rad in f64, as `Fault::Singular`, state intact.
#[test]
fn change_point_in_f32() {
    for angle in [1.0, 1e-1, 1e-2, 1e-3] {
        let state = parallelogram(angle, 1.5);
        let [double, single] = [
            accelerations::<f64>("fourbar", &PARALLELOGRAM, &state),
            accelerations::<f32>("fourbar", &PARALLELOGRAM, &state),
        ];
        let error = relative_error(&single, &double);
        println!("{angle} rad from the change point: f32 errs by {error:.1e}");
        assert!(error <= 1e-7 / (angle * angle), "{angle}: {error:e}");
    }
    fn refused<S: Built>(angle: f64) -> Option<Fault> {
        let mut linkage = model::<S>("fourbar", &PARALLELOGRAM);
        until_refused(&mut Run::new(linkage.as_mut(), &parallelogram(angle, 1.5), &none), 1e-4, 1)
    }
    for angle in [0.0, 1e-8] {
        assert_eq!(refused::<f64>(angle), Some(Fault::Singular), "{angle}");
    }
    for angle in [0.0, 1e-8, 1e-5, 2.5e-4] {
        assert_eq!(refused::<f32>(angle), Some(Fault::Singular), "{angle}");
    }
}

/// Outcome: driven towards the change point, f32 stops before it with `Fault::Singular`; f64, whose singular zone is
/// narrower than a step, passes it and stays on the branch of the parallelogram.
#[test]
fn motion_through_a_change_point() {
    fn drive<S: Built>() -> (Option<Fault>, [f64; 3]) {
        let mut linkage = model::<S>("fourbar", &PARALLELOGRAM);
        let mut run = Run::new(linkage.as_mut(), &parallelogram(1.0, -1.5), &none);
        let fault = until_refused(&mut run, 1e-4, 10_000);
        (fault, run.coordinates().try_into().expect("three angles"))
    }
    let (fault, q) = drive::<f32>();
    println!("f32: {fault:?} at {q:?}");
    assert_eq!(fault, Some(Fault::Singular));
    assert!((0.0..1e-3).contains(&q[0]), "{q:?}");
    let (fault, q) = drive::<f64>();
    println!("f64: {fault:?} at {q:?}");
    assert_eq!(fault, None);
    assert!(q[0] < -1.0, "it must have passed: {q:?}");
    let residual = fourbar::residual(PARALLELOGRAM.map(|(_, length)| length), q);
    assert!(residual <= 1e-12 && q[1].abs() <= 1e-9, "{q:?}: {residual:e}");
}

/// Steps of the wheel below, and what it turns in each (rad): a million radians.
const WHEEL: (u32, f32) = (400_000, 2.5);

/// Outcome: after a million radians the error in f64 is the rounding of such angles; f32 keeps its accuracy if whole
/// turns are subtracted after each step and the rounding error of the sum is kept beside the angle.
#[test]
fn wheels_turned_a_million_radians() {
    let angles = [0.7_f32, 1.9, -2.3];
    let at = |angles: [f64; 3]| State {
        q: named(&["q0", "q1", "q2"], &angles),
        u: named(&["u0", "u1", "u2"], &[1.0, -2.0, 0.5]),
        inputs: Vec::new(),
    };
    let turned = angles.map(|angle| f64::from(angle) + f64::from(WHEEL.0) * f64::from(WHEEL.1));
    let reduced = turned.map(|angle| angle - TAU * (angle / TAU).round());
    let expected = accelerations::<f64>("pendulum3", &[], &at(reduced));
    let double = relative_error(&accelerations::<f64>("pendulum3", &[], &at(turned)), &expected);
    let wrapped = angles.map(|angle| {
        let step = |(x, low), _| {
            let (x, low) = advance(x, low, WHEEL.1);
            wrap(x, low)
        };
        f64::from((0..WHEEL.0).fold((angle, 0.0), step).0)
    });
    let single = relative_error(&accelerations::<f32>("pendulum3", &[], &at(wrapped)), &expected);
    println!("after a million radians: f64 errs by {double:.1e}, f32 by {single:.1e} at {wrapped:?}");
    assert!(double <= 1e-9 && single <= 2e-6, "{double:e}, {single:e}");
}

/// Outcome: 1000 kg on 1 g and 1 g on 1000 kg swing for 2 s and keep their energy to rounding.
#[test]
fn double_pendulum_with_a_mass_ratio_of_a_million() {
    fn change<S: Built>(m1: f64, m2: f64) -> f64 {
        let mut rods = model::<S>("double_pendulum", &[("m1", m1), ("m2", m2), ("c", 0.0)]);
        let start = State {
            q: named(&["q1", "q2"], &[1.57, 0.35]),
            u: named(&["u_q1", "u_q2"], &[0.0; 2]),
            inputs: Vec::new(),
        };
        energy_change(&mut Run::new(rods.as_mut(), &start, &none), 1e-4, 20_000)
    }
    for (m1, m2) in [(1e3, 1e-3), (1e-3, 1e3)] {
        let [double, single] = [change::<f64>(m1, m2), change::<f32>(m1, m2)];
        println!("{m1} kg above {m2} kg: energy {double:.1e}, f32 {single:.1e}");
        assert!(double <= 1e-12 && single <= 5e-6, "{m1}, {m2}: {double:e}, {single:e}");
    }
}

/// Outcome: a top of 3000 rad/s (0.3 rad a step) keeps its spin to the bit, its energy, and precesses at
/// m g h/(Ia w3), the limit of fast spin.
#[test]
fn fast_gyroscope() {
    const SPIN: f64 = 3e3;
    fn check<S: Built>(allowed: f64) {
        let mut top = model::<S>("gyroscope", &[]);
        let start = State {
            q: named(&["psi", "theta", "phi"], &[0.0, 1.0, 0.0]),
            u: named(&["w1", "w2", "w3"], &[0.0, 0.0, SPIN]),
            inputs: Vec::new(),
        };
        let mut run = Run::new(top.as_mut(), &start, &none);
        let change = energy_change(&mut run, 1e-4, 20_000);
        let precession = run.coordinates()[0] / 2.0;
        let expected = 0.3 * 9.81 * 0.05 / (3e-4 * SPIN);
        println!("energy {change:.1e}, precession {precession:.6} rad/s, limit {expected:.6}");
        assert!(change <= allowed, "{change:e}");
        assert!(run.state()[0][5] == S::from_f64(SPIN));
        assert!((precession / expected - 1.0).abs() <= 1e-3, "{precession}");
    }
    check::<f64>(1e-11);
    check::<f32>(1e-6);
}
