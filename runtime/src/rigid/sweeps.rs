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

/// Ends sweeps that gain nothing: what a sweep leaves has not halved within so many of them.
#[derive(Clone, Copy)]
pub(crate) struct Patience<S> {
    sweeps: usize,
    /// What may be left then.
    allowed: S,
    least: S,
}

impl<S: Scalar> Patience<S> {
    /// Before the first sweep.
    pub(crate) fn new(sweeps: usize, allowed: S) -> Self {
        Patience { sweeps, allowed, least: S::from_f64(f64::INFINITY) }
    }

    /// For forces, of whose changes relative to the largest rounding may be left soon, since those of redundant contacts
    /// that cancel one another change for ever. With `rough` more may be left late, since contacts that contradict one
    /// another have no exact forces.
    pub(crate) fn of_forces(rough: bool) -> [Self; 3] {
        let rounding = S::from_f64(0.01) * S::EPSILON.sqrt();
        let [some, more] = [S::from_f64(1e-8), S::from_f64(1e-6)].map(|allowed| allowed.max(rounding));
        let [some, more] = if rough { [some, more] } else { [rounding; 2] };
        [Patience::new(10, rounding), Patience::new(40, some), Patience::new(160, more)]
    }

    /// Whether sweeps should end, given the number of this one, from 0, and what it leaves.
    pub(crate) fn ends(&mut self, number: usize, left: S) -> bool {
        if number % self.sweeps != self.sweeps - 1 {
            return false;
        }
        let gains = left <= S::from_f64(0.5) * self.least;
        self.least = left;
        !gains && self.accepts(left)
    }

    /// Whether so much may be left.
    pub(crate) fn accepts(&self, left: S) -> bool {
        left <= self.allowed
    }
}
