//! Plan texts with exchanged values, missing keys and corrupted letters: no panic, no hang, and every refusal has its
//! place.
//!
//! `SMARTBED_FUZZ_CASES=100000 cargo test -p smartbed --test fuzz -- plans`; the seed is fixed, case n is always the
//! same.

use crate::random::Random;
use crate::worlds::mutated;
use smartbed::plan::{checked, parse};
use smartbed_bed::plan::run::run;
use std::path::Path;

/// Cases if the environment does not say.
const CASES: u64 = 3000;
/// Replacements for values.
const VALUES: [&str; 24] = [
    "0",
    "1",
    "-1",
    "0.5",
    "1e-300",
    "1e300",
    "nan",
    "inf",
    "1e9",
    "true",
    "\"\"",
    "\"supine\"",
    "\"1_kPa\"",
    "\"3 mmHg\"",
    "\"20_kg\"",
    "\"0_s\"",
    "\"all\"",
    "\"5_deg\"",
    "[]",
    "[1]",
    "[2, 2]",
    "[\"1_deg\", \"0_deg\"]",
    "{}",
    "1979-05-27",
];
/// Lines that are added.
const KEYS: [&str; 24] = [
    "rows",
    "columns",
    "pitch",
    "gap",
    "intervals",
    "pressure",
    "friction",
    "sealed",
    "stroke",
    "step",
    "posture",
    "table",
    "mass",
    "stature",
    "joints",
    "place",
    "shape",
    "radius",
    "at",
    "over",
    "tiles",
    "tilt",
    "seconds",
    "every",
];

#[test]
fn fuzzed_plans_are_read_or_refused_with_their_place() {
    let cases = std::env::var("SMARTBED_FUZZ_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(CASES);
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/plans");
    let mut files: Vec<_> =
        std::fs::read_dir(folder).expect("plans").map(|e| e.expect("a plan").path()).collect();
    files.sort();
    let texts: Vec<String> = files.iter().map(|f| std::fs::read_to_string(f).expect("text")).collect();
    // Every second one begins as a plan of a few tiles: those are run.
    let is_small =
        |text: &&String| parse("own.toml", text, &[]).is_ok_and(|read| read.plan.layout.count() <= 4);
    let small: Vec<String> = texts.iter().filter(is_small).cloned().collect();
    let (mut refused, mut beyond, mut ran) = (0, 0, 0);
    for case in 0..cases {
        let mut random = Random::new(case);
        let texts = if case % 2 == 0 { &small } else { &texts };
        let text = mutated(&texts[random.below(texts.len())], &mut random, &KEYS, &VALUES);
        let read = match parse("fuzz.toml", &text, &[]) {
            Err(found) => {
                let said = found.to_string();
                let is_placed = said.contains("fuzz.toml:") && said.starts_with("error: ");
                assert!(is_placed, "case {case}: {said}\n{text}");
                refused += 1;
                continue;
            }
            Ok(read) => read,
        };
        match checked("fuzz.toml", read) {
            Err(said) => {
                assert!(said.starts_with("fuzz.toml: ") && said.contains(" s: "), "case {case}: {said}");
                beyond += 1;
            }
            // An equilibrium of a few tiles is found at once, or missed in words.
            Ok(read) if read.plan.layout.count() <= 4 && read.plan.layout.intervals <= [10, 10] => {
                let _ = run(&read.plan, |_| false);
                ran += 1;
            }
            Ok(_) => {}
        }
    }
    println!("{refused} refused, {beyond} beyond a limit, {ran} run of {cases}");
    assert!(refused > cases / 10 && beyond > 0 && ran > cases / 20, "{refused} {beyond} {ran} of {cases}");
}
