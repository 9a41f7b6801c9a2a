//! Computing time of this thread: what other programs do meanwhile does not count.

use std::time::Duration;

/// A time of computing that is not exceeded by much.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Deadline {
    end: Duration,
    limit: Duration,
}

impl Deadline {
    /// From now on.
    #[must_use]
    pub fn within(limit: Duration) -> Self {
        Self { end: now() + limit, limit }
    }

    /// [`Stop::Late`] at simulated time `t` (s), if it is over.
    ///
    /// # Errors
    /// That.
    pub fn check(&self, t: f64) -> Result<(), Stop> {
        if now() > self.end { Err(Stop::Late { reached: t, limit: self.limit }) } else { Ok(()) }
    }
}

/// Why a run ended early.
#[derive(Clone, PartialEq, Debug)]
pub enum Stop {
    /// It took too long.
    Late {
        /// Simulated time that it came to (s).
        reached: f64,
        /// The computing time that it had.
        limit: Duration,
    },
    /// A step was refused, in words.
    Refused(String),
}

impl From<String> for Stop {
    fn from(text: String) -> Self {
        Self::Refused(text)
    }
}

impl std::fmt::Display for Stop {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Late { reached, limit } => {
                write!(f, "it came to t = {reached:.3e} s in {:.1} s of computing", limit.as_secs_f64())
            }
            Self::Refused(text) => f.write_str(text),
        }
    }
}

/// Time that the processor has spent on this thread.
#[cfg(unix)]
#[must_use]
pub fn now() -> Duration {
    use rustix::time::{ClockId, clock_gettime};
    let time = clock_gettime(ClockId::ThreadCPUTime);
    let seconds = u64::try_from(time.tv_sec).unwrap_or(0);
    Duration::new(seconds, u32::try_from(time.tv_nsec).unwrap_or(0))
}

/// Time since the first call: there is nothing better here.
#[cfg(not(unix))]
#[must_use]
pub fn now() -> Duration {
    static START: std::sync::OnceLock<std::time::Instant> = std::sync::OnceLock::new();
    START.get_or_init(std::time::Instant::now).elapsed()
}
