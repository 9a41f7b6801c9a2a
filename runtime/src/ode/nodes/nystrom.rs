//! Explicit Runge-Kutta-Nystrom step for x'' = a(x, v), any tableau.
//!
//! k_s = a(x + c_s h v + h^2 sum abar_sj k_j,  v + h sum a_sj k_j)
//! x' = x + h v + h^2 sum bbar_j k_j,  v' = v + h sum b_j k_j

use super::{Motion, Newton, Workspace, movable, set};
use crate::ode::tableau::Tableau;
use crate::real::{Constant, Scalar};
use crate::vec3::{self, Vec3};

/// One step; returns the error estimate in units of `tolerance`.
pub(super) fn step<S: Scalar, N: Newton<S>, const K: usize>(
    tableau: &Tableau<Constant, K>,
    newton: &N,
    start: &Motion<S>,
    h: S,
    tolerance: S,
    work: &mut Workspace<S>,
) -> Result<S, N::Fault> {
    let n = newton.nodes();
    for (s, (abar, a)) in tableau.abar.iter().zip(&tableau.a).enumerate() {
        if s == 0 {
            for (i, k) in work.stages.iter_mut().take(n).enumerate() {
                *k = newton.acceleration(i, start.force(i));
            }
            continue;
        }
        let c = tableau.drift.get(s).map_or(S::ZERO, |c| S::constant(*c));
        for i in 0..n {
            let (x, v) = (vec3::at(start.pos, i), vec3::at(start.vel, i));
            let drift = vec3::axpy(x, h * c, v);
            let bend = weighted(work.stages, n, i, abar, s);
            let kick = weighted(work.stages, n, i, a, s);
            set(work.stage_pos, i, vec3::axpy(drift, h * h, bend));
            set(work.stage_vel, i, vec3::axpy(v, h, kick));
        }
        work.evaluations += 1;
        newton.elastic(work.stage_pos, work.stage_elastic)?;
        newton.viscous(work.stage_pos, work.stage_vel, work.stage_viscous);
        for (i, k) in work.stages.iter_mut().skip(s * n).take(n).enumerate() {
            let force = vec3::add(vec3::at(work.stage_elastic, i), vec3::at(work.stage_viscous, i));
            *k = newton.acceleration(i, force);
        }
    }
    for i in 0..n {
        let v = vec3::at(start.vel, i);
        let bend = weighted(work.stages, n, i, &tableau.bbar, K);
        let kick = weighted(work.stages, n, i, &tableau.b, K);
        set(work.dx, i, vec3::axpy(vec3::scale(movable(newton, i, v), h), h * h, bend));
        set(work.dv, i, vec3::scale(kick, h));
    }
    let error = error_estimate(tableau, start, h, tolerance, work, n);
    work.finish(newton, start)?;
    Ok(error)
}

/// Sum over the first `count` stages of weight_j k_j of node i.
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
fn error_estimate<S: Scalar, const K: usize>(
    tableau: &Tableau<Constant, K>,
    start: &Motion<S>,
    h: S,
    tolerance: S,
    work: &Workspace<S>,
    n: usize,
) -> S {
    if tableau.error.b.iter().all(|e| S::constant(*e) == S::ZERO) {
        return S::ZERO;
    }
    // Finer than rounding no step is, however short (Hairer's DOP853 asks for ten units): it would be shortened in vain.
    let tolerance = tolerance.max(S::from_f64(10.0) * S::EPSILON);
    let (mut fine, mut coarse) = (S::ZERO, S::ZERO);
    for i in 0..n {
        let (x, v) = (vec3::at(start.pos, i), vec3::at(start.vel, i));
        let x_size = tolerance * (S::ONE + vec3::norm(x));
        let v_size = tolerance * (S::ONE + vec3::norm(v));
        let scaled = |bbar: &[Constant; K], b: &[Constant; K]| {
            let in_x = vec3::norm(weighted(work.stages, n, i, bbar, K)) * h * h / x_size;
            let in_v = vec3::norm(weighted(work.stages, n, i, b, K)) * h.abs() / v_size;
            in_x.max(in_v)
        };
        fine = fine.max(scaled(&tableau.error.bbar, &tableau.error.b));
        coarse = coarse.max(scaled(&tableau.coarse.bbar, &tableau.coarse.b));
    }
    let total = (fine * fine + S::from_f64(0.01) * coarse * coarse).sqrt();
    if coarse > S::ZERO && total > S::ZERO { fine * fine / total } else { fine }
}
