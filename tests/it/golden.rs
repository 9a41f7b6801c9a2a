//! Emitted text, byte for byte: `UPDATE_GOLDEN=1 cargo test -p smartbed-tests golden` rewrites the files. Of everything
//! else that is emitted `codegen/tests/emitted_bytes.txt` keeps fingerprints.

use smartbed_codegen::ScalarType;
use smartbed_tests::cases::MECHANISMS;
use smartbed_tests::interpreted::emitted;
use std::path::Path;

/// Compares with the stored file, or writes it.
fn check(model: &str, suffix: &str, scalar: ScalarType) {
    let name = format!("{model}_{suffix}.rs");
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("golden").join(&name);
    let text = emitted(model, scalar);
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        std::fs::write(&file, text).expect("the golden file is writable");
        return;
    }
    let golden = std::fs::read_to_string(&file).unwrap_or_default();
    let differing = golden.lines().zip(text.lines()).position(|(old, new)| old != new);
    assert!(
        golden == text,
        "tests/golden/{name} is stale from line {}: review, then UPDATE_GOLDEN=1",
        differing.map_or(0, |line| line + 1)
    );
}

#[test]
fn emitted_text_equals_the_golden_files() {
    for model in MECHANISMS {
        check(model, "f32", ScalarType::F32);
        check(model, "f64", ScalarType::F64);
    }
}

#[test]
fn no_double_literal_in_single_precision() {
    for model in MECHANISMS {
        let text = emitted(model, ScalarType::F32);
        let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
        for line in code {
            assert!(!line.contains("f64"), "{model}: {line}");
            // A float literal without a suffix would be f64 wherever nothing else says f32.
            let bare = line.split(|c: char| !(c.is_alphanumeric() || c == '.' || c == '_')).any(|word| {
                word.starts_with(|c: char| c.is_ascii_digit()) && word.contains('.') && !word.ends_with("f32")
            });
            assert!(!bare, "{model}: {line}");
        }
    }
}
