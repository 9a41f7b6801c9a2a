//! `smartbed firmware`: from a model to an image, its checks, its cost and the digest of its trajectory.
//!
//! A scene of a flexible body is treated in the same way: its constant tables are printed for the firmware from the
//! value that the host steps. So is a world ([`fit`]), together with the equations of its mechanisms, its sheets as
//! fine as RAM allows. Steps: find or install the tools ([`toolchain`]), build image and host simulation from the same
//! settings ([`compile`]), check the image ([`image`]), run it in the emulator with the counting plug-in
//! ([`emulator`]), compare the digests of chip and host, relate the counts to the operations ([`equations`]), print
//! ([`report`]).

pub mod arguments;
pub mod chip;
pub mod compile;
pub mod cycles;
pub mod emulator;
pub mod equations;
pub mod fit;
pub mod functions;
pub mod image;
pub mod process;
pub mod report;
pub mod riscv;
pub mod settings;
pub mod thumb;
pub mod toolchain;
pub mod workspace;

pub use arguments::Arguments;

use crate::failure::Failure;
use crate::output;
use crate::progress::Waiting;
use arguments::Bus;
use chip::{Chip, STM32F405};
use image::{Image, rules};
use report::Report;
use settings::{Settings, Subject};
use smartbed_codegen::words::count;
use std::path::{Path, PathBuf};
use workspace::{lock, workspace};

/// Runs the command and prints the report.
///
/// # Errors
/// Status 1 for a wrong model or parameter and for an image that breaks a rule; status 2 where the
/// machine lacks a tool.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    if let Some(elf) = &arguments.elf {
        return judge(elf, arguments.json);
    }
    if let Some(bus) = arguments.board {
        return judge(&board(bus)?, arguments.json);
    }
    let report = measure(arguments)?;
    let text = if arguments.json { report.json() } else { report.text() };
    output::print(&text)?;
    match report.failures().as_slice() {
        [] => Ok(()),
        failures => Err(Failure::Wrong(failures.join("\nerror: "))),
    }
}

/// Builds, checks and runs the image, and the host's simulation for comparison; prints progress only.
///
/// # Errors
/// As [`run`], except that broken rules are in the report.
pub fn measure(arguments: &Arguments) -> Result<Report, Failure> {
    build(arguments, true)
}

/// As [`measure()`], without the host's simulation: only the image's cost.
///
/// # Errors
/// As [`measure()`].
pub fn cost(arguments: &Arguments) -> Result<Report, Failure> {
    build(arguments, false)
}

fn build(arguments: &Arguments, compared: bool) -> Result<Report, Failure> {
    let workspace = workspace()?;
    let mut settings = Settings::new(&workspace, arguments)?;
    toolchain::announce(STM32F405.target);
    settings.note_what_differs();
    let toolchain = toolchain::toolchain(STM32F405.target)?;
    let emulator = toolchain::emulator()?;
    let folder = workspace.join("target/image");
    let _lock = lock(&folder)?;

    output::say(&format!("building for {} with {}", STM32F405.name, toolchain.describe()));
    let waiting = Waiting::new("building the image");
    let elf = compile::image(&toolchain, &workspace, &folder, &STM32F405, &settings)?;
    drop(waiting);
    let mut image = Image::open(&elf)?;
    let mut stack = image.stack().map_err(Failure::Wrong)?;
    if settings.refit(image.size.ram + u64::from(stack.bytes))? {
        let _waiting = Waiting::new("building the image");
        image = Image::open(&compile::image(&toolchain, &workspace, &folder, &STM32F405, &settings)?)?;
        stack = image.stack().map_err(Failure::Wrong)?;
    }
    let findings = rules::findings(&image, &stack, &STM32F405);
    let mut report = Report::new(&toolchain, &settings, &elf, &image, stack, findings);
    if report.findings.is_empty() {
        let plugin = emulator::plugin(&toolchain, &workspace, &folder)?;
        let host = match compared {
            true => Some(compile::simulation(&toolchain, &workspace, &folder, &settings)?),
            false => None,
        };
        output::say(&format!("running {} in the emulator", count(settings.steps, "step")));
        let run = emulator::run(&emulator, &plugin, &STM32F405, &elf, &image, settings.counted())?;
        report.add_run(&run, host.as_deref(), &image)?;
    }
    Ok(report)
}

/// Builds the controller of a real tile; returns its image.
///
/// # Errors
/// Status 1 if it does not build, status 2 where a tool is missing.
pub fn board(bus: Bus) -> Result<PathBuf, Failure> {
    let workspace = workspace()?;
    toolchain::announce(STM32F405.target);
    let toolchain = toolchain::toolchain(STM32F405.target)?;
    let folder = workspace.join("target/image");
    let _lock = lock(&folder)?;
    output::say(&format!("building the board's program with {}", toolchain.describe()));
    let _waiting = Waiting::new("building the image");
    compile::image(&toolchain, &workspace, &folder, &STM32F405, &Settings::controller(Subject::Board(bus)))
}

/// Builds the controller for a core without a board; returns its image.
///
/// # Errors
/// Status 1 if it does not build, status 2 where a tool is missing.
pub fn bare(chip: &Chip) -> Result<PathBuf, Failure> {
    let workspace = workspace()?;
    let toolchain = toolchain::toolchain(chip.target)?;
    let folder = workspace.join("target/image");
    let _lock = lock(&folder)?;
    output::say(&format!("building the controller for {} with {}", chip.target, toolchain.describe()));
    compile::image(&toolchain, &workspace, &folder, chip, &Settings::controller(Subject::Bare))
}

/// Applies the rules to an image that was built elsewhere.
fn judge(elf: &Path, as_json: bool) -> Result<(), Failure> {
    let image = Image::open(elf)?;
    let stack = image.stack().map_err(Failure::Wrong)?;
    let findings = rules::findings(&image, &stack, &STM32F405);
    output::print(&report::of_image(elf, &image, &stack, &findings, as_json))?;
    if findings.is_empty() {
        return Ok(());
    }
    Err(Failure::Wrong(findings.iter().map(ToString::to_string).collect::<Vec<_>>().join("\nerror: ")))
}
