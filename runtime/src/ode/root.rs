//! Locates a sign change of a guard g(t): the one root finder, bracketed, bounded and without derivatives.
//!
//! [`Search`] proposes times and takes the values of g there, so that its caller may evaluate g in any way, by a whole
//! trial step for instance. Proposals: inverse quadratic interpolation through the last three values; where it leaves
//! the bracket, false position (Anderson & Bjorck 1973). Those of [`locate()`] are drawn towards the middle as far as
//! needed to never take [`SPARE`] evaluations more than bisection, also where g jumps (Oliveira & Takahashi 2020).
//! [`locate()`] runs it on a function and returns a bracket (low, high) of the root. g at `low` has the sign of the
//! start, so the caller may stop before the event (low) or behind it (high).

use crate::real::Scalar;

/// One proposal in so many is the middle of a bracket that is not [`Search::bounded`].
const BISECTION: u32 = 6;
/// Proposals that may leave the bracket as it is, more than bisection would make.
pub const SPARE: i32 = 10;
/// Most evaluations of [`locate()`]: halvings down to the smallest numbers are fewer where the root is not near 0.
pub const MAX_EVALUATIONS: u32 = 400;

/// Why no root was located.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RootFault {
    /// The guard has the same sign at both ends, or is no number at one of them; or the bracket's length is not finite.
    NotBracketed,
    /// The bracket is still wider after [`MAX_EVALUATIONS`]: it was longer than the width by too many orders of
    /// magnitude.
    NotConverged,
    /// The guard became not-a-number inside the bracket.
    NonFinite,
}

/// A bracket that is being narrowed: (t, g) on both sides of the root; `new` is the end found last.
#[derive(Clone, Copy, Debug)]
pub struct Search<S> {
    old: (S, S),
    new: (S, S),
    last: [(S, S); 3],
    guess: Option<S>,
    /// Half of the length that the bracket may have after the next proposal; without, every sixth one is the middle.
    allowed: Option<S>,
    proposals: u32,
}

impl<S: Scalar> Search<S> {
    /// Between two (t, g) of opposite signs; `guess`, if it lies between, is proposed first.
    #[must_use]
    pub fn new(low: (S, S), high: (S, S), guess: Option<S>) -> Self {
        Self { old: low, new: high, last: [low, low, high], guess, allowed: None, proposals: 0 }
    }

    /// The same, never more than [`SPARE`] proposals more than bisection makes.
    #[must_use]
    pub fn bounded(low: (S, S), high: (S, S)) -> Self {
        let allowed = (high.0 - low.0).abs() * S::from_f64(0.25 * f64::from(1 << SPARE));
        Self { allowed: Some(allowed), ..Self::new(low, high, None) }
    }

    /// Ends of the bracket in the order in which they were found, not by size.
    #[must_use]
    pub fn ends(&self) -> (S, S) {
        (self.old.0, self.new.0)
    }

    /// The time at which to evaluate g next: inside the bracket, or an end of it where no number lies between.
    pub fn propose(&mut self) -> S {
        let ((old, f_old), (new, f_new)) = (self.old, self.new);
        let inside = |t: &S| *t > new.min(old) && *t < new.max(old);
        let secant = (old * f_new - new * f_old) / (f_new - f_old);
        let curved = if self.proposals == 0 { self.guess } else { Some(inverse_parabola(self.last)) };
        let guess = curved.filter(inside).or(Some(secant).filter(inside));
        self.proposals += 1;
        let half = S::from_f64(0.5);
        let Some(allowed) = self.allowed else {
            let is_bisection = self.proposals.is_multiple_of(BISECTION);
            return if is_bisection { None } else { guess }.unwrap_or(half * (old + new));
        };
        let (middle, reach) = (old + half * (new - old), half * (new - old).abs());
        // The longer part that it leaves must not be longer than allowed.
        let slack = (allowed - reach).max(S::ZERO);
        self.allowed = Some(half * allowed);
        let drawn = guess.unwrap_or(middle).max(middle - slack).min(middle + slack);
        if inside(&drawn) { drawn } else { middle }
    }

    /// Takes the value `g` at the time proposed last.
    pub fn take(&mut self, t: S, g: S) {
        if (g < S::ZERO) == (self.new.1 < S::ZERO) {
            // Lower the weight of the end that stays, so that it moves next time (Anderson & Bjorck).
            let ratio = S::ONE - g / self.new.1;
            self.old.1 = self.old.1 * if ratio > S::ZERO { ratio } else { S::from_f64(0.5) };
        } else {
            self.old = self.new;
        }
        self.new = (t, g);
        self.last = [self.last[1], self.last[2], (t, g)];
    }
}

/// Zero of the parabola t(g) through three points (t, g); not a number where two have the same g.
fn inverse_parabola<S: Scalar>([(a, fa), (b, fb), (c, fc)]: [(S, S); 3]) -> S {
    let at_a = a * (fb / (fa - fb)) * (fc / (fa - fc));
    let at_b = b * (fa / (fb - fa)) * (fc / (fb - fc));
    let at_c = c * (fa / (fc - fa)) * (fb / (fc - fb));
    at_a + at_b + at_c
}

/// Narrows [low, high] around a sign change of `g` to `width`, or to neighbouring numbers.
///
/// # Errors
/// [`RootFault`] if there is no sign change, `g` fails, or the bracket is longer than `width` beyond measure.
pub fn locate<S: Scalar>(g: impl FnMut(S) -> S, low: S, high: S, width: S) -> Result<(S, S), RootFault> {
    reach(g, [low, high], width, S::ZERO)
}

/// As [`locate()`]; ends earlier at a time where |g| <= `near`, which both ends of the bracket then are.
///
/// # Errors
/// As [`locate()`].
pub fn reach<S: Scalar>(
    mut g: impl FnMut(S) -> S,
    [low, high]: [S; 2],
    width: S,
    near: S,
) -> Result<(S, S), RootFault> {
    let (g_low, g_high) = (g(low), g(high));
    let rising = g_low <= S::ZERO && S::ZERO <= g_high;
    let falling = g_high <= S::ZERO && S::ZERO <= g_low;
    if !((rising || falling) && (high - low).is_finite()) {
        return Err(RootFault::NotBracketed);
    }
    // Search for a guard that falls below 0; one that ends at exactly 0 counts as falling there.
    let sign = if rising { -S::ONE } else { S::ONE };
    let beyond = if g_high == S::ZERO { -S::EPSILON } else { sign * g_high };
    let mut search = Search::bounded((low, sign * g_low), (high, beyond));
    for _ in 0..MAX_EVALUATIONS {
        let (a, b) = search.ends();
        let (low, high) = (a.min(b), a.max(b));
        let middle = low + S::from_f64(0.5) * (high - low);
        if high - low <= width || !(low < middle && middle < high) {
            return Ok((low, high));
        }
        let t = search.propose();
        let value = sign * g(t);
        if !value.is_finite() {
            return Err(RootFault::NonFinite);
        }
        if value.abs() <= near {
            return Ok((t, t));
        }
        search.take(t, value);
    }
    Err(RootFault::NotConverged)
}
