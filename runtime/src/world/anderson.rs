//! Sweeps that are slow, gone on with from what the last few have changed (Anderson 1965; Walker and Ni 2011).
//!
//! In: of each contact its impulse P before a sweep and g(P) behind it. Out: the impulses that the next sweep starts from.
//! ```text
//! f = g(P) - P,   gamma = argmin |f - sum_i gamma_i df_i|,   P = g(P) - sum_i gamma_i dg_i
//! ```
//! d..._i: differences from one sweep to the next. Where contacts stick, slide or lift as before, sweeps are linear and this is
//! GMRES; where that changes, f grows and the trail begins anew. Sums weigh impulses by what the contacts yield: energies.

use super::detect::Touch;
use super::trail::DEPTH;
use crate::real::Scalar;
use crate::rigid::contact::{Inertia, Twist};
use crate::vec3;

/// A direction with less than this share of its square beside the others is none.
const DEPENDENT: f64 = 1e-10;
/// A difference with less than this share of |f|^2 is rounding: sweeps go on alike whatever they start from.
const ROUNDED: f64 = 1e-12;
/// A sweep that changes more than this times the least of the trail (squares) ends the trail.
const WORSE: f64 = 4.0;

/// How far the trails go.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ahead<S> {
    /// Has a sweep been noted?
    begun: bool,
    /// Differences noted since the trail began.
    number: usize,
    /// Least |f|^2 of its sweeps.
    least: S,
}

impl<S: Scalar> Ahead<S> {
    /// Of sweeps that have not begun.
    pub(super) fn new() -> Self {
        Ahead { begun: false, number: 0, least: S::ZERO }
    }

    /// Notes a sweep; returns by how much (m/s) it and the one before changed contacts otherwise, None where a trail begins.
    pub(super) fn note(&mut self, touches: &mut [Touch<S>]) -> Option<S> {
        let (mut square, mut apart, place) = (S::ZERO, S::ZERO, self.number % DEPTH);
        for touch in touches.iter_mut() {
            let weight = touch.weight();
            square = square + weight * vec3::dot(touch.change, touch.change);
            let (change, end, trail) = (touch.change, touch.contact.impulse, &mut touch.trail);
            let difference = vec3::sub(change, trail.change);
            apart = apart.max(weight * vec3::norm(difference));
            if let (Some(changes), Some(ends)) = (trail.changes.get_mut(place), trail.ends.get_mut(place)) {
                (*changes, *ends) = (difference, vec3::sub(end, trail.end));
            }
            (trail.change, trail.end) = (change, end);
        }
        if !self.begun || square > S::from_f64(WORSE) * self.least {
            *self = Ahead { begun: true, number: 0, least: square };
            return None;
        }
        (self.number, self.least) = (self.number + 1, self.least.min(square));
        Some(apart)
    }

    /// Gives the contacts the impulses that the next sweep starts from.
    pub(super) fn go_on(&self, touches: &mut [Touch<S>], inertia: &impl Inertia<S>, twists: &mut [Twist<S>]) {
        let gamma = combination(touches, self.number.min(DEPTH));
        for touch in touches {
            let ends = touch.trail.ends.iter().zip(gamma);
            let more = ends.fold(vec3::zero(), |sum, (end, gamma)| vec3::axpy(sum, -gamma, *end));
            touch.contact.push(inertia, twists, more);
            touch.contact.impulse = vec3::add(touch.contact.impulse, more);
        }
    }
}

/// gamma of the last `count` differences.
fn combination<S: Scalar>(touches: &[Touch<S>], count: usize) -> [S; DEPTH] {
    let (mut matrix, mut right, mut square) = ([[S::ZERO; DEPTH]; DEPTH], [S::ZERO; DEPTH], S::ZERO);
    for touch in touches {
        let (weight, changes) = (touch.weight(), &touch.trail.changes);
        square = square + weight * vec3::dot(touch.change, touch.change);
        for ((own, row), right) in changes.iter().zip(&mut matrix).zip(&mut right).take(count) {
            let own = vec3::scale(*own, weight);
            *right = *right + vec3::dot(own, touch.change);
            for (entry, other) in row.iter_mut().zip(changes).take(count) {
                *entry = *entry + vec3::dot(own, *other);
            }
        }
    }
    eliminate(matrix, right, square)
}

/// gamma of normal equations; directions that depend on those before them, or are rounding beside |f|^2, are left out.
pub(super) fn eliminate<S: Scalar>(
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
