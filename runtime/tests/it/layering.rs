//! The layers of the runtime: a file imports only from layers above its own in `lib.rs`.

use std::fs;
use std::path::{Path, PathBuf};

/// Layers in the order in which `lib.rs` declares them.
fn layers(source: &Path) -> Vec<String> {
    let text = fs::read_to_string(source.join("lib.rs")).expect("lib.rs is there");
    let modules = text.lines().filter_map(|line| line.strip_prefix("pub mod "));
    modules.map(|name| name.trim_end_matches(';').to_owned()).collect()
}

fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            files.push(path);
        }
    }
    files.sort();
    files
}

/// The layers that a text refers to by `crate::`, also inside braces.
fn imports(text: &str) -> Vec<String> {
    let code =
        text.lines().filter(|line| !line.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n");
    let mut found = Vec::new();
    for rest in code.split("crate::").skip(1) {
        let list = rest.strip_prefix('{').map_or(rest, |inside| inside);
        let grouped = list.len() < rest.len();
        let mut depth = 0;
        let mut start = true;
        for (place, c) in list.char_indices() {
            if start && depth == 0 && (c.is_alphabetic() || c == '_') {
                let name = list[place..].chars().take_while(|c| c.is_alphanumeric() || *c == '_');
                found.push(name.collect());
                start = false;
            }
            match c {
                '{' => depth += 1,
                '}' if depth == 0 => break,
                '}' => depth -= 1,
                ',' if depth == 0 => start = true,
                ';' => break,
                _ => {}
            }
            if !grouped {
                break;
            }
        }
    }
    found
}

/// Imports that go upwards, as messages.
fn violations(layers: &[String], file: &str, text: &str) -> Vec<String> {
    let layer = file.split(['/', '.']).next().unwrap_or_default();
    let rank = |name: &str| layers.iter().position(|layer| layer == name);
    let Some(own) = rank(layer) else { return vec![format!("{file}: `{layer}` is not a layer of lib.rs")] };
    let upward = |name: &String| match rank(name) {
        Some(other) if other > own => Some(format!("{file} must not import `{name}`: it is a later layer")),
        Some(_) => None,
        None => Some(format!("{file} imports `{name}`, which lib.rs does not declare")),
    };
    imports(text).iter().filter_map(upward).collect()
}

#[test]
fn no_file_imports_from_a_later_layer() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let layers = layers(&source);
    assert!(layers.iter().position(|l| l == "real") == Some(0), "the numbers lie under everything");
    let mut found = Vec::new();
    for path in rust_files(&source) {
        let file = path.strip_prefix(&source).expect("below src").to_string_lossy().replace('\\', "/");
        if file != "lib.rs" {
            found.extend(violations(&layers, &file, &fs::read_to_string(&path).expect("text")));
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn the_layering_test_sees_what_it_must() {
    let layers = ["real", "mechanism", "ode"].map(str::to_owned);
    let check = |text| violations(&layers, "mechanism.rs", text).len();
    assert_eq!(check("use crate::real::Real;"), 0);
    assert_eq!(check("use crate::ode::State;"), 1);
    assert_eq!(check("use crate::{real::{Real, Scalar}, ode::State};"), 1);
    assert_eq!(check("fn f() -> crate::ode::State {}"), 1);
    assert_eq!(check("// crate::ode is below"), 0);
    assert_eq!(violations(&layers, "sensor/mod.rs", "").len(), 1);
}

#[cfg(feature = "source")]
#[test]
fn a_stand_alone_crate_gets_every_file_of_the_numbers() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut want = vec!["mechanism.rs".to_owned()];
    for path in rust_files(&source.join("real")) {
        want.push(format!("real/{}", path.file_name().expect("a file").to_string_lossy()));
    }
    let mut got = smartbed_runtime::SOURCES.to_vec();
    got.sort_unstable();
    want.sort();
    assert_eq!(got.iter().map(|(path, _)| *path).collect::<Vec<_>>(), want);
    for (path, text) in got {
        let known = imports(text).iter().all(|layer| ["real", "mechanism"].contains(&layer.as_str()));
        assert!(known, "{path} imports what the stand-alone crate does not have");
    }
}

#[cfg(feature = "source")]
#[test]
fn a_stand_alone_crate_that_steps_gets_every_integrator() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/ode");
    let files = fs::read_dir(source).expect("a folder").map(|entry| entry.expect("an entry").path());
    let mut want: Vec<String> = files
        .filter(|path| path.is_file())
        .map(|path| format!("ode/{}", path.file_name().expect("a file").to_string_lossy()))
        .collect();
    let mut got = smartbed_runtime::INTEGRATOR_SOURCES.to_vec();
    got.sort_unstable();
    want.sort();
    assert_eq!(got.iter().map(|(path, _)| *path).collect::<Vec<_>>(), want);
    for (path, text) in got {
        let known = imports(text).iter().all(|layer| ["real", "mechanism", "ode"].contains(&layer.as_str()));
        assert!(known, "{path} imports what the stand-alone crate does not have");
        let nodes = if path == "ode/mod.rs" { 1 } else { 0 };
        assert_eq!(text.matches("nodes").count(), nodes, "{path} names the methods for nodes");
    }
}
