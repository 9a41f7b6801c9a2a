//! Symplectic Euler and velocity Verlet, with dampers solved implicitly.
//!
//! Verlet: v += h/2 a(x); x += h v; v += h/2 a(x'). Forces that depend on speeds (dampers, air, a soft ground)
//! act in a half step before and one after (Strang splitting: order 2), each by the implicit midpoint rule at
//! fixed positions, which dissipates energy for every C and h and conserves momentum.

use super::anderson::Anderson;
use super::motion::{Motion, copy};
use super::newton::{Newton, NodeFault, movable};
use super::rows::{self, accelerations};
use super::workspace::Workspace;
use crate::kernel::{self, Kernel};
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Most iterations of the dampers' half step; each reduces the error by about the factor h C/(4 m).
const ITERATIONS: usize = 100;
/// An error of the speed below this many rounding units ends the iteration.
const SETTLED: f64 = 2.0;
/// Lower bound on the estimated convergence rate: the error that an iteration leaves of the one before.
const LEAST_RATE: f64 = 1.0 / 16.0;

/// The positions at which the dampers act.
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

/// h v; a fixed node stays.
fn drift<S: Scalar>(newton: &impl Newton<S>, i: usize, v: Vec3<S>, h: S) -> Vec3<S> {
    movable(newton, i, vec3::scale(v, h))
}

/// Velocity Verlet between its two half steps of damping.
pub(super) fn verlet<S: Scalar, N: Newton<S>>(
    newton: &N,
    start: &Motion<S>,
    h: S,
    work: &mut Workspace<S>,
) -> Result<(), N::Fault> {
    let half = S::from_f64(0.5) * h;
    let damped = newton.is_damped();
    if damped {
        copy(work.stage_vel, start.vel);
        relax(newton, start, Place::Start, half, work)?;
        core::mem::swap(&mut work.stage_vel, &mut work.dv);
    }
    let mut far = kernel::run(KickAndDrift { newton, start, damped, h, work });
    work.evaluations += 1;
    newton.elastic(work.end.pos, work.end.elastic)?;
    if damped {
        core::mem::swap(&mut work.stage_vel, &mut work.end.vel);
        kernel::run(Kick { newton, h: half, work });
        let relaxed = relax(newton, start, Place::End, half, work);
        core::mem::swap(&mut work.stage_vel, &mut work.end.vel);
        relaxed?;
    }
    let kick = if damped { S::ZERO } else { half };
    far |= kernel::run(Arrive { newton, start, kick, work });
    if damped {
        newton.viscous(work.end.pos, work.end.vel, work.end.viscous);
    }
    Ok(work.end.check_far(far)?)
}

/// v += h a(force at the end), v in `work.stage_vel`.
struct Kick<'a, 'w, S, N> {
    newton: &'a N,
    h: S,
    work: &'a mut Workspace<'w, S>,
}

impl<S: Scalar, N: Newton<S>> Kernel for Kick<'_, '_, S, N> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Workspace { end, stage_vel, dx, stages, .. } = self.work;
        for first in rows::blocks(self.newton.nodes()) {
            let [force, factors] = accelerations(self.newton, first, end.elastic, [dx, stages]);
            rows::add_product(rows::block_mut(stage_vel, first), self.h, force, factors);
        }
    }
}

/// v += h/2 a at the start, x += h v. Writes the velocity at half time into `end.vel`; returns whether an x
/// [`rows::is_far`]. Velocities already changed by dampers are read from `work.dv`.
struct KickAndDrift<'a, 'm, 'w, S, N> {
    newton: &'a N,
    start: &'a Motion<'m, S>,
    damped: bool,
    h: S,
    work: &'a mut Workspace<'w, S>,
}

impl<S: Scalar, N: Newton<S>> Kernel for KickAndDrift<'_, '_, '_, S, N> {
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        let KickAndDrift { newton, start, damped, h, work } = self;
        let Workspace { end, dx, dv, stages, .. } = work;
        let before: &[Vec3<S>] = if damped { dv } else { start.vel };
        let half = S::from_f64(0.5) * h;
        let mut far = false;
        for first in rows::blocks(newton.nodes()) {
            let [force, factors] = accelerations(newton, first, start.elastic, [dx, stages]);
            let before = rows::block(before, first).as_flattened().iter();
            let vel = rows::block_mut(end.vel, first).as_flattened_mut().iter_mut().zip(before);
            let kicks = force.as_flattened().iter().zip(factors.as_flattened());
            let start_pos = rows::block(start.pos, first).as_flattened().iter();
            let start_rest = rows::block(start.pos_rest, first).as_flattened().iter();
            let pos = rows::block_mut(end.pos, first).as_flattened_mut().iter_mut();
            let rest = rows::block_mut(end.pos_rest, first).as_flattened_mut().iter_mut();
            let ends = pos.zip(rest).zip(start_pos.zip(start_rest));
            for (((v, v0), (force, factor)), ((x, rest), (x0, rest0))) in vel.zip(kicks).zip(ends) {
                *v = *v0 + half * (*force * *factor);
                let way = h * *v;
                let way = if *factor > S::ZERO { way } else { S::ZERO };
                (*x, *rest) = rows::add_compensated(*x0, *rest0, way);
                far |= rows::is_far(*x);
            }
        }
        far
    }
}

/// v += kick a at the end, then v by compensated sums from the start; returns whether a v [`rows::is_far`].
struct Arrive<'a, 'm, 'w, S, N> {
    newton: &'a N,
    start: &'a Motion<'m, S>,
    kick: S,
    work: &'a mut Workspace<'w, S>,
}

impl<S: Scalar, N: Newton<S>> Kernel for Arrive<'_, '_, '_, S, N> {
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        let Arrive { newton, start, kick, work } = self;
        let Workspace { end, dx, stages, .. } = work;
        let mut far = false;
        for first in rows::blocks(newton.nodes()) {
            let [force, factors] = accelerations(newton, first, end.elastic, [dx, stages]);
            let kicks = force.as_flattened().iter().zip(factors.as_flattened());
            let start_vel = rows::block(start.vel, first).as_flattened().iter();
            let start_rest = rows::block(start.vel_rest, first).as_flattened().iter();
            let vel = rows::block_mut(end.vel, first).as_flattened_mut().iter_mut();
            let rest = rows::block_mut(end.vel_rest, first).as_flattened_mut().iter_mut();
            let ends = vel.zip(rest).zip(start_vel.zip(start_rest));
            for ((force, factor), ((v, rest), (v0, rest0))) in kicks.zip(ends) {
                let end = *v + kick * (*force * *factor);
                (*v, *rest) = rows::add_compensated(*v0, *rest0, end - *v0);
                far |= rows::is_far(*v);
            }
            let [vel, rest] = [&mut *end.vel, end.vel_rest].map(|row| rows::block_mut(row, first));
            if newton.holds(first, vel.len()) {
                newton.admit(first, vel);
                newton.admit(first, rest);
            }
        }
        far
    }
}

/// Lets the speed-dependent forces act on `work.stage_vel` for a time h: v' = v + h k, k = a(v + h/2 k), at fixed
/// positions.
///
/// Iterates k, kept in `work.stage_elastic`, for all springs at once, so that a symmetric body stays symmetric. At the
/// end of a step the iteration starts from the k found at its start.
fn relax<S: Scalar, N: Newton<S>>(
    newton: &N,
    start: &Motion<S>,
    place: Place,
    h: S,
    work: &mut Workspace<S>,
) -> Result<(), N::Fault> {
    let Workspace { end, dx, dv, stage_pos, stage_vel, stage_elastic, stage_viscous, stages, .. } = work;
    let pos: &[Vec3<S>] = match place {
        Place::Start => start.pos,
        Place::End => end.pos,
    };
    if matches!(place, Place::Start) {
        stage_elastic.as_flattened_mut().fill(S::ZERO);
    }
    let mut anderson = Anderson {
        k: stage_elastic,
        residual: stage_pos,
        residual_change: end.vel_rest,
        last_g: end.viscous,
    };
    let (half, middle) = (S::from_f64(0.5) * h, &mut **stages);
    let mut before: Option<S> = None;
    for _ in 0..ITERATIONS {
        let size = kernel::run(Change { vel: stage_vel, h: half, k: anderson.k, out: middle });
        newton.viscous(pos, middle, stage_viscous);
        let [change, _] = anderson.improve(newton, stage_viscous, [dx, dv]);
        // Estimated change of the midpoint by the next iteration.
        let rate = before.map_or(S::ONE, |before| change / before).max(S::from_f64(LEAST_RATE)).min(S::ONE);
        if half * change * rate <= S::from_f64(SETTLED) * S::EPSILON * size {
            copy(middle, stage_vel);
            kernel::run(Change { vel: middle, h, k: anderson.k, out: stage_vel });
            return Ok(());
        }
        anderson.extrapolate(before.is_none());
        before = Some(change);
    }
    Err(NodeFault::NotConverged { step: h }.into())
}

/// Writes v + h k; returns its largest component.
struct Change<'a, S> {
    vel: &'a [Vec3<S>],
    h: S,
    k: &'a [Vec3<S>],
    out: &'a mut [Vec3<S>],
}

impl<S: Scalar> Kernel for Change<'_, S> {
    type Output = S;

    #[inline(always)]
    fn run(self) -> S {
        let mut largest = rows::Largest::none();
        for first in rows::blocks(self.vel.len()) {
            let [vel, k] = [self.vel, self.k].map(|row| rows::block(row, first).as_flattened().iter());
            let out = rows::block_mut(self.out, first);
            for (out, (v, k)) in out.as_flattened_mut().iter_mut().zip(vel.zip(k)) {
                *out = *v + self.h * *k;
            }
            largest.add(out);
        }
        largest.size()
    }
}
