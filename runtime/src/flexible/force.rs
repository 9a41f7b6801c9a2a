//! Sum of all forces on the points: gravity, springs, dampers, air, pressure (thesis Eqs. 3.1 to 3.3).
//!
//! Elastic forces (of positions alone) and viscous ones (of speeds) are kept apart: methods that
//! treat dampers implicitly need both. Eq. 3.3 prints M^-1 (F_D - F_K); with the signs of Eqs. 3.1
//! and 3.2 the sum is meant.

use super::{Body, BodyError, pressure};
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Forces of positions: gravity, springs, pressure (N).
///
/// # Errors
/// [`BodyError::Collapsed`] where a gas law has no volume left.
pub fn eval_elastic<S: Scalar>(
    body: &Body<S>,
    pos: &[Vec3<S>],
    force: &mut [Vec3<S>],
) -> Result<(), BodyError<S>> {
    eval_springs(body, pos, force);
    pressure::accumulate_force(body, pos, force)
}

/// Those of gravity and springs (N).
pub fn eval_springs<S: Scalar>(body: &Body<S>, pos: &[Vec3<S>], force: &mut [Vec3<S>]) {
    for (f, m) in force.iter_mut().zip(body.mass) {
        *f = vec3::scale(body.gravity, *m);
    }
    for spring in body.springs {
        let (direction, length) = spring.direction(pos);
        let pull = vec3::scale(direction, spring.tension(length));
        vec3::add_at(force, spring.tail, pull);
        vec3::add_at(force, spring.head, vec3::scale(pull, -S::ONE));
    }
}

/// Forces of speeds: dampers along the springs and air (N).
pub fn eval_viscous<S: Scalar>(body: &Body<S>, pos: &[Vec3<S>], vel: &[Vec3<S>], force: &mut [Vec3<S>]) {
    for (f, v) in force.iter_mut().zip(vel) {
        *f = vec3::scale(*v, -body.air_drag);
    }
    for spring in body.springs {
        if spring.damping > S::ZERO {
            let stretch = spring.stretch(pos, vel);
            let pull = vec3::scale(stretch.direction, spring.damping * stretch.rate);
            vec3::add_at(force, spring.tail, pull);
            vec3::add_at(force, spring.head, vec3::scale(pull, -S::ONE));
        }
    }
}
