//! The stage that a derivation is in, for a progress display. Nothing that is derived depends on it.

use std::sync::atomic::{AtomicUsize, Ordering};

/// The stages in their order.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Stage {
    Kinematics,
    Constraints,
    Dynamics,
    Answers,
    Values,
    Sums,
}

/// The stages in words.
const NAMES: [&str; 6] = [
    "positions and velocities",
    "constraints",
    "equations of motion",
    "answers",
    "fewer operations",
    "order of sums",
];

/// The stage begun last, by any derivation in this process.
static LAST: AtomicUsize = AtomicUsize::new(0);

/// Begins a stage.
pub(crate) fn begin(stage: Stage) {
    LAST.store(stage as usize, Ordering::Relaxed);
}

/// The stage that was begun last, in words.
#[must_use]
pub fn current() -> &'static str {
    NAMES[LAST.load(Ordering::Relaxed)]
}
