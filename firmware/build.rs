//! Derives the model into `OUT_DIR` and, for the chip, gives the linker its memory.
//!
//! In, all optional: `SMARTBED_MODEL` (path of a model), `SMARTBED_SET` (`name=value;...`),
//! `SMARTBED_STEPS`, `SMARTBED_SCENE` (path of a scene's tables, for the scene's image),
//! `SMARTBED_INJECT` (a defect that the image's checks must find; for tests).
//! They are read here, at build time, so that host and chip change together.

use smartbed_codegen::{Effort, Options, ScalarType};
use std::env;
use std::error::Error;
use std::fs;
use std::path::Path;

const MODEL: &str = "../models/tile.toml";
const STEPS: &str = "10000";
const CHIP: &str = "chips/stm32f405.x";

fn main() -> Result<(), Box<dyn Error>> {
    let out = env::var("OUT_DIR")?;
    let out = Path::new(&out);
    println!("cargo::rerun-if-changed={CHIP}");
    println!(
        "cargo::rustc-check-cfg=cfg(inject, values(none(), \"panic\", \"double\", \"recursion\", \"indirect\"))"
    );

    let steps: u32 = option("SMARTBED_STEPS", STEPS).parse()?;
    fs::write(out.join("steps.rs"), format!("{steps}"))?;

    if env::var_os("CARGO_FEATURE_SCENE").is_some() {
        let tables = option("SMARTBED_SCENE", "");
        println!("cargo::rerun-if-changed={tables}");
        let text = fs::read_to_string(&tables).map_err(|e| {
            format!(
                "SMARTBED_SCENE={tables}: {e}; `cargo smartbed firmware SCENE` writes the tables and builds"
            )
        })?;
        fs::write(out.join("scene.rs"), text)?;
    } else {
        // A scene has no mechanism: deriving one would be most of the time that its image takes.
        derive(out)?;
        if env::var_os("CARGO_FEATURE_PLANT").is_some() {
            derive_plant();
        }
    }

    let inject = option("SMARTBED_INJECT", "");
    if !inject.is_empty() {
        println!("cargo::rustc-cfg=inject");
        println!("cargo::rustc-cfg=inject=\"{inject}\"");
    }
    if env::var("CARGO_CFG_TARGET_OS")? == "none" {
        fs::copy(CHIP, out.join("memory.x"))?;
        println!("cargo::rustc-link-search={}", out.display());
        println!("cargo::rustc-link-arg-bins=-Tlink.x");
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

/// An environment variable, or its default; a change of it builds again.
fn option(name: &str, default: &str) -> String {
    println!("cargo::rerun-if-env-changed={name}");
    env::var(name).unwrap_or_else(|_| default.to_owned())
}
