//! The machines of this repository against closed forms and equations from textbooks.

use smartbed_codegen::{Interpreted, ParameterChoice, Program, program};
use smartbed_runtime::mechanism::Mechanism;
use std::f64::consts::PI;

use crate::models::shipped;

/// Relative to the largest acceleration: a few hundred rounded operations.
const ROUNDING: f64 = 1e-11;

fn derived(name: &str) -> Program {
    program::derive(&shipped(name), &ParameterChoice::default()).unwrap_or_else(|e| panic!("{e}"))
}

/// (q', u').
fn rates(program: &Program, q: &[f64], u: &[f64], inputs: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let mut mechanism = Interpreted::<f64>::new(program);
    let (mut q_dot, mut u_dot) = (vec![0.0; q.len()], vec![0.0; u.len()]);
    mechanism.rates(0.0, q, u, inputs, &mut q_dot, &mut u_dot).expect("lengths fit");
    (q_dot, u_dot)
}

#[track_caller]
fn assert_close(actual: &[f64], expected: &[f64]) {
    assert_eq!(actual.len(), expected.len());
    let scale = expected.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
    for (a, b) in actual.iter().zip(expected) {
        assert!((a - b).abs() <= ROUNDING * scale, "{actual:?} against {expected:?}");
    }
}

/// Two rods with absolute angles t1, t2 (Lagrange): M11 t1'' + M12 t2'' + B w2^2 + G1 = T + c q2',
/// M12 t1'' + M22 t2'' - B w1^2 + G2 = -c q2', B = m2 l1 a2 sin(t1 - t2).
#[test]
fn double_pendulum_of_rods() {
    let (m1, m2, l1, l2, c, g) = (1.2, 0.8, 0.5, 0.4, 0.02, 9.81);
    let program = derived("double_pendulum");
    for (q, u, t) in [([0.7_f64, -1.1], [1.3, 0.4], 0.5), ([-2.2, 0.3], [-3.0, 5.0], -1.0)] {
        let (t1, t2) = (q[0], q[0] + q[1]);
        let (w1, w2) = (u[0], u[0] + u[1]);
        let m11 = m1 * l1 * l1 / 3.0 + m2 * l1 * l1;
        let m12 = m2 * l1 * l2 / 2.0 * (t1 - t2).cos();
        let m22 = m2 * l2 * l2 / 3.0;
        let b = m2 * l1 * l2 / 2.0 * (t1 - t2).sin();
        let r1 = t + c * u[1] - b * w2 * w2 - (m1 / 2.0 + m2) * g * l1 * t1.sin();
        let r2 = -c * u[1] + b * w1 * w1 - m2 * g * l2 / 2.0 * t2.sin();
        let det = m11 * m22 - m12 * m12;
        let (a1, a2) = ((m22 * r1 - m12 * r2) / det, (m11 * r2 - m12 * r1) / det);
        assert_close(&rates(&program, &q, &u, &[t]).1, &[a1, a2 - a1]);
    }
}

/// Euler's equations of a symmetric top in axes that do not spin: A w1' = m g h sin t + A w2^2 cot t
/// - C w3 w2, A w2' = C w3 w1 - A w1 w2 cot t, w3' = 0.
#[test]
fn gyroscope_obeys_eulers_equations() {
    let (m, h, it, c, g) = (0.3, 0.05, 2e-4, 3e-4, 9.81);
    let a = it + m * h * h;
    let program = derived("gyroscope");
    for (q, w) in [([0.3, 1.1_f64, -0.4], [0.7, -1.2, 80.0]), ([-1.0, 2.3, 2.0], [-2.0, 3.0, -40.0])] {
        let (sin, cos) = q[1].sin_cos();
        let cot = cos / sin;
        let expected = [
            (m * g * h * sin + a * w[1] * w[1] * cot - c * w[2] * w[1]) / a,
            (c * w[2] * w[0] - a * w[0] * w[1] * cot) / a,
            0.0,
        ];
        let (q_dot, w_dot) = rates(&program, &q, &w, &[]);
        assert_close(&w_dot, &expected);
        // psi' = w2 / sin t, t' = w1, phi' = w3 - w2 cot t.
        assert_close(&q_dot, &[w[1] / sin, w[0], w[2] - w[1] * cot]);
    }
}

/// J(q) q'' + J'(q)/2 q'^2 + V'(q) = T with the closed forms of rod and piston.
fn slider_crank(q: f64, w: f64, t: f64) -> [f64; 2] {
    let (r, l, m, mp, i_crank, k) = (0.1, 0.3, 0.4, 0.6, 0.02, 200.0);
    let i_rod = m * l * l / 12.0;
    let (s, c) = q.sin_cos();
    let (sb, cb) = (-r * s / l, (1.0 - (r * s / l).powi(2)).sqrt());
    let b1 = -r * c / (l * cb);
    let b2 = (r * s + l * sb * b1 * b1) / (l * cb);
    let x = r * c + l * cb;
    let x1 = -r * s - l * sb * b1;
    let x2 = -r * c - l * cb * b1 * b1 - l * sb * b2;
    let p1 = [-r * s - l / 2.0 * sb * b1, r * c + l / 2.0 * cb * b1];
    let p2 = [-r * c - l / 2.0 * (cb * b1 * b1 + sb * b2), -r * s + l / 2.0 * (cb * b2 - sb * b1 * b1)];
    let j = i_crank + i_rod * b1 * b1 + m * (p1[0] * p1[0] + p1[1] * p1[1]) + mp * x1 * x1;
    let half = i_rod * b1 * b2 + m * (p1[0] * p2[0] + p1[1] * p2[1]) + mp * x1 * x2;
    [(t - half * w * w - k * (x - l) * x1) / j, x1 * w]
}

#[test]
fn slider_crank_with_constraints() {
    let program = derived("slider_crank");
    for (q, w, t) in [(0.4_f64, 3.0, 0.7), (-1.9, -12.0, 0.0), (2.8, 20.0, -2.0)] {
        let b = -(0.1 * q.sin() / 0.3).asin();
        let x = 0.1 * q.cos() + 0.3 * b.cos();
        assert_close(&rates(&program, &[q, b, x], &[w], &[t]).1, &slider_crank(q, w, t)[..1]);
    }
}

#[test]
fn slider_crank_in_closed_form() {
    let program = derived("slider_crank_closed");
    assert_eq!(program.q.len(), 1, "closed forms are no state");
    for (q, w, t) in [(0.4_f64, 3.0, 0.7), (-1.9, -12.0, 0.0), (2.8, 20.0, -2.0)] {
        let [expected, piston_speed] = slider_crank(q, w, t);
        assert_close(&rates(&program, &[q], &[w], &[t]).1, &[expected]);
        let outputs = Interpreted::<f64>::new(&program).outputs(0.0, &[q], &[w], &[t]).expect("lengths fit");
        assert_close(&outputs[1..], &[piston_speed]);
    }
}

/// Numbers of the drive of `tile_drive`, from the textbook's formulas: (raising, lowering) torque at
/// the motor per newton, with the screw's and the worm's efficiency.
struct Drive {
    eta_screw: f64,
    eta_worm: f64,
    up: f64,
    down: f64,
}

/// Power screw: T_up = F d2/2 tan(lambda + rho), T_down = F d2/2 tan(rho - lambda); a worm driven by
/// its motor passes T on with eta = tan(lambda)/tan(lambda + rho).
fn drive(mu: f64) -> Drive {
    let (lead, d2) = (0.004_f64, 0.014);
    let lambda = (lead / (PI * d2)).atan();
    let rho = (mu / (15.0_f64).to_radians().cos()).atan();
    let (lw, rw) = ((4.5_f64).to_radians(), (0.08_f64).atan());
    let eta_worm = lw.tan() / (lw + rw).tan();
    let up = d2 / 2.0 * (lambda + rho).tan() / (30.0 * eta_worm);
    let screw_down = d2 / 2.0 * (rho - lambda).tan();
    // The screw must be driven down through the worm, or drives the worm's wheel backwards.
    let back_worm = (lw - rw).tan() / lw.tan();
    let down = if 0.0 < screw_down { screw_down / eta_worm } else { screw_down * back_worm } / 30.0;
    Drive { eta_screw: lambda.tan() / (lambda + rho).tan(), eta_worm, up, down }
}

/// Figures of a table of trapezoidal screws, three digits: Tr16x4 at friction 0.10, 0.15, 0.20; the
/// worm of 4.5 degrees at 0.08; 300 N at 0.15 need 0.53 N m.
#[test]
fn drive_formulas_have_the_figures_of_the_tables() {
    const DIGITS: f64 = 6e-4;
    for (mu, eta) in [(0.10, 0.463), (0.15, 0.364), (0.20, 0.299)] {
        assert!((drive(mu).eta_screw - eta).abs() < DIGITS, "{}", drive(mu).eta_screw);
    }
    assert!((drive(0.15).eta_worm - 0.48).abs() < 16e-3, "{}", drive(0.15).eta_worm);
    let at_screw = 300.0 * drive(0.15).up * 30.0 * drive(0.15).eta_worm;
    assert!((at_screw - 0.53).abs() < 6e-3, "{at_screw}");
}

/// Level and moving in heave: every leg carries a third; (J n^2 + m) h'' = T n - friction - c h' - m g.
#[test]
fn tile_drive_lifts_its_share() {
    let program = derived("tile_drive");
    let n = 2.0 * PI * 30.0 / 0.004;
    let share = (3.0 + 8.0) / 3.0 + 0.8 + 0.3;
    let (g, load, drive) = (9.81, (share) * 9.81, drive(0.15));
    let mut q = vec![0.0; 12];
    q[3] = 0.09;
    q[7] = 0.09;
    q[11] = 0.09;
    for (torque, speed) in [(0.02, 5e-3_f64), (0.0, -4e-3), (-0.004, -6e-3), (0.03, 2e-5)] {
        let sense = (speed / 1e-4).tanh();
        // Friction takes what the motor gives beyond the load: up and down differ.
        let (up, down) = (drive.up * n - 1.0, 1.0 + drive.down * n);
        let friction = load
            * sense
            * (if 0.0 < sense { up } else { down } * (1.0 + sense.abs()) / 2.0
                + if 0.0 < sense { down } else { up } * (1.0 - sense.abs()) / 2.0);
        let force = torque * n - friction - 40.0 * speed - share * g;
        let expected = force / (2e-6 * n * n + share);
        let found = rates(&program, &q, &[speed; 3], &[torque; 3]).1;
        assert_close(&found, &[expected; 3]);
    }
}

/// Self-locking is a property of the parameters: 0.15 locks; 0.05 in screw and worm does not.
#[test]
fn self_locking_follows_from_the_parameters() {
    let program = derived("tile_drive");
    let mut mechanism = Interpreted::<f64>::new(&program);
    let output = |mechanism: &mut Interpreted<f64>, name: &str| {
        let q = [0.0, 0.0, 0.0, 0.09, 0.0, 0.0, 0.0, 0.09, 0.0, 0.0, 0.0, 0.09];
        let at = program.outputs.iter().position(|(n, _)| n == name).expect("an output");
        mechanism.outputs(0.0, &q, &[0.0; 3], &[0.0; 3]).expect("lengths fit")[at]
    };
    assert!(0.0 < output(&mut mechanism, "locks"));
    let d = drive(0.15);
    let load = ((3.0 + 8.0) / 3.0 + 1.1) * 9.81;
    assert_close(&[output(&mut mechanism, "torque_up")], &[load * d.up]);
    assert_close(&[output(&mut mechanism, "torque_down")], &[load * d.down]);
    let mut values: Vec<f64> = program.parameters.iter().map(|p| p.value).collect();
    for (value, parameter) in values.iter_mut().zip(&program.parameters) {
        if parameter.name.starts_with("mu_") {
            *value = 0.05;
        }
    }
    mechanism.set_parameters(&values);
    assert!(output(&mut mechanism, "locks") < 0.0);
    assert!(output(&mut mechanism, "margin_screw") < 0.0 && output(&mut mechanism, "margin_worm") < 0.0);
}
