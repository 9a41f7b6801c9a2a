//! Scenes and engines are a library without the command line: code that reads, builds and moves a scene or a mechanism
//! uses neither options nor printing nor any subcommand. Pictures of scenes are separate and may draw.

use std::fs;
use std::path::{Path, PathBuf};

/// Folders of the library.
const LIBRARY: [&str; 4] = ["scene", "world", "engine", "plan"];
/// What it may use of this crate; of `firmware` how it runs other programs.
const ALLOWED: [&str; 16] = [
    "chatter",
    "configuration",
    "contact_force",
    "engine",
    "failure",
    "firmware",
    "hash",
    "input",
    "json",
    "limits",
    "number",
    "observers",
    "switches",
    "scene",
    "suggest",
    "world",
];
/// Files that draw, which may use `plot` too.
const PICTURES: [&str; 2] = ["scene/graph.rs", "scene/pictures.rs"];
/// What is left to be moved out of the library: the names of engines on the command line, and the word that a build
/// takes its time.
const LEFT: [(&str, &str); 2] = [("engine/kinds.rs", "clap"), ("engine/cache.rs", "crate::output")];

fn rust_files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            rust_files(&path, found);
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            found.push(path);
        }
    }
}

/// What in a file of the library belongs to the command line, as messages.
fn violations(file: &str, text: &str) -> Vec<String> {
    let code = text.lines().map(str::trim_start).filter(|line| !line.starts_with("//"));
    let mut found = Vec::new();
    for line in code {
        for tool in ["clap", "println!", "eprintln!", "process::exit", "crate::output"] {
            if line.contains(tool) && !LEFT.contains(&(file, tool)) {
                found.push(format!("{file}: {tool} in `{line}`"));
            }
        }
        for used in line.split("use crate::").skip(1) {
            let name: String = used.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
            let draws = name == "plot" && PICTURES.contains(&file);
            if !draws && !ALLOWED.contains(&name.as_str()) {
                found.push(format!("{file} must not use `{name}`"));
            }
        }
    }
    found
}

#[test]
fn simulation_is_a_library_without_the_command_line() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    LIBRARY.iter().for_each(|folder| rust_files(&source.join(folder), &mut files));
    assert!(files.len() > 15, "{files:?}");
    let mut found = Vec::new();
    for path in files {
        let file = path.strip_prefix(&source).expect("below src").to_string_lossy().replace('\\', "/");
        found.extend(violations(&file, &fs::read_to_string(&path).expect("text")));
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn the_test_sees_what_it_must() {
    assert_eq!(violations("scene/run.rs", "use crate::json;\n// use clap::Args;").len(), 0);
    assert_eq!(violations("scene/run.rs", "use crate::report::Point;").len(), 1);
    assert_eq!(violations("scene/run.rs", "use crate::plot::Axis;").len(), 1);
    assert_eq!(violations("scene/graph.rs", "use crate::plot::Axis;").len(), 0);
    assert_eq!(violations("scene/read/mod.rs", "    crate::output::say(\"reading\");").len(), 1);
    assert_eq!(violations("engine/new.rs", "#[derive(clap::Args)]").len(), 1);
}
