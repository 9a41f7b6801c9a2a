//! Segments connected by joints: energies of weight and joints, with gradients and Hessians in the segments'
//! displacements.
//!
//! A joint is a stiff spring between two points, and a soft one that turns the segments back to their posture: with a_k
//! and b_k the axes of the second segment in the posture and at present, E = kappa/2 (3 - sum a_k . b_k), which is
//! kappa/2 angle^2 for small angles; its moments are -+kappa/2 sum a_k x b_k.

use super::limits::Limits;
use super::surface::Surface;
use crate::pose::Pose;
use smartbed_runtime::rigid::attitude::Attitude;
use smartbed_runtime::vec3::{Vec3, add, cross, dot, scale, sub};

/// A rigid segment covered by tissue.
#[derive(Clone, Debug, PartialEq)]
pub struct Segment {
    /// Its name.
    pub name: String,
    /// Surface of the tissue, relative to the segment's origin.
    pub shape: Surface,
    /// Mass (kg).
    pub mass: f64,
    /// Mass centre (m) in the segment's axes.
    pub centre: Vec3<f64>,
    /// Foundation modulus of the tissue: pressure per depth (Pa/m).
    pub foundation: f64,
    /// Freedom to move along x, y, z of the bed, then to turn about them.
    pub free: [bool; 6],
}

/// A joint: two segments that share a point.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// Its name.
    pub name: String,
    /// Segments, the one nearer to the trunk first.
    pub segments: [usize; 2],
    /// The point in the axes of each (m).
    pub points: [Vec3<f64>; 2],
    /// Attitude of the second segment in the first, in the posture.
    pub posture: Attitude<f64>,
    /// Stiffness of the spring between the points (N/m).
    pub stiffness: f64,
    /// Stiffness against rotation, kappa (N m/rad).
    pub turning: f64,
    /// Limits of its angles, if any.
    pub limits: Option<Limits>,
}

/// Segments and joints.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Body {
    /// Segments.
    pub segments: Vec<Segment>,
    /// Joints.
    pub joints: Vec<Joint>,
}

/// A gradient and a Hessian in the displacements and rotations of all segments, six rows per segment.
#[derive(Clone, Debug)]
pub struct Rows {
    /// Gradient.
    pub gradient: Vec<f64>,
    /// Hessian, row by row.
    pub hessian: Vec<f64>,
}

impl Rows {
    /// Zeros.
    #[must_use]
    pub fn new(segments: usize) -> Rows {
        let size = 6 * segments;
        Rows { gradient: vec![0.0; size], hessian: vec![0.0; size * size] }
    }

    /// Adds sign g for the gradient g with respect to a point at an arm of a segment.
    pub fn add_gradient(&mut self, segment: usize, arm: Vec3<f64>, g: Vec3<f64>, sign: f64) {
        let moment = cross(arm, g);
        for i in 0..3 {
            self.gradient[6 * segment + i] += sign * g[i];
            self.gradient[6 * segment + 3 + i] += sign * moment[i];
        }
    }

    /// Adds sign J_a' H J_b for points at the arms of two segments, with J = (I, -r x).
    pub fn add_hessian(&mut self, [a, b]: [usize; 2], arms: [Vec3<f64>; 2], h: &[Vec3<f64>; 3], sign: f64) {
        let size = self.gradient.len();
        let (left, right) = (lever(arms[0]), lever(arms[1]));
        for (i, left) in left.iter().enumerate() {
            for (j, right) in right.iter().enumerate() {
                let product = [dot(h[0], *right), dot(h[1], *right), dot(h[2], *right)];
                self.hessian[(6 * a + i) * size + 6 * b + j] += sign * dot(*left, product);
            }
        }
    }
}

/// Velocity of a point at an arm, per unit of displacement and rotation: e_k, and e_k x r.
#[must_use]
pub fn lever(arm: Vec3<f64>) -> [Vec3<f64>; 6] {
    let [x, y, z] = arm;
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]
}

impl Segment {
    /// Is the segment fixed?
    #[must_use]
    pub fn is_held(&self) -> bool {
        self.free == [false; 6]
    }
}

impl Body {
    /// A body with one segment.
    #[must_use]
    pub fn single(segment: Segment) -> Body {
        Body { segments: vec![segment], joints: Vec::new() }
    }

    /// Mass (kg).
    #[must_use]
    pub fn mass(&self) -> f64 {
        self.segments.iter().map(|s| s.mass).sum()
    }

    /// Energy of weight and joints (J).
    #[must_use]
    pub fn energy(&self, poses: &[Pose], gravity: f64) -> f64 {
        let parts = self.segments.iter().zip(poses);
        let weight: f64 = parts.map(|(s, p)| s.mass * gravity * p.outwards(s.centre)[2]).sum();
        weight + self.joints.iter().map(|j| j.energy(poses)).sum::<f64>()
    }

    /// Adds gradient and Hessian of weight and joints; the second-order part of the weight is neglected.
    pub fn add_to(&self, poses: &[Pose], gravity: f64, rows: &mut Rows) {
        for (index, (segment, pose)) in self.segments.iter().zip(poses).enumerate() {
            let arm = pose.attitude.to_inertial(segment.centre);
            rows.add_gradient(index, arm, [0.0, 0.0, segment.mass * gravity], 1.0);
        }
        self.joints.iter().for_each(|joint| joint.add_to(poses, rows));
    }
}

impl Joint {
    /// Arms of the point from both origins, and the distance vector between the two points.
    fn parted(&self, poses: &[Pose]) -> ([Vec3<f64>; 2], Vec3<f64>) {
        let [a, b] = self.segments.map(|s| &poses[s]);
        let arms = [a.attitude.to_inertial(self.points[0]), b.attitude.to_inertial(self.points[1])];
        (arms, sub(add(a.place, arms[0]), add(b.place, arms[1])))
    }

    /// Axes of the second segment in the posture, and at present.
    fn axes(&self, poses: &[Pose]) -> [[Vec3<f64>; 3]; 2] {
        let [a, b] = self.segments.map(|s| &poses[s].attitude);
        [self.posture.axes().map(|axis| a.to_inertial(axis)), b.axes()]
    }

    /// Sum a_k . b_k: 1 + 2 cos(angle).
    fn trace(&self, poses: &[Pose]) -> f64 {
        let [wanted, found] = self.axes(poses);
        wanted.iter().zip(found).map(|(a, b)| dot(*a, b)).sum()
    }

    fn energy(&self, poses: &[Pose]) -> f64 {
        let (_, apart) = self.parted(poses);
        let [inner, outer] = self.segments.map(|s| poses[s].attitude.axes());
        let beyond = self.limits.as_ref().map_or(0.0, |limits| limits.energy(&inner, &outer));
        0.5 * self.stiffness * dot(apart, apart) + 0.5 * self.turning * (3.0 - self.trace(poses)) + beyond
    }

    /// Angle between the present attitude and the posture (rad).
    #[must_use]
    pub fn angle(&self, poses: &[Pose]) -> f64 {
        (0.5 * (self.trace(poses) - 1.0)).clamp(-1.0, 1.0).acos()
    }

    fn add_to(&self, poses: &[Pose], rows: &mut Rows) {
        let [a, b] = self.segments;
        let (arms, apart) = self.parted(poses);
        let pull = scale(apart, self.stiffness);
        rows.add_gradient(a, arms[0], pull, 1.0);
        rows.add_gradient(b, arms[1], pull, -1.0);
        let k = self.stiffness;
        let h = [[k, 0.0, 0.0], [0.0, k, 0.0], [0.0, 0.0, k]];
        rows.add_hessian([a, a], [arms[0]; 2], &h, 1.0);
        rows.add_hessian([b, b], [arms[1]; 2], &h, 1.0);
        rows.add_hessian([a, b], arms, &h, -1.0);
        rows.add_hessian([b, a], [arms[1], arms[0]], &h, -1.0);
        let axes = self.axes(poses);
        self.add_turning(axes, self.turning, rows);
        self.add_stops(poses, rows);
    }

    /// Adds the moments of the joint's limits.
    fn add_stops(&self, poses: &[Pose], rows: &mut Rows) {
        let [a, b] = self.segments;
        let (Some(limits), size) = (&self.limits, rows.gradient.len()) else { return };
        let [inner, outer] = [a, b].map(|s| poses[s].attitude.axes());
        for stop in limits.stops(&inner, &outer) {
            let moment = scale(stop.direction, limits.stiffness * stop.beyond);
            for (row, sign) in [(a, -1.0), (b, 1.0)] {
                for (i, (moment, g)) in moment.into_iter().zip(stop.direction).enumerate() {
                    rows.gradient[6 * row + 3 + i] += sign * moment;
                    for (column, other) in [(a, -1.0), (b, 1.0)] {
                        let start = (6 * row + 3 + i) * size + 6 * column + 3;
                        for (entry, along) in rows.hessian[start..].iter_mut().zip(stop.direction) {
                            *entry += sign * other * limits.stiffness * g * along;
                        }
                    }
                }
            }
        }
    }

    /// Energy (J) of a rotational spring of the same stiffness towards the relative attitude at an earlier time.
    #[must_use]
    pub fn turning_since(&self, before: &[Pose], poses: &[Pose]) -> f64 {
        let [wanted, found] = self.axes_since(before, poses);
        let trace: f64 = wanted.iter().zip(found).map(|(a, b)| dot(*a, b)).sum();
        0.5 * self.turning * (3.0 - trace)
    }

    /// Adds its gradient and Hessian, multiplied by `share`.
    pub fn add_turning_since(&self, before: &[Pose], poses: &[Pose], share: f64, rows: &mut Rows) {
        self.add_turning(self.axes_since(before, poses), share * self.turning, rows);
    }

    /// Axes of the second segment in the relative attitude at the earlier time, and at present.
    fn axes_since(&self, before: &[Pose], poses: &[Pose]) -> [[Vec3<f64>; 3]; 2] {
        let [a, b] = self.segments;
        let wanted = before[b].attitude.axes().map(|axis| before[a].attitude.to_body(axis));
        [wanted.map(|axis| poses[a].attitude.to_inertial(axis)), poses[b].attitude.axes()]
    }

    /// Adds the moments that turn the second segment's axes towards the axes `wanted`.
    fn add_turning(&self, [wanted, found]: [[Vec3<f64>; 3]; 2], stiffness: f64, rows: &mut Rows) {
        let [a, b] = self.segments;
        let moments = wanted.iter().zip(found).map(|(a, b)| cross(*a, b));
        let moment = scale(moments.fold([0.0; 3], add), 0.5 * stiffness);
        let size = rows.gradient.len();
        for (i, moment) in moment.into_iter().enumerate() {
            rows.gradient[6 * a + 3 + i] -= moment;
            rows.gradient[6 * b + 3 + i] += moment;
            for (row, column, sign) in [(a, a, 1.0), (b, b, 1.0), (a, b, -1.0), (b, a, -1.0)] {
                rows.hessian[(6 * row + 3 + i) * size + 6 * column + 3 + i] += sign * stiffness;
            }
        }
    }
}
