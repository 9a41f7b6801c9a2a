//! docs/json.schema.json: the output of commands with `--json` has exactly the keys that it describes.
//!
//! The check implements the keywords of JSON Schema (2020-12) that the file uses, and fails at any other.

use crate::support::{file, smartbed, written};
use serde_json::Value;
use smartbed::firmware::Arguments;
use smartbed::firmware::emulator::Count;
use smartbed::firmware::equations::Equations;
use smartbed::firmware::image::rules::{Finding, Rule};
use smartbed::firmware::image::size::Size;
use smartbed::firmware::image::stack::Stack;
use smartbed::firmware::report::{Outcome, Report};
use smartbed::firmware::settings::Settings;
use std::path::Path;

fn schema() -> Value {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/json.schema.json");
    serde_json::from_str(&std::fs::read_to_string(path).expect("the schema")).expect("JSON")
}

/// Fails if a value does not match the schema's definition of that name.
pub fn holds(name: &str, value: &Value) {
    let schema = schema();
    let mut faults = Vec::new();
    judge(&schema["$defs"][name], value, name, &mut faults);
    assert!(!schema["$defs"][name].is_null() && faults.is_empty(), "{faults:?}\n{value}");
}

fn judge(rule: &Value, value: &Value, at: &str, faults: &mut Vec<String>) {
    const KNOWN: [&str; 6] =
        ["type", "properties", "required", "additionalProperties", "items", "description"];
    let Some(words) = rule.as_object() else { return faults.push(format!("{at}: no rule")) };
    for word in words.keys().filter(|word| !KNOWN.contains(&word.as_str())) {
        faults.push(format!("{at}: the check does not know `{word}`"));
    }
    let is = |kind: &Value| match kind.as_str() {
        Some("object") => value.is_object(),
        Some("array") => value.is_array(),
        Some("string") => value.is_string(),
        Some("boolean") => value.is_boolean(),
        Some("null") => value.is_null(),
        Some("integer") => value.is_i64() || value.is_u64(),
        Some("number") => value.is_number(),
        _ => false,
    };
    let fits = rule["type"].as_array().map_or_else(|| is(&rule["type"]), |kinds| kinds.iter().any(is));
    if !fits {
        faults.push(format!("{at}: {value} is not {}", rule["type"]));
    }
    for (n, item) in value.as_array().into_iter().flatten().enumerate() {
        if !rule["items"].is_null() {
            judge(&rule["items"], item, &format!("{at}[{n}]"), faults);
        }
    }
    let Some(object) = value.as_object() else { return };
    for key in rule["required"].as_array().into_iter().flatten().filter_map(Value::as_str) {
        if !object.contains_key(key) {
            faults.push(format!("{at}: `{key}` is missing"));
        }
    }
    for (key, value) in object {
        let at = format!("{at}.{key}");
        match (&rule["properties"][key], &rule["additionalProperties"]) {
            (Value::Null, Value::Bool(false)) => faults.push(format!("{at}: the schema does not know it")),
            (Value::Null, Value::Object(_)) => judge(&rule["additionalProperties"], value, &at, faults),
            (Value::Null, _) => {}
            (rule, _) => judge(rule, value, &at, faults),
        }
    }
}

#[test]
fn what_commands_print_is_what_the_schema_says() {
    let states = written("schema_states.json", r#"{"states": [{"q": {"q1": 1}, "u": {"u1": 2}}]}"#);
    let out = file("schema_fourbar.rs").display().to_string();
    let picture = file("schema_figure.svg").display().to_string();
    let answers = file("schema_answers.json").display().to_string();
    let commands: [(&str, &[&str]); 16] = [
        ("check", &["check", "fourbar", "--json", "--rounding"]),
        ("check", &["check", "free_body", "--json"]),
        ("derive", &["derive", "fourbar", "-o", &out, "--json"]),
        ("costs", &["derive", "fourbar", "--answers", "rates,energy", "--costs", "--json"]),
        ("eval", &["eval", "fourbar", "--states", &states]),
        ("evaluated", &["eval", "fourbar", "--states", &states, "-o", &answers, "--json"]),
        ("equilibrium", &["equilibrium", "double_pendulum", "--json"]),
        ("run", &["run", "fourbar", "--seconds", "0.01", "--json"]),
        // The book of a drive has one column more.
        ("run", &["run", "shaking_table", "--seconds", "0.01", "--scalar", "f32", "--json"]),
        ("scene", &["run", "truss", "--seconds", "0.5", "--json"]),
        ("scene", &["run", "bladder", "--seconds", "0.002", "--json"]),
        ("world", &["run", "box_bounce", "--seconds", "0.5", "--json"]),
        ("figure", &["figure", "4.2", "-o", &picture, "--json"]),
        ("figures", &["figure", "--list", "--json"]),
        ("settled", &["settle", "damper_mass_fixed_end", "--json"]),
        ("world", &["run", "damper_mass_fixed_end", "--seconds", "0.01", "--json"]),
    ];
    for (name, arguments) in commands {
        let done = smartbed(arguments);
        assert_eq!(done.status, 0, "{done:?}");
        holds(name, &done.json());
    }
}

/// A report of an image that has run, and of one that breaks a rule.
#[test]
fn what_firmware_prints_is_what_the_schema_says() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let arguments = Arguments { set: vec!["M=8".to_owned()], ..Arguments::default() };
    let settings = Settings::new(&root, &arguments).expect("settings");
    let count = |name: &str| Count {
        name: name.to_owned(),
        calls: 10,
        instructions: [1, 2, 3],
        cycles: [4, 5],
        most_cycles: 6,
    };
    let equations = Equations {
        operations: 400,
        angles: 3,
        sin_cos: 60,
        apart: 640,
        apart_with_constants: 650,
        bytes: 4000,
    };
    let ran = Outcome {
        digest: "0".to_owned(),
        host_digest: None,
        state: vec![0.5],
        instructions: 1000,
        step: count("step"),
        rates: Some(count("rates")),
        equations: Some(equations),
    };
    let scene = Outcome { rates: None, equations: None, ..ran.clone() };
    let broken = Finding { rule: Rule::ALL[0], what: "__aeabi_dadd".to_owned() };
    for (findings, run) in [(vec![], Some(ran)), (vec![], Some(scene)), (vec![broken], None)] {
        let stack = Stack { bytes: 100, path: vec![("main".to_owned(), 40)], recursive: [].into() };
        let report = Report {
            settings: settings.clone(),
            toolchain: "rustc".to_owned(),
            elf: "image".into(),
            size: Size { flash: 1000, ram: 10 },
            stack,
            findings,
            run,
        };
        holds("firmware", &serde_json::from_str(&report.json()).expect("JSON"));
    }
}

#[test]
fn the_check_finds_what_is_missing_wrong_or_unknown() {
    let rule = serde_json::json!({"type": "object", "properties": {"a": {"type": "integer"}}, "required": ["a"],
        "additionalProperties": false});
    let faults = |value: Value| {
        let mut faults = Vec::new();
        judge(&rule, &value, "x", &mut faults);
        faults.join("; ")
    };
    assert_eq!(faults(serde_json::json!({"a": 1})), "");
    assert_eq!(faults(serde_json::json!({})), "x: `a` is missing");
    assert_eq!(faults(serde_json::json!({"a": 1.5})), "x.a: 1.5 is not \"integer\"");
    assert_eq!(faults(serde_json::json!({"a": 1, "b": 1})), "x.b: the schema does not know it");
}
