//! Invalid models and their exact messages: `models/rejected/<case>.toml` with `<case>.stderr`.
//!
//! After a deliberate change of a message: UPDATE_REJECTED=1 cargo test -p smartbed-codegen --test it rejected

use std::path::{Path, PathBuf};

use smartbed_codegen::{ParameterChoice, model, program};

fn cases() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/rejected");
    let entries = std::fs::read_dir(folder).expect("models/rejected").map(|e| e.expect("an entry").path());
    let mut cases: Vec<PathBuf> = entries.filter(|p| p.extension().is_some_and(|e| e == "toml")).collect();
    cases.sort();
    cases
}

#[test]
fn rejected_models_have_their_exact_messages() {
    let cases = cases();
    assert!(30 <= cases.len(), "{} cases", cases.len());
    let mut stale = Vec::new();
    for case in cases {
        let name = case.file_name().expect("a name").to_string_lossy().into_owned();
        let text = std::fs::read_to_string(&case).expect("readable");
        let found = match (model::parse(&name, &text), text.starts_with("# derivation")) {
            (Err(found), false) => found,
            // Cases that only the derivation can refuse say so.
            (Ok(model), true) => match program::derive(&model, &ParameterChoice::default()) {
                Err(found) => found,
                Ok(_) => panic!("{name} is derived"),
            },
            (Err(found), true) => panic!("{name} is refused before the derivation: {found}"),
            (Ok(_), false) => panic!("{name} is accepted"),
        };
        let actual = found.to_string();
        let expected = case.with_extension("stderr");
        if std::env::var_os("UPDATE_REJECTED").is_some() {
            std::fs::write(&expected, &actual).expect("writable");
        } else if std::fs::read_to_string(&expected).unwrap_or_default() != actual {
            stale.push(format!("{name}:\n{actual}"));
        }
    }
    assert!(stale.is_empty(), "messages differ from those pinned:\n{}", stale.join("\n"));
}

#[test]
fn every_rejection_says_where_and_what_to_do() {
    for case in cases() {
        let text = std::fs::read_to_string(case.with_extension("stderr")).unwrap_or_default();
        let name = case.display();
        assert!(text.contains(" --> ") && text.contains('^'), "{name} shows no place");
        assert!(text.contains("= help: "), "{name} does not say what to do");
    }
}
