//! The planar four-bar of the reference: three links in a loop over the ground link (0,0)-(l4,0).
//!
//! l1 e(q1) + l2 e(q2) + l3 e(q3) = (l4, 0), absolute angles from +x, mass centres at mid link,
//! gravity -y, torque T on link 1 from the ground. In space, hinges 0-1, 1-2 and 3-0 and a point
//! in the plane between 2 and 3: 17 rows for 18 velocities.

use super::body::{Body, Moving, Pose};
use super::jet::{Jet, JetVector};
use super::joint;
use super::system::{self, Linkage, Motion};
use nalgebra::{Matrix3, Rotation3, Vector3};

/// The four-bar at one configuration; arrays in the order of the links.
pub struct Fourbar {
    /// Lengths l1, l2, l3 and of the ground link l4 (m).
    pub lengths: [f64; 4],
    /// Masses (kg).
    pub masses: [f64; 3],
    /// Central moments of inertia (kg m^2).
    pub inertias: [f64; 3],
    /// Gravity (m/s^2).
    pub g: f64,
    /// Absolute angles (rad).
    pub q: [f64; 3],
    /// Torque on link 1 (N m).
    pub torque: f64,
}

impl Fourbar {
    /// From the reference's arrays: parameters l1..l4, m1..m3, I1..I3, g.
    ///
    /// # Panics
    /// If the arrays are shorter than the reference's.
    #[must_use]
    pub fn new(parameters: &[f64], q: &[f64], inputs: &[f64]) -> Self {
        let p = parameters;
        Self {
            lengths: [p[0], p[1], p[2], p[3]],
            masses: [p[4], p[5], p[6]],
            inertias: [p[7], p[8], p[9]],
            g: p[10],
            q: [q[0], q[1], q[2]],
            torque: inputs[0],
        }
    }

    /// The oracle's answer for the crank speed u1.
    #[must_use]
    pub fn solve(&self, u: &[f64]) -> Motion {
        system::solve(self, u)
    }

    /// End of a link: -1 its tail, +1 its head.
    fn end(&self, bodies: &[Moving], link: usize, side: f64) -> JetVector {
        bodies[link].point(Vector3::new(side * 0.5 * self.lengths[link], 0.0, 0.0))
    }
}

impl Linkage for Fourbar {
    fn bodies(&self) -> Vec<Body> {
        let link = |k: usize| Body::rigid(self.masses[k], Matrix3::identity() * self.inertias[k]);
        let mut bodies = vec![link(0), link(1), link(2)];
        bodies[0].torque = Vector3::new(0.0, 0.0, self.torque);
        bodies
    }

    fn poses(&self) -> Vec<Pose> {
        let mut tail = Vector3::zeros();
        let mut poses = Vec::new();
        for (angle, length) in self.q.iter().zip(self.lengths) {
            let rotation = Rotation3::from_axis_angle(&Vector3::z_axis(), *angle).into_inner();
            let along = rotation * Vector3::x() * length;
            poses.push(Pose { centre: tail + along * 0.5, rotation });
            tail += along;
        }
        poses
    }

    fn joints(&self, bodies: &[Moving]) -> Vec<Jet> {
        let ground = |x: f64| JetVector::constant(Vector3::new(x, 0.0, 0.0));
        let across = [JetVector::constant(Vector3::x()), JetVector::constant(Vector3::y())];
        let axis = |link: usize| bodies[link].fixed(Vector3::z());
        let across_1 = [bodies[0].fixed(Vector3::x()), bodies[0].fixed(Vector3::y())];
        let mut rows = Vec::new();
        rows.extend(joint::hinge(&self.end(bodies, 0, -1.0), &ground(0.0), &axis(0), across));
        rows.extend(joint::hinge(&self.end(bodies, 1, -1.0), &self.end(bodies, 0, 1.0), &axis(1), across_1));
        rows.extend(joint::hinge(&self.end(bodies, 2, 1.0), &ground(self.lengths[3]), &axis(2), across));
        let gap = self.end(bodies, 2, -1.0) - self.end(bodies, 1, 1.0);
        rows.extend([gap.component(0), gap.component(1)]);
        rows
    }

    fn coordinate_rates(&self, bodies: &[Moving]) -> Vec<Jet> {
        bodies.iter().map(|body| body.angular_velocity().component(2)).collect()
    }

    fn independent(&self) -> Vec<usize> {
        vec![0]
    }

    fn gravity(&self) -> Vector3<f64> {
        Vector3::new(0.0, -self.g, 0.0)
    }
}
