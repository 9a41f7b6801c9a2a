//! Momentum of mechanisms: rates of linear and angular momentum equal external force and moment, from joint reactions.

use crate::answers::{Asking, State, close};

/// Speeds change by some 30 1/s in a second.
const STEP: f64 = 1e-4;

/// The rate of a part along the motion, by central differences of fourth order; of mechanisms without constraints.
fn rate(asking: &mut Asking, part: &str) -> Vec<f64> {
    let state = asking.state.clone();
    let (q_dot, u_dot) = asking.rates(&state);
    let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|steps| {
        let moved = |from: &[f64], rates: &[f64]| -> Vec<f64> {
            from.iter().zip(rates).map(|(x, rate)| x + steps * STEP * rate).collect()
        };
        let there = State { q: moved(&state.q, &q_dot), u: moved(&state.u, &u_dot), ..state.clone() };
        asking.part(&there, "momentum", part)
    });
    (0..a.len()).map(|i| (a[i] - 8.0 * b[i] + 8.0 * c[i] - d[i]) / (12.0 * STEP)).collect()
}

fn cross(a: &[f64], b: &[f64]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// c' = p/m, p' = F + m g, H' = M + r x F + c x m g, with F and M of the bearing at the base, which is cut; no motor
/// works.
#[test]
fn the_rate_of_momentum_is_what_the_bearing_and_gravity_do() {
    let (reaction, pose) = ("reaction:link0@J0", "pose:link0@J0");
    let mut asking = Asking::new("arm6", &["momentum", reaction, pose]);
    asking.state.inputs.fill(0.0);
    let state = asking.state.clone();
    let [mass] = asking.part(&state, "momentum", "mass")[..] else { panic!("one mass") };
    let [centre, momentum] = ["centre", "momentum"].map(|part| asking.part(&state, "momentum", part));
    let speed: Vec<f64> = momentum.iter().map(|p| p / mass).collect();
    close(&rate(&mut asking, "centre"), &speed, 1e-8, "c'");
    let [axes, place] = ["rotation", "position"].map(|part| asking.part(&state, pose, part));
    let found = asking.part(&state, reaction, "reaction");
    let along_n = |v: &[f64]| -> Vec<f64> {
        axes.chunks(3).map(|row| row.iter().zip(v).map(|(r, x)| r * x).sum()).collect()
    };
    let (force, moment) = (along_n(&found[..3]), along_n(&found[3..]));
    let weight = [0.0, 0.0, -9.81 * mass];
    let outside: Vec<f64> = (0..3).map(|i| force[i] + weight[i]).collect();
    close(&rate(&mut asking, "momentum"), &outside, 1e-8, "p'");
    let (of_force, of_weight) = (cross(&place, &force), cross(&centre, &weight));
    let about: Vec<f64> = (0..3).map(|i| moment[i] + of_force[i] + of_weight[i]).collect();
    close(&rate(&mut asking, "moment_of_momentum"), &about, 1e-8, "H'");
}

/// A free body in Euler parameters: T = (p . v + H_c . w)/2 with the numbers of the model.
#[test]
fn the_energy_of_a_free_body_is_half_of_momentum_times_speed() {
    let mut asking = Asking::new("free_body", &["momentum", "energy", "twist:body@C"]);
    let state = asking.state.clone();
    let kinetic = asking.part(&state, "energy", "kinetic")[0];
    let twist = asking.part(&state, "twist:body@C", "twist");
    let [centre, momentum, moment] =
        ["centre", "momentum", "moment_of_momentum"].map(|part| asking.part(&state, "momentum", part));
    let of_centre = cross(&centre, &momentum);
    let half: f64 =
        (0..3).map(|i| 0.5 * (momentum[i] * twist[i] + (moment[i] - of_centre[i]) * twist[3 + i])).sum();
    close(&[half], &[kinetic], 1e-13, "free_body");
}
