//! The folder with the firmware's sources, and a lock on what is built from them.

use crate::failure::Failure;
use std::fs::{self, File};
use std::path::{Path, PathBuf};

/// The root of the workspace, from whose sources the image is built.
pub(crate) fn workspace() -> Result<PathBuf, Failure> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new(""));
    if root.join("firmware/Cargo.toml").is_file() {
        return Ok(root.to_owned());
    }
    let why = format!("the sources of the firmware are no longer in {}", root.display());
    Err(Failure::Lacking(format!("{why}: run `cargo smartbed firmware` inside a clone of the project")))
}

/// Takes the lock for builds in this folder, one at a time: they share one build script's environment.
pub(crate) fn lock(folder: &Path) -> Result<File, Failure> {
    let wrong = |e: std::io::Error| Failure::Wrong(format!("{}: {e}", folder.display()));
    fs::create_dir_all(folder).map_err(wrong)?;
    let file = File::create(folder.join(".lock")).map_err(wrong)?;
    file.lock().map_err(wrong)?;
    Ok(file)
}
