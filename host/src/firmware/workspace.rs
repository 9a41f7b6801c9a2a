//! Where the sources of the firmware are, and a lock on what is built from them.

use crate::failure::Failure;
use std::fs::{self, File};
use std::path::{Path, PathBuf};

/// The workspace's root: the image is built from its sources.
pub(crate) fn workspace() -> Result<PathBuf, Failure> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new(""));
    if root.join("firmware/Cargo.toml").is_file() {
        return Ok(root.to_owned());
    }
    let why = format!("the sources of the firmware are no longer in {}", root.display());
    Err(Failure::Lacking(format!("{why}: run `cargo smartbed firmware` inside a clone of the project")))
}

/// One build at a time in this folder: the settings go through the environment of one build script.
pub(crate) fn lock(folder: &Path) -> Result<File, Failure> {
    let wrong = |e: std::io::Error| Failure::Wrong(format!("{}: {e}", folder.display()));
    fs::create_dir_all(folder).map_err(wrong)?;
    let file = File::create(folder.join(".lock")).map_err(wrong)?;
    file.lock().map_err(wrong)?;
    Ok(file)
}
