//! Where the worlds of `models/scenes` end, as a golden file: a change of numerics is seen, whatever it was meant for.
//!
//! `UPDATE_GOLDEN=1 cargo test -p smartbed --test world -- pinned` writes the file.

use super::support::{json, number};
use smartbed::file_kind::FileKind;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Of a value and 1: every machine computes the same bits, but not every version of a library of functions.
const NEAR: f64 = 1e-9;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Names of the scenes of format 2.
fn scenes() -> Vec<String> {
    let files = std::fs::read_dir(root().join("models/scenes")).expect("a folder");
    let mut names: Vec<String> = files
        .map(|file| file.expect("a file").path())
        .filter(|path| FileKind::of(path) == FileKind::World)
        .map(|path| path.file_stem().expect("a name").to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

/// Whether a column stands for others: of the nodes of a part, only the first.
fn is_kept(name: &str) -> bool {
    let letters = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let number = &name[letters.len()..];
    number.is_empty() || number == "0" || !letters.ends_with(['x', 'y', 'z'])
}

/// Last row, number of events and accounts of a scene.
fn end(scene: &str) -> BTreeMap<String, f64> {
    let done = json(&[scene]);
    let last = done["last"].as_object().expect("a row");
    let mut values: BTreeMap<String, f64> = last
        .iter()
        .filter(|(name, value)| is_kept(name) && value.is_number())
        .map(|(name, value)| (name.clone(), number(value)))
        .collect();
    values.insert("events".to_owned(), done["events"].as_array().expect("a list").len() as f64);
    values.insert("imbalance".to_owned(), number(&done["imbalance"]));
    values
}

#[test]
fn scenes_end_where_the_golden_file_says() {
    let file = root().join("tests/golden/worlds.csv");
    let mut found = String::from("scene,quantity,value\n");
    let ends: Vec<_> = scenes().into_iter().map(|scene| (end(&scene), scene)).collect();
    for (values, scene) in &ends {
        for (name, value) in values {
            writeln!(found, "{scene},{name},{value:e}").expect("written");
        }
    }
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        std::fs::write(&file, &found).expect("the golden file is written");
    }
    let golden = std::fs::read_to_string(&file).expect("the golden file");
    assert_eq!(golden.lines().count(), found.lines().count(), "other scenes or columns: {}", file.display());
    let mut off = Vec::new();
    for (expected, found) in golden.lines().zip(found.lines()).skip(1) {
        let [(name, expected), (found_name, found)] =
            [expected, found].map(|line| line.rsplit_once(',').expect("a value"));
        assert_eq!(name, found_name);
        let [expected, found]: [f64; 2] = [expected, found].map(|value| value.parse().expect("a number"));
        if (expected - found).abs() > NEAR * expected.abs().max(1.0) {
            off.push(format!("{name}: {found:e} instead of {expected:e}"));
        }
    }
    assert!(
        ends.len() > 14 && off.is_empty(),
        "{} values moved (if meant: UPDATE_GOLDEN=1):\n{}",
        off.len(),
        off.join("\n")
    );
}
