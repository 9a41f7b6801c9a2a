//! Mass centres and places of loads that are written as means of the joint's point and points of the link: "(A + E)/2".
//! They move with the link, and so the joint transmits the same as where they are reached from the joint alone.

use crate::answers::{Asking, close};
use crate::reactions::Vector;
use smartbed_codegen::model::{self, Model};

/// Two links in the plane. A mass at A on the first; the second has its mass in the middle between A and its end E.
fn two_links(middle: &str, first: &str) -> Model {
    let text = format!(
        r#"format = 1
name = "m"
gravity = "-9.81_N/1_kg*N.y"
[parameters]
half = {{ value = 0.5, unit = "1" }}
[inputs]
f = {{ unit = "N" }}
[coordinates]
q1 = {{ unit = "rad", independent = true }}
q2 = {{ unit = "rad", independent = true }}
[frames]
a = {{ rotations = [["z", "q1"]] }}
b = {{ rotations = [["z", "q2"]] }}
[definitions]
end = "A + 0.4_m*b.x"
[points]
A = "0.2_m*a.x"
E = "A + 0.4_m*b.x"
middle = "{middle}"
first = "{first}"
[bodies]
m1 = {{ centre = "A", mass = 1 }}
m2 = {{ centre = "middle", frame = "b", mass = 2, inertia = {{ Izz = 0.02 }} }}
m3 = {{ centre = "first", frame = "a", mass = 0.5, inertia = {{ Izz = 0.01 }} }}
[forces]
pull = {{ point = "middle", force = "f*N.x" }}
push = {{ point = "first", force = "3*f*N.y" }}
"#
    );
    model::parse("model.toml", &text).unwrap_or_else(|found| panic!("{found}"))
}

#[test]
fn a_mean_of_the_joint_and_its_link_goes_with_the_link() {
    let cuts = ["reaction:b@A", "reaction:a@O"];
    let mut plain = Asking::of(&two_links("A + 0.2_m*b.x", "0.1_m*a.x"), &cuts);
    let state = plain.state.clone();
    let expected = cuts.map(|cut| plain.part(&state, cut, "reaction"));
    for (middle, first) in [
        ("(A + E)/2", "A/2"),
        ("A + (E - A)/2", "A - A/2"),
        ("(A + end)/2", "half*A"),
        ("E - half*(E - A)", "O + half*A"),
        ("half*A + (1 - half)*E", "(O + A)/2"),
        ("A/2 + (A + 0.4_m*b.x)/2", "A/2 + 0.1_m*a.x/2 - A/4"),
    ] {
        let mut other = Asking::of(&two_links(middle, first), &cuts);
        for (cut, expected) in cuts.iter().zip(&expected) {
            close(&other.part(&state, cut, "reaction"), expected, 1e-12, &format!("{cut} {middle} {first}"));
        }
    }
}

/// Without the first link's own mass and the loads, by Newton's law of the second link's mass, whose acceleration
/// follows from the angular accelerations.
#[test]
fn the_second_link_is_carried_by_its_joint() {
    let mut links = Asking::of(&two_links("(A + E)/2", "A/2"), &["reaction:b@A"]);
    let mut state = links.state.clone();
    state.inputs.fill(0.0);
    let reaction = links.part(&state, "reaction:b@A", "reaction");
    let rates = links.rates(&state).1;
    let ([q1, q2], [u1, u2]) = ([state.q[0], state.q[1]], [state.u[0], state.u[1]]);
    let arm = |length: f64, q: f64, u: f64, alpha: f64| -> Vector {
        let (s, c) = q.sin_cos();
        [length * (-s * alpha - c * u * u), length * (c * alpha - s * u * u), 0.0]
    };
    let (first, second) = (arm(0.2, q1, u1, rates[0]), arm(0.2, q2, u2, rates[1]));
    let force = [2.0 * (first[0] + second[0]), 2.0 * (first[1] + second[1] + 9.81)];
    let (s, c) = q2.sin_cos();
    close(
        &reaction[..2],
        &[c * force[0] + s * force[1], c * force[1] - s * force[0]],
        1e-12,
        "force on the link",
    );
}
