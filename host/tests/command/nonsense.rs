//! Random arguments and states files: always status 0, 1 or 2 and a message, never a panic.

use crate::support::{Done, command, timed, written};

/// Cases of each kind; every one starts the program.
const CASES: u64 = 150;
/// Nothing here has reason to take longer (s of processor time).
const PATIENCE: f64 = 5.0;

/// A small generator (SplitMix64): the same cases every time.
struct Random(u64);

impl Random {
    fn next(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) % n as u64) as usize
    }
    fn pick<'a>(&mut self, list: &[&'a str]) -> &'a str {
        list[self.next(list.len())]
    }
}

fn check((done, seconds): &(Done, f64), what: &str) -> bool {
    assert!((0..=2).contains(&done.status), "{what}: {done:?}");
    assert!(!done.err.contains("panicked"), "{what}: {done:?}");
    assert!(done.status == 0 || !done.err.trim().is_empty(), "{what}: no message");
    assert!(*seconds < PATIENCE, "{what}: {seconds} s");
    done.status == 0
}

#[test]
fn states_files() {
    let numbers =
        ["0", "1", "-0.4", "1e-300", "1e300", "-1e308", "3.5", "\"x\"", "null", "[]", "1e400", "{}"];
    let names = ["q1", "q2", "q3", "u1", "u2", "T", "l1", "m2", "I3", "g", "", "q1 ", "\\u0000", "états"];
    let groups = ["q", "u", "inputs", "parameters", "Q", "states"];
    let mut random = Random(1);
    let mut understood = 0;
    for case in 0..CASES {
        let mut states = Vec::new();
        for _ in 0..random.next(3) {
            let mut state = vec![format!("\"q\": {{\"q1\": {}}}", numbers[random.next(7)])];
            for _ in 0..random.next(3) {
                let entries: Vec<String> = (0..random.next(3))
                    .map(|_| format!("\"{}\": {}", random.pick(&names), random.pick(&numbers)))
                    .collect();
                state.push(format!("\"{}\": {{{}}}", random.pick(&groups), entries.join(", ")));
            }
            states.push(format!("{{{}}}", state.join(", ")));
        }
        let mut text = format!("{{\"states\": [{}]}}", states.join(", "));
        if random.next(8) == 0 {
            text.truncate(random.next(text.len() + 1));
        }
        let path = written(&format!("nonsense{}.json", case % 4), &text);
        let done = timed(&command(&["eval", "fourbar", "--states", &path]));
        understood += u64::from(check(&done, &text));
    }
    // The cases reach beyond the reader.
    assert!(understood * 10 >= CASES, "{understood} of {CASES}");
}

#[test]
fn command_lines() {
    let words = [
        "run",
        "eval",
        "derive",
        "check",
        "fourbar",
        "pendulum",
        "tile_minimal",
        "nobody",
        "--seconds",
        "0.01",
        "0",
        "-1",
        "1e308",
        "nan",
        "--step",
        "1e-3",
        "--every",
        "--set",
        "q1=1",
        "m1=0",
        "l2=-3",
        "g=1e200",
        "m1=",
        "=",
        "--method",
        "rk4",
        "euler",
        "dormand-prince",
        "--csv",
        "-",
        "--error",
        "--budget",
        "200us",
        "--tolerance",
        "1e-9",
        "--scalar",
        "f32",
        "f64",
        "--json",
        "--form",
        "minimal",
        "kinematic",
        "--answers",
        "rates,,",
        "--engine",
        "--keep",
        "--",
        "",
        "ü",
    ];
    let starts = [["run", "pendulum"], ["run", "fourbar"], ["derive", "pendulum"], ["check", "fourbar"]];
    let mut random = Random(2);
    let mut understood = 0;
    for _ in 0..CASES {
        let mut line: Vec<&str> = starts[random.next(starts.len())].to_vec();
        if line[0] == "run" {
            line.extend(["--seconds", "0.01"]);
        }
        if random.next(10) == 0 {
            line.clear();
        }
        for _ in 0..random.next(5) {
            line.push(random.pick(&words));
        }
        let done = timed(&command(&line));
        understood += u64::from(check(&done, &line.join(" ")));
    }
    assert!(understood * 20 >= CASES, "{understood} of {CASES}");
}
