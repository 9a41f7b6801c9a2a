//! What a model states as an expression of parameters follows them where a command changes these: as if the file had
//! been written with the other numbers.

use crate::support::{smartbed, written};
use serde_json::Value;

/// A rod on a slider: inertia, start, nominal value and range are expressions; J of a parameter that is one itself.
const ROD: &str = r#"format = 1
name = "rod"
gravity = "-g*N.y"
[parameters]
g = { value = 9.81, unit = "m/s^2" }
m = { value = 2, unit = "kg" }
l = { value = 0.6, unit = "m" }
I = { value = "m*l.powi(2)/12", unit = "kg m^2" }
J = { value = "2*I", unit = "kg m^2", range = [0, 1] }
[coordinates]
q = { unit = "rad" }
s = { unit = "m", nominal = "l/2", range = ["-l", "2*l"] }
[frames]
rod = { parent = "N", rotations = [["z", "q"]] }
[points]
P = "s*N.x"
C = "P - l/2*rod.y"
[bodies]
slider = { centre = "P", mass = 1, frame = "rod", inertia = { Izz = "J" } }
rod = { centre = "C", mass = "m", frame = "rod", inertia = { Izz = "I" } }
[start]
q = 0.4
s = "l/3"
u_s = "l/1_s"
[run]
seconds = 0.2
step = 1e-3
"#;

fn changed(pairs: &[(&str, &str)]) -> String {
    pairs.iter().fold(ROD.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    })
}

fn last(path: &str, set: &[&str]) -> Value {
    let options = set.iter().flat_map(|change| ["--set", change]);
    let done = smartbed(&[&["run", path, "--json"][..], &options.collect::<Vec<_>>()].concat());
    assert_eq!(done.status, 0, "{done:?}");
    done.json()["last"].clone()
}

#[test]
fn a_run_with_set_is_that_of_the_file_with_the_other_number() {
    let path = written("derived.toml", ROD);
    let longer = written("derived_longer.toml", &changed(&[("value = 0.6", "value = 0.9")]));
    assert_eq!(last(&path, &["l=0.9"]), last(&longer, &[]));
    assert_ne!(last(&path, &[]), last(&longer, &[]));
    // What is set itself stays, and what is made of it follows; so does a start.
    let pairs = [("value = 0.6", "value = 0.9"), ("\"m*l.powi(2)/12\"", "0.05"), ("\"l/3\"", "0.1")];
    let both = written("derived_both.toml", &changed(&pairs));
    assert_eq!(last(&path, &["l=0.9", "I=0.05", "s=0.1"]), last(&both, &[]));
    // 2 I = 1.04 then.
    let refused = smartbed(&["run", &path, "--set", "l=1.77"]);
    assert!(refused.message().contains("parameter `J` is 1.04"), "{refused:?}");
}

#[test]
fn a_state_with_parameters_is_that_of_the_file_with_the_other_numbers() {
    let path = written("derived_eval.toml", ROD);
    let heavier = written("derived_heavier.toml", &changed(&[("value = 2,", "value = 3,")]));
    let rates = |path: &str, parameters: &str| {
        let state = format!(r#"{{"q": {{"q": 0.3, "s": 0.1}}, "u": {{"u_q": 1.5}}{parameters}}}"#);
        let states = written("derived_states.json", &format!(r#"{{"states": [{state}]}}"#));
        let done = smartbed(&["eval", path, "--states", &states, "--answers", "rates,energy"]);
        assert_eq!(done.status, 0, "{done:?}");
        let found = done.json()["states"][0].clone();
        (found["u_dot"].clone(), found["energy"].clone())
    };
    let agree = |found: (Value, Value), expected: (Value, Value)| {
        for (found, expected) in [(found.0, expected.0), (found.1, expected.1)] {
            for (name, x) in found.as_object().expect("numbers") {
                let (x, other) = (x.as_f64().expect("a number"), expected[name].as_f64().expect("a number"));
                assert!((x - other).abs() <= 1e-14 * other.abs(), "{name}: {x} for {other}");
            }
        }
    };
    agree(rates(&path, r#", "parameters": {"m": 3}"#), rates(&heavier, ""));
    assert_ne!(rates(&path, ""), rates(&heavier, ""));
    let kept = rates(&path, r#", "parameters": {"m": 3, "I": 0.06, "J": 0.12}"#);
    let pairs = [("value = 2,", "value = 3,"), ("\"m*l.powi(2)/12\"", "0.06")];
    agree(kept, rates(&written("derived_kept.toml", &changed(&pairs)), ""));
    let states =
        written("derived_outside.json", r#"{"states": [{"q": {"q": 0, "s": 0}, "parameters": {"m": 30}}]}"#);
    let refused = smartbed(&["eval", &path, "--states", &states]);
    assert!(refused.message().contains("states[0]: parameters: parameter `J` is 1.79999"), "{refused:?}");
}

#[test]
fn derived_code_with_set_is_that_of_the_file_with_the_other_number() {
    let path = written("derived_code.toml", ROD);
    let longer = written("derived_code_longer.toml", &changed(&[("value = 0.6", "value = 0.9")]));
    let code = |arguments: &[&str]| {
        let done = smartbed(&[&["derive"], arguments, &["-o", "-"]].concat());
        assert_eq!(done.status, 0, "{done:?}");
        // The first lines name the file and what was set.
        let rest = done.out.lines().skip(2).map(|line| line.replace("derived_code_longer", "derived_code"));
        rest.collect::<Vec<_>>()
    };
    assert_eq!(code(&[&path, "--set", "l=0.9"]), code(&[&longer]));
}
