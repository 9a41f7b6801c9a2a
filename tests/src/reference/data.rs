//! Reads the reference files: samples in a mechanism's own order of names, and the minimal tile.
//!
//! Samples were evaluated with 50 digits from the doubles as given and rounded once; the minimal
//! tile's trajectory with DOP853 at 1e-13.

use serde_json::Value;
use std::path::Path;

/// One mechanism's samples.
#[derive(Clone, Debug)]
pub struct Reference {
    /// Name of the model.
    pub model: String,
    /// Names of the coordinates.
    pub q_names: Vec<String>,
    /// Names of the independent speeds.
    pub independent: Vec<String>,
    /// Names of the inputs.
    pub input_names: Vec<String>,
    /// Names of the parameters.
    pub parameter_names: Vec<String>,
    /// Fixed joint angles of the arm (deg); azimuths of the tile; empty elsewhere.
    pub alpha_degrees: Vec<f64>,
    /// The states.
    pub samples: Vec<Sample>,
}

/// One state and its accelerations.
#[derive(Clone, PartialEq, Debug)]
pub struct Sample {
    /// Coordinates.
    pub q: Vec<f64>,
    /// Independent speeds.
    pub u: Vec<f64>,
    /// Inputs.
    pub inputs: Vec<f64>,
    /// Parameters.
    pub parameters: Vec<f64>,
    /// Rates of all coordinates.
    pub q_dot: Vec<f64>,
    /// Rates of the independent speeds.
    pub u_dot: Vec<f64>,
}

/// One state of the minimal tile, in the order of legs A, B, C.
#[derive(Clone, PartialEq, Debug)]
pub struct MinimalState {
    /// Heights (m).
    pub h: [f64; 3],
    /// Their rates (m/s).
    pub h_dot: [f64; 3],
    /// Thrusts (N).
    pub thrust: [f64; 3],
    /// Accelerations of the heights.
    pub u_dot: [f64; 3],
    /// Kinetic energy (J).
    pub kinetic: f64,
    /// Potential energy (J).
    pub potential: f64,
    /// Outputs by name.
    pub outputs: Vec<(String, f64)>,
}

/// Heights of the minimal tile under its servo law.
#[derive(Clone, PartialEq, Debug)]
pub struct Trajectory {
    /// Times (s).
    pub t: Vec<f64>,
    /// Heights (m).
    pub h: Vec<[f64; 3]>,
    /// Their rates (m/s).
    pub h_dot: Vec<[f64; 3]>,
}

/// Everything about the minimal tile.
#[derive(Clone, Debug)]
pub struct Minimal {
    /// Parameters in the order of the tile's reference: R ms mr mc Ic1 Ic2 Ic3 M Ix Iy Iz c g.
    pub parameters: Vec<(String, f64)>,
    /// The states.
    pub states: Vec<MinimalState>,
    /// The servo trajectory, five seconds.
    pub servo: Trajectory,
}

/// Order of the tile's parameters.
pub const TILE_PARAMETERS: [&str; 13] =
    ["R", "ms", "mr", "mc", "Ic1", "Ic2", "Ic3", "M", "Ix", "Iy", "Iz", "c", "g"];

/// Reads one of the files.
fn read(model: &str) -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("reference").join(format!("{model}.json"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// A number.
fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("expected a number, found {value}"))
}

/// A list of numbers; a missing one is empty.
fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().map(|list| list.iter().map(number).collect()).unwrap_or_default()
}

/// A list of names.
fn names(value: &Value) -> Vec<String> {
    let list = value.as_array().expect("a list of names");
    list.iter().map(|name| name.as_str().expect("a name").to_owned()).collect()
}

/// Three numbers from an object, by prefix and leg.
fn legs(object: &Value, prefix: &str) -> [f64; 3] {
    ["A", "B", "C"].map(|leg| number(&object[format!("{prefix}{leg}")]))
}

/// The samples of a mechanism: pendulum3, fourbar, tile, arm6 or bicycle.
///
/// # Panics
/// If the file is missing or malformed.
#[must_use]
pub fn samples(model: &str) -> Reference {
    let file = read(model);
    let sample = |s: &Value| Sample {
        q: numbers(&s["q"]),
        u: numbers(&s["u_ind"]),
        inputs: numbers(&s["inputs"]),
        parameters: numbers(&s["params"]),
        q_dot: numbers(s.get("qdot").unwrap_or(&s["u_ind"])),
        u_dot: numbers(s.get("udot").unwrap_or(&s["udot_ind"])),
    };
    Reference {
        model: model.to_owned(),
        q_names: names(&file["q_names"]),
        independent: names(&file["independent"]),
        input_names: names(&file["input_names"]),
        parameter_names: names(&file["param_names"]),
        alpha_degrees: numbers(&file["alpha_degrees"]),
        samples: file["samples"].as_array().expect("samples").iter().map(sample).collect(),
    }
}

/// The minimal tile.
///
/// # Panics
/// If the file is missing or malformed.
#[must_use]
pub fn minimal() -> Minimal {
    let file = read("tile_minimal");
    let outputs = |o: &Value| {
        let object = o.as_object().expect("outputs");
        object.iter().map(|(name, value)| (name.clone(), number(value))).collect()
    };
    let state = |s: &Value| MinimalState {
        h: legs(&s["q"], "h"),
        h_dot: legs(&s["u"], "u_h"),
        thrust: legs(&s["inputs"], "F"),
        u_dot: legs(&s["u_dot"], "u_h"),
        kinetic: number(&s["energy"]["kinetic"]),
        potential: number(&s["energy"]["potential"]),
        outputs: outputs(&s["outputs"]),
    };
    let servo = &file["trajectories"][0];
    let triples = |list: &Value| {
        let rows = list.as_array().expect("a trajectory");
        rows.iter().map(|row| numbers(row).try_into().expect("three heights")).collect()
    };
    Minimal {
        parameters: TILE_PARAMETERS.map(|name| (name.to_owned(), number(&file["parameters"][name]))).into(),
        states: file["states"].as_array().expect("states").iter().map(state).collect(),
        servo: Trajectory {
            t: numbers(&servo["t"]),
            h: triples(&servo["h"]),
            h_dot: triples(&servo["hdot"]),
        },
    }
}
