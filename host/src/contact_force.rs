//! Contact forces as pictures show them.

use smartbed_runtime::vec3;

/// The force at a point of contact.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ContactForce {
    /// Point of contact (m).
    pub point: [f64; 3],
    /// Normal force on the part that is shown as pushed (N).
    pub normal: [f64; 3],
    /// Friction force on it (N).
    pub friction: [f64; 3],
    /// Is the other part movable, so that it is pushed too, or is it fixed in space?
    pub on_both: bool,
}

impl ContactForce {
    /// From a force on the first of two parts, along the axes n, t1, t2; `None` if neither part can move.
    #[must_use]
    pub fn between(
        moves: [bool; 2],
        point: [f64; 3],
        axes: [[f64; 3]; 3],
        [n, t1, t2]: [f64; 3],
    ) -> Option<Self> {
        let sign = if moves[0] { 1.0 } else { -1.0 };
        let normal = vec3::scale(axes[0], sign * n);
        let friction = vec3::add(vec3::scale(axes[1], sign * t1), vec3::scale(axes[2], sign * t2));
        let is_shown = n > 0.0 && (moves[0] || moves[1]);
        is_shown.then_some(Self { point, normal, friction, on_both: moves[0] && moves[1] })
    }

    /// Magnitude of the normal force (N).
    #[must_use]
    pub fn size(&self) -> f64 {
        vec3::norm(self.normal)
    }
}
