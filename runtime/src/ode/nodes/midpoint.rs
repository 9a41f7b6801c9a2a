//! Implicit midpoint rule, and the energy-momentum method built on it.
//!
//! x' = x + h v + h^2/2 k,  v' = v + h k,  k = f/m, f at the middle of the step. In the energy-momentum form (Simo &
//! Tarnow 1992, Gonzalez 1996) f is a mean force whose work is the change of the stored energy ([`Newton::mean_force`]):
//! undamped energy stays, damped energy never rises, for any step; momentum and angular momentum stay.
//! Solved by fixed-point iteration (h w_max < 2).

use super::{Motion, Newton, NodeFault, Way, Workspace, movable, set};
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
        place_middle(newton, start, h, work);
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
            place_middle(newton, start, h, work);
            for i in 0..n {
                set(work.dv, i, vec3::scale(vec3::at(work.stages, i), h));
            }
            return work.finish(newton, start);
        }
    }
    Err(NodeFault::NotConverged { step: h }.into())
}

/// Middle and end of the step from the accelerations k.
fn place_middle<S: Scalar>(newton: &impl Newton<S>, start: &Motion<S>, h: S, work: &mut Workspace<S>) {
    let half = S::from_f64(0.5);
    for i in 0..newton.nodes() {
        let (x, v) = (vec3::at(start.pos, i), vec3::at(start.vel, i));
        let k = vec3::at(work.stages, i);
        let step = movable(newton, i, vec3::axpy(vec3::scale(v, h), half * h * h, k));
        set(work.dx, i, step);
        set(work.stage_pos, i, vec3::axpy(x, half, step));
        set(work.end.pos, i, vec3::add(x, step));
        set(work.stage_vel, i, vec3::axpy(v, half * h, k));
    }
}
