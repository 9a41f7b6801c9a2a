//! The equilibrium that a plan begins with: its load laid on its bladders.

use super::Plan;
use crate::equilibrium::{Bed, Fault, Solution, lay_on, put_down};

/// Puts the load down at once, or in the plan's parts.
pub(super) fn laid(plan: &Plan, bed: &Bed) -> Result<Solution, Fault> {
    let (body, start) = (&plan.load.body, bed.start(plan.load.poses.clone()));
    if plan.parts > 1 { lay_on(bed, body, &start, plan.parts) } else { put_down(bed, body, &start) }
}
