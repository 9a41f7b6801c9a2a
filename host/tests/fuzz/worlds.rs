//! Scene texts of format 2 with exchanged values, missing keys and corrupted letters: no panic, and every refusal has
//! its place.
//!
//! `SMARTBED_FUZZ_CASES=100000 cargo test -p smartbed --test fuzz -- worlds`; the seed is fixed, case n is always the
//! same.

use crate::random::Random;
use smartbed::model_argument::find;
use smartbed::world::{read, run::engine};
use std::path::Path;

/// Cases if the environment does not say.
const CASES: u64 = 2000;
/// Worlds without mechanisms, whose equations would be derived case by case.
const WORLDS: [&str; 8] = [
    "box_bounce",
    "rod_with_friction",
    "stack_boxes",
    "rigid_ball_rests",
    "damper_mass_fixed_end",
    "closed_loop_hung",
    "two_cubes",
    "ball_on_bladder",
];
const VALUES: [&str; 30] = [
    "0",
    "1",
    "2",
    "-1",
    "0.5",
    "1e-300",
    "1e300",
    "nan",
    "inf",
    "1e9",
    "true",
    "\"\"",
    "\"x\"",
    "\"1_m\"",
    "\"1_kg\"",
    "\"1 m/s\"",
    "\"1 m/s^\"",
    "\"1_s/0\"",
    "\"sin(t)\"",
    "\"box\"",
    "\"moreau\"",
    "\"settled\"",
    "\"rim\"",
    "[]",
    "[1, 2, 3]",
    "[\"1_m\", 0, 0]",
    "[[0, 1]]",
    "{}",
    "{ count = [2, 1], pitch = [1, 1] }",
    "1979-05-27",
];
const KEYS: [&str; 24] = [
    "mass",
    "radius",
    "size",
    "start",
    "gas",
    "base",
    "attach",
    "grid",
    "fixed",
    "on",
    "friction",
    "restitution",
    "impact",
    "between",
    "seconds",
    "step",
    "rows",
    "columns",
    "shape",
    "rigid",
    "points",
    "nobody",
    "air_drag",
    "gravity",
];

/// A text with one to three of its lines changed.
pub fn mutated(text: &str, random: &mut Random, keys: &[&str], values: &[&str]) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    for _ in 0..1 + random.below(3) {
        let at = random.below(lines.len());
        match random.below(6) {
            0 => lines[at].clear(),
            1 => lines.insert(at, format!("{} = {}", random.of(keys), random.of(values))),
            2 => {
                let line = lines[at].clone();
                lines.push(line);
            }
            3 if !lines[at].is_empty() => {
                let mut letters: Vec<char> = lines[at].chars().collect();
                let place = random.below(letters.len());
                letters[place] = ['"', '[', '=', 'x', '-', '{', '9', 'ß'][random.below(8)];
                lines[at] = letters.into_iter().collect();
            }
            _ => {
                if let Some((key, _)) = lines[at].split_once('=') {
                    lines[at] = format!("{}= {}", key, random.of(values));
                }
            }
        }
    }
    lines.join("\n")
}

#[test]
fn fuzzed_worlds_are_read_or_refused_with_their_place() {
    let cases = std::env::var("SMARTBED_FUZZ_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(CASES);
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes");
    let texts: Vec<String> = WORLDS
        .iter()
        .map(|name| std::fs::read_to_string(folder.join(format!("{name}.toml"))).expect(name))
        .collect();
    let (mut refused, mut stepped) = (0, 0);
    for case in 0..cases {
        let mut random = Random::new(case);
        let text = mutated(&texts[random.below(texts.len())], &mut random, &KEYS, &VALUES);
        let found = match read::parse("fuzz.toml", &text, &[], &|name| find(name).map_err(|e| e.to_string()))
        {
            Err(found) => {
                let said = found.to_string();
                assert!(
                    said.contains("fuzz.toml:") && said.starts_with("error: "),
                    "case {case}: {said}\n{text}"
                );
                refused += 1;
                continue;
            }
            Ok(assembly) => assembly,
        };
        // What was read is stepped, or refused in words.
        if found.parts.len() > 20 {
            continue;
        }
        let Ok(mut engine) = engine(&found) else { continue };
        let mut events = Vec::new();
        for _ in 0..3 {
            if engine.step(found.run.step, &mut events).is_err() {
                break;
            }
        }
        stepped += 1;
    }
    assert!(refused > cases / 10 && stepped > cases / 10, "{refused} refused, {stepped} stepped of {cases}");
}
