//! Positions and velocities of nodes, with their rounding errors, and the forces there.

use super::newton::{Newton, NodeFault};
use super::rows;
use crate::kernel::Kernel;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Positions, speeds and forces of all nodes at one time.
#[derive(Debug)]
pub struct Motion<'a, S> {
    /// Positions (m).
    pub pos: &'a mut [Vec3<S>],
    /// Rounding errors of the positions.
    pub pos_rest: &'a mut [Vec3<S>],
    /// Velocities (m/s).
    pub vel: &'a mut [Vec3<S>],
    /// Rounding errors of the velocities.
    pub vel_rest: &'a mut [Vec3<S>],
    /// Forces of positions (N).
    pub elastic: &'a mut [Vec3<S>],
    /// Forces of speeds (N); where there are none nothing but [`Motion::refresh`] writes their zeros.
    pub viscous: &'a mut [Vec3<S>],
}

/// Vectors per node in a [`Motion`].
pub const MOTION_ROWS: usize = 6;

impl<'a, S: Scalar> Motion<'a, S> {
    /// Cuts the six rows of n from a buffer; returns what is left.
    ///
    /// # Errors
    /// [`NodeFault::Memory`] if the buffer is too short.
    #[expect(clippy::type_complexity, reason = "the pair is the whole answer")]
    pub fn cut(
        buffer: &'a mut [Vec3<S>],
        n: usize,
    ) -> Result<(Motion<'a, S>, &'a mut [Vec3<S>]), NodeFault<S>> {
        let (pos, buffer) = cut(buffer, n)?;
        let (pos_rest, buffer) = cut(buffer, n)?;
        let (vel, buffer) = cut(buffer, n)?;
        let (vel_rest, buffer) = cut(buffer, n)?;
        let (elastic, buffer) = cut(buffer, n)?;
        let (viscous, buffer) = cut(buffer, n)?;
        Ok((Motion { pos, pos_rest, vel, vel_rest, elastic, viscous }, buffer))
    }

    /// Total force on node i (N).
    #[must_use]
    pub fn force(&self, i: usize) -> Vec3<S> {
        vec3::add(vec3::at(self.elastic, i), vec3::at(self.viscous, i))
    }

    /// Recomputes the forces of these positions and speeds.
    ///
    /// # Errors
    /// From [`Newton::elastic`].
    pub fn refresh<N: Newton<S>>(&mut self, newton: &N) -> Result<(), N::Fault> {
        newton.elastic(self.pos, self.elastic)?;
        newton.viscous(self.pos, self.vel, self.viscous);
        Ok(())
    }

    /// Refuses positions and speeds whose squares are not finite, because energies and errors are made of squares.
    ///
    /// # Errors
    /// [`NodeFault::NotFinite`] for the first such node.
    pub fn check_finite(&self) -> Result<(), NodeFault<S>> {
        self.check_far(rows::run(self.pos.len(), FindFar { rows: [self.pos, self.vel] }))
    }

    /// The same, given whether any position or speed [`rows::is_far`]: almost always none is, and no search is needed.
    pub(super) fn check_far(&self, far: bool) -> Result<(), NodeFault<S>> {
        if !far {
            return Ok(());
        }
        let finite = |x: &Vec3<S>, v: &Vec3<S>| (vec3::dot(*x, *x) + vec3::dot(*v, *v)).is_finite();
        let bad = self.pos.iter().zip(self.vel.iter()).position(|(x, v)| !finite(x, v));
        bad.map_or(Ok(()), |node| Err(NodeFault::NotFinite { node }))
    }
}

/// Whether any number of these rows [`rows::is_far`].
struct FindFar<'a, S> {
    rows: [&'a [Vec3<S>]; 2],
}

impl<S: Scalar> Kernel for FindFar<'_, S> {
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        self.rows.iter().any(|row| row.as_flattened().iter().fold(false, |far, x| far | rows::is_far(*x)))
    }
}

pub(super) fn cut<T, S>(buffer: &mut [T], n: usize) -> Result<(&mut [T], &mut [T]), NodeFault<S>> {
    let given = buffer.len();
    buffer.split_at_mut_checked(n).ok_or(NodeFault::Memory { needed: n, given })
}

/// Copies row by row; no panic if the lengths differ.
pub(crate) fn copy<T: Copy>(to: &mut [T], from: &[T]) {
    let n = to.len().min(from.len());
    if let (Some(to), Some(from)) = (to.get_mut(..n), from.get(..n)) {
        to.copy_from_slice(from);
    }
}
