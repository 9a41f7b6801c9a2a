//! Costs of a mechanism's functions on the chip: code, stack and instructions of each, read from an image that calls
//! them all.
//!
//! In: files of a derived crate in f32 and the names of its functions. Out: a cost per function. Emitted functions are
//! straight-line code, so that their instructions are counted statically; the image is linked but never run.

use super::chip::STM32F405;
use super::compile;
use super::image::straight::{self, Instructions};
use super::image::{Image, stack};
use super::toolchain::{self, Toolchain};
use super::workspace::{lock, workspace};
use crate::engine::crate_text::Files;
use crate::failure::Failure;
use std::fs;
use std::path::Path;

/// The cost of a function on the chip, including all functions that it calls.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ChipCost {
    /// Code and the constants within it (bytes).
    pub bytes: u32,
    /// Stack below its caller's frame (bytes).
    pub stack: u32,
    /// Instructions of a call.
    pub instructions: Instructions,
}

/// A function to be measured.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Measured {
    /// Its name in `equations`.
    pub name: String,
    /// Does it take derivatives of the speeds?
    pub takes_u_dot: bool,
}

impl Measured {
    /// The function that computes: rates are written by one function and returned by another, which calls that one.
    fn computing(&self, equations: &str) -> String {
        let into = format!("{}_into", self.name);
        if equations.contains(&format!("pub fn {into}(")) { into } else { self.name.clone() }
    }

    /// A call of it with arguments unknown to the compiler, by a pointer: a constant result is not put in its place.
    fn call(&self, computing: &str) -> String {
        let u_dot = if self.takes_u_dot { ", &u" } else { "" };
        let written = if computing == self.name { "" } else { ", &mut q_dot, &mut u_dot" };
        let references = 4 + usize::from(self.takes_u_dot);
        let kind = format!(
            "fn(_{}{}) -> _",
            ", &_".repeat(references),
            written.replace("q_dot", "_").replace("u_dot", "_")
        );
        format!(
            "    black_box(black_box({computing} as {kind})(black_box(0.0_f32), &q, &u, &inputs{u_dot}, &p{written}));\n"
        )
    }
}

/// A toolchain for the chip, if there is one; nothing is installed.
#[must_use]
pub fn toolchain() -> Option<Toolchain> {
    toolchain::present(STM32F405.target)
}

/// Costs, in the order of `functions`; `files` are those of `crate_text::library`.
///
/// # Errors
/// Status 1 if it does not build, status 2 if the folder cannot be written.
pub fn costs(
    toolchain: &Toolchain,
    mut files: Files,
    functions: &[Measured],
) -> Result<Vec<ChipCost>, Failure> {
    let equations = files.iter().find(|(path, _)| path == "src/equations.rs");
    let equations = equations.map_or("", |(_, text)| text.as_str());
    let computing: Vec<String> = functions.iter().map(|function| function.computing(equations)).collect();
    let calls = functions.iter().zip(&computing).map(|(function, computing)| function.call(computing));
    let entry = entry(&calls.collect::<String>());
    for (path, text) in &mut files {
        if path == "src/equations.rs" {
            for name in &computing {
                // If it were inlined, its instructions would be counted with the caller; in a section of its own it is
                // not replaced by another function of equal code.
                let apart =
                    format!("#[inline(never)]\n#[unsafe(link_section = \".text.{name}\")]\npub fn {name}(");
                *text = text.replace(&format!("pub fn {name}("), &apart);
            }
        }
        if path == "src/lib.rs" {
            *text = text.replace("#![no_std]", "#![no_std]\n#![no_main]") + &entry;
        }
        if path == "Cargo.toml" {
            *text = text.replace(
                "[dependencies]",
                "[[bin]]\nname = \"functions\"\npath = \"src/lib.rs\"\n\n[dependencies]",
            );
        }
    }
    let workspace = workspace()?;
    let folder = workspace.join("target/functions");
    let _lock = lock(&folder)?;
    let source = folder.join("source");
    files.push((
        "Cargo.lock".to_owned(),
        fs::read_to_string(workspace.join("Cargo.lock")).unwrap_or_default(),
    ));
    for (path, text) in &files {
        let file = source.join(path);
        let written =
            fs::create_dir_all(file.parent().unwrap_or(&source)).and_then(|()| fs::write(&file, text));
        written.map_err(|e| Failure::Lacking(format!("{}: {e}", file.display())))?;
    }
    let image = Image::open(&build(toolchain, &source, &folder)?)?;
    computing.iter().map(|name| cost(&image, name)).collect()
}

/// An entry function with these calls.
fn entry(calls: &str) -> String {
    format!(
        "
#[panic_handler]
fn stop(_: &core::panic::PanicInfo) -> ! {{
    loop {{}}
}}

/// Where the image begins.
#[unsafe(no_mangle)]
pub extern \"C\" fn _start() -> ! {{
    use core::hint::black_box;
    let p = black_box(prepare(&Parameters::default()));
    let (q, u, inputs) = (black_box([0.0_f32; NQ]), black_box([0.0_f32; NU]), black_box([0.0_f32; N_INPUTS]));
    let (mut q_dot, mut u_dot) = ([0.0_f32; NQ], [0.0_f32; NU]);
{calls}    black_box((&mut q_dot, &mut u_dot));
    loop {{}}
}}
"
    )
}

/// Builds with the firmware's options; returns the path of the image.
fn build(toolchain: &Toolchain, source: &Path, folder: &Path) -> Result<std::path::PathBuf, Failure> {
    let mut cargo = toolchain.cargo();
    cargo
        .args(["build", "--quiet", "--release", "--bin", "functions", "--target-dir"])
        .arg(folder)
        .current_dir(source);
    cargo.env("CARGO_PROFILE_RELEASE_OPT_LEVEL", "2").env("CARGO_PROFILE_RELEASE_CODEGEN_UNITS", "1");
    cargo.env("CARGO_PROFILE_RELEASE_LTO", "fat").env("CARGO_PROFILE_RELEASE_DEBUG", "0");
    compile::for_chip(&mut cargo, toolchain, &STM32F405);
    compile::succeed(cargo, "the functions do not build for the chip")?;
    Ok(folder.join(STM32F405.target).join("release/functions"))
}

fn cost(image: &Image, name: &str) -> Result<ChipCost, Failure> {
    let ending = format!("::equations::{name}");
    // The linker merges functions of equal code: one function may have several names.
    let entry = image.entries.iter().find(|(name, _)| name.ends_with(&ending));
    let found = entry.and_then(|(_, address)| image.owner(*address));
    let function = found.ok_or_else(|| Failure::Wrong(format!("the image lacks the function `{name}`")))?;
    Ok(ChipCost {
        bytes: straight::bytes(image, &[function]),
        stack: stack::bound(image, function, &[]).bytes,
        instructions: straight::instructions(image, function),
    })
}
