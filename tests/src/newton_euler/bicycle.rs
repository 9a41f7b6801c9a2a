//! The Whipple bicycle in the axes of Meijaard, Papadopoulos, Ruina and Schwab (2007):
//! x forward, y right, z down; knife-edge wheels that roll without slip on the plane z = 0.
//!
//! Bodies: rear wheel, rear frame, front frame, front wheel; all frames are parallel in the
//! reference position, whose origin is the rear contact. Rows: three hinges, two wheels on the
//! ground, two rolling conditions of two rows each. Yaw, roll, pitch of the rear frame about z,
//! x, y in this order; steer about the head's axis, downwards.

use super::body::{Body, Moving, Pose};
use super::jet::{Jet, JetVector};
use super::joint;
use super::system::{self, Linkage, Motion};
use nalgebra::{Matrix3, Rotation3, Unit, Vector3};

/// Rear wheel in the list of bodies.
const REAR_WHEEL: usize = 0;
/// Rear frame with the rider.
const REAR_FRAME: usize = 1;
/// Handlebar and fork.
const FRONT_FRAME: usize = 2;
/// Front wheel.
const FRONT_WHEEL: usize = 3;

/// The bicycle at one configuration.
#[derive(Clone, Debug)]
pub struct Bicycle {
    /// Mass centres in the reference position from the rear contact (m).
    centres: [Vector3<f64>; 4],
    /// Masses (kg).
    masses: [f64; 4],
    /// Central inertias (kg m^2).
    inertias: [Matrix3<f64>; 4],
    /// Radii of rear and front wheel (m).
    radii: [f64; 2],
    /// A point of the steering axis, from the rear contact (m).
    head: Vector3<f64>,
    /// The steering axis, downwards.
    axis: Unit<Vector3<f64>>,
    g: f64,
    /// yaw, roll, pitch, steer, thR, thF (rad).
    q: [f64; 6],
    /// Roll torque on the rear frame, steer torque, rear wheel torque (N m).
    inputs: [f64; 3],
}

impl Bicycle {
    /// From the reference's arrays: w c lam g rR mR IRx IRy xB zB mB IBxx IByy IBzz IBxz xH zH mH
    /// IHxx IHyy IHzz IHxz rF mF IFx IFy.
    ///
    /// # Panics
    /// If an array is too short.
    #[must_use]
    pub fn new(p: &[f64], q: &[f64], inputs: &[f64]) -> Self {
        let frame = |i: &[f64]| Matrix3::new(i[0], 0.0, i[3], 0.0, i[1], 0.0, i[3], 0.0, i[2]);
        let wheel = |ix: f64, iy: f64| Matrix3::from_diagonal(&Vector3::new(ix, iy, ix));
        Self {
            centres: [
                Vector3::new(0.0, 0.0, -p[4]),
                Vector3::new(p[8], 0.0, p[9]),
                Vector3::new(p[15], 0.0, p[16]),
                Vector3::new(p[0], 0.0, -p[22]),
            ],
            masses: [p[5], p[10], p[17], p[23]],
            inertias: [wheel(p[6], p[7]), frame(&p[11..15]), frame(&p[18..22]), wheel(p[24], p[25])],
            radii: [p[4], p[22]],
            head: Vector3::new(p[0] + p[1], 0.0, 0.0),
            axis: Unit::new_normalize(Vector3::new(p[2].sin(), 0.0, p[2].cos())),
            g: p[3],
            q: [q[0], q[1], q[2], q[3], q[4], q[5]],
            inputs: [inputs[0], inputs[1], inputs[2]],
        }
    }

    /// The oracle's answer for the speeds of roll, steer and rear wheel.
    #[must_use]
    pub fn solve(&self, u: &[f64]) -> Motion {
        system::solve(self, u)
    }

    /// Pitch that puts the front wheel on the ground at this yaw, roll and steer, by the secant method.
    #[must_use]
    pub fn pitch(&self) -> f64 {
        let height = |pitch: f64| {
            let mut bicycle = self.clone();
            bicycle.q[2] = pitch;
            let poses = bicycle.poses();
            let front = Moving::at_rest(poses[FRONT_WHEEL]);
            front.pose.centre.z + to_contact(&front, self.radii[1]).value.z
        };
        let (mut old, mut new) = (-0.01, 0.01);
        for _ in 0..20 {
            let (at_old, at_new) = (height(old), height(new));
            if at_old == at_new {
                break;
            }
            (old, new) = (new, new - at_new * (new - old) / (at_new - at_old));
        }
        new
    }

    /// A point of a body, given in the reference position from the rear contact.
    fn point(&self, bodies: &[Moving], body: usize, reference: Vector3<f64>) -> JetVector {
        bodies[body].point(reference - self.centres[body])
    }
}

/// From a wheel's centre to its lowest point.
fn to_contact(wheel: &Moving, radius: f64) -> JetVector {
    let down = JetVector::constant(Vector3::z());
    let axle = wheel.fixed(Vector3::y());
    (down - axle.scale(axle.dot(&down))).unit().scale(Jet::constant(radius))
}

/// Horizontal direction in which the rear frame heads.
fn heading(rear_frame: &Moving) -> JetVector {
    rear_frame.fixed(Vector3::y()).cross(&JetVector::constant(Vector3::z())).unit()
}

impl Linkage for Bicycle {
    fn bodies(&self) -> Vec<Body> {
        let poses = self.poses();
        let mut bodies: Vec<Body> = (0..4).map(|k| Body::rigid(self.masses[k], self.inertias[k])).collect();
        let axle = poses[REAR_FRAME].rotation.column(1).into_owned();
        let steer = poses[REAR_FRAME].rotation * self.axis.into_inner() * self.inputs[1];
        let (s, c) = self.q[0].sin_cos();
        bodies[REAR_FRAME].torque = Vector3::new(c, s, 0.0) * self.inputs[0] - steer - axle * self.inputs[2];
        bodies[FRONT_FRAME].torque = steer;
        bodies[REAR_WHEEL].torque = axle * self.inputs[2];
        bodies
    }

    fn poses(&self) -> Vec<Pose> {
        let about = |axis, angle| Rotation3::from_axis_angle(&axis, angle).into_inner();
        let [yaw, roll, pitch, steer, rear, front] = self.q;
        let (x, y, z) = (Vector3::x_axis(), Vector3::y_axis(), Vector3::z_axis());
        let frame = about(z, yaw) * about(x, roll) * about(y, pitch);
        let fork = frame * about(self.axis, steer);
        let hub = Pose { centre: Vector3::zeros(), rotation: frame * about(y, rear) };
        let wheel = Moving::at_rest(hub);
        let rear_centre = Vector3::new(0.0, 0.0, -to_contact(&wheel, self.radii[0]).value.z);
        let on_frame = |reference: Vector3<f64>| rear_centre + frame * (reference - self.centres[REAR_WHEEL]);
        let head = on_frame(self.head);
        let on_fork = |reference: Vector3<f64>| head + fork * (reference - self.head);
        vec![
            Pose { centre: rear_centre, ..hub },
            Pose { centre: on_frame(self.centres[REAR_FRAME]), rotation: frame },
            Pose { centre: on_fork(self.centres[FRONT_FRAME]), rotation: fork },
            Pose { centre: on_fork(self.centres[FRONT_WHEEL]), rotation: fork * about(y, front) },
        ]
    }

    fn joints(&self, bodies: &[Moving]) -> Vec<Jet> {
        let mut rows = Vec::new();
        for (wheel, frame) in [(REAR_WHEEL, REAR_FRAME), (FRONT_WHEEL, FRONT_FRAME)] {
            let across = [bodies[frame].fixed(Vector3::x()), bodies[frame].fixed(Vector3::z())];
            let hub = self.point(bodies, frame, self.centres[wheel]);
            rows.extend(joint::hinge(
                &bodies[wheel].centre(),
                &hub,
                &bodies[wheel].fixed(Vector3::y()),
                across,
            ));
        }
        let rear = &bodies[REAR_FRAME];
        let across = [Vector3::y(), self.axis.cross(&Vector3::y())].map(|side| rear.fixed(side));
        let heads = [REAR_FRAME, FRONT_FRAME].map(|body| self.point(bodies, body, self.head));
        let axis = bodies[FRONT_FRAME].fixed(self.axis.into_inner());
        rows.extend(joint::hinge(&heads[1], &heads[0], &axis, across));
        for (wheel, radius) in [REAR_WHEEL, FRONT_WHEEL].into_iter().zip(self.radii) {
            let wheel = &bodies[wheel];
            rows.push((wheel.centre() + to_contact(wheel, radius)).component(2));
        }
        rows
    }

    fn rolling(&self, bodies: &[Moving]) -> Vec<Jet> {
        let slip = |(wheel, radius): (usize, f64)| {
            let slip = bodies[wheel].velocity_at(&to_contact(&bodies[wheel], radius));
            [slip.component(0), slip.component(1)]
        };
        [REAR_WHEEL, FRONT_WHEEL].into_iter().zip(self.radii).flat_map(slip).collect()
    }

    fn coordinate_rates(&self, bodies: &[Moving]) -> Vec<Jet> {
        let down = JetVector::constant(Vector3::z());
        let w = bodies.iter().map(Moving::angular_velocity).collect::<Vec<_>>();
        let axle = bodies[REAR_FRAME].fixed(Vector3::y());
        let ahead = heading(&bodies[REAR_FRAME]);
        let yaw = ahead.derivative().dot(&down.cross(&ahead));
        vec![
            yaw,
            w[REAR_FRAME].dot(&ahead),
            w[REAR_FRAME].dot(&axle) - yaw * axle.dot(&down),
            (w[FRONT_FRAME] - w[REAR_FRAME]).dot(&bodies[REAR_FRAME].fixed(self.axis.into_inner())),
            (w[REAR_WHEEL] - w[REAR_FRAME]).dot(&axle),
            (w[FRONT_WHEEL] - w[FRONT_FRAME]).dot(&bodies[FRONT_FRAME].fixed(Vector3::y())),
        ]
    }

    fn independent(&self) -> Vec<usize> {
        vec![1, 3, 4]
    }

    fn gravity(&self) -> Vector3<f64> {
        Vector3::new(0.0, 0.0, self.g)
    }
}
