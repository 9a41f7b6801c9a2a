//! docs/guide: every command in it is run, in order, in a separate folder for each page; links have existing targets.
//!
//! A block fenced as `sh` must succeed, one fenced as `sh fails "words"` must fail with these words on standard
//! error, one fenced as `sh says "words"` must say them; a block with `file=NAME` is written first. `new`,
//! `completions` and `man` are tested here, too.

use crate::support::{Done, command, file, finish, smartbed, written};
use smartbed::engine::explain;
use smartbed::scene::describe::describe;
use smartbed::scene::run::no_number;
use smartbed::switches::impulse::{jumped, tied};
use smartbed_runtime::flexible::{BodyError, Quantity};
use smartbed_runtime::mechanism::Fault;
use std::path::{Path, PathBuf};

fn guide() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/guide")
}

/// Name and text of every page.
fn pages() -> Vec<(String, String)> {
    let files = std::fs::read_dir(guide()).expect("the guide").map(|e| e.expect("a page").path());
    let mut pages: Vec<(String, String)> = files
        .map(|f| {
            (
                f.file_stem().expect("a name").to_string_lossy().into_owned(),
                std::fs::read_to_string(f).expect("text"),
            )
        })
        .collect();
    pages.sort();
    assert!(pages.len() >= 8, "{}", pages.len());
    pages
}

/// Fenced blocks: the text after the fence, and the lines.
fn blocks(text: &str) -> Vec<(String, String)> {
    let mut blocks: Vec<(String, String)> = Vec::new();
    let mut inside = false;
    for line in text.lines() {
        match line.strip_prefix("```") {
            Some(kind) if !inside => {
                blocks.push((kind.to_owned(), String::new()));
                inside = true;
            }
            Some(_) => inside = false,
            None if inside => {
                let block = blocks.last_mut().expect("an open block");
                block.1 += &format!("{line}\n");
            }
            None => {}
        }
    }
    blocks
}

/// Runs the program in a folder; quotes keep a word together.
fn run(folder: &Path, line: &str) -> Done {
    let words: Vec<String> = line.split_whitespace().map(|w| w.trim_matches('\'').to_owned()).collect();
    let mut smartbed = command(&words.iter().map(String::as_str).collect::<Vec<_>>());
    smartbed.current_dir(folder);
    finish(smartbed)
}

/// Writes the files of a page and runs its commands, in order, in a folder of its own; returns how many.
pub fn run_page(name: &str, text: &str) -> usize {
    let mut commands = 0;
    let folder = file(&format!("guide_{name}"));
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder");
    for (kind, block) in blocks(text) {
        if let Some((_, file)) = kind.split_once("file=") {
            std::fs::write(folder.join(file), &block).expect("written");
        }
        if !kind.starts_with("sh") {
            continue;
        }
        let quoted = |prefix| kind.strip_prefix(prefix).and_then(|words| words.strip_suffix('"'));
        let (fails, says) = (quoted("sh fails \""), quoted("sh says \""));
        assert!(kind == "sh" || fails.or(says).is_some(), "{name}: what does `{kind}` mean?");
        for line in block.lines() {
            let done = run(&folder, line.strip_prefix("cargo smartbed ").expect("a command of ours"));
            match fails {
                Some(words) => assert!(done.message().contains(words), "{name}: {line}: {done:?}"),
                None => {
                    assert_eq!(done.status, 0, "{name}: {line}: {done:?}");
                    assert!(done.out.contains(says.unwrap_or_default()), "{name}: {line}: {done:?}");
                }
            }
            commands += 1;
        }
    }
    commands
}

#[test]
fn every_command_of_the_guide_does_what_it_says() {
    let commands: usize = pages().iter().map(|(name, text)| run_page(name, text)).sum();
    assert!(commands >= 25, "{commands}");
}

/// The name of a heading in links: small letters, words joined by hyphens.
fn anchor(line: &str) -> String {
    let words = line.strip_prefix('#').map_or("", |rest| rest.trim_start_matches('#').trim());
    let kept = words.to_lowercase().replace(' ', "-");
    kept.chars().filter(|c| c.is_alphanumeric() || *c == '-').collect()
}

#[test]
fn links_of_the_guide_lead_somewhere() {
    let mut links = 0;
    for (name, text) in pages() {
        for link in text.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            let (page, heading) = link.split_once('#').unwrap_or((link, ""));
            let target = guide().join(page);
            assert!(target.exists(), "{name}: {link}");
            let there = || std::fs::read_to_string(&target).expect("text");
            assert!(heading.is_empty() || there().lines().any(|l| anchor(l) == heading), "{name}: {link}");
            links += 1;
        }
    }
    assert!(links >= 12, "{links}");
}

/// First column of the tables of `every-error.md`, from one heading to the next that is named.
pub fn messages(from: &str, to: Option<&str>) -> Vec<String> {
    let text = std::fs::read_to_string(guide().join("every-error.md")).expect("the list");
    let part = text.split_once(from).expect("a heading").1;
    let part = to.map_or(part, |to| part.split_once(to).expect("a heading").0);
    let rows = part.lines().filter_map(|line| Some(line.strip_prefix("| ")?.split(" | ").next()?.to_owned()));
    rows.filter(|row| row != "message").collect()
}

/// Whether a message matches the pattern, in which `...` matches any text.
fn reads_like(message: &str, pattern: &str) -> bool {
    let mut parts = pattern.split("...");
    let first = parts.next().unwrap_or_default();
    let Some(mut rest) = message.strip_prefix(first) else { return false };
    let mut parts: Vec<&str> = parts.collect();
    let Some(last) = parts.pop() else { return rest.is_empty() };
    for part in parts {
        let Some(at) = rest.find(part) else { return false };
        rest = &rest[at + part.len()..];
    }
    rest.ends_with(last)
}

/// Every message has a row and every row a message.
pub fn same(messages: &[String], rows: &[String]) {
    for message in messages {
        assert!(rows.iter().any(|row| reads_like(message, row)), "no row of every-error.md says: {message}");
    }
    for row in rows {
        assert!(messages.iter().any(|message| reads_like(message, row)), "nothing says: {row}");
        assert!(
            row.replace("...", "").chars().filter(|c| c.is_alphabetic()).count() >= 5,
            "{row} fits anything"
        );
    }
}

/// Message of a model that passes dead points, for an answer that needs independent speeds: the rejected model with a
/// mass that can turn at the dead point.
fn asked_of_redundant_speeds() -> String {
    let rejected = guide().join("../../models/rejected/dead_point.toml");
    let turned =
        "crank = { centre = \"B\", mass = \"m\", frame = \"crank\", inertia = { Izz = \"m*r*r\" } }\n";
    let text = std::fs::read_to_string(rejected).expect("text") + turned;
    let model = written("dead_point_with_mass.toml", &text);
    error_of(&["derive", &model, "--answers", "mass_matrix", "-o", "-"])
}

/// First line of a failing command's message.
pub fn error_of(arguments: &[&str]) -> String {
    let done = smartbed(arguments);
    let first = done.message().lines().next().and_then(|line| line.strip_prefix("error: "));
    first.expect("an error").to_owned()
}

#[test]
fn every_error_of_a_model_has_its_cause_and_cure() {
    let folder = guide().join("../../models/rejected");
    let files = std::fs::read_dir(folder).expect("rejected models").map(|e| e.expect("a file").path());
    let pinned = files.filter(|f| f.extension().is_some_and(|e| e == "stderr"));
    let mut found: Vec<String> = pinned
        .flat_map(|f| {
            let text = std::fs::read_to_string(&f).expect("text");
            let errors = text.lines().filter_map(|line| line.strip_prefix("error: "));
            let errors: Vec<String> = errors.map(str::to_owned).collect();
            assert!(text.starts_with("error: "), "{} begins with no error", f.display());
            errors
        })
        .collect();
    assert!(found.len() >= 80, "{}", found.len());
    found.push(asked_of_redundant_speeds());
    found.push(error_of(&["derive", "pendulum", "--set", "masss=1"]));
    found.push(error_of(&["check", "bed"]));
    found.push(error_of(&["derive", "pendulum", "--integrator", "--crate", "steps", "--form", "kinematic"]));
    same(&found, &messages("## Notation", Some("## While it runs")));
}

/// A spring whose ends coincide at the start.
const LOOSE: &str = r#"
format = 1
name = "loose"
[parameters]
m = { value = 1, unit = "kg" }
l = { value = 0.5, unit = "m" }
k = { value = 100, unit = "N/m" }
[coordinates]
x = { unit = "m", independent = true }
y = { unit = "m", independent = true }
[points]
P = "x*N.x + y*N.y"
[bodies]
b = { centre = "P", mass = "m" }
[springs]
s = { between = ["O", "P"], stiffness = "k", rest_length = "l" }
"#;

#[test]
fn every_error_of_a_run_has_its_cause_and_cure() {
    let faults = [
        Fault::Shape,
        Fault::Singular,
        Fault::NonFinite,
        Fault::StepSize,
        Fault::Unsettled,
        Fault::TooManyContacts,
    ]
    .map(|f| explain(f).to_owned());
    let bodies = [
        BodyError::Empty,
        BodyError::Length { expected: 2, found: 1 },
        BodyError::UnknownPoint { point: 7, points: 3 },
        BodyError::OutOfRange(Quantity::Normal),
        BodyError::Negative { index: 1 },
        BodyError::Scratch { needed: 9, given: 1 },
        BodyError::NotFinite { point: 1 },
        BodyError::BelowGround { point: 1, depth: 0.1 },
        BodyError::ThroughGround { point: 1 },
        BodyError::PressureTooHigh { pressure: 1e6, spring: 2 },
        BodyError::Collapsed { volume: -1.0 },
        BodyError::NotConverged { step: 0.1 },
    ];
    // A kind that is added does not compile until it stands above.
    for body in &bodies {
        match body {
            BodyError::Empty | BodyError::Length { .. } | BodyError::UnknownPoint { .. } => {}
            BodyError::OutOfRange(_)
            | BodyError::Negative { .. }
            | BodyError::Scratch { .. }
            | BodyError::NotFinite { .. } => {}
            BodyError::BelowGround { .. } | BodyError::ThroughGround { .. } => {}
            BodyError::PressureTooHigh { .. } | BodyError::Collapsed { .. } => {}
            BodyError::NotConverged { .. } => {}
        }
    }
    let bodies = bodies.iter().map(describe);
    let loose_model = written("guide_loose.toml", LOOSE);
    let loose = error_of(&["run", &loose_model]);
    let out = error_of(&["report", "cam", "--quick", "--out", &format!("{loose_model}/report")]);
    let commands = [jumped("the command of `cart`", 0.5), tied("the constraint `gear`", 0.5)];
    let others = [no_number("spring"), loose, out].into_iter().chain(commands);
    let found: Vec<String> = faults.into_iter().chain(bodies).chain(others).collect();
    same(&found, &messages("## While it runs", Some("## Scenes of format 2")));
}

#[test]
fn a_new_file_runs_as_it_is() {
    let folder = file("new");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder");
    for (kind, name) in [("mechanism", "swing"), ("scene", "fall")] {
        let done = run(&folder, &format!("new {kind} {name} --json"));
        assert_eq!(done.json()["file"], format!("{name}.toml"));
        let text = std::fs::read_to_string(folder.join(format!("{name}.toml"))).expect("a file");
        assert!(text.lines().filter(|l| l.contains('#')).count() > 8, "it is commented");
        let done = run(&folder, &format!("run {name}.toml --json"));
        // On a busy machine it says how far it is.
        let silent = done.err.lines().all(|line| line.starts_with("running: "));
        assert!(done.status == 0 && silent, "{done:?}");
        let again = run(&folder, &format!("new {kind} {name}"));
        assert!(again.message().contains("exists; take another name"), "{again:?}");
    }
    let checked = run(&folder, "check swing.toml");
    assert!(checked.out.contains("no warnings"), "{checked:?}");
    let wrong = run(&folder, "new scene ../up");
    assert!(wrong.message().contains("expected a name of letters"), "{wrong:?}");
    for name in ["t", "fn"] {
        let reserved = run(&folder, &format!("new mechanism {name}"));
        assert!(reserved.message().contains("take another name"), "{reserved:?}");
    }
}

#[test]
fn shells_and_man_know_every_command() {
    let commands = ["check", "derive", "eval", "run", "view", "report", "firmware", "new"];
    for shell in ["bash", "zsh", "fish"] {
        let done = smartbed(&["completions", shell]);
        assert_eq!(done.status, 0, "{done:?}");
        assert!(commands.iter().all(|c| done.out.contains(c)) && done.out.contains("tolerance"), "{shell}");
    }
    let folder = file("man");
    let done = smartbed(&["man", &folder.display().to_string()]);
    assert_eq!(done.status, 0, "{done:?}");
    for name in commands {
        let page = std::fs::read_to_string(folder.join(format!("smartbed-{name}.1"))).expect(name);
        assert!(page.starts_with(".ie") || page.contains(".TH smartbed"), "{name}");
        assert!(page.contains("Example"), "{name}: with an example");
    }
}
