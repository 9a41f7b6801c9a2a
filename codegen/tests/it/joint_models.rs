//! Models that are made of joints, against closed forms of the textbooks.

use crate::models::shipped;
use crate::reactions::cross;
use smartbed_codegen::{Interpreted, ParameterChoice, Program, program};
use smartbed_runtime::mechanism::Mechanism;
use smartbed_runtime::ode::{Driven, State, rk4};
use smartbed_runtime::real::Scalar;

fn derived(name: &str) -> Program {
    program::derive(&shipped(name), &ParameterChoice::default()).unwrap_or_else(|e| panic!("{e}"))
}

type V = [f64; 3];

fn norm(v: V) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// The columns of the rotation of Euler parameters: the body's axes in N.
fn axes([a, b, c, d]: [f64; 4]) -> [V; 3] {
    let x = [a * a + b * b - c * c - d * d, 2.0 * (b * c + a * d), 2.0 * (b * d - a * c)];
    let y = [2.0 * (b * c - a * d), a * a - b * b + c * c - d * d, 2.0 * (c * d + a * b)];
    [x, y, cross(x, y)]
}

/// A state by names; missing names are 0, the first Euler parameter 1.
fn state(program: &Program, named: &[(&str, f64)]) -> (Vec<f64>, Vec<f64>) {
    let known = |name: &str| program.q.iter().chain(&program.u).any(|s| s.name == name);
    assert!(named.iter().all(|(name, _)| known(name)), "{named:?}");
    let value = |name: &str, other: f64| named.iter().find(|(n, _)| *n == name).map_or(other, |(_, x)| *x);
    let first = |name: &str| f64::from(u8::from(name.ends_with("_e0")));
    (
        program.q.iter().map(|q| value(&q.name, first(&q.name))).collect(),
        program.u.iter().map(|u| value(&u.name, 0.0)).collect(),
    )
}

/// The value of a coordinate or speed in x = (q, u).
fn of(program: &Program, x: &[f64], name: &str) -> f64 {
    x[program.q.iter().chain(&program.u).position(|s| s.name == name).unwrap_or_else(|| panic!("no {name}"))]
}

/// The state after some steps of Kutta's method as the runtime takes them; none is refused.
fn moved<S: Scalar>(program: &Program, (q, u): &(Vec<f64>, Vec<f64>), h: f64, steps: usize) -> Vec<f64> {
    let mut x: Vec<S> = q.iter().chain(u).map(|&x| S::from_f64(x)).collect();
    let (mut low, mut scratch) = (vec![S::ZERO; x.len()], vec![S::ZERO; 8 * x.len()]);
    let mut inputs = vec![S::ZERO; program.inputs.len()];
    let law = |_: S, _: &[S], _: &[S], inputs: &mut [S]| inputs.fill(S::ZERO);
    let mut driven = Driven::new(Interpreted::<S>::new(program), law, &mut inputs).expect("inputs");
    let mut state = State::new(&mut x, &mut low).expect("one length");
    for step in 0..steps {
        let t = S::from_f64(step as f64 * h);
        let taken = rk4(&mut driven, t, S::from_f64(h), &mut state, &mut scratch);
        assert!(taken.is_ok(), "step {step}: {taken:?} at {:?}", state.x());
    }
    state.x().iter().zip(state.low()).map(|(x, low)| x.to_f64() + low.to_f64()).collect()
}

/// Steady precession of a heavy top: (Ia w3 - J W cos th) W = m g h, the axis goes round at W and keeps its lean.
#[test]
fn a_spinning_top_precesses_as_the_closed_form_says() {
    let program = derived("spinning_top");
    let (m, r, h, g, w3, lean) = (0.1_f64, 0.04_f64, 0.03, 9.81, 200.0, std::f64::consts::FRAC_PI_6);
    let (along, across) = (m * r * r / 2.0, m * r * r / 4.0 + m * h * h);
    for fast in [false, true] {
        // J cos(th) W^2 - Ia w3 W + m g h = 0
        let root = ((along * w3).powi(2) - 4.0 * across * lean.cos() * m * g * h).sqrt();
        let sum = along * w3 + root;
        let turning = if fast { sum / (2.0 * across * lean.cos()) } else { 2.0 * m * g * h / sum };
        let start = [
            ("tip_e0", (lean / 2.0).cos()),
            ("tip_e1", (lean / 2.0).sin()),
            ("tip_wy", turning * lean.sin()),
            ("tip_wz", w3),
        ];
        let (step, steps) = (2e-5, 25_000);
        let x = moved::<f64>(&program, &state(&program, &start), step, steps);
        let axis = axes(["tip_e0", "tip_e1", "tip_e2", "tip_e3"].map(|e| of(&program, &x, e)))[2];
        let angle = turning * step * steps as f64;
        let expected = [lean.sin() * angle.sin(), -lean.sin() * angle.cos(), lean.cos()];
        let off = norm(std::array::from_fn(|i| axis[i] - expected[i]));
        println!("precession at {turning:.2} rad/s, axis off by {off:.1e} after {angle:.1} rad");
        assert!(off <= 1e-9, "{axis:?} against {expected:?}");
    }
    // The model's own start is the slow one.
    let model = shipped("spinning_top");
    let start: Vec<f64> = model.start.iter().map(|(_, x)| *x).collect();
    let slow = 2.0 * m * g * h
        / (along * w3 + ((along * w3).powi(2) - 4.0 * across * lean.cos() * m * g * h).sqrt());
    assert!((start[2] - slow * lean.sin()).abs() <= 1e-14 * slow, "{start:?}");
}

/// A gyrostat: I w' + w x (I w + h) + h' = 0 about the mass centre of all, Ia (w_i' + s_i') = T_i for each wheel.
#[test]
fn a_satellite_is_a_gyrostat() {
    let program = derived("satellite");
    let (body, wheel, r, d) = (20.0, 0.8, 0.06_f64, 0.1);
    let edges = [0.5_f64, 0.4, 0.3].map(|x| x * x);
    let (along, across) = (wheel * r * r / 2.0, wheel * r * r / 4.0);
    // The mass centre lies at (c, c, c) from the body's middle.
    let total = body + 3.0 * wheel;
    let c = wheel * d / total;
    let mut inertia = [[0.0; 3]; 3];
    let mut add = |moments: V, mass: f64, at: V| {
        for i in 0..3 {
            for j in 0..3 {
                let square: f64 = at.iter().map(|x| x * x).sum();
                let diagonal = f64::from(u8::from(i == j));
                inertia[i][j] += diagonal * (moments[i] + mass * square) - mass * at[i] * at[j];
            }
        }
    };
    let sums = [edges[1] + edges[2], edges[0] + edges[2], edges[0] + edges[1]];
    add(sums.map(|x| body * x / 12.0), body, [-c; 3]);
    for n in 0..3 {
        let pick = |there: f64, other: f64| std::array::from_fn(|i| if i == n { there } else { other });
        add(pick(along, across), wheel, pick(d - c, -c));
    }
    let times = |m: &[V; 3], v: V| m.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2]);
    let mut mechanism = Interpreted::<f64>::new(&program);
    for (w, s, torque) in [
        ([0.3, -0.2, 0.5], [100.0, -40.0, 20.0], [0.01, 0.02, -0.03]),
        ([-2.0, 1.0, 0.7], [0.0, 300.0, -10.0], [0.0; 3]),
    ] {
        let named = [
            ("orbit_wx", w[0]),
            ("orbit_wy", w[1]),
            ("orbit_wz", w[2]),
            ("u_spin_x", s[0]),
            ("u_spin_y", s[1]),
            ("u_spin_z", s[2]),
            ("orbit_e0", 0.5),
            ("orbit_e1", -0.5),
            ("orbit_e2", 0.5),
            ("orbit_e3", 0.5),
            ("u_orbit_x", 0.4),
        ];
        let (q, u) = state(&program, &named);
        let (mut q_dot, mut u_dot) = (vec![0.0; q.len()], vec![0.0; u.len()]);
        mechanism.rates(0.0, &q, &u, &torque, &mut q_dot, &mut u_dot).expect("lengths fit");
        let x = [q_dot, u_dot].concat();
        let found = ["orbit_wx", "orbit_wy", "orbit_wz"].map(|name| of(&program, &x, name));
        let wheels = ["u_spin_x", "u_spin_y", "u_spin_z"].map(|name| of(&program, &x, name));
        let momentum = times(&inertia, w);
        let spun: V = std::array::from_fn(|i| momentum[i] + along * s[i]);
        let turned = cross(w, spun);
        let left = times(&inertia, found);
        for i in 0..3 {
            let balance = left[i] + turned[i] + along * wheels[i];
            assert!(balance.abs() <= 1e-13, "moments about axis {i} leave {balance:e}");
            let motor = along * (found[i] + wheels[i]) - torque[i];
            assert!(motor.abs() <= 1e-14, "wheel {i} leaves {motor:e}");
        }
    }
}

/// A free body for a million steps at h w = 0.002 and from any attitude: its angular momentum in N stays.
#[test]
fn a_free_body_keeps_its_angular_momentum_for_a_million_steps() {
    let program = derived("free_body");
    let moments = [1.0, 2.0, 3.0];
    let momentum = |x: &[f64]| -> V {
        let axes = axes(["e0", "e1", "e2", "e3"].map(|e| of(&program, x, e)));
        let w = ["w1", "w2", "w3"].map(|w| of(&program, x, w));
        std::array::from_fn(|i| (0..3).map(|j| axes[j][i] * moments[j] * w[j]).sum())
    };
    let w = [0.6, 0.64, 0.48];
    for (e, steps) in
        [([1.0, 0.0, 0.0, 0.0], 1_000_000), ([0.0, 0.0, 1.0, 0.0], 100_000), ([0.5; 4], 100_000)]
    {
        let named = [
            ("e0", e[0]),
            ("e1", e[1]),
            ("e2", e[2]),
            ("e3", e[3]),
            ("w1", w[0]),
            ("w2", w[1]),
            ("w3", w[2]),
        ];
        let start = state(&program, &named);
        let before = momentum(&[start.0.as_slice(), &start.1].concat());
        let off = |x: &[f64]| {
            let after = momentum(x);
            norm(std::array::from_fn(|i| after[i] - before[i])) / norm(before)
        };
        let double = off(&moved::<f64>(&program, &start, 0.002 / norm(w), steps));
        let single = off(&moved::<f32>(&program, &start, 0.002 / norm(w), steps));
        println!("angular momentum after {steps} steps from {e:?}: f64 {double:.1e}, f32 {single:.1e}");
        assert!(double <= 1e-12 && single <= 1e-4, "f64 {double:e}, f32 {single:e}");
    }
}

/// Accelerations of the independent speeds at places of the independent coordinates; the others are assembled.
fn parallel(name: &str, named: &[(&str, f64)], inputs: &[f64], q_of: &[(&str, f64)]) -> Vec<f64> {
    let model = shipped(name);
    let program = derived(name);
    let (mut q, u) = state(&program, named);
    for (value, coordinate) in q.iter_mut().zip(&program.q) {
        if !named.iter().any(|(n, _)| *n == coordinate.name) {
            *value = coordinate.value;
        }
    }
    let mut mechanism = Interpreted::<f64>::new(&program);
    for _ in 0..20 {
        mechanism.project(&mut q).expect("lengths fit");
    }
    assert!(mechanism.residual(&q).expect("lengths fit") < 1e-14, "{}: not assembled", model.name);
    for (coordinate, expected) in q_of {
        let found = of(&program, &q, coordinate);
        assert!((found - expected).abs() < 1e-13, "{coordinate}: {found} against {expected}");
    }
    let (mut q_dot, mut u_dot) = (vec![0.0; q.len()], vec![0.0; u.len()]);
    let pivot = mechanism.rates(0.0, &q, &u, inputs, &mut q_dot, &mut u_dot).expect("lengths fit");
    println!("{name}: {} operations, pivot {pivot:.2}", program.operations());
    u_dot
}

fn near(found: &[f64], expected: &[f64], what: &str) {
    let size = expected.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let worst = found.iter().zip(expected).fold(0.0_f64, |m, (x, y)| m.max((x - y).abs() / size));
    println!("{what}: {worst:.1e}");
    assert!(found.len() == expected.len() && worst <= 1e-12, "{what}: {worst:e}, {found:?}");
}

/// Against Lagrange's equations in the plate's place, 50 digits: `tests/reference/parallel_robots.py`.
#[test]
fn parallel_robots_move_as_lagrange_says() {
    let e = [
        0.984_340_669_520_627_1,
        0.100_442_925_461_288_48,
        -0.120_531_510_553_546_17,
        0.080_354_340_369_030_78,
    ];
    let stewart = [
        ("pose_x", 0.03),
        ("pose_y", -0.02),
        ("pose_z", 0.52),
        ("pose_e0", e[0]),
        ("pose_e1", e[1]),
        ("pose_e2", e[2]),
        ("pose_e3", e[3]),
        ("u_pose_x", 0.3),
        ("u_pose_y", -0.2),
        ("u_pose_z", 0.1),
        ("pose_wx", 0.4),
        ("pose_wy", -0.5),
        ("pose_wz", 0.7),
    ];
    let found = parallel("stewart", &stewart, &[20.0, -5.0, 12.0, 30.0, 8.0, 15.0], &[]);
    let expected = [
        1.385_209_260_888_721,
        -2.482_164_385_877_112_7,
        -1.283_494_526_648_985_2,
        -21.363_021_914_977_35,
        23.124_521_680_179_434,
        8.167_701_990_649_132,
    ];
    near(&found, &expected, "stewart");
    let delta = [("x", 0.05), ("y", -0.03), ("z", -0.41), ("u_x", 0.4), ("u_y", 0.3), ("u_z", -0.2)];
    let arms =
        [("q1", 0.381_359_246_108_728_4), ("q2", 0.702_998_764_610_594_6), ("q3", 0.543_411_428_533_564_3)];
    let found = parallel("delta", &delta, &[-1.2, 0.5, -0.3], &arms);
    near(&found, &[5.507_964_808_267_872, -2.571_883_997_532_316, -5.895_222_394_286_379], "delta");
}
