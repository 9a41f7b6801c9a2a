//! When sweeps over contacts end: their changes are rounding, or they gain nothing more.
//!
//! In: number and change of each sweep. Out: whether another one is needed.

use crate::real::Scalar;

/// Sweeps before acceleration begins.
pub(crate) const PLAIN: usize = 30;

/// Change of the impulses by a sweep at which sweeps end, relative to the largest. Extrapolation stirs rounding: it
/// never settles to the last digit.
pub(crate) fn fine<S: Scalar>(number: usize) -> S {
    S::from_f64(if number < PLAIN { 4.0 } else { 64.0 }) * S::EPSILON
}

/// What may be left of forces in the end, relative to the largest; with `rough` more.
pub(crate) fn accepted<S: Scalar>(rough: bool) -> S {
    let cancels = S::from_f64(0.01) * S::EPSILON.sqrt();
    if rough { cancels.max(S::from_f64(1e-6)) } else { cancels }
}

/// Ends sweeps that gain nothing: the least that one leaves has not halved within so many of them. Extrapolation may
/// have stirred the last one, so that one of the better ones ends them.
#[derive(Clone, Copy)]
pub(crate) struct Patience<S> {
    sweeps: usize,
    /// What may be left then.
    allowed: S,
    /// The least left before these sweeps, and by these.
    least: [S; 2],
    /// Least of the sweeps before these over the least before them.
    rate: S,
}

impl<S: Scalar> Patience<S> {
    /// Before the first sweep.
    pub(crate) fn new(sweeps: usize, allowed: S) -> Self {
        Patience { sweeps, allowed, least: [S::from_f64(f64::INFINITY); 2], rate: S::ZERO }
    }

    /// For forces, of whose changes relative to the largest rounding may be left soon, since those of redundant
    /// contacts that cancel one another change for ever. With `rough` more may be left late, since contacts that
    /// contradict one another have no exact forces.
    pub(crate) fn of_forces(rough: bool) -> [Self; 3] {
        let soon = S::from_f64(64.0) * S::EPSILON;
        let some = if rough { accepted::<S>(false).max(S::from_f64(1e-8)) } else { accepted(false) };
        let more = accepted(rough);
        [Patience::new(10, soon.max(S::from_f64(1e-11))), Patience::new(40, some), Patience::new(160, more)]
    }

    /// Whether sweeps should end, given the number of this one, from 0, and what it leaves.
    pub(crate) fn ends(&mut self, number: usize, left: S) -> bool {
        let [before, now] = &mut self.least;
        *now = now.min(left);
        if number % self.sweeps == self.sweeps - 1 {
            self.rate = *now / *before;
            (*before, *now) = (*now, S::from_f64(f64::INFINITY));
        }
        self.stays() && left <= S::from_f64(2.0) * self.least[0] && self.accepts(left)
    }

    /// Whether sweeps that gain so little would leave too much even after `most` of them, given the number of this one.
    pub(crate) fn fails(&self, number: usize, most: usize) -> bool {
        let rounds = most.saturating_sub(number) / self.sweeps;
        self.stays() && !self.accepts((0..rounds).fold(self.least[0], |left, _| left * self.rate))
    }

    /// Whether the sweeps before these gained nothing.
    fn stays(&self) -> bool {
        self.rate > S::from_f64(0.5)
    }

    /// Whether so much may be left.
    pub(crate) fn accepts(&self, left: S) -> bool {
        left <= self.allowed
    }
}
