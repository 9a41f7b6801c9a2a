//! Driven mechanisms: velocities with a term without speeds, and positions that depend on time.
//!
//! Oracles: accelerations and powers written out by hand; d/dt (kinetic + potential) against the power of the drive.

use crate::augmented;
use crate::draw::Draw;
use crate::models::shipped;
use crate::reactions::cross;
use smartbed_codegen::{Interpreted, Program, Settings, model};
use smartbed_runtime::mechanism::Mechanism;
use smartbed_runtime::ode::Driven;
use smartbed_runtime::ode::Method;
use smartbed_runtime::ode::State;
use smartbed_runtime::real::Scalar;

/// Against independent equations, relative to the largest acceleration.
const EXACT: f64 = 1e-12;
/// In single precision after ten seconds.
const SINGLE: f64 = 1e-5;
const STATES: usize = 1000;

/// The program of a shipped model by its name, or of a text.
fn derived(text: &str) -> Program {
    let model = match text.lines().count() {
        1 => shipped(text),
        _ => model::parse("driven.toml", text).unwrap_or_else(|found| panic!("{found}")),
    };
    augmented::with_augmented(&model, Settings::default())
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
    let mut random = Draw(1);
    for _ in 0..STATES {
        let (t, q, u) =
            (2.0 + 2.0 * random.next(), [4.0 * random.next(), 3.0 * random.next()], [9.0 * random.next()]);
        let (w, w_dot) = (20.0 * (1.0 + (3.0 * t).sin()), 60.0 * (3.0 * t).cos());
        let expected = [w, u[0], arm_acceleration(q[0], w, w_dot, q[1])];
        let (mut found, u_dot) = rates(&mut engine, t, &q, &u);
        found.extend(u_dot);
        assert!(off(&found, &expected) <= EXACT, "{found:?} {expected:?}");
    }
}

#[test]
fn a_coordinate_is_a_function_of_time() {
    let text = ARM.replace("CRANK", "crank = { unit = \"rad\", closed_form = \"w*t + sin(3_rad/1_s*t)\" }");
    let mut engine = Interpreted::<f64>::new(&derived(&text));
    let mut random = Draw(2);
    for _ in 0..STATES {
        let (t, q, u) = (2.0 + 2.0 * random.next(), [3.0 * random.next()], [9.0 * random.next()]);
        let (crank, w, w_dot) =
            (20.0 * t + (3.0 * t).sin(), 20.0 + 3.0 * (3.0 * t).cos(), -9.0 * (3.0 * t).sin());
        let expected = [u[0], arm_acceleration(crank, w, w_dot, q[0])];
        let (mut found, u_dot) = rates(&mut engine, t, &q, &u);
        found.extend(u_dot);
        assert!(off(&found, &expected) <= EXACT, "{found:?} {expected:?}");
        let speeds = engine.speeds(&q, &u).expect("lengths fit");
        assert!(off(&speeds, &[w, u[0]]) <= 1e-14, "{speeds:?}");
    }
}

/// The drive's power against the rate of the energy along the motion, by central differences of order 4, plus the power
/// `lost` in dampers.
pub fn check_power(program: &Program, t: f64, q: &[f64], u: &[f64], lost: f64) {
    let mut engine = Interpreted::<f64>::new(program);
    let (q_dot, u_dot) = rates(&mut engine, t, q, u);
    let mut along = |h: f64| {
        let moved =
            |x: &[f64], x_dot: &[f64]| -> Vec<f64> { x.iter().zip(x_dot).map(|(x, v)| x + h * v).collect() };
        engine.set_time(t + h);
        let (kinetic, potential) = engine.energy(&moved(q, &q_dot), &moved(u, &u_dot)).expect("lengths fit");
        kinetic + potential
    };
    let h = 1e-4;
    let slope = (8.0 * (along(h) - along(-h)) - (along(2.0 * h) - along(-2.0 * h))) / (12.0 * h);
    let power = engine.drive(t, q, u, &[]).expect("lengths fit");
    assert!(off(&[power], &[slope + lost]) < 1e-8, "{}: {power} {slope}", program.name);
}

/// The state after some steps of Kutta's method, as the runtime takes them.
fn moved<S: Scalar>(program: &Program, start: &[f64], h: f64, steps: usize) -> Vec<f64> {
    moved_by::<S>(Method::Rk4, program, start, h, steps)
}

/// The same by any method of fixed step.
fn moved_by<S: Scalar>(method: Method, program: &Program, start: &[f64], h: f64, steps: usize) -> Vec<f64> {
    let mut x: Vec<S> = start.iter().map(|&x| S::from_f64(x)).collect();
    let mut low = vec![S::ZERO; x.len()];
    let mut scratch = vec![S::ZERO; 8 * x.len()];
    let mut driven =
        Driven::new(Interpreted::<S>::new(program), |_: S, _: &[S], _: &[S], _: &mut [S]| {}, &mut [])
            .expect("no inputs");
    let mut state = State::new(&mut x, &mut low).expect("one length");
    for step in 0..steps {
        let t = S::from_f64(step as f64 * h);
        method.step(&mut driven, t, S::from_f64(h), &mut state, &mut scratch).expect("a regular step");
    }
    state.x().iter().map(|x| x.to_f64()).collect()
}

/// Ten seconds in single precision against the same in double precision with a quarter of the step.
fn check_single(program: &Program, start: &[f64]) {
    let (single, double) =
        (moved::<f32>(program, start, 1e-3, 10_000), moved::<f64>(program, start, 2.5e-4, 40_000));
    assert!(off(&single, &double) <= SINGLE, "{}: {single:?} {double:?}", program.name);
}

#[test]
fn the_power_of_the_drive_is_the_rate_of_the_energy() {
    let constraint = ARM.replace("CRANK", "crank = { unit = \"rad\", speed = { independent = false } }")
        + "[constraints.motion]\ndrive = \"u_crank - w*(1 + sin(3_rad/1_s*t))\"\n";
    check_power(&derived(&constraint), 0.7, &[0.4, 1.1], &[1.3], 0.0);
    let function =
        ARM.replace("CRANK", "crank = { unit = \"rad\", closed_form = \"w*t + sin(3_rad/1_s*t)\" }");
    check_power(&derived(&function), 0.7, &[1.1], &[1.3], 0.0);
}

#[test]
fn a_driven_pendulum_in_f32() {
    check_single(&derived("driven_pendulum"), &[0.0, 0.1, 0.0]);
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The ball on the turntable: m, R, W of the model.
const BALL: (f64, f64, f64) = (0.5, 0.1, 1.4);
const UP: [f64; 3] = [0.0, 0.0, 1.0];

/// Axes of the ball in N by its Euler parameters.
fn axes(e: [f64; 4]) -> [[f64; 3]; 3] {
    let [a, b, c, d] = e;
    let x = [a * a + b * b - c * c - d * d, 2.0 * (b * c + a * d), 2.0 * (b * d - a * c)];
    let y = [2.0 * (b * c - a * d), a * a - b * b + c * c - d * d, 2.0 * (c * d + a * b)];
    [x, y, cross(x, y)]
}

/// Velocity of the centre that rolls: v = w x R z + W z x c.
fn rolling(place: [f64; 2], e: [f64; 4], w: [f64; 3]) -> [f64; 3] {
    let (_, radius, table) = BALL;
    let axes = axes(e);
    let spin = std::array::from_fn(|i| (0..3).map(|j| w[j] * axes[j][i]).sum());
    let (rolled, carried) = (cross(spin, UP), cross(UP, [place[0], place[1], 0.0]));
    std::array::from_fn(|i| radius * rolled[i] + table * carried[i])
}

#[test]
fn a_ball_rolls_on_a_turntable() {
    let program = derived("turntable");
    let mut engine = Interpreted::<f64>::new(&program);
    let mut random = Draw(3);
    let (mass, radius, table) = BALL;
    for _ in 0..STATES {
        let place = [random.next(), random.next()];
        let e: [f64; 4] = std::array::from_fn(|_| random.next());
        let size = e.iter().map(|x| x * x).sum::<f64>().sqrt();
        let e = e.map(|x| x / size);
        let w: [f64; 3] = std::array::from_fn(|_| 5.0 * random.next());
        let v = rolling(place, e, w);
        // Newton, Euler and the rate of the rolling condition: a = 2/7 W z x v, w' = -5/(2 R) z x a.
        let a = cross(UP, v).map(|x| 2.0 / 7.0 * table * x);
        let spin = cross(UP, a).map(|x| -2.5 / radius * x);
        let e_dot = [
            -0.5 * (e[1] * w[0] + e[2] * w[1] + e[3] * w[2]),
            0.5 * (e[0] * w[0] + e[2] * w[2] - e[3] * w[1]),
            0.5 * (e[0] * w[1] + e[3] * w[0] - e[1] * w[2]),
            0.5 * (e[0] * w[2] + e[1] * w[1] - e[2] * w[0]),
        ];
        let q = [place[0], place[1], e[0], e[1], e[2], e[3]];
        let (q_dot, u_dot) = rates(&mut engine, 0.0, &q, &w);
        assert!(off(&q_dot, &[v[0], v[1], e_dot[0], e_dot[1], e_dot[2], e_dot[3]]) <= EXACT, "{q_dot:?}");
        assert!(off(&u_dot, &axes(e).map(|axis| dot(axis, spin))) <= EXACT, "{u_dot:?}");
        // The table does the work of its friction: F . (W z x c).
        let power = mass * table * dot(a, cross(UP, [place[0], place[1], 0.0]));
        let found = engine.drive(0.0, &q, &w, &[]).expect("lengths fit");
        assert!(off(&[found], &[power]) <= EXACT, "{found} {power}");
    }
}

/// v turns at 2/7 W: c = c0 + (sin(nt) v0 + (1 - cos(nt)) z x v0)/n.
#[test]
fn a_ball_on_a_turntable_goes_round_in_circles() {
    let program = derived("turntable");
    let (place, e, w) = ([0.5, 0.0], [1.0, 0.0, 0.0, 0.0], [1.0, 0.5, 2.0]);
    let v = rolling(place, e, w);
    let n = 2.0 / 7.0 * BALL.2;
    let turn = 10.0 * n;
    let across = cross(UP, v);
    let expected: [f64; 2] =
        std::array::from_fn(|i| place[i] + (turn.sin() * v[i] + (1.0 - turn.cos()) * across[i]) / n);
    let start = [place[0], place[1], e[0], e[1], e[2], e[3], w[0], w[1], w[2]];
    // The ball spins at 26 rad/s in the end: short steps.
    let double = moved::<f64>(&program, &start, 1e-4, 100_000);
    assert!(off(&double[..2], &expected) <= 1e-9, "{double:?} {expected:?}");
    let single = moved::<f32>(&program, &start, 1e-3, 10_000);
    assert!(off(&single[..2], &expected) <= SINGLE, "{single:?} {expected:?}");
}

#[test]
fn a_cam_lifts_a_valve() {
    let program = derived("cam");
    let mut engine = Interpreted::<f64>::new(&program);
    let mut random = Draw(4);
    let (w, e, length, stiff, damping, weak, preload): (f64, f64, f64, f64, f64, f64, f64) =
        (60.0, 5e-3, 0.03, 5e4, 20.0, 2e3, 50.0);
    for _ in 0..STATES {
        let (t, x, v) = (0.1 + 0.1 * random.next(), 5e-3 * random.next(), random.next());
        let (sin, cos) = (w * t).sin_cos();
        let (lift, rate, second) = (e - e * cos, e * w * sin, e * w * w * cos);
        let tension = stiff * ((length + x - lift) - length) + damping * (v - rate);
        let expected = [v, (-tension - weak * x - preload) / 0.08];
        let (mut found, u_dot) = rates(&mut engine, t, &[x], &[v]);
        found.extend(u_dot);
        assert!(off(&found, &expected) <= EXACT, "{found:?} {expected:?}");
        let power = (0.1 * second - tension) * rate;
        let found = engine.drive(t, &[x], &[v], &[]).expect("lengths fit");
        assert!(off(&[found], &[power]) <= EXACT, "{found} {power}");
    }
}

/// Angle and place of the shaking table's rod and table, their rates and the table's acceleration.
fn shaken(t: f64) -> ([f64; 2], [f64; 2], f64) {
    let (r, l, w, run_up) = (0.02, 0.15, 12.0, 1.0);
    let decay = f64::exp(-t / run_up);
    let (angle, rate, second) = (w * (t - run_up * (1.0 - decay)), w * (1.0 - decay), w / run_up * decay);
    let (s, c) = angle.sin_cos();
    let reach = (l * l - r * r * s * s).sqrt();
    let reach_rate = -r * r * s * c * rate / reach;
    let reach_second =
        (-r * r * (c * c - s * s) * rate * rate - r * r * s * c * second - reach_rate * reach_rate) / reach;
    let places = [(-r * s / l).asin(), r * c + reach];
    (
        places,
        [-r * c * rate / reach, -r * s * rate + reach_rate],
        -r * c * rate * rate - r * s * second + reach_second,
    )
}

#[test]
fn a_shaking_table_follows_its_crank() {
    let program = derived("shaking_table");
    let mut engine = Interpreted::<f64>::new(&program);
    let mut random = Draw(5);
    let (m, k, d) = (4.0, 900.0, 6.0);
    for n in 0..STATES {
        let (t, sway, v) = (5.0 + 5.0 * random.next(), 0.06 * random.next(), random.next());
        let (places, rates_of, second) = shaken(t);
        let q = [places[0], places[1], sway];
        let expected = [rates_of[0], rates_of[1], v, -(k * sway + d * v) / m - second];
        let (mut found, u_dot) = rates(&mut engine, t, &q, &[v]);
        found.extend(u_dot);
        assert!(off(&found, &expected) <= EXACT, "{found:?} {expected:?}");
        // Off the loop at that time Newton's correction goes back to it, quadratically.
        let mut near = [q[0] + 1e-4, q[1] - 1e-4, q[2]];
        engine.set_time(t);
        engine.project(&mut near).expect("lengths fit");
        assert!(near.iter().zip(&q).all(|(a, b)| (a - b).abs() < 1e-7), "{near:?} {q:?}");
        if n % 100 == 0 {
            check_power(&program, t, &q, &[v], d * v * v);
            let reached = program.assembly.clone().continue_in_time(&program.nominal, t).expect("a way");
            assert!(off(&reached[..2], &places) < 1e-12, "{reached:?} {places:?}");
        }
    }
}

#[test]
fn a_shaking_table_in_f32() {
    check_single(&derived("shaking_table"), &[0.0, 0.17, 0.0, 0.0]);
}

#[test]
fn driven_models_in_augmented_form() {
    augmented::agree(&derived("shaking_table"), &[0.0, 0.17, 0.02], &[0.3], &[]);
    augmented::agree(&derived("driven_pendulum"), &[0.4, 1.1], &[0.3], &[]);
    augmented::agree(&derived("turntable"), &[0.3, -0.2, 0.5, 0.5, -0.5, 0.5], &[0.3, 1.0, -2.0], &[]);
}

#[test]
fn a_stated_velocity_may_read_a_definition_of_velocities() {
    let text = r#"
format = 1
name = "carried"
dof = 1
[parameters]
m = { value = 2, unit = "kg" }
a = { value = 3, unit = "m/s^2" }
k = { value = 5, unit = "N/m" }
[coordinates]
x = { unit = "m" }
[definitions]
both = "velocity(P) + a*t*N.x"
[points]
P = "x*N.x"
Q = { position = "x*N.x", velocity = "both" }
[bodies]
bob = { centre = "Q", mass = "m" }
[springs]
s = { coordinate = "x", stiffness = "k" }
"#;
    // m (x'' + a) = -k x
    let mut engine = Interpreted::<f64>::new(&derived(text));
    let (q_dot, u_dot) = rates(&mut engine, 0.3, &[0.2], &[0.7]);
    assert!(off(&[q_dot[0], u_dot[0]], &[0.7, -5.0 * 0.2 / 2.0 - 3.0]) <= 1e-15, "{q_dot:?} {u_dot:?}");
}

/// A four-bar whose crank turns as prescribed: no freedom is left, no pivot of the elimination vanishes on the way.
#[test]
fn a_linkage_without_freedom_turns_all_round() {
    let text = r#"
format = 1
name = "linkage"
dof = 0
[parameters]
a = { value = 0.1, unit = "m" }
b = { value = 0.3, unit = "m" }
c = { value = 0.25, unit = "m" }
d = { value = 0.3, unit = "m" }
m = { value = 1, unit = "kg" }
[coordinates]
q1 = { unit = "rad", closed_form = "1 + 12_rad/1_s*t" }
q2 = { unit = "rad", nominal = 0.6 }
q3 = { unit = "rad", nominal = 1.5 }
[frames]
crank = { rotations = [["z", "q1"]] }
coupler = { rotations = [["z", "q2"]] }
rocker = { rotations = [["z", "q3"]] }
[points]
B = "a*crank.x + b*coupler.x"
C = "d*N.x + c*rocker.x"
[constraints.configuration]
loop = "B - C"
[bodies]
tip = { centre = "B", mass = "m" }
"#;
    let program = derived(text);
    let start = program.nominal.clone();
    let mut engine = Interpreted::<f64>::new(&program);
    let h = 2e-3;
    for n in 0..300 {
        let q = moved::<f64>(&program, &start, h, n + 1);
        let t = (n + 1) as f64 * h;
        // The rocker's angle by the cosine rule in the triangle of crank pin, coupler and rocker.
        let pin = [0.1 * (1.0 + 12.0 * t).cos(), 0.1 * (1.0 + 12.0 * t).sin()];
        let (x, y) = (pin[0] - 0.3, pin[1]);
        let distance = x.hypot(y);
        let inner = ((0.0625 + distance * distance - 0.09) / (0.5 * distance)).acos();
        let angle = y.atan2(x) - inner;
        let turns = ((q[1] - angle) / std::f64::consts::TAU).round() * std::f64::consts::TAU;
        assert!((q[1] - angle - turns).abs() < 1e-9, "{t}: {} {angle}", q[1]);
        let pivot = engine.rates(t, &q, &[], &[], &mut [0.0; 2], &mut []).expect("lengths fit");
        assert!(0.1 < pivot, "{t}: {pivot}");
    }
}

/// Stages at t + c h, projections at t + h: halving the step divides the error by 2 to the order.
#[test]
fn methods_keep_their_orders_where_time_drives() {
    let program = derived("shaking_table");
    let start = [0.0, 0.17, 0.01, 0.0];
    let exact = moved::<f64>(&program, &start, 2.5e-4, 4000);
    for (method, order, h) in
        [(Method::ExplicitEuler, 1, 1e-3), (Method::SemiImplicitEuler, 1, 1e-3), (Method::Rk4, 4, 8e-3)]
    {
        let error = |h: f64| {
            let found = moved_by::<f64>(method, &program, &start, h, (1.0 / h).round() as usize);
            found.iter().zip(&exact).fold(0.0, |m: f64, (a, b)| m.max((a - b).abs()))
        };
        let observed = (error(h) / error(0.5 * h)).log2();
        assert!((observed - f64::from(order)).abs() < 0.3, "{method:?}: {observed}");
    }
}
