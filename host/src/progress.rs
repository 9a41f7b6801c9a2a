//! Progress on standard error for work that takes longer than a second: a bar with the time left if the share done is
//! known, else the name of the work and the time elapsed.
//!
//! On a terminal `indicatif` draws it and removes it at the end; elsewhere a line is printed now and then.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::{IsTerminal, Write};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Time before anything is shown.
const PATIENCE: Duration = Duration::from_secs(1);
/// Time between two updates: on a terminal, and elsewhere, where each is a line of its own.
const INTERVALS: [Duration; 2] = [Duration::from_millis(200), Duration::from_secs(5)];
/// Resolution of a bar.
const PARTS: u64 = 1000;

/// Progress of work whose share done is known.
#[derive(Debug)]
pub struct Progress {
    what: String,
    start: Instant,
    last: Option<Instant>,
    terminal: bool,
    bar: Option<ProgressBar>,
}

impl Progress {
    /// Starts the clock.
    #[must_use]
    pub fn new(what: &str) -> Self {
        let terminal = std::io::stderr().is_terminal();
        Self { what: what.to_owned(), start: Instant::now(), last: None, terminal, bar: None }
    }

    /// Reports that the share `done` (0 to 1) is done; shows it if an update is due.
    pub fn at(&mut self, done: f64) {
        let interval = if self.terminal { INTERVALS[0] } else { INTERVALS[1] };
        let since = self.last.map_or(self.start.elapsed() >= PATIENCE, |last| last.elapsed() >= interval);
        if !since {
            return;
        }
        self.last = Some(Instant::now());
        let left = left(self.start.elapsed().as_secs_f64(), done);
        if self.terminal {
            let bar =
                self.bar.get_or_insert_with(|| bar(&self.what, "{prefix} {bar:32} {percent:>3} %{msg}"));
            bar.set_message(left);
            bar.set_position((done.clamp(0.0, 1.0) * PARTS as f64) as u64);
        } else {
            // A closed standard error is no reason to stop.
            let _ = writeln!(std::io::stderr(), "{}: {:3.0} %{left}", self.what, 100.0 * done);
        }
    }

    /// Seconds since the start.
    #[must_use]
    pub fn seconds(&self) -> f64 {
        self.start.elapsed().as_secs_f64()
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

fn bar(what: &str, template: &str) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(PARTS), ProgressDrawTarget::stderr());
    // The template is a constant; if it were wrong, the default style would serve.
    let style = ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
    bar.set_style(style);
    bar.set_prefix(what.to_owned());
    bar
}

/// Progress of work whose share done is unknown: what it is and for how long. Where there is no terminal, shown only if
/// the work has stages.
#[derive(Debug)]
pub struct Waiting {
    done: Option<Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

impl Waiting {
    /// Begins to wait, until it is dropped.
    #[must_use]
    pub fn new(what: &str) -> Self {
        Self::begin(what, None)
    }

    /// Shows the derivation of equations, with its present stage.
    #[must_use]
    pub fn deriving() -> Self {
        Self::begin("deriving the equations", Some(smartbed_codegen::program::stage::current))
    }

    /// Shows that the parts of a world come to rest.
    #[must_use]
    pub fn settling() -> Self {
        Self::begin(
            "settle",
            Some(|| "parts come to rest; one that still swings or creeps keeps all others waiting"),
        )
    }

    fn begin(what: &str, stage: Option<fn() -> &'static str>) -> Self {
        let is_terminal = std::io::stderr().is_terminal();
        if !is_terminal && stage.is_none() {
            return Self { done: None, thread: None };
        }
        let (done, ended) = mpsc::channel::<()>();
        let what = what.to_owned();
        let show = move || match stage {
            _ if ended.recv_timeout(PATIENCE) != Err(RecvTimeoutError::Timeout) => {}
            Some(stage) if !is_terminal => list(&mut std::io::stderr(), &what, stage, &ended),
            _ => spin(&what, stage, &ended),
        };
        Self { done: Some(done), thread: std::thread::Builder::new().spawn(show).ok() }
    }
}

impl Drop for Waiting {
    fn drop(&mut self) {
        drop(self.done.take());
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

/// Draws the name of the work, its stage and its time on one line, which is removed at the end.
fn spin(what: &str, stage: Option<fn() -> &'static str>, ended: &Receiver<()>) {
    let bar = bar(what, "{spinner} {prefix}{msg} {elapsed}");
    loop {
        if let Some(stage) = stage {
            bar.set_message(format!(": {}", stage()));
        }
        bar.tick();
        if ended.recv_timeout(INTERVALS[0]) != Err(RecvTimeoutError::Timeout) {
            break;
        }
    }
    bar.finish_and_clear();
}

/// Prints a line for each stage that begins after the first second.
fn list(to: &mut dyn Write, what: &str, stage: fn() -> &'static str, ended: &Receiver<()>) {
    let mut last = "";
    loop {
        let now = stage();
        if now != last {
            // A closed standard error is no reason to stop.
            let _ = writeln!(to, "{what}: {now}");
            last = now;
        }
        if ended.recv_timeout(INTERVALS[0]) != Err(RecvTimeoutError::Timeout) {
            break;
        }
    }
}

/// Estimated time left, if progress continues at the same rate; empty if that cannot be estimated.
fn left(elapsed: f64, done: f64) -> String {
    let seconds = elapsed * (1.0 - done) / done;
    match seconds {
        _ if !(done > 0.01 && done <= 1.0) => String::new(),
        s if s < 90.0 => format!(", {s:.0} s left"),
        s if s < 5400.0 => format!(", {:.0} min left", s / 60.0),
        s => format!(", {:.1} h left", s / 3600.0),
    }
}

#[cfg(test)]
mod tests {
    use super::{left, list};
    use std::sync::atomic::{AtomicUsize, Ordering};
    use std::sync::mpsc;

    #[test]
    fn a_line_for_each_stage_in_turn() {
        static LOOKS: AtomicUsize = AtomicUsize::new(0);
        // Each look at it but the second is at a new stage; the end comes after the third.
        let (done, ended) = mpsc::channel::<()>();
        let lines = std::thread::spawn(move || {
            let mut lines = Vec::new();
            let stage = || ["rows", "rows", "sums", "sums"][LOOKS.fetch_add(1, Ordering::SeqCst).min(3)];
            list(&mut lines, "deriving", stage, &ended);
            String::from_utf8(lines).expect("text")
        });
        while LOOKS.load(Ordering::SeqCst) < 3 {
            std::thread::sleep(std::time::Duration::from_millis(1));
        }
        drop(done);
        assert_eq!(lines.join().expect("an end"), "deriving: rows\nderiving: sums\n");
    }

    #[test]
    fn the_time_left_goes_by_what_is_done() {
        assert_eq!(left(10.0, 0.5), ", 10 s left");
        assert_eq!(left(60.0, 0.2), ", 4 min left");
        assert_eq!(left(100.0, 0.02), ", 82 min left");
        assert_eq!(left(1000.0, 0.02), ", 13.6 h left");
        assert_eq!(left(5.0, 0.0), "");
    }
}
