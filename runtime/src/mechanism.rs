//! What generated equations implement, and what the interpreter of `smartbed-codegen` implements too;
//! [`Driven`] adds the law that commands the inputs and so makes it a [`System`] for integrators.
//!
//! State of a system: x = [q, u], all coordinates and then the independent speeds, SI units.

use crate::real::Real;

/// Why an evaluation or a step was refused. The state given is left as it was.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Fault {
    /// A slice has not the length the mechanism needs.
    Shape,
    /// The worst pivot of the elimination came too close to zero: a singular configuration.
    Singular,
    /// A value became infinite or not a number.
    NonFinite,
    /// An adaptive method cut its step, or used up its steps, without meeting the tolerance.
    StepSize,
}

/// Equations of motion of one mechanism over the scalar `S`, with its parameters inside.
///
/// State: all coordinates `q` and the independent speeds `u`, SI units, in the model's order.
/// `&mut self` only because an interpreter keeps its scratch memory inside.
pub trait Mechanism<S: Real> {
    /// Number of coordinates q.
    fn n_q(&self) -> usize;
    /// Number of independent speeds u.
    fn n_u(&self) -> usize;
    /// Number of inputs.
    fn n_inputs(&self) -> usize;
    /// Writes q_dot (`n_q`) and u_dot (`n_u`) and returns the worst pivot of the eliminations
    /// (dimensionless, relative to its value at the nominal configuration; 1 without elimination).
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not the stated length.
    fn rates(
        &mut self,
        t: S,
        q: &[S],
        u: &[S],
        inputs: &[S],
        q_dot: &mut [S],
        u_dot: &mut [S],
    ) -> Result<S, Fault>;
    /// The time (s) at which [`Mechanism::project`] and [`Mechanism::energy`] are asked for next, where places
    /// depend on time; [`Mechanism::rates`] sets it too. Before the first of these calls it is 0.
    fn set_time(&mut self, t: S) {
        let _ = t;
    }
    /// One Newton correction that puts the dependent coordinates back on the configuration
    /// constraints; returns the largest residual before the correction.
    ///
    /// # Errors
    /// [`Fault::Shape`] if `q` has not `n_q` entries.
    fn project(&mut self, q: &mut [S]) -> Result<S, Fault>;
    /// Kinetic and potential energy (J).
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not the stated length.
    fn energy(&mut self, q: &[S], u: &[S]) -> Result<(S, S), Fault>;
    /// Whether coordinate number `index` is an angle that appears only inside sines and cosines, so
    /// that whole turns may be taken off.
    fn is_angle(&self, index: usize) -> bool {
        let _ = index;
        false
    }
}

/// Ordinary differential equations x_dot = f(t, x), perhaps with constraints to be projected onto.
pub trait System<S: Real> {
    /// Length of x.
    fn n_x(&self) -> usize;
    /// How many leading entries of x are coordinates; the rest are speeds.
    fn n_q(&self) -> usize;
    /// Writes x_dot and returns the worst pivot (see [`Mechanism::rates`]; 1 if there is none).
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not `n_x` entries.
    fn rates(&mut self, t: S, x: &[S], x_dot: &mut [S]) -> Result<S, Fault>;
    /// The time at which the next projections are asked for (see [`Mechanism::set_time`]).
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
    /// Whether whole turns may be taken off entry `index` of x.
    fn is_angle(&self, index: usize) -> bool {
        let _ = index;
        false
    }
}

/// A mechanism and the law that commands its inputs: `law(t, q, u, inputs)` writes all inputs.
#[derive(Debug)]
pub struct Driven<'a, S, M, L> {
    /// The equations.
    pub mechanism: M,
    /// What commands the inputs.
    pub law: L,
    /// Corrections onto the configuration constraints after each step.
    pub projections: u8,
    /// Whether whole turns are taken off angles; outputs that show turns need `false`.
    pub wrap: bool,
    inputs: &'a mut [S],
}

impl<'a, S, M, L> Driven<'a, S, M, L>
where
    S: Real,
    M: Mechanism<S>,
    L: FnMut(S, &[S], &[S], &mut [S]),
{
    /// Joins them; `inputs` (`n_inputs` entries) is memory for the commanded inputs. One projection
    /// after each step, no wrapping.
    ///
    /// # Errors
    /// [`Fault::Shape`] if `inputs` has not `n_inputs` entries.
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

impl<S, M, L> System<S> for Driven<'_, S, M, L>
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
        let (q, _) = x.split_at_mut_checked(n_q).ok_or(Fault::Shape)?;
        self.mechanism.project(q)
    }
    fn projections(&self) -> u8 {
        self.projections
    }
    fn is_angle(&self, index: usize) -> bool {
        self.wrap && index < self.mechanism.n_q() && self.mechanism.is_angle(index)
    }
}
