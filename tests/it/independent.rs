//! Bodies against trajectories of an independent program: shapes, forces, gas, contact law and integrator written
//! separately in Python with 80-bit numbers (`tests/reference/bodies.py`, which makes `bodies.json`).
//!
//! A wrong force passes any test whose reference is another method with the same forces. It does not pass this one.

use serde_json::Value;
use smartbed::scene::parse;
use smartbed::scene::run::run;

/// Rounding of positions and speeds of order 10 over some hundred steps of stiff springs, with room for the
/// tolerance of the method.
const ROUNDING: f64 = 2e-11;

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("list").iter().map(|x| x.as_f64().expect("number")).collect()
}

fn cases() -> Vec<Value> {
    let path = format!("{}/reference/bodies.json", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).expect("reference file");
    serde_json::from_str::<Vec<Value>>(&text).expect("reference is JSON")
}

/// Largest difference of a state over what is allowed, and of an event's time (s).
fn compare(case: &Value) -> (f64, f64) {
    let (name, scene) = (&case["case"], case["scene"].as_str().expect("a name"));
    let path = format!("{}/../models/scenes/{scene}.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).expect("scene");
    let times = numbers(&case["sample_times"]);
    let given = case["settings"].as_array().expect("settings").iter();
    let mut settings: Vec<String> = given.map(|s| s.as_str().expect("a setting").to_owned()).collect();
    let seconds = times.last().expect("samples");
    let every = (times[0] / 1e-3).round();
    settings.extend(["method=dop853", "tolerance=1e-13", "step=1e-3"].map(str::to_owned));
    settings.extend([format!("T={seconds}"), format!("every={every}")]);
    let scene = parse(scene, &text, &settings).unwrap_or_else(|e| panic!("{name}: {e}"));
    let mut rows = Vec::new();
    let events = run::<f64>(&scene, |row| rows.push(row.clone())).expect("run");
    let (states, agreement) = (case["states"].as_array().expect("states"), numbers(&case["agreement"]));
    assert_eq!(rows.len(), states.len() + 1, "{name}");
    let mut worst = 0.0_f64;
    for ((row, state), agreement) in rows[1..].iter().zip(states).zip(agreement) {
        let found = row.pos.iter().chain(&row.vel).flatten();
        let error = found.zip(numbers(state)).map(|(x, r)| (x - r).abs()).fold(0.0, f64::max);
        worst = worst.max(error / (10.0 * agreement).max(ROUNDING));
    }
    let expected = numbers(&case["events"]);
    assert_eq!(events.len(), expected.len(), "{name}: number of events");
    let late = events.iter().zip(&expected).map(|(e, t)| (e.time - t).abs()).fold(0.0, f64::max);
    (worst, late)
}

#[test]
fn bodies_follow_the_trajectories_of_another_program() {
    let mut seen = Vec::new();
    for case in cases() {
        let (worst, late) = compare(&case);
        println!("{}: {worst:.2} of what is allowed, events to {late:.1e} s", case["case"]);
        assert!(worst <= 1.0 && late <= 1e-12, "{}: {worst:.2}, {late:e} s", case["case"]);
        seen.extend(case["case"].as_str().map(str::to_owned));
    }
    for body in ["cube", "cylinder", "ball", "sheet", "gas"] {
        assert!(seen.iter().any(|name| name == body), "{body} is missing");
    }
}
