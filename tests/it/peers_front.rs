//! The committed results of other simulators beside ours: no point of theirs dominates one on our front.
//!
//! `python3 tests/peers/motions.py` writes them, machine by machine, its own exit status says the same.

use serde_json::Value;
use std::path::{Path, PathBuf};

/// Subjects that peers move; each must have points of theirs and of ours.
const SUBJECTS: [&str; 6] = ["pendulum", "fourbar", "tile", "single_spring", "cube", "bladder"];

fn results() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("peers/results");
    let machines = std::fs::read_dir(folder).expect("results by machine");
    let files = machines.map(|machine| machine.expect("a folder").path().join("motions.json"));
    files.filter(|file| file.is_file()).collect()
}

#[test]
fn no_peer_dominates_our_front() {
    let files = results();
    assert!(!files.is_empty(), "no machine has motions.json: run tests/peers/motions.py");
    for file in files {
        let text = std::fs::read_to_string(&file).expect("a readable file");
        let report: Value = serde_json::from_str(&text).expect("JSON");
        for subject in SUBJECTS {
            let points =
                report["points"].as_array().expect("points").iter().filter(|p| p["subject"] == subject);
            let numbers = points.map(|p| {
                let number = |key: &str| p[key].as_f64().expect("a number");
                (p["peer"] == true, number("error"), number("nanoseconds"), &p["method"])
            });
            let (peers, ours): (Vec<_>, Vec<_>) = numbers.partition(|p| p.0);
            assert!(
                peers.len() >= 5 && ours.len() >= 3,
                "{subject}: {} and {} points",
                peers.len(),
                ours.len()
            );
            for (_, error, time, method) in &peers {
                let no_worse = |own: &&(bool, f64, f64, &Value)| *error <= own.1 && *time <= own.2;
                let beaten = ours.iter().filter(no_worse).any(|own| *error < own.1 || *time < own.2);
                assert!(
                    !beaten,
                    "{}: {subject}: {method} with {error:e} in {time:e} ns dominates",
                    file.display()
                );
            }
        }
    }
}
