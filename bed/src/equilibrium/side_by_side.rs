//! Runs a function for every tile or case in parallel; results keep their order.

use std::sync::atomic::{AtomicUsize, Ordering};

/// Number of processors of this machine.
#[must_use]
pub fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// Runs a function for `0..count` on all processors, with at least four tiles per thread, since fewer do not pay for
/// one.
pub fn run<T: Send>(count: usize, one: impl Fn(usize) -> T + Sync) -> Vec<T> {
    run_by(count, cores().min(count.div_ceil(4)), one)
}

/// Runs a function for `0..count` on at most `workers` threads; results do not depend on their number.
pub fn run_by<T: Send>(count: usize, workers: usize, one: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let workers = workers.clamp(1, 256).min(count);
    if workers < 2 {
        return (0..count).map(one).collect();
    }
    let next = AtomicUsize::new(0);
    let work = || {
        let mut done = Vec::new();
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            if index >= count {
                return done;
            }
            done.push((index, one(index)));
        }
    };
    let mut all: Vec<(usize, T)> = std::thread::scope(|scope| {
        let others: Vec<_> = (1..workers).map(|_| scope.spawn(work)).collect();
        let mut all = work();
        for other in others {
            match other.join() {
                Ok(done) => all.extend(done),
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
        all
    });
    all.sort_unstable_by_key(|(index, _)| *index);
    all.into_iter().map(|(_, found)| found).collect()
}
