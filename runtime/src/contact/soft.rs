//! Soft-ground laws: penalty N = k depth, Hunt-Crossley N = k depth^1.5 (1 + a depth_rate).
//!
//! depth = -gap where the gap is negative. The ground never pulls. Hunt & Crossley (1975).

use super::ground::{ContactLaw, Ground};
use crate::ode::nodes::MeanStep;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Normal force of the ground on one point (N) and the part of it that dissipates (N).
#[must_use]
pub fn normal_force<S: Scalar>(ground: &Ground<S>, x: Vec3<S>, v: Vec3<S>) -> (S, S) {
    let depth = -ground.gap(x);
    if depth <= S::ZERO {
        return (S::ZERO, S::ZERO);
    }
    match ground.law {
        ContactLaw::Penalty { stiffness } => (stiffness * depth, S::ZERO),
        ContactLaw::HuntCrossley { stiffness, dissipation } => {
            let elastic = stiffness * depth * depth.sqrt();
            // Computed directly: as a difference of forces it would be lost in their rounding near rest.
            let viscous = (-(elastic * dissipation * ground.gap_rate(v))).max(-elastic);
            (elastic + viscous, viscous)
        }
        _ => (S::ZERO, S::ZERO),
    }
}

/// Energy stored in the ground by one point (J).
#[must_use]
pub fn energy<S: Scalar>(ground: &Ground<S>, x: Vec3<S>) -> S {
    let depth = (-ground.gap(x)).max(S::ZERO);
    match ground.law {
        ContactLaw::Penalty { stiffness } => S::from_f64(0.5) * stiffness * depth * depth,
        ContactLaw::HuntCrossley { stiffness, .. } => {
            S::from_f64(0.4) * stiffness * depth * depth * depth.sqrt()
        }
        _ => S::ZERO,
    }
}

/// Adds the ground's elastic forces.
pub fn accumulate_elastic<S: Scalar>(ground: &Ground<S>, pos: &[Vec3<S>], force: &mut [Vec3<S>]) {
    if matches!(ground.law, ContactLaw::Penalty { .. } | ContactLaw::HuntCrossley { .. }) {
        for (x, f) in pos.iter().zip(force) {
            let (total, viscous) = normal_force(ground, *x, vec3::zero());
            *f = vec3::axpy(*f, total - viscous, ground.normal);
        }
    }
}

/// Adds the ground's speed-dependent forces.
pub fn accumulate_viscous<S: Scalar>(
    ground: &Ground<S>,
    pos: &[Vec3<S>],
    vel: &[Vec3<S>],
    force: &mut [Vec3<S>],
) {
    if matches!(ground.law, ContactLaw::HuntCrossley { .. }) {
        for ((x, v), f) in pos.iter().zip(vel).zip(force) {
            let (_, viscous) = normal_force(ground, *x, *v);
            *f = vec3::axpy(*f, viscous, ground.normal);
        }
    }
}

/// Adds a soft ground's mean force over a step: -(change of energy)/(change of gap), and its dissipation at the mean
/// rate.
pub fn add_mean<S: Scalar>(ground: &Ground<S>, way: &MeanStep<S>, force: &mut [Vec3<S>]) {
    let [before, _, after] = way.pos;
    let dissipation = match ground.law {
        ContactLaw::Penalty { .. } => S::ZERO,
        ContactLaw::HuntCrossley { dissipation, .. } => dissipation,
        _ => return,
    };
    for ((x0, x1), f) in before.iter().zip(after).zip(force) {
        let sink = ground.gap(*x0) - ground.gap(*x1);
        let gained = energy(ground, *x1) - energy(ground, *x0);
        let elastic = if sink.abs() > S::EPSILON.sqrt() * (S::ONE + ground.gap(*x0).abs()) {
            gained / sink
        } else {
            let middle = vec3::scale(vec3::add(*x0, *x1), S::from_f64(0.5));
            normal_force(ground, middle, vec3::zero()).0
        };
        // Never pulling, so that the force dissipates against a rising point too.
        let push = (elastic * (S::ONE + dissipation * (sink / way.h))).max(S::ZERO);
        *f = vec3::axpy(*f, push, ground.normal);
    }
}
