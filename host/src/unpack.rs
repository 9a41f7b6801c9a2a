//! Unpacks a program of the distribution into a folder, for cases in which installing it would remove other packages.
//!
//! In: the name of a Debian package and its program. Out: a script that runs the unpacked program with its own
//! libraries. Nothing in the system changes.

use crate::failure::Failure;
use crate::firmware::process::run_quietly;
use crate::install::{apt, lacking, root_on_debian};
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Makes the program use the libraries that were unpacked with it.
const SCRIPT: &str = r#"#!/bin/sh
here=$(cd "$(dirname "$0")" && pwd)
for folder in "$here"/lib/*-linux-gnu "$here"/usr/lib/*-linux-gnu; do
    LD_LIBRARY_PATH=$folder:$LD_LIBRARY_PATH
done
export LD_LIBRARY_PATH
exec "$here/usr/bin/$(basename "$0")" "$@"
"#;

/// The script that runs `program` of this package, unpacked under `folder` together with those of its dependencies that
/// the system lacks.
///
/// # Errors
/// [`Failure::Lacking`] where apt-get cannot fetch the packages, or a file cannot be written.
pub fn unpack(program: &str, folder: &Path) -> Result<PathBuf, Failure> {
    let script = folder.join(program);
    if script.is_file() {
        return Ok(script);
    }
    let why = format!("{program} can neither be installed nor unpacked into {}", folder.display());
    let help = format!("apt-get install {program}");
    let Some(root) = root_on_debian() else { return Err(lacking(&why, &help)) };
    crate::output::say(&format!(
        "apt-get could not install {program} beside what is there: unpacking it into {}",
        folder.display()
    ));
    // Renamed when complete, because another process may unpack the same package.
    let mine = folder.with_extension(std::process::id().to_string());
    let done = fetch(root, program, &mine).and_then(|()| finish(program, &mine, folder));
    let _ = fs::remove_dir_all(&mine);
    done.map_err(|log| lacking(&format!("{why}\n{log}\n"), &help))?;
    Ok(script)
}

/// The files of the package and of what it needs, under `folder`.
fn fetch(root: &[&str], package: &str, folder: &Path) -> Result<(), String> {
    let archives = folder.join("archives");
    fs::create_dir_all(archives.join("partial")).map_err(text)?;
    let cache = format!("Dir::Cache::archives={}", std::path::absolute(&archives).map_err(text)?.display());
    apt(root, &["install", "--yes", "--no-install-recommends", "--download-only", "-o", &cache, package])?;
    for archive in fs::read_dir(&archives).map_err(text)?.flatten() {
        if archive.path().extension().is_some_and(|e| e == "deb") {
            run_quietly(Command::new("dpkg-deb").arg("-x").arg(archive.path()).arg(folder))?;
        }
    }
    fs::remove_dir_all(&archives).map_err(text)
}

/// Writes the script and renames the folder; if another process has finished an equal folder, that is used.
fn finish(program: &str, mine: &Path, folder: &Path) -> Result<(), String> {
    let script = mine.join(program);
    fs::write(&script, SCRIPT).map_err(text)?;
    fs::set_permissions(&script, fs::Permissions::from_mode(0o755)).map_err(text)?;
    match fs::rename(mine, folder) {
        Err(error) if !folder.join(program).is_file() => Err(text(error)),
        _ => Ok(()),
    }
}

fn text(error: std::io::Error) -> String {
    error.to_string()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::firmware::process::output;

    #[test]
    fn an_unpacked_program_finds_its_libraries_and_gets_its_arguments() {
        let folder = std::env::temp_dir().join(format!("smartbed-unpack-{}", std::process::id()));
        let [mine, done] = ["mine", "done"].map(|name| folder.join(name));
        for part in ["usr/bin", "lib/x-linux-gnu", "usr/lib/x-linux-gnu"] {
            fs::create_dir_all(mine.join(part)).unwrap();
        }
        let program = mine.join("usr/bin/say");
        fs::write(&program, "#!/bin/sh\necho \"$LD_LIBRARY_PATH $1 $2\"\n").unwrap();
        fs::set_permissions(&program, fs::Permissions::from_mode(0o755)).unwrap();
        finish("say", &mine, &done).unwrap();
        let script = unpack("say", &done).unwrap();
        let said = output(Command::new(&script).args(["one", "two words"])).unwrap();
        let here = done.display();
        assert!(said.starts_with(&format!("{here}/usr/lib/x-linux-gnu:{here}/lib/x-linux-gnu:")), "{said}");
        assert!(said.ends_with(" one two words"), "{said}");
        fs::remove_dir_all(&folder).unwrap();
    }
}
