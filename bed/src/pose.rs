//! Where a frame stands: place of its origin and attitude.

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
    /// At a place, not turned.
    #[must_use]
    pub fn at(place: Vec3<f64>) -> Pose {
        Pose { place, attitude: Attitude::identity() }
    }

    /// At a place, turned by an angle (rad) about an axis of length 1.
    #[must_use]
    pub fn turned(place: Vec3<f64>, axis: Vec3<f64>, angle: f64) -> Pose {
        let [x, y, z] = scale(axis, (angle / 2.0).sin());
        Pose { place, attitude: Attitude::new([(angle / 2.0).cos(), x, y, z]) }
    }

    /// A point of this frame, in the outer one.
    #[must_use]
    pub fn outwards(&self, point: Vec3<f64>) -> Vec3<f64> {
        add(self.place, self.attitude.to_inertial(point))
    }

    /// A point of the outer frame, in this one.
    #[must_use]
    pub fn inwards(&self, point: Vec3<f64>) -> Vec3<f64> {
        self.attitude.to_body(sub(point, self.place))
    }

    /// Moved by a way and turned by a rotation vector (rad), both in the outer frame.
    #[must_use]
    pub fn moved(&self, way: Vec3<f64>, turn: Vec3<f64>) -> Pose {
        // Cayley's turn of tan(angle/2): of the same direction and, for a Newton step, of the same first order.
        let attitude = self.attitude.turned(self.attitude.to_body(scale(turn, 0.5)));
        Pose { place: add(self.place, way), attitude }
    }

    /// A frame given in this one, in the outer one.
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
