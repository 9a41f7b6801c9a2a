//! The terms that a stage of time adds to the energy, inertia and dissipation, so that its end is found like an
//! equilibrium.
//!
//! In: the predictions of an integration method for every point. Out: terms of energy, gradient and Hessian. Every
//! formula of [`Method`](crate::method::Method) gives the velocity at the end as v = b (p - p~) and the acceleration as
//! b (v - v~) = b^2 (p - p^), so that the equations of motion at the end minimise m b^2/2 |p - p^|^2 + energy. A
//! segment's inertia is that of six points on its axes. Dissipation is of Kelvin-Voigt type: parallel to a spring, a
//! damper of retardation time times stiffness.

use super::swing::Swing;
use crate::body::{Body, Rows, Segment};
use crate::pose::Pose;
use crate::tissue::Memory;
use smartbed_runtime::vec3::{Vec3, dot, scale, sub};

/// The predictions for all points in a stage.
#[derive(Clone, Debug)]
pub struct Increment<'a> {
    /// b (1/s).
    pub rate: f64,
    /// Retardation time of the joints' rotational springs (s).
    pub joint_loss: f64,
    /// Terms of the sheets, by tile.
    pub sheets: Vec<Swing>,
    /// p^ of six points of each segment, in the bed's frame.
    pub segments: Vec<[Vec3<f64>; 6]>,
    /// The segments' poses at p~, from which joints' dampers count.
    pub resting: Vec<Pose>,
    /// Memory of the tissue, by tile.
    pub tissue: Vec<Memory<'a>>,
}

/// Six points with a sixth of the segment's mass each that have its moments of inertia.
#[must_use]
pub fn points(segment: &Segment, pose: &Pose) -> [Vec3<f64>; 6] {
    let at = segment.shape.gyration();
    std::array::from_fn(|k| {
        let mut place = segment.centre;
        place[k / 2] += if k % 2 == 0 { at[k / 2] } else { -at[k / 2] };
        pose.outwards(place)
    })
}

impl Increment<'_> {
    /// Terms of the segments' inertia and of the joints' dampers.
    pub(super) fn body_energy(&self, body: &Body, poses: &[Pose]) -> f64 {
        let one = |(segment, (pose, hats)): (&Segment, (&Pose, &[Vec3<f64>; 6]))| {
            let factor = segment.mass / 12.0 * self.rate * self.rate;
            let off = points(segment, pose).into_iter().zip(hats).map(|(p, hat)| sub(p, *hat));
            factor * off.map(|o| dot(o, o)).sum::<f64>()
        };
        let kinetic: f64 = body.segments.iter().zip(poses.iter().zip(&self.segments)).map(one).sum();
        let share = self.joint_loss * self.rate;
        let lost: f64 = body.joints.iter().map(|j| share * j.turning_since(&self.resting, poses)).sum();
        kinetic + lost
    }

    /// Adds their gradient and Hessian; second-order terms of a segment's rotation are neglected.
    pub(super) fn add_body(&self, body: &Body, poses: &[Pose], rows: &mut Rows) {
        for (index, (segment, pose)) in body.segments.iter().zip(poses).enumerate() {
            let factor = segment.mass / 6.0 * self.rate * self.rate;
            let same = std::array::from_fn(|i| std::array::from_fn(|j| if i == j { factor } else { 0.0 }));
            for (point, hat) in points(segment, pose).into_iter().zip(self.segments[index]) {
                let arm = sub(point, pose.place);
                rows.add_gradient(index, arm, scale(sub(point, hat), factor), 1.0);
                rows.add_hessian([index; 2], [arm; 2], &same, 1.0);
            }
        }
        let share = self.joint_loss * self.rate;
        body.joints.iter().for_each(|j| j.add_turning_since(&self.resting, poses, share, rows));
    }
}
