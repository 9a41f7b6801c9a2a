//! Installs packages of the distribution, if the machine's package manager can.
//!
//! In: what is missing, the packages that contain it, and a command for other systems. On Debian and its relatives, as
//! root or with `sudo -n`, apt-get installs them; otherwise the failure names the command.

use crate::failure::Failure;
use crate::firmware::process::{self, output, which};
use std::process::Command;
use std::time::Duration;

/// Installs Debian packages, or fails with `why` and `help`.
///
/// # Errors
/// [`Failure::Lacking`] if there is no apt-get, no permission to use it, or it fails.
pub fn install(why: &str, packages: &[&str], help: &str) -> Result<(), Failure> {
    let Some(root) = root_on_debian() else { return Err(lacking(why, help)) };
    crate::output::say(&format!("{why}; installing {} by apt-get", packages.join(" ")));
    let _waiting = crate::progress::Waiting::new("apt-get");
    let apt = |arguments: &[&str]| apt(root, arguments);
    // `--no-remove`: must not remove a package that is installed already; see `unpack`.
    let mut install = vec!["install", "--yes", "--no-install-recommends", "--no-remove"];
    install.extend(packages);
    if apt(&install).is_ok() {
        return Ok(());
    }
    let done = apt(&["update"]).and_then(|()| apt(&install));
    done.map_err(|log| {
        Failure::Lacking(format!("{why}, and apt-get could not install it: run `{help}`\n{log}"))
    })
}

/// The size of an installation, in apt-get's words and preceded by a comma, if it reports one; `None` if apt-get cannot
/// be used.
#[must_use]
pub fn size_of(packages: &[&str]) -> Option<String> {
    root_on_debian()?;
    let mut command = Command::new("apt-get");
    command.args(["install", "--assume-no", "--no-install-recommends", "--no-remove"]).args(packages);
    // It exits with an error, because it has been answered "no".
    let printed = command.env("LC_ALL", "C").stdin(std::process::Stdio::null()).output().ok()?.stdout;
    Some(size_in(&String::from_utf8_lossy(&printed)))
}

/// The lines of apt-get's output that state download and disk sizes.
fn size_in(printed: &str) -> String {
    let told = |line: &&str| line.starts_with("Need to get ") || line.starts_with("After this operation, ");
    let lines: Vec<&str> = printed.lines().filter(told).map(|line| line.trim_end_matches('.')).collect();
    if lines.is_empty() { String::new() } else { format!(" ({})", lines.join("; ")) }
}

/// Lets apt-get update its package lists.
///
/// # Errors
/// [`Failure::Lacking`] where that fails.
pub fn update_lists() -> Result<(), Failure> {
    let help = "apt-get update";
    let Some(root) = root_on_debian() else { return Err(lacking("the package lists may be old", help)) };
    apt(root, &["update"])
        .map_err(|log| Failure::Lacking(format!("apt-get cannot update: run `{help}`\n{log}")))
}

/// Number of attempts while another process uses apt, and the pause between them: ten minutes in all.
const PATIENCE: (usize, Duration) = (300, Duration::from_secs(2));

/// Runs apt-get with the prefix from [`root_on_debian`]; on failure returns what it printed.
///
/// While another process holds one of apt's locks, it is run again.
pub(crate) fn apt(root: &[&str], arguments: &[&str]) -> Result<(), String> {
    let mut command = Command::new(root[0]);
    command.args(&root[1..]).args(arguments).env("DEBIAN_FRONTEND", "noninteractive").env("LC_ALL", "C");
    for _ in 0..PATIENCE.0 {
        match process::run_quietly(&mut command) {
            Err(log) if is_locked_out(&log) => std::thread::sleep(PATIENCE.1),
            done => return done,
        }
    }
    process::run_quietly(&mut command)
}

/// Does apt-get report that another process holds a lock?
fn is_locked_out(log: &str) -> bool {
    log.contains("Could not get lock")
}

/// The failure that names what is missing and the command that installs it.
#[must_use]
pub fn lacking(why: &str, help: &str) -> Failure {
    Failure::Lacking(format!("{why}: run `{help}`"))
}

/// The prefix of apt-get's command line, if this process is root or can become root without a password.
pub(crate) fn root_on_debian() -> Option<&'static [&'static str]> {
    which("apt-get")?;
    let release = std::fs::read_to_string("/etc/os-release").unwrap_or_default();
    if !is_debian(&release) {
        return None;
    }
    if output(Command::new("id").arg("-u")).as_deref() == Some("0") {
        return Some(&["apt-get"]);
    }
    output(Command::new("sudo").args(["-n", "true"])).map(|_| ["sudo", "-n", "apt-get"].as_slice())
}

/// Does the text of os-release name Debian, Ubuntu or a relative?
fn is_debian(release: &str) -> bool {
    release
        .lines()
        .filter_map(|l| l.strip_prefix("ID=").or_else(|| l.strip_prefix("ID_LIKE=")))
        .flat_map(|names| names.trim_matches('"').split_whitespace())
        .any(|name| name == "debian" || name == "ubuntu")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distributions() {
        assert!(is_debian("PRETTY_NAME=\"x\"\nID=debian\n"));
        assert!(is_debian("ID=linuxmint\nID_LIKE=\"ubuntu debian\"\n"));
        assert!(!is_debian("ID=fedora\nID_LIKE=rhel\n"));
    }

    #[test]
    fn another_user_of_apt_is_waited_for_and_nothing_else() {
        let held = "E: Could not get lock /var/lib/dpkg/lock-frontend. It is held by process 12059 (apt-get)";
        assert!(is_locked_out(held));
        assert!(!is_locked_out(
            "E: Could not open lock file /var/lib/dpkg/lock-frontend - open (13: Permission denied)"
        ));
        assert!(!is_locked_out("E: Unable to locate package x"));
    }

    #[test]
    fn the_size_is_apt_s_own() {
        let printed = "Reading package lists...\nThe following NEW packages will be installed:\n  lld\n\
                       Need to get 1,417 kB of archives.\nAfter this operation, 4,913 kB of additional disk space will be used.\n\
                       Do you want to continue? [Y/n] N\nAbort.\n";
        assert_eq!(
            size_in(printed),
            " (Need to get 1,417 kB of archives; After this operation, 4,913 kB of additional disk space will be used)"
        );
        assert_eq!(size_in("E: Unable to locate package x\n"), "");
    }

    #[test]
    fn what_is_lacking_is_named_with_its_command() {
        let failure = lacking("no toolchain", "rustup target add x");
        assert_eq!(failure.status(), 2);
        assert_eq!(failure.to_string(), "no toolchain: run `rustup target add x`");
    }
}
