//! What is wrong with the tile in this tick, as its sensors show it.
//!
//! In: what was read and computed, what the legs are to do. Out: conditions, each of which has lasted long enough.
//! Every sensor is checked against its range, against another sensor and against what is commanded; a value that is
//! no number fails every check, because each is written as what must hold.

use super::board::{RAILS, Readings};
use super::design::{
    CREEP, CURRENT, CURRENT_OFF, CURRENT_RISE, DISAGREEMENT, FALL_DOWN, FASTEST, FOLLOWING, GRAVITY,
    LEAST_LOAD, LOAD_MARGIN, MOST_WEIGHT, OVERPRESSURE, PRESSURE_DISAGREEMENT, RISE_DOWN, RUNAWAY_SPEED,
    SLOPE_FAULT, SLOPE_RATE_FAULT, SUPPLY, SWITCH, SWITCH_PLAY,
};
use super::drive::{DRIVE, SLOWEST};
use super::fault::{Fault, Faults};
use super::motion::{Heights, pose};
use super::profile::Along;
use super::sense::Sense;
use smartbed_runtime::real::Real;

/// A leg's current is learnt for so long, from its start and from when it moves quickly enough (ticks).
const LEARN: (u16, u16) = (300, 60);
/// Share of a new reading in the smoothed current.
const CURRENT_SHARE: f32 = 0.125;
/// Rise of the current on a way down that is not carried on to the next one (A).
const UNTOLD: f32 = 4e-3;

/// What the legs are doing.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Doing {
    /// Drives are off and the legs stay at these heights.
    Rest(Heights),
    /// Drives are on and the legs follow this; `sign` is the direction of each.
    Follow {
        /// What is wanted of each leg.
        wanted: [Along; 3],
        /// 1 up, -1 down, 0 if the leg stays.
        sign: [f32; 3],
        /// Are the lower switches looked for?
        seeks: bool,
        /// Do the legs go back from an obstacle?
        retreats: bool,
        /// What the screws carry under the heaviest patient (N).
        loads: [f32; 3],
    },
}

/// How long conditions have lasted, and what the currents were.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Watch {
    ages: [u8; Fault::ALL.len()],
    push: [Push; 3],
    off: u16,
}

/// What a leg's motor took so far in this motion.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
struct Push {
    smooth: f32,
    /// Current and modelled load when it was learnt.
    learnt: (f32, f32),
    least: f32,
    most: f32,
    /// Ticks in which the leg went its way: one that sticks winds up its current until it breaks away.
    ticks: u16,
    /// Ticks in a row in which the leg is to move quickly enough.
    quick: u16,
    sign: f32,
    /// Rise of the current that no load explains (A): of this motion and those before it that way, and of those before.
    pressed: f32,
    before: f32,
}

/// How a leg goes.
#[derive(Clone, Copy)]
struct Pace {
    /// Is it to go quickly enough for its current to be a measure?
    is_quick: bool,
    /// Does it go as it is to go?
    moves: bool,
    /// Does it go back from an obstacle?
    retreats: bool,
}

impl Watch {
    /// Takes a tick; returns what has lasted long enough.
    pub fn take(&mut self, readings: &Readings, sense: &Sense, doing: &Doing) -> Faults {
        let mut raw = Faults::default();
        position(&mut raw, readings, sense, doing);
        electric(&mut raw, readings, sense);
        pneumatic(&mut raw, readings, sense);
        match doing {
            Doing::Rest(at) => self.rest(&mut raw, sense, at),
            Doing::Follow { .. } => self.follow(&mut raw, sense, doing),
        }
        self.last(raw)
    }

    /// What of this has lasted long enough.
    fn last(&mut self, raw: Faults) -> Faults {
        let mut faults = Faults::default();
        for (fault, age) in Fault::ALL.into_iter().zip(&mut self.ages) {
            *age = if raw.has(fault) { age.saturating_add(1) } else { 0 };
            faults.set(fault, *age >= patience(fault));
        }
        faults
    }

    /// Drives are off: nothing moves and no current flows.
    fn rest(&mut self, raw: &mut Faults, sense: &Sense, at: &Heights) {
        self.push = self.push.map(Push::rested);
        self.off = self.off.saturating_add(1);
        raw.set(Fault::Runaway, !near(sense.heights, *at, CREEP));
        let flows = !sense.measured.current.iter().all(|i| Real::abs(*i) < CURRENT_OFF);
        raw.set(Fault::Current, raw.has(Fault::Current) || (self.off > 20 && flows));
    }

    /// Drives are on: legs are where they should be, as fast as they should, and push no more than so far.
    fn follow(&mut self, raw: &mut Faults, sense: &Sense, doing: &Doing) {
        let Doing::Follow { wanted, sign, retreats, loads, .. } = doing else { return };
        self.off = 0;
        let legs = wanted.iter().zip(sign).zip(sense.heights.iter().zip(&sense.speeds));
        let legs = legs.zip(sense.measured.current.iter().zip(&mut self.push).zip(loads));
        for (((wanted, sign), (height, speed)), ((current, push), load)) in legs {
            let behind = wanted.position - height;
            let lags = Real::abs(behind) < FOLLOWING;
            // Behind and still going its way, or stopped: something is in the way. Anything else goes where it likes.
            let blocked = behind * sign > 0.0 && speed * sign > -RUNAWAY_SPEED / 4.0;
            let is_fast = !below(Real::abs(speed - wanted.speed), RUNAWAY_SPEED);
            raw.set(Fault::Obstruction, raw.has(Fault::Obstruction) || (!lags && blocked));
            raw.set(Fault::Runaway, raw.has(Fault::Runaway) || (!lags && !blocked) || is_fast);
            let inertial = wanted.acceleration * DRIVE.inertia * DRIVE.gear() / DRIVE.constant;
            let pace = Pace {
                is_quick: Real::abs(wanted.speed) > SLOWEST,
                moves: speed * sign >= wanted.speed * sign / 2.0,
                retreats: *retreats,
            };
            let pushes = push.take((current - inertial) * sign, *load, *sign, pace);
            raw.set(Fault::Obstruction, raw.has(Fault::Obstruction) || pushes);
        }
        raw.set(Fault::Overload, self.weight(sense) > MOST_WEIGHT);
    }

    /// The least weight (N) that the currents show, if all legs move; 0 else.
    fn weight(&self, sense: &Sense) -> f32 {
        let mut weight = 0.0;
        for (push, speed) in self.push.iter().zip(sense.speeds) {
            match DRIVE.thrust(push.smooth * Real::sign(speed), speed) {
                Some((least, _)) if push.ticks > LEARN.0 && speed > 0.0 => weight += least,
                _ => return 0.0,
            }
        }
        weight
    }
}

impl Push {
    /// After a motion. What a leg leaned on and did not take for an obstacle is still there: the next way in that direction begins
    /// with it, else many short ones would push harder and harder. A way back lets go.
    fn rested(self) -> Self {
        Self { sign: self.sign, pressed: self.pressed, before: self.pressed, ..Self::default() }
    }

    /// Takes the current that pushes a leg its way (A) and the load that it carries under the heaviest patient (N); does it push
    /// more than the motion took so far? Whatever friction and patient are, the current goes with the load: as much more, or
    /// less, as the model makes of the current that was learnt is no obstacle. The heaviest patient changes it most; an empty
    /// bladder does not say who lies on it.
    /// Going down it is also an obstacle if the motor has less to push: the obstacle carries the load. On the way back from one
    /// it is the obstacle that lets go. A screw that hardly turns sticks and slips, so what it takes then is no measure.
    fn take(&mut self, current: f32, load: f32, sign: f32, pace: Pace) -> bool {
        let Pace { is_quick, moves, retreats } = pace;
        if sign != self.sign {
            *self = Self { sign, ..Self::default() };
        }
        self.smooth += CURRENT_SHARE * (current - self.smooth);
        self.ticks = self.ticks.saturating_add(u16::from(moves));
        self.quick = if is_quick { self.quick.saturating_add(1) } else { 0 };
        // A leg that has just become quick shows what it takes to become so.
        let is_known = self.quick > LEARN.1;
        if is_known {
            self.least = Real::min(self.least, self.smooth);
            self.most = Real::max(self.most, self.smooth);
        } else if is_quick || self.ticks <= LEARN.0 {
            (self.least, self.most) = (Real::max(self.least, self.smooth), self.smooth);
            self.learnt = (self.smooth, load);
        }
        let (learnt, then) = self.learnt;
        let change = if then > LEAST_LOAD { LOAD_MARGIN * learnt * (load - then) / then } else { 0.0 };
        let (more, less) = (Real::max(change, 0.0), Real::max(-change, 0.0));
        let (rise, fall) = (self.smooth - self.least - more, self.most - self.smooth - less);
        let rise = rise + self.before;
        if moves && self.ticks > LEARN.0 && (sign > 0.0 || is_known) {
            // Going down a motor that is hardly loaded tells less: a little is lost on every way.
            self.pressed = Real::max(rise - if sign < 0.0 { UNTOLD } else { 0.0 }, 0.0);
        }
        let share = |(share, least): (f32, f32), of: f32| Real::max(share * of, least);
        match () {
            () if sign == 0.0 => false,
            () if sign < 0.0 && is_known => {
                let is_carried = !retreats && !below(fall, share(FALL_DOWN, self.most));
                !below(rise, share(RISE_DOWN, self.least)) || is_carried
            }
            () => self.ticks > LEARN.0 && !below(rise, CURRENT_RISE),
        }
    }
}

/// Encoders, displacement sensors and switches against one another.
fn position(raw: &mut Faults, readings: &Readings, sense: &Sense, doing: &Doing) {
    let is_slow = sense.raw_speeds.iter().all(|v| Real::abs(*v) < FASTEST);
    raw.set(Fault::Height, !(near(sense.heights, sense.displaced, DISAGREEMENT) && is_slow));
    raw.set(Fault::DisplacementRange, !readings.displacement.iter().all(is_off_rails));
    let slope = sense.pose();
    let by_sensor = pose(sense.displaced);
    let is_flat = [slope, by_sensor].iter().all(|s| s.tx * s.tx + s.ty * s.ty < SLOPE_FAULT * SLOPE_FAULT);
    let [x, y] = sense.slope_rate;
    raw.set(Fault::Tilt, !(is_flat && x * x + y * y < SLOPE_RATE_FAULT * SLOPE_RATE_FAULT));

    let legs = readings.low_closed.iter().zip(readings.high_closed).zip(sense.displaced);
    for (leg, ((low_closed, high_closed), height)) in legs.enumerate() {
        let is_right = |is_pressed: bool, inside: f32| {
            (!is_pressed || inside < SWITCH_PLAY) && (is_pressed || inside > -SWITCH_PLAY)
        };
        let places = is_right(!low_closed, height + SWITCH) && is_right(!high_closed, SWITCH - height);
        raw.set(Fault::SwitchPlace, raw.has(Fault::SwitchPlace) || !places);
        if let Doing::Follow { sign, seeks, .. } = doing {
            let sign = sign.get(leg).copied().unwrap_or(0.0);
            let runs_into = (!low_closed && sign < 0.0 && !seeks) || (!high_closed && sign > 0.0);
            raw.set(Fault::Switch, raw.has(Fault::Switch) || runs_into);
        }
    }
}

fn electric(raw: &mut Faults, readings: &Readings, sense: &Sense) {
    let (least, most) = SUPPLY;
    raw.set(Fault::Supply, !(least < sense.measured.supply && sense.measured.supply < most));
    raw.set(Fault::Current, !sense.measured.current.iter().all(|i| Real::abs(*i) < CURRENT));
    raw.set(Fault::Drive, readings.drive_fault.contains(&true));
    raw.set(Fault::Overrun, readings.overrun);
}

fn pneumatic(raw: &mut Faults, readings: &Readings, sense: &Sense) {
    let [a, b] = sense.measured.pressure;
    let (offset, share) = PRESSURE_DISAGREEMENT;
    raw.set(Fault::PressureRange, !readings.pressure.iter().all(is_off_rails));
    raw.set(
        Fault::Pressure,
        !below(Real::abs(a - b), offset + share * Real::max(Real::abs(a), Real::abs(b))),
    );
    raw.set(Fault::Overpressure, !(a < OVERPRESSURE && b < OVERPRESSURE));
}

/// What the bladder carries at most (kg): the pressure over its whole area.
#[must_use]
pub fn load(pressure: f32) -> f32 {
    Real::max(pressure, 0.0) * super::design::AREA / GRAVITY
}

/// Ticks that a condition lasts before it is a fault.
fn patience(fault: Fault) -> u8 {
    match fault {
        Fault::Height | Fault::DisplacementRange | Fault::PressureRange => 5,
        Fault::Current | Fault::Overpressure => 3,
        // A leg that turns round at once needs some ticks to take its new speed.
        Fault::SwitchPlace | Fault::Supply | Fault::Tilt | Fault::Runaway => 12,
        Fault::Pressure => 50,
        Fault::Overload => 100,
        _ => 1,
    }
}

fn is_off_rails(count: &u16) -> bool {
    let (low, high) = RAILS;
    (low..=high).contains(count)
}

/// Is it a number, and less?
fn below(x: f32, limit: f32) -> bool {
    x < limit
}

fn near(a: Heights, b: Heights, distance: f32) -> bool {
    a.iter().zip(b).all(|(a, b)| Real::abs(a - b) < distance)
}
