//! Dynamic libraries compiled from emitted Rust, kept by the hash of their text.
//!
//! In: the files of a crate. Out: the path of the library, compiled if it is not in the cache. Only one build runs at a
//! time, and a library gets its name only when it is complete.

use super::crate_text::Files;
use crate::failure::Failure;
use crate::firmware::process::{clean, which};
use smartbed_codegen::source::fnv1a;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Version of libm on which results depend, if no lock file names one.
const LIBM: &str = "0.2";

/// The library of these files; compiles it if it is not in the cache.
///
/// # Errors
/// [`Failure::Lacking`] without a compiler or without libm; [`Failure::Wrong`] if it does not compile.
pub fn library(files: &Files) -> Result<PathBuf, Failure> {
    let cache = folder();
    let key = format!("{:016x}", hash(files));
    let name = format!("{}{key}{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX);
    let library = cache.join(name);
    if library.is_file() {
        return Ok(library);
    }
    let wrong = |e: std::io::Error| Failure::Wrong(format!("cannot write in {}: {e}", cache.display()));
    fs::create_dir_all(&cache).map_err(wrong)?;
    let lock = File::create(cache.join(".lock")).map_err(wrong)?;
    lock.lock().map_err(wrong)?;
    // Another process may have built it while this one waited.
    if !library.is_file() {
        let source = cache.join("source");
        for (path, text) in files {
            let file = source.join(path);
            fs::create_dir_all(file.parent().unwrap_or(&source)).map_err(wrong)?;
            fs::write(file, text).map_err(wrong)?;
        }
        let built = build(&source, &cache.join("build"))?;
        let complete = cache.join(format!("{key}.partial"));
        fs::copy(built, &complete).map_err(wrong)?;
        fs::rename(complete, &library).map_err(wrong)?;
    }
    Ok(library)
}

/// Version of libm to compile with: the one in this program's lock file, so that results agree bit for bit.
#[must_use]
pub fn libm_version() -> String {
    let lock = fs::read_to_string(workspace().join("Cargo.lock")).unwrap_or_default();
    let mut lines = lock.lines().skip_while(|l| *l != "name = \"libm\"").skip(1);
    let version = lines.next().and_then(|l| l.strip_prefix("version = \"")).and_then(|l| l.strip_suffix('"'));
    version.map_or(LIBM.to_owned(), |v| format!("={v}"))
}

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// `target/compiled` of the workspace that this program was built from, else the user's cache.
fn folder() -> PathBuf {
    if let Ok(root) = workspace().canonicalize()
        && root.join("Cargo.lock").is_file()
    {
        return root.join("target/compiled");
    }
    let home = || std::env::var_os("HOME").map(|h| Path::new(&h).join(".cache"));
    let user = std::env::var_os("XDG_CACHE_HOME").map(PathBuf::from).or_else(home);
    user.unwrap_or_else(std::env::temp_dir).join("smartbed")
}

/// Hash of paths and texts.
fn hash(files: &Files) -> u64 {
    let bytes = files.iter().flat_map(|(path, text)| path.bytes().chain([0]).chain(text.bytes()).chain([0]));
    fnv1a(bytes)
}

/// Compiles, first without network: libm is on every machine that has built this program.
fn build(source: &Path, target: &Path) -> Result<PathBuf, Failure> {
    let Some(cargo) = which("cargo") else {
        return Err(Failure::Lacking(
            "no Rust compiler on PATH: run `apt-get install cargo-web rustc-web` (Debian) or see \
             https://rustup.rs, or use `--engine interpreter`, which needs none"
                .to_owned(),
        ));
    };
    crate::output::say("compiling the equations");
    let offline = run(&cargo, source, target, true);
    if let Err(log) = offline.or_else(|_| run(&cargo, source, target, false)) {
        let unreachable = ["failed to get", "failed to download", "no matching package"];
        if unreachable.iter().any(|u| log.contains(u)) {
            return Err(Failure::Lacking(format!("libm cannot be fetched: run `cargo fetch` once\n{log}")));
        }
        return Err(Failure::Wrong(format!("the emitted Rust does not compile:\n{log}")));
    }
    let (prefix, suffix) = (std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX);
    Ok(target.join("release").join(format!("{prefix}smartbed_compiled{suffix}")))
}

fn run(cargo: &Path, source: &Path, target: &Path, offline: bool) -> Result<(), String> {
    let mut command: Command = clean(cargo);
    command.args(["build", "--quiet", "--release", "--lib"]).current_dir(source);
    command.arg("--target-dir").arg(target);
    if offline {
        command.arg("--offline");
    }
    let done = command.output().map_err(|e| format!("{}: {e}", cargo.display()))?;
    if done.status.success() { Ok(()) } else { Err(String::from_utf8_lossy(&done.stderr).trim().to_owned()) }
}
