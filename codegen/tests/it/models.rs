//! The models of this repository are read without a finding.

use smartbed_codegen::model::{self, Model};

/// A model of this repository.
pub fn shipped(name: &str) -> Model {
    let path =
        std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(format!("{name}.toml"));
    model::read(&path).unwrap_or_else(|found| panic!("{found}"))
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
