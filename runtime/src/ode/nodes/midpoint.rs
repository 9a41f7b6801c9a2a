//! Implicit midpoint rule, and the energy-momentum method built on it.
//!
//! x' = x + h v + h^2/2 k,  v' = v + h k,  k = f/m, f at the middle of the step. In the energy-momentum form (Simo &
//! Tarnow 1992, Gonzalez 1996) f is a mean force whose work is the change of the stored energy ([`Newton::mean_force`]):
//! undamped energy stays, damped energy never rises, for any step; momentum and angular momentum stay.
//! Solved by fixed-point iteration (h w_max < 2).

use super::{Motion, Newton, NodeFault, Way, Workspace, rows, set};
use crate::kernel::{self, Kernel};
use crate::real::Scalar;
use crate::vec3;

/// Iterations at most: at h w = 1 each gains a factor 4, so 30 reach the rounding of f64.
const ITERATIONS: usize = 200;
/// Changes of the acceleration below this many rounding units end the iteration.
const SETTLED: f64 = 2.0;
/// Iterations without gain that end it near the solution. Near a fold, where the solution is about to vanish, the changes
/// shrink before they grow again: one iteration without gain says nothing there.
const PATIENCE: u32 = 16;
/// Rounding units of acceleration that positions may hand on: below them one iteration without gain is enough.
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
        let way = Way { h, pos, dx: work.dx, vel: work.stage_vel };
        newton.mean_force(&way, work.stage_elastic)
    })
}

/// Solves k = force(middle of the step)/m; `force` leaves its answer in `work.stage_elastic`.
///
/// `stage_pos`, `stage_vel` hold the middle, `end.pos` the end of the step, `dx` the change of position.
fn iterate<S: Scalar, N: Newton<S>>(
    newton: &N,
    start: &Motion<S>,
    h: S,
    work: &mut Workspace<S>,
    force: impl Fn(&mut Workspace<S>) -> Result<(), N::Fault>,
) -> Result<(), N::Fault> {
    let n = newton.nodes();
    for i in 0..n {
        set(work.stages, i, newton.acceleration(i, start.force(i)));
    }
    let unit_strain = newton.acceleration_of_unit_strain();
    let (mut smallest, mut without_gain) = (None, 0_u32);
    for _ in 0..ITERATIONS {
        kernel::run(PlaceMiddle { newton, start, h, work });
        work.evaluations += 1;
        force(work)?;
        let (mut change, mut size) = (S::ZERO, S::ZERO);
        for i in 0..n {
            let k = newton.acceleration(i, vec3::at(work.stage_elastic, i));
            change = change.max(vec3::norm(vec3::sub(k, vec3::at(work.stages, i))));
            size = size.max(vec3::norm(k));
            set(work.stages, i, k);
        }
        let rounding = S::from_f64(SETTLED) * S::EPSILON * size;
        // Once near, no further gain is the end: the last digits of k keep moving.
        let scale = size + unit_strain;
        if smallest.is_some_and(|smallest| change >= smallest) {
            without_gain += 1;
        } else {
            (smallest, without_gain) = (Some(change), 0);
        }
        let patience = if change <= S::from_f64(ROUNDED) * S::EPSILON * scale { 1 } else { PATIENCE };
        let stalled = change <= S::EPSILON.sqrt() * scale && without_gain >= patience;
        if change <= rounding || stalled {
            kernel::run(PlaceMiddle { newton, start, h, work });
            for i in 0..n {
                set(work.dv, i, vec3::scale(vec3::at(work.stages, i), h));
            }
            return work.finish(newton, start);
        }
    }
    Err(NodeFault::NotConverged { step: h }.into())
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
                // A node that no force moves stays.
                *step = if *inverse > S::ZERO { way } else { S::ZERO };
                *pos = *x + half * *step;
                *end = *x + *step;
                *vel = *v + half * h * *k;
            }
        }
    }
}
