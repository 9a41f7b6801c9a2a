//! Poses: position of a frame's origin, and its attitude.

use smartbed_runtime::rigid::attitude::Attitude;
use smartbed_runtime::vec3::{Vec3, add, scale, sub};

/// A frame in N, or in another frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Its origin (m).
    pub place: Vec3<f64>,
    /// Its attitude.
    pub attitude: Attitude<f64>,
}

impl Pose {
    /// At a position, not turned.
    #[must_use]
    pub fn at(place: Vec3<f64>) -> Pose {
        Pose { place, attitude: Attitude::identity() }
    }

    /// At a position, turned by an angle (rad) about a unit axis.
    #[must_use]
    pub fn turned(place: Vec3<f64>, axis: Vec3<f64>, angle: f64) -> Pose {
        let [x, y, z] = scale(axis, (angle / 2.0).sin());
        Pose { place, attitude: Attitude::new([(angle / 2.0).cos(), x, y, z]) }
    }

    /// Transforms a point from this frame to the outer one.
    #[must_use]
    pub fn outwards(&self, point: Vec3<f64>) -> Vec3<f64> {
        add(self.place, self.attitude.to_inertial(point))
    }

    /// Transforms a point from the outer frame to this one.
    #[must_use]
    pub fn inwards(&self, point: Vec3<f64>) -> Vec3<f64> {
        self.attitude.to_body(sub(point, self.place))
    }

    /// Displaced and turned by a rotation vector (rad), both given in the outer frame.
    #[must_use]
    pub fn moved(&self, way: Vec3<f64>, turn: Vec3<f64>) -> Pose {
        // Cayley's rotation by 2 atan(angle/2): same axis and same first order, which is enough for a Newton step.
        let attitude = self.attitude.turned(self.attitude.to_body(scale(turn, 0.5)));
        Pose { place: add(self.place, way), attitude }
    }

    /// Composition: a pose given in this frame, expressed in the outer one.
    #[must_use]
    pub fn of(&self, inner: &Pose) -> Pose {
        let [w, x, y, z] = self.attitude.parameters();
        let [s, i, j, k] = inner.attitude.parameters();
        let attitude = Attitude::new([
            w * s - x * i - y * j - z * k,
            w * i + x * s + y * k - z * j,
            w * j - x * k + y * s + z * i,
            w * k + x * j - y * i + z * s,
        ]);
        Pose { place: self.outwards(inner.place), attitude }
    }
}
