//! The arguments of a program's answers, in order: t, q, u, inputs, given u', prepared values.
//!
//! In: slices of the state. Out: one list, or [`Fault::Shape`] if a slice does not have the program's length.
//! Interpreter and compiled code both use this, so that they reject the same calls.

use super::derived::Program;
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::real::Real;

/// Values of t, q, u, inputs, of u' if an answer takes it, and of everything that depends on parameters alone.
#[derive(Clone, Debug)]
pub struct Arguments<S> {
    n_q: usize,
    n_u: usize,
    n_inputs: usize,
    n_u_dot: usize,
    values: Vec<S>,
}

impl<S: Real> Arguments<S> {
    /// All zeros; the last `n_prepared` values are the prepared ones.
    #[must_use]
    pub fn new(program: &Program, n_prepared: usize) -> Self {
        let (n_q, n_u, n_inputs) = (program.q.len(), program.u.len(), program.inputs.len());
        let n_u_dot = program.u_dot.len();
        let n = 1 + n_q + n_u + n_inputs + n_u_dot + n_prepared;
        Self { n_q, n_u, n_inputs, n_u_dot, values: vec![S::ZERO; n] }
    }

    /// Coordinates.
    #[must_use]
    pub fn n_q(&self) -> usize {
        self.n_q
    }

    /// Independent speeds.
    #[must_use]
    pub fn n_u(&self) -> usize {
        self.n_u
    }

    /// Inputs.
    #[must_use]
    pub fn n_inputs(&self) -> usize {
        self.n_inputs
    }

    /// All values in order.
    #[must_use]
    pub fn values(&self) -> &[S] {
        &self.values
    }

    /// The prepared values, to be filled in.
    pub fn prepared_mut(&mut self) -> &mut [S] {
        let first = 1 + self.n_q + self.n_u + self.n_inputs + self.n_u_dot;
        &mut self.values[first..]
    }

    /// Sets time, state and inputs.
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not the stated length.
    pub fn set(&mut self, t: S, q: &[S], u: &[S], inputs: &[S]) -> Result<(), Fault> {
        if inputs.len() != self.n_inputs {
            return Err(Fault::Shape);
        }
        self.set_state(q, u)?;
        self.set_time(t);
        let first = 1 + self.n_q + self.n_u;
        self.values[first..first + self.n_inputs].copy_from_slice(inputs);
        Ok(())
    }

    /// Sets given derivatives of the speeds; the slice must be empty if no answer takes them.
    ///
    /// # Errors
    /// [`Fault::Shape`] if the slice has not the stated length.
    pub fn set_u_dot(&mut self, u_dot: &[S]) -> Result<(), Fault> {
        if u_dot.len() != self.n_u_dot {
            return Err(Fault::Shape);
        }
        let first = 1 + self.n_q + self.n_u + self.n_inputs;
        self.values[first..first + self.n_u_dot].copy_from_slice(u_dot);
        Ok(())
    }

    /// Sets the time and nothing else.
    pub fn set_time(&mut self, t: S) {
        self.values[0] = t;
    }

    /// Sets the state; time and inputs are kept.
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not the stated length.
    pub fn set_state(&mut self, q: &[S], u: &[S]) -> Result<(), Fault> {
        if u.len() != self.n_u {
            return Err(Fault::Shape);
        }
        self.set_coordinates(q)?;
        self.values[1 + self.n_q..][..self.n_u].copy_from_slice(u);
        Ok(())
    }

    /// Sets the coordinates and nothing else.
    ///
    /// # Errors
    /// [`Fault::Shape`] if the slice has not the stated length.
    pub fn set_coordinates(&mut self, q: &[S]) -> Result<(), Fault> {
        if q.len() != self.n_q {
            return Err(Fault::Shape);
        }
        self.values[1..=self.n_q].copy_from_slice(q);
        Ok(())
    }

    /// Splits the results of `rates` into q' and u'; returns the worst pivot.
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not the stated length.
    pub fn split_rates(&self, rates: &[S], q_dot: &mut [S], u_dot: &mut [S]) -> Result<S, Fault> {
        if q_dot.len() != self.n_q || u_dot.len() != self.n_u {
            return Err(Fault::Shape);
        }
        let (first, rest) = rates.split_at(self.n_q);
        q_dot.copy_from_slice(first);
        u_dot.copy_from_slice(&rest[..self.n_u]);
        Ok(rest[self.n_u])
    }
}
