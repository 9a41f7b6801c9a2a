//! Handles Ctrl-C: a run ends after a whole step, with whole rows, and reports where; a second Ctrl-C ends the program.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};

static ASKED: OnceLock<Arc<AtomicBool>> = OnceLock::new();

/// From now on Ctrl-C only sets a flag, which [`is_asked`] returns.
pub fn watch() {
    let asked = ASKED.get_or_init(Arc::default);
    #[cfg(unix)]
    for signal in [signal_hook::consts::SIGINT, signal_hook::consts::SIGTERM] {
        // If the system refuses the handler, Ctrl-C simply ends the program.
        let _ = signal_hook::flag::register_conditional_shutdown(signal, 1, asked.clone());
        let _ = signal_hook::flag::register(signal, asked.clone());
    }
}

/// Has the user asked to end the run?
#[must_use]
pub fn is_asked() -> bool {
    ASKED.get().is_some_and(|asked| asked.load(Ordering::Relaxed))
}
