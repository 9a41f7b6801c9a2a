//! The front door: all stages in order, and one call for build scripts.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::kinematics::ParameterChoice;
use crate::model;
use crate::program::{self, Optimise, Settings};
use crate::rust;
use crate::rust::EmitOptions;
use crate::source::Source;
use crate::value::Effort;
use std::path::{Path, PathBuf};

/// What to derive and how to emit it.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Parameters kept tunable besides the model's own, and changed values.
    pub parameters: ParameterChoice,
    /// How hard to look for fewer operations.
    pub effort: Effort,
    /// What the choice between forms of the equations goes by.
    pub optimise: Optimise,
    /// Scalar, answers, path of the runtime.
    pub emit: EmitOptions,
    /// Name of the file in `OUT_DIR`, without `.rs`; the model file's own name if left out.
    pub file_name: Option<String>,
}

impl Options {
    fn settings(&self) -> Settings {
        Settings { effort: self.effort, optimise: self.optimise }
    }
}

/// Derives the model at `path` and returns the formatted Rust.
///
/// # Errors
/// Everything that is wrong with the model, each with its place.
pub fn generate(path: &Path, options: &Options) -> Result<String, Diagnostics> {
    let model = model::read(path)?;
    let program = program::derive_with(&model, &options.parameters, options.settings())?;
    Ok(rust::emit(&program, &options.emit))
}

/// For build scripts: derives the model at `path` into `OUT_DIR` and returns the file written.
///
/// Cargo reruns the script when the model or a file it extends changes. If the model is wrong,
/// the build stops with its errors, each with file, line and column.
pub fn build(path: impl AsRef<Path>, options: &Options) -> PathBuf {
    match try_build(path.as_ref(), options) {
        Ok(file) => file,
        Err(errors) => {
            eprintln!("{errors}");
            for line in errors.to_string().lines() {
                println!("cargo::error={line}");
            }
            std::process::exit(1);
        }
    }
}

/// [`build`] that leaves the errors to the caller.
///
/// # Errors
/// Everything that is wrong with the model; a file that cannot be written; no `OUT_DIR`.
pub fn try_build(path: &Path, options: &Options) -> Result<PathBuf, Diagnostics> {
    println!("cargo::rerun-if-changed={}", path.display());
    let model = model::read(path)?;
    for file in model.source.files.iter() {
        println!("cargo::rerun-if-changed={}", file.path);
    }
    let program = program::derive_with(&model, &options.parameters, options.settings())?;
    for line in [model.warnings(), program.warnings.clone()]
        .iter()
        .flat_map(|w| w.to_string().lines().map(str::to_owned).collect::<Vec<_>>())
    {
        println!("cargo::warning={line}");
    }
    let text = rust::emit(&program, &options.emit);
    let fail = |message: String| Diagnostics::one(Source::default(), Diagnostic::error(message));
    let directory = std::env::var_os("OUT_DIR")
        .ok_or_else(|| fail("OUT_DIR is not set: call this from a build script".to_owned()))?;
    let name = options.file_name.clone().unwrap_or_else(|| {
        path.file_stem().map_or_else(|| program.name.clone(), |stem| stem.to_string_lossy().into_owned())
    });
    let file = Path::new(&directory).join(format!("{name}.rs"));
    std::fs::write(&file, text).map_err(|e| fail(format!("cannot write {}: {e}", file.display())))?;
    Ok(file)
}
