//! The tile in motion: its servo trajectory, a million steps on the constraints, energy, slow commands.

use smartbed_runtime::real::Scalar;
use smartbed_tests::cases;
use smartbed_tests::loop_equations;
use smartbed_tests::newton_euler::tile::Parameters;
use smartbed_tests::reference::data;
use smartbed_tests::stepping::{self, Run, SERVO_DAMPING, SERVO_STIFFNESS};
use smartbed_tests::subject::{Built, Engine, State, Subject};

/// Radius of the reference's tile (m).
const R: f64 = 0.2;
/// Height at which the servo trajectory starts (m).
const MIDDLE: f64 = 0.12;

/// A compiled model with the reference's parameters.
fn subject<S: Built>(model: &str) -> Box<dyn Subject<S>> {
    let mut subject = S::subject(Engine::Compiled, model);
    for (name, value) in data::minimal().parameters {
        subject.set_parameter(&name, value);
    }
    subject
}

/// What the thrusts carry at rest.
fn weight() -> f64 {
    let values: Vec<f64> = data::minimal().parameters.iter().map(|(_, value)| *value).collect();
    Parameters::new(&values).weight()
}

/// The three heights among the coordinates of either tile, and of speeds.
fn heights<S: Scalar>(x: &[S]) -> [f64; 3] {
    let stride = x.len() / 3;
    [0, 1, 2].map(|leg| x[leg * stride].to_f64())
}

/// A law from times, heights and their rates for either tile at any scalar, computed in f64.
fn law<S: Scalar>(thrusts: impl Fn(f64, [f64; 3], [f64; 3]) -> [f64; 3]) -> impl Fn(S, &[S], &[S], &mut [S]) {
    move |t, q, u, inputs| {
        for (input, thrust) in inputs.iter_mut().zip(thrusts(t.to_f64(), heights(q), heights(u))) {
            *input = S::from_f64(thrust);
        }
    }
}

/// At rest at three heights.
fn at_rest(model: &str, h: [f64; 3]) -> State {
    let zero = [0.0; 3];
    match model {
        "tile" => cases::tile_state(R, h, zero, zero),
        _ => cases::heights_state(h, zero, zero),
    }
}

/// Largest difference of three heights.
fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).fold(0.0, |worst: f64, (a, b)| worst.max((a - b).abs()))
}

/// RK4 at 1 ms leaves its fourth-order error.
const SERVO_RK4: f64 = 1e-7;
/// The reference trajectory's own two solutions agree to 1.2e-12; local errors of 1e-12 add up.
const SERVO_DORMAND_PRINCE: f64 = 1e-9;

#[test]
fn servo_trajectory_with_rk4_at_one_millisecond() {
    let expected = data::minimal().servo;
    let weight = weight();
    let law = law::<f64>(move |t, h, h_dot| stepping::servo(weight, t, h, h_dot));
    for model in ["tile_minimal", "tile"] {
        let mut tile = subject::<f64>(model);
        let mut run = Run::new(tile.as_mut(), &at_rest(model, [MIDDLE; 3]), &law);
        let mut worst: f64 = 0.0;
        for (row, pair) in expected.t.windows(2).enumerate() {
            let steps = ((pair[1] - pair[0]) / 1e-3).round() as usize;
            (0..steps).for_each(|_| run.rk4(1e-3));
            worst = worst.max(apart(heights(&run.coordinates()), expected.h[row + 1]));
        }
        println!("{model}: servo with RK4 at 1 ms: {worst:.1e} m");
        assert!(worst <= SERVO_RK4, "{model}: {worst:e} m");
    }
}

#[test]
fn servo_trajectory_with_dormand_prince() {
    let expected = data::minimal().servo;
    let weight = weight();
    let law = law::<f64>(move |t, h, h_dot| stepping::servo(weight, t, h, h_dot));
    for model in ["tile_minimal", "tile"] {
        let mut tile = subject::<f64>(model);
        let mut run = Run::new(tile.as_mut(), &at_rest(model, [MIDDLE; 3]), &law);
        let mut worst: f64 = 0.0;
        let mut rows = expected.h[1..].iter();
        run.dormand_prince(1e-12, &expected.t[1..], |x| {
            let n_q = x.len() - 3;
            let row = rows.next().expect("one row per time");
            worst = worst.max(apart(heights(&x[..n_q]), *row));
        });
        println!("{model}: servo with Dormand-Prince at 1e-12: {worst:.1e} m");
        assert!(worst <= SERVO_DORMAND_PRINCE, "{model}: {worst:e} m");
    }
}

/// A thousand seconds.
const MILLION: usize = 1_000_000;
/// Newton's correction leaves the rounding error of numbers below 1 after each step.
const RESIDUAL_F64: f64 = 1e-12;
/// The same in f32.
const RESIDUAL_F32: f64 = 2e-6;

/// Steps the tile under its servo and returns the worst residual after and before projection.
fn residual_of_a_long_run<S: Built>() -> [f64; 2] {
    let weight = weight();
    let law = law::<S>(move |t, h, h_dot| stepping::servo(weight, t, h, h_dot));
    let mut tile = subject::<S>("tile");
    let mut run = Run::new(tile.as_mut(), &at_rest("tile", [MIDDLE; 3]), &law);
    let mut worst: f64 = 0.0;
    for _ in 0..MILLION {
        run.rk4(1e-3);
        worst = worst.max(loop_equations::largest_residual(R, &run.coordinates()));
    }
    [worst, run.before_projection]
}

#[test]
fn a_million_steps_stay_on_the_constraints() {
    let [after, before] = residual_of_a_long_run::<f64>();
    println!("f64, {MILLION} steps: residual {after:.1e}, before projection {before:.1e}");
    assert!(after <= RESIDUAL_F64, "{after:e}");
}

#[test]
fn a_million_steps_stay_on_the_constraints_in_f32() {
    let [after, before] = residual_of_a_long_run::<f32>();
    println!("f32, {MILLION} steps: residual {after:.1e}, before projection {before:.1e}");
    assert!(after <= RESIDUAL_F32, "{after:e}");
}

/// Drift of the energy relative to the largest kinetic energy on the way.
const DRIFT: f64 = 1e-9;

#[test]
fn energy_is_conserved_on_support_springs() {
    for model in ["tile", "tile_minimal"] {
        let mut tile = f64::loaded(Engine::Compiled, model);
        for (name, value) in data::minimal().parameters {
            tile.set_parameter(&name, value);
        }
        tile.set_parameter("c", 0.0);
        tile.set_parameter("k_support", 2000.0);
        // Springs that carry the weight at height 0: the tile swings about it.
        tile.set_parameter("h_support", weight() / 3.0 / 2000.0);
        let none = |_: f64, _: &[f64], _: &[f64], inputs: &mut [f64]| inputs.fill(0.0);
        let mut run = Run::new(tile.as_mut(), &at_rest(model, [0.05, -0.02, 0.01]), &none);
        let start: f64 = run.energy().iter().sum();
        let [mut drift, mut swing]: [f64; 2] = [0.0; 2];
        for _ in 0..100_000 {
            run.rk4(1e-4);
            let [kinetic, potential] = run.energy();
            drift = drift.max((kinetic + potential - start).abs());
            swing = swing.max(kinetic);
        }
        println!("{model}: drift {drift:.1e} J of a swing of {swing:.1} J");
        assert!(1.0 < swing, "the tile must move: {swing} J");
        assert!(drift <= DRIFT * swing, "{model}: {drift:e} J");
    }
}

/// Share of the commanded way.
const ARRIVAL: f64 = 1e-3;

#[test]
fn slow_command_arrives_in_f32() {
    let (speed, seconds, h) = (1e-5, 100.0, 1e-3);
    let weight = weight();
    let law = law::<f32>(move |t, h, h_dot| {
        stepping::follow(weight, [MIDDLE + speed * t, MIDDLE, MIDDLE], h, h_dot)
    });
    let mut tile = subject::<f32>("tile");
    let mut run = Run::new(tile.as_mut(), &at_rest("tile", [MIDDLE; 3]), &law);
    let start = heights(&run.coordinates())[0];
    (0..(seconds / h) as usize).for_each(|_| run.rk4(h));
    let moved = heights(&run.coordinates())[0] - start;
    // A moving command is followed at a constant distance: friction and damping against stiffness.
    let behind = (SERVO_DAMPING + 40.0) * speed / SERVO_STIFFNESS;
    let error = (moved + behind - speed * seconds).abs() / (speed * seconds);
    println!("f32: {speed} m/s for {seconds} s: moved {moved:.6e} m, relative error {error:.1e}");
    assert!(error <= ARRIVAL, "{error:e}");
}

/// Newton's method squares the error: a tenth of a millimetre leaves some 1e-8, curvature times its square.
const QUADRATIC: f64 = 50.0;

#[test]
fn projection_converges_quadratically() {
    let h = [0.05, -0.03, 0.02];
    let mut tile = subject::<f64>("tile");
    let exact: Vec<f64> = at_rest("tile", h).q.iter().map(|(_, value)| *value).collect();
    for size in [1e-2, 1e-3, 1e-4] {
        // Every dependent coordinate off by another multiple.
        let mut q = exact.clone();
        for k in (0..12).filter(|k| k % 4 != 0) {
            q[k] += size * (1.0 + 0.37 * k as f64).sin();
        }
        let before = loop_equations::largest_residual(R, &q);
        let reported = tile.project(&mut q).expect("twelve coordinates");
        let after = loop_equations::largest_residual(R, &q);
        println!("projection: residual {before:.1e} (reported {reported:.1e}), then {after:.1e}");
        assert!(after <= QUADRATIC * before * before, "{before:e}, then {after:e}");
        assert!([0, 4, 8].iter().all(|&k| q[k] == exact[k]), "heights are independent: {q:?}");
    }
}
