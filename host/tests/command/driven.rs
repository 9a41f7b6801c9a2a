//! Driven mechanisms on the command line: the drive's account, states with a time, every form of the equations.

use crate::support::{smartbed, written};
use serde_json::Value;

/// The last row of a run, by name, and the largest imbalance of its ledger.
fn last(arguments: &[&str]) -> (Value, f64) {
    let done = smartbed(arguments);
    assert_eq!(done.status, 0, "{done:?}");
    let answer = done.json();
    let imbalance = answer["imbalance"].as_f64().expect("a number");
    (answer["last"].clone(), imbalance)
}

#[test]
fn the_work_of_a_drive_has_an_account() {
    for model in ["driven_pendulum", "turntable", "cam", "shaking_table"] {
        for method in [["--method=rk4", "--step=5e-5"], ["--method=dormand-prince", "--tolerance=1e-11"]] {
            let (row, imbalance) = last(&["run", model, "--seconds=0.5", "--json", method[0], method[1]]);
            let drive = row["drive"].as_f64().expect("an account");
            assert!(drive.abs() > 1e-4, "{model} {method:?}: {drive}");
            assert!(imbalance < 1e-8, "{model} {method:?}: {imbalance:.1e} J");
        }
    }
    let (row, _) = last(&["run", "fourbar", "--seconds=0.01", "--json"]);
    assert!(row.get("drive").is_none(), "nothing drives it: {row}");
}

#[test]
fn states_have_a_time() {
    let states = "{\"states\": [{\"t\": 0.7, \"q\": {\"sway\": 0.02}, \"u\": {\"u_sway\": 0.1}},\
                  {\"t\": 4.5, \"q\": {\"sway\": -0.01}}, {\"q\": {\"sway\": 0.03}}]}";
    let path = written("driven_states.json", states);
    let done = smartbed(&["eval", "shaking_table", "--states", &path]);
    assert_eq!(done.status, 0, "{done:?}");
    let answer = done.json();
    for (n, t) in [0.7_f64, 4.5, 0.0].into_iter().enumerate() {
        let state = &answer["states"][n];
        let angle = 12.0 * (t - (1.0 - f64::exp(-t)));
        let (s, c) = angle.sin_cos();
        let place = 0.02 * c + (0.15_f64.powi(2) - (0.02 * s).powi(2)).sqrt();
        let off = state["q"]["table"].as_f64().expect("a number") - place;
        assert!(off.abs() < 1e-14, "{t}: {off:e}");
        assert!((state["q"]["crank"].as_f64().expect("a number") - angle).abs() < 1e-12, "{state}");
        assert!(state["constraint_residual"].as_f64().expect("a number") < 1e-15, "{state}");
        assert!(state["drive"].is_number() && state["energy"]["kinetic"].is_number(), "{state}");
        assert_eq!(state.get("t").and_then(Value::as_f64).unwrap_or(0.0), t);
    }
    let wrong = written("driven_wrong.json", "{\"states\": [{\"t\": \"now\", \"q\": {\"sway\": 0}}]}");
    let done = smartbed(&["eval", "shaking_table", "--states", &wrong]);
    assert!(done.message().contains("states[0].t: expected a number of seconds, found \"now\""), "{done:?}");
}

/// A bob on a cart that starts at once, at a time within a step, at its end or at the start of the run.
pub const CART: &str = r#"
format = 1
name = "cart"
dof = 1
[parameters]
l = { value = 2, unit = "m" }
m = { value = 3, unit = "kg" }
v = { value = 0.5, unit = "m/s" }
T = { value = 0.5, unit = "s" }
[coordinates]
cart = { unit = "m", closed_form = "v*max(t - T, 0)" }
theta = { unit = "rad", independent = true }
[frames]
rod = { rotations = [["z", "theta"]] }
[points]
pin = "cart*N.x"
bob = "pin - l*rod.y"
[bodies]
bob = { centre = "bob", mass = "m" }
[run]
seconds = 1
step = 1e-3
"#;

#[test]
fn a_drive_that_starts_at_once_leaves_momenta_and_books_its_work() {
    let path = written("driven_cart.toml", CART);
    // No force acts on the bob across the rod: it stays, and the rod turns at v/l.
    for (start, turned) in [(0.5, -0.125), (0.50037, -0.1249075), (1.0, 0.0)] {
        for method in ["rk4", "euler", "semi-implicit", "dormand-prince"] {
            for scalar in ["f32", "f64"] {
                let set = format!("T={start}");
                let run = ["run", &path, "--json", "--set", &set, "--method", method, "--scalar", scalar];
                let (row, imbalance) = last(&run);
                let number = |name: &str| row[name].as_f64().expect("a number");
                let rounding = if scalar == "f32" { 2e-6 } else { 1e-12 };
                assert!((number("u_theta") + 0.25).abs() < rounding, "{run:?}: {row}");
                assert!((number("theta") - turned).abs() < rounding, "{run:?}: {row}");
                assert!((number("drive") - number("kinetic")).abs() < 1e-2 * rounding, "{run:?}: {row}");
                assert!(imbalance < 1e-2 * rounding, "{run:?}: {imbalance:e}");
            }
        }
    }
    let (row, _) = last(&["run", &path, "--json", "--set", "T=0"]);
    assert_eq!(
        (row["theta"].as_f64(), row["u_theta"].as_f64()),
        (Some(0.0), Some(0.0)),
        "it moves so from the start"
    );
}

/// The pendulum on its cart under gravity: a drive's impulse belongs to the references and to each method's motion, which
/// has its order behind it too.
#[test]
fn reports_pass_a_drive_that_starts_at_once() {
    let heavy = CART.replace("dof = 1", "dof = 1\ngravity = \"-9.81_m/1_s/1_s*N.y\"");
    let path = written("driven_heavy.toml", &heavy);
    let done = smartbed(&["report", &path, "--quick", "--json", "--out", &format!("{path}.report")]);
    let report: serde_json::Value = serde_json::from_str(&done.out).expect("a report");
    let errors = |method: &str| -> Vec<f64> {
        let points = report["points"].as_array().expect("points").iter();
        let own = points.filter(|p| p["method"] == method && p["scalar"] == "f64");
        own.map(|p| p["error"].as_f64().expect("a number")).collect()
    };
    // Each step is a quarter of the one before.
    for (method, order) in [("euler", 1), ("semi-implicit", 2), ("rk4", 4)] {
        let [coarse, fine] = errors(method)[..2] else { panic!("{done:?}") };
        let found = (coarse / fine).log2() / 2.0;
        assert!((found - f64::from(order)).abs() < 0.1, "{method}: {coarse:e}, {fine:e}");
    }
    assert!(errors("dormand-prince").iter().any(|error| *error < 1e-12), "{done:?}");
    // The promised error, against a swing that begins with the speed of the impulse: l theta'' = -g sin(theta).
    let (mut theta, mut u, h) = (0.0_f64, -0.25_f64, 1e-4);
    let a = |theta: f64| -9.81 / 2.0 * theta.sin();
    for _ in 0..5000 {
        let half = u + 0.5 * h * a(theta);
        theta += h * half;
        u = half + 0.5 * h * a(theta);
    }
    for promised in ["1e-4", "1e-6"] {
        let (row, _) = last(&["run", &path, "--json", "--error", promised]);
        let off = (row["theta"].as_f64().expect("a number") - theta).abs();
        assert!(off < promised.parse().expect("a number"), "{promised}: {off:e}");
    }
}

/// The shipped slider-crank, whose guide begins to rise at once. By its piston, which passes dead points, all speeds are
/// state; by its crank one is.
#[test]
fn a_drive_that_starts_at_once_moves_what_passes_dead_points_alike() {
    let shipped = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/slider_crank.toml");
    let text = std::fs::read_to_string(shipped)
        .expect("it is shipped")
        .replace("[frames]", "y = { unit = \"m\", closed_form = \"1_m/1_s*max(t - T1, 0)\" }\n[frames]")
        .replace("[inputs]", "T1 = { value = 0.01, unit = \"s\" }\n[inputs]")
        .replace("S = \"x*N.x\"", "S = \"x*N.x + y*N.y\"");
    let by_piston = text
        .replace("q = { unit = \"rad\", independent = true, nominal", "q = { unit = \"rad\", nominal")
        .replace("x = { unit = \"m\", nominal", "x = { unit = \"m\", independent = true, nominal");
    let [one, all] = [("crank", &text), ("piston", &by_piston)]
        .map(|(name, text)| written(&format!("driven_guide_by_its_{name}.toml"), text));
    // Both start where the piston's coordinate is a round number.
    let state = |path: &str, more: &[&str]| {
        let run = [&["run", path, "--json", "--seconds", "0.1"], more].concat();
        let (row, imbalance) = last(&run);
        (["q", "b", "x", "u_q", "u_b", "u_x"].map(|name| row[name].as_f64().expect("a number")), imbalance)
    };
    let start = ["--set", "q=1.0494404002003752"];
    for at in ["T1=0.01", "T1=0.020371"] {
        let (expected, _) = state(&one, &[&start[..], &["--set", at, "--step", "2.5e-4"]].concat());
        for (method, scalar, near) in [
            ("rk4", "f64", 1e-8),
            ("dormand-prince", "f64", 1e-7),
            ("rk4", "f32", 1e-4),
            ("dormand-prince", "f32", 1e-3),
        ] {
            let run = ["--set", at, "--method", method, "--scalar", scalar];
            let (found, imbalance) = state(&all, &run);
            for (found, expected) in found.iter().zip(expected) {
                let off = (found - expected).abs();
                assert!(off < near * expected.abs().max(1.0), "{run:?}: {found} for {expected}");
            }
            assert!(imbalance < near, "{run:?}: {imbalance:e}");
        }
    }
}

#[test]
fn a_law_that_switches_at_a_time_costs_no_order() {
    let text = r#"
format = 1
name = "push"
dof = 1
[parameters]
m = { value = 1, unit = "kg" }
F = { value = 1, unit = "N" }
T = { value = 0.50037, unit = "s" }
[coordinates]
x = { unit = "m", independent = true }
[inputs]
f = { unit = "N" }
[points]
p = "x*N.x"
[bodies]
p = { centre = "p", mass = "m" }
[forces]
push = { point = "p", force = "f*N.x" }
[law]
f = "F*sign(T - t)"
[run]
seconds = 1
step = 1e-2
"#;
    let path = written("driven_push.toml", text);
    for method in ["rk4", "dormand-prince"] {
        let (row, imbalance) = last(&["run", &path, "--json", "--method", method]);
        let t = 0.50037_f64;
        let exact = [t * t / 2.0 + t * (1.0 - t) - (1.0 - t) * (1.0 - t) / 2.0, 2.0 * t - 1.0];
        let found = [row["x"].as_f64().expect("a number"), row["u_x"].as_f64().expect("a number")];
        assert!(found.iter().zip(exact).all(|(a, b)| (a - b).abs() < 1e-13), "{method}: {found:?} {exact:?}");
        assert!(imbalance < 1e-14, "{method}: {imbalance:e}");
    }
    let terms: Vec<String> = (0..70).map(|k| format!("sign(T + {k}/1000*T - t)")).collect();
    let many = text.replace("sign(T - t)", &format!("({})", terms.join(" + ")));
    let path = written("driven_many.toml", &many);
    assert_eq!(smartbed(&["run", &path]).status, 0);
    let done = smartbed(&["run", &path, "--step", "1"]);
    assert!(
        done.message().contains("have more than 64 kinks (of abs, sign, min, max) in a step"),
        "{done:?}"
    );
}

#[test]
fn commands_that_no_step_follows_are_refused() {
    let path = written("driven_kink.toml", CART);
    let done = smartbed(&["firmware", &path]);
    assert!(done.message().contains("may change its speed at once, where the chip cuts no step"), "{done:?}");
    let jumps = CART.replace("max(t - T, 0)", "sign(t - T)*T");
    let path = written("driven_jump.toml", &jumps);
    let done = smartbed(&["run", &path]);
    assert!(done.message().contains("the command of `cart` jumps at t = 0.500000 s"), "{done:?}");
}

#[test]
fn both_engines_agree_on_driven_models() {
    let states = "{\"states\": [{\"t\": 0.7, \"q\": {\"sway\": 0.02}, \"u\": {\"u_sway\": 0.1}},\
                  {\"t\": 4.5, \"q\": {\"sway\": -0.01}}]}";
    let path = written("driven_engines.json", states);
    for scalar in ["f32", "f64"] {
        let run = |engine: &str| {
            let answers = "--answers=rates,energy,speeds,outputs,projection,drive";
            smartbed(&[
                "eval",
                "shaking_table",
                "--states",
                &path,
                answers,
                "--engine",
                engine,
                "--scalar",
                scalar,
            ])
        };
        let (interpreted, compiled) = (run("interpreter"), run("compiled"));
        assert_eq!((interpreted.status, compiled.status), (0, 0), "{compiled:?}");
        assert_eq!(interpreted.out, compiled.out, "{scalar}");
        let run = |engine: &str| {
            last(&["run", "shaking_table", "--seconds=0.5", "--json", "--engine", engine, "--scalar", scalar])
                .0
        };
        assert_eq!(run("interpreter"), run("compiled"), "{scalar}");
    }
}

#[test]
fn driven_models_have_every_form() {
    let derive = |more: &[&str]| smartbed(&[&["derive"], more].concat());
    let whole = derive(&["shaking_table"]);
    for part in ["pub fn drive(", "fn set_time(", "time: S,"] {
        assert!(whole.out.contains(part), "{part} is missing");
    }
    // Nothing of a pendulum on a crank reads time: its speed is a number.
    assert!(!derive(&["driven_pendulum"]).out.contains("set_time"));
    for form in ["augmented", "kinematic"] {
        assert_eq!(derive(&["shaking_table", "--form", form]).status, 0, "{form}");
    }
    assert_eq!(derive(&["cam", "--form", "minimal", "--answers", "drive"]).status, 0);
    let refused = derive(&["shaking_table", "--form", "minimal"]);
    assert!(refused.message().contains("has dependent coordinates as state (rod, table)"), "{refused:?}");
    let refused = derive(&["fourbar", "--answers", "drive"]);
    assert!(refused.message().contains("--answers drive: `fourbar` has no prescribed motion"), "{refused:?}");
    let refused = derive(&["cam", "--form", "kinematic", "--answers", "drive"]);
    assert!(refused.message().contains("the answer `drive` needs masses"), "{refused:?}");
}

/// A bob on a crank of constant speed under gravity, nothing free: the drive lifts it.
#[test]
fn a_mechanism_without_state_runs_through_time() {
    let model = r#"
format = 1
name = "wheel"
dof = 0
gravity = "-g*N.y"
[parameters]
m = { value = 2, unit = "kg" }
g = { value = 9.81, unit = "m/s^2" }
[coordinates]
q = { unit = "rad", closed_form = "3_Hz*t" }
[frames]
crank = { rotations = [["z", "q"]] }
[points]
P = "0.5_m*crank.x"
[bodies]
bob = { centre = "P", mass = "m" }
"#;
    let path = written("wheel.toml", model);
    for method in ["rk4", "dormand-prince"] {
        let (row, imbalance) =
            last(&["run", &path, "--seconds=0.5", "--method", method, "--step=1e-3", "--json"]);
        // The kinetic energy is constant: the work is the weight's, m g r sin(1.5).
        let lifted = 2.0 * 9.81 * 0.5 * 1.5_f64.sin();
        assert!((row["drive"].as_f64().expect("an account") - lifted).abs() < 1e-9, "{method}: {row}");
        assert!(imbalance < 1e-9, "{method}: {imbalance:.1e} J");
    }
}

/// A bob on a rod whose upper end A moves along x: by a coordinate x, a constraint or the position itself.
fn hung(name: &str, x: &str, a: &str, more: &str) -> String {
    let text = format!(
        r#"
format = 1
name = "hung"
gravity = "-g*N.y"
[parameters]
l = {{ value = 0.5, unit = "m" }}
m = {{ value = 1, unit = "kg" }}
v = {{ value = 0.7, unit = "m/s" }}
g = {{ value = 9.81, unit = "m/s^2" }}
[coordinates]
q = {{ unit = "rad", independent = true }}
{x}
[frames]
rod = {{ rotations = [["z", "q"]] }}
[points]
A = "{a}"
P = "A - l*rod.y"
[bodies]
bob = {{ centre = "P", mass = "m" }}
{more}
[start]
q = 0.3
[run]
seconds = 2
"#
    );
    written(&format!("hung_{name}.toml"), &text)
}

const FOLLOWS: &str = "x = { unit = \"m\", nominal = 0.7, speed = { independent = false } }";

#[test]
fn a_kink_of_the_motion_acts_alike_however_it_is_written() {
    let closed = hung("closed", "x = { unit = \"m\", closed_form = \"v*abs(t - 1_s)\" }", "x*N.x", "");
    let configuration = "[constraints.configuration]\nd = \"x - v*abs(t - 1_s)\"";
    let others = [
        hung("position", "", "v*abs(t - 1_s)*N.x", ""),
        hung("larger", "", "v*max(t - 1_s, 1_s - t)*N.x", ""),
        hung("configuration", "x = { unit = \"m\", nominal = 0.7 }", "x*N.x", configuration),
        hung("motion", FOLLOWS, "x*N.x", "[constraints.motion]\nd = \"u_x - v*sign(t - 1_s)\""),
    ];
    for method in [["--method=rk4", "--step=1e-3"], ["--method=dormand-prince", "--tolerance=1e-13"]] {
        let run = |path: &str| last(&["run", path, "--json", method[0], method[1]]);
        let (expected, _) = run(&closed);
        let number = |row: &Value, name: &str| row[name].as_f64().expect("a number");
        assert!((number(&expected, "q") - 0.357872).abs() < 1e-6, "{expected}");
        for path in &others {
            let (row, imbalance) = run(path);
            for name in ["q", "u_q", "drive"] {
                let off = number(&row, name) - number(&expected, name);
                assert!(off.abs() < 1e-10, "{path} {method:?}: {name} is off by {off:e}");
            }
            assert!(imbalance < 1e-8, "{path} {method:?}: {imbalance:e} J");
        }
    }
    // Where the time itself divides by 0 the accelerations next to it are rounded, but all is finite.
    for (name, x, a, more) in [
        ("quotient", FOLLOWS, "x*N.x", "[constraints.motion]\nd = \"u_x - v*(t - 1_s)/abs(t - 1_s)\""),
        ("root", "", "v*sqrt((t - 1_s).powi(2))*N.x", ""),
        ("product", "", "v*sqrt((t - 1_s)*(t - 1_s))*N.x", ""),
        ("norm", "", "norm(v*(t - 1_s)*N.y)*N.x", ""),
    ] {
        let path = hung(name, x, a, more);
        for method in ["rk4", "dormand-prince"] {
            let (row, imbalance) = last(&["run", &path, "--json", "--method", method]);
            let off = row["q"].as_f64().expect("a number") - 0.357872;
            assert!(off.abs() < 1e-5, "{name} {method}: {row}");
            assert!(imbalance < 1e-5, "{name} {method}: {imbalance:e} J");
        }
    }
    let refused = smartbed(&["firmware", &others[0]]);
    assert!(
        refused.message().contains("may change its speed at once, where the chip cuts no step"),
        "{refused:?}"
    );
}

/// Rows at the moment of a kink have state and command of the same side, whatever the rounding of their time.
#[test]
fn rows_at_a_kink_are_of_one_side() {
    let text = "format = 1\nname = \"kick\"\ngravity = \"-9.81_m/1_s/1_s*N.z\"\n[coordinates]\n\
        x = { unit = \"m\", closed_form = \"0.3_m*abs(3*t/1_s - 0.9)\" }\na = { unit = \"rad\", independent = true }\n\
        [frames]\nA = { rotations = [[\"y\", \"a\"]] }\n[points]\nP = \"x*N.x - 0.3_m*A.z\"\n[bodies]\n\
        p = { centre = \"P\", mass = 1 }\n[run]\nseconds = 0.5\nstep = 0.1\n";
    let kicks = written("kicks.toml", text);
    let often =
        written("often.toml", &text.replace("0.3_m*abs(3*t/1_s - 0.9)", "0.05_m*abs(sin(2*pi*t/0.4_s))"));
    for step in ["0.1", "0.02", "0.01", "1e-3"] {
        for path in [&kicks, &often] {
            let (row, imbalance) =
                last(&["run", path, "--json", "--method", "dormand-prince", "--step", step]);
            assert!(imbalance < 1e-7, "{path} {step}: {imbalance:e} J");
            let off = row["imbalance"].as_f64().expect("a number").abs();
            assert!(off < 1e-7, "{path} {step}: {off:e} J at the end");
        }
        for method in ["dormand-prince", "rk4"] {
            let csv = smartbed(&["run", &kicks, "--csv", "-", "--method", method, "--step", step]).out;
            let mut lines = csv.lines().map(|line| line.split(',').collect::<Vec<_>>());
            let names = lines.next().expect("a header");
            let [t, u_x, u_a] =
                ["t", "u_x", "u_a"].map(|name| names.iter().position(|own| *own == name).expect("a column"));
            let number = |text: &str| text.parse::<f64>().expect("a number");
            let row = lines.find(|row| (number(row[t]) - 0.3).abs() < 1e-9).expect("a row at 0.3 s");
            // Before: at rest below the cart; behind it: 0.3 m u_a has jumped by 2 (0.9 m/s).
            let expected = 3.0 * (number(row[u_x]) + 0.9) / 0.9;
            assert!((number(row[u_a]) - expected).abs() < 1e-9, "{method} {step}: {row:?}");
        }
    }
}

/// A particle that nothing pushes keeps its velocity, whatever its speed multiplies it with.
#[test]
fn however_a_speed_reads_the_time_its_kinks_are_steps_ends_and_its_jumps_refused() {
    let with = |name: &str, factor: &str| {
        let text = format!(
            "format = 1\nname = \"free\"\n[coordinates]\nx = {{ unit = \"m\", independent = true, speed = false }}\n\
             [speeds]\nw = {{ unit = \"m/s\", independent = true, value = \"q_dot(x)*({factor})\" }}\n\
             [points]\nP = \"x*N.x\"\n[bodies]\nb = {{ centre = \"P\", mass = 1 }}\n\
             [start]\nw = 0.5\n[run]\nseconds = 2\n"
        );
        written(name, &text)
    };
    let kink = with("kink.toml", "1 + abs(t/1_s - 1)");
    let (row, _) = last(&["run", &kink, "--json", "--method", "rk4", "--step", "0.03"]);
    let number = |name: &str| row[name].as_f64().expect("a number");
    assert!((number("x") - 0.5).abs() < 1e-8 && (number("w") - 0.5).abs() < 1e-8, "{row}");
    let jump = with("jump.toml", "2 + sign(t - 1_s)");
    let refused = smartbed(&["run", &jump]);
    assert!(refused.message().contains("the speed `w` jumps at t = 1.0"), "{refused:?}");
}

#[test]
fn a_jump_of_what_time_moves_is_refused_wherever_it_is_written() {
    let follows = "x = { unit = \"m\", nominal = -0.1 }";
    let form = |form: &str| format!("x = {{ unit = \"m\", closed_form = \"{form}\" }}");
    let saw = "0.1_m/pi*atan2(sin(2_Hz*t), cos(2_Hz*t))";
    let configuration = "[constraints.configuration]\nd = \"x - 0.1_m*sign(t - 1_s)\"";
    for (name, path, what) in [
        ("position", hung("j1", "", "0.1_m*sign(t - 1_s)*N.x", ""), "the position of `A` jumps at t = 1.0"),
        (
            "quotient",
            hung("j2", "", "0.1_m*(t - 1_s)/abs(t - 1_s)*N.x", ""),
            "the position of `A` jumps at t = 1.0",
        ),
        ("configuration", hung("j3", follows, "x*N.x", configuration), "the constraint `d` jumps at t = 1.0"),
        ("saw", hung("j4", &form(saw), "x*N.x", ""), "the command of `x` jumps at t = 1.570796 s"),
        (
            "pole",
            hung("j5", &form("0.1_m*tan(2_Hz*t)"), "x*N.x", ""),
            "the command of `x` jumps at t = 0.785398 s",
        ),
        (
            "tangent",
            hung("j6", &form("0.1_m*atan2(tan(2_Hz*t), 1)"), "x*N.x", ""),
            "the command of `x` jumps at t = 0.785398 s",
        ),
    ] {
        let done = smartbed(&["run", &path]);
        assert!(done.message().contains(what), "{name}: {done:?}");
    }
    // An angle that passes half a turn nowhere jumps nowhere.
    let path = hung("j7", &form("0.1_m*atan2(sin(2_Hz*t), 2)"), "x*N.x", "");
    assert_eq!(smartbed(&["run", &path]).status, 0);
    let path = hung(
        "j8",
        &FOLLOWS.replace("0.7", "0"),
        "x*N.x",
        "[constraints.motion]\nd = \"u_x - 0.2_m*sign(t - 1_s)*u_q\"",
    );
    let done = smartbed(&["run", &path]);
    assert!(
        done.message().contains("the constraint `d` ties other speeds to one another from t = 1.0"),
        "{done:?}"
    );
}
