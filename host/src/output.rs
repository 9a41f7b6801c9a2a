//! Where a result goes: a file, or standard output for `-`; and what is said on standard error meanwhile.
//!
//! A reader that went away (`| head`) is no failure; a disk that is full is one. Nobody hears a complaint about
//! standard error itself: what cannot be said there is left unsaid.

use crate::failure::Failure;
use std::fs::File;
use std::io::{self, BufWriter, ErrorKind, Write};

/// Something to write results to.
pub struct Output {
    to: Box<dyn Write>,
    name: String,
}

impl std::fmt::Debug for Output {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Output").field("name", &self.name).finish_non_exhaustive()
    }
}

impl Output {
    /// Opens a file, or standard output for `-`.
    ///
    /// # Errors
    /// [`Failure::Wrong`] if the file cannot be created.
    pub fn open(path: &str) -> Result<Self, Failure> {
        let to: Box<dyn Write> = if path == "-" {
            Box::new(BufWriter::new(io::stdout()))
        } else {
            Box::new(BufWriter::new(File::create(path).map_err(|e| cannot_write(path, &e))?))
        };
        Ok(Self { to, name: if path == "-" { "standard output".to_owned() } else { path.to_owned() } })
    }

    /// Writes text.
    ///
    /// # Errors
    /// [`Failure::Wrong`] if that fails.
    pub fn write(&mut self, text: &str) -> Result<(), Failure> {
        let done = self.to.write_all(text.as_bytes());
        self.judge(done)
    }

    /// Everything has been written.
    ///
    /// # Errors
    /// [`Failure::Wrong`] if that fails.
    pub fn finish(mut self) -> Result<(), Failure> {
        let done = self.to.flush();
        self.judge(done)
    }

    fn judge(&self, done: io::Result<()>) -> Result<(), Failure> {
        match done {
            Err(e) if e.kind() != ErrorKind::BrokenPipe => Err(cannot_write(&self.name, &e)),
            _ => Ok(()),
        }
    }
}

/// Writes a whole file, or to standard output for `-`.
///
/// # Errors
/// [`Failure::Wrong`] if that fails.
pub fn write(path: &str, bytes: &[u8]) -> Result<(), Failure> {
    if path != "-" {
        return std::fs::write(path, bytes).map_err(|e| cannot_write(path, &e));
    }
    let mut output = Output::open(path)?;
    let done = output.to.write_all(bytes);
    output.judge(done)?;
    output.finish()
}

/// Prints to standard output.
///
/// # Errors
/// [`Failure::Wrong`] if that fails.
pub fn print(text: &str) -> Result<(), Failure> {
    write("-", text.as_bytes())
}

/// A line on standard error.
pub fn say(line: &str) {
    let _ = writeln!(io::stderr(), "{line}");
}

fn cannot_write(path: &str, error: &io::Error) -> Failure {
    Failure::Wrong(format!("cannot write {path}: {error}"))
}
