//! The equilibrium with which a plan begins: its load laid on its bladders, or fallen on them.

use super::history::{RunError, seal};
use super::{DROP, Dynamics, Laying, Plan, Start};
use crate::dynamics::{Motion, dropped};
use crate::equilibrium::passed::passed;
use crate::equilibrium::{Bed, Fault, Solution, State, lay_on, put_down, solve};

/// Parts in which a load is laid on, one after the other, if it passes through a sheet when it is put down at once.
const MORE_PARTS: [usize; 2] = [8, 32];

/// The equilibrium with which a plan begins.
pub(super) struct Laid {
    pub solution: Solution,
    /// Number of parts in which the load was laid on after all, although the plan puts it down at once.
    pub parts: Option<usize>,
}

/// Lays the load down as the plan says; `at` is called in between and returns whether to go on. A load that falls finds
/// the valves of sealed bladders shut.
pub(super) fn laid(plan: &Plan, bed: &mut Bed, at: impl FnMut(f64) -> bool) -> Result<Laid, RunError> {
    let (body, start) = (&plan.load.body, bed.start(plan.load.poses.clone()));
    let fault = |fault| RunError::Fault(0.0, fault);
    let solution = match plan.laying {
        Laying::AtOnce => return at_once(plan, bed, &start).map_err(fault),
        Laying::InParts(parts) => lay_on(bed, body, &start, parts).map_err(fault),
        Laying::Fallen(dynamics, seconds) => fallen(plan, bed, &dynamics, seconds, at),
    };
    Ok(Laid { solution: solution?, parts: None })
}

/// Puts the load down at once or, if a part of it passes through a sheet or no equilibrium is found, in parts, until
/// there is one through which none passes.
fn at_once(plan: &Plan, bed: &Bed, start: &State) -> Result<Laid, Fault> {
    let body = &plan.load.body;
    let has_passed = |found: &Solution| passed(bed, body, &found.state).is_some();
    let down = match put_down(bed, body, start) {
        Ok(down) if !has_passed(&down) => return Ok(Laid { solution: down, parts: None }),
        Err(fault) if !matches!(fault, Fault::NotFound(..)) => return Err(fault),
        other => other.map(|solution| Laid { solution, parts: None }),
    };
    let again = |parts: usize| {
        let found = lay_on(bed, body, start, parts).ok().filter(|found| !has_passed(found))?;
        Some(Laid { solution: found, parts: Some(parts) })
    };
    // If all pass through, the run ends with the name of the part.
    MORE_PARTS.into_iter().find_map(again).map_or(down, Ok)
}

/// Lets the load fall and settle, with tiles as at the start; then finds the equilibrium. Valves of sealed bladders are
/// shut before, as those of a run in motion.
fn fallen(
    plan: &Plan,
    bed: &mut Bed,
    dynamics: &Dynamics,
    seconds: f64,
    mut at: impl FnMut(f64) -> bool,
) -> Result<Solution, RunError> {
    let (body, fault) = (&plan.load.body, |fault| RunError::Fault(0.0, fault));
    let Dynamics { step, method, start, matter, impact, .. } = *dynamics;
    let height = if let Start::Dropped(height) = start { height } else { DROP };
    let state = dropped(bed, body, &plan.load.poses, height).map_err(fault)?;
    seal(plan, bed, &state);
    let bed: &Bed = bed;
    let motion = Motion::new(bed.clone(), body.clone(), state, matter, method, step);
    let mut motion = motion.touching(impact);
    while motion.time() < seconds - 1e-9 {
        if !at(0.0) {
            return Err(RunError::Stopped);
        }
        motion.step(|_| bed.clone()).map_err(fault)?;
    }
    solve(bed, body, &motion.now.state).map_err(fault)
}
