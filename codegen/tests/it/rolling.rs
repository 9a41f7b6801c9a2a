//! Motion constraints and stated velocities against the closed form of Chaplygin's sleigh.
//!
//! A knife edge keeps the contact from slipping sideways; the mass centre lies a ahead of it. With
//! the forward speed v and the turning rate w: v' = a w^2, w' = -m a v w / (I + m a^2).

use smartbed_codegen::{Interpreted, ParameterChoice, model, program};
use smartbed_runtime::mechanism::Mechanism;

const BODY: &str = r#"
format = 1
name = "sleigh"
dof = 2
[parameters]
m = { value = 2.0, unit = "kg" }
a = { value = 0.3, unit = "m" }
I = { value = 0.5, unit = "kg m^2" }
[frames]
sleigh = { parent = "N", rotations = [["z", "psi"]] }
[bodies]
sleigh = { centre = "centre", mass = "m", frame = "sleigh", inertia = { Izz = "I" } }
"#;
/// The path's length and the heading are coordinates; the contact's velocity is stated.
const STATED: &str = r#"
[coordinates]
s = { unit = "m", speed = "v", independent = true }
psi = { unit = "rad", speed = "w", independent = true }
[points]
contact = { position = "O", velocity = "v*sleigh.x" }
centre = "contact + a*sleigh.x"
"#;
/// The contact has coordinates, and a motion constraint.
const CONSTRAINED: &str = r#"
[coordinates]
x = { unit = "m", independent = true, range = [-1, 1] }
y = { unit = "m", independent = false, range = [-1, 1] }
psi = { unit = "rad", independent = true, range = [-1, 1] }
[points]
contact = "x*N.x + y*N.y"
centre = "contact + a*sleigh.x"
[constraints.motion]
edge = "dot(velocity(contact), sleigh.y)"
"#;
const M: f64 = 2.0;
const A: f64 = 0.3;
const I: f64 = 0.5;

/// q' and u' of the sleigh described by `text`.
fn rates<const Q: usize>(text: &str, q: [f64; Q], u: [f64; 2]) -> ([f64; Q], [f64; 2]) {
    let model =
        model::parse("sleigh.toml", &format!("{BODY}{text}")).unwrap_or_else(|found| panic!("{found}"));
    let program =
        program::derive(&model, &ParameterChoice::default()).unwrap_or_else(|found| panic!("{found}"));
    let mut sleigh = Interpreted::<f64>::new(&program);
    let (mut q_dot, mut u_dot) = ([0.0; Q], [0.0; 2]);
    sleigh.rates(0.0, &q, &u, &[], &mut q_dot, &mut u_dot).expect("lengths fit");
    (q_dot, u_dot)
}

fn assert_near(actual: f64, expected: f64) {
    assert!((actual - expected).abs() <= 1e-14 * expected.abs().max(1.0), "{actual} against {expected}");
}

#[test]
fn stated_velocity_gives_chaplygins_sleigh() {
    let (v, w) = (1.5, -0.8);
    let (_, [v_dot, w_dot]) = rates(STATED, [0.2, 0.7], [v, w]);
    assert_near(v_dot, A * w * w);
    assert_near(w_dot, -M * A * v * w / (I + M * A * A));
}

#[test]
fn motion_constraint_gives_the_same_sleigh() {
    let (v, w, psi) = (1.5, -0.8, 0.7_f64);
    let (q_dot, [x_dot_dot, w_dot]) = rates(CONSTRAINED, [0.1, 0.2, psi], [v * psi.cos(), w]);
    assert_near(q_dot[1], v * psi.sin());
    assert_near(x_dot_dot, A * w * w * psi.cos() - v * w * psi.sin());
    assert_near(w_dot, -M * A * v * w / (I + M * A * A));
}

#[test]
fn a_velocity_beside_closures_is_refused() {
    let text = STATED.replace("velocity = ", "closures = [\"O\"], velocity = ");
    let message = match model::parse("sleigh.toml", &format!("{BODY}{text}")) {
        Err(found) => found.to_string(),
        Ok(_) => String::new(),
    };
    assert!(message.contains("closures and a velocity"), "{message}");
}
