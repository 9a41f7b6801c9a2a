//! Massless contact points (mass redistribution, Khenous, Laborde & Renard 2008): place from statics.
//!
//! A point of mass 0 rests where its springs balance, on or above the ground: it minimises
//! sum K (|x - x_k| - L)^2/2 with gap >= 0. No inertia, hence no impact and no event: the contact
//! force is continuous. Dampers of its springs must be 0: without inertia its speed is not a state.
//! Newton's method where the stiffness is positive definite, else Gauss-Newton; a small ridge means least
//! motion where a chain leaves directions open. First free, then along the surface if it ended below. Several such points are swept in turn.
//! Without inertia a point has no momentum that friction could take, so the law is one without friction.

use super::Ground;
use crate::flexible::{Body, Spring};
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Corrections of one point in one sweep.
const CORRECTIONS: usize = 30;
/// Sweeps over all massless points; one is enough where no spring joins two of them.
const SWEEPS: usize = 30;
/// Ridge relative to the stiffness, in roots of the rounding unit: keeps a chain's open directions in
/// place; its square must stand clear of rounding in the determinant of a single spring.
const RIDGE: f64 = 32.0;

/// Moves every massless point to its balance, starting from where it is.
pub fn settle<S: Scalar>(body: &Body<S>, ground: &Ground<S>, pos: &mut [Vec3<S>]) {
    for _ in 0..SWEEPS {
        let mut largest_move = S::ZERO;
        for (i, springs) in body.massless.iter() {
            let before = vec3::at(pos, i);
            settle_point(body, springs, ground, pos, i);
            largest_move = largest_move.max(vec3::norm(vec3::sub(vec3::at(pos, i), before)));
        }
        if largest_move <= ground.tolerance {
            return;
        }
    }
}

fn settle_point<S: Scalar>(
    body: &Body<S>,
    springs: &[usize],
    ground: &Ground<S>,
    pos: &mut [Vec3<S>],
    i: usize,
) {
    for sliding in [false, true] {
        for _ in 0..CORRECTIONS {
            let springs = springs.iter().filter_map(|s| body.springs.get(*s));
            let (force, stiffness) = balance(springs, ground, pos, i, sliding);
            let correction = solve(stiffness, force);
            let correction = if sliding { vec3::tangential(correction, ground.normal) } else { correction };
            vec3::add_at(pos, i, correction);
            if vec3::norm(correction) <= S::EPSILON * (S::ONE + vec3::norm(vec3::at(pos, i))) {
                break;
            }
        }
        let gap = ground.gap(vec3::at(pos, i));
        if gap >= S::ZERO {
            return;
        }
        vec3::add_at(pos, i, vec3::scale(ground.normal, -gap));
    }
}

/// Spring force on point i and its stiffness, both along the surface only if `sliding`: the sum of
/// K d d^T + K (1 - L/l) (1 - d d^T) + ridge, or without its second term where that leaves it indefinite.
fn balance<'s, S: Scalar>(
    springs: impl Iterator<Item = &'s Spring<S>>,
    ground: &Ground<S>,
    pos: &[Vec3<S>],
    i: usize,
    sliding: bool,
) -> (Vec3<S>, [Vec3<S>; 3]) {
    let mut force = vec3::zero();
    let mut stiffness = [vec3::zero(); 3];
    let mut exact = [vec3::zero(); 3];
    let mut ridge = S::ZERO;
    for spring in springs {
        let other = if spring.tail == i { spring.head } else { spring.tail };
        let (d, length) = vec3::direction(vec3::sub(vec3::at(pos, other), vec3::at(pos, i)));
        let d = if sliding { vec3::tangential(d, ground.normal) } else { d };
        force = vec3::axpy(force, spring.tension(length), d);
        let across = if length > S::ZERO { spring.tension(length) / length } else { S::ZERO };
        let axes = [[S::ONE, S::ZERO, S::ZERO], [S::ZERO, S::ONE, S::ZERO], [S::ZERO, S::ZERO, S::ONE]];
        let rows = stiffness.iter_mut().zip(exact.iter_mut()).zip(axes.iter().zip(d));
        for ((row, exact), (axis, component)) in rows {
            *row = vec3::axpy(*row, spring.stiffness * component, d);
            let axis = if sliding { vec3::tangential(*axis, ground.normal) } else { *axis };
            *exact = vec3::axpy(*exact, (spring.stiffness - across) * component, d);
            *exact = vec3::axpy(*exact, across, axis);
        }
        ridge = ridge + S::from_f64(RIDGE) * S::EPSILON.sqrt() * spring.stiffness;
    }
    let ridged = |mut a: [Vec3<S>; 3]| {
        a[0][0] = a[0][0] + ridge;
        a[1][1] = a[1][1] + ridge;
        a[2][2] = a[2][2] + ridge;
        a
    };
    if sliding {
        // Along the normal nothing may move: any stiffness there keeps the solution well conditioned.
        let across = ridge / (S::from_f64(RIDGE) * S::EPSILON.sqrt());
        let rows = stiffness.iter_mut().zip(exact.iter_mut()).zip(ground.normal);
        for ((row, exact), component) in rows {
            *row = vec3::axpy(*row, across * component, ground.normal);
            *exact = vec3::axpy(*exact, across * component, ground.normal);
        }
    }
    let exact = ridged(exact);
    (force, if is_positive_definite(&exact) { exact } else { ridged(stiffness) })
}

/// By Sylvester's criterion.
fn is_positive_definite<S: Scalar>(a: &[Vec3<S>; 3]) -> bool {
    let minors = vec3::cross(a[1], a[2]);
    a[0][0] > S::ZERO && a[0][0] * a[1][1] - a[0][1] * a[1][0] > S::ZERO && vec3::dot(a[0], minors) > S::ZERO
}

/// Solves the symmetric 3 x 3 system by Cramer's rule; 0 where it has no solution.
fn solve<S: Scalar>(a: [Vec3<S>; 3], b: Vec3<S>) -> Vec3<S> {
    let minors = [vec3::cross(a[1], a[2]), vec3::cross(a[2], a[0]), vec3::cross(a[0], a[1])];
    let determinant = vec3::dot(a[0], minors[0]);
    if determinant == S::ZERO {
        return vec3::zero();
    }
    let sum = vec3::axpy(vec3::axpy(vec3::scale(minors[0], b[0]), b[1], minors[1]), b[2], minors[2]);
    vec3::scale(sum, S::ONE / determinant)
}
