//! A serial arm of hinges: joint i at p_i in the parent's frame, turned by Rx(alpha_i), then about z by q_i.
//!
//! Mass centre c_i and central inertia in the link's frame; torque T_i on link i from its parent
//! about the joint's axis; gravity -z of the base.

use super::body::{Body, Moving, Pose};
use super::jet::{Jet, JetVector};
use super::joint;
use super::system::{self, Linkage, Motion};
use nalgebra::{Matrix3, Rotation3, Vector3};

/// Parameters of one link in the reference: p, m, c, Ixx Iyy Izz Ixy Ixz Iyz.
const PER_LINK: usize = 13;

/// One link.
#[derive(Clone, Copy, Debug)]
struct Link {
    /// Joint in the parent's frame (m).
    joint: Vector3<f64>,
    /// Fixed turn about x before the joint's own (rad).
    alpha: f64,
    /// Mass (kg).
    mass: f64,
    /// Mass centre in the link's frame (m).
    centre: Vector3<f64>,
    /// Central inertia (kg m^2).
    inertia: Matrix3<f64>,
}

/// The arm at one configuration.
#[derive(Clone, Debug)]
pub struct Arm {
    links: Vec<Link>,
    g: f64,
    q: Vec<f64>,
    torques: Vec<f64>,
}

impl Arm {
    /// From the reference's arrays and the fixed angles (deg).
    ///
    /// # Panics
    /// If an array is too short.
    #[must_use]
    pub fn new(alpha_degrees: &[f64], parameters: &[f64], q: &[f64], inputs: &[f64]) -> Self {
        let link = |(p, alpha): (&[f64], &f64)| Link {
            joint: Vector3::new(p[0], p[1], p[2]),
            alpha: alpha.to_radians(),
            mass: p[3],
            centre: Vector3::new(p[4], p[5], p[6]),
            inertia: Matrix3::new(p[7], p[10], p[11], p[10], p[8], p[12], p[11], p[12], p[9]),
        };
        let links: Vec<Link> = parameters.chunks_exact(PER_LINK).zip(alpha_degrees).map(link).collect();
        Self { g: parameters[PER_LINK * links.len()], links, q: q.to_vec(), torques: inputs.to_vec() }
    }

    /// The oracle's answer for joint speeds `u`.
    #[must_use]
    pub fn solve(&self, u: &[f64]) -> Motion {
        system::solve(self, u)
    }

    /// The joint's point and its x, y, z before turning, in the parent.
    fn seat(&self, bodies: &[Moving], i: usize) -> (JetVector, [JetVector; 3]) {
        let link = &self.links[i];
        let (s, c) = link.alpha.sin_cos();
        let axes = [Vector3::x(), Vector3::new(0.0, c, s), Vector3::new(0.0, -s, c)];
        if i == 0 {
            return (JetVector::constant(link.joint), axes.map(JetVector::constant));
        }
        let parent = &bodies[i - 1];
        (parent.point(link.joint - self.links[i - 1].centre), axes.map(|axis| parent.fixed(axis)))
    }
}

impl Linkage for Arm {
    fn bodies(&self) -> Vec<Body> {
        let mut bodies: Vec<Body> =
            self.links.iter().map(|link| Body::rigid(link.mass, link.inertia)).collect();
        for (i, pose) in self.poses().iter().enumerate() {
            let torque = pose.rotation.column(2) * self.torques[i];
            bodies[i].torque += torque;
            if i > 0 {
                bodies[i - 1].torque -= torque;
            }
        }
        bodies
    }

    fn poses(&self) -> Vec<Pose> {
        let mut origin = Vector3::zeros();
        let mut rotation = Matrix3::identity();
        let mut poses = Vec::new();
        for (link, &angle) in self.links.iter().zip(&self.q) {
            origin += rotation * link.joint;
            let seat = Rotation3::from_axis_angle(&Vector3::x_axis(), link.alpha).into_inner();
            let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), angle).into_inner();
            rotation *= seat * turn;
            poses.push(Pose { centre: origin + rotation * link.centre, rotation });
        }
        poses
    }

    fn joints(&self, bodies: &[Moving]) -> Vec<Jet> {
        let mut rows = Vec::new();
        for (i, body) in bodies.iter().enumerate() {
            let (point, [x, y, _]) = self.seat(bodies, i);
            let here = body.point(-self.links[i].centre);
            rows.extend(joint::hinge(&here, &point, &body.fixed(Vector3::z()), [x, y]));
        }
        rows
    }

    fn coordinate_rates(&self, bodies: &[Moving]) -> Vec<Jet> {
        let mut rates = Vec::new();
        let mut parent = JetVector::constant(Vector3::zeros());
        for body in bodies {
            let w = body.angular_velocity();
            rates.push((w - parent).dot(&body.fixed(Vector3::z())));
            parent = w;
        }
        rates
    }

    fn independent(&self) -> Vec<usize> {
        (0..self.links.len()).collect()
    }

    fn gravity(&self) -> Vector3<f64> {
        Vector3::new(0.0, 0.0, -self.g)
    }
}
