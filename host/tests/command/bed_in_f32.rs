//! The world `bed` with a ball that presses on it, in single precision: processor time of a simulated second.

use crate::support::{command, least_time, timed};

/// Bar (s) for sheets of up to 9 x 9 nodes. On a quiet core these take a third of that, the scene's own of 3 x 3 nodes
/// a seventh.
const KEEPS_UP: f64 = 1.0;
/// A start (s) that holds reading and settling, and the time (s) that is measured behind it.
const TIMES: [f64; 2] = [0.1, 0.6];
/// Most times that both are run beside other tests: what else the machine does only adds to either.
const TRIES: usize = 8;

/// Processor time (s) of a simulated second of all threads, the least of some tries, and how strongly the ball presses
/// (N). More are made only while it is longer than asked for.
fn second(scalar: &str, nodes: usize, wanted: f64) -> (f64, f64) {
    let run = |seconds: f64| {
        let sides = ["rows", "columns"].map(|side| format!("parts.bladder.{side}={nodes}"));
        let seconds = seconds.to_string();
        let asked = ["run", "bed", "--scalar", scalar, "--seconds", &seconds, "--json"];
        let set = ["--set", &sides[0], "--set", &sides[1]];
        let (done, spent) = timed(&command(&[&asked[..], &set].concat()));
        assert_eq!(done.status, 0, "{done:?}");
        let pressing = |(name, value): (&String, &serde_json::Value)| {
            let is_force = name.starts_with("ball-") && name.ends_with(".normal");
            value.as_f64().filter(|_| is_force)
        };
        let last = done.json()["last"].as_object().expect("the last row").clone();
        (spent, last.iter().filter_map(pressing).sum::<f64>())
    };
    let (mut least, mut force, mut tries) = ([f64::INFINITY; 2], 0.0, 0);
    let taken = least_time(wanted, TRIES, || {
        for (least, seconds) in least.iter_mut().zip(TIMES) {
            let (spent, pressed) = run(seconds);
            (*least, force) = (least.min(spent), pressed);
        }
        tries += 1;
        // One pair alone may differ by what disturbed the shorter one.
        if tries < 2 { f64::INFINITY } else { (least[1] - least[0]) / (TIMES[1] - TIMES[0]) }
    });
    (taken, force)
}

#[test]
fn the_bed_with_a_ball_keeps_up_with_time_in_f32() {
    for (scalar, nodes) in [("f32", 3), ("f64", 3), ("f32", 9), ("f32", 13)] {
        let wanted = if nodes > 9 { f64::MAX } else { KEEPS_UP };
        let (taken, force) = second(scalar, nodes, wanted);
        println!(
            "{scalar}, {nodes} x {nodes} nodes a sheet: {taken:.2} s of processor time a simulated second"
        );
        // The ball of 5 kg presses with its weight, and more or less as tiles move.
        assert!((20.0..100.0).contains(&force), "{force} N");
        assert!(taken <= wanted, "{scalar}: {taken} s");
    }
}
