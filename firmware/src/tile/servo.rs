//! Position and speed loops of the legs, with feedforward.
//!
//! In: wanted motion of each leg, its height, its load (`super::dynamics`). Out: duties of the drives. The speed
//! demanded of a leg is v = v_wanted + `KP` e + integral of `KI` e. The duty for it follows from the drive's equations
//! (`super::drive`): back-EMF at v, friction in screw and worm under the load, the motor's inertia. The integral
//! corrects for the rest: the actual friction, a load off centre.

use super::drive::{DRIVE, Drive};
use super::motion::sign;
use super::profile::{Along, TICK};
use super::sense::Sense;
use smartbed_runtime::real::Real;

/// Speed per error of height (1/s).
const KP: f32 = 40.0;
/// Speed per integral of the error (1/s^2).
const KI: f32 = 400.0;
/// Most that the integral may add to the speed (m/s).
const MOST_INTEGRAL: f32 = 1.5e-3;
/// Most that error and integral together may add (m/s).
const MOST_CORRECTION: f32 = 2e-3;

/// Integrals of the three loops (m/s).
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Servo {
    integral: [f32; 3],
}

impl Servo {
    /// Duties of this tick; `ways` are the displacements of the legs in the whole motion (m).
    pub fn duties(
        &mut self,
        sense: &Sense,
        wanted: &[Along; 3],
        ways: &[f32; 3],
        loads: &[f32; 3],
    ) -> [f32; 3] {
        let drive = Drive { supply: sense.measured.supply, ..DRIVE };
        let mut duties = [0.0; 3];
        let legs = duties.iter_mut().zip(&mut self.integral).zip(wanted).zip(ways);
        for ((((duty, integral), wanted), way), (height, load)) in legs.zip(sense.heights.iter().zip(loads)) {
            let error = wanted.position - height;
            *integral = clamp(*integral + KI * TICK * error, MOST_INTEGRAL);
            let speed = wanted.speed + clamp(KP * error + *integral, MOST_CORRECTION);
            let sign = sign(*way);
            let carried = if sign == 0.0 { 0.0 } else { drive.torque(*load, sign > 0.0) };
            let torque = carried + drive.inertia * drive.gear() * wanted.acceleration;
            *duty = clamp(drive.duty(torque, speed), 1.0);
        }
        duties
    }
}

fn clamp(x: f32, most: f32) -> f32 {
    Real::max(Real::min(x, most), -most)
}
