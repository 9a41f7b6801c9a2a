//! Free motion of rigid bodies: conservation over a million steps, order 4, a symmetric top's closed form, the flip of
//! the intermediate axis.

use smartbed_runtime::rigid::attitude::Attitude;
use smartbed_runtime::rigid::motion::{TooFast, advance};
use smartbed_runtime::rigid::{RigidBody, RigidState};

const NONE: [f64; 3] = [0.0; 3];

fn spinning(body: &RigidBody<f64>, attitude: Attitude<f64>, rate: [f64; 3]) -> RigidState<f64> {
    let momentum = std::array::from_fn(|i| body.inertia[i] * rate[i]);
    let angular_momentum = attitude.to_inertial(momentum);
    RigidState { position: NONE, velocity: NONE, attitude, angular_momentum }
}

fn body_rate(body: &RigidBody<f64>, state: &RigidState<f64>) -> [f64; 3] {
    state.attitude.to_body(body.angular_velocity(state))
}

#[test]
fn a_million_steps_of_any_size_keep_energy_and_angular_momentum() {
    let body = RigidBody { mass: 2.0, inertia: [1.0, 2.0, 2.5] };
    for h in [1e-3, 0.1, 3.0] {
        let steps = if h > 1.0 { 100_000 } else { 1_000_000 };
        let mut state = spinning(&body, Attitude::new([0.5, 0.5, -0.5, 0.5]), [0.3, 1.0, -0.4]);
        let (energy, momentum) = (body.kinetic(&state), state.angular_momentum);
        for _ in 0..steps {
            advance(&body, &mut state, NONE, NONE, h).expect("a small turn");
        }
        let drift = (body.kinetic(&state) - energy).abs() / energy;
        assert!(drift <= 1e-12, "{drift} at h = {h}");
        assert_eq!(state.angular_momentum, momentum);
    }
}

#[test]
fn the_intermediate_axis_flips_when_it_should_and_the_order_is_four() {
    let body = RigidBody { mass: 2.0, inertia: [1.0, 2.0, 3.0] };
    let at_50 = |steps: u32| {
        let mut state = spinning(&body, Attitude::new([0.5, 0.5, 0.5, 0.5]), [0.01, 1.0, 0.01]);
        for _ in 0..steps {
            advance(&body, &mut state, NONE, NONE, 50.0 / f64::from(steps)).expect("a small turn");
        }
        (body_rate(&body, &state), state.attitude.parameters())
    };
    // Euler's equations alone, by RK4 in small steps.
    let mut w = [0.01, 1.0, 0.01];
    let rate = |w: [f64; 3]| [-w[1] * w[2], w[2] * w[0], -w[0] * w[1] / 3.0];
    let h = 1e-4;
    for _ in 0..500_000 {
        let along = |s: f64, k: [f64; 3]| -> [f64; 3] { std::array::from_fn(|i| w[i] + s * k[i]) };
        let a = rate(w);
        let b = rate(along(0.5 * h, a));
        let c = rate(along(0.5 * h, b));
        let d = rate(along(h, c));
        w = std::array::from_fn(|i| w[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
    }
    let (fine, attitude) = at_50(20_000);
    for i in 0..3 {
        assert!((fine[i] - w[i]).abs() <= 1e-9, "{fine:?} {w:?}");
    }
    let error = |steps: u32| {
        let (_, e) = at_50(steps);
        e.iter().zip(attitude).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
    };
    let order = (error(500) / error(1000)).log2();
    assert!((3.8..4.6).contains(&order), "order {order}");
}

#[test]
fn a_symmetric_top_precesses_steadily() {
    // J = (A, A, C): the axis goes round the angular momentum at |L|/A.
    let body = RigidBody { mass: 1.0, inertia: [2.0, 2.0, 3.0] };
    let mut state = spinning(&body, Attitude::identity(), [0.4, 0.0, 1.0]);
    let l = state.angular_momentum;
    let size = l.iter().map(|x| x * x).sum::<f64>().sqrt();
    let (steps, h) = (1000, 0.01);
    for _ in 0..steps {
        advance(&body, &mut state, NONE, NONE, h).expect("a small turn");
    }
    let axis = state.attitude.to_inertial([0.0, 0.0, 1.0]);
    // Rodrigues' formula on the axis at the start, about L/|L|, by |L| t/A.
    let (k, turned) = (l.map(|x| x / size), size / 2.0 * f64::from(steps) * h);
    let a = [0.0, 0.0, 1.0];
    let cross = [k[1] * a[2] - k[2] * a[1], k[2] * a[0] - k[0] * a[2], k[0] * a[1] - k[1] * a[0]];
    for i in 0..3 {
        let expected = a[i] * turned.cos() + cross[i] * turned.sin() + k[i] * k[2] * (1.0 - turned.cos());
        assert!((axis[i] - expected).abs() <= 1e-9, "{axis:?}");
    }
}

#[test]
fn a_throw_is_a_parabola_and_too_fast_a_turn_is_refused() {
    let body = RigidBody { mass: 3.0, inertia: [1.0; 3] };
    let mut state = spinning(&body, Attitude::identity(), [0.1, 0.0, 0.0]);
    state.velocity = [1.0, 0.0, 5.0];
    for _ in 0..100 {
        advance(&body, &mut state, [0.0, 0.0, -3.0 * 9.81], [0.0, 0.0, 0.5], 0.01).expect("a small turn");
    }
    assert!((state.position[2] - (5.0 - 0.5 * 9.81)).abs() <= 1e-13);
    assert!((state.angular_momentum[2] - 0.5).abs() <= 1e-14);
    let before = state;
    for h in [f64::NAN, f64::INFINITY, 1e12] {
        assert_eq!(advance(&body, &mut state, NONE, NONE, h), Err(TooFast));
        assert_eq!(state, before);
    }
}
