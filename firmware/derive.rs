//! The equations that a build needs: the model's with its demonstration, and those of the tile that the controller is tried on.

use super::option;
use smartbed_codegen::{Effort, Options, ScalarType};
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
    for change in option("SMARTBED_SET", "").split(';').filter(|c| !c.is_empty()) {
        let (name, value) = change.split_once('=').ok_or("SMARTBED_SET: expected name=value;...")?;
        options.parameters.values.insert(name.to_owned(), value.parse()?);
    }
    let model = option("SMARTBED_MODEL", MODEL);
    if env::var_os("CARGO_FEATURE_EVERYTHING").is_some() {
        let read = smartbed_codegen::model::read(Path::new(&model)).map_err(|e| e.to_string())?;
        options.parameters.keep = read.parameters.iter().map(|p| p.name.clone()).collect();
    }
    let mechanism = smartbed_codegen::build(model, &options);
    fs::write(out.join("model.rs"), alias(&fs::read_to_string(mechanism)?)?)?;
    Ok(())
}

/// The tile that the controller is tried on: `tile` with the numbers of `tile_drive`, whose drives are the plant's own
/// code. On the host in double precision too.
fn derive_plant() {
    let numbers =
        [("R", 0.09), ("M", 3.0), ("Ix", 0.012), ("Iy", 0.016), ("Iz", 0.026), ("mc", 0.3), ("c", 0.0)];
    let gear = std::f64::consts::TAU * 30.0 / 0.004;
    let more = [("mr", 2e-6 * gear * gear), ("z_payload", 0.13)];
    let host = env::var("CARGO_CFG_TARGET_OS").is_ok_and(|os| os != "none");
    for (file_name, scalar) in [("plant_f32", ScalarType::F32), ("plant_f64", ScalarType::F64)] {
        if scalar == ScalarType::F64 && !host {
            continue;
        }
        let mut options = Options { file_name: Some(file_name.to_owned()), ..Options::default() };
        options.emit.scalar = scalar;
        options.parameters.keep =
            ["m_payload", "x_payload", "y_payload", "z_payload", "Fz"].map(str::to_owned).into();
        options.parameters.values = numbers.into_iter().chain(more).map(|(n, v)| (n.to_owned(), v)).collect();
        smartbed_codegen::build(MODEL, &options);
    }
}

/// The same name for the equations of every model.
fn alias(mechanism: &str) -> Result<String, &'static str> {
    let name = mechanism.lines().find_map(|line| line.split_once("Mechanism<S> for ")?.1.split(' ').next());
    let name = name.ok_or("the generated file implements no Mechanism")?;
    Ok(format!("/// The equations of motion with their parameters.\npub type Model = {name};\n"))
}
