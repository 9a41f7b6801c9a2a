//! Euler parameters as independent coordinates beside other constraints: sampled configurations, dead points,
//! linearisation at any attitude.
//!
//! Oracles: Newton-Euler equations with a multiplier, solved here as a dense system; the same mechanism with hinges in
//! place of the ball joint; differences along the sphere of unit parameters.

use crate::answers::{Asking, State as At, close};
use crate::draw::Draw;
use crate::linearisation::difference;
use crate::models::{derived_from, shipped};
use crate::reactions::cross;
use smartbed_codegen::kinematics::linear;
use smartbed_codegen::{Interpreted, ParameterChoice, Program, model, program};
use smartbed_runtime::mechanism::Mechanism;
use smartbed_runtime::ode::{Driven, State, rk4};

/// A body on a ball joint, tied to a slider by a rod: where the rod is across the slide, its speed does not follow.
const TIED: &str = r#"
format = 1
name = "tied"
dof = 3
gravity = "-g*N.z"

[parameters]
g = { value = 9.81, unit = "m/s^2" }
l = { value = 0.6, unit = "m" }

[joints]
ball = { kind = "spherical", child = "A", independent = true }
pr = { kind = "prismatic", axis = "y", child = "C", at = "0.3_m*N.x", nominal = 0.7, range = [-2, 2] }

[points]
E = "A + 0.5_m*A.x"

[constraints.configuration]
rod = "dot(E - C, E - C) - l*l"

[bodies]
A = { centre = "E", frame = "A", mass = 1, inertia = { Ixx = 0.02, Iyy = 0.03, Izz = 0.04 } }
C = { centre = "C", mass = 0.7 }
"#;

/// Two bodies on ball joints, one after the other, tied to a slider.
const TWO: &str = r#"
format = 1
name = "two"
dof = 6
gravity = "-g*N.z"

[parameters]
g = { value = 9.81, unit = "m/s^2" }
l = { value = 0.9, unit = "m" }

[joints]
s1 = { kind = "spherical", child = "A", independent = true }
f2 = { kind = "spherical", parent = "A", child = "B", at = "A + 0.5_m*A.x", independent = true }
pr = { kind = "prismatic", axis = [0, 1, 1], child = "C", at = "0.3_m*N.x", nominal = 0.7, stiffness = 5, rest = 0.2, damping = 0.5 }

[points]
E = "B + 0.4_m*B.x + 0.1_m*B.z"
CA = "A + 0.2_m*A.x + 0.05_m*A.y"
CB = "B + 0.2_m*B.x - 0.05_m*B.z"

[constraints.configuration]
rod = "dot(E - C, E - C) - l*l"

[bodies]
A = { centre = "CA", frame = "A", mass = 1, inertia = { Ixx = 0.02, Iyy = 0.03, Izz = 0.04, Ixy = 0.005 } }
B = { centre = "CB", frame = "B", mass = 2, inertia = { Ixx = 0.02, Iyy = 0.04, Izz = 0.03, Iyz = -0.003 } }
C = { centre = "C", mass = 0.7 }

[inputs]
T = { unit = "N m" }

[torques]
t = { frame = "B", torque = "T*A.y", reaction = "A" }
"#;

/// A ball joint on a cart that a constraint moves.
const CARRIED: &str = r#"
format = 1
name = "carried"
dof = 4
gravity = "-g*N.z"

[parameters]
g = { value = 9.81, unit = "m/s^2" }
c = { value = 0.3, unit = "N m s" }

[joints]
sl = { kind = "prismatic", axis = [0.6, 0, 0.8], child = "cart", turned = [["z", "30*deg"]] }
bj = { kind = "spherical", independent = true, parent = "cart", child = "ball", at = "cart + 0.2_m*cart.y" }
hi = { kind = "revolute", independent = true, axis = [1, 2, -2], parent = "ball", child = "arm", at = "ball + 0.3_m*ball.x - 0.1_m*ball.z", stiffness = 3, rest = 0.4, damping = 0.2 }

[points]
C = "ball - 0.15_m*ball.z"
D = "arm + 0.25_m*arm.y"

[bodies]
cart = { centre = "cart", mass = 2 }
ball = { centre = "C", frame = "ball", mass = 1.3, inertia = { Ixx = 0.11, Iyy = 0.15, Izz = 0.09, Ixy = 0.012, Ixz = -0.007, Iyz = 0.02 } }
arm = { centre = "D", frame = "arm", mass = 0.7, inertia = { Ixx = 0.01, Iyy = 0.002, Izz = 0.011 } }

[torques]
drag = { frame = "ball", torque = "-c*angular_velocity(ball)" }

[outputs]
height = "dot(D, N.z)"

[constraints.configuration]
command = "sl - 0.1_m*dot(ball.x, N.y)"
"#;

/// Two ball joints, of which constraints make the second dependent.
const LEVEL: &str = r#"
format = 1
name = "level"
dof = 3
gravity = "-g*N.z"

[parameters]
g = { value = 9.81, unit = "m/s^2" }

[joints]
s1 = { kind = "spherical", child = "A", independent = true }
s2 = { kind = "spherical", parent = "A", child = "B", at = "A + 0.5_m*A.x" }

[points]
E = "B + 0.4_m*B.x"
CA = "A + 0.2_m*A.x"

[constraints.configuration]
level = "dot(B.x, N.z)"
straight = "dot(B.y, N.z)"
head = "dot(B.x, N.y)"

[bodies]
A = { centre = "CA", frame = "A", mass = 1, inertia = { Ixx = 0.02, Iyy = 0.03, Izz = 0.04, Ixy = 0.005 } }
B = { centre = "E", frame = "B", mass = 2, inertia = { Ixx = 0.02, Iyy = 0.04, Izz = 0.03, Iyz = -0.003 } }
"#;

/// Euler parameters, uniform in attitude.
fn attitude(draw: &mut Draw) -> [f64; 4] {
    loop {
        let e: [f64; 4] = draw.list(1.0);
        let length = e.iter().map(|x| x * x).sum::<f64>().sqrt();
        if (0.1..1.0).contains(&length) {
            return e.map(|x| x / length);
        }
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The components along N's axes of a vector given along the body's, R v; `inverse` for R' v.
fn turned(e: [f64; 4], v: [f64; 3], inverse: bool) -> [f64; 3] {
    let own = if inverse { [-e[1], -e[2], -e[3]] } else { [e[1], e[2], e[3]] };
    let once = cross(own, v);
    let twice = cross(own, once);
    std::array::from_fn(|i| v[i] + 2.0 * (e[0] * once[i] + twice[i]))
}

/// The tied body: e, w along its axes, place and speed of the slider.
#[derive(Clone, Copy)]
struct Tied {
    e: [f64; 4],
    w: [f64; 3],
    place: f64,
    speed: f64,
}

/// From the joint to the mass centre, where the rod is fastened, along the body's axes.
const ARM: [f64; 3] = [0.5, 0.0, 0.0];
const AXIS: [f64; 3] = [0.0, 1.0, 0.0];
const ROD: f64 = 0.6;

impl Tied {
    /// From the slider to the end of the body, along N's axes.
    fn rod(&self) -> [f64; 3] {
        let end = turned(self.e, ARM, false);
        [end[0] - 0.3, end[1] - self.place, end[2]]
    }

    /// Row of the rod's constraint, divided by 2: coefficients of w and of the slider's speed.
    fn row(&self) -> [f64; 4] {
        let rod = turned(self.e, self.rod(), true);
        let moment = cross(ARM, rod);
        [moment[0], moment[1], moment[2], -self.rod()[1]]
    }

    /// w' and the slider's acceleration: Euler's equation about the joint, Newton's along the slide, and the rod's
    /// constraint differentiated twice, with its multiplier as the fifth unknown.
    fn accelerations(&self) -> [f64; 4] {
        let inertia = [0.02, 0.03 + 0.25, 0.04 + 0.25];
        let momentum = std::array::from_fn(|i| inertia[i] * self.w[i]);
        let weight = cross(ARM, turned(self.e, [0.0, 0.0, -9.81], true));
        let gyroscopic = cross(self.w, momentum);
        let row = self.row();
        let mut matrix = vec![0.0; 25];
        for (i, mass) in inertia.into_iter().chain([0.7]).enumerate() {
            matrix[6 * i] = mass;
            (matrix[5 * i + 4], matrix[20 + i]) = (row[i], row[i]);
        }
        let velocity = turned(self.e, cross(self.w, ARM), false);
        let relative: [f64; 3] = std::array::from_fn(|i| velocity[i] - self.speed * AXIS[i]);
        let centripetal = turned(self.e, cross(self.w, cross(self.w, ARM)), false);
        let bias = dot(relative, relative) + dot(self.rod(), centripetal);
        let mut right: Vec<f64> = (0..3).map(|i| weight[i] - gyroscopic[i]).chain([0.0, -bias]).collect();
        let (found, rank) = linear::solve(&matrix, &mut right, 5);
        assert_eq!(rank, 5);
        [found[0], found[1], found[2], found[3]]
    }

    fn energy(&self) -> f64 {
        let w = self.w;
        0.5 * (0.02 * w[0] * w[0] + 0.28 * w[1] * w[1] + 0.29 * w[2] * w[2] + 0.7 * self.speed * self.speed)
            + 9.81 * turned(self.e, ARM, false)[2]
    }

    /// On the rod's constraint, velocities included. The end of the body is `across` away from where the rod is across
    /// the slide, a dead point; anywhere if `across` is 1.
    fn random(draw: &mut Draw, across: f64) -> Self {
        let mut e = attitude(draw);
        let mut end = turned(e, ARM, false);
        let away =
            if across < 1.0 { across } else { (ROD * ROD - (end[0] - 0.3).powi(2) - end[2] * end[2]).sqrt() };
        if across < 1.0 {
            // Turned about N.z until the end is as far from the slide as the rod allows: at most 0.3 beyond N.z.
            let reach = (0.25 - end[2] * end[2]).sqrt();
            let x = 0.3 - (ROD * ROD - end[2] * end[2] - across * across).sqrt();
            if x.abs() > reach {
                return Self::random(draw, across);
            }
            let angle = (x / reach).acos() - end[1].atan2(end[0]);
            let (sin, cos) = (0.5 * angle).sin_cos();
            let [e0, e1, e2, e3] = e;
            e = [cos * e0 - sin * e3, cos * e1 - sin * e2, cos * e2 + sin * e1, cos * e3 + sin * e0];
            end = turned(e, ARM, false);
        }
        if away.is_nan() {
            return Self::random(draw, across);
        }
        let mut found = Self { e, w: [0.0; 3], place: end[1] - away, speed: 0.0 };
        let (row, motion) = (found.row(), draw.list::<4>(1.0));
        let along: f64 = row.iter().zip(&motion).map(|(a, b)| a * b).sum();
        let square: f64 = row.iter().map(|a| a * a).sum();
        let [x, y, z, speed]: [f64; 4] = std::array::from_fn(|i| motion[i] - row[i] * along / square);
        (found.w, found.speed) = ([x, y, z], speed);
        found
    }

    /// One step of Kutta's method.
    fn step(&self, h: f64) -> Self {
        let rate = |x: &Self| {
            let [x1, x2, x3] = x.w;
            let [e0, e1, e2, e3] = x.e;
            let e_dot = [
                -0.5 * (e1 * x1 + e2 * x2 + e3 * x3),
                0.5 * (e0 * x1 + e2 * x3 - e3 * x2),
                0.5 * (e0 * x2 + e3 * x1 - e1 * x3),
                0.5 * (e0 * x3 + e1 * x2 - e2 * x1),
            ];
            let [a, b, c, d] = x.accelerations();
            Self { e: e_dot, w: [a, b, c], place: x.speed, speed: d }
        };
        let plus = |x: &Self, h: f64, k: &Self| Self {
            e: std::array::from_fn(|i| x.e[i] + h * k.e[i]),
            w: std::array::from_fn(|i| x.w[i] + h * k.w[i]),
            place: x.place + h * k.place,
            speed: x.speed + h * k.speed,
        };
        let k1 = rate(self);
        let k2 = rate(&plus(self, 0.5 * h, &k1));
        let k3 = rate(&plus(self, 0.5 * h, &k2));
        let k4 = rate(&plus(self, h, &k3));
        [(&k1, 1.0), (&k2, 2.0), (&k3, 2.0), (&k4, 1.0)]
            .iter()
            .fold(*self, |sum, (k, weight)| plus(&sum, weight * h / 6.0, k))
    }

    /// Values in the order of the program's names.
    fn named(&self, names: &[smartbed_codegen::program::Quantity]) -> Vec<f64> {
        let value = |name: &str| match name {
            "pr" => self.place,
            "u_pr" => self.speed,
            "ball_w0" => 0.0,
            _ => match name.strip_prefix("ball_e") {
                Some(i) => self.e[i.parse::<usize>().expect("an index")],
                None => self.w["xyz".find(&name["ball_w".len()..]).expect("an axis")],
            },
        };
        names.iter().map(|quantity| value(&quantity.name)).collect()
    }
}

#[test]
fn attitudes_are_sampled_all_round() {
    for (name, least) in
        [("spinning_top", 65), ("satellite", 65), ("free_body", 60), ("turntable", 60), ("stewart", 60)]
    {
        let program = program::derive(&shipped(name), &ParameterChoice::default());
        let samples = program.unwrap_or_else(|e| panic!("{e}")).n_samples;
        println!("{name}: {samples} samples");
        assert!(samples >= least, "{name}: {samples}");
    }
    for (text, least) in [(TIED, 65), (TWO, 60), (CARRIED, 65)] {
        let program = derived_from(text);
        println!("{}: {} samples", program.name, program.n_samples);
        assert!(program.n_samples >= least, "{}: {}", program.name, program.n_samples);
    }
}

#[test]
fn a_tied_body_on_a_ball_joint_moves_at_dead_points() {
    let program = derived_from(TIED);
    assert!(program.is_redundant());
    let mut mechanism = Interpreted::<f64>::new(&program);
    let mut draw = Draw(3);
    for state in 0..1000 {
        let tied = Tied::random(&mut draw, [1.0, 1.0, 1e-2, 1e-5, 1e-9, 0.0][state % 6]);
        let (q, u) = (tied.named(&program.q), tied.named(&program.u));
        let (mut q_dot, mut u_dot) = (vec![0.0; q.len()], vec![0.0; u.len()]);
        let pivot = mechanism.rates(0.0, &q, &u, &[], &mut q_dot, &mut u_dot).expect("lengths fit");
        let [a, b, c, d] = tied.accelerations();
        let expected = Tied { w: [a, b, c], speed: d, ..tied }.named(&program.u);
        close(&u_dot, &expected, 1e-11, &format!("state {state}"));
        assert!(pivot > 1e-3, "{pivot}");
    }
}

/// The state after 3 s of Kutta's method, and the largest change of the energy.
fn moved(program: &Program, start: &[f64], h: f64, torque: impl Fn(f64) -> f64) -> (Vec<f64>, f64) {
    let mut x = start.to_vec();
    let mut low = vec![0.0; x.len()];
    let mut scratch = vec![0.0; 8 * x.len()];
    let mut inputs = vec![0.0; program.inputs.len()];
    let law = |t: f64, _: &[f64], _: &[f64], inputs: &mut [f64]| inputs.fill(torque(t));
    let mut driven = Driven::new(Interpreted::new(program), law, &mut inputs).expect("inputs");
    let mut state = State::new(&mut x, &mut low).expect("one length");
    let n_q = program.q.len();
    let mut observer = Interpreted::<f64>::new(program);
    let mut energy = |x: &[f64]| {
        let (kinetic, potential) = observer.energy(&x[..n_q], &x[n_q..]).expect("lengths fit");
        kinetic + potential
    };
    let first = energy(state.x());
    let mut worst = 0.0_f64;
    for step in 0..(3.0 / h).round() as usize {
        let taken = rk4(&mut driven, step as f64 * h, h, &mut state, &mut scratch);
        assert!(taken.is_ok(), "step {step}: {taken:?} at {:?}", state.x());
        worst = worst.max((energy(state.x()) - first).abs());
    }
    (state.x().to_vec(), worst)
}

#[test]
fn a_run_of_a_tied_body_passes_dead_points() {
    let program = derived_from(TIED);
    let place = (ROD * ROD - 0.04_f64).sqrt();
    let mut exact = Tied { e: [1.0, 0.0, 0.0, 0.0], w: [1.0, 0.0, 3.0], place, speed: 0.0 };
    // The rod's constraint gives the slider's speed.
    let row = exact.row();
    exact.speed = -(row[0] * exact.w[0] + row[1] * exact.w[1] + row[2] * exact.w[2]) / row[3];
    let start = [exact.named(&program.q), exact.named(&program.u)].concat();
    let at_start = exact.energy();
    let mut passed = 0;
    for _ in 0..30_000 {
        let next = exact.step(1e-4);
        passed += usize::from(next.rod()[1] * exact.rod()[1] < 0.0);
        exact = next;
    }
    assert!((exact.energy() - at_start).abs() < 1e-8 && passed > 0, "{passed} dead points");
    assert!((exact.place - 0.914_281_36).abs() < 1e-7, "{}", exact.place);
    let slide = program.q.iter().position(|q| q.name == "pr").expect("the slider");
    let [(_, coarse), (end, fine)] = [2e-3, 1e-3].map(|h| moved(&program, &start, h, |_| 0.0));
    println!("{passed} dead points, energy {coarse:.1e} J, with half the step {fine:.1e} J");
    assert!(fine < 1e-8 && fine < 0.1 * coarse, "{coarse:e} {fine:e}");
    assert!((end[slide] - exact.place).abs() < 1e-5, "{} {}", end[slide], exact.place);
}

#[test]
fn a_tied_body_moves_on_hinges_as_on_a_ball_joint() {
    let hinges = "bz = { kind = \"universal\", axes = [\"z\", \"y\"], child = \"W\", independent = true }\n\
                  bx = { kind = \"revolute\", axis = \"x\", parent = \"W\", child = \"A\", at = \"W\", independent = true }";
    let ball = "ball = { kind = \"spherical\", child = \"A\", independent = true }";
    let programs = [derived_from(TIED), derived_from(&TIED.replace(ball, hinges))];
    let ends = programs.map(|program| {
        let place = |name: &str| match name {
            "pr" => (ROD * ROD - 0.04_f64).sqrt(),
            "ball_e0" => 1.0,
            _ => 0.0,
        };
        let q: Vec<f64> = program.q.iter().map(|q| place(&q.name)).collect();
        let rate = |name: &str| match name {
            "ball_wx" | "u_bx" => 1.0,
            "ball_wz" | "u_bz_first" => 3.0,
            // Along the rod: 3 rad/s of the end across it.
            "u_pr" => 1.5,
            _ => 0.0,
        };
        let u: Vec<f64> = program.u.iter().map(|u| rate(&u.name)).collect();
        let (end, _) = moved(&program, &[q, u].concat(), 5e-4, |_| 0.0);
        end[program.q.iter().position(|q| q.name == "pr").expect("the slider")]
    });
    assert!((ends[0] - ends[1]).abs() < 1e-6, "{ends:?}");
}

/// The end of the second body after 3 s, from equations with multipliers in all rates, derived and integrated by other
/// programs (CasADi, DOP853 at 1e-9).
#[test]
fn two_ball_joints_and_a_slider_move_through_half_turns() {
    let program = derived_from(TWO);
    let start = |h: f64| {
        let mut q = program.nominal.clone();
        program.assembly.clone().correct(&mut q).expect("nominal");
        let mut u: Vec<f64> = program
            .u
            .iter()
            .map(|u| match u.name.as_str() {
                "s1_wx" => 3.0,
                "f2_wy" => -2.0,
                "s1_wz" => 1.0,
                _ => 0.0,
            })
            .collect();
        if program.is_redundant() {
            let mut mechanism = Interpreted::<f64>::new(&program);
            // The correction is linear in the slider's speed: that with which it vanishes.
            let slide = program.u.iter().position(|u| u.name == "u_pr").expect("the slider");
            let mut change = |speed: f64| {
                let mut u = u.clone();
                u[slide] = speed;
                mechanism.project_speeds(&q, &mut u).expect("lengths fit");
                u[slide] - speed
            };
            let [at_rest, at_one] = [0.0, 1.0].map(&mut change);
            u[slide] = at_rest / (at_rest - at_one);
        }
        moved(&program, &[q, u].concat(), h, |t| 0.3 * (4.0 * t).sin()).0
    };
    let e0 = program.q.iter().position(|q| q.name == "s1_e0").expect("its first parameter");
    let end = start(1e-3);
    assert!((end[e0] - 0.755_75).abs() < 1e-4, "{}", end[e0]);
}

/// The linearisation against differences at attitudes of the independent ball joint whose first Euler parameter is
/// named, half turns among them. `follow` sets guesses of the dependent coordinates.
fn linearisation_is_regular(text: &str, first: &str, follow: impl Fn(&mut [f64])) {
    let model = model::parse("test.toml", text).unwrap_or_else(|e| panic!("{e}"));
    let mut asking = Asking::of(&model, &["linearisation", "outputs"]);
    let first = asking.program.q.iter().position(|q| q.name == first).expect("a ball joint");
    let is_independent = |name: &str| model.coordinates.iter().any(|c| c.name == name && c.independent);
    let independent: Vec<usize> =
        (0..asking.program.q.len()).filter(|&i| is_independent(&asking.program.q[i].name)).collect();
    let n_q = independent.len();
    let n = n_q + asking.program.u.len();
    let mut assembly = asking.program.assembly.clone();
    assembly.set_time(asking.state.t);
    for e in [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.6, 0.8, 0.0], [1e-4, 0.6, 0.0, -0.8]] {
        let turn = |q: &mut [f64], e: [f64; 4]| {
            let length = e.iter().map(|x| x * x).sum::<f64>().sqrt();
            (0..4).for_each(|i| q[first + i] = e[i] / length);
        };
        let mut state = asking.state.clone();
        turn(&mut state.q, e);
        follow(&mut state.q);
        assembly.correct(&mut state.q).expect("the dependent coordinates follow");
        let unit: [f64; 4] = std::array::from_fn(|i| state.q[first + i]);
        let [a, c] = ["a", "c"].map(|part| asking.part(&state, "linearisation", part));
        assert_eq!([a.len(), c.len()], [n * n, n * asking.program.outputs.len()]);
        let matrix = [a, c].concat();
        let size = matrix.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        assert!(size < 1e3, "{size:e} at {e:?}");
        for column in 0..n {
            // Of the Euler parameters a direction across them: they stay of unit length.
            let mut direction = vec![0.0; n];
            direction[column] = 1.0;
            let of = independent.get(column).and_then(|i| i.checked_sub(first)).filter(|i| *i < 4);
            for (i, &place) in independent.iter().enumerate() {
                if let (Some(own), Some(other @ 0..4)) = (of, place.checked_sub(first)) {
                    direction[i] -= unit[own] * unit[other];
                }
            }
            let mut rates = |change: f64| {
                let mut at: At = state.clone();
                independent.iter().zip(&direction).for_each(|(&i, d)| at.q[i] += change * d);
                at.u.iter_mut().zip(&direction[n_q..]).for_each(|(u, d)| *u += change * d);
                let moved = std::array::from_fn(|i| at.q[first + i]);
                turn(&mut at.q, moved);
                follow(&mut at.q);
                assembly.correct(&mut at.q).expect("the dependent coordinates follow");
                let (q_dot, u_dot) = asking.rates(&at);
                let outputs = asking.engine.outputs(at.t, &at.q, &at.u, &at.inputs).expect("lengths fit");
                independent.iter().map(|&i| q_dot[i]).chain(u_dot).chain(outputs).collect()
            };
            let slopes = difference(&mut rates, 1e-3);
            for (row, (entries, slope)) in matrix.chunks(n).zip(&slopes).enumerate() {
                let found: f64 = entries.iter().zip(&direction).map(|(x, d)| x * d).sum();
                let off = (found - slope).abs();
                assert!(off <= 1e-8 * size, "({row}, {column}) at {e:?}: {found:e} against {slope:e}");
            }
        }
    }
}

#[test]
fn linearisation_is_regular_at_half_turns_beside_a_constraint() {
    linearisation_is_regular(CARRIED, "bj_e0", |_| {});
}

#[test]
fn linearisation_is_regular_where_a_dependent_ball_joint_turns_by_half() {
    // The second body keeps its attitude: its joint turns back what the first one turns.
    linearisation_is_regular(LEVEL, "s1_e0", |q| {
        q[4] = q[0];
        (1..4).for_each(|i| q[4 + i] = -q[i]);
    });
}
