//! Speeds as combinations of rates against the same mechanism with plain speeds.

use smartbed_codegen::{Interpreted, ParameterChoice, Program, program};
use smartbed_runtime::mechanism::Mechanism;

use crate::models::{derived_from, shipped, text_of};

/// Accelerations of order 10, a few hundred rounded operations.
const ROUNDING: f64 = 1e-10;

fn rates(program: &Program, q: &[f64], u: &[f64], inputs: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let mut mechanism = Interpreted::<f64>::new(program);
    let (mut q_dot, mut u_dot) = (vec![0.0; q.len()], vec![0.0; u.len()]);
    mechanism.rates(0.0, q, u, inputs, &mut q_dot, &mut u_dot).expect("lengths fit");
    (q_dot, u_dot)
}

/// Differentiating w = Y q' by hand: w' = Y' q' + Y q''.
#[test]
fn gyroscope_with_plain_rates_moves_alike() {
    let combined = program::derive(&shipped("gyroscope"), &ParameterChoice::default()).expect("derives");
    let text = text_of("gyroscope");
    let (head, rest) = text.split_once("[speeds]").expect("speeds");
    let rest = rest.split_once("[frames]").expect("frames").1;
    let rest = rest.split_once("[start]").expect("start").0;
    let plain = derived_from(&format!("{}[frames]{rest}", head.replace("speed = false, ", "")));
    for (q, w) in [([0.3, 1.1_f64, -0.4], [0.7, -1.2, 8.0]), ([-1.0, 2.3, 2.0], [-2.0, 3.0, -4.0])] {
        let (q_dot, w_dot) = rates(&combined, &q, &w, &[]);
        let second = rates(&plain, &q, &q_dot, &[]).1;
        let (s, c) = q[1].sin_cos();
        let expected = [
            second[1],
            second[0] * s + q_dot[0] * c * q_dot[1],
            second[2] + second[0] * c - q_dot[0] * s * q_dot[1],
        ];
        for (a, b) in w_dot.iter().zip(expected) {
            assert!((a - b).abs() < ROUNDING, "{w_dot:?} against {expected:?}");
        }
    }
}

/// A loop whose dependent speeds are combinations: same motion, and the correction still converges.
#[test]
fn combinations_of_dependent_rates() {
    let text = text_of("slider_crank");
    let plain = derived_from(&text);
    let combined = derived_from(
        &text
            .replace("b = { unit = \"rad\",", "b = { unit = \"rad\", speed = false,")
            .replace("x = { unit = \"m\",", "x = { unit = \"m\", speed = false,")
            .replace(
                "[frames]",
                "[speeds]\nv = { unit = \"m/s\", value = \"q_dot(x) - 2*l*q_dot(b)*cos(b)\", independent = false }\n\
                 w = { unit = \"rad/s\", value = \"q_dot(b) - q_dot(q)\", independent = false }\n[frames]",
            ),
    );
    for (q, w, t) in [(0.4_f64, 3.0, 0.7), (-1.9, -12.0, 0.0), (2.8, 20.0, -2.0)] {
        let b = -(0.1 * q.sin() / 0.3).asin();
        let x = 0.1 * q.cos() + 0.3 * b.cos();
        let (a, b_) = (rates(&plain, &[q, b, x], &[w], &[t]), rates(&combined, &[q, b, x], &[w], &[t]));
        for (a, b) in a.0.iter().chain(&a.1).zip(b_.0.iter().chain(&b_.1)) {
            assert!((a - b).abs() < ROUNDING * (1.0 + a.abs()), "{a} against {b}");
        }
        let mut off = [q, b + 1e-3, x - 1e-3];
        let mut mechanism = Interpreted::<f64>::new(&combined);
        for _ in 0..3 {
            mechanism.project(&mut off).expect("lengths fit");
        }
        assert!((off[1] - b).abs() < 1e-12 && (off[2] - x).abs() < 1e-12, "{off:?} against {b}, {x}");
        assert!((off[0] - q).abs() < 1e-2);
    }
}

/// A redundant constraint is dropped with a warning that names it.
#[test]
fn redundant_constraint_is_dropped_with_a_warning() {
    let text = text_of("slider_crank")
        .replace("[bodies]", "again = \"2*dot(B - S, N.x) - dot(B - S, N.y)\"\n[bodies]");
    let program = derived_from(&text);
    let warnings = program.warnings.to_string();
    assert!(warnings.starts_with("warning: `again` follows from the other constraints"), "{warnings}");
    let plain = derived_from(&text_of("slider_crank"));
    assert!(plain.warnings.items.is_empty());
    assert_eq!(program.operations(), plain.operations());
}
