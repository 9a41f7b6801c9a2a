//! Small models against equations of motion from textbooks.

use smartbed_codegen::{Interpreted, ParameterChoice, program};
use smartbed_runtime::mechanism::Mechanism;

use crate::models::shipped;

/// Numbers of order 100, some hundred rounded operations.
const ROUNDING: f64 = 1e-11;

/// u_dot of the independent speeds.
fn accelerations(name: &str, q: &[f64], u: &[f64], inputs: &[f64]) -> Vec<f64> {
    let program =
        program::derive(&shipped(name), &ParameterChoice::default()).unwrap_or_else(|e| panic!("{e}"));
    let mut mechanism = Interpreted::<f64>::new(&program);
    let (mut q_dot, mut u_dot) = (vec![0.0; q.len()], vec![0.0; u.len()]);
    mechanism.rates(0.0, q, u, inputs, &mut q_dot, &mut u_dot).expect("lengths fit");
    u_dot
}

fn assert_close(actual: &[f64], expected: &[f64]) {
    for (a, b) in actual.iter().zip(expected) {
        assert!((a - b).abs() <= ROUNDING, "{actual:?} against {expected:?}");
    }
    assert_eq!(actual.len(), expected.len());
}

#[test]
fn pendulum_with_friction() {
    let (m, l, c, g) = (0.5, 0.3, 0.01, 9.81);
    for (q, u) in [(0.3_f64, 0.0), (-1.2, 2.5), (2.9, -4.0)] {
        let expected = -g / l * q.sin() - c * u / (m * l * l);
        assert_close(&accelerations("pendulum", &[q], &[u], &[]), &[expected]);
    }
}

/// The pole leans towards +x for q > 0: (M + m) x'' + m a (q'' cos q - q'^2 sin q) = F and
/// (I + m a^2) q'' + m a x'' cos q = m g a sin q.
#[test]
fn cart_and_pole() {
    let (mc, m, l, g) = (1.0, 0.2, 0.6, 9.81);
    let (a, i) = (l / 2.0, m * l * l / 12.0);
    for (q, u, f) in [(0.1_f64, 0.5, 3.0), (-0.9, -2.0, -1.0)] {
        let (s, c) = q.sin_cos();
        let (m11, m12, m22) = (mc + m, m * a * c, i + m * a * a);
        let (b1, b2) = (f + m * a * u * u * s, m * g * a * s);
        let det = m11 * m22 - m12 * m12;
        let expected = [(m22 * b1 - m12 * b2) / det, (m11 * b2 - m12 * b1) / det];
        assert_close(&accelerations("cart_pole", &[0.2, q], &[0.7, u], &[f]), &expected);
    }
}

/// Chaplygin's sleigh with the speed v along the blade: v' = a w^2, (I + m a^2) w' = -m a v w;
/// u_x = v cos q.
#[test]
fn sleigh_on_a_blade() {
    let (m, i, a) = (2.0, 0.1, 0.2);
    let (q, w, v) = (0.8_f64, 2.0, 1.5);
    let expected = [a * w * w * q.cos() - v * q.sin() * w, -m * a * v * w / (i + m * a * a)];
    assert_close(&accelerations("sleigh", &[0.3, -0.2, q], &[v * q.cos(), w], &[]), &expected);
}
