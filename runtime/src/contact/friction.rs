//! Coulomb friction as an impulse: the tangential speed loses at most mu J/m, and the energy loss is exact.
//!
//! f = min(1, mu J/(m |v_t|)); v_t := (1 - f) v_t; loss = m |v_t|^2 (1 - (1-f)^2)/2.
//! f = 1 leaves no tangential speed: the point sticks. Over a stretch of motion the impulse opposes the mean of the
//! slip directions at both ends, v' = v - mu J/m (d0 + d1)/|d0 + d1|, of order 2 on a curved path; or, where it could
//! stop the slip within the stretch, the direction at the end.

use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Slows the tangential part of v by the friction of a normal impulse J (N s); returns the energy lost (J).
pub fn apply<S: Scalar>(v: &mut Vec3<S>, normal: Vec3<S>, mass: S, coefficient: S, impulse: S) -> S {
    let slip = vec3::tangential(*v, normal);
    let speed = vec3::norm(slip);
    let largest = coefficient * impulse;
    if speed <= S::ZERO || largest <= S::ZERO || mass <= S::ZERO {
        return S::ZERO;
    }
    let kinetic = S::from_f64(0.5) * mass * speed * speed;
    if largest >= mass * speed {
        *v = vec3::sub(*v, slip);
        return kinetic;
    }
    let fraction = largest / (mass * speed);
    *v = vec3::axpy(*v, -fraction, slip);
    kinetic * fraction * (S::from_f64(2.0) - fraction)
}

/// As [`apply`], over a stretch of motion that started with the velocity `before`, along the mean direction of slip.
///
/// Friction turns slip at the rate mu N/(m |v_t|). If it could stop the slip within the stretch, the mean would carry
/// it past the direction of the driving force and make speed: there it acts against the slip after the stretch.
pub fn apply_over<S: Scalar>(
    v: &mut Vec3<S>,
    before: Vec3<S>,
    normal: Vec3<S>,
    mass: S,
    coefficient: S,
    impulse: S,
) -> S {
    let (first, start) = vec3::direction(vec3::tangential(before, normal));
    let (last, speed) = vec3::direction(vec3::tangential(*v, normal));
    let (mean, length) = vec3::direction(vec3::add(first, last));
    let largest = coefficient * impulse;
    if length <= S::ZERO || mass <= S::ZERO || largest >= mass * speed.min(start) {
        return apply(v, normal, mass, coefficient, impulse);
    }
    let change = largest / mass;
    // m dv.(v + dv/2): positive unless the slip reverses, which ends a stretch.
    let loss = largest * (vec3::dot(mean, *v) - S::from_f64(0.5) * change);
    if loss <= S::ZERO {
        return apply(v, normal, mass, coefficient, impulse);
    }
    *v = vec3::axpy(*v, -change, mean);
    loss
}
