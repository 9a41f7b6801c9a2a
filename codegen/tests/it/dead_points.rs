//! Dead points of the independent speeds: one program covers them, with all speeds as state.
//!
//! Oracles: the same mechanisms in the coordinate without dead points, in closed form, written here.

use crate::models::derived_from;
use smartbed_codegen::{Interpreted, Program};
use smartbed_runtime::mechanism::Mechanism;
use smartbed_runtime::ode::{Driven, State, rk4};
use smartbed_runtime::real::Scalar;
use std::f64::consts::PI;

/// Against independent equations, relative to the largest acceleration.
const EXACT: f64 = 1e-12;
const STATES: usize = 1000;

/// The shipped slider-crank, but for its independent coordinate.
pub fn slider_crank() -> String {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/slider_crank.toml");
    let text = std::fs::read_to_string(path).expect("it is shipped");
    let changed = text
        .replace("q = { unit = \"rad\", independent = true, nominal", "q = { unit = \"rad\", nominal")
        .replace("x = { unit = \"m\", nominal", "x = { unit = \"m\", independent = true, nominal");
    assert_eq!(changed.matches("independent = true").count(), 1);
    changed
}

/// Crank q, rod b, piston x with their rates at a crank angle, speed and acceleration.
fn follow(q: f64, u: f64, a: f64) -> [[f64; 3]; 3] {
    let (r, l) = (0.1, 0.3);
    let sin_b = -r * q.sin() / l;
    let (b, cos_b) = (sin_b.asin(), (1.0 - sin_b * sin_b).sqrt());
    let v = -r * q.cos() * u / (l * cos_b);
    let w = (r * q.sin() * u * u - r * q.cos() * a + l * sin_b * v * v) / (l * cos_b);
    let x = r * q.cos() + l * cos_b;
    let x_dot = -r * q.sin() * u - l * sin_b * v;
    let x_ddot = -r * q.cos() * u * u - r * q.sin() * a - l * cos_b * v * v - l * sin_b * w;
    [[q, b, x], [u, v, x_dot], [a, w, x_ddot]]
}

/// The crank's acceleration under a torque, its pin standing still: power of all forces along the motion.
fn crank_acceleration(q: f64, u: f64, torque: f64) -> f64 {
    carried_crank_acceleration(q, u, torque, [0.0; 2])
}

/// The same with the crank's pin moved by `e` along the piston's line, the second rate of which is `e_ddot`.
fn carried_crank_acceleration(q: f64, u: f64, torque: f64, [e, e_ddot]: [f64; 2]) -> f64 {
    let (r, l, m_rod, m_piston, i_crank, spring) = (0.1, 0.3, 0.4, 0.6, 0.02, 200.0);
    let i_rod = m_rod * l * l / 12.0;
    let [place, _, still] = follow(q, u, 0.0);
    let [_, per, _] = follow(q, 1.0, 0.0);
    // The rod's centre: r e(q) + l/2 e(b).
    let centre = |rate: [f64; 3]| {
        [
            -r * q.sin() * rate[0] - 0.5 * l * place[1].sin() * rate[1],
            r * q.cos() * rate[0] + 0.5 * l * place[1].cos() * rate[1],
        ]
    };
    let [_, now, _] = follow(q, u, 0.0);
    let turning = centre(still);
    let bias = [
        turning[0] - r * q.cos() * now[0] * now[0] - 0.5 * l * place[1].cos() * now[1] * now[1],
        turning[1] - r * q.sin() * now[0] * now[0] - 0.5 * l * place[1].sin() * now[1] * now[1],
    ];
    let v = centre(per);
    let mass =
        i_crank + i_rod * per[1] * per[1] + m_rod * (v[0] * v[0] + v[1] * v[1]) + m_piston * per[2] * per[2];
    let inertia =
        i_rod * per[1] * still[1] + m_rod * (v[0] * bias[0] + v[1] * bias[1]) + m_piston * per[2] * still[2];
    let carried = e_ddot * (m_rod * v[0] + m_piston * per[2]);
    (torque - spring * (place[2] + e - l) * per[2] - inertia - carried) / mass
}

/// Angles at and near the dead points, and all round.
fn angle(state: usize) -> f64 {
    let near = [0.0, 1e-12, -1e-9, 1e-7, -1e-5, 1e-3, -0.02][state % 7];
    let scattered = (state as f64 * 0.618_033_988_749_894_9).fract();
    match state % 3 {
        0 => near,
        1 => PI + near,
        _ => 2.0 * PI * scattered - PI,
    }
}

/// The same with the loop closed in the piston's pin, whose velocity is an unknown besides the speeds.
fn closed_in_its_pin() -> String {
    let mut text = slider_crank();
    let (from, to) =
        (text.find("[constraints").expect("a section"), text.find("[bodies]").expect("the next"));
    text.replace_range(from..to, "");
    let pin = "B = \"A + l*rod.x\"";
    assert!(text.contains(pin));
    text.replace(pin, "B = { position = \"A + l*rod.x\", closures = [\"S\"] }")
}

/// One speed determines the others, whichever is stated, as in a run; two that contradict are met as closely as
/// possible.
#[test]
fn the_start_has_all_speeds_where_all_are_state() {
    for stated in ["u_q = 3", "u_x = -0.25", "u_q = 3\nu_b = 0"] {
        let text = slider_crank().replace("u_q = 20", stated);
        let program = derived_from(&text);
        let start = program.start().expect("it can be assembled");
        let [q, b, x] = [start.u[0], start.u[1], start.u[2]];
        let [sin, cos] = [start.q[0].sin(), start.q[0].cos()];
        let left =
            [x + 0.1 * sin * q + 0.3 * start.q[1].sin() * b, 0.1 * cos * q + 0.3 * start.q[1].cos() * b];
        assert!(left.iter().all(|r| r.abs() < 1e-15), "{stated}: {left:?}");
        let [_, moving, _] = follow(start.q[0], 1.0, 0.0);
        let as_stated = match stated {
            "u_q = 3" => (q - 3.0).abs() < 1e-12 && (b - 3.0 * moving[1]).abs() < 1e-12,
            "u_x = -0.25" => (x + 0.25).abs() < 1e-12 && (q + 0.25 / moving[2]).abs() < 1e-12,
            _ => q < 3.0 && b < 0.0,
        };
        assert!(as_stated, "{stated}: {start:?}");
    }
}

#[test]
fn a_slider_crank_moves_through_the_dead_points_of_its_slider() {
    moves_as_its_crank_says(&slider_crank());
}

#[test]
fn a_slider_crank_closed_in_its_pin_moves_through_dead_points() {
    moves_as_its_crank_says(&closed_in_its_pin());
}

/// Off the loop by 1 mm and 0.01 rad, at dead points and elsewhere; no coordinate is held.
#[test]
fn a_correction_of_all_coordinates_is_the_shortest_and_quadratic() {
    let program = derived_from(&slider_crank());
    let mut mechanism = Interpreted::<f64>::new(&program);
    for state in 0..STATES {
        let [place, ..] = follow(angle(state), 0.0, 0.0);
        let off = |k: usize| 0.01 * ((state * 3 + k) as f64).sin();
        let mut q = [place[0] + off(0), place[1] + off(1), place[2] + 0.1 * off(2)];
        let before = q;
        let residuals =
            |q: [f64; 3]| [0.1 * q[0].cos() + 0.3 * q[1].cos() - q[2], 0.1 * q[0].sin() + 0.3 * q[1].sin()];
        mechanism.project(&mut q).expect("lengths fit");
        let left = residuals(q).map(f64::abs);
        assert!(left[0].max(left[1]) < 1e-4, "{state}: {left:?}");
        // The shortest way is a combination of the rows: perpendicular to the one motion that they allow.
        let [x, y, z] = [0, 1, 2].map(|i| q[i] - before[i]);
        let motion = {
            let [sin, cos] = [before[0].sin(), before[0].cos()].map(|v| 0.1 * v);
            let [sin_b, cos_b] = [before[1].sin(), before[1].cos()].map(|v| 0.3 * v);
            [-cos_b, cos, sin * cos_b - cos * sin_b]
        };
        let along = x * motion[0] + y * motion[1] + z * motion[2];
        assert!(along.abs() < 1e-12, "{state}: {along:e} along the motion");
    }
}

/// The lower end of the piston's range is its dead point.
#[test]
fn a_dead_point_at_the_end_of_a_range_is_found() {
    let text = slider_crank().replace("60*deg", "150*deg").replace("[-3.1, 3.1]", "[2, 4.2]");
    let text = text.replace("nominal = 0.337", "nominal = 0.209").replace("[0.2, 0.4]", "[0.2, 0.22]");
    moves_as_its_crank_says(&text);
}

/// At and near the dead points, and all round.
fn moves_as_its_crank_says(text: &str) {
    let program = derived_from(text);
    let names: Vec<&str> = program.u.iter().map(|u| u.name.as_str()).collect();
    assert_eq!(names, ["u_q", "u_b", "u_x"]);
    let mut mechanism = Interpreted::<f64>::new(&program);
    for state in 0..STATES {
        let (q, u, torque) = (angle(state), 20.0 * (state as f64).sin(), 3.0 * (state as f64).cos());
        let a = crank_acceleration(q, u, torque);
        let [places, rates, expected] = follow(q, u, a);
        let (mut q_dot, mut u_dot) = ([0.0; 3], [0.0; 3]);
        let pivot =
            mechanism.rates(0.0, &places, &rates, &[torque], &mut q_dot, &mut u_dot).expect("lengths fit");
        let size = expected.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        for (found, expected) in u_dot.iter().zip(&expected) {
            assert!((found - expected).abs() < EXACT * size, "{state}: {u_dot:?} {expected} at {q}");
        }
        assert!(pivot > 0.01, "{pivot} at {q}");
    }
}

/// The state after some steps of Kutta's method, and the largest change of the energy relative to its kinetic part.
fn moved<S: Scalar>(program: &Program, start: &[f64], h: f64, steps: usize) -> (Vec<f64>, f64) {
    let mut x: Vec<S> = start.iter().map(|&x| S::from_f64(x)).collect();
    let mut low = vec![S::ZERO; x.len()];
    let mut scratch = vec![S::ZERO; 8 * x.len()];
    let mut inputs = vec![S::ZERO; program.inputs.len()];
    let law = |_: S, _: &[S], _: &[S], inputs: &mut [S]| inputs.fill(S::ZERO);
    let mut driven = Driven::new(Interpreted::<S>::new(program), law, &mut inputs).expect("inputs");
    let mut state = State::new(&mut x, &mut low).expect("one length");
    let n_q = program.q.len();
    let mut observer = Interpreted::<f64>::new(program);
    let mut energy = |x: &[S]| {
        let x: Vec<f64> = x.iter().map(|x| x.to_f64()).collect();
        observer.energy(&x[..n_q], &x[n_q..]).expect("lengths fit")
    };
    let (kinetic, potential) = energy(state.x());
    let mut worst = 0.0_f64;
    for step in 0..steps {
        let before: Vec<S> = state.x().to_vec();
        let t = S::from_f64(step as f64 * h);
        let taken = rk4(&mut driven, t, S::from_f64(h), &mut state, &mut scratch);
        assert!(taken.is_ok(), "step {step}: {taken:?} at {:?}", state.x());
        // No jump: no more than the speeds say.
        for i in 0..n_q {
            let change = (state.x()[i].to_f64() - before[i].to_f64()).abs();
            let rate = before[n_q + i].to_f64().abs().max(state.x()[n_q + i].to_f64().abs());
            assert!(change < 1.5 * h * (rate + 1.0), "step {step}: coordinate {i} jumps by {change}");
        }
        let now = energy(state.x());
        worst = worst.max((now.0 + now.1 - kinetic - potential).abs() / (kinetic + potential.abs()));
    }
    (state.x().iter().map(|x| x.to_f64()).collect(), worst)
}

#[test]
fn runs_through_dead_points_keep_their_energy() {
    let program = derived_from(&slider_crank());
    let [places, rates, _] = follow(1.0, 20.0, 0.0);
    let start = [places, rates].concat();
    // Ten seconds are thirty turns, two dead points each.
    let (end, double) = moved::<f64>(&program, &start, 1e-3, 10_000);
    assert!(end[0] > 150.0, "{end:?}");
    let (_, finer) = moved::<f64>(&program, &start, 0.5e-3, 20_000);
    println!("energy: {double:.1e}, with half the step {finer:.1e}");
    assert!(double < 1e-7 && finer < 0.1 * double, "{double:e} {finer:e}");
    // Of one run rounding decides as chance does, 3e-6 to 2e-5, so that the middle of several is judged.
    let mut single: Vec<f64> = (0..7_u8)
        .map(|k| {
            let [places, rates, _] = follow(1.0 + 0.05 * f64::from(k), 20.0 - 0.1 * f64::from(k), 0.0);
            moved::<f32>(&program, &[places, rates].concat(), 1e-3, 10_000).1
        })
        .collect();
    single.sort_by(f64::total_cmp);
    println!("energy in single precision: {single:?}");
    assert!(single[3] < 1e-5, "{single:?}");
}

/// The slider-crank with its piston as independent coordinate, without torque, its crank's pin moved to and fro as a
/// function of time: at the start no dead point lies within the ranges.
fn carried_slider_crank() -> String {
    let mut text = slider_crank();
    for (from, to) in [("[inputs]", "[coordinates]"), ("[torques]", "[springs]"), ("[start]", "[run]")] {
        let (from, to) = (text.find(from).expect("a section"), text.find(to).expect("the next"));
        text.replace_range(from..to, "");
    }
    text.replace(
        "[coordinates]\n",
        "[coordinates]\ne = { unit = \"m\", closed_form = \"-0.1_m*sin(1_rad/1_s*t)\" }\n",
    )
    .replace("range = [0.2, 0.4]", "range = [0.25, 0.35]")
    .replace("A = \"r*crank.x\"", "A = \"e*N.x + r*crank.x\"")
}

#[test]
fn dead_points_that_time_brings_about_are_found() {
    let program = derived_from(&carried_slider_crank());
    let names: Vec<&str> = program.u.iter().map(|u| u.name.as_str()).collect();
    assert_eq!(names, ["u_e", "u_q", "u_b", "u_x"]);
    let mut mechanism = Interpreted::<f64>::new(&program);
    for state in 0..STATES {
        let t = 2.0 * (state as f64 * 0.754_877_666_246_692_8).fract();
        let (e, e_dot) = (-0.1 * t.sin(), -0.1 * t.cos());
        let (q, u) = (angle(state), 20.0 * (state as f64).sin());
        let a = carried_crank_acceleration(q, u, 0.0, [e, -e]);
        let [mut places, mut rates, mut expected] = follow(q, u, a);
        places[2] += e;
        rates[2] += e_dot;
        expected[2] -= e;
        // The rate of what time gives is a speed, and state, like the others.
        let rates = [&[e_dot][..], &rates[..]].concat();
        let expected = [&[-e][..], &expected[..]].concat();
        let (mut q_dot, mut u_dot) = ([0.0; 3], [0.0; 4]);
        mechanism.rates(t, &places, &rates, &[], &mut q_dot, &mut u_dot).expect("lengths fit");
        let size = expected.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        for (found, expected) in u_dot.iter().zip(&expected) {
            assert!((found - expected).abs() <= EXACT * size, "{state}: {u_dot:?} {expected} at {q}, {t}");
        }
        if state % 50 == 0 {
            crate::driven::check_power(&program, t, &places, &rates, 0.0);
        }
    }
}
