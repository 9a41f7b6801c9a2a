//! Forces where two things touch, as pictures show them.

use smartbed_runtime::vec3;

/// What acts at a point of contact.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ContactForce {
    /// Where (m).
    pub point: [f64; 3],
    /// Along the normal, on what is shown to be pushed (N).
    pub normal: [f64; 3],
    /// Across it (N).
    pub friction: [f64; 3],
    /// Is the other one pushed as well, or fixed in space?
    pub on_both: bool,
}

impl ContactForce {
    /// From a force along the axes n, t1, t2 on the first of two things that move or do not; none where neither does.
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

    /// Length of the normal force (N).
    #[must_use]
    pub fn size(&self) -> f64 {
        vec3::norm(self.normal)
    }
}
