//! Running the program in a folder of its own.

use serde_json::Value;
use std::cell::Cell;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::{PoisonError, RwLock};

/// Held by every command while it runs, so that the others can wait for one that is timed.
static RUNNING: RwLock<()> = RwLock::new(());

thread_local! {
    /// Whether this test holds all commands of others.
    static ALONE: Cell<bool> = const { Cell::new(false) };
}

/// Most tries of [`least_time`] while other commands wait.
const ALONE_TRIES: usize = 5;

/// Result of a run of the program.
#[derive(Debug)]
pub struct Done {
    /// Exit status.
    pub status: i32,
    /// Standard output.
    pub out: String,
    /// Standard error.
    pub err: String,
}

impl Done {
    /// Standard output as JSON.
    pub fn json(&self) -> Value {
        serde_json::from_str(&self.out).unwrap_or_else(|e| panic!("{e}: {}\n{}", self.out, self.err))
    }

    /// The message of a wrong input: status 1, `error: ` and no panic.
    pub fn message(&self) -> &str {
        assert_eq!(self.status, 1, "{self:?}");
        assert!(self.err.starts_with("error: "), "{self:?}");
        &self.err
    }
}

/// The text of a model of the project.
pub fn model(name: &str) -> String {
    let models = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models");
    std::fs::read_to_string(models.join(name).with_extension("toml")).expect("a model")
}

/// The program with arguments, run at the root of the workspace.
pub fn smartbed(arguments: &[&str]) -> Done {
    finish(command(arguments))
}

/// A command that runs the program at the root of the workspace.
pub fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_smartbed"));
    command.args(arguments).current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(".."));
    command.stdin(Stdio::null());
    command
}

/// Runs a command to its end.
pub fn finish(mut command: Command) -> Done {
    let _running = (!ALONE.get()).then(|| RUNNING.read().unwrap_or_else(PoisonError::into_inner));
    let output = command.output().expect("the program runs");
    let said = String::from_utf8_lossy(&output.stderr);
    Done {
        // A signal has no status; no test expects -1.
        status: output.status.code().unwrap_or(-1),
        out: String::from_utf8_lossy(&output.stdout).into_owned(),
        // What a derivation is at shows on busy machines only.
        err: said
            .split_inclusive('\n')
            .filter(|line| !line.starts_with("deriving the equations: "))
            .collect(),
    }
}

/// Runs a command to its end and tells its processor time (s): what others do meanwhile does not count.
pub fn timed(command: &Command) -> (Done, f64) {
    let mut shell = Command::new("sh");
    shell.args(["-c", "\"$0\" \"$@\"; status=$?; times >&2; exit $status"]).arg(command.get_program());
    shell.args(command.get_args()).stdin(Stdio::null());
    shell.current_dir(command.get_current_dir().unwrap_or(Path::new(".")));
    let mut done = finish(shell);
    let seconds = children_seconds(&done.err);
    // The shell's own two lines are no message of the command.
    let lines = done.err.trim_end().rsplitn(3, '\n').nth(2).map_or(0, |message| message.len() + 1);
    done.err.truncate(lines);
    (done, seconds)
}

/// The least time (s) that `measure` gives, in so many tries beside other tests, until one takes no longer than
/// `wanted`. These share core and caches; if no moment was quiet enough, their commands wait for a few tries more.
pub fn least_time(wanted: f64, tries: usize, mut measure: impl FnMut() -> f64) -> f64 {
    let mut least = f64::INFINITY;
    let mut most = |tries: usize| {
        for _ in 0..tries {
            least = least.min(measure());
            if least <= wanted {
                break;
            }
        }
        least
    };
    if most(tries) <= wanted {
        return least;
    }
    let _all = RUNNING.write().unwrap_or_else(PoisonError::into_inner);
    ALONE.set(true);
    let least = most(ALONE_TRIES);
    ALONE.set(false);
    least
}

/// Processor time of the children of a shell, as its `times` prints it last: `0m0.25s 0m0.08s`.
pub fn children_seconds(times: &str) -> f64 {
    let of = |time: &str| {
        let (minutes, seconds) = time.strip_suffix('s')?.split_once('m')?;
        Some(60.0 * minutes.parse::<f64>().ok()? + seconds.parse::<f64>().ok()?)
    };
    let line = times.lines().last().expect("two lines");
    line.split_whitespace().map(|time| of(time).unwrap_or_else(|| panic!("no time in {times}"))).sum()
}

/// Gives a crate the versions of this workspace.
pub fn lock(folder: &Path) {
    let locked = Path::new(env!("CARGO_MANIFEST_DIR")).join("../Cargo.lock");
    std::fs::copy(locked, folder.join("Cargo.lock")).expect("copied");
}

/// A file of one test, in a folder of its own: tests run at once and write the same names.
pub fn file(name: &str) -> PathBuf {
    let test = std::thread::current().name().unwrap_or("unnamed").replace("::", "-");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
    std::fs::create_dir_all(&folder).expect("a folder");
    folder.join(name)
}

/// A folder for builds, which all tests share: what one has compiled the others need not.
pub fn builds(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

/// Writes a file of one test and returns its path.
pub fn written(name: &str, text: &str) -> String {
    let path = file(name);
    std::fs::write(&path, text).expect("the test folder can be written");
    path.display().to_string()
}

/// `eval` of a model at states given as JSON; `name` is the states file's.
pub fn eval(name: &str, model: &str, states: &str, more: &[&str]) -> Done {
    let path = written(name, states);
    let mut arguments = vec!["eval", model, "--states", &path];
    arguments.extend(more);
    smartbed(&arguments)
}

/// The numbers of an object, in alphabetical order of their names.
pub fn numbers(object: &Value) -> Vec<f64> {
    object.as_object().expect("an object").values().map(|x| x.as_f64().expect("a number")).collect()
}
