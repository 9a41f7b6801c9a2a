//! What is known to be wrong only once a world is built is told with its place in the text, too.

use super::support::{fails, scene};

/// A mechanism with an input that no law gives.
const ARM: &str = "format = 2\n[parts.arm]\nmechanism = \"double_pendulum\"\n";
/// A controller of it.
const HELD: &str = "reads = \"arm.q1\"\ndrives = \"arm.T\"\ntarget = 0\nperiod = 0.001\n";

/// The message for a scene: the words, the place `line:column`, and what to do.
fn told(lines: &str, options: &[&str], words: &str, place: &str) {
    let said = fails(&[&["run", &scene("placed", lines)], options].concat());
    assert!(said.contains(words), "{words}\n{said}");
    assert!(said.contains(&format!("{place}\n")), "{words}: expected {place}\n{said}");
    assert!(said.contains("help: "), "what to do\n{said}");
}

#[test]
fn sensors_are_refused_where_they_stand() {
    let sensor = |lines: &str| format!("{ARM}[sensors.s]\n{lines}\n");
    let cases = [
        ("of = \"arm.q3\"", "sensors.s: no number `arm.q3` in the rows", 5, 6),
        ("of = \"kinetic\"", "sensors.s: no number `kinetic` in the rows", 5, 6),
        ("of = \"arm.q1\"\nunit = \"N\"", "sensors.s: `unit` is that of a number in N", 6, 8),
        (
            "of = \"arm.q1\"\nperiod = \"1.5_ms\"",
            "sensors.s: period = 0.0015 s is no whole number of steps",
            6,
            10,
        ),
        (
            "of = \"arm.q1\"\ndelay = \"0.5_ms\"",
            "sensors.s: delay = 0.0005 s is no whole number of steps",
            6,
            9,
        ),
        ("of = \"arm.q1\"\ndelay = \"0.1_s\"", "sensors.s: `delay` is 100 steps, `period` 1", 6, 9),
        ("of = \"arm.q1\"\nperiod = 1e-12", "sensors.s: `period` is shorter than a step", 6, 10),
        ("of = \"arm.q1\"\nrange = [1, 0]", "sensors.s: a number of it is out of range", 4, 10),
    ];
    for (lines, words, line, column) in cases {
        told(&sensor(lines), &[], words, &format!("placed.toml:{line}:{column}"));
    }
    // A setting is a text of its own.
    let fine = sensor("of = \"arm.q1\"");
    told(&fine, &["--set", "sensors.s.of=arm.q3"], "no number `arm.q3`", "--set:1:16");
}

#[test]
fn controllers_are_refused_where_they_stand() {
    let held = |from: &str, to: &str| format!("{ARM}[controllers.c]\n{}", HELD.replace(from, to));
    let cases = [
        (held("arm.q1", "arm.q3"), "controllers.c: no number `arm.q3` in the rows or of a sensor", 5, 9),
        (
            held("arm.q1", "sensors.s"),
            "controllers.c: no number `sensors.s` in the rows or of a sensor",
            5,
            9,
        ),
        (held("arm.T", "arm.F"), "controllers.c: `arm.F` is no valve and no free input", 6, 10),
        (held("0.001", "0.0015"), "controllers.c: period = 0.0015 s is no whole number of steps", 8, 10),
        (held("target", "unit = \"m\"\ntarget"), "controllers.c: `unit` is that of a number in m", 7, 8),
        (
            format!("{ARM}[controllers.c]\n{HELD}[controllers.d]\n{HELD}"),
            "controllers.d: `arm.T` is driven by controllers.c already",
            11,
            10,
        ),
    ];
    for (text, words, line, column) in cases {
        told(&text, &[], words, &format!("placed.toml:{line}:{column}"));
        // A choice of the method, too, says where.
        told(&text, &["--error", "1e-3"], words, &format!("placed.toml:{line}:{column}"));
    }
}
