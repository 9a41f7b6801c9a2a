//! Counts the source files that a new answer, joint or kind of orientation touches (docs/extending.md).

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

fn rust_files(folder: &Path, found: &mut Vec<PathBuf>) {
    for path in std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()) {
        if path.is_dir() {
            rust_files(&path, found);
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            found.push(path);
        }
    }
}

/// Texts of the generator's source files by path, without their tests.
fn sources() -> BTreeMap<String, String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    rust_files(&folder, &mut files);
    let text = |path: &PathBuf| {
        let text = std::fs::read_to_string(path).expect("a text");
        text.split("#[cfg(test)]").next().unwrap_or_default().to_owned()
    };
    files
        .iter()
        .map(|path| (path.strip_prefix(&folder).expect("inside").display().to_string(), text(path)))
        .collect()
}

/// The files that hold one of these pieces of text.
fn holding<'s>(sources: &'s BTreeMap<String, String>, pieces: &[&str]) -> Vec<&'s str> {
    let holds = |text: &str| pieces.iter().any(|piece| text.contains(piece));
    sources.iter().filter(|(_, text)| holds(text)).map(|(path, _)| path.as_str()).collect()
}

#[test]
fn an_answer_is_an_entry_of_the_list_and_a_function() {
    let sources = sources();
    for answer in
        ["momentum", "inverse_dynamics", "linearisation", "multipliers", "inverse_inertia", "jacobian"]
    {
        let derive = format!("fn {answer}(");
        let in_answers: BTreeMap<String, String> = sources
            .iter()
            .filter(|(path, _)| path.starts_with("program/answer/"))
            .map(|(p, t)| (p.clone(), t.clone()))
            .collect();
        let touched = holding(&in_answers, &[&derive, &format!("kind(\"{answer}\"")]);
        assert_eq!(touched.len(), 2, "{answer}: {touched:?}");
        assert!(touched.contains(&"program/answer/mod.rs"), "{answer}: {touched:?}");
        let elsewhere = holding(&sources, &[&format!("== \"{answer}\"")]);
        assert!(elsewhere.is_empty(), "`{answer}` is treated in a way of its own by {elsewhere:?}");
    }
}

#[test]
fn a_joint_is_a_row_of_one_table() {
    let sources = sources();
    for word in ["revolute", "cylindrical", "universal", "spherical", "free", "knife_edge", "rolling_ball"] {
        assert_eq!(holding(&sources, &[&format!("\"{word}\"")]), ["model/text/joints/kind.rs"], "{word}");
    }
}

/// The kind with its parent and expressions, its text, its triad.
#[test]
fn an_orientation_kind_is_named_by_three_files() {
    let sources = sources();
    let three = ["kinematics/orientation.rs", "model/frame.rs", "model/text/mechanics.rs"];
    for kind in ["Directions", "Euler"] {
        let pieces = [format!("Orientation::{kind}"), format!("Self::{kind}")];
        let pieces: Vec<&str> = pieces.iter().map(String::as_str).collect();
        assert_eq!(holding(&sources, &pieces), three, "{kind}");
    }
}
