//! Where a result goes: a file, or standard output for `-`.

use crate::failure::Failure;
use std::fs::File;
use std::io::{self, BufWriter, ErrorKind, Write};

/// Something to write results to; a reader that went away is no failure.
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
        Ok(Self { to, name: path.to_owned() })
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
pub fn print(text: &str) {
    // A reader that went away is no failure.
    let _ = write("-", text.as_bytes());
}

fn cannot_write(path: &str, error: &io::Error) -> Failure {
    Failure::Wrong(format!("cannot write {path}: {error}"))
}
