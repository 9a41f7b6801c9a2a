//! The bladder's pressure loop: two valves, each open or shut.
//!
//! In: measured and commanded pressure over ambient (Pa). Out: which valve is open, and faults where the pressure does
//! not follow the valves. Hysteresis: a valve opens at an error of 40 Pa and shuts at 10 Pa, so both are shut most of
//! the time. Without a command both stay shut: the bladder keeps its air.

use super::design::PRESSURE;
use super::fault::{Fault, Faults};
use crate::link::message::Refusal;

/// A valve opens at an error of this size (Pa), and shuts when the error is below [`SHUT`].
const OPEN: f32 = 40.0;
/// See [`OPEN`].
const SHUT: f32 = 10.0;
/// Length of an observation window for the pressure (ticks).
const LOOK: u32 = 500;
/// A pressure that changes the same way by this much (Pa) in each of [`LOOKS`] windows with shut valves shows a valve
/// that is open.
const LEAK: f32 = 60.0;
/// See [`LEAK`].
const LOOKS: i8 = 4;
/// A valve open for this long (ticks) ...
const PATIENCE: u32 = 2000;
/// ... must have changed the pressure by this much (Pa).
const EFFECT: f32 = 50.0;

/// Checks a commanded pressure (Pa).
///
/// # Errors
/// [`Refusal::Pressure`].
pub fn commanded(pressure: f32) -> Result<f32, Refusal> {
    if (0.0..=PRESSURE).contains(&pressure) { Ok(pressure) } else { Err(Refusal::Pressure) }
}

/// Which valves are open.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Valves {
    /// Neither.
    #[default]
    Shut,
    /// The valve from the pump.
    Supply,
    /// The vent.
    Vent,
}

/// State of the loop.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Bladder {
    valves: Valves,
    since: u32,
    /// Pressure when the valves last changed, or when the last window began (Pa).
    began: f32,
    /// Consecutive windows in which the pressure rose (positive) or fell, or consecutive openings soon after the valves
    /// were shut.
    drift: i8,
    is_still: bool,
}

impl Bladder {
    /// Valves to open now, by hysteresis; pressures in Pa.
    pub fn regulate(&mut self, wanted: Option<f32>, pressure: f32) -> Valves {
        let next = match (wanted, self.valves) {
            (None, _) => Valves::Shut,
            (Some(wanted), Valves::Supply) if pressure < wanted - SHUT => Valves::Supply,
            (Some(wanted), Valves::Vent) if pressure > wanted + SHUT => Valves::Vent,
            (Some(wanted), _) if pressure < wanted - OPEN => Valves::Supply,
            (Some(wanted), _) if pressure > wanted + OPEN => Valves::Vent,
            _ => Valves::Shut,
        };
        self.switch(next, pressure);
        next
    }

    /// Opens the vent, or shuts both valves, regardless of the command.
    pub fn force(&mut self, valves: Valves, pressure: f32) -> Valves {
        self.switch(valves, pressure);
        valves
    }

    fn switch(&mut self, next: Valves, pressure: f32) {
        if next == self.valves {
            return;
        }
        // The same valve opens again soon after it was shut, repeatedly: the other valve is open, or this one leaks.
        let soon = self.valves == Valves::Shut && self.since < LOOK && self.is_still;
        let drift = match next {
            Valves::Shut => self.drift,
            Valves::Vent if soon => self.drift.max(0) + 1,
            Valves::Supply if soon => self.drift.min(0) - 1,
            Valves::Vent | Valves::Supply => 0,
        };
        let drift = drift.clamp(-LOOKS, LOOKS);
        *self = Self { valves: next, began: pressure, since: 0, drift, is_still: self.is_still };
    }

    /// Takes the pressure of this tick; returns the faults that it shows. `is_still`: the tile does not move; motion
    /// changes the pressure too.
    pub fn watch(&mut self, pressure: f32, is_still: bool) -> Faults {
        let mut faults = Faults::default();
        self.since = self.since.saturating_add(1);
        self.is_still = is_still;
        let change = pressure - self.began;
        match self.valves {
            Valves::Shut if self.since >= LOOK => {
                self.drift = match self.drift {
                    up if change > LEAK && is_still => up.max(0) + 1,
                    down if change < -LEAK && is_still => down.min(0) - 1,
                    _ => 0,
                };
                faults.set(Fault::ValveOpen, self.drift.abs() >= LOOKS);
                self.drift = self.drift.clamp(-LOOKS, LOOKS);
                (self.since, self.began) = (0, pressure);
            }
            Valves::Shut => faults.set(Fault::ValveOpen, self.drift.abs() >= LOOKS),
            // An empty bladder cannot fall any further.
            Valves::Vent if pressure < LEAK => self.restart(pressure),
            Valves::Supply | Valves::Vent if self.since >= PATIENCE => {
                let effect = if self.valves == Valves::Supply { change } else { -change };
                faults.set(Fault::ValveShut, effect < EFFECT);
                self.restart(pressure);
            }
            Valves::Supply | Valves::Vent => (),
        }
        faults
    }

    fn restart(&mut self, pressure: f32) {
        (self.since, self.began) = (0, pressure);
    }
}

#[cfg(test)]
mod tests {
    use super::{Bladder, Valves};
    use crate::tile::fault::{Fault, Faults};

    /// All faults of so many seconds in which the pressure rises at this rate (Pa/s) while this is wanted.
    fn faults(seconds: u32, rate: f32, wanted: Option<f32>) -> Faults {
        let mut bladder = Bladder::default();
        (0..seconds * 1000).fold(Faults::default(), |faults, tick| {
            let pressure = 3000.0 + rate * 1e-3 * tick as f32;
            bladder.regulate(wanted, pressure);
            faults.with(bladder.watch(pressure, true))
        })
    }

    #[test]
    fn a_valve_that_does_not_do_as_told_is_seen() {
        assert!(faults(3, 200.0, None).has(Fault::ValveOpen), "it rises with shut valves");
        assert!(faults(3, -200.0, None).has(Fault::ValveOpen), "it falls with shut valves");
        assert!(faults(60, 0.0, None).is_empty() && faults(60, -5.0, None).is_empty(), "a leak of 5 Pa/s");
        assert!(faults(3, 0.0, Some(4000.0)).has(Fault::ValveShut), "it does not rise");
        assert!(faults(3, 0.0, Some(2000.0)).has(Fault::ValveShut), "it does not fall");
        assert!(faults(10, 500.0, Some(8000.0)).is_empty(), "it rises as it should");
    }

    #[test]
    fn a_valve_that_works_against_an_open_one_is_seen() {
        let (mut bladder, mut pressure, mut faults) = (Bladder::default(), 4000.0, Faults::default());
        for _ in 0..3000 {
            let valves = bladder.regulate(Some(4000.0), pressure);
            faults = faults.with(bladder.watch(pressure, true));
            // The supply stands open (0.3 kPa/s); the vent lets out far more.
            pressure += if valves == Valves::Vent { -10.0 } else { 0.3 };
        }
        assert!(faults.has(Fault::ValveOpen));
    }

    #[test]
    fn it_switches_with_hysteresis() {
        let mut bladder = Bladder::default();
        let steps = [
            (4030.0, Valves::Shut),
            (4041.0, Valves::Vent),
            (4011.0, Valves::Vent),
            (4009.0, Valves::Shut),
            (3961.0, Valves::Shut),
            (3959.0, Valves::Supply),
            (3989.0, Valves::Supply),
            (3991.0, Valves::Shut),
        ];
        for (pressure, valves) in steps {
            assert_eq!(bladder.regulate(Some(4000.0), pressure), valves, "{pressure}");
        }
        assert_eq!(bladder.regulate(None, 0.0), Valves::Shut);
    }
}
