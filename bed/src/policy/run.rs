//! Runs a plan under a policy.
//!
//! In: a plan, a policy with its bounds, a supervisor for its orders, and the sensing surface. Out: the run, or the
//! first limit that is exceeded.

use super::bounds::{Bounds, Reach};
use super::{Policy, Supervisor, View};
use crate::plan::check::check_from;
use crate::plan::history::{History, RunError, Seen};
use crate::plan::{Move, Order, Plan, run as plan_run};
use crate::sensor::reader::Reader;

/// Runs a plan under a policy. `supervisor` checks its orders; `reader` is the surface through which it sees (without
/// one it sees the truth); `at` is given the share that is done and returns whether to go on.
///
/// # Errors
/// [`RunError`]; [`RunError::Refused`] for a policy that exceeds a limit.
pub fn run(
    plan: &Plan,
    policy: &mut dyn Policy,
    bounds: &Bounds,
    supervisor: Option<&dyn Supervisor>,
    reader: Option<&Reader>,
    at: impl FnMut(f64) -> bool,
) -> Result<History, RunError> {
    let (mut reach, mut number) = (Reach::default(), 0);
    let mut decide = |seen: &Seen<'_>| {
        let frame = reader.map_or_else(|| seen.frame.clone(), |reader| reader.frame(number, seen.frame));
        number += 1;
        reach.widen(&seen.plan.layout, seen.grid, &frame.pressure);
        let areas = reach.areas(&seen.plan.layout, seen.grid);
        let weight = plan.load.body.mass() * crate::equilibrium::GRAVITY;
        let orders: Vec<Order> =
            (0..plan.layout.count()).map(|tile| seen.plan.order(tile, seen.frame.time)).collect();
        let judge = |moves: &[Move]| {
            let told = seen.plan.with(moves);
            if !moves.is_empty() {
                check_from(&told, seen.frame.time)?;
                supervisor.map_or(Ok(()), |own| own.check(&told, seen.frame.time))?;
            }
            bounds.check(&told, seen.frame.time, &areas, weight)
        };
        let view = View {
            time: seen.frame.time,
            layout: &seen.plan.layout,
            grid: seen.grid,
            sites: seen.sites,
            frame: &frame,
            orders: &orders,
            reach: &areas,
            weight,
            allows: &|moves| judge(moves).is_ok(),
        };
        let moves = policy.decide(&view);
        judge(&moves)?;
        Ok(moves)
    };
    plan_run::run_by(plan, &mut decide, at)
}
