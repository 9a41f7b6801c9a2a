//! Counts the instructions of a new process; the count does not depend on the machine's load.

use std::process::Command;

use smartbed::install::install;

/// Instructions of a process that runs one test of this binary alone, with a variable of its environment set.
pub fn of_a_fresh_process(test: &str, variable: &str, value: &str) -> f64 {
    if Command::new("valgrind").arg("--version").output().is_err() {
        let why = "valgrind, which counts the instructions of a process, is not on PATH";
        install(why, &["valgrind"], "apt-get install valgrind").unwrap_or_else(|e| panic!("{e}"));
    }
    let this = std::env::current_exe().expect("the test binary");
    let mut command = Command::new("valgrind");
    command.args(["--tool=callgrind", "--callgrind-out-file=/dev/null"]).arg(this);
    command.args(["--exact", test, "--test-threads=1"]).env(variable, value);
    let output = command.output().expect("valgrind runs");
    let text = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{text}");
    let count = text.lines().find_map(|line| line.split("Collected :").nth(1));
    count.and_then(|count| count.trim().parse().ok()).unwrap_or_else(|| panic!("no count in {text}"))
}
