//! The state of a simulation as compensated sums: the value of an entry is x + low, unrounded.
//!
//! x + delta rounds away whatever is below half a unit in the last place of x: at 0.12 m in f32 that is 4 nm, so
//! a tile that creeps at 3 um/s would not move at all in steps of 1 ms. `low` keeps the part that was
//! rounded away (Kahan 1965; exact error of a sum: Knuth, TAOCP 4.2.2, theorem B,
//! which needs no comparison).
//! Invariant: |low| is at most half a unit in the last place of x.

use crate::mechanism::Fault;
use crate::real::Scalar;

/// a + b = sum + error, exactly (barring overflow).
#[inline(always)]
pub fn two_sum<S: Scalar>(a: S, b: S) -> (S, S) {
    let sum = a + b;
    let b_seen = sum - a;
    (sum, (a - (sum - b_seen)) + (b - b_seen))
}

/// (x, low) + delta, with an error of the rounding unit of `low`.
#[inline(always)]
pub fn advance<S: Scalar>(x: S, low: S, delta: S) -> (S, S) {
    let (sum, error) = two_sum(x, delta);
    two_sum(sum, low + error)
}

/// (x, low) less whole turns, x in [-pi, pi] up to rounding; unchanged if it is there already.
#[inline]
pub fn wrap<S: Scalar>(x: S, low: S) -> (S, S) {
    let n = -x.turns();
    S::TURN.iter().fold((x, low), |(x, low), part| advance(x, low, n * *part))
}

/// A borrowed state: coordinates and speeds, each with the rounding error of its sum.
#[derive(Debug)]
pub struct State<'a, S> {
    x: &'a mut [S],
    low: &'a mut [S],
}

impl<'a, S: Scalar> State<'a, S> {
    /// The state that starts at `x`; `low` is memory of the same length and is set to zero.
    ///
    /// # Errors
    /// [`Fault::Shape`] if the lengths differ.
    pub fn new(x: &'a mut [S], low: &'a mut [S]) -> Result<Self, Fault> {
        low.fill(S::ZERO);
        Self::resume(x, low)
    }

    /// The state that continues from `x` and `low` as an earlier one left them.
    ///
    /// # Errors
    /// [`Fault::Shape`] if the lengths differ.
    pub fn resume(x: &'a mut [S], low: &'a mut [S]) -> Result<Self, Fault> {
        if x.len() == low.len() { Ok(Self { x, low }) } else { Err(Fault::Shape) }
    }

    /// The values, rounded.
    #[must_use]
    pub fn x(&self) -> &[S] {
        self.x
    }

    /// Rounding errors of [`State::x`]: the exact value is x + low.
    #[must_use]
    pub fn low(&self) -> &[S] {
        self.low
    }

    /// Sets the state to exactly `x`.
    ///
    /// # Errors
    /// [`Fault::Shape`] if the lengths differ; nothing is changed then.
    pub fn set(&mut self, x: &[S]) -> Result<(), Fault> {
        if x.len() != self.x.len() {
            return Err(Fault::Shape);
        }
        self.x.iter_mut().zip(x).for_each(|(own, given)| *own = *given);
        self.low.fill(S::ZERO);
        Ok(())
    }

    /// Pairs (x, low) to be overwritten.
    pub(crate) fn entries(&mut self) -> impl Iterator<Item = (&mut S, &mut S)> {
        self.x.iter_mut().zip(self.low.iter_mut())
    }
}
