//! The equilibrium with which a plan begins: its load laid on its bladders, or fallen on them.

use super::history::RunError;
use super::{DROP, Dynamics, Laying, Plan, Start};
use crate::dynamics::{Motion, dropped};
use crate::equilibrium::{Bed, Solution, lay_on, put_down, solve};

/// Lays the load down as the plan says; `at` is called in between and returns whether to go on.
pub(super) fn laid(plan: &Plan, bed: &Bed, at: impl FnMut(f64) -> bool) -> Result<Solution, RunError> {
    let (body, start) = (&plan.load.body, || bed.start(plan.load.poses.clone()));
    let fault = |fault| RunError::Fault(0.0, fault);
    match plan.laying {
        Laying::AtOnce => put_down(bed, body, &start()).map_err(fault),
        Laying::InParts(parts) => lay_on(bed, body, &start(), parts).map_err(fault),
        Laying::Fallen(dynamics, seconds) => fallen(plan, bed, &dynamics, seconds, at),
    }
}

/// Lets the load fall and settle, with tiles and pressures as at the start; then finds the equilibrium.
fn fallen(
    plan: &Plan,
    bed: &Bed,
    dynamics: &Dynamics,
    seconds: f64,
    mut at: impl FnMut(f64) -> bool,
) -> Result<Solution, RunError> {
    let (body, fault) = (&plan.load.body, |fault| RunError::Fault(0.0, fault));
    let Dynamics { step, method, start, matter, impact, .. } = *dynamics;
    let height = if let Start::Dropped(height) = start { height } else { DROP };
    let state = dropped(bed, body, &plan.load.poses, height).map_err(fault)?;
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
