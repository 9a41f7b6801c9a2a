//! Runs the program at the root of the workspace, and reads what it says.

use smartbed::world::run::engine;
use smartbed::world::{Assembly, read};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::Instant;

/// The program at the root of the workspace.
pub fn smartbed(arguments: &[&str]) -> Output {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    Command::new(env!("CARGO_BIN_EXE_smartbed")).args(arguments).current_dir(root).output().expect("it runs")
}

/// Standard output of a run that succeeds.
pub fn run(arguments: &[&str]) -> String {
    let output = smartbed(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("text")
}

/// Message of a refused run.
pub fn fails(arguments: &[&str]) -> String {
    let output = smartbed(arguments);
    assert_eq!(output.status.code(), Some(1), "{arguments:?}");
    String::from_utf8(output.stderr).expect("text")
}

/// File of a model.
pub fn find(name: &str) -> Result<PathBuf, String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(format!("{name}.toml"));
    if path.is_file() { Ok(path) } else { Err(format!("no model `{name}`")) }
}

/// A world from its text.
pub fn parse(text: &str) -> Result<Assembly, String> {
    read::parse("w.toml", text, &[], &find).map_err(|found| found.to_string())
}

/// A text that is refused when it is read: its message, the place after the file's name, and what to do.
pub fn unread(text: &str, words: &str, place: &str) {
    let said = parse(text).map(|_| ()).expect_err(text);
    assert!(said.contains(words), "{words}\n{said}");
    assert!(said.contains(&format!("w.toml:{place}")), "{words}: expected {place}\n{said}");
    assert!(said.contains("help: "), "what to do\n{said}");
}

/// File of a scene with this text, in a folder of the test's own: tests run at once and write the same names.
pub fn scene(name: &str, text: &str) -> String {
    let test = std::thread::current().name().unwrap_or("unnamed").replace("::", "-");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
    std::fs::create_dir_all(&folder).expect("a folder");
    let file = folder.join(format!("{name}.toml"));
    std::fs::write(&file, text).expect("a file");
    file.display().to_string()
}

/// An undamped cube far away, so that rigid parts are stepped as parts of any world are.
pub const ELSEWHERE: &str =
    "[parts.cube]\nshape = \"cube\"\nside = 0.1\nmass = 0.1\nK = 100\nstart = { position = [3, 3, 3] }\n";

/// Text of a contact of two parts that lose energy, with friction 0.3.
pub fn rubbing(one: &str, other: &str, restitution: f64) -> String {
    format!(
        "[[contacts]]\nbetween = [\"{one}\", \"{other}\"]\nimpact = \"stronge\"\nrestitution = {restitution}\nfriction = 0.3\n"
    )
}

/// Output of `run --json` for a scene.
pub fn json(arguments: &[&str]) -> serde_json::Value {
    let output = run(&[&["run"], arguments, &["--json"]].concat());
    serde_json::from_str(&output).expect("JSON")
}

/// Output of `settle --json` for a scene.
pub fn settled(arguments: &[&str]) -> serde_json::Value {
    let output = run(&[&["settle"], arguments, &["--json"]].concat());
    serde_json::from_str(&output).expect("JSON")
}

/// A number in this output.
pub fn number(value: &serde_json::Value) -> f64 {
    value.as_f64().expect("a number")
}

/// Times of the events in this output.
pub fn times(json: &serde_json::Value) -> Vec<f64> {
    json["events"].as_array().expect("events").iter().map(|event| number(&event["time"])).collect()
}

/// Fields of a row of CSV by RFC 4180: what stands in quotes is one field, a quote in it is doubled.
pub fn fields(line: &str) -> Vec<String> {
    let (mut fields, mut is_quoted) = (vec![String::new()], false);
    let mut letters = line.chars().peekable();
    while let Some(letter) = letters.next() {
        match letter {
            '"' if is_quoted && letters.next_if_eq(&'"').is_some() => {
                fields.last_mut().expect("one").push('"')
            }
            '"' => is_quoted = !is_quoted,
            ',' if !is_quoted => fields.push(String::new()),
            _ => fields.last_mut().expect("one").push(letter),
        }
    }
    fields
}

/// Numbers of a scene's rows, by column.
pub fn rows(arguments: &[&str]) -> (Vec<String>, Vec<Vec<f64>>) {
    let text = run(&[&["run"], arguments, &["--csv", "-"]].concat());
    let mut lines = text.lines();
    let names = fields(lines.next().expect("a header"));
    let row = |line: &str| line.split(',').map(|x| x.parse().expect("a number")).collect();
    (names, lines.map(row).collect())
}

/// The least time of a step of 1 ms of each of these worlds (s), after `settled` steps of each. They take turns, so
/// that a machine that slows down slows all of them: 30 turns, then more until the times are as `enough` asks, at most
/// 2000.
pub fn least_times<const N: usize>(
    texts: [String; N],
    settled: usize,
    enough: impl Fn(&[f64; N]) -> bool,
) -> [f64; N] {
    let mut worlds = texts.map(|text| engine(&parse(&text).expect("a world")).expect("an engine"));
    let mut least = [f64::INFINITY; N];
    for turn in 0..settled + 2000 {
        if turn >= settled + 30 && enough(&least) {
            break;
        }
        for (world, least) in worlds.iter_mut().zip(&mut least) {
            let start = Instant::now();
            world.step(1e-3, &mut Vec::new()).expect("a step");
            let took = start.elapsed().as_secs_f64();
            if turn >= settled {
                *least = least.min(took);
            }
        }
    }
    least
}
