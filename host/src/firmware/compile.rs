//! Builds the image for the chip and the same simulation for the host, from the same settings.
//!
//! In: [`Settings`], passed to the firmware's build script through environment variables. Out: the ELF of the chip, and
//! what the host's simulation prints. Both are built by one cargo into a target folder of their own, so that they
//! neither wait for an outer cargo nor disturb its builds.

use super::chip::Chip;
use super::image::checksum;
use super::process::{clean, run_limited};
use super::settings::{Settings, Subject};
use super::toolchain::Toolchain;
use crate::failure::Failure;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

/// Time limit of the host's simulation, which runs 10,000 steps in milliseconds.
const TIME_LIMIT: Duration = Duration::from_secs(60);

/// Builds the image; returns its path.
///
/// # Errors
/// [`Failure::Wrong`] if it does not build; the compiler's messages are on standard error.
pub fn image(
    toolchain: &Toolchain,
    workspace: &Path,
    folder: &Path,
    chip: &Chip,
    settings: &Settings,
) -> Result<PathBuf, Failure> {
    let mut cargo = build(toolchain, workspace, folder, settings)?;
    for_chip(&mut cargo, toolchain, chip);
    cargo.env("SMARTBED_CHIP", chip.short);
    succeed(cargo, "the image does not build")?;
    let built = folder.join(chip.target).join("firmware").join(settings.program());
    if !matches!(settings.subject, Subject::Loop | Subject::Board(_)) {
        return Ok(built);
    }
    // Chips of one target share an output folder: the image is copied to a file of its own, with its checksum, so that
    // a build for another chip does not replace it before it is run.
    let own = folder.join(format!("{}-{}", chip.short, settings.program()));
    let fresh = own.with_extension("new");
    let wrong = |e: std::io::Error| Failure::Wrong(format!("{}: {e}", own.display()));
    let mut elf = fs::read(&built).map_err(wrong)?;
    checksum::write(&mut elf).map_err(|why| Failure::Wrong(format!("{}: {why}", built.display())))?;
    fs::write(&fresh, elf).and_then(|()| fs::rename(&fresh, &own)).map_err(wrong)?;
    Ok(own)
}

/// Builds and runs the same simulation on the host; returns what it prints.
///
/// # Errors
/// [`Failure::Wrong`] if it does not build or fails.
pub fn simulation(
    toolchain: &Toolchain,
    workspace: &Path,
    folder: &Path,
    settings: &Settings,
) -> Result<String, Failure> {
    run_limited(&mut clean(&program(toolchain, workspace, folder, settings)?), TIME_LIMIT)
        .map_err(|e| Failure::Wrong(format!("the simulation fails on the host: {e}")))
}

/// Builds the same program for the host; returns its path.
///
/// # Errors
/// [`Failure::Wrong`] if it does not build.
pub fn program(
    toolchain: &Toolchain,
    workspace: &Path,
    folder: &Path,
    settings: &Settings,
) -> Result<PathBuf, Failure> {
    let mut cargo = build(toolchain, workspace, folder, settings)?;
    // Link-time optimisation would take seconds and save milliseconds.
    cargo.env("CARGO_PROFILE_FIRMWARE_LTO", "off");
    succeed(cargo, "the simulation does not build for the host")?;
    Ok(folder.join("firmware").join(settings.program()))
}

fn build(
    toolchain: &Toolchain,
    workspace: &Path,
    folder: &Path,
    settings: &Settings,
) -> Result<Command, Failure> {
    let mut cargo = package(toolchain, workspace, folder);
    cargo.args(["--bin", settings.program()]);
    if settings.small {
        // Only the program's own crate: generic code is compiled there, and nothing else has to be rebuilt.
        cargo.args(["--config", "profile.firmware.package.smartbed-firmware.opt-level=\"s\""]);
    }
    settings.export(&mut cargo, folder)?;
    Ok(cargo)
}

/// A cargo command that builds the firmware's package, without deriving what the program does not need.
fn package(toolchain: &Toolchain, workspace: &Path, folder: &Path) -> Command {
    let mut cargo = toolchain.cargo();
    cargo.args(["build", "--quiet", "--package", "smartbed-firmware", "--no-default-features"]);
    cargo.args(["--profile", "firmware", "--target-dir"]).arg(folder).current_dir(workspace);
    cargo
}

/// Adds a target, with core built from source if the toolchain has none for it.
fn for_target(cargo: &mut Command, toolchain: &Toolchain, target: &str) {
    cargo.args(["--target", target]);
    if toolchain.core_from_source {
        cargo.arg("-Zbuild-std=core");
    }
}

/// Adds a chip: its target, its processor, a linker.
pub(super) fn for_chip(cargo: &mut Command, toolchain: &Toolchain, chip: &Chip) {
    for_target(cargo, toolchain, chip.target);
    let target = chip.target.to_uppercase().replace(['-', '.'], "_");
    if let Some(linker) = &toolchain.linker {
        cargo.env(format!("CARGO_TARGET_{target}_LINKER"), linker);
    }
    cargo.env(
        format!("CARGO_TARGET_{target}_RUSTFLAGS"),
        format!("-Ctarget-cpu={} {}", chip.cpu, chip.options),
    );
}

/// Runs a build; its messages go to standard error.
pub(super) fn succeed(mut cargo: Command, what: &str) -> Result<(), Failure> {
    let status = cargo.stdout(Stdio::null()).status();
    match status {
        Ok(status) if status.success() => Ok(()),
        Ok(_) => Err(Failure::Wrong(format!("{what}: see the compiler's messages above"))),
        Err(e) => Err(Failure::Lacking(format!("{}: {e}", cargo.get_program().display()))),
    }
}
