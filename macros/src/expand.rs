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
    if !folder.join(&path).is_file() {
        return Err(format!("mechanism!: there is no file {path} in {}", folder.display()));
    }
    // The compiler writes `error: ` before the text.
    let once = |text: String| text.strip_prefix("error: ").map_or(text.clone(), str::to_owned);
    let generated = generate_in(&folder, &path, &options).map_err(|errors| once(errors.to_string()))?;
    let mut items = generated.text;
    for file in generated.files {
        let file = folder.join(file);
        let _ = writeln!(items, "const _: &[u8] = ::core::include_bytes!({:?});", file.display().to_string());
    }
    Ok(items)
}

#[cfg(test)]
mod tests {
    use super::expand;

    #[test]
    fn a_missing_file_is_told_with_its_folder() {
        let said = expand("\"nowhere.toml\"").expect_err("no such file");
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).display().to_string();
        assert!(said.contains("nowhere.toml") && said.ends_with(&folder), "{said}");
    }

    #[test]
    fn an_error_of_a_model_is_called_one_once() {
        let file = std::env::temp_dir().join(format!("smartbed-wrong-{}.toml", std::process::id()));
        std::fs::write(&file, "format = 1\nname = \"wrong\"\nnonsense = 1\n").expect("a temporary folder");
        let said = expand(&format!("{:?}", file.display().to_string())).expect_err("a wrong model");
        std::fs::remove_file(&file).expect("it was written");
        assert!(!said.starts_with("error") && said.contains("nonsense"), "{said}");
    }
}
