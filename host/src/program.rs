//! Exit status of the programs in this package: 0 success; 1 wrong input; 2 the machine lacks something; 101 a panic,
//! which is a fault of ours.

use crate::failure::Failure;
use crate::{diagnostics, output};
use std::io::Write;
use std::process::ExitCode;

/// The status of a Rust program that panicked.
const PANICKED: i32 = 101;

/// Makes a panic exit with its own status; with `panic = abort` it would raise a signal and leave a core file.
pub fn begin() {
    let tell = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        tell(panic);
        std::process::exit(PANICKED);
    }));
}

/// Ends after the command line could not be parsed (wrong input, 1), or after help or version were printed (0).
#[must_use]
pub fn refuse(message: &clap::Error) -> ExitCode {
    let to_stdout = if message.use_stderr() { Ok(()) } else { output::print("") };
    let is_heard = to_stdout.is_ok() && message.print().is_ok_and(|()| std::io::stdout().flush().is_ok());
    ExitCode::from(u8::from(message.use_stderr() || !is_heard))
}

/// Ends with the status of a command's result.
#[must_use]
pub fn end(done: Result<(), Failure>) -> ExitCode {
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            diagnostics::fail(&failure);
            ExitCode::from(failure.status())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::process::Command;

    /// Runs as a separate process, in the test below.
    #[test]
    fn a_panic() {
        if std::env::var_os("SMARTBED_PANICS").is_some() {
            begin();
            panic!("on purpose");
        }
    }

    #[test]
    fn a_panic_ends_the_program_at_once_and_has_its_own_status() {
        let tests = std::env::current_exe().expect("a program");
        let mut panics = Command::new(tests);
        panics.args(["--exact", "program::tests::a_panic", "--nocapture"]).env("SMARTBED_PANICS", "1");
        let done = panics.output().expect("to run");
        let [out, said] = [done.stdout, done.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
        assert_eq!(done.status.code(), Some(PANICKED), "{said}");
        assert!(said.contains("on purpose"), "{said}");
        assert!(!out.contains("test result"), "the tests went on: {out}");
    }
}
