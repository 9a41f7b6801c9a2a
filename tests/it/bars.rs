//! Every command in the table of bars is an existing test or script, or limits its own time, so that it can fail.

use crate::hard_table;
use std::path::Path;

/// Bars that the table must have at least.
const BARS: usize = 20;

/// Names of the tests of a program as `file::function`.
fn tests(package: &str, program: &str) -> Vec<String> {
    let folder = hard_table::folder(package, program).unwrap_or_default();
    let files = std::fs::read_dir(&folder).into_iter().flatten().map(|entry| entry.expect("an entry").path());
    let named = files.flat_map(|file| {
        let stem = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let names = hard_table::tests_of(&file).into_iter();
        names.map(move |name| format!("{stem}::{name}")).collect::<Vec<_>>()
    });
    named.collect()
}

/// What is wrong with a command, if anything.
fn fault(command: &str) -> Option<String> {
    let words: Vec<&str> = command.split(' ').skip_while(|word| word.starts_with("SMARTBED_")).collect();
    match words[..] {
        ["cargo", "test", "-p", package, "--test", program, ref filter @ ..] => {
            let wanted = filter.last().copied().unwrap_or_default();
            let known = tests(package, program).iter().any(|name| name.contains(wanted));
            (!known).then(|| format!("no test of {package} has `{wanted}` in its name"))
        }
        ["python3", script] => {
            let there = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(script).is_file();
            (!there).then(|| format!("no script {script}"))
        }
        ["timeout", seconds, "cargo", ..] if seconds.parse::<u32>().is_ok() => None,
        // The emulator's own checks end with status 1.
        ["cargo", "smartbed", "firmware"] => None,
        _ => Some(format!("`{command}` cannot fail where the bar is missed")),
    }
}

#[test]
fn every_bar_has_a_command_that_can_fail() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/bars.md");
    let text = std::fs::read_to_string(path).expect("docs/bars.md");
    let (mut bars, mut wrong) = (0, Vec::new());
    for line in text.lines().filter(|line| line.starts_with("| ") && !line.starts_with("| what")) {
        let command = line.trim_end_matches(" |").rsplit(" | ").next().unwrap_or_default();
        bars += 1;
        let commands: Vec<&str> = command.split('`').skip(1).step_by(2).collect();
        if commands.is_empty() && !command.starts_with("the same") {
            wrong.push(format!("no command: {line}"));
        }
        wrong.extend(commands.into_iter().filter_map(fault));
    }
    assert!(wrong.is_empty(), "docs/bars.md:\n{}", wrong.join("\n"));
    assert!(bars >= BARS, "{bars} bars");
}

#[test]
fn a_command_that_cannot_fail_is_seen() {
    assert_eq!(fault("cargo test -p smartbed-tests --test it -- bars::"), None);
    assert!(fault("cargo test -p smartbed-tests --test it -- no_such_test").is_some());
    assert!(fault("cargo smartbed report").is_some());
    assert!(fault("time cargo build").is_some());
    assert!(fault("python3 tests/peers/nothing.py").is_some());
}
