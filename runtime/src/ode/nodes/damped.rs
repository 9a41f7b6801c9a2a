//! Verlet's method with implicit dampers: only the springs bound its step, however strong the dampers are.
//!
//! In: state, step. Out: the motion at the end. At the midpoint x_m = x + h/2 v solve (M + h/2 C) k = f - C v, f and C
//! at x_m; v' = v + h k, x' = x + h v + h^2/2 k: order 2, symmetric, stable for h w < 2 and any C. k is found by
//! conjugate gradients from 0, preconditioned by M (Hestenes & Stiefel 1952). M times each iterate is a sum of f and of
//! forces between pairs of nodes along their connecting lines at x_m. So wherever the iteration stops, linear and
//! angular momentum are conserved and dampers alone add no energy.

use super::motion::{Motion, copy};
use super::newton::{Newton, NodeFault};
use super::rows::{self, accelerations};
use super::workspace::Workspace;
use crate::kernel::{self, Kernel};
use crate::real::Scalar;
use crate::vec3::Vec3;

/// Most iterations; the number needed grows with the square root of h C/(2 m).
const ITERATIONS: usize = 1000;
/// Relative residual of k allowed where f - C v changes by its own size within half a step; elsewhere it shrinks with
/// the square of that relative change, as the step's own error does.
const ACCURACY: f64 = 1e-2;
/// Smallest relative residual asked for, in rounding units.
const SETTLED: f64 = 2.0;

/// A step of length h into `work.end`.
pub(super) fn damped_verlet<S: Scalar, N: Newton<S>>(
    newton: &N,
    start: &Motion<S>,
    h: S,
    work: &mut Workspace<S>,
) -> Result<(), N::Fault> {
    kernel::run(PlaceMiddle { newton, start, h, work });
    work.evaluations += 1;
    newton.elastic(work.stage_pos, work.stage_elastic)?;
    newton.viscous(work.stage_pos, start.vel, work.stage_viscous);
    solve(newton, start, h, work)?;
    kernel::run(Arrive { newton, start, h, work });
    work.finish(newton, start)
}

/// Leaves k in `work.stages`; uses rows of the end of the step, not yet needed, as memory.
fn solve<S: Scalar, N: Newton<S>>(
    newton: &N,
    start: &Motion<S>,
    h: S,
    work: &mut Workspace<S>,
) -> Result<(), N::Fault> {
    let pos: &[Vec3<S>] = work.stage_pos;
    let mut rows = Rows {
        k: work.stages,
        residual: work.stage_elastic,
        preconditioned: work.end.elastic,
        direction: work.stage_vel,
        inertia: work.end.vel,
        image: work.stage_viscous,
        memory: [work.dx, work.dv],
    };
    let [mut size, change] = kernel::run(Begin { newton, start, rows: &mut rows });
    let accuracy = S::from_f64(ACCURACY) * (change / size).min(S::ONE);
    let accuracy = accuracy.max(S::from_f64(SETTLED) * S::EPSILON);
    let enough = accuracy * accuracy * size;
    for _ in 0..ITERATIONS {
        // A size that is NaN ends the iteration too: the check at the end of the step then names the node.
        if size.partial_cmp(&enough) != Some(core::cmp::Ordering::Greater) {
            return Ok(());
        }
        newton.viscous(pos, rows.direction, rows.image);
        let curvature = kernel::run(ApplyMatrix { half: S::from_f64(0.5) * h, rows: &mut rows });
        let next = kernel::run(UpdateSolution { newton, gain: size / curvature, rows: &mut rows });
        kernel::run(NextDirection { share: next / size, rows: &mut rows });
        size = next;
    }
    Err(NodeFault::NotConverged { step: h }.into())
}

/// Vectors of the conjugate gradient iteration.
struct Rows<'a, S> {
    /// The solution (m/s^2).
    k: &'a mut [Vec3<S>],
    /// Residual f - C v - (M + h/2 C) k (N).
    residual: &'a mut [Vec3<S>],
    /// Preconditioned residual, M^-1 `residual` (m/s^2).
    preconditioned: &'a mut [Vec3<S>],
    /// Search direction p (m/s^2).
    direction: &'a mut [Vec3<S>],
    /// M p (N).
    inertia: &'a mut [Vec3<S>],
    /// -C p, then (M + h/2 C) p (N).
    image: &'a mut [Vec3<S>],
    /// For accelerations and their factors.
    memory: [&'a mut [Vec3<S>]; 2],
}

/// Writes a block of M^-1 force into `out`.
#[inline(always)]
fn precondition<S: Scalar, N: Newton<S>>(
    newton: &N,
    first: usize,
    force: &[Vec3<S>],
    [one, other]: [&mut [Vec3<S>]; 2],
    out: &mut [Vec3<S>],
) {
    let [part, factors] = accelerations(newton, first, force, [one, other]);
    rows::multiply(rows::block_mut(out, first), part, factors);
}

/// Places the nodes at the midpoint with the velocities at the start; fixed nodes (inverse mass 0) stay.
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
        let half = S::from_f64(0.5) * h;
        for first in rows::blocks(newton.nodes()) {
            let inverse = newton.inverse_masses(first, rows::block_mut(work.dv, first)).as_flattened().iter();
            let [x, v] = [&*start.pos, start.vel].map(|row| rows::block(row, first).as_flattened().iter());
            let middle = rows::block_mut(work.stage_pos, first).as_flattened_mut().iter_mut();
            for (middle, ((x, v), inverse)) in middle.zip(x.zip(v).zip(inverse)) {
                *middle = *x + if *inverse > S::ZERO { half * *v } else { S::ZERO };
            }
        }
    }
}

/// Starts with f and -C v in `residual` and `image`: k = 0, p = M^-1 (f - C v). Returns a.M^-1 a for a = f - C v and
/// for the change of f - C v since the start of the step.
struct Begin<'a, 'm, 'r, S, N> {
    newton: &'a N,
    start: &'a Motion<'m, S>,
    rows: &'a mut Rows<'r, S>,
}

impl<S: Scalar, N: Newton<S>> Kernel for Begin<'_, '_, '_, S, N> {
    type Output = [S; 2];

    #[inline(always)]
    fn run(self) -> [S; 2] {
        let Begin { newton, start, rows } = self;
        let Rows { k, residual, preconditioned, direction, inertia, image, memory: [one, other] } = rows;
        for first in rows::blocks(newton.nodes()) {
            rows::block_mut(k, first).as_flattened_mut().fill(S::ZERO);
            rows::add_scaled(rows::block_mut(residual, first), S::ONE, rows::block(image, first));
            precondition(newton, first, residual, [one, other], direction);
            let [inertia, since] = [&mut **inertia, &mut **image].map(|row| rows::block_mut(row, first));
            copy(inertia, rows::block(residual, first));
            copy(since, inertia);
            rows::add_scaled(since, -S::ONE, rows::block(start.elastic, first));
            rows::add_scaled(since, -S::ONE, rows::block(start.viscous, first));
            precondition(newton, first, image, [one, other], preconditioned);
        }
        [rows::product(residual, direction), rows::product(image, preconditioned)]
    }
}

/// Writes (M + h/2 C) p into `image` from M p and -C p; returns its product with p. `half` is h/2.
struct ApplyMatrix<'a, 'r, S> {
    half: S,
    rows: &'a mut Rows<'r, S>,
}

impl<S: Scalar> Kernel for ApplyMatrix<'_, '_, S> {
    type Output = S;

    #[inline(always)]
    fn run(self) -> S {
        let Rows { direction, inertia, image, .. } = self.rows;
        for (image, inertia) in image.as_flattened_mut().iter_mut().zip(inertia.as_flattened()) {
            *image = *inertia - self.half * *image;
        }
        rows::product(direction, image)
    }
}

/// Moves k by `gain` p and updates the residual r; returns r.M^-1 r.
struct UpdateSolution<'a, 'r, S, N> {
    newton: &'a N,
    gain: S,
    rows: &'a mut Rows<'r, S>,
}

impl<S: Scalar, N: Newton<S>> Kernel for UpdateSolution<'_, '_, S, N> {
    type Output = S;

    #[inline(always)]
    fn run(self) -> S {
        let Rows { k, residual, preconditioned, direction, image, memory: [one, other], .. } = self.rows;
        for first in rows::blocks(self.newton.nodes()) {
            rows::add_scaled(rows::block_mut(k, first), self.gain, rows::block(direction, first));
            rows::add_scaled(rows::block_mut(residual, first), -self.gain, rows::block(image, first));
            precondition(self.newton, first, residual, [one, other], preconditioned);
        }
        rows::product(residual, preconditioned)
    }
}

/// The next direction: p = M^-1 r + `share` p, and M p likewise.
struct NextDirection<'a, 'r, S> {
    share: S,
    rows: &'a mut Rows<'r, S>,
}

impl<S: Scalar> Kernel for NextDirection<'_, '_, S> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Rows { residual, preconditioned, direction, inertia, .. } = self.rows;
        for (next, row) in [(&**preconditioned, direction), (&**residual, inertia)] {
            for (row, next) in row.as_flattened_mut().iter_mut().zip(next.as_flattened()) {
                *row = *next + self.share * *row;
            }
        }
    }
}

/// Changes of positions and velocities from k.
struct Arrive<'a, 'm, 'w, S, N> {
    newton: &'a N,
    start: &'a Motion<'m, S>,
    h: S,
    work: &'a mut Workspace<'w, S>,
}

impl<S: Scalar, N: Newton<S>> Kernel for Arrive<'_, '_, '_, S, N> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Arrive { newton, start, h, work } = self;
        let Workspace { dx, dv, stages, stage_elastic, .. } = work;
        let half = S::from_f64(0.5);
        for first in rows::blocks(newton.nodes()) {
            let inverse = newton.inverse_masses(first, rows::block_mut(stage_elastic, first));
            let [v, k] = [&*start.vel, stages].map(|row| rows::block(row, first).as_flattened().iter());
            let [dx, dv] =
                [&mut **dx, dv].map(|row| rows::block_mut(row, first).as_flattened_mut().iter_mut());
            for ((dx, dv), ((v, k), inverse)) in dx.zip(dv).zip(v.zip(k).zip(inverse.as_flattened())) {
                *dv = h * *k;
                // A fixed node (inverse mass 0) stays.
                *dx = if *inverse > S::ZERO { h * (*v + half * *dv) } else { S::ZERO };
            }
        }
    }
}
