//! Fingerprints of all emitted text in `tests/emitted_bytes.txt`: they prove that a change of the generator keeps
//! its output, or show which models, forms and scalars it affects.
//!
//! `UPDATE_EMITTED=1 cargo test -p smartbed-codegen --test it -- emitted_bytes` renews the file.

use crate::models::shipped;
use smartbed_codegen::program::{derive_asked, derive_kinematic};
use smartbed_codegen::{
    Asked, Diagnostics, Effort, EmitOptions, Function, Optimise, ParameterChoice, Program, ScalarType,
    Settings, rust,
};
use std::fmt::Write;
use std::path::Path;

/// Names and settings of the derivations.
const SETTINGS: [(&str, Settings); 4] = [
    ("default", Settings { effort: Effort::Default, optimise: Optimise::Operations }),
    ("accuracy", Settings { effort: Effort::Default, optimise: Optimise::Accuracy }),
    ("time", Settings { effort: Effort::Default, optimise: Optimise::Time }),
    ("all", Settings { effort: Effort::All, optimise: Optimise::Operations }),
];

/// FNV-1a, 64 bits: any change of a byte changes it, and it is the same on every machine.
fn fingerprint(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

/// One line a scalar: model, settings, form, scalar, length, fingerprint.
fn record(lines: &mut String, program: &Program, settings: &str, form: &str, functions: &[Function]) {
    let lanes = ScalarType::Path("wide::f32x8".to_owned());
    for (name, scalar) in [("f32", ScalarType::F32), ("f64", ScalarType::F64), ("f32x8", lanes)] {
        let options = EmitOptions { scalar, functions: functions.to_vec(), ..EmitOptions::default() };
        let text = rust::emit(program, &options);
        let (length, hash) = (text.len(), fingerprint(&text));
        let model = &program.name;
        writeln!(lines, "{model} {settings} {form} {name} {length} {hash:016x}").expect("a string grows");
    }
}

/// Names of the mechanisms under `models/`, sorted.
pub fn mechanisms() -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models");
    let files = std::fs::read_dir(folder).expect("models/").map(|entry| entry.expect("an entry").path());
    let is_mechanism =
        |file: &std::path::PathBuf| std::fs::read_to_string(file).is_ok_and(|text| text.contains("\ndof = "));
    let stem = |file: std::path::PathBuf| file.file_stem().map(|name| name.to_string_lossy().into_owned());
    let mut names: Vec<String> = files.filter(is_mechanism).filter_map(stem).collect();
    names.sort();
    names
}

fn derived(program: Result<Program, Diagnostics>) -> Program {
    program.unwrap_or_else(|found| panic!("{found}"))
}

/// Everything that is emitted for a model.
fn of_model(name: &str) -> String {
    let model = shipped(name);
    let choice = ParameterChoice::default();
    let mut lines = String::new();
    for (settings, how) in SETTINGS {
        let program = derived(derive_asked(&model, &choice, how, &Asked::complete(&model, Vec::new())));
        record(&mut lines, &program, settings, "reduced", &[]);
        if how.effort == Effort::Default {
            let augmented = Function::each(&["augmented"]);
            let asked = Asked::besides(augmented.clone());
            let program = derived(derive_asked(&model, &choice, how, &asked));
            record(&mut lines, &program, settings, "augmented", &augmented);
        }
    }
    let program = derived(derive_kinematic(&model, &choice, Effort::Default));
    record(&mut lines, &program, "default", "kinematic", &Function::each(&program.kinematic()));
    lines
}

#[test]
fn emitted_bytes_are_those_on_file() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/emitted_bytes.txt");
    let found: String = mechanisms().iter().map(|name| of_model(name)).collect();
    if std::env::var_os("UPDATE_EMITTED").is_some() {
        std::fs::write(&file, found).expect("the file is writable");
        return;
    }
    let stored = std::fs::read_to_string(&file).unwrap_or_default();
    let changed: Vec<&str> = found.lines().filter(|line| !stored.lines().any(|old| old == *line)).collect();
    assert!(
        found == stored,
        "{} of {} emitted texts are not those of codegen/tests/emitted_bytes.txt; renew it with UPDATE_EMITTED=1 if \
         that is meant:\n{}",
        changed.len(),
        found.lines().count(),
        changed.join("\n")
    );
}
