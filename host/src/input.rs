//! Reads files that a command line names, up to a maximum size, because a device or a pipe may never end.

use std::fs::File;
use std::io::{Read, stdin};
use std::path::Path;

/// Largest states file, scene, or list of points (bytes); everything made from it stays below 1 GiB.
pub const LARGEST: u64 = 8 << 20;

/// Most values, keys and lines in the text of a scene: the largest bodies have this many, and each takes some 180
/// bytes.
pub const MOST_MARKS: usize = 900_000;

/// The text of a file of at most [`LARGEST`] bytes; `-` is standard input.
///
/// # Errors
/// Why it cannot be read.
pub fn text(path: &str) -> Result<String, String> {
    if path == "-" {
        return bounded(stdin().lock());
    }
    refuse_special(Path::new(path))?;
    bounded(File::open(path).map_err(|e| e.to_string())?)
}

/// The contents of a file of at most `most` bytes.
///
/// # Errors
/// Why it cannot be read.
pub fn bytes(path: &Path, most: u64) -> Result<Vec<u8>, String> {
    refuse_special(path)?;
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(|e| e.to_string())?;
    file.take(most + 1).read_to_end(&mut bytes).map_err(|e| e.to_string())?;
    match bytes.len() as u64 <= most {
        true => Ok(bytes),
        false => Err(format!("it has more than {} MiB; expected a smaller one", most >> 20)),
    }
}

/// Refuses devices, which may never end; a file that a shell passes as `/dev/fd/3` is allowed.
fn refuse_special(path: &Path) -> Result<(), String> {
    let kind = std::fs::metadata(path).map_err(|e| e.to_string())?.file_type();
    match kind.is_file() || path.starts_with("/dev/fd") || path.starts_with("/proc/self/fd") {
        true => Ok(()),
        false if kind.is_dir() => Err("it is a folder; expected a file".to_owned()),
        false => Err("it is a pipe or a device; expected a file, or - for standard input".to_owned()),
    }
}

fn bounded(from: impl Read) -> Result<String, String> {
    let mut text = String::new();
    from.take(LARGEST + 1).read_to_string(&mut text).map_err(|e| e.to_string())?;
    match text.len() as u64 <= LARGEST {
        true => Ok(text),
        false => Err(format!("it has more than {} MiB; expected a smaller one", LARGEST >> 20)),
    }
}
