//! Newton's law of impact for each point by itself: v+ = -e v-, J = (1 + e) m v_b, loss (1 - e^2) m v_b^2/2.
//!
//! Moreau's time stepping uses the same law over a whole step (see `scene::moreau`).

use super::compensation::{Impact, PointImpact, Root};
use super::repertoire::Repertoire;
use super::system::System;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Applies the law to the points marked in `points`, which receive the impulses.
pub fn apply<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    restitution: S,
    vel: &mut [Vec3<S>],
    points: &mut [PointImpact<S>],
) -> Impact<S> {
    let mut lost = S::ZERO;
    if let Some(ground) = system.ground {
        for ((v, point), m) in vel.iter_mut().zip(points.iter_mut()).zip(system.body.mass) {
            point.impulse = S::ZERO;
            if point.touching {
                point.approach = -ground.gap_rate(*v);
                let change = (S::ONE + restitution) * point.approach;
                *v = vec3::axpy(*v, change, ground.normal);
                point.impulse = *m * change;
                let kinetic = S::from_f64(0.5) * *m * point.approach * point.approach;
                lost = lost + kinetic * (S::ONE - restitution * restitution);
            }
        }
    }
    Impact { root: Root::Alone, lambda: S::ZERO, lost, friction: S::ZERO }
}
