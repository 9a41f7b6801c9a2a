//! Runs that went wrong end with a warning, which `--strict` turns into a failure. Calibrations end in time.

use crate::support::{command, smartbed, timed, written};

fn warnings(line: &[&str]) -> Vec<String> {
    let done = smartbed(&[line, &["--json"]].concat());
    assert_eq!(done.status, 0, "{done:?}");
    let warnings = done.json()["warnings"].clone();
    let list: Vec<String> = serde_json::from_value(warnings).expect("a list");
    // They stand on standard error too.
    assert!(list.iter().all(|w| done.err.contains(&format!("warning: {w}"))), "{done:?}");
    list
}

#[test]
fn a_run_in_order_has_nothing_to_tell() {
    let lines: [&[&str]; 5] = [
        &["run", "pendulum"],
        &["run", "fourbar", "--seconds", "2"],
        &["run", "pendulum3", "--seconds", "1", "--scalar", "f32"],
        &["run", "cube", "--seconds", "1"],
        &["run", "single_spring", "--scalar", "f32", "--seconds", "1"],
    ];
    for line in lines {
        assert_eq!(warnings(line), [""; 0], "{line:?}");
        assert_eq!(smartbed(&[line, &["--strict"]].concat()).status, 0, "{line:?}");
    }
}

#[test]
fn energy_that_no_account_explains_is_told_of() {
    // Explicit Euler multiplies the energy of a swing by 1 + (w h)^2 each step.
    let swing = ["run", "pendulum", "--method", "euler", "--step", "1e-2", "--set", "c=0", "--seconds", "5"];
    let scene = ["run", "single_spring", "--method", "symplectic_euler", "--step", "9e-3", "--seconds", "1"];
    for line in [&swing[..], &scene[..]] {
        let found = warnings(line);
        assert!(found.iter().any(|w| w.starts_with("energy: ") && w.contains("in no account")), "{found:?}");
        let strict = smartbed(&[line, &["--strict"]].concat());
        assert_eq!(strict.status, 1, "{strict:?}");
        assert!(strict.err.contains("error: --strict: energy: "), "{strict:?}");
    }
}

/// Gaps that are rounding are closed without an account; what is left of the weights' work is no error.
#[test]
fn boxes_at_rest_have_nothing_to_tell() {
    let stacked = |gap: f64| {
        let part = |name: &str, height: f64| {
            format!(
                "[parts.{name}]\nrigid = \"box\"\nsize = [0.3, 0.3, 0.1]\nmass = 7.5\nstart = {{ height = {height:?} }}\n"
            )
        };
        let pair = |one: &str, other: &str| {
            format!(
                "[[contacts]]\nbetween = [\"{one}\", \"{other}\"]\nimpact = \"stronge\"\nfriction = 0.5\n"
            )
        };
        let [low, high] = [part("low", 0.0), part("high", 0.1 + gap)];
        let text = format!(
            "format = 2\n[parts.ground]\nrigid = \"half_space\"\n{low}{high}{}{}[run]\nseconds = 1\nstep = \"1_ms\"\n",
            pair("low", "ground"),
            pair("high", "low")
        );
        written(&format!("stacked_{gap:e}.toml"), &text)
    };
    for gap in [0.0, 1e-12, -1e-12, 5e-12] {
        let line = ["run", &stacked(gap), "--strict"];
        let done = smartbed(&line);
        assert_eq!(done.status, 0, "{gap:e}: {done:?}");
    }
    // An overlap that the text allows is pushed out without an account: that is told.
    assert_eq!(warnings(&["run", &stacked(-9e-10), "--seconds", "0.1"]).len(), 1);
}

#[test]
fn a_range_that_is_left_is_told_of_once() {
    let line = ["run", "tile", "--seconds", "1"];
    let found = warnings(&line);
    let ranges: Vec<&String> = found.iter().filter(|w| w.contains("left the ranges")).collect();
    assert_eq!(ranges.len(), 1, "{found:?}");
    // It falls g t^2/2 at most.
    assert!(["`hA` = -", "`hB` = -", "`hC` = -"].iter().all(|name| ranges[0].contains(name)), "{found:?}");
    assert_eq!(smartbed(&[&line[..], &["--strict"]].concat()).status, 1);
}

/// A heavy top on its tip; started next to the pole of its Euler angles or let fall without spin, hardly any step is
/// small enough for an error of 1e-13.
const TOP: &str = r#"
format = 1
name = "heavy_top"
dof = 3
gravity = "-g*N.z"
[parameters]
m = { value = 0.5, unit = "kg" }
l = { value = 60, unit = "mm" }
I = { value = 4e-4, unit = "kg m^2" }
J = { value = 3e-4, unit = "kg m^2" }
g = { value = 9.81, unit = "m/s^2" }
[coordinates]
psi = { unit = "rad" }
theta = { unit = "rad", nominal = 0.5, range = [0.01, 1.5] }
phi = { unit = "rad" }
[frames]
top = { rotations = [["z", "psi"], ["x", "theta"], ["z", "phi"]] }
[points]
G = "l*top.z"
[bodies]
top = { centre = "G", frame = "top", mass = "m", inertia = { Ixx = "I", Iyy = "I", Izz = "J" } }
[start]
theta = 0.3
u_phi = 200
[run]
seconds = 10
step = 1e-3
"#;

#[test]
fn dry_friction_that_chatters_is_told_of() {
    let sliding = |friction: &str| {
        format!(
            "format = 1\nname = \"sliding\"\n[coordinates]\nx = {{ unit = \"m\" }}\n[points]\nP = \"x*N.x\"\n\
             [bodies]\nb = {{ centre = \"P\", mass = 2 }}\n[forces]\nfr = {{ point = \"P\", force = \"-6_N*{friction}*N.x\" }}\n\
             [springs]\ns = {{ coordinate = \"x\", stiffness = 50, rest = 0 }}\n[start]\nx = 1\n\
             [run]\nseconds = 3\nstep = 1e-3\nevery = 100\n"
        )
    };
    let rough = written("rough.toml", &sliding("sign(u_x)"));
    let found = warnings(&["run", &rough]);
    let told = |found: &[String]| found.len() == 1 && found[0].contains("in `fr` changed again and again");
    assert!(told(&found), "{found:?}");
    // Its steps are tiny from 2.51 s on.
    let found = warnings(&["run", &rough, "--method", "dormand-prince", "--seconds", "2.515"]);
    assert!(told(&found), "steps of any size: {found:?}");
    let facts = smartbed(&["check", &rough, "--json"]).json();
    let warned = facts["warnings"].to_string();
    assert!(warned.contains("`fr` jumps where a speed changes sign"), "{warned}");
    // While it slides nothing chatters; a smooth law never does.
    assert_eq!(warnings(&["run", &rough, "--seconds", "1"]), [""; 0]);
    let smooth = written("smooth.toml", &sliding("tanh(u_x/0.01_m*1_s)"));
    assert_eq!(warnings(&["run", &smooth]), [""; 0]);
    assert_eq!(smartbed(&["check", &smooth, "--json"]).json()["warnings"].to_string(), "[]");
}

#[test]
fn calibrations_end_in_time() {
    let top = written("heavy_top.toml", TOP);
    for start in [["theta=1e-6", "u_phi=300"], ["theta=0.3", "u_phi=0"], ["theta=0.3", "u_phi=200"]] {
        let line = ["run", &top, "--error=1e-6", "--set", start[0], "--set", start[1]];
        let (done, seconds) = timed(&command(&line));
        assert!(seconds < 120.0, "{start:?}: {seconds} s of computing");
        let said = [
            "picked --method",
            "the reference solution was not finished in time",
            "not enough",
            "not met",
            "singular",
        ];
        assert!(said.iter().any(|words| done.err.contains(words)), "{start:?}: {done:?}");
    }
}
