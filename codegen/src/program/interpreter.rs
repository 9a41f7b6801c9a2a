//! Runs a program by the interpreter: the same operations as the emitted Rust, hence the same bits.

use super::arguments::Arguments;
use super::derived::{Program, Quantity};
use crate::expr::tape::Tape;
use crate::expr::{ExprId, Node, SymbolId};
use smartbed_runtime::mechanism::{Fault, Mechanism};
use smartbed_runtime::real::Real;

/// A mechanism that runs without a compiler.
#[derive(Clone, Debug)]
pub struct Interpreted<S> {
    arguments: Arguments<S>,
    /// Computes the prepared values from the parameters.
    prepare: Tape<S>,
    results: Vec<S>,
    corrected: Vec<usize>,
    angles: Vec<bool>,
    rates: Tape<S>,
    projection: Tape<S>,
    energy: Tape<S>,
    speeds: Tape<S>,
    outputs: Tape<S>,
    drive: Tape<S>,
    speed_projection: Tape<S>,
    /// One tape per requested function.
    functions: Vec<Tape<S>>,
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
        let (speeds, outputs) = (second(&program.speeds), second(&program.outputs));
        let drive = program.drive.into_iter().collect();
        let speed_projection = program.speed_correction.clone();
        let answers = [rates, projection, program.energy.to_vec(), speeds, outputs, drive, speed_projection];
        let functions: Vec<Vec<ExprId>> =
            program.functions.iter().map(|function| program.function_roots(function)).collect();
        let symbols = |list: &[Quantity]| -> Vec<SymbolId> { list.iter().map(|x| x.symbol).collect() };
        let prepared = program.prepared(&[answers.concat(), functions.concat()].concat());
        let prepare = Tape::new(&program.dag, &prepared, &symbols(&program.parameters));
        let mut inputs: Vec<ExprId> = vec![program.time]
            .into_iter()
            .chain(
                [&program.q, &program.u, &program.inputs, &program.u_dot]
                    .into_iter()
                    .flat_map(|list| symbols(list)),
            )
            .filter_map(|symbol| program.dag.find(Node::Symbol(symbol)))
            .collect();
        let n_prepared = prepared.len();
        inputs.extend(prepared);
        let longest = answers.iter().map(Vec::len).max().unwrap_or(0);
        let [rates, projection, energy, speeds, outputs, drive, speed_projection] =
            answers.map(|roots| Tape::above(&program.dag, &roots, &inputs));
        let functions = functions.iter().map(|roots| Tape::above(&program.dag, roots, &inputs)).collect();
        let parameters: Vec<S> = program.parameters.iter().map(|p| S::from_f64(p.value)).collect();
        let mut this = Self {
            arguments: Arguments::new(program, n_prepared),
            prepare,
            results: vec![S::ZERO; longest],
            corrected: program.correction.iter().map(|(i, _)| *i).collect(),
            angles: program.q.iter().map(|q| q.is_angle).collect(),
            rates,
            projection,
            energy,
            speeds,
            outputs,
            drive,
            speed_projection,
            functions,
        };
        this.set_parameters(&parameters);
        this
    }

    /// Sets all parameters, in the program's order.
    pub fn set_parameters(&mut self, values: &[S]) {
        self.prepare.run(values, self.arguments.prepared_mut());
    }

    /// All speeds of the model, dependent ones included, in the model's order, at the time last set.
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not the stated length.
    pub fn speeds(&mut self, q: &[S], u: &[S]) -> Result<Vec<S>, Fault> {
        self.arguments.set_state(q, u)?;
        let mut values = vec![S::ZERO; self.speeds.n_outputs()];
        self.speeds.run(self.arguments.values(), &mut values);
        Ok(values)
    }

    /// The model's outputs, in its order.
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not the stated length.
    pub fn outputs(&mut self, t: S, q: &[S], u: &[S], inputs: &[S]) -> Result<Vec<S>, Fault> {
        self.arguments.set(t, q, u, inputs)?;
        let mut values = vec![S::ZERO; self.outputs.n_outputs()];
        self.outputs.run(self.arguments.values(), &mut values);
        Ok(values)
    }

    /// The power (W) supplied by the drive; 0 if the model is not driven.
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not the stated length.
    pub fn drive(&mut self, t: S, q: &[S], u: &[S], inputs: &[S]) -> Result<S, Fault> {
        self.arguments.set(t, q, u, inputs)?;
        let mut power = [S::ZERO];
        self.drive.run(self.arguments.values(), &mut power);
        Ok(power[0])
    }

    /// The results of a requested function, by its index in [`Program::functions`]: all parts of all its answers in
    /// order. `u_dot` is empty if no answer of the program takes it.
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not the stated length, or there is no such function.
    pub fn function(
        &mut self,
        place: usize,
        (t, q, u, inputs, u_dot): (S, &[S], &[S], &[S], &[S]),
    ) -> Result<Vec<S>, Fault> {
        self.arguments.set(t, q, u, inputs)?;
        self.arguments.set_u_dot(u_dot)?;
        let tape = self.functions.get_mut(place).ok_or(Fault::Shape)?;
        let mut values = vec![S::ZERO; tape.n_outputs()];
        tape.run(self.arguments.values(), &mut values);
        Ok(values)
    }

    /// Largest constraint residual of a configuration, at the time last set.
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
        self.arguments.n_q()
    }

    fn n_u(&self) -> usize {
        self.arguments.n_u()
    }

    fn n_inputs(&self) -> usize {
        self.arguments.n_inputs()
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
        self.arguments.set(t, q, u, inputs)?;
        self.rates.run(self.arguments.values(), &mut self.results);
        self.arguments.split_rates(&self.results, q_dot, u_dot)
    }

    fn set_time(&mut self, t: S) {
        self.arguments.set_time(t);
    }

    fn project(&mut self, q: &mut [S]) -> Result<S, Fault> {
        self.arguments.set_coordinates(q)?;
        self.projection.run(self.arguments.values(), &mut self.results);
        for (&index, &correction) in self.corrected.iter().zip(&self.results) {
            q[index] = q[index] + correction;
        }
        Ok(self.results[self.corrected.len()])
    }

    fn project_speeds(&mut self, q: &[S], u: &mut [S]) -> Result<(), Fault> {
        self.arguments.set_state(q, u)?;
        self.speed_projection.run(self.arguments.values(), &mut self.results);
        let n = self.speed_projection.n_outputs();
        for (speed, &correction) in u.iter_mut().zip(&self.results[..n]) {
            *speed = *speed + correction;
        }
        Ok(())
    }

    fn energy(&mut self, q: &[S], u: &[S]) -> Result<(S, S), Fault> {
        self.arguments.set_state(q, u)?;
        let mut energy = [S::ZERO; 2];
        self.energy.run(self.arguments.values(), &mut energy);
        Ok((energy[0], energy[1]))
    }
}
