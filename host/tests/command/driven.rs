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
