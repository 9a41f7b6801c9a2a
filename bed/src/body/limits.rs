//! Limits of a joint: a spring beyond each end of its range.
//!
//! In: axes of both segments. Out: for each angle beyond its range by how much, and the direction of the moment. With
//! the outer segment turned by R = Rx(flexion) Rz(spread) Ry(twist) in the inner one, spread = asin(-R_xy), twist =
//! atan2(R_xz, R_xx), flexion = atan2(R_zy, R_yy); an angle grows at the rate g . omega, with g the vector dual to its
//! axis. (flexion + pi, pi - spread, twist + pi) is the same attitude: of the two the one nearer to the posture is
//! used.

use smartbed_runtime::vec3::{Vec3, add, cross, dot, scale};
use std::f64::consts::{PI, TAU};

/// The range of a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Flexion, spread, twist in the posture (rad).
    pub posture: [f64; 3],
    /// Allowed range of each (rad).
    pub range: [[f64; 2]; 3],
    /// Stiffness beyond the range (N m/rad).
    pub stiffness: f64,
}

/// An angle beyond its range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stop {
    /// By how much (rad); negative below the range.
    pub beyond: f64,
    /// g, in the frame of the axes.
    pub direction: Vec3<f64>,
}

impl Limits {
    /// Flexion, spread and twist (rad) of a segment with axes `outer` relative to one with axes `inner`.
    #[must_use]
    pub fn angles(&self, inner: &[Vec3<f64>; 3], outer: &[Vec3<f64>; 3]) -> [f64; 3] {
        let r = |i: usize, k: usize| dot(inner[i], outer[k]);
        let found = [r(2, 1).atan2(r(1, 1)), (-r(0, 1)).clamp(-1.0, 1.0).asin(), r(0, 2).atan2(r(0, 0))];
        let other = [found[0] + PI, PI - found[1], found[2] + PI];
        let near = |angles: [f64; 3]| -> [f64; 3] {
            std::array::from_fn(|i| angles[i] - TAU * ((angles[i] - self.posture[i]) / TAU).round())
        };
        let off = |angles: &[f64; 3]| -> f64 { (0..3).map(|i| (angles[i] - self.posture[i]).powi(2)).sum() };
        let (found, other) = (near(found), near(other));
        if off(&found) <= off(&other) { found } else { other }
    }

    /// Angles beyond their range. None near a spread of 90 deg, where flexion and twist turn about the same axis.
    pub fn stops(&self, inner: &[Vec3<f64>; 3], outer: &[Vec3<f64>; 3]) -> impl Iterator<Item = Stop> {
        let angles = self.angles(inner, outer);
        let (sin, cos) = angles[0].sin_cos();
        let across = add(scale(inner[1], -sin), scale(inner[2], cos));
        let axes = [inner[0], across, outer[1]];
        let volume = dot(axes[0], cross(axes[1], axes[2]));
        let one = move |i: usize| {
            let [low, high] = self.range[i];
            let beyond = (angles[i] - high).max(0.0) + (angles[i] - low).min(0.0);
            let direction = scale(cross(axes[(i + 1) % 3], axes[(i + 2) % 3]), 1.0 / volume);
            (beyond != 0.0 && volume.abs() > 0.1).then_some(Stop { beyond, direction })
        };
        (0..3).filter_map(one)
    }

    /// Energy of the springs (J).
    #[must_use]
    pub fn energy(&self, inner: &[Vec3<f64>; 3], outer: &[Vec3<f64>; 3]) -> f64 {
        self.stops(inner, outer).map(|stop| 0.5 * self.stiffness * stop.beyond * stop.beyond).sum()
    }
}
