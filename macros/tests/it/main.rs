//! The macro as its user meets it: a crate that is built, run, broken and mended.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The example as a crate of its own, with this repository's versions, which are at hand without a network.
fn press_crate() -> PathBuf {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("press_crate");
    for file in ["src/main.rs", "models/press.toml"] {
        let target = folder.join(file);
        std::fs::create_dir_all(target.parent().expect("a folder")).expect("a folder");
        std::fs::copy(here.join("examples/press_crate").join(file), target).expect("copied");
    }
    let manifest = std::fs::read_to_string(here.join("examples/press_crate/Cargo.toml")).expect("readable");
    let manifest = manifest
        .replace("\"../../../runtime\"", &format!("{:?}", here.join("../runtime")))
        .replace("\"../..\"", &format!("{here:?}"));
    std::fs::write(folder.join("Cargo.toml"), manifest).expect("writable");
    std::fs::copy(here.join("../Cargo.lock"), folder.join("Cargo.lock")).expect("copied");
    folder
}

fn cargo_run(folder: &Path) -> Output {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    Command::new(cargo)
        .args(["run", "--offline", "--quiet", "--target-dir"])
        .arg(folder.join("target"))
        .current_dir(folder)
        .env_remove("CARGO_TARGET_DIR")
        .output()
        .expect("cargo runs")
}

fn said(output: &Output) -> [String; 2] {
    [&output.stdout, &output.stderr].map(|text| String::from_utf8_lossy(text).into_owned())
}

/// m z'' = -m g - F - k (z - l) at z = l, with the m that the macro sets; then with another g, found because the file
/// has changed; then a model that is wrong.
#[test]
fn a_model_is_built_rebuilt_and_refused_at_its_place() {
    let folder = press_crate();
    let [out, err] = said(&cargo_run(&folder));
    assert_eq!(out.trim(), format!("{:.3} m/s^2", -9.81 - 100.0 / 10.0), "{err}");
    assert!(!err.contains("warning"), "{err}");

    let model = folder.join("models/press.toml");
    let text = std::fs::read_to_string(&model).expect("readable");
    std::fs::write(&model, text.replace("9.81", "1.62")).expect("writable");
    let [out, err] = said(&cargo_run(&folder));
    assert_eq!(out.trim(), format!("{:.3} m/s^2", -1.62 - 100.0 / 10.0), "the model has changed: {err}");

    std::fs::write(&model, text.replace("\"-F*N.z\"", "\"-G*N.z\"")).expect("writable");
    let bad = cargo_run(&folder);
    let [_, err] = said(&bad);
    assert!(!bad.status.success());
    let line = text.lines().position(|line| line.starts_with("motor")).expect("a force") + 1;
    for part in ["unknown name `G`", &format!("models/press.toml:{line}:"), "--> src/main.rs:7:33"] {
        assert_eq!(err.matches(part).count(), 1, "{part}, once:\n{err}");
    }
    std::fs::remove_dir_all(&folder).expect("its own folder");
}
