//! Runs a plan, as a sequence of equilibria, each starting from the one before, or as a motion.
//!
//! In: a plan that [`super::check`] accepts. Out: a [`History`].

use super::check::Refusal;
use super::history::{Decide, History, Recorder, RunError, Seen, seal};
use super::motion;
use super::start::{Laid, laid};
use super::{Clock, Move, Plan};
use crate::equilibrium::passed::passed;
use crate::equilibrium::{Bed, Solution, solve};

/// Shortest increment of time, as a share of the time between two equilibria, before a run is given up.
const SHORTEST: f64 = 1.0 / 64.0;

/// Runs a plan; `at` is given the share that is done and returns whether to go on.
///
/// # Errors
/// [`RunError`].
pub fn run(plan: &Plan, at: impl FnMut(f64) -> bool) -> Result<History, RunError> {
    run_by(plan, &mut |_| Ok(Vec::new()), at)
}

/// Runs a plan; after each equilibrium `decide` may add moves that begin then or later.
///
/// # Errors
/// [`RunError`].
pub fn run_by(
    plan: &Plan,
    decide: &mut dyn FnMut(&Seen<'_>) -> Result<Vec<Move>, Refusal>,
    at: impl FnMut(f64) -> bool,
) -> Result<History, RunError> {
    match plan.clock {
        Clock::QuasiStatic => equilibria(plan, decide, at),
        Clock::Dynamics(dynamics) => motion::run(plan, &dynamics, decide, at),
    }
}

/// Runs a plan as a sequence of equilibria.
fn equilibria(plan: &Plan, decide: Decide<'_>, mut at: impl FnMut(f64) -> bool) -> Result<History, RunError> {
    let times = plan.times();
    let mut told = plan.clone();
    let plan = &mut told;
    let mut bed = plan.bed(0.0).map_err(RunError::Sheet)?;
    let Laid { mut solution, parts } = laid(plan, &mut bed, &mut at)?;
    let mut history = Recorder::new(plan, &bed, &solution);
    history.take(plan, &bed, &solution, 0.0)?;
    history.decide(plan, true, decide)?;
    seal(plan, &mut bed, &solution.state);
    for pair in times.windows(2) {
        if !at(pair[0] / plan.seconds) {
            return Err(RunError::Stopped);
        }
        (bed, solution) = onwards(plan, bed, solution, pair[0], pair[1])?;
        history.take(plan, &bed, &solution, pair[1])?;
        history.decide(plan, true, decide)?;
    }
    Ok(History { parts, ..history.finish(plan)? })
}

/// The equilibrium at a later time: in one increment or, if that does not converge or lets a part of the load pass
/// through a sheet, in smaller ones.
fn onwards(
    plan: &Plan,
    bed: Bed,
    solution: Solution,
    from: f64,
    to: f64,
) -> Result<(Bed, Solution), RunError> {
    let (mut now, mut share) = (from, 1.0);
    let (mut bed, mut solution) = (bed, solution);
    while now < to {
        let next = (now + share * (to - from)).min(to);
        let mut ordered = plan.bed(next).map_err(RunError::Sheet)?;
        keep_sealed(plan, &bed, &mut ordered, now, next);
        match solve(&ordered, &plan.load.body, &solution.state) {
            Ok(found) if share > SHORTEST && passed(&ordered, &plan.load.body, &found.state).is_some() => {
                share *= 0.5;
            }
            Ok(found) => {
                seal(plan, &mut ordered, &found.state);
                (bed, solution, now) = (ordered, found, next);
            }
            Err(fault) if share <= SHORTEST => return Err(RunError::Fault(next, fault)),
            Err(_) => share *= 0.5,
        }
    }
    Ok((bed, solution))
}

/// Keeps the sealed gas of bladders with constant pressure orders.
fn keep_sealed(plan: &Plan, before: &Bed, bed: &mut Bed, from: f64, to: f64) {
    if !plan.layout.is_sealed {
        return;
    }
    for (index, (tile, old)) in bed.tiles.iter_mut().zip(&before.tiles).enumerate() {
        if plan.order(index, from).pressure == plan.order(index, to).pressure {
            tile.air = old.air;
        }
    }
}
