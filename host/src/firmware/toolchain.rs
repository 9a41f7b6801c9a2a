//! Finds the tools that build and run the image, and installs them if the machine's package manager can.
//!
//! In: the machine. Out: a [`Toolchain`] that can build for the chip, and the emulator's program. Order: a toolchain
//! with the chip's target is used as it is; else one with the sources of core, from which core is built; else
//! [`crate::install`] installs the distribution's packages, or the error names the command that helps. rustup is never
//! called.

use super::process::{self, output, which};
use super::workspace::workspace;
use crate::failure::Failure;
use crate::install::{install, lacking, update_lists};
use crate::output::say;
use crate::unpack::unpack;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Debian's packages for a toolchain with the sources of core, and a linker for it.
const TOOLCHAIN_PACKAGES: [&str; 4] = ["rustc-web", "cargo-web", "rust-web-src", "lld"];
/// The emulator's program, and Debian's package of it.
const EMULATOR: &str = "qemu-system-arm";
/// Oldest rustc that compiles the workspace (major, minor), as in `rust-version` of Cargo.toml.
const OLDEST: (u32, u32) = (1, 89);

/// A Rust toolchain that can build for the chip.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Toolchain {
    /// Its cargo.
    pub cargo: PathBuf,
    /// Its rustc.
    pub rustc: PathBuf,
    /// `rustc -V`.
    pub version: String,
    /// Must core be built from source?
    pub core_from_source: bool,
    /// Linker, if the toolchain has none.
    pub linker: Option<PathBuf>,
}

impl Toolchain {
    /// A command that runs this toolchain's cargo, without the variables that a rustup proxy sets.
    #[must_use]
    pub fn cargo(&self) -> Command {
        let mut command = process::clean(&self.cargo);
        command.env("RUSTC", &self.rustc);
        if self.core_from_source {
            command.env("RUSTC_BOOTSTRAP", "1");
        }
        command
    }

    /// Description in one line, for a report.
    #[must_use]
    pub fn describe(&self) -> String {
        let core = if self.core_from_source { "core from source" } else { "target installed" };
        format!("{} ({}, {core})", self.version, self.rustc.display())
    }
}

/// Says once, before anything else, what the machine lacks and which packages will be installed; silent if nothing is
/// missing.
pub fn announce(target: &str) {
    let mut packages = Vec::new();
    let mut lacking = Vec::new();
    if find(target).is_none() {
        packages.extend(TOOLCHAIN_PACKAGES);
        lacking.push(format!("a Rust toolchain that builds for {target}"));
    }
    if found_emulator().is_none() && !workspace().is_ok_and(|w| w.join("target/emulator").is_dir()) {
        packages.push(EMULATOR);
        lacking.push(format!("{EMULATOR} with plug-ins"));
    }
    if lacking.is_empty() {
        return;
    }
    say(&format!("note: this machine lacks {}", lacking.join(" and ")));
    match crate::install::size_of(&packages) {
        Some(size) => say(&format!(
            "note: apt-get will install {}{size}; nothing else is changed, and rustup is not called; Ctrl-C now to stop",
            packages.join(" ")
        )),
        None => say("note: nothing can be installed here; the commands to run are listed below"),
    }
}

/// A toolchain for `target`, if the machine has one; installs nothing.
#[must_use]
pub fn present(target: &str) -> Option<Toolchain> {
    find(target)
}

/// A toolchain for `target`; installs one if none is found.
///
/// # Errors
/// [`Failure::Lacking`] with the command that helps.
pub fn toolchain(target: &str) -> Result<Toolchain, Failure> {
    if let Some(found) = find(target) {
        return Ok(found);
    }
    let help = format!("rustup target add {target}");
    let why = format!("no Rust toolchain here can build for {target}");
    install(&why, &TOOLCHAIN_PACKAGES, &help)?;
    if let Some(found) = find(target) {
        return Ok(found);
    }
    // With outdated package lists an old compiler may have been installed, or it was there before.
    update_lists()?;
    install(&why, &TOOLCHAIN_PACKAGES, &help)?;
    find(target).ok_or_else(|| lacking(&why, &help))
}

/// A toolchain for programs of this machine; installs one if none is found.
///
/// # Errors
/// [`Failure::Lacking`] with the command that helps.
pub fn native() -> Result<Toolchain, Failure> {
    let own = || compilers().iter().find_map(|rustc| probe(rustc, None));
    let (major, minor) = OLDEST;
    let why = format!(
        "no Rust toolchain here, rustc and cargo {major}.{minor} or later, builds programs of this machine"
    );
    let help = "rustup toolchain install stable";
    if let Some(found) = own() {
        return Ok(found);
    }
    install(&why, &TOOLCHAIN_PACKAGES[..2], help)?;
    own().ok_or_else(|| lacking(&why, help))
}

/// The emulator's program, with plug-ins; if none is found, installs it or unpacks it into `target/emulator`.
///
/// # Errors
/// [`Failure::Lacking`] with the command that helps.
pub fn emulator() -> Result<PathBuf, Failure> {
    if let Some(found) = found_emulator() {
        return Ok(found);
    }
    let unpacked = workspace()?.join("target/emulator");
    if unpacked.is_dir() {
        return unpack(EMULATOR, &unpacked);
    }
    let help = format!("apt-get install {EMULATOR}");
    let why = format!("{EMULATOR} with plug-ins is not on PATH");
    if install(&why, &[EMULATOR], &help).is_err() {
        return unpack(EMULATOR, &unpacked);
    }
    found_emulator().ok_or_else(|| lacking(&why, &help))
}

fn found_emulator() -> Option<PathBuf> {
    let has_plugins =
        |p: &PathBuf| output(Command::new(p).arg("--help")).is_some_and(|h| h.contains("-plugin"));
    which(EMULATOR).filter(has_plugins)
}

/// Looks for toolchains with the target first, then for those that can build core.
fn find(target: &str) -> Option<Toolchain> {
    let found: Vec<Toolchain> = compilers().iter().filter_map(|rustc| probe(rustc, Some(target))).collect();
    found.iter().find(|t| !t.core_from_source).or(found.first()).cloned()
}

fn compilers() -> Vec<PathBuf> {
    which("rustc").into_iter().chain([PathBuf::from("/usr/bin/rustc")]).collect()
}

/// Can this rustc, with the cargo next to it, build for `target`, without one for its own machine, and how?
fn probe(rustc: &Path, target: Option<&str>) -> Option<Toolchain> {
    let cargo = Some(rustc.with_file_name("cargo")).filter(|p| p.is_file()).or_else(|| which("cargo"))?;
    let verbose = output(process::clean(rustc).arg("-vV"))?;
    let field = |name: &str| verbose.lines().find_map(|l| l.strip_prefix(name)).map(str::to_owned);
    let (host, release) = (field("host: ")?, field("release: ")?);
    if !is_recent(&release) {
        return None;
    }
    let version = format!("rustc {release}");
    let Some(target) = target else {
        return Some(Toolchain {
            cargo,
            rustc: rustc.to_owned(),
            version,
            core_from_source: false,
            linker: None,
        });
    };
    let sysroot = output(process::clean(rustc).args(["--print", "sysroot"]))?;
    let library = Path::new(&sysroot).join("lib/rustlib");
    let installed = has_core(&library.join(target).join("lib"));
    if !installed && !library.join("src/rust/library/core/Cargo.toml").is_file() {
        return None;
    }
    let linker = if library.join(host).join("bin/rust-lld").is_file() {
        None
    } else {
        Some(which("rust-lld").or_else(|| which("ld.lld"))?)
    };
    Some(Toolchain { cargo, rustc: rustc.to_owned(), version, core_from_source: !installed, linker })
}

fn has_core(folder: &Path) -> bool {
    let files = std::fs::read_dir(folder).into_iter().flatten().flatten();
    files.into_iter().any(|f| f.file_name().to_string_lossy().starts_with("libcore-"))
}

/// Is `1.96.0`, `1.97.0-nightly` at least [`OLDEST`]?
fn is_recent(release: &str) -> bool {
    let mut numbers = release.split(['.', '-']).map(str::parse::<u32>);
    match (numbers.next(), numbers.next()) {
        (Some(Ok(major)), Some(Ok(minor))) => (major, minor) >= OLDEST,
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn releases() {
        assert!(is_recent("1.96.0"));
        assert!(is_recent("1.89.0-nightly"));
        assert!(!is_recent("1.63.0"));
        assert!(!is_recent("?"));
    }
}
