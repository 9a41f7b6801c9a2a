//! Running the program in a folder of its own.

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// What a run of the program left behind.
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
    let output = command.output().expect("the program runs");
    Done {
        // A signal has no status; no test expects -1.
        status: output.status.code().unwrap_or(-1),
        out: String::from_utf8_lossy(&output.stdout).into_owned(),
        err: String::from_utf8_lossy(&output.stderr).into_owned(),
    }
}

/// A file of one test, in a folder that cargo keeps for tests.
pub fn file(name: &str) -> PathBuf {
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
