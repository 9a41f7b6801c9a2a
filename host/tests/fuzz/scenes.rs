//! Scene texts and command lines: keys of all kinds with values of all kinds, most of them read; shipped ones with
//! lines exchanged.

use crate::random::Random;
use smartbed::scene::keys::READERS;
use std::fmt::Write as _;

const NUMBERS: [&str; 14] =
    ["1", "0.5", "2", "3", "0.1", "0", "-1", "1e-300", "1e300", "inf", "nan", "\"x\"", "[1, 2, 3]", "true"];
const SHAPES: [&str; 10] =
    ["chain", "polygon", "truss", "prism", "cube", "cylinder", "ball", "cubes", "sheet", "bar"];
const LAWS: [&str; 8] =
    ["compensation", "massless_point", "moreau", "newton", "penalty", "hunt_crossley", "none", "glue"];
const METHODS: [&str; 10] = [
    "symplectic_euler",
    "verlet",
    "damped_verlet",
    "nystrom4",
    "blanes_moan4",
    "rk4",
    "implicit_midpoint",
    "energy_momentum",
    "dormand_prince",
    "dop853",
];

/// A value that may stand behind a key: most often a small number.
pub fn value(random: &mut Random, key: &str) -> String {
    let count = ["1", "2", "3", "4", "0", "-1", "1.5", "100000000000"];
    match key {
        "shape" => format!("\"{}\"", random.of(&SHAPES)),
        "law" => format!("\"{}\"", random.of(&LAWS)),
        "method" => format!("\"{}\"", random.of(&METHODS)),
        "gas" => format!("\"{}\"", random.of(&["constant", "polytropic", "air"])),
        "pressure_form" => format!("\"{}\"", random.of(&["exact", "facet", "fan", "cone"])),
        "floor" => random
            .of(&[
                "{ normal = [0, 0, 1], offset = -1 }",
                "{ offset = 0.1 }",
                "{ normal = [1, 0, 1] }",
                "3",
                "{}",
            ])
            .to_owned(),
        "cells" => {
            random.of(&["[[1, 1, 1]]", "[[2, 1, 1]]", "[[0, 1, 1]]", "[[1e9, 1, 1]]", "[]"]).to_owned()
        }
        "fixed" | "massless" => random.of(&["[0]", "[0, 1]", "[]", "[-1]", "[99]", "[0, 0]"]).to_owned(),
        "anchor" | "plastic_alone" | "allow_unstable" => random.of(&["true", "false", "1"]).to_owned(),
        "receivers" => random.of(&["all", "centres", "centre", "1"]).to_owned(),
        "links" | "corners" | "bays" | "rings" | "bands" | "rows" | "columns" | "elements" | "every" => {
            let known = if random.one_in(4) { &count[..] } else { &count[..4] };
            random.of(known).to_owned()
        }
        "step" => random.of(&["1e-3", "1e-4", "0", "1e-12", "1"]).to_owned(),
        "T" | "seconds" => random.of(&["0.01", "0.002", "0", "1e-6", "-1", "1e9"]).to_owned(),
        _ => {
            let known = if random.one_in(4) { &NUMBERS[..] } else { &NUMBERS[..5] };
            random.of(known).to_owned()
        }
    }
}

/// A text of any kind.
pub fn text(random: &mut Random) -> String {
    let mut text = String::from("format = 1\nT = 0.01\n");
    let lists = random.one_in(4);
    if lists {
        text += "points = [[0, 0, 0.1], [0, 0, 1.1], [1, 0, 0.1]]\nsprings = [[0, 1], [1, 2]]\n";
    } else {
        let _ = writeln!(text, "shape = \"{}\"", random.of(&SHAPES));
    }
    // A group at a time, so that keys fit each other more often than not.
    for _ in 0..random.below(3) {
        let reader = READERS[random.below(READERS.len())];
        let keys: Vec<&str> = reader.keys.split_whitespace().collect();
        if let smartbed::scene::keys::Choice::Law(law) = reader.choice {
            let _ = writeln!(text, "law = \"{law}\"");
        }
        for _ in 0..random.below(3) {
            let key = if keys.is_empty() { "K" } else { random.of(&keys) };
            if !["format", "title", "points", "springs", "facets", "shape", "law", "T"].contains(&key) {
                let _ = writeln!(text, "{key} = {}", value(random, key));
            }
        }
    }
    if random.one_in(6) {
        let at = random.below(text.len());
        text.replace_range(at..=at, random.of(&["\"", "[", "=", "x", "\n", "-"]));
    }
    text
}

/// Settings of a command line for a scene.
pub fn settings(random: &mut Random) -> Vec<String> {
    let mut settings = Vec::new();
    for _ in 0..random.below(3) {
        let reader = READERS[random.below(READERS.len())];
        let keys: Vec<&str> = reader.keys.split_whitespace().collect();
        let key = if keys.is_empty() { "nobody" } else { random.of(&keys) };
        settings.push(format!("{key}={}", value(random, key)));
    }
    settings
}

/// Small scenes, and a few that are none.
const NAMES: [&str; 11] = [
    "single_spring",
    "double_spring",
    "truss",
    "cube",
    "prism",
    "closed_loop_3_links",
    "mass_on_4_springs",
    "spring_loaded_pendulum",
    "complex_structure",
    "centre_masses",
    "singel_spring",
];
/// Numbers at the edges of what an option takes. None asks for minutes.
const EDGES: [&str; 12] =
    ["nan", "inf", "-inf", "1e300", "1e-300", "-1", "0", "-0.0", "", "x", "18446744073709551616", "1e-3"];
/// Values of settings that are no numbers, or not plain ones.
const ODD: [&str; 14] = [
    "nan",
    "inf",
    "-1e300",
    "1e308",
    "1e-320",
    "\"x\"",
    "[]",
    "[[[1]]]",
    "[1, 2]",
    "{ a = { b = 1 } }",
    "{",
    "\"",
    "0x10",
    "null",
];

/// A command line that runs a scene and writes its rows to `csv`; now and then with an error asked for.
pub fn line(random: &mut Random, csv: &str) -> Vec<String> {
    let mut line: Vec<String> = vec!["run".to_owned(), random.of(&NAMES).to_owned(), format!("--csv={csv}")];
    let seconds = if random.one_in(8) { random.of(&EDGES) } else { random.of(&["0.01", "0.003", "0.05"]) };
    line.push(format!("--seconds={seconds}"));
    for _ in 0..random.below(4) {
        let word = match random.below(9) {
            0 => format!(
                "--step={}",
                if random.one_in(2) { random.of(&EDGES) } else { random.of(&["1e-3", "2e-4"]) }
            ),
            1 => format!("--method={}", if random.one_in(6) { "moreau" } else { random.of(&METHODS) }),
            2 => format!("--scalar={}", random.of(&["f32", "f32", "f64", "f16"])),
            3 if random.one_in(40) => format!("--error={}", random.of(&EDGES)),
            3 => format!("--tolerance={}", random.of(&EDGES)),
            4 => random.of(&["--json", "--strict", "--every=3", "--every=0"]).to_owned(),
            _ => {
                let reader = READERS[random.below(READERS.len())];
                let keys: Vec<&str> = reader.keys.split_whitespace().filter(|k| *k != "T").collect();
                let key = if keys.is_empty() || random.one_in(20) { "nobody" } else { random.of(&keys) };
                let value = if random.one_in(4) { random.of(&ODD).to_owned() } else { value(random, key) };
                format!("--set={key}={value}")
            }
        };
        line.push(word);
    }
    line
}
