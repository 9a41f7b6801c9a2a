//! A program run by the interpreter: the same operations as the emitted Rust, hence the same bits.

use super::{Program, Quantity};
use crate::expr::tape::Tape;
use crate::expr::{ExprId, Node, SymbolId};
use smartbed_runtime::mechanism::{Fault, Mechanism};
use smartbed_runtime::real::Real;

/// A mechanism without a compiler in between.
#[derive(Clone, Debug)]
pub struct Interpreted<S> {
    n_q: usize,
    n_u: usize,
    n_inputs: usize,
    /// t, q, u, inputs, prepared values.
    arguments: Vec<S>,
    /// From the parameters to the prepared values.
    prepare: Tape<S>,
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
        let mut rates = program.forward_dynamics();
        rates.push(program.rates.worst_pivot);
        let mut projection: Vec<_> = program.correction.iter().map(|(_, e)| *e).collect();
        projection.push(program.residual);
        let second = |list: &[(String, ExprId)]| -> Vec<ExprId> { list.iter().map(|(_, e)| *e).collect() };
        let answers =
            [rates, projection, program.energy.to_vec(), second(&program.speeds), second(&program.outputs)];
        let symbols = |list: &[Quantity]| -> Vec<SymbolId> { list.iter().map(|x| x.symbol).collect() };
        let prepared = program.prepared(&answers.concat());
        let prepare = Tape::new(&program.dag, &prepared, &symbols(&program.parameters));
        let mut inputs: Vec<ExprId> = vec![program.time]
            .into_iter()
            .chain([&program.q, &program.u, &program.inputs].into_iter().flat_map(|list| symbols(list)))
            .filter_map(|symbol| program.dag.find(Node::Symbol(symbol)))
            .collect();
        inputs.extend(prepared);
        let longest = answers.iter().map(Vec::len).max().unwrap_or(0);
        let [rates, projection, energy, speeds, outputs] =
            answers.map(|roots| Tape::above(&program.dag, &roots, &inputs));
        let parameters: Vec<S> = program.parameters.iter().map(|p| S::from_f64(p.value)).collect();
        let mut this = Self {
            n_q: program.q.len(),
            n_u: program.u.len(),
            n_inputs: program.inputs.len(),
            arguments: vec![S::ZERO; inputs.len()],
            prepare,
            results: vec![S::ZERO; longest],
            corrected: program.correction.iter().map(|(i, _)| *i).collect(),
            angles: program.q.iter().map(|q| q.is_angle).collect(),
            rates,
            projection,
            energy,
            speeds,
            outputs,
        };
        this.set_parameters(&parameters);
        this
    }

    /// Sets all parameters, in the program's order.
    pub fn set_parameters(&mut self, values: &[S]) {
        let first = 1 + self.n_q + self.n_u + self.n_inputs;
        self.prepare.run(values, &mut self.arguments[first..]);
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
