//! One leg's drive over a step: motor, worm and screw with stiction and load-dependent friction.
//!
//! In: voltage, speed, load. Out: the speed after the step. At the screw, m u' = E - D u - f(u) L, with E the motor's
//! force at its voltage, D its electric damping, L the load and f the factor of the screw's statics (`tile::drive`):
//! `raise` against the load, `hold` with it. At u = 0 friction takes any value between the two, so a drive below that
//! limit does not move at all; if `hold` is negative, no load moves it. The step is implicit in D u and in the
//! direction of friction (Moreau's time stepping, one leg at a time).

use crate::tile::drive::Drive;
use smartbed_runtime::real::{Real, Scalar};

/// Inertia of the motor, as a mass at the screw (kg).
#[must_use]
pub fn reflected<S: Scalar>(drive: &Drive<S>) -> S {
    drive.inertia * drive.gear() * drive.gear()
}

/// Current (A) at this voltage and speed.
#[must_use]
pub fn current<S: Scalar>(drive: &Drive<S>, volts: S, speed: S) -> S {
    (volts - drive.constant * drive.gear() * speed) / drive.resistance
}

/// The speed after a step of length h; `volts` is None if the windings are open.
#[must_use]
pub fn speed_after<S: Scalar>(drive: &Drive<S>, volts: Option<S>, speed: S, load: S, h: S) -> S {
    let mass = reflected(drive);
    let force_per_volt = drive.constant * drive.gear() / drive.resistance;
    let damping = volts.map_or(S::ZERO, |_| drive.constant * drive.gear() * force_per_volt);
    let push = volts.map_or(S::ZERO, |volts| volts * force_per_volt);
    let (a, b) = (load * drive.raise(), load * drive.hold());
    let (against_up, against_down) = (Real::max(a, b), Real::min(a, b));
    let after = |friction: S| (speed + h / mass * (push - friction)) / (S::ONE + h / mass * damping);
    let (up, down) = (after(against_up), after(against_down));
    match () {
        () if up > S::ZERO => up,
        () if down < S::ZERO => down,
        () => S::ZERO,
    }
}

#[cfg(test)]
mod tests {
    use super::speed_after;
    use crate::tile::drive::DRIVE;

    /// Ten seconds from rest.
    fn settled(volts: f32, load: f32) -> f32 {
        (0..20_000).fold(0.0, |u, _| speed_after(&DRIVE, Some(volts), u, load, 5e-4))
    }

    #[test]
    fn a_steady_speed_is_that_of_the_statics() {
        for (speed, load) in [(2e-3, 100.0), (-2e-3, 100.0), (1e-3, 0.0)] {
            let duty = DRIVE.duty(DRIVE.torque(load, speed > 0.0), speed);
            let found = settled(24.0 * duty, load);
            assert!((found - speed).abs() < 1e-6, "{speed} {load}: {found}");
        }
    }

    #[test]
    fn what_does_not_overcome_friction_moves_nothing() {
        let least = DRIVE.torque(100.0, true) / DRIVE.constant * DRIVE.resistance;
        assert_eq!(settled(0.99 * least, 100.0), 0.0);
        assert!(settled(1.01 * least, 100.0) > 0.0);
        assert_eq!(settled(0.0, 1e5), 0.0, "it locks itself");
        assert_eq!(speed_after(&DRIVE, None, 0.0, 1e5, 5e-4), 0.0);
    }

    #[test]
    fn a_drive_that_does_not_lock_runs_down() {
        let two_starts = crate::tile::drive::Drive { lead: 0.008, worm_friction: 0.0, ..DRIVE };
        assert!(speed_after(&two_starts, None, 0.0, 100.0, 5e-4) < 0.0);
    }
}
