//! Reads `[run]` and the clock: length and interval of a run, its clock, and how the load is laid on.

use super::{dynamics, load};
use crate::world::read::value::{Bound, count, number};
use smartbed_bed::plan::{Clock, Laying, Start};
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::Fields;
use smartbed_codegen::model::document::Table;
use smartbed_codegen::source::Span;

/// Most equilibria of a run.
const MOST_EQUILIBRIA: f64 = 100_000.0;
/// Most steps in which a weight is laid on.
const MOST_PARTS: usize = 100;

/// Length, intervals and clock of a run.
pub(super) struct Timing {
    pub seconds: f64,
    pub every: f64,
    pub cycle: f64,
    pub clock: Clock,
    pub laying: Laying,
    pub is_supervised: Option<bool>,
}

/// Reads `[run]` and `[dynamics]` of a plan; motion in f32 requires an empty bed.
pub(super) fn read(plan: &Fields<'_>, is_empty: bool, found: &mut Diagnostics) -> Option<Timing> {
    let empty = Table::default();
    let table = plan.table("run", found).unwrap_or(&empty);
    let fields = Fields::of("run", table.span, table);
    let seconds = number(&fields, "seconds", "s", Bound::NotNegative, found).unwrap_or(0.0);
    let every = number(&fields, "every", "s", Bound::Positive, found).unwrap_or(10.0);
    let cycle = number(&fields, "cycle", "s", Bound::Positive, found).unwrap_or(600.0);
    let parts = count(&fields, "parts", 1, found).unwrap_or(1);
    let fall = number(&fields, "fall", "s", Bound::Positive, found);
    let is_motion = load::named(&fields, "clock", &dynamics::CLOCKS, found);
    let is_supervised = fields.boolean("supervised", found);
    fields.finish(found);
    let wrong = wrong_times([seconds, every], parts, fall);
    if let Some((what, where_, help)) = wrong {
        return refuse(found, table.span, what, where_, &help);
    }
    let is_motion = is_motion?;
    let motion = plan.table("dynamics", found).unwrap_or(&empty);
    let in_motion = fall.unwrap_or(0.0) + if is_motion { seconds } else { 0.0 };
    let told = dynamics::read(motion, in_motion, fall.is_some(), found)?;
    if fall.is_some() && is_motion && told.dynamics.start != Start::AtRest {
        let (what, help) = (
            "`fall` has no effect on a motion in which the load is dropped".to_owned(),
            "leave `fall` out, or dynamics.start = \"at_rest\" after it",
        );
        return refuse(found, table.span, what, "of this run", help);
    }
    if told.dynamics.is_f32 && !is_empty {
        let (what, help) = (
            "`dynamics.scalar` f32 is for a bed without a load".to_owned(),
            "scalar = \"f64\", or neither [patient] nor [load]",
        );
        return refuse(found, motion.span, what, "of this motion", help);
    }
    let clock = if is_motion { Clock::Dynamics(told.dynamics) } else { Clock::QuasiStatic };
    let laying = match fall {
        Some(seconds) => Laying::Fallen(told.fall, seconds),
        None if parts > 1 => Laying::InParts(parts),
        None => Laying::AtOnce,
    };
    Some(Timing { seconds, every, cycle, clock, laying, is_supervised })
}

/// Reports invalid times and parts, with their places and what to do.
fn wrong_times(
    [seconds, every]: [f64; 2],
    parts: usize,
    fall: Option<f64>,
) -> Option<(String, &'static str, String)> {
    let of_run = "of this run";
    if parts > MOST_PARTS {
        let what = format!("`parts` is {parts}, expected 1 to {MOST_PARTS}");
        return Some((what, of_run, "parts = 8".to_owned()));
    }
    if fall.is_some() && parts > 1 {
        let what = "`fall` and `parts` are both given; expected one of them".to_owned();
        return Some((what, of_run, "leave one of the two out".to_owned()));
    }
    if seconds / every > MOST_EQUILIBRIA {
        let what = format!("more than {MOST_EQUILIBRIA} equilibria");
        return Some((what, of_run, "a longer `every`".to_owned()));
    }
    let count = (seconds / every).round();
    // Of the shorter one: a long `every` must not hide a whole run in the tolerance.
    if (seconds - count * every).abs() > 1e-6 * every.min(seconds) {
        let what = format!("`seconds` is {seconds} s, no multiple of `every`, {every} s");
        let help = format!("every = {}, or seconds = {}", seconds / count.max(1.0), count.max(1.0) * every);
        return Some((what, "of this run: its end would appear in no map", help));
    }
    None
}

fn refuse(found: &mut Diagnostics, span: Span, what: String, of: &str, help: &str) -> Option<Timing> {
    found.push(Diagnostic::error(what).label(span, of).help(help));
    None
}
