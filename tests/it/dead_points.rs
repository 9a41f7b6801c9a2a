//! Dead points of the independent speeds against Newton-Euler: a four-bar driven at its rocker, a disc that rolls
//! across the axis whose speed is independent.

use smartbed_codegen::{Interpreted, ParameterChoice, Program, model, program};
use smartbed_runtime::mechanism::Mechanism;
use smartbed_tests::closed_form::fourbar as closed_form;
use smartbed_tests::newton_euler::fourbar::Fourbar;
use smartbed_tests::random::Random;
use std::f64::consts::{FRAC_PI_2, PI};

const EXACT: f64 = 1e-12;
const STATES: usize = 1000;
const PARAMETERS: [f64; 11] = [1.0, 2.2, 1.8, 2.0, 1.1, 2.3, 1.7, 0.09, 0.9, 0.45, 9.81];

fn derived(name: &str, changes: &[(&str, &str)]) -> Program {
    let path = format!("{}/../models/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let mut text = std::fs::read_to_string(path).expect("it is shipped");
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    let model = model::parse("test.toml", &text).unwrap_or_else(|e| panic!("{e}"));
    program::derive(&model, &ParameterChoice::default()).unwrap_or_else(|e| panic!("{e}"))
}

/// q', u' and the worst pivot against what is expected of u'.
fn compare(
    program: &Program,
    engine: &mut Interpreted<f64>,
    q: &[f64],
    u: &[f64],
    inputs: &[f64],
    expected: &[f64],
) {
    let (mut q_dot, mut u_dot) = (vec![0.0; q.len()], vec![0.0; u.len()]);
    let pivot = engine.rates(0.0, q, u, inputs, &mut q_dot, &mut u_dot).expect("lengths fit");
    assert!(pivot > 1e-3, "{}: {pivot} at {q:?}", program.name);
    let size = expected.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
    for (found, expected) in u_dot.iter().zip(expected) {
        assert!(
            (found - expected).abs() < EXACT * size,
            "{}: {u_dot:?}, expected {expected} at {q:?}",
            program.name
        );
    }
}

/// The rocker reverses where crank and coupler are collinear: its speed does not determine theirs there.
#[test]
fn a_four_bar_moves_through_the_dead_points_of_its_rocker() {
    let program = derived(
        "fourbar",
        &[
            ("speed = \"u1\", independent = true", "speed = \"u1\""),
            ("speed = \"u3\", nominal", "speed = \"u3\", independent = true, nominal"),
            ("values = { q1 = \"90*deg\" }", "values = { q3 = \"-100*deg\" }"),
        ],
    );
    assert!(program.is_redundant());
    let mut engine = Interpreted::<f64>::new(&program);
    let mut random = Random::new(1);
    // Stretched and folded: the angle of the crank by the triangle of the ground, the rocker, and both links.
    let [l1, l2, l3, l4] = [1.0, 2.2, 1.8, 2.0];
    let dead = |reach: f64| ((reach * reach + l4 * l4 - l3 * l3) / (2.0 * reach * l4)).acos();
    let (stretched, folded) = (dead(l1 + l2), PI + dead(l2 - l1));
    for state in 0..STATES {
        let near = [0.0, 1e-12, -1e-9, 1e-7, -1e-4, 1e-2][state % 6];
        let q1 = match state % 3 {
            0 => stretched + near,
            1 => folded + near,
            _ => random.between(-PI, PI),
        };
        let lengths = [l1, l2, l3, l4];
        // The branch of the model's nominal configuration, and its mirror image.
        let side = if state % 2 == 0 { 1.0 } else { -1.0 };
        let Some([q2, q3]) = closed_form::assemble(lengths, q1, side) else {
            panic!("the crank turns fully")
        };
        let (q, torque) = ([q1, q2, q3], random.between(-5.0, 5.0));
        let motion = Fourbar::new(&PARAMETERS, &q, &[torque]).solve(&[random.between(-4.0, 4.0)]);
        compare(&program, &mut engine, &q, &motion.q_dot, &[torque], &motion.q_ddot);
    }
}

/// Kane and Levinson's disc with the speed of its contact along x independent: this speed does not determine the motion
/// while the disc rolls along y.
#[test]
fn a_disc_rolls_across_the_axis_of_its_independent_speed() {
    let program = derived(
        "rolling_disc",
        &[
            ("x = { unit = \"m\", speed = { independent = false }", "x = { unit = \"m\""),
            ("u2 = { unit = \"rad/s\", independent = true", "u2 = { unit = \"rad/s\", independent = false"),
        ],
    );
    assert!(program.is_redundant());
    let names: Vec<&str> = program.u.iter().map(|u| u.name.as_str()).collect();
    assert_eq!(names, ["u_x", "u_y", "u1", "u2", "u3"]);
    let mut engine = Interpreted::<f64>::new(&program);
    let mut random = Random::new(2);
    let (r, g) = (0.5, 9.81);
    for state in 0..STATES {
        let yaw = match state % 2 {
            0 => [FRAC_PI_2, -FRAC_PI_2][state / 2 % 2] + [0.0, 1e-12, 1e-8, -1e-5, 1e-2][state % 5],
            _ => random.between(-PI, PI),
        };
        let lean = random.between(-1.0, 1.0);
        let [u1, u2, u3] = [(); 3].map(|()| random.between(-5.0, 5.0));
        // Kane and Levinson's equations; the contact runs along the heading as the disc unrolls.
        let (yaw_dot, spin_dot) = (u3 / lean.cos(), u2 - u3 * lean.tan());
        let u1_dot = (4.0 * g * lean.sin() + 6.0 * r * u2 * u3 - r * u3 * u3 * lean.tan()) / (5.0 * r);
        let u2_dot = -2.0 / 3.0 * u1 * u3;
        let u3_dot = (-2.0 * u2 + u3 * lean.tan()) * u1;
        let spin_ddot = u2_dot - u3_dot * lean.tan() - u3 * u1 / lean.cos().powi(2);
        let along = |angle: f64| r * spin_dot * angle;
        let u = [along(yaw.cos()), along(yaw.sin()), u1, u2, u3];
        let x_ddot = r * (spin_ddot * yaw.cos() - spin_dot * yaw_dot * yaw.sin());
        let y_ddot = r * (spin_ddot * yaw.sin() + spin_dot * yaw_dot * yaw.cos());
        let expected = [x_ddot, y_ddot, u1_dot, u2_dot, u3_dot];
        let q = [random.between(-1.0, 1.0), random.between(-1.0, 1.0), yaw, lean, random.between(-PI, PI)];
        compare(&program, &mut engine, &q, &u, &[], &expected);
    }
}
