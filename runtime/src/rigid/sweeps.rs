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

/// Change of the forces by a sweep, relative to the largest, that may be left where contacts are redundant: accelerations
/// are known to fewer digits than forces, so that no forces fit all contacts, and those that cancel one another change
/// for ever.
pub(crate) fn redundant<S: Scalar>() -> S {
    S::from_f64(0.01) * S::EPSILON.sqrt()
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
