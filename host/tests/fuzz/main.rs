//! Random models, expressions, states files, scenes and command lines: no panic, no hang, no unbounded memory, no NaN
//! in an answer.
//!
//! Every case ends with an answer or with a message that names a place. The cases run in a child process
//! whose address space is limited to 1 GiB. The seed is fixed, so that case n is always the same:
//! `SMARTBED_FUZZ_CASES=1000000 cargo test -p smartbed --test fuzz`, and `SMARTBED_FUZZ_FIRST=n
//! SMARTBED_FUZZ_CASES=1` for case n alone. `SMARTBED_FUZZ_KIND=scene` draws only kinds whose names begin so: scenes'
//! texts and command lines.

mod arguments;
mod models;
mod plans;
mod random;
mod scenes;
mod states;
mod worlds;

use clap::Parser;
use random::Random;
use smartbed::failure::Failure;
use smartbed::output::Stream;
use smartbed::{check, derive, diagnostics, eval, model_argument, run, scene};
use smartbed_codegen::{EmitOptions, ParameterChoice, model, program, rust};
use std::os::unix::fs::FileExt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// Cases if the environment does not say.
const CASES: u64 = 10_000;
/// A case that needs a processor for longer hangs.
const LIMIT: Duration = Duration::from_secs(1);
/// The same where an error is asked for: the calibration's reference takes 6 s at most, then its methods are measured.
const CALIBRATED: Duration = Duration::from_secs(30);
/// A case that takes longer than this is not waited for: others may have the processor.
const PATIENCE: Duration = Duration::from_secs(600);
/// Address space of the process that runs the cases (KiB).
const MEMORY: u64 = 1 << 20;

/// Subcommands with an answer at once; the firmware builds for minutes and has tests of its own.
#[derive(Parser)]
#[command(name = "smartbed")]
enum CommandLine {
    Check(check::Arguments),
    Derive(derive::Arguments),
    Eval(eval::Arguments),
    Run(run::Arguments),
}

/// How far a case came.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Outcome {
    /// The text was refused.
    Refused,
    /// The text was read, then something else was wrong.
    Read,
    /// There is an answer.
    Answered,
}

/// Description of a case, for messages, and its outcome.
struct Case {
    kind: usize,
    text: String,
    outcome: Result<Outcome, String>,
}

/// Action of a case.
type Run = Box<dyn FnOnce() -> Result<Outcome, String>>;

const KINDS: [&str; 5] = ["models", "states", "arguments", "scenes", "scene lines"];
/// How many of 28 cases are of each kind.
const SHARES: [usize; KINDS.len()] = [12, 4, 4, 4, 4];

fn number(name: &str) -> Option<u64> {
    std::env::var(name).ok().and_then(|n| n.parse().ok())
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).to_owned()
}

#[test]
fn random_input_neither_panics_nor_hangs_nor_floods_the_memory() {
    let program = std::env::current_exe().expect("this test has a path");
    let mut child = Command::new("sh");
    child.args(["-c", &format!("ulimit -v {MEMORY} && exec \"$0\" \"$@\"")]).arg(program);
    child.args(["--exact", "cases", "--ignored", "--nocapture", "--test-threads=1"]);
    // What commands print is not looked at; what the cases say goes to standard error.
    let status = child.stdout(Stdio::null()).stdin(Stdio::null()).status().expect("a shell");
    let last = std::fs::read_to_string(folder().join("fuzz.case")).unwrap_or_default();
    assert!(status.success(), "{status} in or after case {}", last.trim());
}

#[test]
#[ignore = "run by the other test, with limited memory"]
fn cases() {
    std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).expect("the workspace");
    let cases = number("SMARTBED_FUZZ_CASES").unwrap_or(CASES);
    let first = number("SMARTBED_FUZZ_FIRST").unwrap_or(0);
    let at = std::fs::File::create(folder().join("fuzz.case")).expect("a file");
    let (shares, shipped) = (shares(), models::shipped());
    let started: &'static AtomicU64 = Box::leak(Box::new(AtomicU64::new(first)));
    watch(started);
    // By kind: cases, those read, those answered.
    let mut counts = [[0_u64; 3]; KINDS.len()];
    let mut slowest = Duration::ZERO;
    for case in first..first + cases {
        let _ = at.write_at(format!("{case:>20}").as_bytes(), 0);
        started.store(case + 1, Ordering::Relaxed);
        let start = processor_time();
        let done = run_case(case, &shares, &shipped);
        let took = processor_time().saturating_sub(start);
        let outcome = done.outcome.unwrap_or_else(|e| panic!("case {case}: {e}\n{}", done.text));
        let limit = if done.text.contains("--error") { CALIBRATED } else { LIMIT };
        assert!(took < limit, "case {case} takes {took:?}:\n{}", done.text);
        let count = &mut counts[done.kind];
        count[0] += 1;
        count[1] += u64::from(outcome >= Outcome::Read);
        count[2] += u64::from(outcome == Outcome::Answered);
        slowest = slowest.max(took);
        if (case + 1) % 50_000 == 0 || case + 1 == first + cases {
            for (kind, [all, read, answered]) in KINDS.iter().zip(counts) {
                eprint!("{all} {kind}: {read} read, {answered} answered; ");
            }
            eprintln!("slowest {slowest:?}");
        }
    }
    // A share means something for many cases only.
    for (kind, [all, read, answered]) in KINDS.iter().zip(counts).filter(|(_, [all, ..])| *all >= 1000) {
        assert!(all <= 5 * read, "{kind}: only {read} of {all} pass the reader");
        assert!(all <= 20 * answered, "{kind}: only {answered} of {all} have an answer");
    }
}

/// Time that this thread has had a processor: others may have it while a case waits.
fn processor_time() -> Duration {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let nanoseconds = text.split(' ').next().and_then(|n| n.parse().ok());
    Duration::from_nanos(nanoseconds.expect("Linux counts it"))
}

/// Ends the process if one case takes far too long: nothing else could.
fn watch(started: &'static AtomicU64) {
    std::thread::spawn(move || {
        let (mut seen, mut since) = (0, Instant::now());
        loop {
            std::thread::sleep(Duration::from_secs(1));
            let now = started.load(Ordering::Relaxed);
            if now != seen {
                (seen, since) = (now, Instant::now());
            } else if since.elapsed() > PATIENCE {
                eprintln!("case {} hangs", now.saturating_sub(1));
                std::process::exit(101);
            }
        }
    });
}

/// The shares of the kinds that the environment names, all if it names none.
fn shares() -> [usize; KINDS.len()] {
    let begin = std::env::var("SMARTBED_FUZZ_KIND").unwrap_or_default();
    let shares = std::array::from_fn(|k| if KINDS[k].starts_with(&begin) { SHARES[k] } else { 0 });
    assert!(shares.iter().any(|&n| n > 0), "SMARTBED_FUZZ_KIND=`{begin}` begins none of {KINDS:?}");
    shares
}

/// One of the kinds, as often as its share.
fn drawn(shares: &[usize; KINDS.len()], random: &mut Random) -> usize {
    let mut left = random.below(shares.iter().sum());
    shares
        .iter()
        .position(|&n| {
            left < n || {
                left -= n;
                false
            }
        })
        .expect("less than their sum")
}

fn run_case(case: u64, shares: &[usize; KINDS.len()], shipped: &[String]) -> Case {
    let mut random = Random::new(case);
    let kind = drawn(shares, &mut random);
    let (text, run): (String, Run) = match kind {
        0 => {
            let text = models::text(&mut random, shipped);
            let own = text.clone();
            (text, Box::new(move || run_model(&own, case)))
        }
        1 => {
            let (subject, text) = states::file(&mut random);
            let own = text.clone();
            (format!("{}: {text}", subject.model), Box::new(move || run_states(subject.model, &own)))
        }
        2 => {
            let line = arguments::line(&mut random, &folder().display().to_string());
            (format!("{line:?}"), Box::new(move || run_line(&line)))
        }
        3 => {
            let (text, settings) = (scenes::text(&mut random), scenes::settings(&mut random));
            let own = text.clone();
            (format!("{settings:?}\n{text}"), Box::new(move || run_scene(&own, &settings)))
        }
        _ => {
            let csv = folder().join("fuzz.csv").display().to_string();
            let line = scenes::line(&mut random, &csv);
            (format!("{line:?}"), Box::new(move || run_scene_line(&line, &csv)))
        }
    };
    let outcome = catch_unwind(AssertUnwindSafe(run)).unwrap_or_else(|_| Err("panics".to_owned()));
    Case { kind, text, outcome }
}

/// Status 1 or 2 with a message that holds one of the places.
fn refused(failure: &Failure, places: &[&str]) -> Result<(), String> {
    let text = failure.to_string();
    let placed = places.iter().any(|place| text.contains(place));
    if let Failure::Found(found) = failure {
        // As a terminal shows it: whatever the text and its places, nothing panics or moves the cursor.
        let shown = diagnostics::text(found, Stream::Error);
        if shown.chars().any(|c| c.is_control() && c != '\n') {
            return Err(format!("a control character is shown: {shown:?}"));
        }
    }
    if (1..=2).contains(&failure.status()) && placed {
        Ok(())
    } else {
        Err(format!("no place in the message: {text}"))
    }
}

/// Read and derived; now and then emitted, or checked as the command does.
fn run_model(text: &str, case: u64) -> Result<Outcome, String> {
    let place = ["fuzz.toml:"];
    let model = match model::parse("fuzz.toml", text) {
        Err(found) if found.has_errors() => {
            return refused(&model_argument::wrong(&found), &place).map(|()| Outcome::Refused);
        }
        Err(_) => return Err("refused without an error".to_owned()),
        Ok(model) => model,
    };
    let program = match program::derive(&model, &ParameterChoice::default()) {
        Err(found) if found.has_errors() => {
            return refused(&model_argument::wrong(&found), &place).map(|()| Outcome::Read);
        }
        Err(_) => return Err("not derived without an error".to_owned()),
        Ok(program) => program,
    };
    if case.is_multiple_of(16) {
        let path = folder().join("fuzz.toml");
        std::fs::write(&path, text).map_err(|e| e.to_string())?;
        let arguments = check::Arguments {
            model: path.display().to_string(),
            rounding: case.is_multiple_of(64),
            all: false,
            json: case.is_multiple_of(32),
        };
        check::run(&arguments).map_err(|e| format!("derived, but not checked: {e}"))?;
    }
    if case % 16 == 1 && rust::emit(&program, &EmitOptions::default()).is_empty() {
        return Err("derived, but nothing is emitted".to_owned());
    }
    Ok(Outcome::Answered)
}

/// Springs times steps that a case may take.
const SCENE_WORK: usize = 20_000;

/// Read, and stepped for a while.
fn run_scene(text: &str, settings: &[String]) -> Result<Outcome, String> {
    let mut scene = match scene::parse("fuzz.toml", text, settings) {
        Ok(scene) => scene,
        Err(message) if message.contains("fuzz.toml") || message.contains("--set ") => {
            return Ok(Outcome::Refused);
        }
        Err(message) => return Err(format!("no place in the message: {message}")),
    };
    let steps = SCENE_WORK / scene.lists.springs.len().max(100);
    scene.seconds = scene.seconds.min(steps as f64 * scene.step);
    let mut rows = 0;
    match scene::run::run::<f64>(&scene, |_| rows += 1) {
        Ok(_) if rows > 0 => Ok(Outcome::Answered),
        Ok(_) => Err("no row".to_owned()),
        Err(message) if message.starts_with("t = ") => Ok(Outcome::Read),
        Err(message) => Err(format!("no time in the message: {message}")),
    }
}

fn run_states(model: &str, text: &str) -> Result<Outcome, String> {
    let path = folder().join("fuzz.json");
    std::fs::write(&path, text).map_err(|e| e.to_string())?;
    let file = path.display().to_string();
    let line = ["smartbed", "eval", model, "--states", &file, "-o", "/dev/null"];
    let Ok(CommandLine::Eval(arguments)) = CommandLine::try_parse_from(line) else {
        return Err("the command line is right".to_owned());
    };
    match eval::run(&arguments) {
        Ok(()) => Ok(Outcome::Answered),
        Err(failure) => {
            refused(&failure, &["states[", "\"states\"", "line "])?;
            Ok(if eval::states::parse(text).is_ok() { Outcome::Read } else { Outcome::Refused })
        }
    }
}

fn run_line(line: &[String]) -> Result<Outcome, String> {
    let words = std::iter::once("smartbed").chain(line.iter().map(String::as_str));
    let command_line = match CommandLine::try_parse_from(words) {
        Ok(command_line) => command_line,
        Err(message) if message.use_stderr() => {
            let said = message.to_string();
            return if said.contains("error: ") || said.contains("Usage") {
                Ok(Outcome::Refused)
            } else {
                Err(said)
            };
        }
        Err(_) => return Ok(Outcome::Answered),
    };
    let done = match command_line {
        CommandLine::Check(arguments) => check::run(&arguments),
        CommandLine::Derive(arguments) => derive::run(&arguments),
        CommandLine::Eval(arguments) => eval::run(&arguments),
        CommandLine::Run(arguments) => run::run(&arguments),
    };
    match done {
        Ok(()) => Ok(Outcome::Answered),
        // The place on a command line is the word that is wrong, or the file and what is in it.
        Err(failure) => refused(&failure, &["`", "--", "t = ", "start", "/", " s "]).map(|()| Outcome::Read),
    }
}

/// As any command line; where it answers, its rows are numbers.
fn run_scene_line(line: &[String], csv: &str) -> Result<Outcome, String> {
    let outcome = run_line(line)?;
    if outcome == Outcome::Answered {
        let rows = std::fs::read_to_string(csv).map_err(|e| e.to_string())?;
        let is_number = |word: &str| word.parse::<f64>().is_ok_and(f64::is_finite);
        let wrong = rows.lines().skip(1).find(|row| !row.split(',').all(is_number));
        if rows.lines().nth(1).is_none() || wrong.is_some() {
            return Err(format!("status 0 with the row {wrong:?}"));
        }
    }
    Ok(outcome)
}
