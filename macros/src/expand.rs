//! Expands the macro to items.
//!
//! In: the macro's argument; the model in the package's folder. Out: the text of the emitted file, and one line per
//! model file that makes the compiler track its changes.

use crate::choices::Choices;
use smartbed_codegen::generate_in;
use std::fmt::Write;
use std::path::PathBuf;

/// The items.
///
/// # Errors
/// What was wrong with the choices or the model, as the error's text.
pub fn expand(text: &str) -> Result<String, String> {
    let Choices { path, options } = syn::parse_str(text).map_err(|e| format!("mechanism!: {e}"))?;
    let folder = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from);
    let folder = folder.ok_or(
        "mechanism!: no CARGO_MANIFEST_DIR: compile by cargo, or set it to the folder of the models",
    )?;
    let generated = generate_in(&folder, &path, &options).map_err(|errors| errors.to_string())?;
    let mut items = generated.text;
    for file in generated.files {
        let file = folder.join(file);
        let _ = writeln!(items, "const _: &[u8] = ::core::include_bytes!({:?});", file.display().to_string());
    }
    Ok(items)
}
