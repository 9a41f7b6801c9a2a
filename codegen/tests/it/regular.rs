//! A regular configuration is never refused: mechanisms pass configurations where a single elimination is singular.
//!
//! Oracles: textbook closed forms, integrated here by Kutta's method; none of them uses eliminations.

use crate::draw::Draw;
use crate::models::{derived_from, shipped};
use smartbed_codegen::{Interpreted, ParameterChoice, Program, program};
use smartbed_runtime::mechanism::Mechanism;
use smartbed_runtime::ode::Driven;
use smartbed_runtime::ode::State;
use smartbed_runtime::ode::rk4;
use smartbed_runtime::real::Scalar;
use std::f64::consts::{FRAC_PI_2, PI};

/// Against independent equations at random states, relative to the largest acceleration.
const EXACT: f64 = 1e-12;
/// In single precision after ten seconds.
const SINGLE: f64 = 1e-5;
const STATES: usize = 1000;

fn derived(name: &str) -> Program {
    program::derive(&shipped(name), &ParameterChoice::default()).unwrap_or_else(|e| panic!("{e}"))
}

/// q', u' and the worst pivot.
fn rates(mechanism: &mut Interpreted<f64>, q: &[f64], u: &[f64]) -> (Vec<f64>, Vec<f64>, f64) {
    let (mut q_dot, mut u_dot) = (vec![0.0; q.len()], vec![0.0; u.len()]);
    let inputs = vec![0.0; mechanism.n_inputs()];
    let pivot = mechanism.rates(0.0, q, u, &inputs, &mut q_dot, &mut u_dot).expect("lengths fit");
    (q_dot, u_dot, pivot)
}

/// Largest difference relative to the largest expected value.
fn error(found: &[f64], expected: &[f64]) -> f64 {
    let size = expected.iter().fold(1e-3_f64, |m, x| m.max(x.abs()));
    found.iter().zip(expected).fold(0.0_f64, |m, (a, b)| {
        let off = (a - b).abs() / size;
        if off.is_nan() { f64::INFINITY } else { m.max(off) }
    })
}

/// The state after some steps of Kutta's method, as the runtime takes them: no step is refused.
fn moved<S: Scalar>(program: &Program, start: &[f64], h: f64, steps: usize) -> Vec<f64> {
    let mut x: Vec<S> = start.iter().map(|&x| S::from_f64(x)).collect();
    let mut low = vec![S::ZERO; x.len()];
    let mut scratch = vec![S::ZERO; 8 * x.len()];
    let mut inputs = vec![S::ZERO; program.inputs.len()];
    let law = |_: S, _: &[S], _: &[S], inputs: &mut [S]| inputs.fill(S::ZERO);
    let mut driven = Driven::new(Interpreted::<S>::new(program), law, &mut inputs).expect("inputs");
    let mut state = State::new(&mut x, &mut low).expect("one length");
    for step in 0..steps {
        let t = S::from_f64(step as f64 * h);
        let taken = rk4(&mut driven, t, S::from_f64(h), &mut state, &mut scratch);
        assert!(taken.is_ok(), "step {step}: {taken:?} at {:?}", state.x());
    }
    state.x().iter().map(|x| x.to_f64()).collect()
}

/// The same by a function written here.
fn integrated<const N: usize>(
    mut x: [f64; N],
    h: f64,
    steps: usize,
    f: impl Fn([f64; N]) -> [f64; N],
) -> [f64; N] {
    let along = |x: [f64; N], k: [f64; N], h: f64| std::array::from_fn(|i| x[i] + h * k[i]);
    for _ in 0..steps {
        let a = f(x);
        let b = f(along(x, a, 0.5 * h));
        let c = f(along(x, b, 0.5 * h));
        let d = f(along(x, c, h));
        x = std::array::from_fn(|i| x[i] + h / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]));
    }
    x
}

const R: f64 = 0.5;
const G: f64 = 9.81;

/// Kane and Levinson's rolling disc: x, y of the contact, yaw, lean, spin; u1, u2, u3 as in the model.
fn disc([_, _, yaw, lean, _, u1, u2, u3]: [f64; 8]) -> [f64; 8] {
    let yaw_dot = u3 / lean.cos();
    let spin_dot = u2 - u3 * lean.tan();
    // The contact runs along the heading as the disc unrolls.
    let [x_dot, y_dot] = [R * spin_dot * yaw.cos(), R * spin_dot * yaw.sin()];
    let (s, t) = (lean.sin(), lean.tan());
    [
        x_dot,
        y_dot,
        yaw_dot,
        u1,
        spin_dot,
        (4.0 * G * s + 6.0 * R * u2 * u3 - R * u3 * u3 * t) / (5.0 * R),
        -2.0 / 3.0 * u1 * u3,
        (-2.0 * u2 + u3 * t) * u1,
    ]
}

#[test]
fn a_rolling_disc_is_regular_at_every_heading() {
    let program = derived("rolling_disc");
    let mut mechanism = Interpreted::<f64>::new(&program);
    let mut draw = Draw(1);
    let (mut worst, mut least) = (0.0_f64, 1.0_f64);
    for state in 0..STATES {
        let [x, y, yaw, lean, spin]: [f64; 5] = draw.list(1.0);
        // Every other state at a heading where fixed axes and the disc's are parallel, or almost.
        let yaw = match state % 4 {
            0 => (state / 4 % 8) as f64 * FRAC_PI_2,
            1 => (state / 4 % 8) as f64 * FRAC_PI_2 + 1e-8 * yaw,
            _ => PI * yaw,
        };
        let u: [f64; 3] = draw.list(5.0);
        let q = [x, y, yaw, 1.2 * lean, PI * spin];
        let expected = disc([q[0], q[1], q[2], q[3], q[4], u[0], u[1], u[2]]);
        let (q_dot, u_dot, pivot) = rates(&mut mechanism, &q, &u);
        worst = worst.max(error(&u_dot, &expected[5..])).max(error(&q_dot, &expected[..5]));
        least = least.min(pivot);
    }
    println!("rolling disc: error {worst:.1e}, least pivot {least:.2}");
    assert!(worst <= EXACT && least > 0.1, "{worst:e}, pivot {least}");
}

#[test]
fn a_rolling_disc_turns_through_every_heading_in_f32() {
    let program = derived("rolling_disc");
    let (lean, yaw_rate) = (0.3_f64, 1.5);
    let u3 = yaw_rate * lean.cos();
    let u2 = (u3 * u3 * lean.tan() - 4.0 * G * lean.sin() / R) / (6.0 * u3);
    let start = [0.0, 0.0, 0.0, lean, 0.0, 0.0, u2, u3];
    let expected = integrated(start, 1e-3, 10_000, disc);
    let double = error(&moved::<f64>(&program, &start, 1e-3, 10_000), &expected);
    let single = error(&moved::<f32>(&program, &start, 1e-3, 10_000), &expected);
    println!("rolling disc after 10 s: f64 {double:.1e}, f32 {single:.1e}");
    assert!(double <= 1e-10 && single <= SINGLE, "{double:e}, {single:e}");
}

/// Principal moments of the free body.
const I: [f64; 3] = [1.0, 2.0, 3.0];

/// Euler's equations and the rates of Euler parameters: e0..e3, w1..w3.
fn tumbling([e0, e1, e2, e3, w1, w2, w3]: [f64; 7]) -> [f64; 7] {
    [
        0.5 * (-e1 * w1 - e2 * w2 - e3 * w3),
        0.5 * (e0 * w1 - e3 * w2 + e2 * w3),
        0.5 * (e3 * w1 + e0 * w2 - e1 * w3),
        0.5 * (-e2 * w1 + e1 * w2 + e0 * w3),
        (I[1] - I[2]) * w2 * w3 / I[0],
        (I[2] - I[0]) * w3 * w1 / I[1],
        (I[0] - I[1]) * w1 * w2 / I[2],
    ]
}

/// Names of the independent speeds in the program's order.
fn speeds(program: &Program, named: &[(&str, f64)]) -> Vec<f64> {
    let value = |name: &str| named.iter().find(|(n, _)| *n == name).map_or(0.0, |(_, x)| *x);
    program.u.iter().map(|u| value(&u.name)).collect()
}

#[test]
fn a_free_body_in_euler_parameters_is_regular_at_every_attitude() {
    let program = derived("free_body");
    let mut mechanism = Interpreted::<f64>::new(&program);
    let mut draw = Draw(2);
    let (mut worst, mut least) = (0.0_f64, 1.0_f64);
    for state in 0..STATES {
        let mut e: [f64; 4] = draw.list(1.0);
        // At the identity, half turns about every axis, and with one parameter zero.
        match state % 3 {
            0 => e = std::array::from_fn(|i| f64::from(u8::from(i == state / 3 % 4))),
            1 => e[state / 3 % 4] = 0.0,
            _ => {}
        }
        let norm = e.iter().map(|x| x * x).sum::<f64>().sqrt();
        let e = e.map(|x| x / norm);
        let [w1, w2, w3]: [f64; 3] = draw.list(5.0);
        let expected = tumbling([e[0], e[1], e[2], e[3], w1, w2, w3]);
        let u = speeds(&program, &[("w1", w1), ("w2", w2), ("w3", w3)]);
        let q = [0.1, 0.2, 0.3, e[0], e[1], e[2], e[3]];
        let (q_dot, u_dot, pivot) = rates(&mut mechanism, &q, &u);
        let found: Vec<f64> = ["w1", "w2", "w3"]
            .iter()
            .map(|name| u_dot[program.u.iter().position(|u| u.name == *name).expect("a speed")])
            .collect();
        worst = worst.max(error(&q_dot[3..], &expected[..4])).max(error(&found, &expected[4..]));
        least = least.min(pivot);
    }
    println!("free body: error {worst:.1e}, least pivot {least:.2}, {} operations", program.operations());
    assert!(worst <= EXACT && least > 0.5, "{worst:e}, pivot {least}");
}

#[test]
fn a_free_body_tumbles_through_half_turns_in_f32() {
    let program = derived("free_body");
    let w = [1.0, 0.2, 1.0];
    let start = |e: [f64; 4]| {
        let u = speeds(&program, &[("w1", w[0]), ("w2", w[1]), ("w3", w[2])]);
        [&[0.0; 3][..], &e, &u].concat()
    };
    for e in [[1.0, 0.0, 0.0, 0.0], [0.5; 4], [0.0, 0.0, 1.0, 0.0]] {
        let expected = integrated([e[0], e[1], e[2], e[3], w[0], w[1], w[2]], 1e-3, 10_000, tumbling);
        let double = error(&moved::<f64>(&program, &start(e), 1e-3, 10_000)[3..7], &expected[..4]);
        let single = error(&moved::<f32>(&program, &start(e), 1e-3, 10_000)[3..7], &expected[..4]);
        println!("free body after 10 s from {e:?}: f64 {double:.1e}, f32 {single:.1e}");
        assert!(double <= 1e-10 && single <= SINGLE, "{double:e}, {single:e}");
    }
}

/// The correction moves all four parameters along themselves: it converges at once where one of them is 0.
#[test]
fn euler_parameters_are_corrected_along_themselves() {
    let mut mechanism = Interpreted::<f64>::new(&derived("free_body"));
    for e in [[0.0, 1.0, 0.0, 0.0], [0.6, 0.0, 0.8, 0.0], [0.5; 4]] {
        let long = e.map(|x| 1.001 * x);
        let mut q = [&[0.1, 0.2, 0.3][..], &long].concat();
        let residuals: Vec<f64> = (0..3).map(|_| mechanism.project(&mut q).expect("lengths fit")).collect();
        assert!(residuals[0] > 1e-3 && residuals[2] < 1e-11, "{residuals:?}");
        assert!(error(&q[3..], &e) < 1e-12, "{q:?}");
    }
}

/// The orthogonal six-bar linkage of Bricard: six hinges at right angles, one bar apart; six equations of rank 4.
const BRICARD: &str = r#"
format = 1
name = "bricard"
dof = 1
gravity = "-g*N.z"
[parameters]
a = { value = 1, unit = "m" }
m = { value = 1, unit = "kg" }
I = { value = 0.1, unit = "kg m^2" }
g = { value = 9.81, unit = "m/s^2" }
k = { value = 200, unit = "N m" }
[coordinates]
q1 = { unit = "rad", independent = true, nominal = NOMINAL1, range = [-2, 2] }
q2 = { unit = "rad", nominal = NOMINAL2 }
q3 = { unit = "rad", nominal = NOMINAL1 }
q4 = { unit = "rad", nominal = NOMINAL2 }
q5 = { unit = "rad", nominal = NOMINAL1 }
[frames]
f1 = { rotations = [["z", "q1"]] }
f2 = { parent = "f1", rotations = [["x", "90*deg"], ["z", "q2"]] }
f3 = { parent = "f2", rotations = [["x", "-90*deg"], ["z", "q3"]] }
f4 = { parent = "f3", rotations = [["x", "90*deg"], ["z", "q4"]] }
f5 = { parent = "f4", rotations = [["x", "-90*deg"], ["z", "q5"]] }
f6 = { parent = "f5", rotations = [["x", "90*deg"]] }
[points]
P1 = "a*f1.x"
P2 = "P1 + a*f2.x"
P3 = "P2 + a*f3.x"
P4 = "P3 + a*f4.x"
P5 = "P4 + a*f5.x"
C1 = "P1/2"
C2 = "(P1 + P2)/2"
C3 = "(P2 + P3)/2"
C4 = "(P3 + P4)/2"
C5 = "(P4 + P5)/2"
[bodies]
b1 = { centre = "C1", frame = "f1", mass = "m", inertia = { Iyy = "I", Izz = "I" } }
b2 = { centre = "C2", frame = "f2", mass = "m", inertia = { Iyy = "I", Izz = "I" } }
b3 = { centre = "C3", frame = "f3", mass = "m", inertia = { Iyy = "I", Izz = "I" } }
b4 = { centre = "C4", frame = "f4", mass = "m", inertia = { Iyy = "I", Izz = "I" } }
b5 = { centre = "C5", frame = "f5", mass = "m", inertia = { Iyy = "I", Izz = "I" } }
[springs]
centring = { coordinate = "q1", stiffness = "k", rest = "1.5" }
[constraints.configuration]
close = "P5 + a*N.x"
axis6x = "dot(f6.z, N.x)"
axis6y = "dot(f6.z, N.y) + 1"
axis6z = "dot(f6.z, N.z)"
"#;

/// A number with its first and second derivatives by one variable.
#[derive(Clone, Copy)]
struct Jet([f64; 3]);

impl Jet {
    fn constant(x: f64) -> Self {
        Self([x, 0.0, 0.0])
    }

    fn plus(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] + other.0[i]))
    }

    fn times(self, Self([b, b1, b2]): Self) -> Self {
        let Self([a, a1, a2]) = self;
        Self([a * b, a1 * b + a * b1, a2 * b + 2.0 * a1 * b1 + a * b2])
    }

    /// f(self) from f and its derivatives there.
    fn map(self, [f, f1, f2]: [f64; 3]) -> Self {
        let Self([_, a1, a2]) = self;
        Self([f, f1 * a1, f2 * a1 * a1 + f1 * a2])
    }

    fn sin_cos(self) -> [Self; 2] {
        let (s, c) = self.0[0].sin_cos();
        [self.map([s, c, -s]), self.map([c, -s, -c])]
    }
}

type Axes = [[Jet; 3]; 3];

/// Axes turned about their own x or z (0 or 2).
fn turned(axes: &Axes, about: usize, [s, c]: [Jet; 2]) -> Axes {
    let (a, b) = ((about + 1) % 3, (about + 2) % 3);
    let minus = s.times(Jet::constant(-1.0));
    let mut new = *axes;
    for i in 0..3 {
        new[a][i] = c.times(axes[a][i]).plus(s.times(axes[b][i]));
        new[b][i] = minus.times(axes[a][i]).plus(c.times(axes[b][i]));
    }
    new
}

/// q2 by q1: three hinges at q1, three at q2, cos q1 + cos q2 + cos q1 cos q2 = 0.
fn other_angle(q1: f64) -> Jet {
    let one = Jet([q1, 1.0, 0.0]);
    let [s, c] = one.sin_cos().map(|jet| jet.0[0]);
    let sum = 1.0 + c;
    // x = -c/(1 + c), x' = s/(1 + c)^2, x'' = (c (1 + c) + 2 s^2)/(1 + c)^3; q2 = acos x.
    let x = Jet([-c / sum, s / (sum * sum), (c * sum + 2.0 * s * s) / sum.powi(3)]);
    let root = (1.0 - x.0[0] * x.0[0]).sqrt();
    x.map([x.0[0].acos(), -1.0 / root, -x.0[0] / root.powi(3)])
}

/// u1' of the six-bar linkage by Lagrange's equation in q1: M u' + M'/2 u^2 + V' = 0.
fn bricard(q1: f64, u1: f64) -> f64 {
    let (mass, moment) = (1.0, 0.1);
    let angles = [Jet([q1, 1.0, 0.0]), other_angle(q1)];
    let [one, zero] = [1.0, 0.0].map(Jet::constant);
    let mut axes = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
    let mut place = [zero; 3];
    let [mut m, mut m_slope, mut force] = [0.0; 3];
    for link in 0..5 {
        if link > 0 {
            let sine = if link % 2 == 1 { 1.0 } else { -1.0 };
            axes = turned(&axes, 0, [Jet::constant(sine), zero]);
        }
        axes = turned(&axes, 2, angles[link % 2].sin_cos());
        let [x, y, z] = axes;
        let half = x.map(|c| c.times(Jet::constant(0.5)));
        let centre: [Jet; 3] = std::array::from_fn(|i| place[i].plus(half[i]));
        place = std::array::from_fn(|i| place[i].plus(x[i]));
        // w_y = z' x, w_z = x' y per unit of q1'.
        let slope = |a: [Jet; 3]| a.map(|Jet([_, a1, a2])| Jet([a1, a2, 0.0]));
        let dot = |a: [Jet; 3], b: [Jet; 3]| (0..3).fold(zero, |sum, i| sum.plus(a[i].times(b[i])));
        let v = slope(centre);
        for (size, square) in [(mass, dot(v, v))]
            .into_iter()
            .chain([dot(slope(z), x), dot(slope(x), y)].map(|w| (moment, w.times(w))))
        {
            m += size * square.0[0];
            m_slope += size * square.0[1];
        }
        force -= mass * G * centre[2].0[1];
    }
    force -= 200.0 * (q1 - 1.5);
    (force - 0.5 * m_slope * u1 * u1) / m
}

/// The six-bar linkage with these equations of its last axis; a spring swings it through right angles.
fn six_bar(equations: &str) -> Program {
    let text = BRICARD.replace("NOMINAL1", "1.2").replace("NOMINAL2", "1.9");
    let (head, _) = text.split_once("axis6x").expect("constraints");
    derived_from(&format!("{head}{equations}"))
}

const ALL_AXES: &str =
    "axis6x = \"dot(f6.z, N.x)\"\naxis6y = \"dot(f6.z, N.y) + 1\"\naxis6z = \"dot(f6.z, N.z)\"\n";

#[test]
fn an_overconstrained_six_bar_is_regular_wherever_it_closes() {
    let program = six_bar(ALL_AXES);
    let mut mechanism = Interpreted::<f64>::new(&program);
    let mut draw = Draw(3);
    let (mut worst, mut least) = (0.0_f64, f64::INFINITY);
    for state in 0..STATES {
        let [place, u1]: [f64; 2] = draw.list(1.0);
        // Every other state at a right angle, or almost; the dead points are at 120 degrees.
        let q1 = match state % 4 {
            0 => FRAC_PI_2,
            1 => FRAC_PI_2 + 1e-4 * place,
            _ => 1.8 * place,
        };
        let q2 = other_angle(q1).0[0];
        let (_, u_dot, pivot) = rates(&mut mechanism, &[q1, q2, q1, q2, q1], &[3.0 * u1]);
        let expected = bricard(q1, 3.0 * u1);
        worst = worst.max((u_dot[0] - expected).abs() / expected.abs().max(10.0));
        least = least.min(pivot);
    }
    println!("six-bar: error {worst:.1e}, least pivot {least:.1e}, {} operations", program.operations());
    assert!(worst <= EXACT && least > 1e-2, "{worst:e}, pivot {least:e}");
}

#[test]
fn an_overconstrained_six_bar_moves_through_right_angles_in_f32() {
    let program = six_bar(ALL_AXES);
    let (q1, u1) = (1.2, 0.0);
    let q2 = other_angle(q1).0[0];
    let mut reached = [q1; 2];
    let (mut expected, h) = ([q1, u1], 1e-3);
    for _ in 0..10_000 {
        expected = integrated(expected, h, 1, |[q, u]| [u, bricard(q, u)]);
        reached = [reached[0].min(expected[0]), reached[1].max(expected[0])];
    }
    println!("six-bar: oracle moves from {:.3} to {:.3} rad", reached[0], reached[1]);
    let start = [q1, q2, q1, q2, q1, u1];
    let double = error(&moved::<f64>(&program, &start, h, 10_000)[..1], &expected[..1]);
    let single = error(&moved::<f32>(&program, &start, h, 10_000)[..1], &expected[..1]);
    println!("six-bar after 10 s: f64 {double:.1e}, f32 {single:.1e}");
    assert!(double <= 1e-9 && single <= SINGLE, "{double:e}, {single:e}");
    assert!(reached[0] < FRAC_PI_2 && FRAC_PI_2 < reached[1], "{reached:?}");
}

/// At 120 degrees q1 turns back while the other angles go on.
#[test]
fn without_a_range_the_six_bar_passes_its_dead_points() {
    let text = BRICARD.replace("NOMINAL1, range = [-2, 2]", "1.2").replace("NOMINAL1", "1.2");
    assert!(!six_bar(ALL_AXES).is_redundant());
    assert!(derived_from(&text.replace("NOMINAL2", "1.9")).is_redundant());
}

/// The warning's advice works: without the equations that it calls redundant the same mechanism is derived.
#[test]
fn a_dropped_constraint_may_be_removed_as_advised() {
    let mut equations = ALL_AXES.to_owned();
    let mut removed = Vec::new();
    loop {
        let program = six_bar(&equations);
        let Some(warning) = program.warnings.items.first() else { break };
        let name = warning.message.split('`').nth(1).expect("a name").to_owned();
        let kept: Vec<&str> = equations.lines().filter(|line| !line.starts_with(&name)).collect();
        equations = kept.join("\n");
        removed.push(name);
    }
    assert_eq!(removed.len(), 2, "{removed:?}");
    let [mut all, mut fewer] = [six_bar(ALL_AXES), six_bar(&equations)].map(|p| Interpreted::<f64>::new(&p));
    for q1 in [0.3, 1.0, FRAC_PI_2, 1.9] {
        let q2 = other_angle(q1).0[0];
        let [a, b] = [&mut all, &mut fewer].map(|m| rates(m, &[q1, q2, q1, q2, q1], &[1.0]).1[0]);
        assert!((a - b).abs() < 1e-9 * a.abs().max(1.0), "q1 = {q1}: {a} and {b} without {removed:?}");
    }
}

/// Rolling implies the front wheel's contact only at velocity level: the position equation of the contact corrects the
/// bicycle's pitch, and changes nothing else.
#[test]
fn the_bicycles_front_wheel_is_put_back_on_the_ground() {
    let program = derived("bicycle");
    let pitch = program.q.iter().position(|q| q.name == "pitch").expect("a coordinate");
    let mut mechanism = Interpreted::<f64>::new(&program);
    let mut q = program.nominal.clone();
    for (i, place) in q.iter_mut().enumerate().filter(|(i, _)| *i != pitch) {
        *place += 0.1 * (i + 1) as f64;
    }
    let start = q.clone();
    let residuals: Vec<f64> = (0..6).map(|_| mechanism.project(&mut q).expect("lengths fit")).collect();
    // Newton: every residual is about the square of the last.
    assert!(residuals[0] > 1e-3 && residuals[5] < 1e-15, "{residuals:?}");
    assert!(residuals.windows(2).all(|r| r[1] <= 10.0 * r[0] * r[0] + 1e-15), "{residuals:?}");
    let moved = (0..q.len()).filter(|&i| q[i] != start[i]).collect::<Vec<_>>();
    assert_eq!(moved, [pitch]);
}
