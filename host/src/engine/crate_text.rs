//! The text of a self-contained crate: emitted equations, the numeric part of the runtime, a manifest.
//!
//! In: a program and a scalar. Out: (path, text) of every file. The crate depends on `libm`, and on `wide` for lanes;
//! on nothing else of this project.

use smartbed_codegen::{EmitOptions, Program, ScalarType, escape, rust};
use smartbed_runtime::{INTEGRATOR_SOURCES, SOURCES};

/// (path within the crate, text).
pub type Files = Vec<(String, String)>;

/// The no_std crate of `derive --crate`.
#[must_use]
pub fn library(program: &Program, scalar: &ScalarType, options: &EmitOptions) -> Files {
    let lanes = matches!(scalar, ScalarType::Path(_));
    let wide = if lanes { "wide = { version = \"1.7\", default-features = false }\n" } else { "" };
    let features = if lanes { "default = [\"simd\"]\n" } else { "" };
    let name = crate_name(&program.name);
    let about = if program.doc.trim().is_empty() { &program.name } else { &program.doc };
    // A TOML string, whose escapes differ from Rust's.
    let description = toml::Value::from(escape::line(&about.replace(['\n', '\t'], " ")));
    let manifest = format!(
        "# Written by `smartbed derive --crate`.
[package]
name = \"{name}\"
description = {description}
version = \"0.1.0\"
edition = \"2024\"
rust-version = \"1.89\"

[dependencies]
libm = {{ version = \"0.2\", default-features = false }}
{wide}
[features]
{features}simd = []
counting = []

[profile.release]
panic = \"abort\"

# Stands on its own, also inside the folder of a workspace.
[workspace]
"
    );
    let root = format!(
        "//! {}
//!
//! `equations` is generated; `real` and `mechanism` are the parts of the runtime that it needs.
#![no_std]

pub mod equations;
pub mod mechanism;
pub mod real;

pub use equations::*;
",
        escape::markdown(about)
    );
    let mut files = vec![("Cargo.toml".to_owned(), manifest), ("src/lib.rs".to_owned(), root)];
    let options = EmitOptions { runtime: "crate".to_owned(), ..options.clone() };
    files.push(("src/equations.rs".to_owned(), rust::emit(program, &options)));
    files.extend(sources());
    files
}

/// The same crate with the runtime's integrators, which step its mechanism under a law of its inputs.
#[must_use]
pub fn with_integrators(program: &Program, scalar: &ScalarType, options: &EmitOptions) -> Files {
    let mut files = library(program, scalar, options);
    for (path, text) in &mut files {
        if path == "src/lib.rs" {
            *text = text.replace(
                "pub mod mechanism;\n",
                "pub mod mechanism;\n// One step of the equations by any method: `ode::rk4` of an `ode::Driven`.\npub mod ode;\n",
            );
        }
    }
    files.extend(INTEGRATOR_SOURCES.iter().map(|(path, text)| {
        // Without the methods for bodies' nodes, of which the crate has none.
        (format!("src/{path}"), text.replace("pub mod nodes;\n", ""))
    }));
    files
}

/// The crate of the dynamic library for `--engine compiled`: one C function returns any answer.
#[must_use]
pub fn dynamic(program: &Program, scalar: ScalarType, libm: &str) -> Files {
    let manifest = format!(
        "[package]
name = \"smartbed-compiled\"
version = \"0.1.0\"
edition = \"2024\"

[lib]
crate-type = [\"cdylib\"]

[dependencies]
libm = {{ version = \"{libm}\", default-features = false }}

[features]
simd = []
counting = []

[workspace]
"
    );
    let options = EmitOptions { scalar, runtime: "crate".to_owned(), ..EmitOptions::default() };
    let drive = match program.drive {
        Some(_) => "6 => fill(results, [drive(*t, q, u, inputs, p)].iter()),",
        None => "// 6, the power of the drive: nothing drives this mechanism.",
    };
    let speeds = match program.is_redundant() {
        true => "7 => fill(results, speed_projection(*t, q, u, inputs, p).iter()),",
        false => "// 7, the correction of the speeds: they are independent.",
    };
    // Only functions of answers on request: their structs consist of numbers only.
    let functions = program.functions.iter().enumerate().map(|(place, function)| {
        let u_dot = match program.answers_of(function).iter().any(|answer| answer.takes_u_dot) {
            true => ", u_dot",
            false => "",
        };
        let (number, name) = (8 + place, &function.name);
        format!(
            "{number} => {{
            let answer = {name}(*t, q, u, inputs{u_dot}, p);
            // SAFETY: the structs of answers are `repr(C)` and hold nothing but numbers `S`.
            fill(results, unsafe {{ numbers(&answer) }}.iter())
        }}"
        )
    });
    let u_dot = match program.u_dot.is_empty() {
        true => "",
        false => "let (u_dot, values) = values.split_first_chunk::<NU>()?;",
    };
    let root = include_str!("dynamic.rs.txt")
        .replace("// DRIVE", drive)
        .replace("// SPEEDS", speeds)
        .replace("// FUNCTIONS", &functions.collect::<Vec<_>>().join("\n        "))
        .replace("// U_DOT", u_dot);
    let mut files = vec![("Cargo.toml".to_owned(), manifest), ("src/lib.rs".to_owned(), root)];
    files.push(("src/equations.rs".to_owned(), rust::emit(program, &options)));
    files.extend(sources());
    files
}

fn sources() -> impl Iterator<Item = (String, String)> {
    SOURCES.iter().map(|(path, text)| (format!("src/{path}"), (*text).to_owned()))
}

/// `my tile` -> `my-tile`: what cargo takes for the name of a package.
fn crate_name(model: &str) -> String {
    let name: String = model
        .chars()
        .map(|c| if c.is_ascii_alphanumeric() || c == '_' { c.to_ascii_lowercase() } else { '-' })
        .collect();
    if name.starts_with(|c: char| c.is_ascii_alphabetic()) { name } else { format!("model-{name}") }
}
