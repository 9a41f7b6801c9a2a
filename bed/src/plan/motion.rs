//! Runs a plan in motion: the load falls on the bed, settles, and tiles move under it.
//!
//! In: a plan and how motion is computed. Out: the same [`History`] as that of equilibria, and what happened between its
//! moments. Steps divide the time between two moments evenly.

use super::history::{Decide, History, Recorder, RunError, Watched, seal};
use super::start::laid;
use super::{Dynamics, Plan, Start};
use crate::dynamics::{Motion, dropped};
use crate::equilibrium::{Bed, GRAVITY};
use std::collections::VecDeque;

/// Time (s) over which a force is averaged before its peak is taken.
const WINDOW: f64 = 0.01;
/// Nothing is faster in a bed at rest (m/s).
const STILL: f64 = 1e-3;
/// Nothing is faster under a load that lies, beside what screws move (m/s).
const SLOW: f64 = 0.01;
/// A load lies where contacts carry its weight to this share.
const CARRIED: f64 = 0.05;

/// Runs it.
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
    let state = match dynamics.start {
        Start::Dropped(height) => dropped(&bed, &body, &plan.load.poses, height).map_err(fault(0.0))?,
        Start::AtRest => laid(plan, &bed, &mut at)?.state,
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
        for _ in 0..count as usize {
            if !at(motion.time() / plan.seconds) {
                return Err(RunError::Stopped);
            }
            let (before, now) = (motion.bed.clone(), motion.time());
            let volumes: Vec<f64> =
                motion.now.state.sheets.iter().map(|sheet| before.volume(sheet)).collect();
            motion.step(|time| ordered(plan, &before, &volumes, now, time)).map_err(fault(now))?;
            watch.see(&motion);
        }
        history.take(plan, &motion.bed, &motion.now, pair[1])?;
        history.decide(plan, lies(&motion), decide)?;
    }
    Ok(History { watched: Some(watch.watched), ..history.finish(plan)? })
}

/// Has the load come to lie: is its weight carried and everything slow?
fn lies(motion: &Motion) -> bool {
    let weight = motion.body.mass() * GRAVITY;
    (motion.now.carried - weight).abs() <= CARRIED * weight && motion.fastest() < SLOW
}

/// The bed as it is told to stand at a time. Bladders whose pressure nobody changes are shut, if the plan says so.
fn ordered(plan: &Plan, before: &Bed, volumes: &[f64], from: f64, to: f64) -> Bed {
    let mut bed = Bed { tiles: plan.tiles(to), ..before.clone() };
    for (index, (tile, old)) in bed.tiles.iter_mut().zip(&before.tiles).enumerate() {
        if plan.layout.is_sealed && plan.order(index, from).pressure == plan.order(index, to).pressure {
            tile.air = plan.layout.shut(old.air, volumes[index]);
        }
    }
    bed
}

/// Looks at every step.
struct Watch {
    forces: VecDeque<f64>,
    window: usize,
    watched: Watched,
}

impl Watch {
    fn new(step: f64) -> Watch {
        let window = ((WINDOW / step).round() as usize).max(1);
        Watch { forces: VecDeque::new(), window, watched: Watched { step, ..Watched::default() } }
    }

    fn see(&mut self, motion: &Motion) {
        let own = &mut self.watched;
        let pressed: f64 = motion.now.contacts.iter().flatten().map(|c| c.force()[2]).sum();
        let up = pressed + (motion.blows.upwards - own.blows.upwards) / own.step;
        self.forces.push_back(up);
        if self.forces.len() > self.window {
            self.forces.pop_front();
        }
        let mean = self.forces.iter().sum::<f64>() / self.forces.len() as f64;
        if mean > own.peak {
            (own.peak, own.peak_time) = (mean, motion.time());
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
