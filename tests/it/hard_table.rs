//! Every command in the table of hard cases names one existing test of an existing package.

use std::path::{Path, PathBuf};

/// The workspace.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("tests/ lies in the workspace").to_owned()
}

/// Rows that the table must have at least.
const ROWS: usize = 30;

/// Folder of a package's test program.
pub fn folder(package: &str, program: &str) -> Option<PathBuf> {
    let folder = match (package, program) {
        ("smartbed-codegen", "it") => "codegen/tests/it",
        ("smartbed-macros", "it") => "macros/tests/it",
        ("smartbed-runtime", "it") => "runtime/tests/it",
        ("smartbed-tests", "it") => "tests/it",
        ("smartbed-firmware", "it") => "firmware/tests/it",
        ("smartbed-bed", "it") => "bed/tests/it",
        ("smartbed", "command") => "host/tests/command",
        ("smartbed", "fuzz") => "host/tests/fuzz",
        ("smartbed", "world") => "host/tests/world",
        _ => return None,
    };
    Some(root().join(folder))
}

/// Names of the tests in a file: functions right below `#[test]`.
pub fn tests_of(file: &Path) -> Vec<String> {
    let text = std::fs::read_to_string(file).unwrap_or_default();
    let after = text.split("#[test]").skip(1);
    after
        .filter_map(|after| after.trim_start().strip_prefix("fn ").and_then(|rest| rest.split('(').next()))
        .map(str::to_owned)
        .collect()
}

/// Names of the tests in a folder.
pub fn tests(folder: &Path) -> Vec<String> {
    let files = std::fs::read_dir(folder).expect("a folder of tests").map(|e| e.expect("an entry").path());
    files.filter(|f| f.extension().is_some_and(|e| e == "rs")).flat_map(|file| tests_of(&file)).collect()
}

/// The error in a row, if any.
fn fault(cells: &[&str]) -> Option<String> {
    let [hard, _, outcome, bound, command] = cells else {
        return Some(format!("{} columns, expected 5", cells.len()));
    };
    if [hard, outcome, bound].iter().any(|cell| cell.is_empty()) {
        return Some("an empty cell".to_owned());
    }
    let words: Vec<&str> = command.trim_matches('`').split(' ').collect();
    let ["-p", package, "--test", program, "--", name] = words[..] else {
        return Some(format!("`{command}`: expected `-p PACKAGE --test PROGRAM -- NAME`"));
    };
    let Some(folder) = folder(package, program) else {
        return Some(format!("no test program `{program}` of `{package}`"));
    };
    let known = tests(&folder);
    (!known.iter().any(|test| test == name)).then(|| format!("no test `{name}` in {package}"))
}

#[test]
fn every_command_of_the_table_names_a_test() {
    let text = std::fs::read_to_string(root().join("docs/hard-cases.md")).expect("docs/hard-cases.md");
    let (mut rows, mut wrong) = (0, Vec::new());
    for (index, line) in text.lines().enumerate().filter(|(_, line)| line.starts_with('|')) {
        let cells: Vec<&str> = line[1..line.len() - 1].split('|').map(str::trim).collect();
        if line.starts_with("|-") || cells[0] == "what is hard" {
            continue;
        }
        rows += 1;
        wrong.extend(fault(&cells).map(|what| format!("line {}: {what}", index + 1)));
    }
    assert!(wrong.is_empty(), "docs/hard-cases.md:\n{}", wrong.join("\n"));
    assert!(rows >= ROWS, "{rows} rows");
}

#[test]
fn a_wrong_row_is_seen() {
    let row = |command| ["hard", "", "outcome", "bound", command];
    assert_eq!(fault(&row("`-p smartbed-tests --test it -- zero_length_spring`")), None);
    assert!(fault(&row("`-p smartbed-tests --test it -- no_such_test`")).is_some());
    assert!(fault(&row("`-p smartbed --test it -- zero_length_spring`")).is_some());
    assert!(fault(&row("zero_length_spring")).is_some());
    assert!(fault(&["hard", "", "", "bound", "`-p smartbed-tests --test it -- grazing`"]).is_some());
}
