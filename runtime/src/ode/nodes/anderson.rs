//! Fixed-point iteration for the accelerations of nodes, accelerated by Anderson's method (1965, depth 1).
//!
//! In: the trail of the iteration before, and the forces at the present guess k. Out: a better k. With g = f(k)/m and
//! the residual r = g - k, the next guess is g - gamma (g - g~), gamma = r.dr/dr.dr; g~ is the g of the iteration
//! before, dr the change of r since.

use super::newton::Newton;
use super::rows::{self, accelerations};
use crate::kernel::{self, Kernel};
use crate::real::Scalar;
use crate::vec3::Vec3;

/// Data that an iteration hands on to the next.
pub(super) struct Trail<'a, S> {
    /// The accelerations (m/s^2).
    pub k: &'a mut [Vec3<S>],
    /// The residual r = g - k.
    pub off: &'a mut [Vec3<S>],
    /// The change of r since the iteration before.
    pub turn: &'a mut [Vec3<S>],
    /// g of the iteration before.
    pub before: &'a mut [Vec3<S>],
}

impl<S: Scalar> Trail<'_, S> {
    /// Replaces k by g = force/m; returns the largest components of r and g. `memory` is two rows.
    pub fn improve<N: Newton<S>>(
        &mut self,
        newton: &N,
        force: &[Vec3<S>],
        memory: [&mut [Vec3<S>]; 2],
    ) -> [S; 2] {
        kernel::run(Improve { newton, force, memory, trail: self })
    }

    /// Extrapolates from g by the last change. Where |gamma| would exceed 1, and in the first iteration, k = g.
    pub fn go_on(&mut self, is_first: bool) {
        kernel::run(GoOn { is_first, trail: self });
    }
}

struct Improve<'a, 't, S, N> {
    newton: &'a N,
    force: &'a [Vec3<S>],
    memory: [&'a mut [Vec3<S>]; 2],
    trail: &'a mut Trail<'t, S>,
}

impl<S: Scalar, N: Newton<S>> Kernel for Improve<'_, '_, S, N> {
    type Output = [S; 2];

    #[inline(always)]
    fn run(self) -> [S; 2] {
        let Improve { newton, force, memory: [one, other], trail: Trail { k, off, turn, .. } } = self;
        let mut largest = [rows::Largest::none(); 2];
        for first in rows::blocks(newton.nodes()) {
            let [force, factors] = accelerations(newton, first, force, [one, other]);
            let found = force.as_flattened().iter().zip(factors.as_flattened());
            let [k, off, turn] = [&mut **k, off, turn].map(|row| rows::block_mut(row, first));
            let lanes = off.as_flattened_mut().iter_mut().zip(turn.as_flattened_mut());
            for ((k, (force, factor)), (off, turn)) in k.as_flattened_mut().iter_mut().zip(found).zip(lanes) {
                let found = *force * *factor;
                let now = found - *k;
                (*k, *turn, *off) = (found, now - *off, now);
            }
            largest[0].add(off);
            largest[1].add(k);
        }
        largest.map(|largest| largest.size())
    }
}

struct GoOn<'a, 't, S> {
    is_first: bool,
    trail: &'a mut Trail<'t, S>,
}

impl<S: Scalar> Kernel for GoOn<'_, '_, S> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Trail { k, off, turn, before } = self.trail;
        let gamma = rows::quotient(off, turn);
        // A gamma that is NaN fails this too.
        let goes_on = !self.is_first && gamma.abs() <= S::ONE;
        for (k, before) in k.as_flattened_mut().iter_mut().zip(before.as_flattened_mut()) {
            let g = *k;
            let next = g - gamma * (g - *before);
            (*k, *before) = (if goes_on { next } else { g }, g);
        }
    }
}
