//! Detects what is wrong with the tile in this tick from its sensors.
//!
//! In: readings, estimates, and what the legs should do. Out: faults, each of which has lasted long enough.
//! Every sensor is checked against its range, another sensor and the command. A NaN
//! fails every check, because each is written as the condition that must hold.

use super::board::{RAILS, Readings};
use super::design::{
    CREEP, CURRENT, CURRENT_OFF, DISAGREEMENT, FASTEST, FOLLOWING, GRAVITY, MOST_WEIGHT, OVERPRESSURE,
    PRESSURE_DISAGREEMENT, RUNAWAY_SPEED, SHORT_WAY, SLOPE_FAULT, SLOPE_RATE_FAULT, SUPPLY, SWITCH,
    SWITCH_PLAY,
};
use super::drive::DRIVE;
use super::effort::{Efforts, Step};
use super::fault::{Fault, Faults};
use super::motion::{Heights, pose, sign};
use super::profile::{Along, TICK};
use super::sense::Sense;
use smartbed_runtime::real::Real;

/// What the legs should do.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Doing {
    /// Drives are off and the legs stay at these heights.
    Rest(Heights),
    /// Drives are on and the legs follow a motion.
    Follow {
        /// Wanted motion of each leg.
        wanted: [Along; 3],
        /// Displacement of each leg, positive up (m).
        ways: [f32; 3],
        /// Whether the lower switches are being searched.
        seeks: bool,
        /// Whether the legs go back from an obstacle.
        retreats: bool,
        /// Forces of the screws under the heaviest patient (N).
        loads: [f32; 3],
    },
}

/// How long conditions have lasted, and the efforts of the motors.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Watch {
    ages: [u8; Fault::ALL.len()],
    efforts: [Efforts; 3],
    off: u16,
}

impl Watch {
    /// Takes a tick; returns the conditions that have lasted long enough.
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

    /// The conditions that have lasted long enough to be faults.
    fn last(&mut self, raw: Faults) -> Faults {
        let mut faults = Faults::default();
        for (fault, age) in Fault::ALL.into_iter().zip(&mut self.ages) {
            *age = if raw.has(fault) { age.saturating_add(1) } else { 0 };
            faults.set(fault, *age >= patience(fault));
        }
        faults
    }

    /// With drives off, nothing may move and no current may flow.
    fn rest(&mut self, raw: &mut Faults, sense: &Sense, at: &Heights) {
        self.efforts.iter_mut().for_each(Efforts::rest);
        self.off = self.off.saturating_add(1);
        raw.set(Fault::Runaway, !near(sense.heights, *at, CREEP));
        let flows = !sense.measured.current.iter().all(|i| Real::abs(*i) < CURRENT_OFF);
        raw.set(Fault::Current, raw.has(Fault::Current) || (self.off > 20 && flows));
    }

    /// With drives on, legs must be near their wanted positions and speeds, and must not push too hard.
    fn follow(&mut self, raw: &mut Faults, sense: &Sense, doing: &Doing) {
        let Doing::Follow { wanted, ways, retreats, loads, .. } = doing else { return };
        self.off = 0;
        for (leg, efforts) in self.efforts.iter_mut().enumerate() {
            let (wanted, sign, speed) = (&wanted[leg], sign(ways[leg]), sense.speeds[leg]);
            let behind = wanted.position - sense.heights[leg];
            let lags = Real::abs(behind) < FOLLOWING;
            // Behind, and still moving forward or stopped: an obstacle. Any other deviation is a runaway.
            let blocked = behind * sign > 0.0 && speed * sign > -RUNAWAY_SPEED / 4.0;
            let is_fast = !below(Real::abs(speed - wanted.speed), RUNAWAY_SPEED);
            raw.set(Fault::Runaway, raw.has(Fault::Runaway) || (!lags && !blocked) || is_fast);
            let pushes = efforts.take(&Step {
                current: sense.measured.current[leg],
                way: sense.raw_speeds[leg] * TICK,
                speed,
                wanted: wanted.speed,
                load: loads[leg],
                is_long: Real::abs(ways[leg]) >= SHORT_WAY,
                retreats: *retreats,
            });
            raw.set(Fault::Obstruction, raw.has(Fault::Obstruction) || (!lags && blocked) || pushes);
        }
        raw.set(Fault::Overload, self.weight(sense) > MOST_WEIGHT);
    }

    /// The least weight (N) that the currents show, if all legs rise; else 0.
    fn weight(&self, sense: &Sense) -> f32 {
        let mut weight = 0.0;
        for (efforts, speed) in self.efforts.iter().zip(sense.speeds) {
            match efforts.raising().and_then(|level| DRIVE.thrust(level, speed)) {
                Some((least, _)) if speed > 0.0 => weight += least,
                _ => return 0.0,
            }
        }
        weight
    }
}

/// Checks encoders, displacement sensors and switches against one another.
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
        if let Doing::Follow { ways, seeks, .. } = doing {
            let sign = sign(ways.get(leg).copied().unwrap_or(0.0));
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

/// Largest mass that the bladder can carry (kg): the pressure on its whole area.
#[must_use]
pub fn load(pressure: f32) -> f32 {
    Real::max(pressure, 0.0) * super::design::AREA / GRAVITY
}

/// Number of ticks that a condition must last to be a fault.
fn patience(fault: Fault) -> u8 {
    match fault {
        Fault::Height | Fault::DisplacementRange | Fault::PressureRange => 5,
        Fault::Current | Fault::Overpressure => 3,
        // A leg that reverses abruptly needs some ticks to reach its new speed.
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

/// Whether x is less than the limit; false for NaN.
fn below(x: f32, limit: f32) -> bool {
    x < limit
}

fn near(a: Heights, b: Heights, distance: f32) -> bool {
    a.iter().zip(b).all(|(a, b)| Real::abs(a - b) < distance)
}
