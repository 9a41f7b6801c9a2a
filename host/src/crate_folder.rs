//! Writes a folder of generated files, which may be regenerated at any time without touching files of others.
//!
//! In: a folder, paths and texts. Out: the files, and a list of them with hashes. An existing file is replaced only if
//! its hash is in that list; nothing is written through a symbolic link.

use crate::engine::crate_text::Files;
use crate::failure::Failure;
use smartbed_codegen::source::fnv1a;
use std::collections::BTreeMap;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::Path;

/// Name of the list in the folder.
const LIST: &str = ".smartbed";

/// Writes all files, or none.
///
/// # Errors
/// [`Failure::Wrong`] names a file that somebody else wrote or changed, a link, or a file that cannot be written.
pub fn write(folder: &Path, files: &Files) -> Result<(), Failure> {
    let written = list(folder)?;
    for (path, text) in files {
        check(folder, path, text, written.get(path).copied())?;
    }
    let mut lines = String::from("# Written by `smartbed derive --crate`: hash and path of each file.\n");
    for (path, text) in files {
        put(&folder.join(path), text)?;
        lines += &format!("{:016x} {path}\n", fnv1a(text.bytes()));
    }
    put(&folder.join(LIST), &lines)
}

/// Paths and hashes of the files that an earlier derivation wrote.
fn list(folder: &Path) -> Result<BTreeMap<String, u64>, Failure> {
    let file = folder.join(LIST);
    refuse_links(folder, LIST)?;
    let text = match fs::read_to_string(&file) {
        Ok(text) => text,
        Err(e) if e.kind() == ErrorKind::NotFound => return Ok(BTreeMap::new()),
        Err(e) => return Err(cannot("read", &file, &e)),
    };
    let entries = text.lines().filter_map(|line| line.split_once(' '));
    let entries =
        entries.filter_map(|(hash, path)| Some((path.to_owned(), u64::from_str_radix(hash, 16).ok()?)));
    Ok(entries.collect())
}

/// Checks that this file may be written.
fn check(folder: &Path, path: &str, text: &str, written: Option<u64>) -> Result<(), Failure> {
    refuse_links(folder, path)?;
    let file = folder.join(path);
    match fs::read(&file) {
        Err(e) if e.kind() == ErrorKind::NotFound => Ok(()),
        Err(e) => Err(cannot("read", &file, &e)),
        Ok(found) if found == text.as_bytes() || written == Some(fnv1a(found.iter().copied())) => Ok(()),
        Ok(_) => {
            let what = if written.is_some() {
                "was changed since it was derived"
            } else {
                "was written by somebody else"
            };
            let help = "move it away, or choose another folder";
            Err(Failure::Wrong(format!("{}: it {what} and is not overwritten; {help}", file.display())))
        }
    }
}

/// Refuses symbolic links: the folder, folders on the path to the file, and the file itself.
fn refuse_links(folder: &Path, path: &str) -> Result<(), Failure> {
    let mut place = folder.to_owned();
    for part in std::iter::once(Path::new("")).chain(Path::new(path).iter().map(Path::new)) {
        if part != Path::new("") {
            place.push(part);
        }
        if fs::symlink_metadata(&place).is_ok_and(|found| found.is_symlink()) {
            let help = "name the folder that it leads to, or remove it";
            return Err(Failure::Wrong(format!("{}: it is a link; {help}", place.display())));
        }
    }
    Ok(())
}

/// Writes under a temporary name first, so that another hard link to the same file keeps its content.
fn put(file: &Path, text: &str) -> Result<(), Failure> {
    let parent = file.parent().unwrap_or(Path::new(""));
    fs::create_dir_all(parent).map_err(|e| cannot("create", parent, &e))?;
    let mut name = file.as_os_str().to_owned();
    name.push(format!(".{}", std::process::id()));
    let done = fs::OpenOptions::new().write(true).create_new(true).open(&name);
    let done = done.and_then(|mut new| io::Write::write_all(&mut new, text.as_bytes()));
    let done = done.and_then(|()| fs::rename(&name, file));
    done.map_err(|e| {
        let _ = fs::remove_file(&name);
        cannot("write", file, &e)
    })
}

fn cannot(what: &str, path: &Path, error: &io::Error) -> Failure {
    Failure::Wrong(format!("cannot {what} {}: {error}", path.display()))
}
