//! The example crate is built as it stands, runs, and shows a model's errors with their place.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn copy(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).expect("a folder");
    for entry in std::fs::read_dir(from).expect("readable").map(|e| e.expect("an entry").path()) {
        let target = to.join(entry.file_name().expect("a name"));
        if entry.is_dir() {
            copy(&entry, &target);
        } else {
            std::fs::copy(&entry, &target).expect("copied");
        }
    }
}

fn cargo_run(crate_folder: &Path) -> Output {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    Command::new(cargo)
        .args(["run", "--quiet", "--target-dir"])
        .arg(crate_folder.join("target"))
        .current_dir(crate_folder)
        .env_remove("CARGO_TARGET_DIR")
        .output()
        .expect("cargo runs")
}

#[test]
fn example_crate_builds_runs_and_explains() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("pendulum_crate");
    copy(&here.join("examples/pendulum_crate"), &folder);
    // Its paths from the copy; the versions of this repository.
    let manifest = std::fs::read_to_string(folder.join("Cargo.toml")).expect("readable");
    let manifest = manifest
        .replace("\"../../../runtime\"", &format!("{:?}", here.join("../runtime")))
        .replace("\"../..\"", &format!("{here:?}"));
    std::fs::write(folder.join("Cargo.toml"), manifest).expect("writable");
    std::fs::copy(here.join("../Cargo.lock"), folder.join("Cargo.lock")).expect("copied");

    let good = cargo_run(&folder);
    let (out, err) = (String::from_utf8_lossy(&good.stdout), String::from_utf8_lossy(&good.stderr));
    assert!(good.status.success(), "{err}");
    // The energy of 0.5 kg at 0.3 m, 30 degrees from the vertical, kept to the digits printed.
    let energy = -0.5 * 9.81 * 0.3 * 30_f64.to_radians().cos();
    let expected = format!("energy {energy:.9} J -> {energy:.9} J");
    assert!(out.contains(&expected), "{out} lacks {expected}");
    assert!(!String::from_utf8_lossy(&good.stderr).contains("warning"), "{err}");

    let model = folder.join("models/pendulum.toml");
    let text = std::fs::read_to_string(&model).expect("readable");
    std::fs::write(&model, text.replace("-l*rod.z", "-l*rodd.z")).expect("writable");
    let bad = cargo_run(&folder);
    let err = String::from_utf8_lossy(&bad.stderr);
    assert!(!bad.status.success());
    assert!(err.contains("models/pendulum.toml:"), "{err}");
    assert_eq!(err.matches("unknown frame `rodd`").count(), 1, "once:\n{err}");
}
