//! When sweeps over contacts end: their changes are rounding, or they gain nothing more.
//!
//! In: number and change of each sweep. Out: whether another one is needed.

use crate::real::Scalar;

/// Sweeps before acceleration begins.
pub(crate) const PLAIN: usize = 30;

/// Change of the impulses by a sweep at which sweeps end, relative to the largest. Extrapolation stirs rounding: it never
/// settles to the last digit.
pub(crate) fn fine<S: Scalar>(number: usize) -> S {
    S::from_f64(if number < PLAIN { 4.0 } else { 64.0 }) * S::EPSILON
}

/// Sweeps without gain after which a change of the forces, relative to the largest, may be left: rounding soon, since forces
/// of redundant contacts that cancel one another change for ever; more of it late, since contacts that contradict one
/// another, by the error of their accelerations or because they are closed to some digits only, have no exact forces.
pub(crate) const LEFT: [(usize, f64); 3] = [(10, 1e-10), (40, 1e-8), (160, 1e-6)];

/// A change that may be left, in this precision.
pub(crate) fn may_be_left<S: Scalar>(left: f64) -> S {
    S::from_f64(left).max(S::from_f64(0.01) * S::EPSILON.sqrt())
}

/// Ends sweeps that gain nothing: what a sweep leaves has not halved within so many of them.
pub(crate) struct Patience<S> {
    sweeps: usize,
    least: S,
}

impl<S: Scalar> Patience<S> {
    /// Before the first sweep.
    pub(crate) fn new(sweeps: usize) -> Self {
        Patience { sweeps, least: S::from_f64(f64::INFINITY) }
    }

    /// Whether sweeps should end, given the number of this one, from 0, and what it leaves.
    pub(crate) fn ends(&mut self, number: usize, left: S) -> bool {
        if number % self.sweeps != self.sweeps - 1 {
            return false;
        }
        let gains = left <= S::from_f64(0.5) * self.least;
        self.least = left;
        !gains
    }
}
