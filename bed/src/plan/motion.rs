//! Runs a plan as a motion: the load falls on the bed, settles, and tiles move under it.
//!
//! In: a plan and settings of the motion. Out: the same [`History`] as for equilibria, with extremes between its
//! moments. Steps divide the time between two moments evenly.

use super::history::{Decide, History, Recorder, RunError, Watched, seal};
use super::start::{Laid, laid};
use super::{Dynamics, Plan, Start};
use crate::dynamics::{Motion, dropped};
use crate::equilibrium::{Bed, GRAVITY};
use std::collections::VecDeque;

/// Interval (s) over which a force is averaged before its peak is taken.
const WINDOW: f64 = 0.01;
/// Largest speed in a bed at rest (m/s).
const STILL: f64 = 1e-3;
/// Largest speed (m/s) under a load that counts as lying.
const SLOW: f64 = 0.01;
/// Moves that begin or end within this share of a step from one another, or from a moment, count as simultaneous.
const SHORTEST: f64 = 1e-3;
/// A load counts as lying if contacts carry its weight to this share.
const CARRIED: f64 = 0.05;

/// Runs a plan as a motion.
pub(super) fn run(
    plan: &Plan,
    dynamics: &Dynamics,
    decide: Decide<'_>,
    mut at: impl FnMut(f64) -> bool,
) -> Result<History, RunError> {
    let times = plan.times();
    let mut told = plan.clone();
    let plan = &mut told;
    let mut bed = plan.bed(0.0).map_err(RunError::Sheet)?;
    let body = plan.load.body.clone();
    let fault = |time: f64| move |fault| RunError::Fault(time, fault);
    let (state, parts) = match dynamics.start {
        Start::Dropped(height) => (dropped(&bed, &body, &plan.load.poses, height).map_err(fault(0.0))?, None),
        Start::AtRest => {
            let Laid { solution, parts } = laid(plan, &mut bed, &mut at)?;
            (solution.state, parts)
        }
    };
    seal(plan, &mut bed, &state);
    let count = (plan.every / dynamics.step - 1e-9).ceil().max(1.0);
    let step = plan.every / count;
    let motion = Motion::new(bed, body, state, dynamics.matter, dynamics.method, step);
    let motion = motion.touching(dynamics.impact);
    let mut motion = if dynamics.is_f32 { motion.in_f32() } else { motion };
    let mut history = Recorder::new(plan, &motion.bed, &motion.now);
    history.take(plan, &motion.bed, &motion.now, 0.0)?;
    history.decide(plan, lies(&motion), decide)?;
    let mut watch = Watch::new(step);
    for pair in times.windows(2) {
        for (seconds, jumps) in steps(plan, [pair[0], pair[1]], step) {
            if !at(motion.time() / plan.seconds) {
                return Err(RunError::Stopped);
            }
            if jumps {
                motion.jump();
            }
            let (before, now) = (motion.bed.clone(), motion.time());
            let volumes: Vec<f64> =
                motion.now.state.sheets.iter().map(|sheet| before.volume(sheet)).collect();
            motion
                .step_of(seconds, |time| ordered(plan, &before, &volumes, now, time))
                .map_err(fault(now))?;
            watch.see(&motion, seconds);
        }
        history.take(plan, &motion.bed, &motion.now, pair[1])?;
        history.decide(plan, lies(&motion), decide)?;
    }
    Ok(History { watched: Some(watch.watched), parts, ..history.finish(plan)? })
}

/// Lengths (s) of the steps from one moment to the next, each with whether a move begins or ends at its start. Steps
/// are equal unless a move begins or ends in between.
fn steps(plan: &Plan, [from, to]: [f64; 2], longest: f64) -> Vec<(f64, bool)> {
    let near = SHORTEST * longest;
    let mut ends: Vec<f64> = plan.moves.iter().flat_map(|told| [told.at, told.at + told.over]).collect();
    ends.sort_by(f64::total_cmp);
    let jumps_at = |time: f64| ends.iter().any(|end| (end - time).abs() <= near);
    let mut stops = vec![from];
    for end in ends.iter().copied().filter(|end| *end < to - near) {
        if stops.last().is_some_and(|last| end > last + near) {
            stops.push(end);
        }
    }
    stops.push(to);
    let part = |pair: &[f64]| {
        let count = ((pair[1] - pair[0]) / longest - 1e-9).ceil().max(1.0);
        // Without a move that begins or ends in between, steps have the common length.
        let step = if stops.len() == 2 { longest } else { (pair[1] - pair[0]) / count };
        let jumps = jumps_at(pair[0]);
        (0..count as usize).map(move |k| (step, jumps && k == 0)).collect::<Vec<_>>()
    };
    stops.windows(2).flat_map(part).collect()
}

/// Is the load lying: is its weight carried, and everything slow?
fn lies(motion: &Motion) -> bool {
    let weight = motion.body.mass() * GRAVITY;
    (motion.now.carried - weight).abs() <= CARRIED * weight && motion.fastest() < SLOW
}

/// The bed as commanded at a time. Bladders with constant pressure orders are sealed if the plan says so.
fn ordered(plan: &Plan, before: &Bed, volumes: &[f64], from: f64, to: f64) -> Bed {
    let mut bed = Bed { tiles: plan.tiles(to), ..before.clone() };
    for (index, (tile, old)) in bed.tiles.iter_mut().zip(&before.tiles).enumerate() {
        if plan.layout.is_sealed && plan.order(index, from).pressure == plan.order(index, to).pressure {
            tile.air = plan.layout.shut(old.air, volumes[index]);
        }
    }
    bed
}

/// Observes every step.
struct Watch {
    /// Forces (N) of the last steps, with their lengths (s).
    forces: VecDeque<[f64; 2]>,
    watched: Watched,
}

impl Watch {
    fn new(step: f64) -> Watch {
        Watch { forces: VecDeque::new(), watched: Watched { step, ..Watched::default() } }
    }

    fn see(&mut self, motion: &Motion, seconds: f64) {
        let own = &mut self.watched;
        let pressed: f64 = motion.now.contacts.iter().flatten().map(|c| c.force()[2]).sum();
        let up = pressed + (motion.blows.upwards - own.blows.upwards) / seconds;
        self.forces.push_back([up, seconds]);
        let mut length: f64 = self.forces.iter().map(|own| own[1]).sum();
        // The last step stays, however long it is: its force is a mean over the step.
        while let Some([_, first]) = self.forces.front().filter(|_| self.forces.len() > 1)
            && length - first > WINDOW - 0.5 * first
        {
            length -= first;
            self.forces.pop_front();
        }
        let mean = self.forces.iter().map(|[force, seconds]| force * seconds).sum::<f64>() / length;
        if mean > own.peak {
            (own.peak, own.peak_time, own.peak_window) = (mean, motion.time(), length);
        }
        for (tile, gauge) in motion.now.gauges.iter().enumerate() {
            if *gauge > own.pressed {
                (own.pressed, own.pressed_tile, own.pressed_time) = (*gauge, tile, motion.time());
            }
        }
        own.still = if motion.fastest() >= STILL { None } else { own.still.or(Some(motion.time())) };
        own.left_over = own.left_over.max(motion.ledger.left_over().abs());
        own.kinetic = own.kinetic.max(motion.ledger.kinetic);
        own.lost = motion.ledger.lost();
        own.blows = motion.blows;
        own.turned = motion.ledger.turned;
        own.steps += 1;
        own.newton += motion.now.steps;
    }
}
