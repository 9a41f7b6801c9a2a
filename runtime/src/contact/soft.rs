//! A soft ground: each point below its surface is pushed by a [`ForceLaw`](super::force::ForceLaw) on its depth, -gap. The ground never pulls.

use super::ground::{ContactLaw, Ground};
use crate::ode::nodes::MeanStep;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Normal force of the ground on one point (N) and the part of it that dissipates (N).
#[must_use]
pub fn normal_force<S: Scalar>(ground: &Ground<S>, x: Vec3<S>, v: Vec3<S>) -> (S, S) {
    match ground.law {
        ContactLaw::Force(law) => law.force(-ground.gap(x), -ground.gap_rate(v)),
        _ => (S::ZERO, S::ZERO),
    }
}

/// Energy stored in the ground by one point (J).
#[must_use]
pub fn energy<S: Scalar>(ground: &Ground<S>, x: Vec3<S>) -> S {
    match ground.law {
        ContactLaw::Force(law) => law.energy(-ground.gap(x)),
        _ => S::ZERO,
    }
}

/// Adds the ground's elastic forces.
pub fn accumulate_elastic<S: Scalar>(ground: &Ground<S>, pos: &[Vec3<S>], force: &mut [Vec3<S>]) {
    if !ground.is_rigid() {
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
    if ground.is_damped() {
        for ((x, v), f) in pos.iter().zip(vel).zip(force) {
            let (_, viscous) = normal_force(ground, *x, *v);
            *f = vec3::axpy(*f, viscous, ground.normal);
        }
    }
}

/// Adds a soft ground's mean force over a step: -(change of energy)/(change of gap), and its dissipation at the mean
/// rate.
pub fn add_mean<S: Scalar>(ground: &Ground<S>, way: &MeanStep<S>, force: &mut [Vec3<S>]) {
    let ContactLaw::Force(law) = ground.law else { return };
    let [before, _, after] = way.pos;
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
        let push = (elastic * (S::ONE + law.dissipation() * (sink / way.h))).max(S::ZERO);
        *f = vec3::axpy(*f, push, ground.normal);
    }
}
