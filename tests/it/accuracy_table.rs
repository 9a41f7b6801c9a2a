//! The accuracy of every method on every scene and mechanism, as a golden file.
//!
//! Bounds by half decades: an entry changes when an error does by a factor of three or so. Fixed steps are an
//! eighth of the step that a report's ladder begins with; tolerances 1e-8 in f64, 1e-5 in f32.
//! `UPDATE_GOLDEN=1 cargo test -p smartbed-tests --test it accuracy_table` writes the file.

use smartbed::engine::{EngineKind, ScalarKind};
use smartbed::file_kind::FileKind;
use smartbed::report::point::Control;
use smartbed::report::subject::{Method, SAMPLES, Subject, Time, step_of};
use smartbed::report::{open, reference};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// An error below this (m or rad) is rounding; it is not recorded, because it changes with the order of operations.
const LEAST: f64 = 1e-10;
const LEAST_F32: f64 = 1e-4;
/// Springs times seconds; the first touches of a drop from 1 m are in 0.6 s.
const WORK: f64 = 300.0;
const MOST_SECONDS: f64 = 0.6;
/// Computing time of a run; none comes near.
const LIMIT: Duration = Duration::from_secs(600);

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(name)
}

/// Files of a folder of models, by name.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("a folder of models");
    let mut files: Vec<PathBuf> = entries.map(|e| e.expect("an entry").path()).collect();
    // Worlds (format 2) have no points of work and precision yet.
    files.retain(|f| f.extension().is_some_and(|e| e == "toml") && FileKind::of(f) != FileKind::World);
    files.sort();
    files
}

/// The next power of the root of ten above an error.
fn bound(error: f64, least: f64) -> String {
    if error.is_nan() {
        return "-".to_owned();
    }
    let halves = (2.0 * error.max(least).log10()).ceil() as i32;
    let mantissa = if halves.rem_euclid(2) == 0 { 1 } else { 3 };
    format!("{mantissa}e{}", halves.div_euclid(2))
}

/// Error of a method at the table's step or tolerance; NaN where there is no answer.
fn error(subject: &dyn Subject, truth: &reference::Truth, method: &Method, scalar: ScalarKind) -> f64 {
    let seconds = truth.seconds;
    let coarsest = (seconds / SAMPLES as f64 / subject.coarsest_step(&method.name)).ceil().max(1.0) as usize;
    let control = match (method.adaptive, scalar) {
        (false, _) => Control::Step(step_of(seconds, 8 * coarsest)),
        (true, ScalarKind::F64) => Control::Tolerance(1e-8),
        (true, ScalarKind::F32) => Control::Tolerance(1e-5),
    };
    let run = subject.run((&method.name, control, scalar), Time::new(seconds, LIMIT));
    let error = run.map_or(f64::NAN, |trace| trace.difference(&truth.trace));
    // What stands still is off by its rounding or tolerance, which may be more than its way.
    let least = match control {
        Control::Tolerance(e) => e,
        Control::Step(_) => LEAST,
    };
    if error > truth.trace.extent().max(least) { f64::NAN } else { error }
}

/// The table of one folder.
fn table(folder: &Path) -> String {
    let mut text = String::new();
    let mut names: Vec<String> = Vec::new();
    for file in files(folder) {
        let name = file.file_stem().expect("a name").to_string_lossy().into_owned();
        let subject = open::open(&file.display().to_string(), EngineKind::Interpreter).expect("it is read");
        let seconds = subject.seconds().min(MOST_SECONDS).min(WORK / subject.weight());
        let truth =
            reference::make(subject.as_ref(), seconds, false, Duration::from_secs(600)).expect("a reference");
        assert!(truth.reference.agreement <= LEAST, "{name}: {:?}", truth.reference);
        let methods = subject.methods();
        if text.is_empty() {
            names = methods.iter().map(|m| m.name.clone()).collect();
            let _ = writeln!(text, "| | s | {} |\n|{}", names.join(" | "), "---|".repeat(2 + names.len()));
        }
        // A method that the subject refuses has no answer.
        let cells = names.iter().map(|name| {
            let method = methods.iter().find(|m| m.name == *name);
            let error = |scalar| method.map_or(f64::NAN, |m| error(subject.as_ref(), &truth, m, scalar));
            let of = |scalar, least| bound(error(scalar), least);
            format!("{} / {}", of(ScalarKind::F64, LEAST), of(ScalarKind::F32, LEAST_F32))
        });
        let _ = writeln!(text, "| {name} | {seconds:.3} | {} |", cells.collect::<Vec<_>>().join(" | "));
    }
    text
}

#[test]
fn errors_are_those_of_the_golden_file() {
    let found = format!(
        "# Accuracy\n\nBounds of the largest error of a coordinate (m or rad), f64 / f32, rounding not told apart; `-`: no answer. How they are \
         taken is told in tests/it/accuracy_table.rs.\n\n## Mechanisms\n\n{}\n## Scenes\n\n{}",
        table(&folder("models")),
        table(&folder("models/scenes"))
    );
    let golden = folder("tests/golden/accuracy.md");
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        std::fs::write(&golden, &found).expect("the golden file is written");
    }
    let expected = std::fs::read_to_string(&golden).expect("the golden file");
    let changed: Vec<String> = (found.lines().zip(expected.lines()))
        .filter(|(a, b)| a != b)
        .map(|(a, b)| format!("found    {a}\nexpected {b}"))
        .collect();
    assert!(found == expected, "run with UPDATE_GOLDEN=1 if this is meant:\n{}", changed.join("\n"));
}
