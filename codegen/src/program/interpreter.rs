//! A program run by the interpreter: the same operations as the emitted Rust, hence the same bits.

use super::Program;
use crate::expr::SymbolId;
use crate::expr::tape::Tape;
use smartbed_runtime::mechanism::{Fault, Mechanism};
use smartbed_runtime::real::Real;

/// A mechanism without a compiler in between.
#[derive(Clone, Debug)]
pub struct Interpreted<S> {
    n_q: usize,
    n_u: usize,
    n_inputs: usize,
    /// t, q, u, inputs, parameters.
    arguments: Vec<S>,
    results: Vec<S>,
    corrected: Vec<usize>,
    angles: Vec<bool>,
    rates: Tape<S>,
    projection: Tape<S>,
    energy: Tape<S>,
    speeds: Tape<S>,
    outputs: Tape<S>,
}

impl<S: Real> Interpreted<S> {
    /// The program with its default parameters, each rounded once to the scalar.
    #[must_use]
    pub fn new(program: &Program) -> Self {
        let mut symbols: Vec<SymbolId> = vec![program.time];
        for group in [&program.q, &program.u, &program.inputs, &program.parameters] {
            symbols.extend(group.iter().map(|quantity| quantity.symbol));
        }
        let tape = |roots: Vec<_>| Tape::new(&program.dag, &roots, &symbols);
        let mut rates = program.forward_dynamics();
        rates.push(program.rates.worst_pivot);
        let mut projection: Vec<_> = program.correction.iter().map(|(_, e)| *e).collect();
        projection.push(program.residual);
        let mut arguments = vec![S::ZERO; symbols.len()];
        let first = symbols.len() - program.parameters.len();
        for (argument, parameter) in arguments[first..].iter_mut().zip(&program.parameters) {
            *argument = S::from_f64(parameter.value);
        }
        let longest = rates.len().max(program.speeds.len()).max(program.outputs.len()).max(2);
        Self {
            n_q: program.q.len(),
            n_u: program.u.len(),
            n_inputs: program.inputs.len(),
            arguments,
            results: vec![S::ZERO; longest],
            corrected: program.correction.iter().map(|(i, _)| *i).collect(),
            angles: program.q.iter().map(|q| q.is_angle).collect(),
            rates: tape(rates),
            projection: tape(projection),
            energy: tape(program.energy.to_vec()),
            speeds: tape(program.speeds.iter().map(|(_, e)| *e).collect()),
            outputs: tape(program.outputs.iter().map(|(_, e)| *e).collect()),
        }
    }

    /// Sets all parameters, in the program's order.
    pub fn set_parameters(&mut self, values: &[S]) {
        let first = 1 + self.n_q + self.n_u + self.n_inputs;
        for (argument, &value) in self.arguments[first..].iter_mut().zip(values) {
            *argument = value;
        }
    }

    fn set(&mut self, t: S, q: &[S], u: &[S], inputs: &[S]) -> Result<(), Fault> {
        if q.len() != self.n_q || u.len() != self.n_u || inputs.len() != self.n_inputs {
            return Err(Fault::Shape);
        }
        let state = [t].into_iter().chain(q.iter().chain(u).chain(inputs).copied());
        for (argument, value) in self.arguments.iter_mut().zip(state) {
            *argument = value;
        }
        Ok(())
    }

    fn set_state(&mut self, q: &[S], u: &[S]) -> Result<(), Fault> {
        if q.len() != self.n_q || u.len() != self.n_u {
            return Err(Fault::Shape);
        }
        for (argument, &value) in self.arguments[1..].iter_mut().zip(q.iter().chain(u)) {
            *argument = value;
        }
        Ok(())
    }

    /// All speeds of the model, dependent ones included, in the model's order.
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not the stated length.
    pub fn speeds(&mut self, q: &[S], u: &[S]) -> Result<Vec<S>, Fault> {
        self.set_state(q, u)?;
        let mut values = vec![S::ZERO; self.speeds.n_outputs()];
        self.speeds.run(&self.arguments, &mut values);
        Ok(values)
    }

    /// The model's outputs, in its order.
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not the stated length.
    pub fn outputs(&mut self, t: S, q: &[S], u: &[S], inputs: &[S]) -> Result<Vec<S>, Fault> {
        self.set(t, q, u, inputs)?;
        let mut values = vec![S::ZERO; self.outputs.n_outputs()];
        self.outputs.run(&self.arguments, &mut values);
        Ok(values)
    }

    /// Largest constraint residual of a configuration.
    ///
    /// # Errors
    /// [`Fault::Shape`] if `q` has not `n_q` entries.
    pub fn residual(&mut self, q: &[S]) -> Result<S, Fault> {
        let mut q = q.to_vec();
        self.project(&mut q)
    }
}

impl<S: Real> Mechanism<S> for Interpreted<S> {
    fn n_q(&self) -> usize {
        self.n_q
    }

    fn n_u(&self) -> usize {
        self.n_u
    }

    fn n_inputs(&self) -> usize {
        self.n_inputs
    }

    fn is_angle(&self, index: usize) -> bool {
        self.angles.get(index).copied().unwrap_or(false)
    }

    fn rates(
        &mut self,
        t: S,
        q: &[S],
        u: &[S],
        inputs: &[S],
        q_dot: &mut [S],
        u_dot: &mut [S],
    ) -> Result<S, Fault> {
        if q_dot.len() != self.n_q || u_dot.len() != self.n_u {
            return Err(Fault::Shape);
        }
        self.set(t, q, u, inputs)?;
        self.rates.run(&self.arguments, &mut self.results);
        let (first, rest) = self.results.split_at(self.n_q);
        q_dot.copy_from_slice(first);
        u_dot.copy_from_slice(&rest[..self.n_u]);
        Ok(rest[self.n_u])
    }

    fn project(&mut self, q: &mut [S]) -> Result<S, Fault> {
        if q.len() != self.n_q {
            return Err(Fault::Shape);
        }
        self.arguments[1..=self.n_q].copy_from_slice(q);
        self.projection.run(&self.arguments, &mut self.results);
        for (&index, &correction) in self.corrected.iter().zip(&self.results) {
            q[index] = q[index] + correction;
        }
        Ok(self.results[self.corrected.len()])
    }

    fn energy(&mut self, q: &[S], u: &[S]) -> Result<(S, S), Fault> {
        self.set_state(q, u)?;
        let mut energy = [S::ZERO; 2];
        self.energy.run(&self.arguments, &mut energy);
        Ok((energy[0], energy[1]))
    }
}
