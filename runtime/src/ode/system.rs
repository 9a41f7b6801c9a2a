//! The interface that methods integrate: rates of x = [q, u], and a projection onto constraints where there are any.

use crate::mechanism::Fault;
use crate::real::Real;

/// Ordinary differential equations x_dot = f(t, x), perhaps with constraints to be projected onto.
pub trait Ode<S: Real> {
    /// Length of x.
    fn n_x(&self) -> usize;
    /// How many leading entries of x are coordinates; the rest are speeds.
    fn n_q(&self) -> usize;
    /// Writes x_dot and returns the worst pivot (see [`Mechanism::rates`](crate::mechanism::Mechanism::rates); 1 if
    /// there is none).
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not `n_x` entries.
    fn rates(&mut self, t: S, x: &[S], x_dot: &mut [S]) -> Result<S, Fault>;
    /// Writes the rates of the coordinates; entries of the speeds may hold anything. Cheaper than [`Ode::rates`] where
    /// forces are expensive.
    ///
    /// # Errors
    /// As [`Ode::rates`].
    fn coordinate_rates(&mut self, t: S, x: &[S], x_dot: &mut [S]) -> Result<S, Fault> {
        self.rates(t, x, x_dot)
    }
    /// Whether the rates of the speeds depend on the speeds.
    fn is_damped(&self) -> bool {
        true
    }
    /// Sets the time of the next projections (see [`Mechanism::set_time`](crate::mechanism::Mechanism::set_time)).
    fn set_time(&mut self, t: S) {
        let _ = t;
    }
    /// One correction towards the constraints; returns the largest residual before it.
    ///
    /// # Errors
    /// [`Fault::Shape`] if `x` has not `n_x` entries.
    fn project(&mut self, x: &mut [S]) -> Result<S, Fault> {
        let _ = x;
        Ok(S::ZERO)
    }
    /// Corrections after each step: 0 without constraints, else 1, at most 2.
    fn projections(&self) -> u8 {
        0
    }
    /// Whether a step from `t` to t + `h`, evaluated at these parts of it, hides something that depends on time alone,
    /// such as a short pulse: an adaptive method then takes a shorter one.
    fn hides(&mut self, t: S, h: S, stages: &[S]) -> bool {
        let _ = (t, h, stages);
        false
    }
    /// Whether whole turns may be subtracted from entry `index` of x.
    fn is_angle(&self, index: usize) -> bool {
        let _ = index;
        false
    }
}
