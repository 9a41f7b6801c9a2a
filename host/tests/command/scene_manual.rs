//! docs/scenes.md against the program: every key with its readers, every default, the table law x method, the
//! examples.

use crate::guide::run_page;
use smartbed::input::LARGEST;
use smartbed::scene::keys::{ALIASES, Choice, READERS, gases, laws, shapes};
use smartbed::scene::method::{METHODS, TABLE};
use smartbed::scene::parse;
use std::collections::BTreeSet;

const MANUAL: &str = include_str!("../../../docs/scenes.md");

/// A row of the table of keys.
struct Row {
    key: String,
    choices: Vec<Choice>,
    default: String,
}

fn choice(words: &str) -> Choice {
    let name = words.trim_matches('`');
    let named = |mut names: Box<dyn Iterator<Item = &'static str>>| names.find(|n| *n == name);
    match words {
        "every scene" => Choice::Always,
        "lists" => Choice::Lists,
        "a method of fixed step" => Choice::FixedStep,
        "an adaptive method" => Choice::AdaptiveStep,
        "a `pressure`" => Choice::Pressure,
        _ => None
            .or(named(Box::new(shapes())).map(Choice::Shape))
            .or(named(Box::new(laws())).map(Choice::Law))
            .or(named(Box::new(gases())).map(Choice::Gas))
            .unwrap_or_else(|| panic!("no choice `{words}`")),
    }
}

fn rows() -> Vec<Row> {
    let table =
        MANUAL.split("\n## Every key").nth(1).and_then(|rest| rest.split("\n## ").next()).expect("keys");
    let lines = table.lines().filter(|line| line.starts_with("| `"));
    let row = |line: &str| {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        assert_eq!(cells.len(), 5, "{line}");
        assert!(!cells[4].is_empty(), "{line}");
        let text = |cell: &str| cell.trim_matches('`').to_owned();
        Row {
            key: text(cells[0]),
            choices: cells[1].split(", ").map(choice).collect(),
            default: text(cells[3]),
        }
    };
    lines.map(row).collect()
}

#[test]
fn every_key_of_a_scene_is_in_the_manual_with_those_who_read_it() {
    let pair = |choice: Choice, key: &str| format!("{key}: {choice}");
    let read: BTreeSet<String> =
        READERS.iter().flat_map(|r| r.keys.split_whitespace().map(|k| pair(r.choice, k))).collect();
    let told: Vec<String> = rows().iter().flat_map(|r| r.choices.iter().map(|c| pair(*c, &r.key))).collect();
    assert_eq!(told.iter().cloned().collect::<BTreeSet<_>>(), read);
    assert_eq!(told.len(), read.len(), "a key stands twice");
    for (alias, key) in ALIASES {
        let words = format!("may be written `{alias}`");
        assert!(
            MANUAL.lines().any(|l| l.starts_with(&format!("| `{key}`")) && l.contains(&words)),
            "{alias}"
        );
    }
}

/// A scene that makes the choice, with a line more.
fn scene(choice: Choice, key: &str, line: &str) -> String {
    let body = match choice {
        Choice::Lists => "points = [[0, 0, 1], [0, 0, 2]]\n".to_owned(),
        Choice::Shape(name) => format!("shape = \"{name}\"\n"),
        Choice::Pressure => "shape = \"cube\"\npressure = 100\n".to_owned(),
        Choice::Gas(name) => format!("shape = \"cube\"\npressure = 100\ngas = \"{name}\"\n"),
        _ => "shape = \"chain\"\n".to_owned(),
    };
    let rest = match choice {
        Choice::Law(name) => format!("law = \"{name}\"\n"),
        Choice::AdaptiveStep => "method = \"dop853\"\n".to_owned(),
        _ => String::new(),
    };
    let step = if key == "step" { "" } else { "step = 1e-4\n" };
    format!("format = 1\n{body}{rest}{step}{line}\n")
}

#[test]
fn the_defaults_of_the_manual_are_those_of_the_program() {
    let mut tried = 0;
    for row in rows().iter().filter(|r| !r.default.is_empty()) {
        for &choice in &row.choices {
            let line = format!("{} = {}", row.key, row.default);
            let [without, with] = ["", line.as_str()].map(|line| {
                let text = scene(choice, &row.key, line);
                let scene = parse("manual", &text, &[]).unwrap_or_else(|e| panic!("{e}\n{text}"));
                format!("{scene:?}")
            });
            assert_eq!(with, without, "{choice}: {line}");
            tried += 1;
        }
    }
    assert!(tried > 90, "{tried}");
}

#[test]
fn the_manuals_table_of_laws_and_methods_is_the_programs() {
    let mut table = format!("| law | {} |\n", METHODS.map(|(name, ..)| format!("`{name}`")).join(" | "));
    table += &format!("|---|{}\n", "---|".repeat(METHODS.len()));
    for row in TABLE {
        let damped = if row.damped && row.law != "moreau" { ", damped" } else { "" };
        let cells = row.entries.map(|entry| entry.map_or("-".to_owned(), |order| order.to_string()));
        table += &format!("| `{}`{damped} | {} |\n", row.law, cells.join(" | "));
    }
    assert!(MANUAL.contains(&table), "expected\n{table}");
    for law in laws() {
        assert!(MANUAL.contains(&format!("\n| `{law}` | ")), "{law}");
    }
}

#[test]
fn the_manuals_scenes_and_commands_run() {
    assert!(run_page("scenes", MANUAL) >= 6);
    assert!(MANUAL.contains(&format!("a file at most {} MiB", LARGEST >> 20)));
}
