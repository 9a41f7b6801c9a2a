//! Implicit midpoint rule, and the energy-momentum method built on it.
//!
//! x' = x + h v + h^2/2 k,  v' = v + h k,  k = f/m, f at the middle of the step. In the energy-momentum
//! form (Simo & Tarnow 1992, Gonzalez 1996) each spring pulls with its mean tension along its mean
//! direction: f = [K ((l + l')/2 - L) + C (l' - l)/h] (d + d')/(l + l'). Its work over the step is then
//! exactly -K [(l'-L)^2 - (l-L)^2]/2 - C (l'-l)^2/h: undamped energy stays, damped energy never rises,
//! for any step; momentum and angular momentum stay. Solved by fixed-point iteration (h w_max < 2).

use super::{Start, Workspace, eval_elastic, eval_viscous, finish};
use crate::contact::{ContactLaw, Ground, System, soft};
use crate::flexible::pressure::{self, Gas};
use crate::flexible::{Body, BodyError};
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Iterations at most: at h w = 1 each gains a factor 4, so 30 reach the rounding of f64.
const ITERATIONS: usize = 200;
/// Changes of the acceleration below this many rounding units end the iteration.
const SETTLED: f64 = 2.0;

/// The plain midpoint rule.
pub(crate) fn midpoint<S: Scalar>(
    system: &System<S>,
    start: Start<S>,
    h: S,
    work: &mut Workspace<S>,
) -> Result<S, BodyError<S>> {
    iterate(system, start, h, work, |system, _, _, work| {
        eval_elastic(system, work.stage_pos, work.stage_elastic)?;
        eval_viscous(system, work.stage_pos, work.stage_vel, work.stage_viscous);
        for (sum, viscous) in work.stage_elastic.iter_mut().zip(work.stage_viscous.iter()) {
            *sum = vec3::add(*sum, *viscous);
        }
        Ok(())
    })
}

/// The energy-momentum method.
pub(crate) fn energy_momentum<S: Scalar>(
    system: &System<S>,
    start: Start<S>,
    h: S,
    work: &mut Workspace<S>,
) -> Result<S, BodyError<S>> {
    iterate(system, start, h, work, mean_force)
}

/// Solves k = force(middle of the step)/m; `force` leaves its answer in `work.stage_elastic`.
///
/// `stage_pos`, `stage_vel` hold the middle, `end.pos` the end of the step, `dx` the change of position.
fn iterate<S: Scalar>(
    system: &System<S>,
    start: Start<S>,
    h: S,
    work: &mut Workspace<S>,
    force: impl Fn(&System<S>, Start<S>, S, &mut Workspace<S>) -> Result<(), BodyError<S>>,
) -> Result<S, BodyError<S>> {
    let n = system.body.points();
    for i in 0..n {
        let k = system.acceleration(i, start.mode(i), start.motion.force(i));
        set(work.stages, i, k);
    }
    // Rounding of the positions moves k by about EPSILON times this, also where all forces balance.
    let unit_strain = (system.body.springs.iter()).fold(S::ZERO, |largest, s| {
        let inverse = system.body.inverse_mass(s.tail).max(system.body.inverse_mass(s.head));
        largest.max(s.stiffness * s.rest_length * inverse)
    });
    let mut last_change = None;
    for _ in 0..ITERATIONS {
        place_middle(system, start, h, work);
        work.evaluations += 1;
        force(system, start, h, work)?;
        let (mut change, mut size) = (S::ZERO, S::ZERO);
        for i in 0..n {
            let k = system.acceleration(i, start.mode(i), vec3::at(work.stage_elastic, i));
            change = change.max(vec3::norm(vec3::sub(k, vec3::at(work.stages, i))));
            size = size.max(vec3::norm(k));
            set(work.stages, i, k);
        }
        let rounding = S::from_f64(SETTLED) * S::EPSILON * size;
        // Once near, no further gain is the end: the last digits of k keep moving.
        let near = S::EPSILON.sqrt() * (size + unit_strain);
        let stalled = change <= near && last_change.is_some_and(|last| change >= last);
        if change <= rounding || stalled {
            place_middle(system, start, h, work);
            for i in 0..n {
                set(work.dv, i, vec3::scale(vec3::at(work.stages, i), h));
            }
            finish(system, start, work)?;
            return Ok(S::ZERO);
        }
        last_change = Some(change);
    }
    Err(BodyError::NotConverged { step: h })
}

fn set<S: Scalar>(rows: &mut [Vec3<S>], i: usize, value: Vec3<S>) {
    if let Some(row) = rows.get_mut(i) {
        *row = value;
    }
}

fn moving<S: Scalar>(system: &System<S>, i: usize, step: Vec3<S>) -> Vec3<S> {
    if system.body.inverse_mass(i) > S::ZERO { step } else { vec3::zero() }
}

/// Middle and end of the step from the accelerations k.
fn place_middle<S: Scalar>(system: &System<S>, start: Start<S>, h: S, work: &mut Workspace<S>) {
    let half = S::from_f64(0.5);
    for i in 0..system.body.points() {
        let (x, v) = (vec3::at(start.motion.pos, i), vec3::at(start.motion.vel, i));
        let k = vec3::at(work.stages, i);
        let step = moving(system, i, vec3::axpy(vec3::scale(v, h), half * h * h, k));
        set(work.dx, i, step);
        set(work.stage_pos, i, vec3::axpy(x, half, step));
        set(work.end.pos, i, vec3::add(x, step));
        set(work.stage_vel, i, vec3::axpy(v, half * h, k));
    }
}

/// Mean forces whose work is the change of energy.
fn mean_force<S: Scalar>(
    system: &System<S>,
    start: Start<S>,
    h: S,
    work: &mut Workspace<S>,
) -> Result<(), BodyError<S>> {
    let body = &system.body;
    let force = &mut *work.stage_elastic;
    for ((f, m), v) in force.iter_mut().zip(body.mass).zip(work.stage_vel.iter()) {
        *f = vec3::axpy(vec3::scale(body.gravity, *m), -body.air_drag, *v);
    }
    let half = S::from_f64(0.5);
    for spring in body.springs {
        let between = |pos: &[Vec3<S>]| vec3::sub(vec3::at(pos, spring.head), vec3::at(pos, spring.tail));
        let (before, after) = (between(start.motion.pos), between(work.end.pos));
        let (l0, l1) = (vec3::norm(before), vec3::norm(after));
        let sum = l0 + l1;
        if sum > S::ZERO {
            // l1 - l0 without its cancellation: (after + before).(after - before)/(l0 + l1), the change
            // taken from the steps themselves: in a tiny step the positions hold nothing but rounding.
            let change = vec3::sub(vec3::at(work.dx, spring.head), vec3::at(work.dx, spring.tail));
            let growth = vec3::dot(vec3::add(after, before), change) / sum;
            let tension = spring.tension(half * sum) + spring.damping * growth / h;
            let pull = vec3::scale(vec3::add(before, after), tension / sum);
            vec3::add_at(force, spring.tail, pull);
            vec3::add_at(force, spring.head, vec3::scale(pull, -S::ONE));
        }
    }
    mean_pressure(body, start.motion.pos, work.stage_pos, work.end.pos, force)?;
    if let Some(ground) = &system.ground {
        mean_ground(ground, h, start.motion.pos, work.end.pos, force);
    }
    Ok(())
}

/// Pressure times the mean gradient of the volume (Simpson's rule is exact: the gradient is quadratic).
fn mean_pressure<S: Scalar>(
    body: &Body<S>,
    before: &[Vec3<S>],
    middle: &[Vec3<S>],
    after: &[Vec3<S>],
    force: &mut [Vec3<S>],
) -> Result<(), BodyError<S>> {
    let Some(inflation) = body.inflation else { return Ok(()) };
    let pressure = mean_gauge_pressure(body, &inflation.gas, before, after)?;
    let weights = [S::from_f64(1.0 / 6.0), S::from_f64(4.0 / 6.0), S::from_f64(1.0 / 6.0)];
    for facet in body.facets {
        for (pos, weight) in [before, middle, after].into_iter().zip(weights) {
            let shares = pressure::corner_shares(inflation.form, pressure::corners(pos, facet));
            for (point, share) in facet.iter().zip(shares) {
                vec3::add_at(force, *point, vec3::scale(share, weight * pressure));
            }
        }
    }
    Ok(())
}

/// Mean pressure over the change of volume: Simpson's rule on the gas law.
fn mean_gauge_pressure<S: Scalar>(
    body: &Body<S>,
    gas: &Gas<S>,
    before: &[Vec3<S>],
    after: &[Vec3<S>],
) -> Result<S, BodyError<S>> {
    let (v0, v1) = match gas {
        Gas::Constant(_) => (S::ZERO, S::ZERO),
        Gas::Polytropic { .. } => {
            (pressure::enclosed_volume(body, before), pressure::enclosed_volume(body, after))
        }
    };
    let middle = pressure::gauge_pressure(gas, S::from_f64(0.5) * (v0 + v1))?;
    let ends = pressure::gauge_pressure(gas, v0)? + pressure::gauge_pressure(gas, v1)?;
    Ok((ends + S::from_f64(4.0) * middle) * S::from_f64(1.0 / 6.0))
}

/// A soft ground's force as minus the quotient of its energy and the gap, and its dissipation at the mean rate.
fn mean_ground<S: Scalar>(
    ground: &Ground<S>,
    h: S,
    before: &[Vec3<S>],
    after: &[Vec3<S>],
    force: &mut [Vec3<S>],
) {
    let dissipation = match ground.law {
        ContactLaw::Penalty { .. } => S::ZERO,
        ContactLaw::HuntCrossley { dissipation, .. } => dissipation,
        _ => return,
    };
    for ((x0, x1), f) in before.iter().zip(after).zip(force) {
        let sink = ground.gap(*x0) - ground.gap(*x1);
        let gained = soft::energy(ground, *x1) - soft::energy(ground, *x0);
        let elastic = if sink.abs() > S::EPSILON.sqrt() * (S::ONE + ground.gap(*x0).abs()) {
            gained / sink
        } else {
            let middle = vec3::scale(vec3::add(*x0, *x1), S::from_f64(0.5));
            soft::normal_force(ground, middle, vec3::zero()).0
        };
        // Never pulling, so that against a rising point too the force takes energy out.
        let push = (elastic * (S::ONE + dissipation * (sink / h))).max(S::ZERO);
        *f = vec3::axpy(*f, push, ground.normal);
    }
}
