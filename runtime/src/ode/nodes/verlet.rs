//! Symplectic Euler and velocity Verlet, with dampers solved implicitly.
//!
//! Verlet: v += h/2 a(x); x += h v; v += h/2 a(x'). Where forces depend on speeds (dampers, air, a soft ground)
//! a half step of them stands before and one after (Strang: order 2), each by the implicit midpoint rule at
//! fixed positions, which takes energy out for every C and h and conserves momentum.

use super::{Motion, Newton, NodeFault, Workspace, copy, movable, rows};
use crate::kernel::{self, BLOCK, Kernel};
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
    kernel::run(KickAndDrift { newton, start, h, work });
    work.evaluations += 1;
    newton.elastic(work.end.pos, work.end.elastic)?;
    kernel::run(Kick { newton, force: work.end.elastic, h: half, vel: work.stage_vel });
    if damped {
        relax(newton, start, Place::End, half, work)?;
    }
    kernel::run(Difference { of: [work.stage_vel, start.vel], out: work.dv });
    work.place_velocities(newton, start);
    newton.viscous(work.end.pos, work.end.vel, work.end.viscous);
    Ok(())
}

/// out = a - b.
struct Difference<'a, S> {
    of: [&'a [Vec3<S>]; 2],
    out: &'a mut [Vec3<S>],
}

impl<S: Scalar> Kernel for Difference<'_, S> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let [a, b] = self.of;
        rows::subtract(self.out, a, b);
    }
}

/// Accelerations of a block of nodes from `first` on, after what holds them has taken its part; returns 1/mass of each.
#[inline(always)]
fn accelerate<S: Scalar>(
    newton: &impl Newton<S>,
    first: usize,
    force: &[Vec3<S>],
    acceleration: &mut [Vec3<S>; BLOCK],
) -> [Vec3<S>; BLOCK] {
    let weights = newton.inverse_masses(first);
    rows::weigh(acceleration, rows::block(force, first), &weights);
    newton.admit(first, acceleration);
    weights
}

/// v += h a(force).
struct Kick<'a, S, N> {
    newton: &'a N,
    force: &'a [Vec3<S>],
    h: S,
    vel: &'a mut [Vec3<S>],
}

impl<S: Scalar, N: Newton<S>> Kernel for Kick<'_, S, N> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let mut acceleration = [vec3::zero(); BLOCK];
        for first in rows::blocks(self.newton.nodes()) {
            accelerate(self.newton, first, self.force, &mut acceleration);
            rows::add_scaled(rows::block_mut(self.vel, first), self.h, &acceleration);
        }
    }
}

/// v += h/2 a at the start, x += h v.
struct KickAndDrift<'a, 'm, 'w, S, N> {
    newton: &'a N,
    start: &'a Motion<'m, S>,
    h: S,
    work: &'a mut Workspace<'w, S>,
}

impl<S: Scalar, N: Newton<S>> Kernel for KickAndDrift<'_, '_, '_, S, N> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let KickAndDrift { newton, start, h, work } = self;
        let half = S::from_f64(0.5) * h;
        let mut acceleration = [vec3::zero(); BLOCK];
        for first in rows::blocks(newton.nodes()) {
            let weights = accelerate(newton, first, start.elastic, &mut acceleration);
            let vel = rows::block_mut(work.stage_vel, first);
            rows::add_scaled(vel, half, &acceleration);
            let dx = rows::block_mut(work.dx, first);
            rows::scale_weighty(dx, vel, h, &weights);
            let terms = [rows::block(start.pos, first), rows::block(start.pos_rest, first), dx];
            let (pos, rest) =
                (rows::block_mut(work.end.pos, first), rows::block_mut(work.end.pos_rest, first));
            rows::sum_compensated(terms, pos, rest);
        }
    }
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
