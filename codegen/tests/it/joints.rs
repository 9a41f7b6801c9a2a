//! Joint keywords: each gives the motion of the same mechanism written by hand, or of a closed form.

use crate::draw::Draw;
use crate::models::shipped;
use smartbed_codegen::model::Model;
use smartbed_codegen::{Interpreted, ParameterChoice, Program, model, program};
use smartbed_runtime::mechanism::Mechanism;

fn read(text: &str) -> Model {
    let text = format!("format = 1\nname = \"test\"\n{text}");
    model::parse("test.toml", &text).unwrap_or_else(|found| panic!("{found}"))
}

fn derived(model: &Model) -> Program {
    program::derive(model, &ParameterChoice::default()).unwrap_or_else(|found| panic!("{found}"))
}

/// Results of the equations by name: q' under the coordinate, u' under the speed.
fn rates(program: &Program, value: &dyn Fn(&str) -> f64) -> Vec<(String, f64)> {
    let mut mechanism = Interpreted::<f64>::new(program);
    let q: Vec<f64> = program.q.iter().map(|q| value(&q.name)).collect();
    let u: Vec<f64> = program.u.iter().map(|u| value(&u.name)).collect();
    let inputs: Vec<f64> = program.inputs.iter().map(|i| value(&i.name)).collect();
    let (mut q_dot, mut u_dot) = (vec![0.0; q.len()], vec![0.0; u.len()]);
    mechanism.rates(0.0, &q, &u, &inputs, &mut q_dot, &mut u_dot).expect("lengths fit");
    let names = program.q.iter().map(|q| q.name.clone()).chain(program.u.iter().map(|u| u.name.clone()));
    names.zip(q_dot.into_iter().chain(u_dot)).collect()
}

/// Compares two models at random states; `named` translates a joint's name into that of the hand-written model.
/// Quaternions of such a state are of length 1.
fn agree(words: &Model, hand: &Model, named: &dyn Fn(&str) -> String, quaternions: &[[&str; 4]]) {
    let (words, hand) = (derived(words), derived(hand));
    let mut draw = Draw(7);
    let all = hand
        .q
        .iter()
        .chain(&hand.u)
        .map(|s| s.name.clone())
        .chain(hand.inputs.iter().map(|i| i.name.clone()));
    let all: Vec<String> = all.collect();
    let mut worst = 0.0_f64;
    for _ in 0..50 {
        let mut state: Vec<(String, f64)> = all.iter().map(|name| (name.clone(), draw.next())).collect();
        for quaternion in quaternions {
            let is_part = |name: &String| quaternion.contains(&name.as_str());
            let length = state.iter().filter(|(n, _)| is_part(n)).map(|(_, x)| x * x).sum::<f64>().sqrt();
            state.iter_mut().filter(|(n, _)| is_part(n)).for_each(|(_, x)| *x /= length);
        }
        let at = |name: &str| state.iter().find(|(n, _)| n == name).unwrap_or_else(|| panic!("no {name}")).1;
        let expected = rates(&hand, &at);
        let found = rates(&words, &|name| at(&named(name)));
        assert_eq!(found.len(), expected.len());
        let size = expected.iter().fold(1.0_f64, |m, (_, x)| m.max(x.abs()));
        for (name, x) in found {
            let name = named(&name);
            let y = expected.iter().find(|(n, _)| *n == name).unwrap_or_else(|| panic!("no {name}")).1;
            worst = worst.max((x - y).abs() / size);
        }
    }
    println!(
        "{}: {worst:.1e}; operations {} by words, {} by hand",
        hand.name,
        words.operations(),
        hand.operations()
    );
    assert!(worst <= 1e-12, "{}: {worst:e}", hand.name);
}

const CHAIN: &str = r#"
gravity = "-9.81_N/1_kg*N.z"
[parameters]
k = { value = 3, unit = "N m" }
d = { value = 0.2, unit = "N m s" }
m = { value = 2, unit = "kg" }
I = { value = 0.03, unit = "kg m^2" }
[inputs]
T = { unit = "N m" }
F = { unit = "N" }
M = { unit = "N m" }
[bodies]
turret = { centre = "Ct", mass = "m", frame = "turret", inertia = { Ixx = "I", Iyy = "2*I", Izz = "3*I", Ixy = "I/4" } }
slide = { centre = "Cs", mass = "m", frame = "slide", inertia = { Ixx = "I", Iyy = "2*I", Izz = "3*I" } }
cross = { centre = "Cc", mass = "2*m", frame = "cross", inertia = { Ixx = "I", Iyy = "2*I", Izz = "3*I" } }
tool = { centre = "Co", mass = "m/2", frame = "tool", inertia = { Ixx = "I", Iyy = "2*I", Izz = "2*I" } }
[points]
Ct = "turret + 0.1_m*turret.x"
Cs = "slide + 0.1_m*slide.y - 0.05_m*slide.z"
Cc = "cross + 0.1_m*cross.x + 0.2_m*cross.y"
Co = "tool + 0.05_m*tool.y"
"#;

#[test]
fn a_chain_of_joints_is_the_chain_of_frames_and_points() {
    let words = r#"
[joints]
q1 = { kind = "revolute", axis = "z", child = "turret", at = "0.3_m*N.z", stiffness = "k", rest = 0.2, damping = "d", drive = "T" }
q2 = { kind = "prismatic", axis = [0, 0.6, 0.8], parent = "turret", child = "slide", at = "turret + 0.2_m*turret.x", turned = [["x", "20*deg"]], drive = "F", speed = "v2" }
q3 = { kind = "universal", axes = ["x", "-y"], parent = "slide", child = "cross", at = "slide + 0.1_m*slide.x", turned = [["z", "40*deg"]], drive = ["M", 2] }
q4 = { kind = "cylindrical", axis = "-x", parent = "cross", child = "tool", at = "cross + 0.3_m*cross.x", damping = ["3_N*1_s/1_m", "d"], drive = [1, "M"] }
"#;
    let hand = r#"
[coordinates]
q1 = { unit = "rad" }
q2 = { unit = "m", speed = "v2" }
q3_first = { unit = "rad" }
q3_second = { unit = "rad" }
q4_slide = { unit = "m" }
q4_turn = { unit = "rad" }
[frames]
turret = { rotations = [["z", "q1"]] }
slide = { parent = "turret", rotations = [["x", "20*deg"]] }
yoke = { parent = "slide", rotations = [["z", "40*deg"], ["x", "q3_first"]] }
cross = { parent = "yoke", rotations = [["y", "-q3_second"]] }
tool = { parent = "cross", rotations = [["x", "-q4_turn"]] }
[points]
turret = "0.3_m*N.z"
hold = "turret + 0.2_m*turret.x"
slide = "hold + q2*(0.6*slide.y + 0.8*slide.z)"
cross = "slide + 0.1_m*slide.x"
grip = "cross + 0.3_m*cross.x"
tool = "grip - q4_slide*cross.x"
[springs]
q1 = { coordinate = "q1", stiffness = "k", rest = 0.2, damping = "d" }
q4_slide = { coordinate = "q4_slide", stiffness = 0, damping = "3_N*1_s/1_m" }
q4_turn = { coordinate = "q4_turn", stiffness = 0, damping = "d" }
[torques]
T = { frame = "turret", torque = "T*N.z" }
first = { frame = "yoke", torque = "M*yoke.x", reaction = "slide" }
second = { frame = "cross", torque = "-2_J*yoke.y", reaction = "yoke" }
turn = { frame = "tool", torque = "-M*tool.x", reaction = "cross" }
[forces]
F = { point = "slide", force = "F*(0.6*slide.y + 0.8*slide.z)", reaction = "hold" }
push = { point = "tool", force = "-1_N*cross.x", reaction = "grip" }
"#;
    agree(&read(&format!("{CHAIN}{words}")), &read(&hand_first(hand)), &str::to_owned, &[]);
}

/// The hand-written entries with those that both have, points of both in one table.
fn hand_first(hand: &str) -> String {
    let (before, points) = CHAIN.split_once("[points]").expect("points");
    let hand = hand.replace("[points]", &format!("[points]{points}"));
    format!("{before}{hand}")
}

#[test]
fn a_free_joint_is_the_free_body_in_euler_parameters() {
    let words = read(
        r#"
[parameters]
m = { value = 2, unit = "kg" }
I1 = { value = 1, unit = "kg m^2" }
I2 = { value = 2, unit = "kg m^2" }
I3 = { value = 3, unit = "kg m^2" }
[joints]
f = { kind = "free", child = "body" }
[bodies]
body = { centre = "body", frame = "body", mass = "m", inertia = { Ixx = "I1", Iyy = "I2", Izz = "I3" } }
"#,
    );
    let named = |name: &str| {
        let name = name.replace("f_", "");
        match name.as_str() {
            "wx" => "w1".to_owned(),
            "wy" => "w2".to_owned(),
            "wz" => "w3".to_owned(),
            _ => name,
        }
    };
    agree(&words, &shipped("free_body"), &named, &[["e0", "e1", "e2", "e3"]]);
}

#[test]
fn a_rolling_disc_is_the_disc_by_hand() {
    let words = read(
        r#"
gravity = "-g*N.z"
[parameters]
m = { value = 1, unit = "kg" }
r = { value = 0.5, unit = "m" }
g = { value = 9.81, unit = "m/s^2" }
[joints]
d = { kind = "rolling_disc", child = "disc", radius = "r", nominal = [0, 0, 0, 0, 0], range = [[-1, 1], [-1, 1], [-1, 1], [-1.2, 1.2], [-1, 1]] }
[bodies]
disc = { centre = "disc", frame = "disc", mass = "m", disc = "r", axis = "y" }
"#,
    );
    let named = |name: &str| match name {
        "d_wx" => "u1".to_owned(),
        "d_wy" => "u2".to_owned(),
        "d_wz" => "u3".to_owned(),
        _ => name.replace("d_", ""),
    };
    agree(&words, &shipped("rolling_disc"), &named, &[]);
}

/// The ball of `models/turntable.toml` on a table that is a link: a joint in closed form turns it.
#[test]
fn a_ball_rolls_on_a_link_that_turns() {
    let words = read(
        r#"
[parameters]
m = { value = 0.5, unit = "kg" }
R = { value = 0.1, unit = "m" }
W = { value = 1.4, unit = "rad/s" }
[frames]
table = { rotations = [["z", "W*t"]] }
[joints]
b = { kind = "rolling_ball", parent = "table", child = "ball", at = "0_m*table.x", radius = "R" }
[bodies]
ball = { centre = "ball", frame = "ball", mass = "m", ball = "R" }
[outputs]
x = "dot(ball, N.x)"
"#,
    );
    let program = derived(&words);
    let mut draw = Draw(3);
    for _ in 0..50 {
        let e: [f64; 4] = std::array::from_fn(|_| draw.next());
        let length = e.iter().map(|x| x * x).sum::<f64>().sqrt();
        let e = e.map(|x| x / length);
        let (x, y) = (draw.next(), draw.next());
        let w: [f64; 3] = std::array::from_fn(|_| draw.next());
        let value = |name: &str| match name {
            "b_x" => x,
            "b_y" => y,
            "b_e0" => e[0],
            "b_e1" => e[1],
            "b_e2" => e[2],
            "b_e3" => e[3],
            "b_wx" => w[0],
            "b_wy" => w[1],
            "b_wz" => w[2],
            other => panic!("{other}"),
        };
        let rates = rates(&program, &value);
        let at = |name: &str| rates.iter().find(|(n, _)| n == name).expect("a rate").1;
        // The speeds are relative to the table, which has turned by 0 at t = 0 and goes on at W about z.
        let [a, b, c, d] = e;
        let rotate = |v: [f64; 3]| -> [f64; 3] {
            let m = [
                [a * a + b * b - c * c - d * d, 2.0 * (b * c - a * d), 2.0 * (b * d + a * c)],
                [2.0 * (b * c + a * d), a * a - b * b + c * c - d * d, 2.0 * (c * d - a * b)],
                [2.0 * (b * d - a * c), 2.0 * (c * d + a * b), a * a - b * b - c * c + d * d],
            ];
            m.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
        };
        let (table, radius) = (1.4, 0.1);
        let relative = rotate(w);
        // Rolling on the table, seen from it: x' = w_y R, y' = -w_x R.
        assert!((at("b_x") - relative[1] * radius).abs() < 1e-12);
        assert!((at("b_y") + relative[0] * radius).abs() < 1e-12);
        // Absolute: v = v_rel + W x r; the acceleration of the centre is 2/7 W (z x v), and the spin about z stays.
        let v = [relative[1] * radius - table * y, -relative[0] * radius + table * x];
        let acceleration = [-table * v[1] * 2.0 / 7.0, table * v[0] * 2.0 / 7.0];
        // In the table's axes: x'' = a + 2 W y' + W^2 x and the like.
        let (vx, vy) = (relative[1] * radius, -relative[0] * radius);
        let ax = acceleration[0] + 2.0 * table * vy + table * table * x;
        let ay = acceleration[1] - 2.0 * table * vx + table * table * y;
        // d(relative)/dt along the table's axes; u' is along the ball's: rotate(u') = that, as w x w = 0.
        let angular = rotate([at("b_wx"), at("b_wy"), at("b_wz")]);
        assert!((angular[1] * radius - ax).abs() < 1e-12, "{} against {ax}", angular[1] * radius);
        assert!((-angular[0] * radius - ay).abs() < 1e-12, "{} against {ay}", -angular[0] * radius);
        assert!(angular[2].abs() < 1e-12, "{angular:?}");
    }
}

/// Chaplygin's sleigh: v' = a w^2, w' = -m a v w/(I + m a^2), at any heading.
#[test]
fn a_knife_edge_is_chaplygins_sleigh_at_any_heading() {
    let words = read(
        r#"
dof = 2
[joints]
s = { kind = "knife_edge", child = "sleigh" }
[points]
C = "sleigh + 0.3_m*sleigh.x"
[bodies]
sleigh = { centre = "C", frame = "sleigh", mass = 2, inertia = { Izz = 0.5 } }
"#,
    );
    let program = derived(&words);
    for heading in [0.0, 0.7, std::f64::consts::FRAC_PI_2, 3.0, -2.0] {
        let (v, w) = (1.5, -0.8);
        let value = |name: &str| match name {
            "s_yaw" => heading,
            "s_ahead" => v,
            "u_s_yaw" => w,
            _ => 0.1,
        };
        let rates = rates(&program, &value);
        let at = |name: &str| rates.iter().find(|(n, _)| n == name).expect("a rate").1;
        let (m, a, i) = (2.0, 0.3, 0.5);
        assert!((at("s_ahead") - a * w * w).abs() < 1e-14);
        assert!((at("u_s_yaw") + m * a * v * w / (i + m * a * a)).abs() < 1e-14);
        assert!(
            (at("s_x") - v * heading.cos()).abs() < 1e-14 && (at("s_y") - v * heading.sin()).abs() < 1e-14
        );
    }
}

/// A physical pendulum about a slanted axis n: I q'' = n . (r x m g), r turned by Rodrigues' formula.
#[test]
fn a_hinge_about_any_axis_is_a_physical_pendulum() {
    let words = read(
        r#"
dof = 1
gravity = "-9.81_N/1_kg*N.z"
[joints]
q = { kind = "revolute", axis = [1, -2, 2], child = "door" }
[points]
C = "door + 0.4_m*door.x + 0.1_m*door.y - 0.2_m*door.z"
[bodies]
door = { centre = "C", mass = 3 }
"#,
    );
    let program = derived(&words);
    let n = [1.0 / 3.0, -2.0 / 3.0, 2.0 / 3.0];
    let r = [0.4, 0.1, -0.2];
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let dot = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let arm = cross(n, r);
    for q in [0.0, 0.4, 2.0, -1.3] {
        let along = dot(n, r) * (1.0 - f64::cos(q));
        let turned: [f64; 3] = std::array::from_fn(|i| r[i] * q.cos() + arm[i] * q.sin() + n[i] * along);
        let torque = dot(n, cross(turned, [0.0, 0.0, -9.81]));
        let expected = torque / dot(arm, arm);
        let rates = rates(&program, &|name| if name == "q" { q } else { 0.3 });
        assert!((rates[1].1 - expected).abs() < 1e-13, "{} against {expected}", rates[1].1);
    }
}

/// Planar and spherical joints on a link that moves, by hand.
#[test]
fn planar_and_spherical_joints_are_those_by_hand() {
    let both = r#"
gravity = "-9.81_N/1_kg*N.y"
[bodies]
cart = { centre = "cart", mass = 2, frame = "cart", inertia = { Ixx = 0.1, Iyy = 0.2, Izz = 0.3 } }
ball = { centre = "C", mass = 1, frame = "ball", inertia = { Ixx = 0.1, Iyy = 0.2, Izz = 0.25, Ixz = 0.01 } }
[points]
C = "ball + 0.2_m*ball.x + 0.1_m*ball.y"
"#;
    let words = r#"
[joints]
p = { kind = "planar", axis = "y", child = "cart", turned = [["x", "30*deg"]], damping = ["1_N*1_s/1_m", 0, 0] }
b = { kind = "spherical", parent = "cart", child = "ball", at = "cart + 0.5_m*cart.z" }
"#;
    let hand = r#"
cart = "p_x*tilted.x + p_z*tilted.z"
ball = "cart + 0.5_m*cart.z"
[coordinates]
p_x = { unit = "m", independent = true }
p_z = { unit = "m", independent = true }
p_turn = { unit = "rad", independent = true }
b_e0 = { unit = "1", nominal = 1, speed = false }
b_e1 = { unit = "1", independent = true, speed = false }
b_e2 = { unit = "1", independent = true, speed = false }
b_e3 = { unit = "1", independent = true, speed = false }
[speeds]
b_wx = { unit = "rad/s", independent = true, value = "2*(b_e0*q_dot(b_e1) - b_e1*q_dot(b_e0) + b_e3*q_dot(b_e2) - b_e2*q_dot(b_e3))" }
b_wy = { unit = "rad/s", independent = true, value = "2*(b_e0*q_dot(b_e2) - b_e2*q_dot(b_e0) + b_e1*q_dot(b_e3) - b_e3*q_dot(b_e1))" }
b_wz = { unit = "rad/s", independent = true, value = "2*(b_e0*q_dot(b_e3) - b_e3*q_dot(b_e0) + b_e2*q_dot(b_e1) - b_e1*q_dot(b_e2))" }
w0 = { unit = "rad/s", independent = false, value = "b_e0*q_dot(b_e0) + b_e1*q_dot(b_e1) + b_e2*q_dot(b_e2) + b_e3*q_dot(b_e3)" }
[constraints.configuration]
unit = "b_e0.powi(2) + b_e1.powi(2) + b_e2.powi(2) + b_e3.powi(2) - 1"
[frames]
tilted = { rotations = [["x", "30*deg"]] }
cart = { parent = "tilted", rotations = [["y", "p_turn"]] }
[frames.ball]
x = "(1 - 2*b_e2.powi(2) - 2*b_e3.powi(2))*cart.x + 2*(b_e1*b_e2 + b_e0*b_e3)*cart.y + 2*(b_e1*b_e3 - b_e0*b_e2)*cart.z"
y = "2*(b_e1*b_e2 - b_e0*b_e3)*cart.x + (1 - 2*b_e1.powi(2) - 2*b_e3.powi(2))*cart.y + 2*(b_e2*b_e3 + b_e0*b_e1)*cart.z"
[springs]
slip = { coordinate = "p_x", stiffness = 0, damping = "1_N*1_s/1_m" }
"#;
    let quaternion = [["b_e0", "b_e1", "b_e2", "b_e3"]];
    agree(&read(&format!("{both}{words}")), &read(&format!("{both}{hand}")), &str::to_owned, &quaternion);
}

/// Entries that joints create are not reported as unused, and have the names stated in the manual.
#[test]
fn names_follow_the_joint() {
    let model = read(
        r#"
[joints]
a = { kind = "planar", axis = "x", child = "plate" }
b = { kind = "revolute", axis = "y", parent = "plate", child = "arm", at = "plate + 1_m*plate.x", range = ["-90*deg", 1], unit = "rad", doc = "elbow" }
[bodies]
m = { centre = "arm", mass = 1 }
"#,
    );
    let names: Vec<&str> = model.coordinates.iter().map(|c| c.name.as_str()).collect();
    assert_eq!(names, ["a_y", "a_z", "a_turn", "b"]);
    let speeds: Vec<&str> = model.speeds.iter().map(|s| s.name.as_str()).collect();
    assert_eq!(speeds, ["u_a_y", "u_a_z", "u_a_turn", "u_b"]);
    let elbow = model.coordinates.iter().last().expect("the elbow");
    assert!((elbow.range.0 + std::f64::consts::FRAC_PI_2).abs() < 1e-15 && elbow.doc == "elbow");
    assert!(model.warnings().items.is_empty(), "{}", model.warnings());
}

/// Mass and moments of inertia about x, y, z of a free body, from its response to a force and torques.
fn mass_and_moments(shape: &str) -> [f64; 4] {
    let text = format!(
        r#"
[inputs]
F = {{ unit = "N" }}
T = {{ unit = "N m" }}
[joints]
f = {{ kind = "free", child = "body" }}
[bodies]
body = {{ centre = "body", frame = "body", {shape} }}
[forces]
f = {{ point = "body", force = "F*N.x" }}
[torques]
t = {{ frame = "body", torque = "T*(body.x + body.y + body.z)" }}
"#
    );
    let found =
        rates(&derived(&read(&text)), &|name| f64::from(u8::from(["F", "T", "f_e0"].contains(&name))));
    ["u_f_x", "f_wx", "f_wy", "f_wz"]
        .map(|name| 1.0 / found.iter().find(|(n, _)| n == name).expect("a rate").1)
}

/// Mass, moment along and moment across the axis of a solid of revolution, cut into thin discs.
fn turned_solid(density: f64, half: f64, radii: impl Fn(f64) -> (f64, f64)) -> [f64; 3] {
    let (slices, mut sum) = (200_000, [0.0; 3]);
    let thick = 2.0 * half / f64::from(slices);
    for i in 0..slices {
        let z = -half + (f64::from(i) + 0.5) * thick;
        let (outer, inner) = radii(z);
        let power = |n: i32| outer.powi(n) - inner.powi(n);
        let area = std::f64::consts::PI * power(2) * density * thick;
        let fourth = std::f64::consts::FRAC_PI_4 * power(4) * density * thick;
        sum = [sum[0] + area, sum[1] + 2.0 * fourth, sum[2] + fourth + area * z * z];
    }
    sum
}

/// Against sums over thin discs; where nothing is that thick, against the handbook's numbers.
#[test]
fn bodies_by_shape_have_the_mass_and_inertia_of_their_parts() {
    let ball = |r: f64, z: f64| (r * r - z * z).max(0.0).sqrt();
    let cap = |z: f64| if z.abs() <= 0.15 { 0.2 } else { ball(0.2, z.abs() - 0.15) };
    let rounds = [
        ("ball = 0.2", turned_solid(800.0, 0.2, |z| (ball(0.2, z), 0.0))),
        ("shell = [0.2, 0.15]", turned_solid(800.0, 0.2, |z| (ball(0.2, z), ball(0.15, z)))),
        ("cylinder = [0.2, 0.3]", turned_solid(800.0, 0.15, |_| (0.2, 0.0))),
        ("tube = [0.2, 0.15, 0.3]", turned_solid(800.0, 0.15, |_| (0.2, 0.15))),
        ("capsule = [0.2, 0.3]", turned_solid(800.0, 0.35, |z| (cap(z), 0.0))),
    ];
    let near = |found: [f64; 4], expected: [f64; 4], tolerance: f64, what: &str| {
        for (x, y) in found.into_iter().zip(expected) {
            assert!((x - y).abs() <= tolerance * y, "{what}: {found:?} against {expected:?}");
        }
    };
    for (shape, [mass, along, across]) in rounds {
        for (axis, moments) in
            [("x", [along, across, across]), ("y", [across, along, across]), ("z", [across, across, along])]
        {
            let found = mass_and_moments(&format!("{shape}, axis = \"{axis}\", density = 800"));
            near(found, [mass, moments[0], moments[1], moments[2]], 1e-6, shape);
        }
        let found = mass_and_moments(&format!("{shape}, mass = 2"));
        near(
            found,
            [2.0, across, across, along].map(|x| if x == 2.0 { x } else { 2.0 * x / mass }),
            1e-6,
            shape,
        );
    }
    // 2 kg/m^2 on a disc of 0.5 m; edges of 0.1, 0.2 and 0.4 m.
    let disc = std::f64::consts::PI * 0.5;
    near(
        mass_and_moments("disc = 0.5, density = 2"),
        [disc, disc / 16.0, disc / 16.0, disc / 8.0],
        1e-14,
        "disc",
    );
    let edges = [12.0, 0.2, 0.17, 0.05];
    near(mass_and_moments("box = [0.1, 0.2, 0.4], density = 1500"), edges, 1e-14, "box");
}
