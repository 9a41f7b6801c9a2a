//! Computing time of this thread, which does not include that of other programs.

use crate::failure::Failure;
use std::time::Duration;

/// A limit on computing time.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Deadline {
    end: Duration,
    limit: Duration,
}

impl Deadline {
    /// Begins now.
    #[must_use]
    pub fn within(limit: Duration) -> Self {
        Self { end: now() + limit, limit }
    }

    /// Checks the limit at simulated time `t` (s).
    ///
    /// # Errors
    /// [`Stop::Late`] if it is exceeded.
    pub fn check(&self, t: f64) -> Result<(), Stop> {
        if now() > self.end { Err(Stop::Late { reached: t, limit: self.limit }) } else { Ok(()) }
    }
}

/// Reasons for which a run ended early.
#[derive(Clone, PartialEq, Debug)]
pub enum Stop {
    /// It exceeded its computing time.
    Late {
        /// Simulated time reached (s).
        reached: f64,
        /// The limit.
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

impl From<Failure> for Stop {
    fn from(failure: Failure) -> Self {
        Self::Refused(failure.into())
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

/// Processor time of this thread.
#[cfg(unix)]
#[must_use]
pub fn now() -> Duration {
    use rustix::time::{ClockId, clock_gettime};
    let time = clock_gettime(ClockId::ThreadCPUTime);
    let seconds = u64::try_from(time.tv_sec).unwrap_or(0);
    Duration::new(seconds, u32::try_from(time.tv_nsec).unwrap_or(0))
}

/// Wall-clock time since the first call: this system offers nothing better.
#[cfg(not(unix))]
#[must_use]
pub fn now() -> Duration {
    static START: std::sync::OnceLock<std::time::Instant> = std::sync::OnceLock::new();
    START.get_or_init(std::time::Instant::now).elapsed()
}
