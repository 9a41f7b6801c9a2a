//! Distances and speeds of points that meet or stand, in f32 and f64, against components.

use crate::models::derived_from;
use smartbed_codegen::Interpreted;
use smartbed_runtime::mechanism::Mechanism;
use smartbed_runtime::real::Scalar;

/// Two arms of one length about one axis, with a spring between their ends; its rest length is `rest`.
fn arms(rest: f64) -> String {
    format!(
        r#"format = 1
name = "arms"
[coordinates]
a = {{ unit = "rad" }}
b = {{ unit = "rad" }}
[frames]
A = {{ rotations = [["z", "a"]] }}
B = {{ rotations = [["z", "b"]] }}
[points]
P = "0.7312_m*A.x"
Q = "0.7312_m*B.x"
[bodies]
p = {{ centre = "P", mass = "1_kg" }}
q = {{ centre = "Q", mass = "1_kg" }}
[springs]
s = {{ between = ["P", "Q"], stiffness = "100_N/1_m", rest_length = "{rest}_m" }}
[outputs]
distance = "norm(P - Q)"
speed = "norm(velocity(P) - velocity(Q))"
"#
    )
}

/// Distance, relative speed and acceleration of the first arm, with the arms `apart` (rad) and both at 3 rad/s.
fn met<S: Scalar>(text: &str, a: f64, apart: f64) -> [f64; 3] {
    let mut engine = Interpreted::<S>::new(&derived_from(text));
    let q = [a, a + apart].map(S::from_f64);
    let u = [S::from_f64(3.0); 2];
    let outputs = engine.outputs(S::ZERO, &q, &u, &[]).expect("lengths fit");
    let (mut q_dot, mut u_dot) = ([S::ZERO; 2], [S::ZERO; 2]);
    engine.rates(S::ZERO, &q, &u, &[], &mut q_dot, &mut u_dot).expect("lengths fit");
    [outputs[0].to_f64(), outputs[1].to_f64(), u_dot[0].to_f64()]
}

#[test]
fn points_that_meet_are_as_far_apart_as_their_components() {
    let text = arms(1e-4);
    // Rounding of angles near 3 rad and of components, in rounding units of the arm's length.
    for (far, bound) in [(met::<f64> as fn(&str, f64, f64) -> _, 4e-16), (met::<f32>, 2e-7)] {
        for a in [0.1, 0.9, 1.7, 2.9] {
            for apart in [1e-2, 1e-3, 2e-4] {
                let [distance, speed, acceleration] = far(&text, a, apart);
                let expected = 2.0 * 0.7312 * (apart / 2.0_f64).sin();
                assert!((distance - expected).abs() < 2.0 * bound, "{a} {apart}: {distance} not {expected}");
                assert!((speed - 3.0 * expected).abs() < 8.0 * bound, "{a} {apart}: {speed}");
                // k (d - d0) cos(apart/2) on 1 kg at the end of the arm.
                let exact = 100.0 * (expected - 1e-4) * (apart / 2.0_f64).cos() / 0.7312;
                assert!(
                    (acceleration - exact).abs() < 1e3 * bound,
                    "{a} {apart}: {acceleration} not {exact}"
                );
            }
            let [distance, speed, _] = far(&text, a, 0.0);
            assert!(distance <= bound && speed <= 4.0 * bound, "{a}: {distance} m, {speed} m/s");
        }
    }
}
