//! Driven mechanisms: velocities with a part that no speed enters, and places that depend on time.
//!
//! Oracles: accelerations written out by hand; d/dt (kinetic + potential) against the power of the drive.

use smartbed_codegen::model;
use smartbed_codegen::{Interpreted, ParameterChoice, Program, program};
use smartbed_runtime::mechanism::Mechanism;

/// Values of a reproducible sequence in (-1, 1).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

fn derived(text: &str) -> Program {
    let model = model::parse("driven.toml", text).unwrap_or_else(|found| panic!("{found}"));
    program::derive(&model, &ParameterChoice::default()).unwrap_or_else(|found| panic!("{found}"))
}

fn rates(engine: &mut Interpreted<f64>, t: f64, q: &[f64], u: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let (mut q_dot, mut u_dot) = (vec![0.0; q.len()], vec![0.0; u.len()]);
    engine.rates(t, q, u, &[], &mut q_dot, &mut u_dot).expect("lengths fit");
    (q_dot, u_dot)
}

/// Largest difference, relative to the largest of the expected values or 1.
fn off(found: &[f64], expected: &[f64]) -> f64 {
    let scale = expected.iter().fold(1.0, |m: f64, x| m.max(x.abs()));
    found.iter().zip(expected).fold(0.0, |m, (a, b)| m.max((a - b).abs() / scale))
}

const ARM: &str = r#"
format = 1
name = "arm"
dof = 1
gravity = "-g*N.y"
[parameters]
r = { value = 0.1, unit = "m" }
l = { value = 0.5, unit = "m" }
m = { value = 1, unit = "kg" }
w = { value = 20, unit = "rad/s" }
g = { value = 9.81, unit = "m/s^2" }
[coordinates]
CRANK
q = { unit = "rad", independent = true }
[frames]
arm = { rotations = [["z", "crank"]] }
rod = { rotations = [["z", "q"]] }
[points]
A = "r*arm.x"
P = "A - l*rod.y"
[bodies]
bob = { centre = "P", mass = "m" }
[run]
seconds = 5
"#;

/// l q'' = -g sin q + r w^2 sin(crank - q + pi/2): the pivot's acceleration -r w^2 arm.x beside gravity.
fn arm_acceleration(crank: f64, w: f64, w_dot: f64, q: f64) -> f64 {
    let (r, l, g) = (0.1, 0.5, 9.81);
    let pivot = [
        -r * w_dot * crank.sin() - r * w * w * crank.cos(),
        r * w_dot * crank.cos() - r * w * w * crank.sin(),
    ];
    // Along the rod's x, at right angles to it.
    -(pivot[0] * q.cos() + (pivot[1] + g) * q.sin()) / l
}

#[test]
fn a_motion_constraint_has_a_part_without_speeds() {
    let text = ARM.replace("CRANK", "crank = { unit = \"rad\", speed = { independent = false } }")
        + "[constraints.motion]\ndrive = \"u_crank - w*(1 + sin(3_rad/1_s*t))\"\n";
    let mut engine = Interpreted::<f64>::new(&derived(&text));
    let mut random = Random(1);
    for _ in 0..1000 {
        let (t, q, u) =
            (2.0 + 2.0 * random.next(), [4.0 * random.next(), 3.0 * random.next()], [9.0 * random.next()]);
        let (w, w_dot) = (20.0 * (1.0 + (3.0 * t).sin()), 60.0 * (3.0 * t).cos());
        let expected = [w, u[0], arm_acceleration(q[0], w, w_dot, q[1])];
        let (mut found, u_dot) = rates(&mut engine, t, &q, &u);
        found.extend(u_dot);
        assert!(off(&found, &expected) <= 1e-12, "{found:?} {expected:?}");
    }
}

#[test]
fn a_coordinate_is_a_function_of_time() {
    let text = ARM.replace("CRANK", "crank = { unit = \"rad\", closed_form = \"w*t + sin(3_rad/1_s*t)\" }");
    let mut engine = Interpreted::<f64>::new(&derived(&text));
    let mut random = Random(2);
    for _ in 0..1000 {
        let (t, q, u) = (2.0 + 2.0 * random.next(), [3.0 * random.next()], [9.0 * random.next()]);
        let (crank, w, w_dot) =
            (20.0 * t + (3.0 * t).sin(), 20.0 + 3.0 * (3.0 * t).cos(), -9.0 * (3.0 * t).sin());
        let expected = [u[0], arm_acceleration(crank, w, w_dot, q[0])];
        let (mut found, u_dot) = rates(&mut engine, t, &q, &u);
        found.extend(u_dot);
        assert!(off(&found, &expected) <= 1e-12, "{found:?} {expected:?}");
        let speeds = engine.speeds(&q, &u).expect("lengths fit");
        assert!(off(&speeds, &[w, u[0]]) <= 1e-14, "{speeds:?}");
    }
}

/// Kinetic and potential energy at (t, x), x = [q, u].
fn energy(engine: &mut Interpreted<f64>, t: f64, q: &[f64], u: &[f64]) -> f64 {
    engine.set_time(t);
    let (kinetic, potential) = engine.energy(q, u).expect("lengths fit");
    kinetic + potential
}

/// The drive's power against the rate of the energy along the motion, by central differences of order 4.
fn check_power(text: &str, q: [f64; 2], n_q: usize) {
    let mut engine = Interpreted::<f64>::new(&derived(text));
    let (t, q, u) = (0.7, &q[..n_q], [1.3]);
    let (q_dot, u_dot) = rates(&mut engine, t, q, &u);
    let mut along = |h: f64| {
        let moved =
            |x: &[f64], x_dot: &[f64]| -> Vec<f64> { x.iter().zip(x_dot).map(|(x, v)| x + h * v).collect() };
        energy(&mut engine, t + h, &moved(q, &q_dot), &moved(&u, &u_dot))
    };
    let h = 2e-4;
    let slope = (8.0 * (along(h) - along(-h)) - (along(2.0 * h) - along(-2.0 * h))) / (12.0 * h);
    let power = engine.drive(t, q, &u, &[]).expect("lengths fit");
    assert!(1.0 < power.abs() && off(&[power], &[slope]) < 1e-8, "{power} {slope}");
}

#[test]
fn the_power_of_the_drive_is_the_rate_of_the_energy() {
    let constraint = ARM.replace("CRANK", "crank = { unit = \"rad\", speed = { independent = false } }")
        + "[constraints.motion]\ndrive = \"u_crank - w*(1 + sin(3_rad/1_s*t))\"\n";
    check_power(&constraint, [0.4, 1.1], 2);
    let function =
        ARM.replace("CRANK", "crank = { unit = \"rad\", closed_form = \"w*t + sin(3_rad/1_s*t)\" }");
    check_power(&function, [1.1, 0.0], 1);
}
