//! The stages of the generator: what each module may import, and that it imports nothing else.

use std::fs;
use std::path::{Path, PathBuf};

/// Module, and the modules it may name by `crate::`.
const MAY_IMPORT: [(&str, &[&str]); 16] = [
    ("id", &[]),
    ("source", &[]),
    ("words", &[]),
    ("section", &[]),
    ("sorted", &[]),
    ("escape", &[]),
    ("diagnostic", &["escape", "source"]),
    ("expr", &["id", "section"]),
    ("model", &["id", "source", "words", "diagnostic"]),
    ("vector", &["id", "sorted", "expr", "model"]),
    ("kinematics", &["id", "source", "words", "section", "sorted", "diagnostic", "expr", "model", "vector"]),
    ("dynamics", &["id", "source", "section", "diagnostic", "expr", "model", "vector", "kinematics"]),
    ("program", &["id", "source", "diagnostic", "expr", "model", "kinematics", "dynamics", "value"]),
    ("value", &["id", "expr"]),
    ("rust", &["escape", "id", "words", "section", "expr", "program"]), // no mechanics
    ("build", &["escape", "source", "diagnostic", "model", "kinematics", "program", "rust", "value"]),
];

fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            files.push(path);
        }
    }
    files.sort();
    files
}

/// Modules named after `crate::`; the crate imports one module a `use`.
fn imports(text: &str) -> Vec<String> {
    let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    code.flat_map(|line| {
        line.split("crate::").skip(1).map(|rest| {
            rest.chars().take_while(|c| c.is_ascii_alphanumeric() || *c == '_').collect::<String>()
        })
    })
    .collect()
}

fn violations(file: &str, text: &str) -> Vec<String> {
    let module = file.split(['/', '.']).next().unwrap_or_default();
    let Some((_, allowed)) = MAY_IMPORT.iter().find(|(name, _)| *name == module) else {
        return vec![format!("{file}: `{module}` is not in the table of modules")];
    };
    imports(text)
        .into_iter()
        .filter(|name| name != module && !allowed.contains(&name.as_str()))
        .map(|name| format!("{file} must not import `{name}`"))
        .collect()
}

#[test]
fn data_flows_downwards() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut found = Vec::new();
    for path in rust_files(&source) {
        let file = path.strip_prefix(&source).expect("below src").to_string_lossy().replace('\\', "/");
        if file != "lib.rs" {
            found.extend(violations(&file, &fs::read_to_string(&path).expect("text")));
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn a_wrong_import_is_seen() {
    assert_eq!(violations("rust/mod.rs", "use crate::kinematics::Row;").len(), 1);
    assert_eq!(violations("expr/mod.rs", "let x = crate::model::parse();").len(), 1);
    assert!(violations("rust/mod.rs", "use crate::program::Program;").is_empty());
}
