//! Ctrl-C: a run ends behind a whole step, with whole rows, and says where; a second one ends the program at once.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};

static ASKED: OnceLock<Arc<AtomicBool>> = OnceLock::new();

/// From here on Ctrl-C is a question that [`is_asked`] answers.
pub fn watch() {
    let asked = ASKED.get_or_init(Arc::default);
    #[cfg(unix)]
    for signal in [signal_hook::consts::SIGINT, signal_hook::consts::SIGTERM] {
        // Where the system refuses, a run ends as any program does.
        let _ = signal_hook::flag::register_conditional_shutdown(signal, 1, asked.clone());
        let _ = signal_hook::flag::register(signal, asked.clone());
    }
}

/// Has somebody asked to end the run?
#[must_use]
pub fn is_asked() -> bool {
    ASKED.get().is_some_and(|asked| asked.load(Ordering::Relaxed))
}
