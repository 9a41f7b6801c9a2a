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
    assert_eq!(names(tile.coordinates.iter().map(|c| &c.name)), ["hA", "hB", "hC"]);
    let outputs = ["Gx", "Gy", "Gz", "psiA", "thA", "sA", "psiB", "thB", "sB", "psiC", "thC", "sC"];
    assert_eq!(names(tile.outputs.iter().map(|o| &o.name)), outputs);
    assert!(tile.configuration_constraints.is_empty());
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
