//! Kinetic and stored energies of a body (thesis Eqs. 4.5 to 4.9).
//!
//! In: positions and velocities. Out: energies (J). Gravity is 0 at the origin.

use super::body::Body;
use super::element::Element;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// The parts of the total energy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Energies<S> {
    /// m v^2/2, Eq. 4.6.
    pub kinetic: S,
    /// m g h, Eq. 4.8.
    pub gravity: S,
    /// K s^2/2, Eq. 4.9, and the energy stored in a soft ground.
    pub spring: S,
    /// Potential of the gas.
    pub pressure: S,
}

impl<S: Scalar> Energies<S> {
    /// Their sum.
    #[must_use]
    pub fn total(&self) -> S {
        self.kinetic + self.gravity + self.spring + self.pressure
    }
}

/// Energies of a state.
#[must_use]
pub fn eval_energies<S: Scalar>(body: &Body<S>, pos: &[Vec3<S>], vel: &[Vec3<S>]) -> Energies<S> {
    let half = S::from_f64(0.5);
    let (mut kinetic, mut gravity) = (S::ZERO, S::ZERO);
    for ((m, x), v) in body.mass.iter().zip(pos).zip(vel) {
        kinetic = kinetic + half * *m * vec3::dot(*v, *v);
        gravity = gravity - *m * vec3::dot(body.gravity, *x);
    }
    let elements = body.elements();
    let pressure = elements.filled.map_or(S::ZERO, |filled| filled.energy(pos));
    Energies { kinetic, gravity, spring: elements.springs.energy(pos), pressure }
}
