//! Symplectic Euler and velocity Verlet, with dampers solved implicitly.
//!
//! Verlet: v += h/2 a(x); x += h v; v += h/2 a(x'). Where forces depend on speeds (dampers, air, a soft ground)
//! a half step of them stands before and one after (Strang: order 2), each by the implicit midpoint rule at
//! fixed positions, which takes energy out for every C and h and conserves momentum.

use super::{Motion, Newton, NodeFault, Workspace, copy, movable};
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Iterations of the dampers' half step; each gains the factor h C/(4 m) per spring.
const ITERATIONS: usize = 100;
/// Changes of the speed below this many rounding units end the iteration.
const SETTLED: f64 = 2.0;

/// Where the dampers act.
#[derive(Clone, Copy)]
enum Place {
    Start,
    End,
}

/// v' = v + h a(x, v), x' = x + h v'.
pub(super) fn symplectic_euler<S: Scalar, N: Newton<S>>(
    newton: &N,
    start: &Motion<S>,
    h: S,
    work: &mut Workspace<S>,
) -> Result<(), N::Fault> {
    for (i, (dx, dv)) in work.dx.iter_mut().zip(work.dv.iter_mut()).enumerate() {
        *dv = vec3::scale(newton.acceleration(i, start.force(i)), h);
        *dx = drift(newton, i, vec3::add(vec3::at(start.vel, i), *dv), h);
    }
    work.finish(newton, start)
}

/// h v; a node that no force moves stays.
fn drift<S: Scalar>(newton: &impl Newton<S>, i: usize, v: Vec3<S>, h: S) -> Vec3<S> {
    movable(newton, i, vec3::scale(v, h))
}

/// Velocity Verlet, its two halves of damping around it.
pub(super) fn verlet<S: Scalar, N: Newton<S>>(
    newton: &N,
    start: &Motion<S>,
    h: S,
    work: &mut Workspace<S>,
) -> Result<(), N::Fault> {
    let half = S::from_f64(0.5) * h;
    let damped = newton.is_damped();
    copy(work.stage_vel, start.vel);
    if damped {
        relax(newton, start, Place::Start, half, work)?;
    }
    for (i, (dx, v)) in work.dx.iter_mut().zip(work.stage_vel.iter_mut()).enumerate() {
        let a = newton.acceleration(i, vec3::at(start.elastic, i));
        *v = vec3::axpy(*v, half, a);
        *dx = drift(newton, i, *v, h);
    }
    work.place_positions(start);
    work.evaluations += 1;
    newton.elastic(work.end.pos, work.end.elastic)?;
    for (i, v) in work.stage_vel.iter_mut().enumerate() {
        let a = newton.acceleration(i, vec3::at(work.end.elastic, i));
        *v = vec3::axpy(*v, half, a);
    }
    if damped {
        relax(newton, start, Place::End, half, work)?;
    }
    for (i, dv) in work.dv.iter_mut().enumerate() {
        *dv = vec3::sub(vec3::at(work.stage_vel, i), vec3::at(start.vel, i));
    }
    work.place_velocities(newton, start);
    newton.viscous(work.end.pos, work.end.vel, work.end.viscous);
    Ok(())
}

/// Lets the forces of speeds act on `work.stage_vel` for a time h: v' = v + h a((v + v')/2), at fixed positions.
///
/// Fixed-point iteration on the middle: all springs at once, so a symmetric body stays symmetric.
fn relax<S: Scalar, N: Newton<S>>(
    newton: &N,
    start: &Motion<S>,
    place: Place,
    h: S,
    work: &mut Workspace<S>,
) -> Result<(), N::Fault> {
    let pos: &[Vec3<S>] = match place {
        Place::Start => start.pos,
        Place::End => work.end.pos,
    };
    let (vel, middle) = (&mut *work.stage_vel, &mut *work.stages);
    copy(middle, vel);
    let half = S::from_f64(0.5) * h;
    for _ in 0..ITERATIONS {
        newton.viscous(pos, middle, work.stage_viscous);
        let (mut change, mut size) = (S::ZERO, S::ZERO);
        for (i, (m, v)) in middle.iter_mut().zip(vel.iter()).enumerate() {
            let a = newton.acceleration(i, vec3::at(work.stage_viscous, i));
            let next = vec3::axpy(*v, half, a);
            change = change.max(vec3::norm(vec3::sub(next, *m)));
            size = size.max(vec3::norm(next));
            *m = next;
        }
        if change <= S::from_f64(SETTLED) * S::EPSILON * size {
            for (v, m) in vel.iter_mut().zip(middle.iter()) {
                *v = vec3::sub(vec3::add(*m, *m), *v);
            }
            return Ok(());
        }
    }
    Err(NodeFault::NotConverged { step: h }.into())
}
