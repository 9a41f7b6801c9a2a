//! Explicit Runge-Kutta-Nystrom step for x'' = a(x, v), any tableau.
//!
//! k_s = a(x + c_s h v + h^2 sum abar_sj k_j,  v + h sum a_sj k_j)
//! x' = x + h v + h^2 sum bbar_j k_j,  v' = v + h sum b_j k_j

use super::{Start, Workspace, eval_elastic, eval_viscous, finish};
use crate::contact::System;
use crate::flexible::BodyError;
use crate::ode::tableau::Tableau;
use crate::real::{Constant, Scalar};
use crate::vec3::{self, Vec3};

/// One step; returns the error estimate in units of `tolerance`.
pub(crate) fn step<S: Scalar, const N: usize>(
    tableau: &Tableau<Constant, N>,
    system: &System<S>,
    start: Start<S>,
    h: S,
    tolerance: S,
    work: &mut Workspace<S>,
) -> Result<S, BodyError<S>> {
    let n = system.body.points();
    for (s, (abar, a)) in tableau.abar.iter().zip(&tableau.a).enumerate() {
        if s == 0 {
            for (i, k) in work.stages.iter_mut().take(n).enumerate() {
                *k = system.acceleration(i, start.mode(i), start.motion.force(i));
            }
            continue;
        }
        let c = tableau.drift.get(s).map_or(S::ZERO, |c| S::constant(*c));
        for i in 0..n {
            let (x, v) = (vec3::at(start.motion.pos, i), vec3::at(start.motion.vel, i));
            let drift = vec3::axpy(x, h * c, v);
            let bend = weighted(work.stages, n, i, abar, s);
            let kick = weighted(work.stages, n, i, a, s);
            set(work.stage_pos, i, vec3::axpy(drift, h * h, bend));
            set(work.stage_vel, i, vec3::axpy(v, h, kick));
        }
        work.evaluations += 1;
        eval_elastic(system, work.stage_pos, work.stage_elastic)?;
        eval_viscous(system, work.stage_pos, work.stage_vel, work.stage_viscous);
        for (i, k) in work.stages.iter_mut().skip(s * n).take(n).enumerate() {
            let force = vec3::add(vec3::at(work.stage_elastic, i), vec3::at(work.stage_viscous, i));
            *k = system.acceleration(i, start.mode(i), force);
        }
    }
    for i in 0..n {
        let v = vec3::at(start.motion.vel, i);
        let bend = weighted(work.stages, n, i, &tableau.bbar, N);
        let kick = weighted(work.stages, n, i, &tableau.b, N);
        set(work.dx, i, vec3::axpy(vec3::scale(moving(system, i, v), h), h * h, bend));
        set(work.dv, i, vec3::scale(kick, h));
    }
    let error = error_estimate(tableau, start, h, tolerance, work, n);
    finish(system, start, work)?;
    Ok(error)
}

/// The velocity with which a point drifts: a fixed one goes nowhere.
fn moving<S: Scalar>(system: &System<S>, i: usize, v: Vec3<S>) -> Vec3<S> {
    if system.body.inverse_mass(i) > S::ZERO { v } else { vec3::zero() }
}

fn set<S: Scalar>(rows: &mut [Vec3<S>], i: usize, value: Vec3<S>) {
    if let Some(row) = rows.get_mut(i) {
        *row = value;
    }
}

/// Sum over the first `count` stages of weight_j k_j of point i.
fn weighted<S: Scalar>(
    stages: &[Vec3<S>],
    n: usize,
    i: usize,
    weights: &[Constant],
    count: usize,
) -> Vec3<S> {
    let mut sum = vec3::zero();
    for (stage, weight) in stages.chunks_exact(n).zip(weights).take(count) {
        let weight = S::constant(*weight);
        if weight != S::ZERO {
            sum = vec3::axpy(sum, weight, vec3::at(stage, i));
        }
    }
    sum
}

/// Largest component of the estimated error over (tolerance (1 + |y|)); Hairer's combination where two estimates exist.
fn error_estimate<S: Scalar, const N: usize>(
    tableau: &Tableau<Constant, N>,
    start: Start<S>,
    h: S,
    tolerance: S,
    work: &Workspace<S>,
    n: usize,
) -> S {
    if tableau.error.b.iter().all(|e| S::constant(*e) == S::ZERO) {
        return S::ZERO;
    }
    let (mut fine, mut coarse) = (S::ZERO, S::ZERO);
    for i in 0..n {
        let (x, v) = (vec3::at(start.motion.pos, i), vec3::at(start.motion.vel, i));
        let x_size = tolerance * (S::ONE + vec3::norm(x));
        let v_size = tolerance * (S::ONE + vec3::norm(v));
        let scaled = |bbar: &[Constant; N], b: &[Constant; N]| {
            let in_x = vec3::norm(weighted(work.stages, n, i, bbar, N)) * h * h / x_size;
            let in_v = vec3::norm(weighted(work.stages, n, i, b, N)) * h.abs() / v_size;
            in_x.max(in_v)
        };
        fine = fine.max(scaled(&tableau.error.bbar, &tableau.error.b));
        coarse = coarse.max(scaled(&tableau.coarse.bbar, &tableau.coarse.b));
    }
    let total = (fine * fine + S::from_f64(0.01) * coarse * coarse).sqrt();
    if coarse > S::ZERO && total > S::ZERO { fine * fine / total } else { fine }
}
