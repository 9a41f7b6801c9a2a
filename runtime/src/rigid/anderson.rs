//! Anderson acceleration of slow sweeps over contacts: extrapolates from the last few sweeps (Anderson 1965; Walker &
//! Ni 2011).
//!
//! In: the impulse P of each contact before a sweep and g(P) after it. Out: the impulses from which the next sweep
//! starts.
//! ```text
//! f = g(P) - P,   gamma = argmin |f - sum_i gamma_i df_i|,   P = g(P) - sum_i gamma_i dg_i
//! ```
//! d..._i: differences from one sweep to the next. While no contact changes between sticking, sliding and lifting,
//! sweeps are linear and this is GMRES; where one does, f grows and the history begins anew. The norm weighs impulses
//! by inverse mass: energies.

use super::contact::{Inertia, Twist};
use super::history::{DEPTH, Swept};
use crate::real::Scalar;
use crate::vec3;

/// A direction is dropped if elimination leaves less than this share of its squared length.
const DEPENDENT: f64 = 1e-10;
/// A difference with less than this share of |f|^2 is rounding: sweeps then change the same whatever they start from.
const ROUNDED: f64 = 1e-12;
/// A sweep with |f|^2 above this many times the least of the history ends the history.
const WORSE: f64 = 4.0;

/// State of the extrapolation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Anderson<S> {
    /// Whether a sweep has been recorded.
    begun: bool,
    /// Differences recorded since the history began.
    number: usize,
    /// Least |f|^2 of its sweeps.
    least: S,
}

impl<S: Scalar> Anderson<S> {
    /// Before the first sweep.
    pub(crate) fn new() -> Self {
        Anderson { begun: false, number: 0, least: S::ZERO }
    }

    /// Records a sweep; returns the largest difference (m/s) between its change and that of the sweep before, None
    /// where a history begins.
    pub(crate) fn record(&mut self, list: &mut [impl Swept<S>]) -> Option<S> {
        let (mut square, mut apart, place) = (S::ZERO, S::ZERO, self.number % DEPTH);
        for entry in list.iter_mut() {
            let (contact, weight, history) = entry.parts();
            square = square + weight * vec3::dot(history.moved, history.moved);
            let (change, end) = (history.moved, contact.impulse);
            let difference = vec3::sub(change, history.change);
            apart = apart.max(weight * vec3::norm(difference));
            if let (Some(changes), Some(ends)) = (history.changes.get_mut(place), history.ends.get_mut(place))
            {
                (*changes, *ends) = (difference, vec3::sub(end, history.end));
            }
            (history.change, history.end) = (change, end);
        }
        if !self.begun || square > S::from_f64(WORSE) * self.least {
            *self = Anderson { begun: true, number: 0, least: square };
            return None;
        }
        (self.number, self.least) = (self.number + 1, self.least.min(square));
        Some(apart)
    }

    /// Gives the contacts the impulses that the next sweep starts from.
    pub(crate) fn extrapolate(
        &self,
        list: &mut [impl Swept<S>],
        inertia: &(impl Inertia<S> + ?Sized),
        twists: &mut [Twist<S>],
    ) {
        let gamma = combination(list, self.number.min(DEPTH));
        for entry in list {
            let (contact, _, history) = entry.parts();
            let ends = history.ends.iter().zip(gamma);
            let more = ends.fold(vec3::zero(), |sum, (end, gamma)| vec3::axpy(sum, -gamma, *end));
            contact.push(inertia, twists, more);
            contact.impulse = vec3::add(contact.impulse, more);
        }
    }
}

/// gamma from the last `count` differences.
fn combination<S: Scalar>(list: &mut [impl Swept<S>], count: usize) -> [S; DEPTH] {
    let (mut matrix, mut right, mut square) = ([[S::ZERO; DEPTH]; DEPTH], [S::ZERO; DEPTH], S::ZERO);
    for entry in list {
        let (_, weight, history) = entry.parts();
        let changes = &history.changes;
        square = square + weight * vec3::dot(history.moved, history.moved);
        for ((own, row), right) in changes.iter().zip(&mut matrix).zip(&mut right).take(count) {
            let own = vec3::scale(*own, weight);
            *right = *right + vec3::dot(own, history.moved);
            for (entry, other) in row.iter_mut().zip(changes).take(count) {
                *entry = *entry + vec3::dot(own, *other);
            }
        }
    }
    eliminate(matrix, right, square)
}

/// Solves the normal equations for gamma; leaves out directions that depend on earlier ones or are rounding compared
/// with |f|^2.
pub(crate) fn eliminate<S: Scalar>(
    mut matrix: [[S; DEPTH]; DEPTH],
    mut right: [S; DEPTH],
    square: S,
) -> [S; DEPTH] {
    let sizes: [S; DEPTH] = core::array::from_fn(|i| matrix[i][i]);
    let mut taken = [false; DEPTH];
    for i in 0..DEPTH {
        let (row, of_row) = (matrix[i], right[i]);
        if row[i] <= S::from_f64(DEPENDENT) * sizes[i] || row[i] <= S::from_f64(ROUNDED) * square {
            continue;
        }
        taken[i] = true;
        for (j, (other, of_other)) in matrix.iter_mut().zip(&mut right).enumerate() {
            if j == i {
                continue;
            }
            let factor = other[i] / row[i];
            *of_other = *of_other - factor * of_row;
            other.iter_mut().zip(row).for_each(|(to, from)| *to = *to - factor * from);
        }
    }
    core::array::from_fn(|i| if taken[i] { right[i] / matrix[i][i] } else { S::ZERO })
}
