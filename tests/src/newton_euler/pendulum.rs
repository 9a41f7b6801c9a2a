//! A chain of n point masses on massless rods, pinned at the origin, in the plane z = 0.
//!
//! Angles are absolute, from the downward vertical (-y). Particles at the ends of rods: every rod
//! keeps its length, every particle its plane.

use super::body::{Body, Moving, Pose};
use super::jet::{Jet, JetVector};
use super::joint;
use super::system::{self, Linkage, Motion};
use nalgebra::Vector3;

/// The chain at one configuration.
pub struct Pendulum<'a> {
    /// Masses (kg).
    pub masses: &'a [f64],
    /// Rod lengths (m).
    pub lengths: &'a [f64],
    /// Gravity (m/s^2), along -y.
    pub g: f64,
    /// Absolute angles (rad).
    pub q: &'a [f64],
}

impl Pendulum<'_> {
    /// The oracle's answer for absolute angular speeds `u`.
    #[must_use]
    pub fn solve(&self, u: &[f64]) -> Motion {
        system::solve(self, u)
    }
}

impl Linkage for Pendulum<'_> {
    fn bodies(&self) -> Vec<Body> {
        self.masses.iter().map(|&mass| Body::particle(mass)).collect()
    }

    fn poses(&self) -> Vec<Pose> {
        let mut end = Vector3::zeros();
        let mut poses = Vec::new();
        for (angle, length) in self.q.iter().zip(self.lengths) {
            end += Vector3::new(angle.sin(), -angle.cos(), 0.0) * *length;
            poses.push(Pose::at(end));
        }
        poses
    }

    fn joints(&self, bodies: &[Moving]) -> Vec<Jet> {
        let mut previous = JetVector::constant(Vector3::zeros());
        let mut rows = Vec::new();
        for (body, &length) in bodies.iter().zip(self.lengths) {
            rows.push(joint::distance(&body.centre(), &previous, length));
            rows.push(body.centre().component(2));
            previous = body.centre();
        }
        rows
    }

    fn coordinate_rates(&self, bodies: &[Moving]) -> Vec<Jet> {
        let mut previous = JetVector::constant(Vector3::zeros());
        let mut rates = Vec::new();
        for (body, length) in bodies.iter().zip(self.lengths) {
            let rod = body.centre() - previous;
            let turning = rod.cross(&rod.derivative()).component(2);
            rates.push(turning * Jet::constant(1.0 / (length * length)));
            previous = body.centre();
        }
        rates
    }

    fn independent(&self) -> Vec<usize> {
        (0..self.q.len()).collect()
    }

    fn gravity(&self) -> Vector3<f64> {
        Vector3::new(0.0, -self.g, 0.0)
    }
}
