//! docs/guide: every command in it is run, in order, in a folder of the page's own; links lead somewhere.
//!
//! A block fenced as `sh` must succeed, one fenced as `sh fails "words"` must fail with these words on standard
//! error; a block with `file=NAME` is written first. `new`, `completions` and `man` stand here, too.

use crate::support::{Done, command, file, finish, smartbed};
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

/// Fenced blocks: what stands behind the fence, and the lines.
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

#[test]
fn every_command_of_the_guide_does_what_it_says() {
    let mut commands = 0;
    for (name, text) in pages() {
        let folder = file(&format!("guide_{name}"));
        let _ = std::fs::remove_dir_all(&folder);
        std::fs::create_dir_all(&folder).expect("a folder");
        for (kind, block) in blocks(&text) {
            if let Some((_, file)) = kind.split_once("file=") {
                std::fs::write(folder.join(file), &block).expect("written");
            }
            if !kind.starts_with("sh") {
                continue;
            }
            let fails = kind.strip_prefix("sh fails \"").and_then(|words| words.strip_suffix('"'));
            for line in block.lines() {
                let done = run(&folder, line.strip_prefix("cargo smartbed ").expect("a command of ours"));
                match fails {
                    Some(words) => assert!(done.message().contains(words), "{name}: {line}: {done:?}"),
                    None => assert_eq!(done.status, 0, "{name}: {line}: {done:?}"),
                }
                commands += 1;
            }
        }
    }
    assert!(commands >= 25, "{commands}");
}

#[test]
fn links_of_the_guide_lead_somewhere() {
    let mut links = 0;
    for (name, text) in pages() {
        for link in text.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            assert!(guide().join(link).is_file(), "{name}: {link}");
            links += 1;
        }
    }
    assert!(links >= 12, "{links}");
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
        assert_eq!((done.status, done.err.as_str()), (0, ""), "{done:?}");
        let again = run(&folder, &format!("new {kind} {name}"));
        assert!(again.message().contains("exists; take another name"), "{again:?}");
    }
    let checked = run(&folder, "check swing.toml");
    assert!(checked.out.contains("no warnings"), "{checked:?}");
    let wrong = run(&folder, "new scene ../up");
    assert!(wrong.message().contains("expected a name of letters"), "{wrong:?}");
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
