//! Error norm and step size controller of adaptive methods.
//!
//! norm = sqrt(mean((error_i / (absolute + relative max(|x_i|, |x_i new|)))^2)), accepted up to 1.
//! Next step = h * factor; factor from the present and the last accepted norm (PI control:
//! Gustafsson, Lundh & Soderlind 1988; constants of DOPRI5, Hairer & Wanner).

use crate::real::Scalar;

/// Safety factor on the step that the error estimate would allow.
const SAFETY: f64 = 0.9;
/// Weight of the present error: 1/5 - 0.75 `MEMORY`.
const PRESENT: f64 = 0.17;
/// Weight of the last accepted error.
const MEMORY: f64 = 0.04;
/// Smallest factor.
const SHRINK: f64 = 0.2;
/// Largest factor.
const GROW: f64 = 10.0;
/// Smaller norms count as this one: the logarithms of the controller stay bounded.
const LEAST_NORM: f64 = 1e-4;

/// Allowed error per step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance<S> {
    /// Absolute part, in the units of x.
    pub absolute: S,
    /// Part relative to |x|; at least ten rounding units, because a finer tolerance is met by no step, however short.
    pub relative: S,
}

impl<S: Scalar> Tolerance<S> {
    /// The norm of `errors`, given (old, new) values of the same entries; NaN if any of them is.
    pub fn norm(&self, errors: impl Iterator<Item = S>, values: impl Iterator<Item = (S, S)>) -> S {
        let start = (S::ZERO, S::ZERO);
        let relative = self.relative.max(S::from_f64(10.0) * S::EPSILON);
        let (sum, count) = errors.zip(values).fold(start, |(sum, count), (error, (old, new))| {
            let scale = self.absolute + relative * old.abs().max(new.abs());
            let share = error / scale;
            (sum + share * share, count + S::ONE)
        });
        (sum / count.max(S::ONE)).sqrt()
    }
}

/// Chooses step sizes; remembers the last accepted norm.
#[derive(Clone, Copy, Debug)]
pub struct Controller<S> {
    last: S,
    rejected: bool,
}

impl<S: Scalar> Default for Controller<S> {
    fn default() -> Self {
        Self { last: S::from_f64(LEAST_NORM), rejected: false }
    }
}

impl<S: Scalar> Controller<S> {
    /// The factor for the step after an accepted one; at most 1 right after a rejection.
    pub fn accept(&mut self, norm: S) -> S {
        let norm = norm.max(S::from_f64(LEAST_NORM));
        let power = S::from_f64(MEMORY) * self.last.ln() - S::from_f64(PRESENT) * norm.ln();
        let factor = S::from_f64(SAFETY) * power.exp();
        let most = if self.rejected { S::ONE } else { S::from_f64(GROW) };
        self.last = norm;
        self.rejected = false;
        factor.min(most).max(S::from_f64(SHRINK))
    }

    /// The factor for the next attempt after a rejected one; a norm that is not finite gives the smallest.
    pub fn reject(&mut self, norm: S) -> S {
        self.rejected = true;
        if !norm.is_finite() {
            return S::from_f64(SHRINK);
        }
        let factor = S::from_f64(SAFETY) * (-(S::from_f64(0.2) * norm.ln())).exp();
        factor.max(S::from_f64(SHRINK)).min(S::from_f64(SAFETY))
    }
}
