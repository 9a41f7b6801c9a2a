//! A mechanism with a control law for its inputs, as an [`Ode`].

use super::system::Ode;
use crate::mechanism::{Fault, Mechanism};
use crate::real::Real;

/// A mechanism and its control law: `law(t, q, u, inputs)` writes all inputs.
#[derive(Debug)]
pub struct Driven<'a, S, M, L> {
    /// The equations.
    pub mechanism: M,
    /// The control law.
    pub law: L,
    /// Corrections onto the configuration constraints after each step.
    pub projections: u8,
    /// Whether whole turns are subtracted from angles; outputs that count turns need `false`.
    pub wrap: bool,
    inputs: &'a mut [S],
}

impl<'a, S, M, L> Driven<'a, S, M, L>
where
    S: Real,
    M: Mechanism<S>,
    L: FnMut(S, &[S], &[S], &mut [S]),
{
    /// Joins them; `inputs` (`n_inputs` entries) is memory for the inputs. One projection
    /// after each step, no wrapping of angles.
    ///
    /// # Errors
    /// [`Fault::Shape`] if `inputs` does not have `n_inputs` entries.
    pub fn new(mechanism: M, law: L, inputs: &'a mut [S]) -> Result<Self, Fault> {
        if inputs.len() == mechanism.n_inputs() {
            Ok(Self { mechanism, law, projections: 1, wrap: false, inputs })
        } else {
            Err(Fault::Shape)
        }
    }
    /// The inputs of the last evaluation.
    pub fn inputs(&self) -> &[S] {
        self.inputs
    }
}

impl<S, M, L> Ode<S> for Driven<'_, S, M, L>
where
    S: Real,
    M: Mechanism<S>,
    L: FnMut(S, &[S], &[S], &mut [S]),
{
    fn n_x(&self) -> usize {
        self.mechanism.n_q() + self.mechanism.n_u()
    }
    fn n_q(&self) -> usize {
        self.mechanism.n_q()
    }
    fn rates(&mut self, t: S, x: &[S], x_dot: &mut [S]) -> Result<S, Fault> {
        let n_q = self.mechanism.n_q();
        let (q, u) = x.split_at_checked(n_q).ok_or(Fault::Shape)?;
        let (q_dot, u_dot) = x_dot.split_at_mut_checked(n_q).ok_or(Fault::Shape)?;
        (self.law)(t, q, u, self.inputs);
        self.mechanism.rates(t, q, u, self.inputs, q_dot, u_dot)
    }
    fn set_time(&mut self, t: S) {
        self.mechanism.set_time(t);
    }
    fn project(&mut self, x: &mut [S]) -> Result<S, Fault> {
        let n_q = self.mechanism.n_q();
        let (q, u) = x.split_at_mut_checked(n_q).ok_or(Fault::Shape)?;
        let residual = self.mechanism.project(q)?;
        self.mechanism.project_speeds(q, u)?;
        Ok(residual)
    }
    fn projections(&self) -> u8 {
        self.projections
    }
    fn is_angle(&self, index: usize) -> bool {
        self.wrap && index < self.mechanism.n_q() && self.mechanism.is_angle(index)
    }
}
