//! One leg's drive in numbers: motor, worm and trapezoidal screw.
//!
//! In: geometry, friction, motor constants. Out: motor force at the screw per load, raising and
//! lowering; whether the load can turn the motor; the duty for a speed and a load.
//! Symbols as in `models/tile_drive.toml`; formulas of any text on power screws: with lead angle
//! lambda and friction angle rho, raising takes tan(lambda + rho), lowering tan(lambda - rho).

use smartbed_runtime::real::Real;

/// Parameters of a drive. SI units.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Drive<R> {
    /// Turns of the motor per turn of the screw (1).
    pub ratio: R,
    /// Rise of the screw per turn (m).
    pub lead: R,
    /// Pitch diameter of the screw (m).
    pub diameter: R,
    /// Tangent of the worm's lead angle (1).
    pub worm_slope: R,
    /// Friction in the thread (1).
    pub screw_friction: R,
    /// Friction in the worm (1).
    pub worm_friction: R,
    /// Moment of inertia at the motor (kg m^2).
    pub inertia: R,
    /// Torque constant, equal to the voltage constant (N m/A = V s).
    pub constant: R,
    /// Resistance of the motor (ohm).
    pub resistance: R,
    /// Supply (V).
    pub supply: R,
}

/// The cosine of half the angle of a trapezoidal thread, 15 degrees.
const FLANK_COS: f64 = 0.965_925_826_289_068_3;
const TAU: f64 = core::f64::consts::TAU;

/// Tr16x4, worm 30:1 of one start at 4.5 degrees, 24 V motor: see `docs/controller.md`.
pub const DRIVE: Drive<f32> = Drive {
    ratio: 30.0,
    lead: 0.004,
    diameter: 0.014,
    worm_slope: 0.078_701_7,
    screw_friction: 0.15,
    worm_friction: 0.08,
    inertia: 2e-6,
    constant: 0.07,
    resistance: 6.0,
    supply: 24.0,
};

/// Below this speed of the screw (m/s) the current does not show the thrust.
pub const SLOWEST: f32 = 2e-4;
/// Range of friction in the thread over wear, grease and temperature.
pub const SCREW_FRICTION: (f32, f32) = (0.10, 0.20);
/// Range of friction in the worm.
pub const WORM_FRICTION: (f32, f32) = (0.06, 0.10);

impl<R: Real + PartialOrd> Drive<R> {
    /// Angle of the motor per height (rad/m).
    #[must_use]
    pub fn gear(&self) -> R {
        R::from_f64(TAU) * self.ratio / self.lead
    }

    /// Tangent of the screw's lead angle.
    fn screw_slope(&self) -> R {
        self.lead / (R::from_f64(core::f64::consts::PI) * self.diameter)
    }

    /// Motor force at the screw per load that is raised (1): 1/(efficiency of screw x efficiency of worm).
    #[must_use]
    pub fn raise(&self) -> R {
        let screw = self.screw_slope();
        let friction = self.screw_friction / R::from_f64(FLANK_COS);
        tan_sum(screw, friction) / screw * (tan_sum(self.worm_slope, self.worm_friction) / self.worm_slope)
    }

    /// Motor force at the screw per load that is lowered (1). Negative if the motor must drive the load down: the drive
    /// then holds its load without the motor.
    #[must_use]
    pub fn hold(&self) -> R {
        let screw = self.screw_slope();
        let friction = self.screw_friction / R::from_f64(FLANK_COS);
        let back = tan_sum(screw, -friction) / screw;
        let worm = self.worm_slope;
        if back < R::ZERO {
            return back * (tan_sum(worm, self.worm_friction) / worm);
        }
        back * (tan_sum(worm, -self.worm_friction) / worm)
    }

    /// Margin against being turned by the load (1): positive if the drive is self-locking.
    #[must_use]
    pub fn locking_margin(&self) -> R {
        -self.hold()
    }

    /// Torque of the motor (N m) that moves this load (N) up or down at constant speed.
    #[must_use]
    pub fn torque(&self, load: R, is_up: bool) -> R {
        let factor = if is_up { self.raise() } else { self.hold() };
        load * factor / self.gear()
    }

    /// Duty (-1 to 1) that gives this torque (N m) at this speed of the screw (m/s).
    #[must_use]
    pub fn duty(&self, torque: R, speed: R) -> R {
        (self.resistance * torque / self.constant + self.constant * self.gear() * speed) / self.supply
    }

    /// Current (A) at this duty and speed of the screw (m/s).
    #[must_use]
    pub fn current(&self, duty: R, speed: R) -> R {
        (self.supply * duty - self.constant * self.gear() * speed) / self.resistance
    }
}

impl Drive<f32> {
    /// The same drive with the least, or the most, friction of the range.
    #[must_use]
    pub fn with_friction(self, is_least: bool) -> Self {
        let pick = |(least, most): (f32, f32)| if is_least { least } else { most };
        Self { screw_friction: pick(SCREW_FRICTION), worm_friction: pick(WORM_FRICTION), ..self }
    }

    /// Range of thrust (N) that this current (A) shows while the screw moves, over the range of friction;
    /// None at rest, where a self-locking screw shows nothing.
    #[must_use]
    pub fn thrust(self, current: f32, speed: f32) -> Option<(f32, f32)> {
        if Real::abs(speed) < SLOWEST {
            return None;
        }
        let torque = current * self.constant;
        let load = |drive: Self| {
            let factor = if speed > 0.0 { drive.raise() } else { drive.hold() };
            torque * drive.gear() / factor
        };
        let (a, b) = (load(self.with_friction(true)), load(self.with_friction(false)));
        Some((Real::min(a, b), Real::max(a, b)))
    }
}

/// tan(a + b) from the tangents of a and b.
fn tan_sum<R: Real>(a: R, b: R) -> R {
    (a + b) / (R::ONE - a * b)
}

#[cfg(test)]
mod tests {
    use super::{DRIVE, Drive};

    fn screw(lead: f32, diameter: f32, mu: f32) -> Drive<f32> {
        Drive { lead, diameter, screw_friction: mu, worm_friction: 0.0, ..DRIVE }
    }

    #[test]
    fn efficiencies_are_the_tabled_ones() {
        // Raising efficiency of the screw alone: Tr10x2, Tr12x3, Tr16x4, Tr16x8 from tables, three digits.
        let cases = [
            (0.002, 0.009, 0.10, 0.403),
            (0.003, 0.0105, 0.15, 0.364),
            (0.004, 0.014, 0.20, 0.299),
            (0.008, 0.014, 0.10, 0.625),
        ];
        for (lead, diameter, mu, efficiency) in cases {
            let eta = 1.0 / screw(lead, diameter, mu).raise();
            assert!((eta - efficiency).abs() < 7e-4, "{lead} {mu}: {eta}");
        }
    }

    #[test]
    fn what_locks_itself_is_known() {
        // Lead angle 5.2 degrees against a friction angle of 5.91: locks. Two starts: does not, nor at 0.15.
        assert!(screw(0.004, 0.014, 0.10).locking_margin() > 0.0);
        assert!(screw(0.008, 0.014, 0.15).locking_margin() < 0.0);
        assert!(DRIVE.with_friction(true).locking_margin() > 0.0, "ours locks at the lowest friction");
    }

    #[test]
    fn duty_and_current_are_inverse() {
        let duty = DRIVE.duty(0.02, 0.003);
        assert!((DRIVE.current(duty, 0.003) * DRIVE.constant - 0.02).abs() < 1e-6);
        let no_load = 1.0 / DRIVE.duty(0.0, 1.0);
        assert!((6e-3..8e-3).contains(&no_load), "full duty without load: {no_load} m/s");
    }

    #[test]
    fn thrust_is_known_in_motion_only_and_with_its_uncertainty() {
        // Going down the screw is near to being turned by its load, so the current says little: the interval is wide.
        for (speed, load, widest) in [(0.002, 200.0, 2.0), (-0.002, 150.0, 20.0)] {
            let current = DRIVE.torque(load, speed > 0.0) / DRIVE.constant;
            let (least, most) = DRIVE.thrust(current, speed).expect("it moves");
            assert!(least < load && load < most && most < widest * least, "{least} {most}");
        }
        assert_eq!(DRIVE.thrust(0.3, 0.0), None);
    }
}
