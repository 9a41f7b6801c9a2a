//! Finds the model, scene or plan that a command line names, by path or by the name of a file under `models/`; parses
//! `name=value`.
//!
//! Names are looked up in `models/` and `models/scenes/`, those of plans in `models/plans/`, of the current folder and
//! of the folders above it, up to the root of the workspace (the first folder with a Cargo.lock); last in the sources
//! that this program was built from.

use crate::failure::Failure;
use crate::file_kind::FileKind;
use crate::grouped;
#[cfg(feature = "whole")]
use crate::input;
use crate::output::{self, Stream};
use crate::suggest;
#[cfg(feature = "whole")]
use crate::world::{self, Assembly};
use smartbed_codegen::model::{self, Model};
use smartbed_codegen::{Diagnostics, Program};
use std::path::{Path, PathBuf};

/// Folders of models and of scenes.
const MODELS: [&str; 2] = ["models", "models/scenes"];

/// Finds the file of a model or scene.
///
/// # Errors
/// [`Failure::Wrong`] with the most similar name, if there is no such file.
pub fn find(argument: &str) -> Result<PathBuf, Failure> {
    find_in(argument, "model", &MODELS)
}

/// Finds the file of a plan of the bed.
///
/// # Errors
/// As [`find`].
pub fn find_plan(argument: &str) -> Result<PathBuf, Failure> {
    find_in(argument, "plan", &["models/plans"])
}

fn find_in(argument: &str, what: &str, under: &[&str]) -> Result<PathBuf, Failure> {
    for given in [PathBuf::from(argument), PathBuf::from(format!("{argument}.toml"))] {
        if given.is_file() {
            return Ok(given);
        }
    }
    // A folder may have the same name as a model.
    if Path::new(argument).exists() && !Path::new(argument).is_dir() {
        return Err(Failure::Wrong(format!(
            "{argument}: it is a pipe or a device; expected the file of a {what}"
        )));
    }
    let mut known = Vec::new();
    for folder in folders(under).into_iter().chain(sources(under)) {
        for candidate in [folder.join(argument), folder.join(format!("{argument}.toml"))] {
            if candidate.is_file() {
                return Ok(candidate);
            }
        }
        known.extend(names_in(&folder));
    }
    known.sort();
    known.dedup();
    let first = under.first().copied().unwrap_or_default();
    if known.is_empty() {
        return Err(Failure::Wrong(format!(
            "no {what} `{argument}`: there is no such file, and no folder {first}/ here or above"
        )));
    }
    let help = suggest::help(argument, known.iter().map(String::as_str));
    Err(Failure::Wrong(format!(
        "no {what} `{argument}`: expected the path of a file, or the name of one under {first}/{help}"
    )))
}

/// These folders among the sources of the program, whose models are found from any folder.
fn sources(names: &[&str]) -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new(""));
    names.iter().map(|name| root.join(name)).filter(|folder| folder.is_dir()).collect()
}

/// Names of all models and scenes of format 1, models first.
#[must_use]
pub fn all() -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for folder in folders(&MODELS) {
        let mut found = names_in(&folder);
        found.sort();
        found.retain(|name| {
            !names.contains(name) && FileKind::of(&folder.join(format!("{name}.toml"))) != FileKind::World
        });
        names.extend(found);
    }
    names
}

/// Finds and reads a model.
///
/// # Errors
/// [`Failure::Wrong`] if there is no such model, or it is a file of another kind; or all errors in it.
pub fn read(argument: &str) -> Result<Model, Failure> {
    let path = find(argument)?;
    FileKind::expect(&path, &[FileKind::Model])?;
    model::read(&path).map_err(|errors| wrong(&errors))
}

/// Reads a scene of format 2 and applies settings `path = value`.
///
/// # Errors
/// [`Failure::Found`] with all errors in it; [`Failure::Wrong`] if there is no such file.
#[cfg(feature = "whole")]
pub fn open_world(path: &Path, settings: &[String]) -> Result<Assembly, Failure> {
    world_by(world::read::parse, path, settings)
}

/// The same for a scene that is settled first.
///
/// # Errors
/// As [`open_world`].
#[cfg(feature = "whole")]
pub fn open_world_to_settle(path: &Path, settings: &[String]) -> Result<Assembly, Failure> {
    world_by(world::read::parse_to_settle, path, settings)
}

/// Reads a scene by one of the two functions that parse its text.
#[cfg(feature = "whole")]
fn world_by(
    parse: fn(&str, &str, &[String], world::read::Find<'_>) -> Result<Assembly, Diagnostics>,
    path: &Path,
    settings: &[String],
) -> Result<Assembly, Failure> {
    let name = path.display().to_string();
    let find = |model: &str| find(model).map_err(|failure| failure.to_string());
    let text = input::text(&name)?;
    parse(&name, &text, settings, &find).map_err(|found| wrong(&found))
}

/// Findings as a failure.
#[must_use]
pub fn wrong(errors: &Diagnostics) -> Failure {
    Failure::Found(Box::new(errors.clone()))
}

/// Warnings about a model: names that are never used, constraints that were dropped.
#[must_use]
pub fn warnings(model: &Model, program: &Program) -> Diagnostics {
    let mut found = model.warnings();
    found.items.extend(program.warnings.items.iter().cloned());
    found
}

/// Prints the derivation's warnings to standard error.
pub fn print_warnings(program: &Program) {
    print_findings(&program.warnings);
}

/// Prints warnings to standard error.
pub fn print_findings(warnings: &Diagnostics) {
    if !warnings.items.is_empty() {
        output::say(grouped::text(warnings, Stream::Error, false).trim_end());
    }
}

/// Parses `NAME=NUMBER` after an option of the command line.
///
/// # Errors
/// [`Failure::Wrong`] if it is none.
pub fn assignment(option: &str, text: &str) -> Result<(String, f64), Failure> {
    let parts = text.split_once('=').map(|(name, value)| (name.trim(), value.trim().parse::<f64>()));
    match parts {
        Some((name, Ok(value))) if !name.is_empty() && value.is_finite() => Ok((name.to_owned(), value)),
        _ => Err(Failure::Wrong(format!(
            "{option} {text}: expected NAME=NUMBER in SI units, for example {option} M=8"
        ))),
    }
}

/// Folders with these names here and above, the nearest first, up to the root of the workspace.
fn folders(names: &[&str]) -> Vec<PathBuf> {
    let mut folders = Vec::new();
    let here = std::env::current_dir().unwrap_or_default();
    for (depth, folder) in here.ancestors().enumerate() {
        // Relative to the current folder, because the path appears in generated files and messages.
        let prefix: PathBuf = std::iter::repeat_n("..", depth).collect();
        folders.extend(names.iter().map(|name| prefix.join(name)));
        if folder.join("Cargo.lock").is_file() {
            break;
        }
    }
    folders.retain(|f| f.is_dir());
    folders
}

fn names_in(folder: &Path) -> Vec<String> {
    let files = std::fs::read_dir(folder).into_iter().flatten().flatten().map(|f| f.path());
    files
        .filter(|p| p.extension().is_some_and(|e| e == "toml"))
        .filter_map(|p| Some(p.file_stem()?.to_string_lossy().into_owned()))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn assignments() {
        assert_eq!(assignment("--set", "M=8"), Ok(("M".to_owned(), 8.0)));
        for wrong in ["M", "M=", "=3", "M=heavy", "M=nan", "M=1e999"] {
            let failure = assignment("--set", wrong).expect_err(wrong);
            assert!(failure.to_string().contains("NAME=NUMBER"), "{wrong}");
        }
    }

    #[test]
    fn models_are_found_among_the_sources() {
        let folders = sources(&MODELS);
        assert!(folders.iter().all(|folder| folder.is_absolute()), "{folders:?}");
        for name in ["tile.toml", "two_cubes.toml"] {
            assert!(folders.iter().any(|folder| folder.join(name).is_file()), "{name}: {folders:?}");
        }
    }

    #[test]
    fn models_are_found_from_below() {
        // Tests run in the package's folder: the models lie one above.
        assert_eq!(find("tile").map(|p| p.ends_with("models/tile.toml")), Ok(true));
        let failure = find("tyle").expect_err("a slip");
        assert!(failure.to_string().contains("did you mean `tile"), "{failure}");
    }
}
