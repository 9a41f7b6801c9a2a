//! Derives the model into `OUT_DIR` and, for the chip, gives the linker its memory.
//!
//! In, all optional: `SMARTBED_MODEL` (path of a model), `SMARTBED_SET` (`name=value;...`),
//! `SMARTBED_CHIP` (a file of `chips/`), `SMARTBED_STEPS`, `SMARTBED_SCENE` (path of the tables of a scene or world,
//! for its image), `SMARTBED_INJECT` (a defect that the image's checks must find; for tests). They are read here, at
//! build time, so that host and chip change together.

#[cfg(feature = "derive")]
mod derive;

use std::env;
use std::error::Error;
use std::fs;
use std::path::Path;

const STEPS: &str = "10000";
/// Behind the constants lies the checksum of vectors, code and constants.
const CHECKSUM: &str = "
__svectors = ADDR(.vector_table);
__evectors = ADDR(.vector_table) + SIZEOF(.vector_table);
SECTIONS { .checksum : ALIGN(4) { KEEP(*(.checksum)) } > FLASH } INSERT AFTER .rodata;
";
/// The chip, by the name of its file in `chips/`.
const CHIP: &str = "m4";

fn main() -> Result<(), Box<dyn Error>> {
    let out = env::var("OUT_DIR")?;
    let out = Path::new(&out);
    let chip = option("SMARTBED_CHIP", CHIP);
    let memory = format!("chips/{chip}.x");
    println!("cargo::rerun-if-changed={memory}");
    println!("cargo::rustc-check-cfg=cfg(chip, values(\"m4\", \"m7\", \"m33\", \"rv32\"))");
    println!("cargo::rustc-cfg=chip=\"{chip}\"");
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
        #[cfg(feature = "derive")]
        derive::all(out)?;
    }

    let inject = option("SMARTBED_INJECT", "");
    if !inject.is_empty() {
        println!("cargo::rustc-cfg=inject");
        println!("cargo::rustc-cfg=inject=\"{inject}\"");
    }
    let is_bare = env::var("CARGO_CFG_TARGET_OS")? == "none";
    if is_bare && env::var("CARGO_CFG_TARGET_ARCH")? != "arm" {
        // A program that is measured alone has a layout, and no start.
        println!("cargo::rustc-link-arg-bins=-T{}/{memory}", env::var("CARGO_MANIFEST_DIR")?);
    } else if is_bare {
        let text = fs::read_to_string(&memory).map_err(|e| format!("SMARTBED_CHIP={chip}: {memory}: {e}"))?;
        fs::write(out.join("memory.x"), text + CHECKSUM)?;
        println!("cargo::rustc-link-search={}", out.display());
        println!("cargo::rustc-link-arg-bins=-Tlink.x");
    }
    Ok(())
}

/// An environment variable, or its default; a change of it builds again.
fn option(name: &str, default: &str) -> String {
    println!("cargo::rerun-if-env-changed={name}");
    env::var(name).unwrap_or_else(|_| default.to_owned())
}
