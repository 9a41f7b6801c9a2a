//! One step of a body on the ground: try, shorten to the first touch or release, resolve it, continue.
//!
//! In: a system, a state, a step h, a method. Out: the state h later and a report. The observer sees
//! everything and changes nothing. Work per step is bounded, and time always advances by h: after its last split a step
//! ends by Moreau's law with e = 0 (`stepping`), and the report says so.
//! Invariant: on an error the state is the last good one.

mod attempt;
mod march;
mod modes;
mod moreau;
mod slide;
mod state;
mod step;
mod stepping;
mod touch;
mod watch;

pub use march::{Marching, Rows, can_march, march};
pub use state::State;
pub use step::{MAX_EVENTS, MAX_SUBSTEPS, step};
pub use watch::{Event, Flow, Observer, StepReport};
