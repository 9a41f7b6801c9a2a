//! Derives every model under test, as any user would, for each scalar.
//!
//! `<model>_<scalar>.rs` has the model's own tunable parameters; `<model>_loaded_<scalar>.rs` keeps
//! the fixed ones of the tiles too; `<model>_accurate_<scalar>.rs` is the form for accuracy.

use smartbed_codegen::{Effort, EmitOptions, Optimise, Options, ParameterChoice, ScalarType, Settings};

/// Models whose code the tests compile.
const MODELS: [&str; 4] = ["pendulum3", "fourbar", "tile", "tile_minimal"];
/// Models compiled in f64 only, to be timed, with every effort to be short.
const TIMED: [&str; 3] = ["arm6", "bicycle", "pendulum10"];
/// Parameters that the tiles fold by default.
const LOAD: [&str; 15] = [
    "m_payload",
    "x_payload",
    "y_payload",
    "z_payload",
    "k_support",
    "h_support",
    "Fx",
    "Fy",
    "Fz",
    "Tx",
    "Ty",
    "Tz",
    "k_stop",
    "h_min",
    "h_max",
];

fn main() {
    let counting = ScalarType::Path("smartbed_runtime::real::counting::Counting".to_owned());
    for model in MODELS {
        for (suffix, scalar) in
            [("f64", ScalarType::F64), ("f32", ScalarType::F32), ("counting", counting.clone())]
        {
            derive(model, &format!("{model}_{suffix}"), scalar, &[], Effort::Default);
        }
    }
    for (suffix, scalar) in [("f64", ScalarType::F64), ("f32", ScalarType::F32), ("counting", counting)] {
        let accurate = Settings { effort: Effort::Default, optimise: Optimise::Accuracy };
        derive("fourbar", &format!("fourbar_accurate_{suffix}"), scalar, &[], accurate);
    }
    // Constraints that follow from the others only as long as parameters are what they are.
    for (suffix, scalar) in [("f64", ScalarType::F64), ("f32", ScalarType::F32)] {
        derive("parallelogram", &format!("parallelogram_{suffix}"), scalar, &[], Effort::Default);
    }
    for model in TIMED {
        derive(model, &format!("{model}_f64"), ScalarType::F64, &[], Effort::All);
    }
    for model in ["tile", "tile_minimal"] {
        derive(model, &format!("{model}_loaded_f64"), ScalarType::F64, &LOAD, Effort::Default);
        derive(model, &format!("{model}_loaded_f32"), ScalarType::F32, &LOAD, Effort::Default);
    }
}

/// One file in `OUT_DIR`.
fn derive(model: &str, file_name: &str, scalar: ScalarType, keep: &[&str], settings: impl Into<Settings>) {
    let options = Options {
        parameters: ParameterChoice {
            keep: keep.iter().map(ToString::to_string).collect(),
            ..ParameterChoice::default()
        },
        emit: EmitOptions { scalar, ..EmitOptions::default() },
        settings: settings.into(),
        file_name: Some(file_name.to_owned()),
        ..Options::default()
    };
    smartbed_codegen::build(format!("../models/{model}.toml"), &options);
}
