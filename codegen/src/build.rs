//! Runs all stages in order, from a model file to Rust text; one call for build scripts.
//!
//! In: the path of a model and [`Options`]. Out: the text of the emitted file ([`generate`]), or that file written into
//! `OUT_DIR` and watched by cargo ([`build`]).

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::escape;
use crate::kinematics::ParameterChoice;
use crate::model::{self, Model};
use crate::program::answer::{Asked, Function};
use crate::program::{self, Program, Settings};
use crate::rust::{self, EmitOptions};
use crate::source::Source;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// What to derive and how to emit it.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Parameters kept tunable besides the model's own, and changed values.
    pub parameters: ParameterChoice,
    /// Answers besides those that every mechanism has, such as `port:platform`. Each entry becomes one function; an
    /// entry that names several answers, separated by commas, gives one function that returns them all.
    pub answers: Vec<String>,
    /// How the equations are derived.
    pub settings: Settings,
    /// Scalar, answers, path of the runtime.
    pub emit: EmitOptions,
    /// Name of the file in `OUT_DIR`, without `.rs`; the model file's own name if left out.
    pub file_name: Option<String>,
}

/// Derives the model at `path` and returns the formatted Rust.
///
/// # Errors
/// Everything that is wrong with the model, each with its place.
pub fn generate(path: &Path, options: &Options) -> Result<String, Diagnostics> {
    let program = derived(&model::read(path)?, options)?;
    Ok(rust::emit(&program, &options.emit))
}

/// An emitted file, and what it was made from.
#[derive(Clone, Debug)]
pub struct Generated {
    /// Formatted Rust.
    pub text: String,
    /// The model and the files that it extends, from the folder.
    pub files: Vec<PathBuf>,
}

/// [`generate`] for a model in a folder whose path must not appear in messages; also lists the files that were read.
///
/// # Errors
/// As [`generate`].
pub fn generate_in(folder: &Path, path: &str, options: &Options) -> Result<Generated, Diagnostics> {
    let model = model::read_in(folder, Path::new(path))?;
    let files = model.source.files.iter().map(|file| PathBuf::from(&file.path)).collect();
    Ok(Generated { text: rust::emit(&derived(&model, options)?, &options.emit), files })
}

/// All stages between reading and emitting.
fn derived(model: &Model, options: &Options) -> Result<Program, Diagnostics> {
    let asked = Asked::complete(model, functions(&options.answers).map_err(failure)?);
    let program = program::derive_asked(model, &options.parameters, options.settings, &asked)?;
    // A constant beyond the scalar's range would be emitted as an infinity.
    if let Some(why) = program.beyond_single().filter(|_| options.emit.scalar.is_single()) {
        return Err(failure(format!("{why}; derive for f64, or choose other units")));
    }
    Ok(program)
}

/// The functions asked for, one per entry; an entry of several answers is named `answers`, `answers_2` and so on.
fn functions(entries: &[String]) -> Result<Vec<Function>, String> {
    entries.iter().enumerate().map(|(place, entry)| Function::parse(entry, place)).collect()
}

/// For build scripts: derives the model at `path` into `OUT_DIR` and returns the file written.
///
/// Cargo reruns the script when the model or a file it extends changes. If the model is wrong,
/// the build stops with its errors, each with file, line and column.
pub fn build(path: impl AsRef<Path>, options: &Options) -> PathBuf {
    build_program(path, options).0
}

/// [`build`], and the program that was emitted: for scripts that write more about the same mechanism.
pub fn build_program(path: impl AsRef<Path>, options: &Options) -> (PathBuf, Program) {
    match try_build(path.as_ref(), options) {
        Ok(built) => built,
        Err(errors) => {
            // Cargo shows `cargo::error` lines once and stops. A failing exit code would show all output of the script
            // again.
            for line in errors.to_string().lines() {
                println!("cargo::error={line}");
            }
            std::process::exit(0);
        }
    }
}

/// [`build_program`] that leaves the errors to the caller.
///
/// # Errors
/// Everything that is wrong with the model; a file that cannot be written; no `OUT_DIR`.
pub fn try_build(path: &Path, options: &Options) -> Result<(PathBuf, Program), Diagnostics> {
    watch(&path.display().to_string())?;
    let model = model::read(path)?;
    for file in model.source.files.iter() {
        watch(&file.path)?;
    }
    let program = derived(&model, options)?;
    for line in [model.warnings(), program.warnings.clone()]
        .iter()
        .map(ToString::to_string)
        .collect::<String>()
        .lines()
    {
        println!("cargo::warning={line}");
    }
    let directory = std::env::var_os("OUT_DIR")
        .ok_or_else(|| failure("OUT_DIR is not set: call this from a build script".to_owned()))?;
    let name = options.file_name.clone().unwrap_or_else(|| {
        path.file_stem().map_or_else(|| model.name.clone(), |stem| stem.to_string_lossy().into_owned())
    });
    let file = Path::new(&directory).join(format!("{name}.rs"));
    let text = rust::emit(&program, &options.emit);
    check_unwritten(path, &file, &text)?;
    std::fs::write(&file, text).map_err(|e| failure(format!("cannot write {}: {e}", file.display())))?;
    Ok((file, program))
}

/// Refuses another text for a file that this script has written: both modules would include the second one.
fn check_unwritten(model: &Path, file: &Path, text: &str) -> Result<(), Diagnostics> {
    static WRITTEN: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());
    let mut written = WRITTEN.lock().unwrap_or_else(PoisonError::into_inner);
    if written.iter().any(|other| other == file) && std::fs::read_to_string(file).is_ok_and(|old| old != text)
    {
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        return Err(failure(format!(
            "{}: `{name}` was written for another model, or for another scalar of the same one; give each its own \
             `file_name` in `Options`",
            model.display()
        )));
    }
    written.push(file.to_owned());
    Ok(())
}

/// Asks cargo to run the script again when the file changes. Cargo reads one instruction a line.
fn watch(path: &str) -> Result<(), Diagnostics> {
    if path.contains(char::is_control) {
        let message =
            format!("cargo cannot watch `{}`: no line break may stand in a path", escape::line(path));
        return Err(failure(message));
    }
    println!("cargo::rerun-if-changed={path}");
    Ok(())
}

/// A diagnostic that refers to no place in a model.
fn failure(message: String) -> Diagnostics {
    Diagnostics::one(Source::default(), Diagnostic::error(message))
}

#[cfg(test)]
mod tests {
    use super::check_unwritten;
    use std::path::Path;

    #[test]
    fn another_text_for_a_written_file_is_refused() {
        let file = std::env::temp_dir().join(format!("smartbed-written-{}.rs", std::process::id()));
        let write = |model: &str, text: &str| {
            let checked = check_unwritten(Path::new(model), &file, text).map_err(|why| why.to_string());
            checked.map(|()| std::fs::write(&file, text).expect("a temporary folder"))
        };
        assert_eq!(write("a/plant.toml", "one"), Ok(()));
        assert_eq!(write("a/plant.toml", "one"), Ok(()));
        let refused = write("b/plant.toml", "two").expect_err("another model");
        assert!(refused.contains("b/plant.toml") && refused.contains("file_name"), "{refused}");
        std::fs::remove_file(&file).expect("it was written");
    }
}
