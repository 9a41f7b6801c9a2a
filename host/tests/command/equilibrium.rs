//! `smartbed equilibrium` against closed forms, published eigenvalues, and the slope of the energy.

use crate::support::{Done, smartbed, written};
use serde_json::Value;

fn found(arguments: &[&str]) -> Value {
    let all: Vec<&str> = [&["equilibrium", "--json"], arguments].concat();
    let done = smartbed(&all);
    assert_eq!(done.status, 0, "{done:?}");
    done.json()
}

fn refused(arguments: &[&str]) -> Done {
    smartbed(&[&["equilibrium"], arguments].concat())
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("a number: {value}"))
}

fn eigenvalues(answer: &Value) -> Vec<[f64; 2]> {
    let modes = answer["modes"].as_array().expect("modes");
    modes.iter().map(|mode| [number(&mode["real"]), number(&mode["imaginary"])]).collect()
}

fn close(x: f64, y: f64, relative: f64, what: &str) {
    assert!((x - y).abs() <= relative * y.abs(), "{what}: {x:e} against {y:e}");
}

/// |det(l^2 M + l C + K)| over the sum of its terms, 2 x 2.
fn determinant([re, im]: [f64; 2], mass: [f64; 4], damping: [f64; 4], stiffness: [f64; 4]) -> f64 {
    let times = |[a, b]: [f64; 2], [c, d]: [f64; 2]| [a * c - b * d, a * d + b * c];
    let square = times([re, im], [re, im]);
    let entry = |i: usize| {
        let sum = |part: usize| square[part] * mass[i] + [re, im][part] * damping[i];
        [sum(0) + stiffness[i], sum(1)]
    };
    let (first, second) = (times(entry(0), entry(3)), times(entry(1), entry(2)));
    let size = |[a, b]: [f64; 2]| a.hypot(b);
    size([first[0] - second[0], first[1] - second[1]]) / (size(first) + size(second))
}

#[test]
fn a_double_pendulum_hangs_and_swings_as_its_matrices_say() {
    let answer = found(&["double_pendulum", "--set", "q1=0.7", "--set", "q2=-0.4"]);
    for name in ["q1", "q2"] {
        assert!(number(&answer["q"][name]).abs() < 1e-12, "{answer}");
    }
    // Slender rods about the downward vertical, in q1 and the relative q2.
    let (m1, m2, l1, l2, c, g) = (1.2, 0.8, 0.5, 0.4, 0.02, 9.81);
    let (own, lower) = (m1 * l1 * l1 / 3.0 + m2 * l1 * l1, m2 * l2 * l2 / 3.0);
    let coupled = m2 * l1 * l2 / 2.0;
    let mass = [own + lower + 2.0 * coupled, lower + coupled, lower + coupled, lower];
    let (upper_weight, lower_weight) = ((m1 / 2.0 + m2) * g * l1, m2 * g * l2 / 2.0);
    let stiffness = [upper_weight + lower_weight, lower_weight, lower_weight, lower_weight];
    let values = eigenvalues(&answer);
    assert_eq!(values.len(), 2, "{answer}");
    for value in values {
        let rest = determinant(value, mass, [0.0, 0.0, 0.0, c], stiffness);
        assert!(rest < 1e-12, "{value:?}: {rest:e}");
    }
    assert!(answer["modes"].as_array().expect("modes").iter().all(|mode| mode["fate"] == "decays"));
}

#[test]
fn a_law_closes_the_loop() {
    let answer = found(&["cart_pole"]);
    // (m_c + m_p) x'' + m_p l/2 q'' = F, m_p l/2 x'' + (I + m_p l^2/4) q'' = m_p g l/2 q, and the law
    // F = 30 q + 5 q' + x + 3 x'.
    let (cart, pole, l, g) = (1.0, 0.2, 0.6, 9.81);
    let arm = pole * l / 2.0;
    let mass = [cart + pole, arm, arm, pole * l * l / 3.0];
    for value in eigenvalues(&answer) {
        let rest = determinant(value, mass, [-3.0, -5.0, 0.0, 0.0], [-1.0, -30.0, 0.0, -arm * g]);
        assert!(rest < 1e-12, "{value:?}: {rest:e}");
    }
    let text = smartbed(&["equilibrium", "cart_pole"]).out;
    assert!(text.contains("stable: every small push dies out"), "{text}");
    // Without its gains the pole falls.
    let fallen = smartbed(&["equilibrium", "cart_pole", "--set", "k_angle=0", "--set", "k_rate=0"]).out;
    assert!(fallen.contains("unstable: a small push grows"), "{fallen}");
}

#[test]
fn the_bicycle_at_5_m_per_s_has_the_published_eigenvalues() {
    // Meijaard, Papadopoulos, Ruina and Schwab 2007, table 2: weave, capsize, castering.
    const PUBLISHED: [[f64; 2]; 3] = [
        [-14.078_389_692_798_22, 0.0],
        [-0.775_341_882_195_85, 4.464_867_713_788_23],
        [-0.322_866_429_004_09, 0.0],
    ];
    let answer = found(&["bicycle", "--hold", "u_thR=-16.666666666666668"]);
    assert_eq!(answer["steady_motion"], true);
    let values = eigenvalues(&answer);
    for (value, published) in values.iter().zip(PUBLISHED) {
        for part in 0..2 {
            assert!((value[part] - published[part]).abs() < 2e-12, "{value:?} against {published:?}");
        }
    }
    // The rest is where it is, how it heads, how far it rolled and how fast: nothing brings these back.
    assert!(values[3..].iter().all(|value| *value == [0.0, 0.0]), "{values:?}");
}

#[test]
fn a_top_precesses_steadily() {
    let answer = found(&["gyroscope", "--hold", "w3=300", "--hold", "theta=1.1"]);
    // m g h = Ia w3 W - (It + m h^2) W^2 cos(theta), W the precession.
    let (m, h, it, ia, g) = (0.3, 0.05, 2e-4, 3e-4, 9.81);
    let (theta, precession) = (number(&answer["q"]["theta"]), number(&answer["outputs"]["precession"]));
    assert_eq!(theta, 1.1);
    let turning = ia * 300.0 * precession - (it + m * h * h) * precession * precession * theta.cos();
    close(turning, m * g * h, 1e-12, "moment of the weight");
    assert!(
        answer["modes"].as_array().expect("modes").iter().all(|mode| mode["fate"] == "persists"),
        "{answer}"
    );
}

#[test]
fn thrusts_that_hold_the_tile_are_slopes_of_its_energy() {
    let place = [("hA", 0.02), ("hB", -0.01), ("hC", 0.005)];
    let start: Vec<String> = place.iter().map(|(name, h)| format!("{name}={h}")).collect();
    let set: Vec<&str> = start.iter().flat_map(|change| ["--set", change.as_str()]).collect();
    let answer = found(&[&["tile", "--trim"], set.as_slice()].concat());
    const STEP: f64 = 1e-4;
    for (leg, thrust) in [("hA", "FA"), ("hB", "FB"), ("hC", "FC")] {
        let at = |change: f64| {
            let q =
                place.map(|(name, h)| format!("\"{name}\": {}", h + if name == leg { change } else { 0.0 }));
            format!("{{\"q\": {{{}}}}}", q.join(", "))
        };
        let states = [-2.0, -1.0, 1.0, 2.0].map(|n| at(n * STEP)).join(", ");
        let file = written(&format!("trim_{leg}.json"), &format!("{{\"states\": [{states}]}}"));
        let energies = smartbed(&["eval", "tile", "--states", &file, "--answers", "energy"]).json();
        let v = |n: usize| number(&energies["states"][n]["energy"]["potential"]);
        let slope = (8.0 * (v(2) - v(1)) - (v(3) - v(0))) / (12.0 * STEP);
        close(number(&answer["inputs"][thrust]), slope, 1e-9, thrust);
    }
}

/// The thrust that holds a rod on a turning hub: m g l sin q less the centrifugal moment m W^2 (a + l sin q) l cos q.
#[test]
fn a_trim_keeps_the_speeds_of_the_start() {
    let text = r#"format = 1
name = "turning"
gravity = "-9.81_m/1_s/1_s*N.z"
[inputs]
T = { unit = "N m" }
[coordinates]
psi = { unit = "deg" }
q = { unit = "deg", range = [-170, 170] }
[frames]
turn = { rotations = [["z", "psi"]] }
rod = { parent = "turn", rotations = [["x", "q"]] }
[points]
P = "0.1_m*turn.y - 0.5_m*rod.z"
[bodies]
bob = { centre = "P", mass = 1 }
[torques]
pin = { frame = "rod", torque = "T*rod.x", reaction = "turn" }
[start]
q = 20
u_psi = 180
"#;
    let file = written("turning.toml", text);
    let (s, c) = 20.0_f64.to_radians().sin_cos();
    for turning in [std::f64::consts::PI, 0.0] {
        let set = format!("u_psi={turning}");
        let answer = found(&[&file, "--trim", "--set", &set]);
        let thrust = 9.81 * 0.5 * s - turning * turning * (0.1 + 0.5 * s) * 0.5 * c;
        close(number(&answer["inputs"]["T"]), thrust, 1e-12, &set);
    }
    let by_start = found(&[&file, "--trim"]);
    assert_eq!(by_start["inputs"], found(&[&file, "--trim", "--set", "u_psi=3.141592653589793"])["inputs"]);
    let falls = refused(&[&file, "--trim", "--set", "u_q=1"]);
    assert!(falls.message().contains("speeds are kept too; set them to 0 by --set"), "{falls:?}");
}

/// An arm on a hub that turns about the vertical.
const WHIRLING: &str = r#"format = 1
name = "whirling"
gravity = "-g*N.y"
[parameters]
g = { value = 9.81, unit = "m/s^2" }
[joints]
yaw = { kind = "revolute", axis = "y", child = "hub" }
sw = { kind = "revolute", axis = "z", parent = "hub", child = "arm", at = "0.1_m*hub.x", damping = 0.05 }
[points]
B = "arm - 0.4_m*arm.y"
[bodies]
b = { centre = "B", frame = "arm", mass = 1, ball = 0.05 }
hub = { centre = "O", frame = "hub", mass = 1, disc = 0.2, axis = "y" }
[outputs]
angle = "sw"
"#;

#[test]
fn a_search_that_ends_between_equilibria_starts_again() {
    let model = written("whirling.toml", WHIRLING);
    // Without the hold of the hub's speed the search ends where the rates are least, not 0.
    let balance = |sw: f64| 36.0 * (0.1 + 0.4 * sw.sin()) * sw.cos() - 9.81 * sw.sin();
    for (start, expected) in [("0", 1.016_38), ("1.2", 1.016_38), ("3", -2.993_016), ("-1.5", -2.0)] {
        let answer = found(&[&model, "--hold", "u_yaw=6", "--set", &format!("sw={start}")]);
        let sw = number(&answer["q"]["sw"]);
        assert!(balance(sw).abs() < 1e-9, "from {start}: {sw}");
        assert!(sw.abs() <= std::f64::consts::PI, "from {start}: {sw}");
        assert!(start == "-1.5" || (sw - expected).abs() < 1e-4, "from {start}: {sw}");
        // Nothing depends on where the hub points.
        assert_eq!(number(&answer["q"]["yaw"]), 0.0, "from {start}");
        assert_eq!(answer["outputs"]["angle"], answer["q"]["sw"]);
    }
}

#[test]
fn an_equilibrium_outside_a_stated_range_gives_way_to_one_inside() {
    let ranged = WHIRLING.replace("damping = 0.05", "damping = 0.05, range = [-3.1, 0]");
    let model = written("whirling_within.toml", &ranged);
    let answer = found(&[&model, "--hold", "u_yaw=6", "--set", "sw=-0.1"]);
    let sw = number(&answer["q"]["sw"]);
    assert!((-3.1..=0.0).contains(&sw), "{sw}");
}

/// A mass on a spring, with what its law and the drag of the second power do.
const HANGING: &str = r#"format = 1
name = "hanging"
gravity = "9.81_N/1_kg*N.x"
[inputs]
F = { unit = "N" }
[coordinates]
x = { unit = "m", range = [-1, 1] }
[points]
P = "x*N.x"
[bodies]
p = { centre = "P", mass = 2 }
[springs]
s = { coordinate = "x", stiffness = 40 }
[forces]
drive = { point = "P", force = "F*N.x - 3_kg/1_m*norm(velocity(P))*velocity(P)" }
[law]
F = "LAW"
"#;

#[test]
fn inputs_are_those_that_the_law_commands() {
    let model = written("hanging.toml", &HANGING.replace("LAW", "5_N - 10_N/1_m*x"));
    let answer = found(&[&model]);
    let x = (2.0 * 9.81 + 5.0) / 50.0;
    close(number(&answer["q"]["x"]), x, 1e-12, "place");
    close(number(&answer["inputs"]["F"]), 5.0 - 10.0 * x, 1e-12, "force of the law");
    // The drag has no slope at rest.
    let [[real, imaginary]] = eigenvalues(&answer)[..] else { panic!("{answer}") };
    assert_eq!(real, 0.0);
    close(imaginary, (50.0_f64 / 2.0).sqrt(), 1e-12, "circular frequency");
    let done =
        smartbed(&["equilibrium", &written("pushed.toml", &HANGING.replace("LAW", "5_N*cos(2_Hz*t)"))]);
    assert_eq!(done.status, 0, "{done:?}");
    assert!(done.err.contains("warning: `drive` changes with time"), "{done:?}");
}

/// Heading, spin and place of a disc change for ever; its lean and speeds do not.
#[test]
fn a_disc_rolls_in_circles_as_its_closed_form_says() {
    let (lean, yaw_rate, r, g) = (0.3_f64, 1.5_f64, 0.5, 9.81);
    let u3 = yaw_rate * lean.cos();
    let hold = [format!("lean={lean}"), format!("u3={u3}")];
    // Moment of momentum about the contact: 6 u3 u2 = u3^2 tan(lean) - 4 g sin(lean)/r.
    let u2 = (u3 * u3 * lean.tan() - 4.0 * g * lean.sin() / r) / (6.0 * u3);
    let answer = found(&["rolling_disc", "--hold", &hold[0], "--hold", &hold[1]]);
    close(number(&answer["speeds"]["u2"]), u2, 1e-12, "spin");
    assert!(number(&answer["speeds"]["u1"]).abs() < 1e-12, "{answer}");
    // With one of the two held the nearest to the start is found, not the disc that stands and turns.
    let near = found(&["rolling_disc", "--hold", &hold[1]]);
    close(number(&near["q"]["lean"]), lean, 1e-2, "lean");
    // A run from there keeps the lean.
    let start: Vec<String> =
        ["u1", "u2", "u3"].iter().map(|u| format!("{u}={}", number(&answer["speeds"][u]))).collect();
    let set: Vec<&str> = start.iter().flat_map(|change| ["--set", change]).collect();
    let run = smartbed(&[&["run", "rolling_disc", "--json"][..], &set].concat()).json();
    close(number(&run["last"]["lean"]), lean, 1e-9, "lean after 10 s");
}

/// A pendulum held by a controller with an integral and a filtered rate, both written as motion constraints.
const CONTROLLED: &str = r#"
format = 1
name = "controlled"
gravity = "-g*N.z"
[parameters]
m = { value = 1, unit = "kg" }
l = { value = 1, unit = "m" }
g = { value = 9.81, unit = "m/s^2" }
[inputs]
M = { unit = "N m" }
[coordinates]
q = { unit = "rad", independent = true }
sum = { unit = "s", independent = true, speed = { independent = false } }
slow = { unit = "rad", independent = true, speed = { independent = false } }
[constraints.motion]
integral = "u_sum - (0.5 - q)"
filter = "u_slow - (u_q*1_s - slow)/0.02_s"
[frames]
rod = { rotations = [["x", "q"]] }
[points]
P = "-l*rod.z"
[bodies]
bob = { centre = "P", mass = "m" }
[torques]
motor = { frame = "rod", torque = "M*N.x" }
[law]
M = "40_J*(0.5 - q) - 5_J/1_s*(slow*1_s) + 30_W*sum"
"#;

#[test]
fn constraints_that_are_memory_have_equilibria() {
    let answer = found(&[&written("controlled.toml", CONTROLLED)]);
    close(number(&answer["q"]["q"]), 0.5, 1e-12, "the angle aimed at");
    close(number(&answer["q"]["sum"]), 9.81 * 0.5_f64.sin() / 30.0, 1e-12, "what holds the weight");
    assert!(number(&answer["q"]["slow"]).abs() < 1e-12, "{answer}");
    assert_eq!(answer["steady_motion"], false, "{answer}");
    // Each eigenvalue is a root of ((s^2 + 40 + g cos q) s + 30) (0.02 s + 1) + 5 s^2.
    let (times, plus) = (
        |a: [f64; 2], b: [f64; 2]| [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]],
        |a: [f64; 2], b: f64| [a[0] + b, a[1]],
    );
    let values = eigenvalues(&answer);
    for &s in &values {
        let stiff = plus(times(s, s), 40.0 + 9.81 * 0.5_f64.cos());
        let held = times(plus(times(stiff, s), 30.0), plus([0.02 * s[0], 0.02 * s[1]], 1.0));
        let rest = [held[0] + 5.0 * times(s, s)[0], held[1] + 5.0 * times(s, s)[1]];
        let size = 1.0 + s[0].hypot(s[1]).powi(3);
        assert!(rest[0].hypot(rest[1]) < 1e-11 * size, "{s:?}: {rest:?}");
    }
    assert_eq!(values.len(), 3, "a pair counts once: {answer}");
    // A motor that turns for ever lets the crank change, on which the pendulum's weight depends.
    let turning = refused(&["driven_pendulum"]);
    assert!(turning.message().contains("no equilibrium was found: the rate of `crank`"), "{turning:?}");
}

#[test]
fn what_cannot_be_is_refused() {
    let turning = refused(&["spinning_top", "--hold", "tip_wz=200"]);
    assert!(turning.message().contains("no motion of it is steady in them"), "{turning:?}");
    // Nothing holds its platform up.
    let tile = refused(&["tile"]);
    assert!(tile.message().contains("no equilibrium was found: the rate of `u_h"), "{tile:?}");
    assert!(tile.message().contains("--trim"), "{tile:?}");
    let driven = refused(&["cam"]);
    assert!(driven.message().contains("a mechanism with prescribed motion has no equilibrium"), "{driven:?}");
    let name = refused(&["bicycle", "--hold", "u_thr=-5"]);
    assert!(name.message().contains("did you mean `u_thR`"), "{name:?}");
    let input = refused(&["cart_pole", "--input", "F=1"]);
    assert!(input.message().contains("follows its law"), "{input:?}");
    let number = refused(&["tile", "--input", "FA=much"]);
    assert!(number.message().contains("expected NAME=NUMBER"), "{number:?}");
    // Nothing can hold a leaning top that does not spin.
    let none = refused(&["gyroscope", "--trim"]);
    assert!(none.message().contains("no input without a law"), "{none:?}");
}

#[test]
fn a_critically_damped_servo_is_stable() {
    let text = "format = 1\nname = \"servo\"\n[parameters]\nJ = { value = 0.5, unit = \"kg m^2\" }\nw = { value = 4, unit = \"rad/s\" }\n\
        [inputs]\nT = { unit = \"N m\" }\n[coordinates]\nq = { unit = \"rad\" }\n[frames]\nA = { rotations = [[\"z\", \"q\"]] }\n\
        [bodies]\nrotor = { centre = \"O\", frame = \"A\", mass = 1, inertia = { Izz = \"J\" } }\n\
        [torques]\nmotor = { frame = \"A\", torque = \"T*N.z\" }\n[law]\nT = \"-J*w*w*q - 2*J*w*u_q\"\n";
    let values = eigenvalues(&found(&[&written("servo.toml", text)]));
    assert_eq!(values.len(), 2);
    // -w twice, in numbers that rounding does not tell apart.
    values
        .iter()
        .for_each(|value| assert!((value[0] + 4.0).abs() < 1e-6 && value[1].abs() < 1e-6, "{values:?}"));
    let unstable = text.replace("- 2*J*w*u_q", "+ 2*J*w*u_q");
    let said = smartbed(&["equilibrium", &written("servo_unstable.toml", &unstable)]);
    assert!(said.out.contains("unstable") && !said.out.contains("eigenvalues of 0"), "{}", said.out);
}

#[test]
fn an_input_that_is_kept_is_no_unknown_of_a_trim() {
    let text = "format = 1\nname = \"lifted\"\ngravity = \"-9.81_N/1_kg*N.z\"\n\
        [inputs]\nT = { unit = \"N m\" }\nT2 = { unit = \"N m\" }\n\
        [joints]\nr = { kind = \"revolute\", axis = \"y\", child = \"A\", drive = \"T + 3*T2\" }\n\
        [points]\nC = \"A + 0.5_m*A.x\"\n[bodies]\na = { centre = \"C\", frame = \"A\", mass = 1, box = [0.1, 0.1, 0.1] }\n";
    let file = written("lifted.toml", text);
    let answer = found(&[&file, "--trim", "--input", "T2=1"]);
    // T + 3 T2 = -m g l/2.
    close(number(&answer["inputs"]["T2"]), 1.0, 0.0, "T2");
    close(number(&answer["inputs"]["T"]), -9.81 * 0.5 - 3.0, 1e-12, "T");
    let done = refused(&[&file, "--trim", "--input", "T2=1", "--input", "T=0"]);
    assert!(
        done.status == 1 && done.err.contains("no input without a law, or --input holds them all"),
        "{done:?}"
    );
}

#[test]
fn the_search_starts_again_where_no_slope_shows_at_the_middle_of_the_ranges() {
    // An arm that stands horizontally at the middle of its range: there its weight's slope is 0.
    let arm = |range: &str| {
        format!(
            "format = 1\nname = \"arm\"\ngravity = \"-9.81_N/1_kg*N.y\"\n[coordinates]\nq = {{ unit = \"rad\"{range} }}\n\
             [frames]\nA = {{ rotations = [[\"z\", \"q\"]] }}\n[points]\nP = \"0.5_m*A.x\"\n[bodies]\np = {{ centre = \"P\", mass = 1 }}\n"
        )
    };
    for (k, range) in [", range = [\"-180*deg\", \"180*deg\"]", ", range = [\"-150*deg\", \"150*deg\"]", ""]
        .iter()
        .enumerate()
    {
        let answer = found(&[&written(&format!("arm_{k}.toml"), &arm(range))]);
        close(number(&answer["q"]["q"]).abs(), std::f64::consts::FRAC_PI_2, 1e-9, range);
    }
}

/// Two masses along x and y, pushed, one of them held by a spring; their speeds mix the rates of x and y.
fn mixed_speeds(push: &str, springs: &str) -> String {
    format!(
        "format = 1\nname = \"mixed\"\n[coordinates]\nx = {{ unit = \"m\", speed = false }}\n\
         y = {{ unit = \"m\", speed = false }}\n[speeds]\n\
         v = {{ unit = \"m/s\", value = \"0.5*q_dot(x) + 0.3*q_dot(y)\" }}\n\
         w = {{ unit = \"m/s\", value = \"q_dot(y)*cos(0.5*y/1_m) - 0.7*q_dot(x)*y/1_m\" }}\n\
         [points]\nP = \"x*N.x\"\nQ = \"y*N.y\"\n\
         [bodies]\na = {{ centre = \"P\", mass = 3 }}\nb = {{ centre = \"Q\", mass = 1 }}\n\
         [forces]\nf = {{ point = \"P\", force = \"20_N*N.x\" }}\ng = {{ point = \"Q\", force = \"{push}*N.y\" }}\n\
         [springs]\ns = {{ coordinate = \"x\", stiffness = \"20_N/1_m\", rest = 0.3, damping = 1 }}\n{springs}"
    )
}

#[test]
fn what_falls_where_the_speeds_depend_on_one_another_is_no_equilibrium() {
    // At y = -1.6316 m v and w are one speed up to a factor; the masses accelerate so that it does not change.
    let free = written("mixed_free.toml", &mixed_speeds("1_N", ""));
    let far = refused(&[&free]);
    assert!(far.message().contains("no equilibrium was found"), "{far:?}");
    let near = refused(&[&free, "--set", "x=1.39", "--set", "y=-1.63"]);
    assert!(near.message().contains("stop being independent of one another"), "{near:?}");
    // A spring along y that balances 1 mm and 1 um away from that place does.
    for away in [1e-3, 1e-6] {
        let y: f64 = -1.631_617_845_8 + away;
        let spring = format!("t = {{ coordinate = \"y\", stiffness = \"10_N/1_m\", rest = {y} }}\n");
        let model = written(&format!("mixed_{away}.toml"), &mixed_speeds("0_N", &spring));
        let answer = found(&[&model, "--set", &format!("y={}", y + 0.2 * away)]);
        close(number(&answer["q"]["y"]), y, 1e-9, "y");
        close(number(&answer["q"]["x"]), 1.3, 1e-9, "x");
    }
}
