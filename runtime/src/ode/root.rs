//! Where a guard g(t) changes its sign: the one root finder, bracketed, bounded and without derivatives.
//!
//! [`Search`] proposes times and takes the values there, so that its caller may evaluate g as it must, by a whole
//! trial step for instance. Inverse parabolas through the last three values; where these leave the bracket, false
//! position (Anderson & Bjorck 1973); every sixth time is the middle, which bounds the search.
//! [`locate()`] runs it on a function: the bracket (low, high) of the root that it leaves has g's sign of the start
//! at `low`: the caller stops before the event or steps over it, as it needs.

use crate::real::Scalar;

/// Every so many proposals one is the middle.
const BISECTION: u32 = 6;
/// Evaluations of [`locate()`] at most: so many for each of the 53 halvings that exhaust f64, and some to spare.
pub const MAX_EVALUATIONS: u32 = 400;

/// Why no root was located.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RootFault {
    /// The guard has the same sign at both ends, or is no number at one of them.
    NotBracketed,
    /// The guard became not-a-number inside the bracket.
    NonFinite,
}

/// A bracket under way: (t, g) on both sides of the root, the newer one last.
#[derive(Clone, Copy, Debug)]
pub struct Search<S> {
    old: (S, S),
    new: (S, S),
    last: [(S, S); 3],
    guess: Option<S>,
    proposals: u32,
}

impl<S: Scalar> Search<S> {
    /// Between two (t, g) of opposite signs; `guess`, if it lies between, is proposed first.
    #[must_use]
    pub fn new(low: (S, S), high: (S, S), guess: Option<S>) -> Self {
        Self { old: low, new: high, last: [low, low, high], guess, proposals: 0 }
    }

    /// Ends of the bracket as they were found, not by size.
    #[must_use]
    pub fn ends(&self) -> (S, S) {
        (self.old.0, self.new.0)
    }

    /// The time to evaluate g at; inside the bracket, or an end of it where nothing lies between.
    pub fn propose(&mut self) -> S {
        let ((old, f_old), (new, f_new)) = (self.old, self.new);
        let inside = |t: &S| *t > new.min(old) && *t < new.max(old);
        let secant = (old * f_new - new * f_old) / (f_new - f_old);
        let curved = if self.proposals == 0 { self.guess } else { Some(inverse_parabola(self.last)) };
        let guess = curved.filter(inside).or(Some(secant).filter(inside));
        let is_bisection = self.proposals % BISECTION == BISECTION - 1;
        self.proposals += 1;
        let half = S::from_f64(0.5);
        if is_bisection { None } else { guess }.unwrap_or(half * (old + new))
    }

    /// Takes the value `g` at the time proposed last.
    pub fn take(&mut self, t: S, g: S) {
        if (g < S::ZERO) == (self.new.1 < S::ZERO) {
            // The end that stays counts for less, so that it moves next time.
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
/// [`RootFault`] if there is no sign change or `g` fails.
pub fn locate<S: Scalar>(mut g: impl FnMut(S) -> S, low: S, high: S, width: S) -> Result<(S, S), RootFault> {
    let (g_low, g_high) = (g(low), g(high));
    let rising = g_low <= S::ZERO && S::ZERO <= g_high;
    let falling = g_high <= S::ZERO && S::ZERO <= g_low;
    if !(rising || falling) {
        return Err(RootFault::NotBracketed);
    }
    // Searched for as a guard that falls below 0; one that ends at 0 does so there.
    let sign = if rising { -S::ONE } else { S::ONE };
    let beyond = if g_high == S::ZERO { -S::EPSILON } else { sign * g_high };
    let mut search = Search::new((low, sign * g_low), (high, beyond), None);
    for _ in 0..MAX_EVALUATIONS {
        let (a, b) = search.ends();
        let (low, high) = (a.min(b), a.max(b));
        let middle = low + S::from_f64(0.5) * (high - low);
        if high - low <= width || !(low < middle && middle < high) {
            break;
        }
        let t = search.propose();
        let value = sign * g(t);
        if !value.is_finite() {
            return Err(RootFault::NonFinite);
        }
        search.take(t, value);
    }
    let (a, b) = search.ends();
    Ok((a.min(b), a.max(b)))
}
