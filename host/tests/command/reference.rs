//! `eval` and `run` against numbers of other programs: 50-digit references, a servo trajectory.

use crate::support::{eval, smartbed, written};
use serde_json::{Map, Value, json};
use std::path::Path;

fn reference(name: &str) -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/reference").join(name);
    serde_json::from_str(&std::fs::read_to_string(path).expect("a reference")).expect("JSON")
}

/// Names with the numbers of a list.
fn named(names: &Value, numbers: &Value) -> Value {
    let names = names.as_array().expect("names").iter().map(|n| n.as_str().expect("a name").to_owned());
    let numbers = numbers.as_array().expect("numbers").iter().cloned();
    Value::Object(Map::from_iter(names.zip(numbers)))
}

/// Largest difference of `u_dot` relative to the largest acceleration, over all states.
fn worst(found: &Value, expected: &[Value]) -> f64 {
    let states = found["states"].as_array().expect("states");
    assert_eq!(states.len(), expected.len());
    let number = |x: &Value| x.as_f64().expect("a number");
    let mut worst = 0.0_f64;
    for (state, expected) in states.iter().zip(expected) {
        let expected = expected.as_object().expect("named accelerations");
        let largest = expected.values().map(|x| number(x).abs()).fold(0.0, f64::max);
        for (name, value) in expected {
            worst = worst.max((number(&state["u_dot"][name]) - number(value)).abs() / largest);
        }
    }
    worst
}

#[test]
fn accelerations_are_those_of_the_references() {
    for model in ["pendulum3", "fourbar", "tile"] {
        let reference = reference(&format!("{model}.json"));
        let samples = reference["samples"].as_array().expect("samples");
        let states: Vec<Value> = samples
            .iter()
            .map(|s| {
                json!({
                    "q": named(&reference["q_names"], &s["q"]),
                    "u": named(&reference["independent"], &s["u_ind"]),
                    "inputs": named(&reference["input_names"], &s["inputs"]),
                    "parameters": named(&reference["param_names"], &s["params"]),
                })
            })
            .collect();
        let expected: Vec<Value> = samples
            .iter()
            .map(|s| {
                let list = if s["udot"].is_null() { &s["udot_ind"] } else { &s["udot"] };
                named(&reference["independent"], list)
            })
            .collect();
        let text = json!({ "states": states }).to_string();
        // Bounds relative to the largest acceleration: of f64 and of f32.
        for (scalar, bound) in [("f64", 1e-12), ("f32", 2e-6)] {
            let done = eval(&format!("{model}_reference.json"), model, &text, &["--scalar", scalar]);
            assert_eq!(done.status, 0, "{done:?}");
            let error = worst(&done.json(), &expected);
            assert!(error <= bound, "{model} {scalar}: {error:.1e}");
        }
    }
}

#[test]
fn minimal_tile_moves_as_the_reference_servo() {
    let model = |method: &str| {
        let model = format!(
            r#"
format = 1
extends = "{}"
name = "servo"
[parameters]
weight = {{ value = "(3*ms + 3*mc + M)*g", unit = "N" }}
k_servo = {{ value = 900.0, unit = "N/m" }}
d_servo = {{ value = 20.0, unit = "N s/m" }}
[law]
FA = "weight/3 + k_servo*(0.12_m + 0.05_m*sin(2*pi*0.8*t/1_s) - hA) - d_servo*u_hA"
FB = "weight/3 + k_servo*(0.12_m + 0.05_m*sin(2*pi*0.8*t/1_s + 2.1) - hB) - d_servo*u_hB"
FC = "weight/3 + k_servo*(0.12_m + 0.03_m*sin(2*pi*1.3*t/1_s + 4.2) - hC) - d_servo*u_hC"
[start]
hA = 0.12
hB = 0.12
hC = 0.12
"#,
            Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/tile_minimal.toml").display()
        );
        written(&format!("servo_{method}.toml"), &model)
    };
    let reference = &reference("tile_minimal.json")["trajectories"][0];
    let heights = reference["h"].as_array().expect("heights");
    let cases: [(&str, &[&str], f64); 2] = [
        ("dormand-prince", &["--tolerance", "1e-12", "--step", "1e-3"], 1e-9),
        ("rk4", &["--step", "1e-3"], 1e-7),
    ];
    for (method, settings, bound) in cases {
        let model = model(method);
        let mut arguments =
            vec!["run", &model, "--seconds", "5", "--every", "250", "--csv", "-", "--method", method];
        arguments.extend(settings);
        let done = smartbed(&arguments);
        assert_eq!(done.status, 0, "{done:?}");
        let rows: Vec<Vec<f64>> = done
            .out
            .lines()
            .skip(1)
            .map(|row| row.split(',').map(|x| x.parse().expect("a number")).collect())
            .collect();
        assert_eq!(rows.len(), heights.len());
        let mut worst = 0.0_f64;
        for (row, expected) in rows.iter().zip(heights) {
            for (found, expected) in row[1..4].iter().zip(expected.as_array().expect("three")) {
                worst = worst.max((found - expected.as_f64().expect("a number")).abs());
            }
        }
        assert!(worst <= bound, "{method}: {worst:.1e} m");
    }
}
