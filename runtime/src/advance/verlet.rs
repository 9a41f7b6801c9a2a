//! Symplectic Euler and velocity Verlet, with dampers solved implicitly pair by pair.
//!
//! Verlet: v += h/2 a(x); x += h v; v += h/2 a(x'). With dampers a half step of them stands before and
//! one after, in opposite order of the springs, which keeps order 2 (Strang): along each spring
//! r' = -C W r with W = d.(P_i/m_i + P_j/m_j) d is solved by r := r (1 - x/2)/(1 + x/2), x = C W h.
//! That takes energy out for every C and h, and conserves momentum pair by pair.

use super::{
    Start, Workspace, copy, eval_elastic, eval_viscous, finish, place_positions, place_velocities,
};
use crate::body::vec3::{self, Vec3};
use crate::body::{BodyError, Spring};
use crate::contact::System;
use crate::real::Scalar;

/// v' = v + h a(x, v), x' = x + h v'.
pub(crate) fn symplectic_euler<S: Scalar>(
    system: &System<S>,
    start: Start<S>,
    h: S,
    work: &mut Workspace<S>,
) -> Result<S, BodyError<S>> {
    for (i, (dx, dv)) in work.dx.iter_mut().zip(work.dv.iter_mut()).enumerate() {
        *dv = vec3::scale(system.acceleration(i, start.mode(i), start.motion.force(i)), h);
        *dx = drift(system, i, vec3::add(vec3::at(start.motion.vel, i), *dv), h);
    }
    finish(system, start, work)?;
    Ok(S::ZERO)
}

/// h v; a point that no force moves stays.
fn drift<S: Scalar>(system: &System<S>, i: usize, v: Vec3<S>, h: S) -> Vec3<S> {
    if system.body.inverse_mass(i) > S::ZERO { vec3::scale(v, h) } else { vec3::zero() }
}

/// Velocity Verlet, its two halves of damping around it.
pub(crate) fn verlet<S: Scalar>(
    system: &System<S>,
    start: Start<S>,
    h: S,
    work: &mut Workspace<S>,
) -> Result<S, BodyError<S>> {
    let half = S::from_f64(0.5) * h;
    let damped = system.body.is_damped();
    copy(work.stage_vel, start.motion.vel);
    if damped {
        relax(system, start, start.motion.pos, work.stage_vel, half, false);
    }
    for (i, (dx, v)) in work.dx.iter_mut().zip(work.stage_vel.iter_mut()).enumerate() {
        let a = system.acceleration(i, start.mode(i), velocity_free(system, start, i));
        *v = vec3::axpy(*v, half, a);
        *dx = drift(system, i, *v, h);
    }
    place_positions(start, work);
    eval_elastic(system, work.end.pos, work.end.elastic)?;
    for (i, v) in work.stage_vel.iter_mut().enumerate() {
        let a = system.acceleration(i, start.mode(i), vec3::at(work.end.elastic, i));
        *v = vec3::axpy(*v, half, a);
    }
    if damped {
        relax(system, start, work.end.pos, work.stage_vel, half, true);
    }
    for (i, dv) in work.dv.iter_mut().enumerate() {
        *dv = vec3::sub(vec3::at(work.stage_vel, i), vec3::at(start.motion.vel, i));
    }
    place_velocities(system, start, work);
    eval_viscous(system, work.end.pos, work.end.vel, work.end.viscous);
    Ok(S::ZERO)
}

/// The start's force without that of the dampers, which have their own half steps; a soft ground's stays.
fn velocity_free<S: Scalar>(system: &System<S>, start: Start<S>, i: usize) -> Vec3<S> {
    if system.body.is_damped() { vec3::at(start.motion.elastic, i) } else { start.motion.force(i) }
}

/// Lets the dampers and the air act for a time h at fixed positions.
fn relax<S: Scalar>(
    system: &System<S>,
    start: Start<S>,
    pos: &[Vec3<S>],
    vel: &mut [Vec3<S>],
    h: S,
    backwards: bool,
) {
    let springs = system.body.springs;
    if backwards {
        slow_in_air(system, vel, h);
        springs.iter().rev().for_each(|s| relax_spring(system, start, s, pos, vel, h));
    } else {
        springs.iter().for_each(|s| relax_spring(system, start, s, pos, vel, h));
        slow_in_air(system, vel, h);
    }
}

/// (1 - x/2)/(1 + x/2) - 1: relative change of a speed that decays at the rate x/h.
fn decay<S: Scalar>(x: S) -> S {
    -(x / (S::ONE + S::from_f64(0.5) * x))
}

fn slow_in_air<S: Scalar>(system: &System<S>, vel: &mut [Vec3<S>], h: S) {
    if system.body.air_drag > S::ZERO {
        for (i, v) in vel.iter_mut().enumerate() {
            let change = decay(system.body.air_drag * system.body.inverse_mass(i) * h);
            *v = vec3::axpy(*v, change, *v);
        }
    }
}

fn relax_spring<S: Scalar>(
    system: &System<S>,
    start: Start<S>,
    spring: &Spring<S>,
    pos: &[Vec3<S>],
    vel: &mut [Vec3<S>],
    h: S,
) {
    if spring.damping <= S::ZERO {
        return;
    }
    let stretch = spring.stretch(pos, vel);
    let d = stretch.direction;
    let tail = system.acceleration(spring.tail, start.mode(spring.tail), d);
    let head = system.acceleration(spring.head, start.mode(spring.head), d);
    let response = vec3::dot(d, tail) + vec3::dot(d, head);
    if response > S::ZERO {
        // Impulse along the spring that changes the rate by decay(C W h) rate.
        let impulse = stretch.rate * decay(spring.damping * response * h) / response;
        vec3::add_at(vel, spring.head, vec3::scale(head, impulse));
        vec3::add_at(vel, spring.tail, vec3::scale(tail, -impulse));
    }
}
