//! Implicit midpoint rule, and the energy-momentum method built on it.
//!
//! x' = x + h v + h^2/2 k,  v' = v + h k,  k = f/m, f at the middle of the step. In the energy-momentum form (Simo &
//! Tarnow 1992, Gonzalez 1996) f is a mean force whose work is the change of the stored energy
//! ([`Newton::mean_force`]): for any step, energy is conserved without damping and never rises with it; linear and
//! angular momentum are conserved. Solved by fixed-point iteration (h w_max < 2) with Anderson's acceleration
//! (`anderson`).

use super::anderson::Anderson;
use super::motion::Motion;
use super::newton::{MeanStep, Newton, NodeFault};
use super::rows;
use super::workspace::Workspace;
use crate::kernel::{self, Kernel};
use crate::real::Scalar;
use crate::vec3;

/// Most iterations: at h w = 1 each reduces the error about sixfold, so 20 reach the rounding of f64.
const ITERATIONS: usize = 200;
/// An error of the acceleration below this many rounding units ends the iteration.
const SETTLED: f64 = 2.0;
/// Lower bound on the estimated convergence rate: the error that an iteration leaves of the one before.
const LEAST_RATE: f64 = 1.0 / 16.0;
/// Iterations without gain after which it ends near the solution. Near a fold, where the solution is about to vanish,
/// the changes shrink before they grow again, so one iteration without gain proves nothing there.
const PATIENCE: u32 = 16;
/// Rounding units of acceleration that the rounding of positions may cause: below them one iteration without gain is
/// enough.
const ROUNDED: f64 = 1e3;

/// The plain midpoint rule.
pub(super) fn midpoint<S: Scalar, N: Newton<S>>(
    newton: &N,
    start: &Motion<S>,
    h: S,
    work: &mut Workspace<S>,
) -> Result<(), N::Fault> {
    iterate(newton, start, h, work, |work| {
        newton.elastic(work.stage_pos, work.stage_elastic)?;
        newton.viscous(work.stage_pos, work.stage_vel, work.stage_viscous);
        for (sum, viscous) in work.stage_elastic.iter_mut().zip(work.stage_viscous.iter()) {
            *sum = vec3::add(*sum, *viscous);
        }
        Ok(())
    })
}

/// The energy-momentum method.
pub(super) fn energy_momentum<S: Scalar, N: Newton<S>>(
    newton: &N,
    start: &Motion<S>,
    h: S,
    work: &mut Workspace<S>,
) -> Result<(), N::Fault> {
    iterate(newton, start, h, work, |work| {
        let pos = [&*start.pos, &*work.stage_pos, &*work.end.pos];
        let way = MeanStep { h, pos, dx: work.dx, vel: work.stage_vel };
        newton.mean_force(&way, work.stage_elastic)
    })
}

/// Solves k = force(middle of the step)/m; `force` leaves its result in `work.stage_elastic`.
///
/// `stage_pos`, `stage_vel` hold the middle, `end.pos` the end of the step, `dx` the change of position, `stages` k.
/// The [`Anderson`] of the iteration before uses rows of the end of the step that are not needed yet.
fn iterate<S: Scalar, N: Newton<S>>(
    newton: &N,
    start: &Motion<S>,
    h: S,
    work: &mut Workspace<S>,
    force: impl Fn(&mut Workspace<S>) -> Result<(), N::Fault>,
) -> Result<(), N::Fault> {
    for i in 0..newton.nodes() {
        vec3::set_at(work.stages, i, newton.acceleration(i, start.force(i)));
    }
    let (mut smallest, mut without_gain, mut before) = (None, 0_u32, None);
    for _ in 0..ITERATIONS {
        kernel::run(PlaceMiddle { newton, start, h, work });
        work.evaluations += 1;
        force(work)?;
        let Workspace { end, dx, dv, stage_elastic, stages, .. } = work;
        let mut anderson =
            Anderson { k: stages, residual: end.elastic, residual_change: end.pos_rest, last_g: end.vel };
        let [change, size] = anderson.improve(newton, stage_elastic, [dx, dv]);
        if smallest.is_some_and(|smallest| change >= smallest) {
            without_gain += 1;
        } else {
            (smallest, without_gain) = (Some(change), 0);
        }
        // Estimated change by the next iteration.
        let rate = before.map_or(S::ONE, |before| change / before).max(S::from_f64(LEAST_RATE)).min(S::ONE);
        let settled = change * rate <= S::from_f64(SETTLED) * S::EPSILON * size;
        if settled || has_stalled(newton, [change, size], without_gain) {
            kernel::run(PlaceMiddle { newton, start, h, work });
            for (dv, k) in work.dv.iter_mut().zip(work.stages.iter()) {
                *dv = vec3::scale(*k, h);
            }
            return work.finish(newton, start);
        }
        anderson.extrapolate(before.is_none());
        before = Some(change);
    }
    Err(NodeFault::NotConverged { step: h }.into())
}

/// Whether an iteration near the solution has gained nothing for a while: the last digits of k keep moving.
fn has_stalled<S: Scalar>(newton: &impl Newton<S>, [change, size]: [S; 2], without_gain: u32) -> bool {
    if without_gain == 0 {
        return false;
    }
    let scale = size + newton.acceleration_of_unit_strain();
    let patience = if change <= S::from_f64(ROUNDED) * S::EPSILON * scale { 1 } else { PATIENCE };
    change <= S::EPSILON.sqrt() * scale && without_gain >= patience
}

/// Middle and end of the step from the accelerations k.
struct PlaceMiddle<'a, 'm, 'w, S, N> {
    newton: &'a N,
    start: &'a Motion<'m, S>,
    h: S,
    work: &'a mut Workspace<'w, S>,
}

impl<S: Scalar, N: Newton<S>> Kernel for PlaceMiddle<'_, '_, '_, S, N> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let PlaceMiddle { newton, start, h, work } = self;
        let Workspace { end, dx, dv, stage_pos, stage_vel, stages, .. } = work;
        let half = S::from_f64(0.5);
        for first in rows::blocks(newton.nodes()) {
            let inverse = newton.inverse_masses(first, rows::block_mut(dv, first)).as_flattened().iter();
            let [x, v, k] =
                [&*start.pos, start.vel, stages].map(|row| rows::block(row, first).as_flattened().iter());
            let [step, pos, end, vel] = [&mut **dx, stage_pos, end.pos, stage_vel]
                .map(|row| rows::block_mut(row, first).as_flattened_mut().iter_mut());
            for (((x, v), (k, inverse)), ((step, pos), (end, vel))) in
                x.zip(v).zip(k.zip(inverse)).zip(step.zip(pos).zip(end.zip(vel)))
            {
                let way = h * *v + half * h * h * *k;
                // A fixed node (inverse mass 0) stays.
                *step = if *inverse > S::ZERO { way } else { S::ZERO };
                *pos = *x + half * *step;
                *end = *x + *step;
                *vel = *v + half * h * *k;
            }
        }
    }
}
