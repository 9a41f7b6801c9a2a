//! `docs/safety.md` names only existing files, functions, tests, and the crates of `Cargo.lock`.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Behaviours of the bed, rules of the firmware, and the check of its own program.
const ROWS: usize = 20 + 16 + 1;
/// Crates that only tests and the generator need; no image links them.
const NOT_LINKED: [&str; 5] = ["cobs 0.5.1", "crc", "proptest", "smartbed-codegen", "smartbed-runtime"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn text(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|e| panic!("{path}: {e}"))
}

/// Cells of the rows below a heading of a table.
fn rows(document: &str, heading: &str) -> Vec<Vec<String>> {
    let heading = format!("| {heading} |");
    let below = document.split(&heading).skip(1);
    let lines = below.flat_map(|table| table.lines().skip(2).take_while(|line| line.starts_with("| ")));
    lines.map(|line| line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect()).collect()
}

/// The error in a cell "`file` `name`"; `before` lists the texts that may precede the name in its file.
fn fault(cell: &str, before: &[&str]) -> Option<String> {
    let quoted: Vec<&str> = cell.split('`').skip(1).step_by(2).collect();
    let [file, name] = quoted[..] else { return Some(format!("`{cell}`: expected a file and a name")) };
    let Ok(text) = fs::read_to_string(root().join(file)) else { return Some(format!("no file {file}")) };
    let is_there = before.iter().any(|before| {
        let wanted = format!("{before}{name}");
        let mut places = text.match_indices(&wanted);
        places.any(|(at, found)| {
            text[at + found.len()..].chars().next().is_some_and(|c| !c.is_alphanumeric() && c != '_')
        })
    });
    (!is_there).then(|| format!("{file} has no `{name}`"))
}

#[test]
fn every_row_names_what_is_there() {
    let document = text("docs/safety.md");
    let rows: Vec<Vec<String>> =
        ["id | behaviour", "id | rule"].iter().flat_map(|h| rows_of(&document, h)).collect();
    assert_eq!(rows.len(), ROWS);
    let mut wrong = Vec::new();
    let mut ids = BTreeSet::new();
    for row in &rows {
        let [id, _, hazard, owner, state, code, test] = &row[..] else { panic!("{row:?}: seven cells") };
        assert!(ids.insert(id.clone()), "{id} twice");
        if hazard.is_empty() || owner.is_empty() || !["HOLD", "RETREAT", "OFF"].contains(&state.as_str()) {
            wrong.push(format!("{id}: hazard, owner and a safe state are expected"));
        }
        // Behaviours out of scope have a reason in place of code.
        if owner.starts_with("out of scope: ") && code.is_empty() && test.is_empty() {
            continue;
        }
        let found = fault(code, &["fn ", "struct ", "enum ", "pub "]).into_iter();
        let found = found.chain(fault(test, &["#[test]\nfn ", "#[test]\n    fn ", "#[test]\n        fn "]));
        wrong.extend(found.map(|what| format!("{id}: {what}")));
    }
    assert!(wrong.is_empty(), "docs/safety.md:\n{}", wrong.join("\n"));
}

/// As [`rows`], for a heading given by its beginning.
fn rows_of(document: &str, beginning: &str) -> Vec<Vec<String>> {
    let heading = document.lines().find_map(|l| l.strip_prefix("| ").filter(|l| l.starts_with(beginning)));
    rows(document, heading.expect("a table").trim_end_matches(" |"))
}

#[test]
fn a_row_that_names_nothing_is_seen() {
    assert_eq!(fault("`firmware/src/node.rs` `tick`", &["fn "]), None);
    assert!(fault("`firmware/src/node.rs` `tic`", &["fn "]).is_some());
    assert!(fault("`firmware/src/nod.rs` `tick`", &["fn "]).is_some());
    assert!(fault("tick", &["fn "]).is_some());
}

#[test]
fn crates_are_those_that_are_locked() {
    let lock = text("Cargo.lock");
    // (name, version) and what each needs, as the file names it: with its version where there are several.
    let mut packages: BTreeMap<(String, String), Vec<String>> = BTreeMap::new();
    for package in lock.split("[[package]]").skip(1) {
        let value = |key: &str| {
            let line = package.lines().find_map(|l| l.strip_prefix(&format!("{key} = \"")));
            line.map(|l| l.trim_end_matches('"').to_owned()).unwrap_or_default()
        };
        let needs = package
            .lines()
            .filter_map(|l| l.strip_prefix(" \""))
            .map(|l| l.trim_end_matches("\",").to_owned());
        packages.insert((value("name"), value("version")), needs.collect());
    }
    let find = |needed: &str| -> (String, String) {
        let (name, version) = needed.split_once(' ').unwrap_or((needed, ""));
        let found = packages.keys().find(|(n, v)| n == name && (version.is_empty() || v == version));
        found.unwrap_or_else(|| panic!("{needed} is not locked")).clone()
    };
    let mut linked = BTreeSet::new();
    let mut waiting: Vec<String> = packages[&find("smartbed-firmware")].clone();
    waiting.push("libm".to_owned());
    waiting.retain(|name| !NOT_LINKED.contains(&name.as_str()));
    while let Some(name) = waiting.pop() {
        let package = find(&name);
        if linked.insert(package.clone()) {
            waiting.extend(packages[&package].clone());
        }
    }
    let document = text("docs/safety.md");
    let listed: BTreeSet<(String, String)> = rows(&document, "crate | version | for")
        .into_iter()
        .map(|row| (row[0].clone(), row[1].clone()))
        .collect();
    assert_eq!(listed, linked, "docs/safety.md lists what Cargo.lock locks");
}
