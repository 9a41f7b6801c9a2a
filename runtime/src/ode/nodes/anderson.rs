//! Fixed-point iteration for the accelerations of nodes, accelerated by Anderson's method (1965, depth 1).
//!
//! In: what the iteration before left, and the forces at the present guess k. Out: a better k. With g = f(k)/m and
//! the residual r = g - k, the next guess is g - gamma (g - g~), gamma = r.dr/dr.dr; g~ is the g of the iteration
//! before, dr the change of r since.

use super::newton::Newton;
use super::rows::{self, accelerations};
use crate::kernel::{self, Kernel};
use crate::real::Scalar;
use crate::vec3::Vec3;

/// Data that an iteration hands on to the next.
pub(super) struct Anderson<'a, S> {
    /// The accelerations (m/s^2).
    pub k: &'a mut [Vec3<S>],
    /// The residual r = g - k.
    pub residual: &'a mut [Vec3<S>],
    /// The change of r since the iteration before.
    pub residual_change: &'a mut [Vec3<S>],
    /// g of the iteration before.
    pub last_g: &'a mut [Vec3<S>],
}

impl<S: Scalar> Anderson<'_, S> {
    /// Replaces k by g = force/m; returns the largest components of r and g. `memory` is two rows.
    pub fn improve<N: Newton<S>>(
        &mut self,
        newton: &N,
        force: &[Vec3<S>],
        memory: [&mut [Vec3<S>]; 2],
    ) -> [S; 2] {
        kernel::run(Improve { newton, force, memory, anderson: self })
    }

    /// Extrapolates from g by the last change. Where |gamma| would exceed 1, and in the first iteration, k = g.
    pub fn extrapolate(&mut self, is_first: bool) {
        kernel::run(Extrapolate { is_first, anderson: self });
    }
}

struct Improve<'a, 't, S, N> {
    newton: &'a N,
    force: &'a [Vec3<S>],
    memory: [&'a mut [Vec3<S>]; 2],
    anderson: &'a mut Anderson<'t, S>,
}

impl<S: Scalar, N: Newton<S>> Kernel for Improve<'_, '_, S, N> {
    type Output = [S; 2];

    #[inline(always)]
    fn run(self) -> [S; 2] {
        let Improve {
            newton,
            force,
            memory: [one, other],
            anderson: Anderson { k, residual, residual_change, .. },
        } = self;
        let mut largest = [rows::Largest::none(); 2];
        for first in rows::blocks(newton.nodes()) {
            let [force, factors] = accelerations(newton, first, force, [one, other]);
            let found = force.as_flattened().iter().zip(factors.as_flattened());
            let [k, residual, residual_change] =
                [&mut **k, residual, residual_change].map(|row| rows::block_mut(row, first));
            let lanes = residual.as_flattened_mut().iter_mut().zip(residual_change.as_flattened_mut());
            for ((k, (force, factor)), (residual, residual_change)) in
                k.as_flattened_mut().iter_mut().zip(found).zip(lanes)
            {
                let found = *force * *factor;
                let now = found - *k;
                (*k, *residual_change, *residual) = (found, now - *residual, now);
            }
            largest[0].add(residual);
            largest[1].add(k);
        }
        largest.map(|largest| largest.size())
    }
}

struct Extrapolate<'a, 't, S> {
    is_first: bool,
    anderson: &'a mut Anderson<'t, S>,
}

impl<S: Scalar> Kernel for Extrapolate<'_, '_, S> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Anderson { k, residual, residual_change, last_g } = self.anderson;
        let gamma = rows::quotient(residual, residual_change);
        // A gamma that is NaN fails this too.
        let goes_on = !self.is_first && gamma.abs() <= S::ONE;
        for (k, last_g) in k.as_flattened_mut().iter_mut().zip(last_g.as_flattened_mut()) {
            let g = *k;
            let next = g - gamma * (g - *last_g);
            (*k, *last_g) = (if goes_on { next } else { g }, g);
        }
    }
}
