//! Writes results to a file, or to standard output for `-`, and messages to standard error.
//!
//! A reader that has gone away (`| head`) is no failure; a full disk is one. Failures to write to standard error are
//! ignored, because there is nowhere to report them.

use crate::failure::Failure;
use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fs::File;
use std::io::{self, BufWriter, ErrorKind, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicU8, Ordering};

/// Was standard output closed before the program began? The standard library then opens the null device in its place,
/// and every write would seem to succeed.
static CLOSED: AtomicBool = AtomicBool::new(false);

/// Records that standard output is closed, so that writing to it becomes an error.
pub fn stdout_is_closed() {
    CLOSED.store(true, Ordering::Relaxed);
}

/// Refuses two results for standard output, of which one would end within the other: each by its option, and whether it
/// goes there.
///
/// # Errors
/// [`Failure::Wrong`] names the first two.
pub fn one_in_standard_output(results: &[(&str, bool)]) -> Result<(), Failure> {
    let mut there = results.iter().filter(|(_, is_there)| *is_there).map(|(name, _)| *name);
    match (there.next(), there.next()) {
        (Some(one), Some(other)) => Err(Failure::Wrong(format!(
            "{one} and {other}: only one of them can go to standard output; name a file for the other"
        ))),
        _ => Ok(()),
    }
}

/// Refuses results, each by its option and file, that would replace a file which the command reads, or one another.
///
/// # Errors
/// [`Failure::Wrong`] names the option and the file.
pub fn replace_none(results: &[(&str, Option<&str>)], inputs: &[&str]) -> Result<(), Failure> {
    let place = |path: &str| std::fs::canonicalize(path).ok();
    // A model may be named without its ending.
    let read: Vec<PathBuf> =
        inputs.iter().flat_map(|input| [place(input), place(&format!("{input}.toml"))]).flatten().collect();
    let mut written: Vec<(&str, PathBuf)> = Vec::new();
    for (option, file) in
        results.iter().filter_map(|(option, file)| Some((option, file.filter(|f| *f != "-")?)))
    {
        let full = place(file).unwrap_or_else(|| PathBuf::from(file));
        if read.contains(&full) && full.is_file() {
            let message =
                format!("{option} {file}: this would replace a file that is read; name another one");
            return Err(Failure::Wrong(message));
        }
        if let Some((first, _)) = written.iter().find(|(_, other)| *other == full && !is_device(&full)) {
            let message = format!("{first} and {option}: both would write {file}; name two files");
            return Err(Failure::Wrong(message));
        }
        written.push((option, full));
    }
    Ok(())
}

/// Whether something that is no file stands there: it takes several results.
fn is_device(place: &Path) -> bool {
    place.exists() && !place.is_file()
}

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
        if path == "-" && CLOSED.load(Ordering::Relaxed) {
            return Err(Failure::Wrong("cannot write standard output: it is closed".to_owned()));
        }
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

    /// Finishes the output and reports late errors.
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

/// Writes to a temporary file and renames it, so that the file appears complete or not at all, even if the process is
/// killed. Devices and pipes are written to directly.
///
/// # Errors
/// [`Failure::Wrong`] if that fails.
pub fn replace(file: &Path, text: &str) -> Result<(), Failure> {
    replace_bytes(file, text.as_bytes())
}

/// The same with bytes.
///
/// # Errors
/// As [`replace`].
pub fn replace_bytes(file: &Path, text: &[u8]) -> Result<(), Failure> {
    let place = std::fs::canonicalize(file).unwrap_or_else(|_| file.to_owned());
    if place.exists() && !place.is_file() {
        return write(&place.display().to_string(), text);
    }
    let beside = place.with_extension(format!("{PART}{}", std::process::id()));
    let put = || -> io::Result<()> {
        let mut open = File::create(&beside)?;
        // A file system without locks keeps what a killed process leaves.
        let _ = open.lock();
        open.write_all(text)?;
        open.sync_all()?;
        std::fs::rename(&beside, &place)
    };
    // Once more: `clear` may remove it before it is locked.
    let again = |e: io::Error| if e.kind() == ErrorKind::NotFound { put() } else { Err(e) };
    put().or_else(again).map_err(|e| {
        let _ = std::fs::remove_file(&beside);
        cannot_write(&file.display().to_string(), &e)
    })
}

/// Start of the extension of a temporary file; the number of the process that writes it follows.
const PART: &str = "part-";

/// Removes temporary files that [`replace`] left in a folder when its process was killed, of files whose names
/// without extension are given. What a process is writing is locked, and stays.
pub fn clear(folder: &Path, names: &BTreeSet<OsString>) {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        let is_part = path.extension().is_some_and(|e| e.to_string_lossy().starts_with(PART));
        let is_own = path.file_stem().is_some_and(|name| names.contains(name));
        if is_part && is_own && File::open(&path).is_ok_and(|file| file.try_lock().is_ok()) {
            let _ = std::fs::remove_file(&path);
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

/// Prints a line to standard error; a leading `error`, `warning` or `note` is coloured.
pub fn say(line: &str) {
    let _ = writeln!(io::stderr(), "{}", tinted(line, has_colour(Stream::Error)));
}

/// Standard output or standard error.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Stream {
    /// Results.
    Out,
    /// Messages.
    Error,
}

/// When text has colours.
#[derive(Clone, Copy, Default, PartialEq, Eq, Debug, clap::ValueEnum)]
#[repr(u8)]
pub enum Colour {
    /// On a terminal, unless the environment variable `NO_COLOR` is set.
    #[default]
    Auto,
    /// Always.
    Always,
    /// Never.
    Never,
}

/// The choice of `--color`.
static COLOUR: AtomicU8 = AtomicU8::new(Colour::Auto as u8);

/// Sets for the whole program when text is coloured.
pub fn choose_colour(colour: Colour) {
    COLOUR.store(colour as u8, Ordering::Relaxed);
}

/// Shall text to this stream be coloured?
#[must_use]
pub fn has_colour(to: Stream) -> bool {
    let chosen = COLOUR.load(Ordering::Relaxed);
    let is_set = |name: &str| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    let dumb = std::env::var_os("TERM").is_some_and(|term| term == "dumb");
    let auto = || is_terminal(to) && !is_set("NO_COLOR") && !dumb;
    chosen == Colour::Always as u8 || (chosen == Colour::Auto as u8 && auto())
}

fn is_terminal(stream: Stream) -> bool {
    match stream {
        Stream::Out => io::stdout().is_terminal(),
        Stream::Error => io::stderr().is_terminal(),
    }
}

/// Width of the terminal behind a stream, if it is one.
#[must_use]
pub fn columns(stream: Stream) -> Option<usize> {
    if !is_terminal(stream) {
        return None;
    }
    #[cfg(unix)]
    {
        let size = match stream {
            Stream::Out => rustix::termios::tcgetwinsize(io::stdout()),
            Stream::Error => rustix::termios::tcgetwinsize(io::stderr()),
        };
        size.ok().map(|size| usize::from(size.ws_col)).filter(|columns| *columns >= LEAST_COLUMNS)
    }
    #[cfg(not(unix))]
    None
}

/// Narrower than this a terminal's width is not trusted.
const LEAST_COLUMNS: usize = 40;

/// The line with its first word coloured (ECMA-48), if that word has a colour.
pub(crate) fn tinted(line: &str, has_colour: bool) -> String {
    let words = [("error", "1;91"), ("warning", "1;33"), ("note", "1;32")];
    let first = words.iter().find_map(|(word, code)| Some((word, code, line.strip_prefix(word)?)));
    match first.filter(|(.., rest)| has_colour && rest.starts_with(": ")) {
        Some((word, code, rest)) => format!("\x1b[{code}m{word}\x1b[0m{rest}"),
        None => line.to_owned(),
    }
}

fn cannot_write(path: &str, error: &io::Error) -> Failure {
    Failure::Wrong(format!("cannot write {path}: {error}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_word_alone_is_coloured() {
        assert_eq!(tinted("warning: error: x", true), "\x1b[1;33mwarning\x1b[0m: error: x");
        assert_eq!(tinted("errors: x", true), "errors: x");
        assert_eq!(tinted("error: x", false), "error: x");
    }

    #[test]
    fn a_choice_holds_for_both_streams() {
        // Tests write to no terminal.
        assert_eq!((has_colour(Stream::Out), columns(Stream::Error)), (false, None));
    }
}
