//! The equations that a build needs: the model's with its demonstration, and those of the tile that the controller is
//! tried on.

use super::option;
use smartbed_codegen::{Core, Effort, Options, ScalarType};
use std::env;
use std::error::Error;
use std::fs;
use std::path::Path;

const MODEL: &str = "../models/tile.toml";

/// What the features ask for, into `out`.
pub fn all(out: &Path) -> Result<(), Box<dyn Error>> {
    if cfg!(feature = "model") {
        derive(out)?;
    }
    if cfg!(feature = "controller") {
        derive_feedforward();
    }
    if cfg!(feature = "plant") {
        derive_plant();
    }
    Ok(())
}

/// Derives the model, with the changes of its parameters.
fn derive(out: &Path) -> Result<(), Box<dyn Error>> {
    let mut options = Options {
        file_name: Some("mechanism".to_owned()),
        settings: Effort::All.into(),
        ..Options::default()
    };
    options.emit.scalar = ScalarType::F32;
    options.emit.core = Some(Core::CortexM4);
    options.emit.shared_work = true;
    for change in option("SMARTBED_SET", "").split(';').filter(|c| !c.is_empty()) {
        let (name, value) = change.split_once('=').ok_or("SMARTBED_SET: expected name=value;...")?;
        options.parameters.values.insert(name.to_owned(), value.parse()?);
    }
    let model = option("SMARTBED_MODEL", MODEL);
    let read = smartbed_codegen::model::read(Path::new(&model)).map_err(|e| e.to_string())?;
    if env::var_os("CARGO_FEATURE_EVERYTHING").is_some() {
        options.parameters.keep = read.parameters.iter().map(|p| p.name.clone()).collect();
    }
    let (_, program) = smartbed_codegen::build_program(model, &options);
    program.start()?;
    let corrects_speeds = !program.speed_correction.is_empty();
    fs::write(out.join("model.rs"), command(!read.laws.is_empty()) + correct(corrects_speeds))?;
    Ok(())
}

/// The model's law as a function of the state; without one the inputs stay as they are.
fn command(has_law: bool) -> String {
    let (underscore, body) = match has_law {
        true => ("", "law(t, q, u, inputs, p).inputs"),
        false => ("_", "*inputs"),
    };
    let [t, q, u, p] = ["t", "q", "u", "p"].map(|name| format!("{underscore}{name}"));
    format!(
        "/// Has the model a law?\npub const HAS_LAW: bool = {has_law};\n\
         /// Inputs as the model's law commands them.\n#[must_use]\n\
         pub fn command({t}: f32, {q}: &[f32; NQ], {u}: &[f32; NU], inputs: &[f32; N_INPUTS], {p}: &Prepared) \
         -> [f32; N_INPUTS] {{\n    {body}\n}}\n"
    )
}

/// The corrections that the first evaluation of a step finds, added to the state.
fn correct(speeds: bool) -> &'static str {
    match speeds {
        true => {
            "/// Corrects coordinates and speeds.\npub fn correct(begun: &BeginStep, q: &mut [f32; NQ], u: &mut [f32; NU]) {\n    \
             CORRECTED.iter().zip(&begun.projection.0).for_each(|(&index, change)| q[index] += change);\n    \
             u.iter_mut().zip(&begun.speed_projection).for_each(|(u, change)| *u += change);\n}\n"
        }
        false => {
            "/// Corrects coordinates; the speeds are independent.\npub fn correct(begun: &BeginStep, q: &mut [f32; NQ], _: &mut [f32; NU]) {\n    \
             CORRECTED.iter().zip(&begun.projection.0).for_each(|(&index, change)| q[index] += change);\n}\n"
        }
    }
}

/// Numbers of the tile (SI), as in `firmware/src/tile/design.rs`; the patient's mass lies 130 mm over the middle.
const NUMBERS: [(&str, f64); 8] = [
    ("R", 0.09),
    ("M", 3.0),
    ("Ix", 0.012),
    ("Iy", 0.016),
    ("Iz", 0.026),
    ("mc", 0.3),
    ("c", 0.0),
    ("z_payload", 0.13),
];

/// What the screws carry along a motion, for the controller. Drives are left out: their inertia needs no force of a
/// screw.
fn derive_feedforward() {
    let mut options = Options {
        file_name: Some("feedforward".to_owned()),
        answers: vec!["inverse_dynamics".to_owned()],
        settings: Effort::All.into(),
        ..Options::default()
    };
    options.emit.scalar = ScalarType::F32;
    options.parameters.keep = vec!["m_payload".to_owned()];
    options.parameters.values =
        NUMBERS.into_iter().chain([("mr", 0.0)]).map(|(n, v)| (n.to_owned(), v)).collect();
    smartbed_codegen::build("../models/tile_minimal.toml", &options);
}

/// The tile that the controller is tried on: `tile` with those numbers and the inertia of its drives, whose friction is
/// the plant's own code. On the host in double precision too.
fn derive_plant() {
    let gear = std::f64::consts::TAU * 30.0 / 0.004;
    let more = [("mr", 2e-6 * gear * gear)];
    let host = env::var("CARGO_CFG_TARGET_OS").is_ok_and(|os| os != "none");
    for (file_name, scalar) in [("plant_f32", ScalarType::F32), ("plant_f64", ScalarType::F64)] {
        if scalar == ScalarType::F64 && !host {
            continue;
        }
        let mut options = Options { file_name: Some(file_name.to_owned()), ..Options::default() };
        options.emit.scalar = scalar;
        options.parameters.keep =
            ["m_payload", "x_payload", "y_payload", "z_payload", "Fz"].map(str::to_owned).into();
        options.parameters.values = NUMBERS.into_iter().chain(more).map(|(n, v)| (n.to_owned(), v)).collect();
        smartbed_codegen::build(MODEL, &options);
    }
}
