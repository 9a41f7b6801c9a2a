//! Massless contact points (mass redistribution, Khenous, Laborde & Renard 2008): place from statics.
//!
//! A point of mass 0 rests where its springs balance, on or above the ground: it minimises
//! sum K (|x - x_k| - L)^2/2 with gap >= 0. No inertia, hence no impact and no event: the contact
//! force is continuous. Dampers of its springs must be 0: without inertia its speed is not a state.
//! Gauss-Newton with a small ridge (least motion where a chain leaves directions open), first free,
//! then along the surface if it ended below. Several such points are swept in turn.

use super::Ground;
use crate::body::Body;
use crate::body::vec3::{self, Vec3};
use crate::real::Scalar;

/// Gauss-Newton corrections of one point in one sweep.
const CORRECTIONS: usize = 12;
/// Sweeps over all massless points; one is enough where no spring joins two of them.
const SWEEPS: usize = 30;
/// Ridge relative to the stiffness, in roots of the rounding unit: keeps a chain's open directions in
/// place; its square must stand clear of rounding in the determinant of a single spring.
const RIDGE: f64 = 32.0;

/// Moves every massless point to its balance, starting from where it is.
pub fn settle<S: Scalar>(body: &Body<S>, ground: &Ground<S>, pos: &mut [Vec3<S>]) {
    for _ in 0..SWEEPS {
        let mut largest_move = S::ZERO;
        for (i, mass) in body.mass.iter().enumerate() {
            if *mass == S::ZERO {
                let before = vec3::at(pos, i);
                settle_point(body, ground, pos, i);
                largest_move = largest_move.max(vec3::norm(vec3::sub(vec3::at(pos, i), before)));
            }
        }
        if largest_move <= ground.tolerance {
            return;
        }
    }
}

fn settle_point<S: Scalar>(body: &Body<S>, ground: &Ground<S>, pos: &mut [Vec3<S>], i: usize) {
    for sliding in [false, true] {
        for _ in 0..CORRECTIONS {
            let (force, stiffness) = balance(body, ground, pos, i, sliding);
            let correction = solve(stiffness, force);
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

/// Spring force on point i and sum of K d d^T + ridge, both along the surface only if `sliding`.
fn balance<S: Scalar>(
    body: &Body<S>,
    ground: &Ground<S>,
    pos: &[Vec3<S>],
    i: usize,
    sliding: bool,
) -> (Vec3<S>, [Vec3<S>; 3]) {
    let mut force = vec3::zero();
    let mut stiffness = [vec3::zero(); 3];
    let mut ridge = S::ZERO;
    for spring in body.springs.iter().filter(|s| s.tail == i || s.head == i) {
        let other = if spring.tail == i { spring.head } else { spring.tail };
        let (d, length) = vec3::direction(vec3::sub(vec3::at(pos, other), vec3::at(pos, i)));
        let d = if sliding { vec3::tangential(d, ground.normal) } else { d };
        force = vec3::axpy(force, spring.tension(length), d);
        for (row, component) in stiffness.iter_mut().zip(d) {
            *row = vec3::axpy(*row, spring.stiffness * component, d);
        }
        ridge = ridge + S::from_f64(RIDGE) * S::EPSILON.sqrt() * spring.stiffness;
    }
    stiffness[0][0] = stiffness[0][0] + ridge;
    stiffness[1][1] = stiffness[1][1] + ridge;
    stiffness[2][2] = stiffness[2][2] + ridge;
    (force, stiffness)
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
