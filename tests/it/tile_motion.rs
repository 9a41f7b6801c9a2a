//! The tile in motion: its servo trajectory, a million steps on the constraints, energy, slow commands.

use smartbed_tests::cases;
use smartbed_tests::loop_equations;
use smartbed_tests::newton_euler::tile::Parameters;
use smartbed_tests::reference::data;
use smartbed_tests::stepping::{Run, servo};
use smartbed_tests::subject::{Built, Engine, State, Subject};

/// Radius of the reference's tile [m].
const R: f64 = 0.2;
/// The reference trajectory's own agreement is 1e-12; RK4 at 1 ms leaves its fourth-order error.
const SERVO_RK4: f64 = 1e-7;

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

/// Where each height stands among the coordinates.
fn heights_of(q: &[f64]) -> [f64; 3] {
    let stride = q.len() / 3;
    [q[0], q[stride], q[2 * stride]]
}

/// The servo law for either tile at any scalar.
fn servo_law<S: Built>(weight: f64) -> impl Fn(S, &[S], &[S]) -> Vec<S> {
    move |t, q, u| {
        let wide: Vec<f64> = q.iter().map(|x| x.to_f64()).collect();
        let speeds = [u[0].to_f64(), u[1].to_f64(), u[2].to_f64()];
        servo(weight, t.to_f64(), heights_of(&wide), speeds).map(S::from_f64).to_vec()
    }
}

/// At rest at the middle of the stroke.
fn start(model: &str) -> State {
    let (h, zero) = ([0.12; 3], [0.0; 3]);
    match model {
        "tile" => cases::tile_state(R, h, zero, zero),
        _ => cases::heights_state(h, zero, zero),
    }
}

#[test]
fn servo_trajectory_with_rk4_at_one_millisecond() {
    let expected = data::minimal().servo;
    for model in ["tile_minimal", "tile"] {
        let mut tile = subject::<f64>(model);
        let law = servo_law::<f64>(weight());
        let mut run = Run::new(tile.as_mut(), &start(model));
        let mut worst: f64 = 0.0;
        for (row, pair) in expected.t.windows(2).enumerate() {
            let steps = ((pair[1] - pair[0]) / 1e-3).round() as usize;
            for _ in 0..steps {
                run.rk4(1e-3, &law);
            }
            let found = heights_of(&run.coordinates());
            let errors = found.iter().zip(expected.h[row + 1]).map(|(a, b)| (a - b).abs());
            worst = errors.fold(worst, f64::max);
        }
        println!("{model}: servo with RK4 at 1 ms: {worst:.1e} m");
        assert!(worst <= SERVO_RK4, "{model}: {worst:e} m");
    }
}

/// A thousand seconds.
const MILLION: usize = 1_000_000;
/// Newton's correction leaves rounding of numbers below 1, over and over.
const RESIDUAL_F64: f64 = 1e-12;
/// The same in f32.
const RESIDUAL_F32: f64 = 2e-6;

/// Steps the tile under its servo and returns the worst residual after and before projection.
fn residual_of_a_long_run<S: Built>(steps: usize) -> [f64; 2] {
    let mut tile = subject::<S>("tile");
    let law = servo_law::<S>(weight());
    let mut run = Run::new(tile.as_mut(), &start("tile"));
    let mut worst: f64 = 0.0;
    for _ in 0..steps {
        run.rk4(S::from_f64(1e-3), &law);
        worst = worst.max(loop_equations::largest_residual(R, &run.coordinates()));
    }
    [worst, run.before_projection]
}

#[test]
fn a_million_steps_stay_on_the_constraints() {
    let [after, before] = residual_of_a_long_run::<f64>(MILLION);
    println!("f64, {MILLION} steps: residual {after:.1e}, before projection {before:.1e}");
    assert!(after <= RESIDUAL_F64, "{after:e}");
    let [after, before] = residual_of_a_long_run::<f32>(MILLION);
    println!("f32, {MILLION} steps: residual {after:.1e}, before projection {before:.1e}");
    assert!(after <= RESIDUAL_F32, "{after:e}");
}
