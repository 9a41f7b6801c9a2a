//! The error of a pick over the whole run, where the reference covers only its start.
//!
//! In: a subject, a method, the step that was picked at the start. Out: a step, and its error over all of the time. A
//! start says nothing of what follows, such as the first contact. So the run is made with this step, half of it and a
//! quarter (of an adaptive method: with smaller tolerances), and compared at all ends of steps; steps are halved until
//! the error is small enough or the time is used up. Two finer runs are asked, since two steps may agree by chance
//! where contacts decide.

use super::clock::{self, Stop};
use super::measure::{at_step_ends, finer, share};
use super::plan::Plan;
use super::point::Control;
use super::subject::{Method, Subject, Time, Trace, larger};
use crate::engine::ScalarKind;
use std::time::Duration;

/// Most runs.
const RUNS: usize = 24;

/// What is known of a run over all of its time.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Whole {
    /// Its step or tolerance.
    pub control: Control,
    /// Largest error of a coordinate (m or rad).
    pub error: f64,
    /// Time up to which the error is at most what was asked for (s).
    pub kept: f64,
    /// Computing time per simulated second (ns).
    pub nanoseconds: f64,
}

/// The first step, from `first` on, whose error over the whole run is at most the plan's `enough`; if there is none in
/// the plan's time, the most exact one. `None` if time allows no three runs.
#[must_use]
pub fn judge(
    subject: &dyn Subject,
    coordinates: usize,
    (method, first, scalar): (&Method, Control, ScalarKind),
    plan: &Plan,
) -> Option<Whole> {
    let seconds = subject.seconds();
    let mut control = first;
    let end = clock::now() + plan.whole;
    let mut runs: Vec<(Control, Trace)> = Vec::new();
    let mut best: Option<Whole> = None;
    for _ in 0..RUNS {
        let left = end.saturating_sub(clock::now());
        let expected = runs.last().map_or(Duration::ZERO, |(_, last)| last.elapsed * 2);
        if left <= expected {
            break;
        }
        if matches!(control, Control::Step(step) if subject.passes_over(step)) {
            // Finer runs would agree with it where they miss the same.
            runs.clear();
            control = finer(control, plan);
            continue;
        }
        let (how, time) = ((method.name.as_str(), control, scalar), Time::new(seconds, left));
        match at_step_ends(subject, coordinates, plan, how, time) {
            Ok(trace) => runs.push((control, trace)),
            // A finer step may go on where this one could not.
            Err(Stop::Refused(_)) => runs.clear(),
            Err(Stop::Late { .. }) => break,
        }
        if let [own, half, quarter] = &runs[..] {
            let found = compared(seconds, own, [&half.1, &quarter.1], (share(method, plan), plan.enough));
            if !best.is_some_and(|best| best.error <= found.error) {
                best = Some(found);
            }
            if found.error <= plan.enough {
                break;
            }
            runs.remove(0);
        }
        control = finer(control, plan);
    }
    best
}

/// A run's error by its differences from finer ones, enlarged by `share`.
fn compared(
    seconds: f64,
    (control, trace): &(Control, Trace),
    finer: [&Trace; 2],
    (share, enough): (f64, f64),
) -> Whole {
    let differences = finer.map(|other| share * trace.difference(other));
    let kept = finer.map(|other| trace.agreement(other, enough / share));
    Whole {
        control: *control,
        error: larger(differences[0], differences[1]),
        kept: seconds * kept[0].min(kept[1]),
        nanoseconds: trace.elapsed.as_nanos() as f64 / seconds,
    }
}
