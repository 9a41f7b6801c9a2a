//! The mechanism that integrators step: the engine of its equations together with the laws of its inputs.
//!
//! In: an engine and the laws as a program. Out: rates, projection, and the answers of the engine, with the inputs that
//! the laws give at each state.

use crate::engine::{Engine, EngineScalar};
use crate::observers::Observers;
use crate::switches::Switches;
use crate::switches::between::Between;
use smartbed_codegen::{Interpreted, Program};
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::Ode;

/// A mechanism with its laws, as integrators step it.
#[derive(Debug)]
pub struct Plant<E, S> {
    pub(super) engine: E,
    law: Interpreted<S>,
    law_inputs: Vec<usize>,
    closed_forms: Interpreted<S>,
    /// Times at which commands, laws and loads switch.
    pub(crate) switches: Switches<S>,
    /// What happens between the stages of a step, if it is looked for.
    between: Option<Between>,
    pub(super) inputs: Vec<S>,
    projections: u8,
    evaluations: u64,
}

impl<E: std::ops::DerefMut<Target = dyn Engine<S>>, S: EngineScalar> Ode<S> for Plant<E, S> {
    fn n_x(&self) -> usize {
        self.engine.n_q() + self.engine.n_u()
    }
    fn n_q(&self) -> usize {
        self.engine.n_q()
    }
    fn rates(&mut self, t: S, x: &[S], x_dot: &mut [S]) -> Result<S, Fault> {
        self.evaluations += 1;
        let t = self.switches.moment(t)?;
        self.command(t, x)?;
        let n_q = self.engine.n_q();
        let (q, u) = x.split_at_checked(n_q).ok_or(Fault::Shape)?;
        let (q_dot, u_dot) = x_dot.split_at_mut_checked(n_q).ok_or(Fault::Shape)?;
        self.engine.rates(t, q, u, &self.inputs, q_dot, u_dot)
    }
    fn set_time(&mut self, t: S) {
        self.engine.set_time(self.switches.moment(t).unwrap_or(t));
    }
    fn project(&mut self, x: &mut [S]) -> Result<S, Fault> {
        let n_q = self.engine.n_q();
        let (q, u) = x.split_at_mut_checked(n_q).ok_or(Fault::Shape)?;
        let residual = self.engine.project(q)?;
        self.engine.project_speeds(q, u)?;
        Ok(residual)
    }
    fn projections(&self) -> u8 {
        self.projections
    }
    fn hides(&mut self, t: S, h: S, stages: &[S]) -> bool {
        let Some(between) = &self.between else { return false };
        let stages: Vec<f64> = stages.iter().map(|c| c.to_f64()).collect();
        between.hides(t.to_f64(), h.to_f64(), &stages)
    }
}

impl<E: std::ops::DerefMut<Target = dyn Engine<S>>, S: EngineScalar> Plant<E, S> {
    /// Joins an engine and the laws.
    pub fn new(engine: E, program: &Program, observers: &Observers) -> Self {
        Self {
            engine,
            law: Interpreted::new(&observers.laws()),
            law_inputs: observers.law_inputs.clone(),
            closed_forms: Interpreted::new(&observers.closed_forms()),
            switches: Switches::new(observers),
            between: None,
            inputs: vec![S::ZERO; program.inputs.len()],
            projections: u8::from(!program.correction.is_empty() || program.is_redundant()),
            evaluations: 0,
        }
    }

    /// From now on adaptive steps hide no pulse, in a run over so many seconds with this step (s).
    ///
    /// # Errors
    /// The engine's.
    pub(crate) fn watch(&mut self, observers: &Observers, seconds: f64, step: f64) -> Result<(), Fault> {
        self.between = Between::new(observers, seconds, step)?;
        Ok(())
    }

    /// Evaluations of the equations of motion so far.
    #[must_use]
    pub fn evaluations(&self) -> u64 {
        self.evaluations
    }

    /// Values and rates of the coordinates in closed form.
    ///
    /// # Errors
    /// [`Fault::Shape`] if the state has another length.
    pub(super) fn closed_forms(&mut self, t: S, x: &[S]) -> Result<Vec<[S; 2]>, Fault> {
        let (q, u) = x.split_at_checked(self.engine.n_q()).ok_or(Fault::Shape)?;
        let t = self.switches.moment(t)?;
        let values = self.closed_forms.outputs(t, q, u, &self.inputs)?;
        Ok(values.chunks_exact(2).map(|both| [both[0], both[1]]).collect())
    }

    /// Energies, all speeds and outputs of a state.
    ///
    /// # Errors
    /// [`Fault::Shape`] if it has another length.
    pub fn answers(&mut self, t: S, x: &[S]) -> Result<(), Fault> {
        let (q, u) = x.split_at_checked(self.engine.n_q()).ok_or(Fault::Shape)?;
        self.engine.set_time(t);
        self.engine.energy(q, u)?;
        self.engine.speeds(q, u)?;
        self.engine.outputs(t, q, u, &self.inputs)?;
        Ok(())
    }

    /// Sets the inputs that have laws; the others stay 0.
    pub(super) fn command(&mut self, t: S, x: &[S]) -> Result<(), Fault> {
        if self.law_inputs.is_empty() {
            return Ok(());
        }
        let (q, u) = x.split_at_checked(self.engine.n_q()).ok_or(Fault::Shape)?;
        let commanded = self.law.outputs(t, q, u, &vec![S::ZERO; self.inputs.len()])?;
        for (&input, value) in self.law_inputs.iter().zip(commanded) {
            self.inputs[input] = value;
        }
        Ok(())
    }
}
