//! Manifests of the packages: oldest supported compiler, and no effect on other packages of a user's build.

use std::path::{Path, PathBuf};
use std::process::Command;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn text(path: &str) -> String {
    std::fs::read_to_string(root().join(path)).unwrap_or_else(|e| panic!("{path}: {e}"))
}

/// The value of the first line `key = "value"`.
fn value<'t>(text: &'t str, key: &str) -> &'t str {
    let line = text.lines().find_map(|line| line.trim().strip_prefix(key)?.trim().strip_prefix('='));
    line.unwrap_or_else(|| panic!("no {key}")).trim().trim_matches('"')
}

#[test]
fn every_package_declares_the_oldest_compiler_and_the_lints_that_hold_it() {
    let workspace = text("Cargo.toml");
    let oldest = value(&workspace, "rust-version");
    assert_eq!(value(&workspace, "incompatible_msrv"), "deny");
    let members = value(&workspace, "members").trim_matches(['[', ']']);
    let members: Vec<&str> = members.split(',').map(|name| name.trim().trim_matches('"')).collect();
    assert!(5 < members.len(), "{members:?}");
    for member in members {
        let manifest = text(&format!("{member}/Cargo.toml"));
        assert!(manifest.contains("rust-version.workspace = true"), "{member}");
        assert!(manifest.contains("[lints]\nworkspace = true"), "{member}");
    }
    // Derived crates and the search for a toolchain name it once more.
    let derived = text("host/src/engine/crate_text.rs");
    assert!(derived.contains(&format!("rust-version = \\\"{oldest}\\\"")), "derived crates: {oldest}");
    let numbers = oldest.replace('.', ", ");
    assert!(text("host/src/firmware/toolchain.rs").contains(&format!("OLDEST: (u32, u32) = ({numbers})")));
}

/// Functions newer than the declared compiler fail clippy with the workspace's lints.
#[test]
fn what_is_newer_than_the_declared_compiler_is_found() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("newer");
    std::fs::create_dir_all(folder.join("src")).expect("a folder");
    let workspace = text("Cargo.toml");
    let lints = &workspace[workspace.find("[workspace.lints.rust]").expect("lints")..];
    let lints = &lints[..lints.find("[profile").expect("profiles")];
    let clippy = |oldest: &str| {
        let manifest = format!(
            "[package]\nname = \"newer\"\nversion = \"0.1.0\"\nedition = \"2021\"\nrust-version = \"{oldest}\"\n[workspace]\n{}",
            lints.replace("[workspace.lints", "[lints")
        );
        std::fs::write(folder.join("Cargo.toml"), manifest).expect("written");
        // Of Rust 1.73.
        let code =
            "//! A crate.\n\n/// Half, upwards.\npub fn half(n: usize) -> usize {\n    n.div_ceil(2)\n}\n";
        std::fs::write(folder.join("src/lib.rs"), code).expect("written");
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args(["clippy", "--quiet", "--offline", "--target-dir"]).arg(folder.join("target"));
        let done = cargo.current_dir(&folder).output().expect("clippy");
        (done.status.success(), String::from_utf8_lossy(&done.stderr).into_owned())
    };
    let (passes, message) = clippy("1.72");
    assert!(!passes && message.contains("current MSRV"), "{message}");
    let (passes, message) = clippy("1.73");
    assert!(passes, "{message}");
}

/// Cargo unites the features of a package over all its users: features of proc-macro2 requested by the generator would
/// apply to every procedural macro of its user's build.
#[test]
fn the_generator_asks_nothing_of_the_packages_of_procedural_macros() {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["tree", "--package", "smartbed-codegen", "--edges", "normal,build", "--prefix", "none"]);
    let done = cargo.current_dir(root()).output().expect("cargo tree");
    let tree = String::from_utf8_lossy(&done.stdout);
    let names: Vec<&str> = tree.lines().filter_map(|line| line.split(' ').next()).collect();
    assert!(
        done.status.success() && names.contains(&"smartbed-codegen") && names.contains(&"toml"),
        "{tree}"
    );
    for name in ["proc-macro2", "syn", "quote"] {
        assert!(!names.contains(&name), "{tree}");
    }
}
