//! Sum of all forces on the points: gravity, springs, dampers, air, pressure (thesis Eqs. 3.1 to 3.3).
//!
//! Elastic forces (of positions only) and viscous ones (of speeds) are kept apart, because methods that
//! treat dampers implicitly need both. Eq. 3.3 prints M^-1 (F_D - F_K); with the signs of Eqs. 3.1
//! and 3.2 the sum is meant.

use super::body::Body;
use super::element::{Element, Elements};
use super::fault::BodyError;
use super::spring::Spring;
use crate::ode::nodes::MeanStep;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Position-dependent forces: gravity, then the elements (N).
///
/// # Errors
/// [`BodyError::Collapsed`] if a gas law has no volume left.
pub fn eval_elastic<S: Scalar>(
    body: &Body<S>,
    elements: &Elements<S>,
    pos: &[Vec3<S>],
    force: &mut [Vec3<S>],
) -> Result<(), BodyError<S>> {
    elements.eval_elastic((body.mass, body.gravity), |_| true, pos, force)
}

/// The same of a body that has but few springs, see [`Body::short_list`] (N).
pub fn eval_short_list<S: Scalar>(
    body: &Body<S>,
    springs: &[Spring<S>],
    pos: &[Vec3<S>],
    force: &mut [Vec3<S>],
) {
    for (f, m) in force.iter_mut().zip(body.mass) {
        *f = vec3::scale(body.gravity, *m);
    }
    for spring in springs {
        spring.add_elastic(pos, force);
    }
}

/// Forces of speeds: air, then the elements (N).
pub fn eval_viscous<S: Scalar>(
    body: &Body<S>,
    elements: &Elements<S>,
    pos: &[Vec3<S>],
    vel: &[Vec3<S>],
    force: &mut [Vec3<S>],
) {
    elements.eval_viscous(body.air_drag, pos, vel, force);
}

/// Mean forces over a step (energy-momentum method): gravity and air drag, then the elements (N).
///
/// # Errors
/// As for [`eval_elastic`].
pub fn eval_mean<S: Scalar>(
    body: &Body<S>,
    elements: &Elements<S>,
    way: &MeanStep<S>,
    force: &mut [Vec3<S>],
) -> Result<(), BodyError<S>> {
    for ((f, m), v) in force.iter_mut().zip(body.mass).zip(way.vel) {
        *f = vec3::axpy(vec3::scale(body.gravity, *m), -body.air_drag, *v);
    }
    elements.add_mean(way, force)
}
