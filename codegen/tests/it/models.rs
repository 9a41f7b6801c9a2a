//! The models of this repository are read without errors or warnings.

use smartbed_codegen::model::{self, Model};
use smartbed_codegen::{ParameterChoice, Program, program};

/// A model of this repository.
pub fn shipped(name: &str) -> Model {
    let path =
        std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(format!("{name}.toml"));
    model::read(&path).unwrap_or_else(|found| panic!("{found}"))
}

/// The text of a model of this repository.
pub fn text_of(name: &str) -> String {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../models");
    std::fs::read_to_string(folder.join(format!("{name}.toml"))).expect("readable")
}

/// The program of a model's text, or why its equations cannot be derived.
pub fn derive(text: &str) -> Result<Program, String> {
    let model = model::parse("test.toml", text).unwrap_or_else(|e| panic!("{e}"));
    program::derive(&model, &ParameterChoice::default()).map_err(|e| e.to_string())
}

/// The program of a model's text.
pub fn derived_from(text: &str) -> Program {
    derive(text).unwrap_or_else(|e| panic!("{e}\n{text}"))
}

fn names<'a>(items: impl Iterator<Item = &'a String>) -> Vec<&'a str> {
    items.map(String::as_str).collect()
}

#[test]
fn tile_has_the_names_of_the_reference() {
    let tile = shipped("tile");
    let q = ["hA", "psiA", "thA", "sA", "hB", "psiB", "thB", "sB", "hC", "psiC", "thC", "sC"];
    assert_eq!(names(tile.coordinates.iter().map(|c| &c.name)), q);
    assert_eq!(names(tile.speeds.iter().map(|s| &s.name)), q.map(|name| format!("u_{name}")));
    assert_eq!(
        names(tile.speeds.iter().filter(|s| s.independent).map(|s| &s.name)),
        ["u_hA", "u_hB", "u_hC"]
    );
    assert_eq!(names(tile.inputs.iter().map(|i| &i.name)), ["FA", "FB", "FC"]);
    let tunable = tile.parameters.iter().filter(|p| p.tunable).map(|p| &p.name);
    let reference = ["R", "ms", "mr", "mc", "Ic1", "Ic2", "Ic3", "M", "Ix", "Iy", "Iz", "c", "g"];
    assert_eq!(names(tunable), reference);
}

#[test]
fn tile_minimal_has_three_coordinates_and_the_outputs_of_the_reference() {
    let tile = shipped("tile_minimal");
    let state = tile.coordinates.iter().filter(|c| c.closed_form.is_none());
    assert_eq!(names(state.map(|c| &c.name)), ["hA", "hB", "hC"]);
    let outputs = ["Gx", "Gy", "Gz", "psiA", "thA", "sA", "psiB", "thB", "sB", "psiC", "thC", "sC"];
    assert_eq!(names(tile.outputs.iter().map(|o| &o.name)), outputs);
}

#[test]
fn planar_models_have_the_names_of_the_reference() {
    let pendulum = shipped("pendulum3");
    assert_eq!(names(pendulum.coordinates.iter().map(|c| &c.name)), ["q0", "q1", "q2"]);
    assert_eq!(names(pendulum.speeds.iter().map(|s| &s.name)), ["u0", "u1", "u2"]);
    assert_eq!(names(pendulum.parameters.iter().map(|p| &p.name)), ["m0", "m1", "m2", "l0", "l1", "l2", "g"]);
    let fourbar = shipped("fourbar");
    assert_eq!(names(fourbar.speeds.iter().map(|s| &s.name)), ["u1", "u2", "u3"]);
    assert_eq!(names(fourbar.speeds.iter().filter(|s| s.independent).map(|s| &s.name)), ["u1"]);
}

#[test]
fn shipped_models_leave_nothing_unused() {
    for name in ["pendulum3", "fourbar", "tile", "tile_minimal"] {
        let warnings = shipped(name).warnings();
        assert!(warnings.items.is_empty(), "{warnings}");
    }
}

/// Blocks of TOML in the manual, each with the name of the model it is taken from.
fn quoted_in_manual() -> Vec<(String, String)> {
    let manual = include_str!("../../../docs/models.md");
    let mut blocks = Vec::new();
    let mut parts = manual.split("```toml\n");
    let mut before = parts.next().unwrap_or("");
    for part in parts {
        let (block, after) = part.split_once("```").expect("a block ends");
        let from = before.rfind("models/").map_or("", |at| &before[at + 7..]);
        let name = from.split(".toml").next().unwrap_or("");
        blocks.push((name.to_owned(), block.to_owned()));
        before = after;
    }
    blocks
}

#[test]
fn examples_of_the_manual_stand_in_the_models() {
    let blocks = quoted_in_manual();
    assert!(10 < blocks.len(), "only {} examples found", blocks.len());
    for (name, block) in blocks {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../models/{name}.toml"));
        let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        assert!(text.contains(&block), "not in models/{name}.toml:\n{block}");
    }
}

#[test]
fn every_model_is_read_without_a_finding() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../models");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).expect("models/").map(|e| e.expect("an entry").path()) {
        let text = std::fs::read_to_string(&entry).unwrap_or_default();
        // Scenes and bodies are other texts: only mechanisms state degrees of freedom.
        if text.contains("\ndof = ") {
            let model = model::read(&entry).unwrap_or_else(|found| panic!("{found}"));
            let warnings = model.warnings();
            assert!(warnings.items.is_empty(), "{warnings}");
            count += 1;
        }
    }
    assert!(8 <= count, "{count} models");
}

#[test]
fn plain_numbers_are_in_the_unit_of_their_quantity() {
    let text = r#"
format = 1
name = "units"
[parameters]
m = { value = 2, unit = "kg" }
k = { value = 3, unit = "N m" }
[inputs]
F = { unit = "kN" }
[coordinates]
q = { unit = "deg", nominal = 10, range = [-90, 90] }
x = { unit = "mm", nominal = "1_m", range = [-2000, "2_m"] }
[frames]
arm = { rotations = [["z", "q"]] }
[points]
P = "x*arm.x"
[bodies]
b = { centre = "P", mass = "m" }
[springs]
s = { coordinate = "q", stiffness = "k", rest = 180 }
[forces]
f = { point = "P", force = "F*N.x" }
[[configurations]]
values = { q = 45, x = "0.5_m" }
[start]
q = 30
x = 250
u_q = "90"
u_x = "3_m/1_s"
[law]
F = 1.5
"#;
    let model = model::parse("units.toml", text).unwrap_or_else(|e| panic!("{e}"));
    let degree = std::f64::consts::PI / 180.0;
    let close = |x: f64, y: f64| assert!((x - y).abs() <= 1e-15 * y.abs(), "{x} is not {y}");
    let start: Vec<f64> = model.start.iter().map(|(_, x)| *x).collect();
    for (x, y) in start.iter().zip([30.0 * degree, 0.25, 90.0 * degree, 3.0]) {
        close(*x, y);
    }
    let values: Vec<f64> = model.configurations[0].values.iter().map(|(_, x)| *x).collect();
    for (x, y) in values.iter().zip([45.0 * degree, 0.5]) {
        close(*x, y);
    }
    let x = model.coordinates.iter().nth(1).expect("x");
    assert_eq!((x.unit.as_str(), x.written_unit.clone()), ("m", ("mm".to_owned(), 1e-3)));
    close(x.range.0, -2.0);
    close(x.range.1, 2.0);
    let program = smartbed_codegen::program::derive(&model, &Default::default()).expect("derives");
    let mut engine = smartbed_codegen::Interpreted::<f64>::new(&program);
    let zero = [0.0; 2];
    // The spring pulls q from 0 to its rest of pi: k pi^2 / 2.
    let energy =
        smartbed_runtime::mechanism::Mechanism::energy(&mut engine, &zero, &zero).expect("lengths fit");
    close(energy.1, 1.5 * std::f64::consts::PI.powi(2));
    let smartbed_codegen::model::expression::ExprKind::Number(law) = model.laws[0].1.kind else {
        panic!("a number")
    };
    close(law, 1500.0);
}
