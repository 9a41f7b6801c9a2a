//! Runs other programs, without terminal input and without the environment variables that a rustup proxy sets.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Variables by which cargo or rustup pins the tools of the processes that it starts.
const LEAKS: [&str; 13] = [
    "RUSTUP_TOOLCHAIN",
    "CARGO",
    "RUSTC",
    "RUSTDOC",
    "RUSTC_WRAPPER",
    "RUSTC_WORKSPACE_WRAPPER",
    "CARGO_ENCODED_RUSTFLAGS",
    "RUSTFLAGS",
    "CARGO_BUILD_TARGET",
    "CARGO_TARGET_DIR",
    "CARGO_MAKEFLAGS",
    "LD_LIBRARY_PATH",
    "RUSTC_BOOTSTRAP",
];

/// A command without input and without the variables that would pin another toolchain.
#[must_use]
pub fn clean(program: &Path) -> Command {
    let mut command = Command::new(program);
    for name in LEAKS {
        command.env_remove(name);
    }
    command.stdin(Stdio::null());
    command
}

/// Standard output, trimmed, of a program; `None` if it fails.
#[must_use]
pub fn output(command: &mut Command) -> Option<String> {
    let output = command.stdin(Stdio::null()).output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

/// Runs a program to its end.
///
/// # Errors
/// Everything that it printed, if it fails.
pub fn run_quietly(command: &mut Command) -> Result<(), String> {
    let output = command.stdin(Stdio::null()).output().map_err(|e| format!("{}: {e}", name(command)))?;
    if output.status.success() {
        return Ok(());
    }
    let text = [output.stdout, output.stderr].concat();
    Err(format!("{} failed:\n{}", name(command), String::from_utf8_lossy(&text).trim()))
}

/// Runs a program for at most `limit` and returns its standard output, which must fit into a pipe: it is read only
/// after the program has ended.
///
/// # Errors
/// What it printed to standard error, or that the limit has passed; the program is then ended.
pub fn run_limited(command: &mut Command, limit: Duration) -> Result<String, String> {
    let name = name(command);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().map_err(|e| format!("{name}: {e}"))?;
    let start = Instant::now();
    while child.try_wait().map_err(|e| format!("{name}: {e}"))?.is_none() {
        if start.elapsed() > limit {
            let ended = child.kill().and_then(|()| child.wait());
            let note = ended.err().map(|e| format!(" ({e})")).unwrap_or_default();
            return Err(format!("{name} did not end within {} s and was ended{note}", limit.as_secs()));
        }
        sleep(Duration::from_millis(2));
    }
    let output = child.wait_with_output().map_err(|e| format!("{name}: {e}"))?;
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).trim().to_owned();
    if output.status.success() {
        return Ok(text(&output.stdout));
    }
    Err(format!("{name} failed ({}): {} {}", output.status, text(&output.stdout), text(&output.stderr)))
}

/// The first file of that name in the folders of PATH.
#[must_use]
pub fn which(name: &str) -> Option<PathBuf> {
    std::env::split_paths(&std::env::var_os("PATH")?).map(|d| d.join(name)).find(|p| p.is_file())
}

fn name(command: &Command) -> String {
    Path::new(command.get_program()).file_name().unwrap_or_default().to_string_lossy().into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_program_that_hangs_is_ended() {
        let error = run_limited(Command::new("sleep").arg("60"), Duration::from_millis(50)).unwrap_err();
        assert!(error.contains("did not end within"), "{error}");
    }

    #[test]
    fn a_program_that_fails_says_so() {
        let error = run_quietly(Command::new("sh").args(["-c", "echo no >&2; exit 3"])).unwrap_err();
        assert_eq!(error, "sh failed:\nno");
    }
}
