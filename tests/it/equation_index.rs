//! Every file, function and test named in the index of equations exists.

use std::path::{Path, PathBuf};

/// The workspace.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("tests/ lies in the workspace").to_owned()
}

/// One row of the index.
struct Row {
    line: usize,
    equation: String,
    file: String,
    function: String,
    tests: Vec<String>,
}

/// Texts between backticks.
fn quoted(cell: &str) -> Vec<String> {
    cell.split('`').skip(1).step_by(2).map(str::to_owned).collect()
}

/// The rows of all tables: | equation | meaning | `file` | `function` | `file::test` ... |.
fn rows(text: &str) -> Vec<Row> {
    let mut rows = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let cells: Vec<&str> = line.trim().trim_matches('|').split('|').map(str::trim).collect();
        if !line.starts_with('|') || line.starts_with("|-") || cells[0] == "equation" {
            continue;
        }
        assert_eq!(cells.len(), 5, "line {}: equation, meaning, file, function, tests", index + 1);
        let only = |cell: &str| quoted(cell).first().cloned().unwrap_or_default();
        rows.push(Row {
            line: index + 1,
            equation: cells[0].to_owned(),
            file: only(cells[2]),
            function: only(cells[3]),
            tests: quoted(cells[4]),
        });
    }
    rows
}

/// Whether a text defines an item of this name (or a model file has the key).
fn defines(file: &str, text: &str, name: &str) -> bool {
    if file.ends_with(".toml") {
        return text.contains(name);
    }
    ["fn ", "struct ", "trait ", "enum "].iter().any(|kind| {
        text.match_indices(&format!("{kind}{name}")).any(|(at, found)| {
            let next = text[at + found.len()..].chars().next();
            next.is_none_or(|c| !c.is_alphanumeric() && c != '_')
        })
    })
}

#[test]
fn every_named_file_function_and_test_exists() {
    let text = std::fs::read_to_string(root().join("docs/equations.md")).expect("docs/equations.md");
    let rows = rows(&text);
    let mut wrong = Vec::new();
    for row in &rows {
        let source = std::fs::read_to_string(root().join(&row.file)).unwrap_or_default();
        if source.is_empty() {
            wrong.push(format!("line {}: no file `{}`", row.line, row.file));
        } else if !defines(&row.file, &source, &row.function) {
            wrong.push(format!("line {}: no `{}` in `{}`", row.line, row.function, row.file));
        }
        if row.tests.is_empty() {
            wrong.push(format!("line {}: {} has no test", row.line, row.equation));
        }
        for test in &row.tests {
            let (file, name) = test.split_once("::").unwrap_or((test, ""));
            let source = std::fs::read_to_string(root().join(file)).unwrap_or_default();
            if !source.contains(&format!("fn {name}()")) {
                wrong.push(format!("line {}: no test `{test}`", row.line));
            }
        }
    }
    assert!(wrong.is_empty(), "docs/equations.md:\n{}", wrong.join("\n"));
}

/// Numbers of equations by chapter: 2.1 to 2.5, 3.1 to 3.10, 4.1 to 4.26.
const CHAPTERS: [(u32, u32); 3] = [(2, 5), (3, 10), (4, 26)];

#[test]
fn every_equation_of_the_thesis_is_indexed() {
    let text = std::fs::read_to_string(root().join("docs/equations.md")).expect("docs/equations.md");
    let rows = rows(&text);
    let names = |cell: &str, named: &str| {
        cell.match_indices(named)
            .any(|(at, found)| !cell[at + found.len()..].starts_with(|next: char| next.is_ascii_digit()))
    };
    for (chapter, last) in CHAPTERS {
        for number in 1..=last {
            let named = format!("Eq. {chapter}.{number}");
            let found = rows.iter().any(|row| names(&row.equation, &named));
            assert!(found, "{named} is not in docs/equations.md");
        }
    }
}
