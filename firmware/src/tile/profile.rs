//! Motion profile from rest to rest, with bounded speed, acceleration and jerk.
//!
//! In: length L and bounds. Out: position, speed and acceleration at each tick.
//! Speed rises in the time T by v(x) = V (3 x^2 - 2 x^3), x = t/T, stays at V, and falls the same way; so
//! acceleration is at most 3/2 V/T and jerk 6 V/T^2. A length below V T keeps T and has V = L/T.

use smartbed_runtime::real::Real;

/// Time in which the speed rises (ticks of 1 ms).
pub const RAMP: u32 = 500;
/// Length of a tick (s).
pub const TICK: f32 = 1e-3;
/// The ramp's time (s).
const RAMP_TIME: f32 = RAMP as f32 * TICK;
/// Longest motion (ticks): an hour.
const LONGEST: f32 = 3.6e6;

/// Position, speed and acceleration along a motion.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Along {
    /// Position, in the unit of the length.
    pub position: f32,
    /// Speed, per second.
    pub speed: f32,
    /// Acceleration, per second squared.
    pub acceleration: f32,
}

/// A motion from rest to rest.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Profile {
    length: f32,
    /// Highest speed.
    speed: f32,
    /// Ticks from the start of the motion to the start of its final ramp.
    cruise_end: u32,
}

impl Profile {
    /// A motion of this length (not negative) with at most this speed (positive).
    #[must_use]
    pub fn new(length: f32, most_speed: f32) -> Self {
        let shortest = most_speed * RAMP_TIME;
        if length <= shortest {
            return Self { length, speed: length / RAMP_TIME, cruise_end: RAMP };
        }
        // A whole number of ticks, rounded up; it determines the speed.
        let ticks = Real::min(length / most_speed / TICK, LONGEST) as u32 + 1;
        Self { length, speed: length / (ticks as f32 * TICK), cruise_end: ticks }
    }

    /// Length of the motion in ticks.
    #[must_use]
    pub fn ticks(&self) -> u32 {
        self.cruise_end + RAMP
    }

    /// Position, speed and acceleration this many ticks after the start.
    #[must_use]
    pub fn at(&self, tick: u32) -> Along {
        if tick >= self.ticks() {
            return Along { position: self.length, ..Along::default() };
        }
        if tick < RAMP {
            return self.rising(tick);
        }
        if tick <= self.cruise_end {
            let since = (tick - RAMP) as f32 * TICK;
            let position = self.speed * (RAMP_TIME / 2.0 + since);
            return Along { position, speed: self.speed, acceleration: 0.0 };
        }
        // The final ramp is the first one mirrored.
        let mirrored = self.rising(self.ticks() - tick);
        Along {
            position: self.length - mirrored.position,
            speed: mirrored.speed,
            acceleration: -mirrored.acceleration,
        }
    }

    fn rising(&self, tick: u32) -> Along {
        let x = tick as f32 / RAMP as f32;
        Along {
            position: self.speed * RAMP_TIME * x * x * x * (1.0 - 0.5 * x),
            speed: self.speed * x * x * (3.0 - 2.0 * x),
            acceleration: self.speed / RAMP_TIME * 6.0 * x * (1.0 - x),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Profile, RAMP, RAMP_TIME, TICK};
    use proptest::prelude::proptest;

    proptest! {
        #[test]
        fn bounds_hold_and_the_end_is_reached(length in 0.0_f32..10.0, most in 0.01_f32..2.0) {
            let profile = Profile::new(length, most);
            assert_eq!(profile.at(0).position, 0.0);
            assert_eq!(profile.at(profile.ticks()).position, length);
            let close = |a: f32, b: f32, unit: f32| (a - b).abs() <= 1e-5 * unit;
            let step = (profile.ticks() / 4096).max(1);
            for tick in (0..profile.ticks()).step_by(step as usize) {
                let (now, next) = (profile.at(tick), profile.at(tick + 1));
                assert!(now.speed <= most * (1.0 + 1e-6));
                assert!(now.acceleration.abs() <= 1.5 * most / RAMP_TIME * (1.0 + 1e-6));
                // Speed is the rate of position and acceleration that of speed: trapezoids differ by
                // their bounded jerk, here at most 6 V/T^2.
                let jerk = 6.0 * most / RAMP_TIME / RAMP_TIME;
                let by_speed = now.position + (now.speed + next.speed) / 2.0 * TICK;
                assert!(close(next.position, by_speed, length.max(1e-3)), "{tick}");
                assert!((next.acceleration - now.acceleration).abs() <= jerk * TICK * 1.01 + 1e-5);
            }
        }
    }

    #[test]
    fn a_turn_of_five_degrees_at_half_a_degree_a_second() {
        assert_eq!(Profile::new(5.0, 0.5).ticks(), 10_001 + RAMP);
        assert_eq!(Profile::new(0.0, 0.5).at(RAMP).speed, 0.0);
    }
}
