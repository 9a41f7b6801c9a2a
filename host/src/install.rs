//! Installs packages of the distribution, where the machine's package manager can.
//!
//! In: what is lacking, the packages that bring it, the command that helps elsewhere. On Debian and its
//! relatives, as root or with `sudo -n`, apt-get installs them; else the failure names the command.

use crate::failure::Failure;
use crate::firmware::process::{self, output, which};
use std::process::Command;

/// Installs Debian packages, or fails with `why` and `help`.
///
/// # Errors
/// [`Failure::Lacking`] where there is no apt-get, no right to use it, or it fails.
pub fn install(why: &str, packages: &[&str], help: &str) -> Result<(), Failure> {
    let Some(root) = root_on_debian() else { return Err(lacking(why, help)) };
    eprintln!("{why}; installing {} by apt-get", packages.join(" "));
    let apt = |arguments: &[&str]| apt(root, arguments);
    // Never at the cost of a package that is already there.
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

/// Has apt-get read anew which versions there are.
///
/// # Errors
/// [`Failure::Lacking`] where that fails.
pub fn update_lists() -> Result<(), Failure> {
    let help = "apt-get update";
    let Some(root) = root_on_debian() else { return Err(lacking("the package lists may be old", help)) };
    apt(root, &["update"])
        .map_err(|log| Failure::Lacking(format!("apt-get cannot update: run `{help}`\n{log}")))
}

fn apt(root: &[&str], arguments: &[&str]) -> Result<(), String> {
    let mut command = Command::new(root[0]);
    command.args(&root[1..]).args(arguments).env("DEBIAN_FRONTEND", "noninteractive");
    process::run_quietly(&mut command)
}

/// The failure that names what is lacking and the command that helps.
#[must_use]
pub fn lacking(why: &str, help: &str) -> Failure {
    Failure::Lacking(format!("{why}: run `{help}`"))
}

/// The command line in front of apt-get's arguments, if we are root or become root unasked.
fn root_on_debian() -> Option<&'static [&'static str]> {
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
    fn what_is_lacking_is_named_with_its_command() {
        let failure = lacking("no toolchain", "rustup target add x");
        assert_eq!(failure.status(), 2);
        assert_eq!(failure.to_string(), "no toolchain: run `rustup target add x`");
    }
}
