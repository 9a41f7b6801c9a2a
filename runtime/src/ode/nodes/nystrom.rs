//! Explicit Runge-Kutta-Nystrom step for x'' = a(x, v) with any tableau.
//!
//! k_s = a(x + c_s h v + h^2 sum abar_sj k_j,  v + h sum a_sj k_j)
//! x' = x + h v + h^2 sum bbar_j k_j,  v' = v + h sum b_j k_j

use super::motion::Motion;
use super::newton::{Newton, movable};
use super::rows;
use super::workspace::Workspace;
use crate::kernel::{self, Kernel};
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
    let (n, is_damped) = (newton.nodes(), newton.is_damped());
    for (s, (abar, a)) in tableau.abar.iter().zip(&tableau.a).enumerate() {
        let forces: [&[Vec3<S>]; 2] = if s == 0 {
            [start.elastic, start.viscous]
        } else {
            let drift = tableau.drift.get(s).map_or(S::ZERO, |c| h * S::constant(*c));
            let weights = [abar.get(..s).unwrap_or_default(), a.get(..s).unwrap_or_default()];
            rows::run(n, Reach { n, start, weights, is_damped, h, drift, work });
            work.evaluations += 1;
            newton.elastic(work.stage_pos, work.stage_elastic)?;
            if is_damped {
                newton.viscous(work.stage_pos, work.stage_vel, work.stage_viscous);
            }
            [work.stage_elastic, if is_damped { work.stage_viscous } else { start.viscous }]
        };
        let out = work.stages.get_mut(s * n..).unwrap_or_default();
        rows::run(n, Accelerate { newton, forces, memory: work.dx, out });
    }
    rows::run(n, Arrive { newton, start, weights: [&tableau.bbar, &tableau.b], h, work });
    let error = error_estimate(tableau, start, h, tolerance, work, n);
    work.finish(newton, start)?;
    Ok(error)
}

/// Accelerations of all nodes under the sum of two forces; `memory` is one row.
struct Accelerate<'a, S, N> {
    newton: &'a N,
    forces: [&'a [Vec3<S>]; 2],
    memory: &'a mut [Vec3<S>],
    out: &'a mut [Vec3<S>],
}

impl<S: Scalar, N: Newton<S>> Kernel for Accelerate<'_, S, N> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Accelerate { newton, forces: [elastic, viscous], memory, out } = self;
        let out = out.get_mut(..newton.nodes()).unwrap_or_default();
        if out.len() < rows::FEW {
            let forces = elastic.iter().zip(viscous);
            for (i, (out, (elastic, viscous))) in out.iter_mut().zip(forces).enumerate() {
                *out = newton.acceleration(i, vec3::add(*elastic, *viscous));
            }
            return;
        }
        for first in rows::blocks(newton.nodes()) {
            let inverse = newton.inverse_masses(first, rows::block_mut(memory, first));
            let out = rows::block_mut(out, first);
            rows::multiply_sum(out, [elastic, viscous].map(|force| rows::block(force, first)), inverse);
            if newton.holds(first, out.len()) {
                newton.admit(first, out);
            }
        }
    }
}

/// Positions of a stage from those before it, and where some force depends on them the velocities; `drift` is c h.
struct Reach<'a, 'm, 'w, S> {
    n: usize,
    start: &'a Motion<'m, S>,
    weights: [&'a [Constant]; 2],
    is_damped: bool,
    h: S,
    drift: S,
    work: &'a mut Workspace<'w, S>,
}

impl<S: Scalar> Kernel for Reach<'_, '_, '_, S> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Reach { n, start, weights: [abar, a], is_damped, h, drift, work } = self;
        let Workspace { stage_pos, stage_vel, stages, .. } = work;
        if n < rows::FEW {
            let starts = start.pos.iter().zip(start.vel.iter());
            for (i, (pos, (x, v))) in stage_pos.iter_mut().zip(starts).enumerate() {
                *pos = vec3::axpy(vec3::axpy(*x, drift, *v), h * h, weigh_node(stages, (n, i), abar));
            }
            if is_damped {
                for (i, (vel, v)) in stage_vel.iter_mut().zip(start.vel.iter()).enumerate() {
                    *vel = vec3::axpy(*v, h, weigh_node(stages, (n, i), a));
                }
            }
            return;
        }
        for first in rows::blocks(n) {
            let [x, v] = [&*start.pos, start.vel].map(|row| rows::block(row, first));
            let pos = rows::block_mut(stage_pos, first);
            weigh(pos, stages, (n, first), abar);
            let starts = x.as_flattened().iter().zip(v.as_flattened());
            for (bend, (x, v)) in pos.as_flattened_mut().iter_mut().zip(starts) {
                *bend = *x + drift * *v + h * h * *bend;
            }
            if is_damped {
                let vel = rows::block_mut(stage_vel, first);
                weigh(vel, stages, (n, first), a);
                for (kick, v) in vel.as_flattened_mut().iter_mut().zip(v.as_flattened()) {
                    *kick = *v + h * *kick;
                }
            }
        }
    }
}

/// Changes of positions and velocities over the step.
struct Arrive<'a, 'm, 'w, S, N> {
    newton: &'a N,
    start: &'a Motion<'m, S>,
    weights: [&'a [Constant]; 2],
    h: S,
    work: &'a mut Workspace<'w, S>,
}

impl<S: Scalar, N: Newton<S>> Kernel for Arrive<'_, '_, '_, S, N> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Arrive { newton, start, weights: [bbar, b], h, work } = self;
        let Workspace { dx, dv, stage_pos, stages, .. } = work;
        let n = newton.nodes();
        if n < rows::FEW {
            for (i, ((dx, dv), v)) in dx.iter_mut().zip(dv.iter_mut()).zip(start.vel.iter()).enumerate() {
                let [bend, kick] = [bbar, b].map(|weights| weigh_node(stages, (n, i), weights));
                *dx = vec3::axpy(movable(newton, i, vec3::scale(*v, h)), h * h, bend);
                *dv = vec3::scale(kick, h);
            }
            return;
        }
        for first in rows::blocks(n) {
            let inverse = newton.inverse_masses(first, rows::block_mut(stage_pos, first));
            let [dx, dv] = [&mut **dx, dv].map(|row| rows::block_mut(row, first));
            weigh(dx, stages, (n, first), bbar);
            weigh(dv, stages, (n, first), b);
            let starts = rows::block(start.vel, first).as_flattened().iter().zip(inverse.as_flattened());
            let ends = dx.as_flattened_mut().iter_mut().zip(dv.as_flattened_mut());
            for ((bend, kick), (v, inverse)) in ends.zip(starts) {
                // A fixed node (inverse mass 0) stays.
                let way = h * *v;
                let way = if *inverse > S::ZERO { way } else { S::ZERO };
                *bend = way + h * h * *bend;
                *kick = *kick * h;
            }
        }
    }
}

/// Sums of weight_j k_j over as many stages as there are weights, for a block of the n nodes. Not inlined on a
/// microcontroller: its flash then holds it once.
#[cfg_attr(target_os = "none", inline(never))]
#[cfg_attr(not(target_os = "none"), inline(always))]
fn weigh<S: Scalar>(
    sums: &mut [Vec3<S>],
    stages: &[Vec3<S>],
    (n, first): (usize, usize),
    weights: &[Constant],
) {
    sums.as_flattened_mut().fill(S::ZERO);
    for (stage, weight) in stages.chunks_exact(n.max(1)).zip(weights) {
        let weight = S::constant(*weight);
        if weight != S::ZERO {
            rows::add_scaled(sums, weight, rows::block(stage, first));
        }
    }
}

/// The same for one of few nodes, which stays in registers.
#[inline(always)]
fn weigh_node<S: Scalar>(stages: &[Vec3<S>], (n, node): (usize, usize), weights: &[Constant]) -> Vec3<S> {
    let (mut sum, mut place) = (vec3::zero(), node);
    for weight in weights {
        let Some(k) = stages.get(place) else { break };
        sum = vec3::axpy(sum, S::constant(*weight), *k);
        place += n;
    }
    sum
}

/// Largest estimated error over (tolerance (1 + |y|)), y node by node; combined as in Hairer's DOP853 where two
/// estimates exist.
fn error_estimate<S: Scalar, const K: usize>(
    tableau: &Tableau<Constant, K>,
    start: &Motion<S>,
    h: S,
    tolerance: S,
    work: &mut Workspace<S>,
    n: usize,
) -> S {
    // No step, however short, is more accurate than rounding (Hairer's DOP853 asks for ten units): a finer tolerance
    // would fail.
    let tolerance = tolerance.max(S::from_f64(10.0) * S::EPSILON);
    let estimate = |[bbar, b]: [&[Constant; K]; 2], work: &mut Workspace<S>| {
        if b.iter().all(|e| S::constant(*e) == S::ZERO) {
            return S::ZERO;
        }
        kernel::run(Estimate { n, start, weights: [bbar, b], h, tolerance, work })
    };
    let fine = estimate([&tableau.error.bbar, &tableau.error.b], work);
    let coarse = estimate([&tableau.coarse.bbar, &tableau.coarse.b], work);
    let total = (fine * fine + S::from_f64(0.01) * coarse * coarse).sqrt();
    if coarse > S::ZERO && total > S::ZERO { fine * fine / total } else { fine }
}

/// Largest ratio over all nodes of one error estimate to the error allowed, given the weights of the stages in the
/// estimate.
struct Estimate<'a, 'm, 'w, S> {
    n: usize,
    start: &'a Motion<'m, S>,
    weights: [&'a [Constant]; 2],
    h: S,
    tolerance: S,
    work: &'a mut Workspace<'w, S>,
}

impl<S: Scalar> Kernel for Estimate<'_, '_, '_, S> {
    type Output = S;

    #[inline(always)]
    fn run(self) -> S {
        let Estimate { n, start, weights: [bbar, b], h, tolerance, work } = self;
        let Workspace { stage_pos, stage_vel, stages, .. } = work;
        let mut largest = S::ZERO;
        for first in rows::blocks(n) {
            let [in_x, in_v] = [&mut **stage_pos, stage_vel].map(|row| rows::block_mut(row, first));
            weigh(in_x, stages, (n, first), bbar);
            weigh(in_v, stages, (n, first), b);
            let errors = in_x.iter().zip(in_v.iter());
            let states = rows::block(start.pos, first).iter().zip(rows::block(start.vel, first));
            for ((in_x, in_v), (x, v)) in errors.zip(states) {
                let [x, v] = [x, v].map(|y| tolerance * (S::ONE + vec3::norm(*y)));
                let (in_x, in_v) = (vec3::norm(*in_x) * h * h / x, vec3::norm(*in_v) * h.abs() / v);
                largest = largest.max(in_x.max(in_v));
            }
        }
        largest
    }
}
