//! A line on standard error for whatever takes longer than a second.

use std::io::{IsTerminal, Write};
use std::time::{Duration, Instant};

/// Nothing is said before.
const PATIENCE: Duration = Duration::from_secs(1);
/// Between two lines: on a terminal, where the line is overwritten, and elsewhere.
const INTERVALS: [Duration; 2] = [Duration::from_millis(200), Duration::from_secs(5)];

/// How far a piece of work has come.
#[derive(Debug)]
pub struct Progress {
    what: String,
    start: Instant,
    last: Option<Instant>,
    terminal: bool,
}

impl Progress {
    /// Starts the clock.
    #[must_use]
    pub fn new(what: &str) -> Self {
        let terminal = std::io::stderr().is_terminal();
        Self { what: what.to_owned(), start: Instant::now(), last: None, terminal }
    }

    /// Says that the share `done` (0 to 1) is done, if it is time to.
    pub fn at(&mut self, done: f64) {
        let interval = if self.terminal { INTERVALS[0] } else { INTERVALS[1] };
        let since = self.last.map_or(self.start.elapsed() >= PATIENCE, |last| last.elapsed() >= interval);
        if since {
            self.last = Some(Instant::now());
            let end = if self.terminal { '\r' } else { '\n' };
            // Nobody reading is no reason to stop.
            let left = left(self.start.elapsed().as_secs_f64(), done);
            let _ = write!(std::io::stderr(), "{}: {:3.0} %{left}{end}", self.what, 100.0 * done);
        }
    }

    /// Seconds since the start.
    #[must_use]
    pub fn seconds(&self) -> f64 {
        self.start.elapsed().as_secs_f64()
    }
}

/// The time left, if the rest goes as fast as the share that is done; nothing where that tells nothing.
fn left(elapsed: f64, done: f64) -> String {
    let seconds = elapsed * (1.0 - done) / done;
    match seconds {
        _ if !(done > 0.01 && done <= 1.0) => String::new(),
        s if s < 90.0 => format!(", {s:.0} s left  "),
        s if s < 5400.0 => format!(", {:.0} min left  ", s / 60.0),
        s => format!(", {:.1} h left  ", s / 3600.0),
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if self.terminal && self.last.is_some() {
            let _ = write!(std::io::stderr(), "\x1b[2K");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::left;

    #[test]
    fn the_time_left_goes_by_what_is_done() {
        assert_eq!(left(10.0, 0.5).trim_end(), ", 10 s left");
        assert_eq!(left(60.0, 0.2).trim_end(), ", 4 min left");
        assert_eq!(left(100.0, 0.02).trim_end(), ", 82 min left");
        assert_eq!(left(1000.0, 0.02).trim_end(), ", 13.6 h left");
        assert_eq!(left(5.0, 0.0), "");
    }
}
