//! Detects an obstacle in a leg's way from the work of its motor.
//!
//! In: current, displacement and speed of a leg at each tick, and its load by the model. Out: whether there is an
//! obstacle. Over a displacement dx the motor does the work k G (integral of i dx) = f L dx + J G^2 (u_1^2 - u_0^2) /
//! 2, with f the factor of the screw's statics (`super::drive`) and u the speed. So each tenth of a millimetre gives a
//! current level f L / (k G), independent of speed and of how many motions it takes. Levels of one direction are
//! compared with one another: an obstacle pushes more with the displacement; a patient who turns over changes the load
//! at rest.

use super::design::{CURRENT_RISE, FALL_DOWN, LEAST_LOAD, LOAD_MARGIN, RELEASE, RISE_DOWN, SHORT_WAY};
use super::drive::DRIVE;
use smartbed_runtime::real::Real;

/// Displacement that gives one level (m).
const WINDOW: f32 = 1e-4;
/// Change not carried over from one motion to the next (A), so that noise does not add up.
const UNTOLD: f32 = 3e-4;
/// Rise from level to level (A) while an obstacle is still releasing a leg that goes back: that of 17 N/mm.
const LETS_GO: f32 = 2e-3;
/// Share of the obstruction limit from which a leg may be leaning on an obstacle, which releases it when the leg
/// reverses.
const LEANS: f32 = 0.2;

/// Data of a leg in one tick.
#[derive(Clone, Copy)]
pub struct Step {
    /// Current of the motor (A), positive if it pushes up.
    pub current: f32,
    /// Displacement since the last tick (m) and speed (m/s).
    pub way: f32,
    /// See `way`.
    pub speed: f32,
    /// Wanted speed (m/s), whose sign is the direction of the motion.
    pub wanted: f32,
    /// Load under the heaviest patient (N).
    pub load: f32,
    /// Whether the whole motion is long enough to be judged by itself.
    pub is_long: bool,
    /// Whether the leg goes back from an obstacle.
    pub retreats: bool,
}

/// A leg's levels, up and down.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Efforts {
    up: Effort,
    down: Effort,
    is_up: bool,
    retreats: bool,
    /// Speed at the last tick (m/s).
    speed: f32,
}

/// Levels of one direction.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
struct Effort {
    /// Integrals since the last level: of i dx less the part for the drive's inertia (A m), and of dx (m).
    work: f32,
    way: f32,
    /// First level (A), and the load (N) then.
    learnt: Option<(f32, f32)>,
    /// Least and greatest level (A).
    least: f32,
    most: f32,
    last: f32,
    /// Rise over the least level and fall from the greatest that the load does not explain (A).
    rise: f32,
    fall: f32,
    /// The larger of the two, relative to the limit for an obstruction.
    excess: f32,
    /// Displacement in this motion, and displacement back since the leg was farthest (m).
    gone: f32,
    back: f32,
    /// Whether the next level is the first of a long motion.
    begins: bool,
    /// Whether the obstacle that the leg goes back from has released it.
    is_free: bool,
}

impl Efforts {
    /// Call when a motion has ended.
    pub fn rest(&mut self) {
        (self.up.gone, self.down.gone) = (0.0, 0.0);
    }

    /// Takes a tick; returns whether there is an obstacle.
    // Not inlined: one copy for three legs.
    #[inline(never)]
    pub fn take(&mut self, step: &Step) -> bool {
        if step.retreats != self.retreats {
            *self = Self { retreats: step.retreats, ..Self::default() };
        }
        if step.wanted != 0.0 {
            self.is_up = step.wanted > 0.0;
        }
        let (sign, before) = (if self.is_up { 1.0 } else { -1.0 }, self.speed);
        self.speed = step.speed;
        let way = step.way * sign;
        if way <= 0.0 {
            return false;
        }
        let inertia = DRIVE.inertia * DRIVE.gear() / DRIVE.constant;
        let inertial = inertia * (step.speed * step.speed - before * before) / 2.0;
        let work = step.current * step.way - inertial;
        let (one, other) =
            if self.is_up { (&mut self.up, &mut self.down) } else { (&mut self.down, &mut self.up) };
        other.go_back(way);
        let leaned = step.retreats || other.excess >= LEANS;
        match one.go_on(step, way, work) {
            Some(level) => one.judge(level, step.load, self.is_up, leaned),
            None => false,
        }
    }

    /// The last level of a rising leg (A), if it has gone far enough to have one.
    #[must_use]
    pub fn raising(&self) -> Option<f32> {
        (self.up.gone >= SHORT_WAY).then_some(self.up.last)
    }
}

impl Effort {
    /// Takes a displacement back; a leg that has gone far enough is free of whatever it leaned on.
    fn go_back(&mut self, way: f32) {
        self.back += way;
        if self.learnt.is_none() || self.back >= RELEASE {
            *self = Self::default();
        }
    }

    /// Takes a displacement forward and its work; returns the level if this completes one.
    fn go_on(&mut self, step: &Step, way: f32, work: f32) -> Option<f32> {
        if self.gone == 0.0 && step.is_long {
            let kept = 1.0 - self.back / RELEASE;
            self.rise = Real::max(self.rise - UNTOLD, 0.0) * kept;
            self.fall = Real::max(self.fall - UNTOLD, 0.0) * kept;
            (self.work, self.way, self.back) = (0.0, 0.0, 0.0);
            (self.begins, self.is_free) = (true, false);
        }
        self.gone += way;
        if self.back > 0.0 {
            // Where the leg has been before there is no obstacle.
            self.back -= way;
            return None;
        }
        self.way += way;
        self.work += work;
        if self.way < WINDOW {
            return None;
        }
        let level = self.work / self.way;
        (self.work, self.way) = (0.0, 0.0);
        Some(level)
    }

    /// Compares a level with earlier ones; returns whether it shows an obstacle. For any friction and patient the
    /// current is proportional to the load: a change up to that which the model predicts from the learnt level is no
    /// obstacle. The heaviest patient is assumed, because it changes most, and an empty bladder does not show who lies
    /// on it. In a falling leg an obstacle carries the load, so the motor pushes less. An obstacle that a leg `leaned`
    /// on before it reversed releases it: more to raise, less to push down.
    fn judge(&mut self, level: f32, load: f32, is_up: bool, leaned: bool) -> bool {
        let lets_go = leaned && is_up && !self.is_free && level > self.last + LETS_GO;
        self.is_free |= self.gone >= RELEASE || (self.learnt.is_some() && !self.begins && !lets_go);
        let (learnt, then) = match self.learnt {
            Some(learnt) if !(self.begins || lets_go) => learnt,
            // A change at rest is the patient's; an obstacle that the leg leaned on before is still there.
            _ => {
                (self.least, self.most) = (level - self.rise, level + self.fall);
                *self.learnt.insert((level, load))
            }
        };
        (self.last, self.begins) = (level, false);
        (self.least, self.most) = (Real::min(self.least, level), Real::max(self.most, level));
        if leaned && !is_up {
            self.most = level;
        }
        let change = if then > LEAST_LOAD { LOAD_MARGIN * learnt * (load - then) / then } else { 0.0 };
        self.rise = level - self.least - Real::max(change, 0.0);
        self.fall = self.most - level + Real::min(change, 0.0);
        let share = |(share, least): (f32, f32), of: f32| Real::max(share * of, least);
        self.excess = match is_up {
            true => self.rise / CURRENT_RISE,
            false => {
                Real::max(self.rise / share(RISE_DOWN, self.least), self.fall / share(FALL_DOWN, self.most))
            }
        };
        // NaN counts as an obstacle.
        let is_free = |excess: f32| excess < 1.0;
        !is_free(self.excess)
    }
}
