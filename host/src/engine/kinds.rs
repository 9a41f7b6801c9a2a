//! The interface of engines, their kinds and their scalars.

use clap::ValueEnum;
use smartbed_codegen::{Interpreted, ScalarType};
use smartbed_runtime::mechanism::{Fault, Mechanism};
use smartbed_runtime::real::Scalar;

/// Which engine.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, ValueEnum)]
pub enum EngineKind {
    /// Interpret the equations: starts at once, needs no compiler.
    #[default]
    Interpreter,
    /// Compile the equations as Rust code, once per model, into a cache: faster in long runs, needs cargo.
    Compiled,
}

/// Scalars that one state can be computed with.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, ValueEnum)]
pub enum ScalarKind {
    /// 32-bit floating point, as on the microcontroller.
    F32,
    /// 64-bit floating point.
    #[default]
    F64,
}

impl ScalarKind {
    /// Its name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
        }
    }

    /// Rounding error, accumulated over a run, of a difference of numbers of size 1.
    #[must_use]
    pub fn noise(self) -> f64 {
        match self {
            Self::F32 => 1e-5,
            Self::F64 => 1e-12,
        }
    }
}

/// A scalar that an engine computes with.
pub trait EngineScalar: Scalar {
    /// Its name in emitted files.
    fn scalar_type() -> ScalarType;
}

impl EngineScalar for f32 {
    fn scalar_type() -> ScalarType {
        ScalarType::F32
    }
}

impl EngineScalar for f64 {
    fn scalar_type() -> ScalarType {
        ScalarType::F64
    }
}

/// Evaluates the equations of motion and all other answers of a program.
pub trait Engine<S: EngineScalar>: Mechanism<S> {
    /// Sets all tunable parameters, in the program's order.
    fn set_parameters(&mut self, values: &[S]);
    /// All speeds, dependent ones included, at the time last set.
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not the stated length.
    fn speeds(&mut self, q: &[S], u: &[S]) -> Result<Vec<S>, Fault>;
    /// The model's outputs.
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not the stated length.
    fn outputs(&mut self, t: S, q: &[S], u: &[S], inputs: &[S]) -> Result<Vec<S>, Fault>;
    /// Power (W) that the drive puts in; 0 if the mechanism is not driven.
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not the stated length.
    fn drive(&mut self, t: S, q: &[S], u: &[S], inputs: &[S]) -> Result<S, Fault>;
    /// The results of a function on request, by its index in the program's functions; `u_dot` is empty if no answer
    /// uses it.
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice does not have the stated length, or there is no such function.
    fn function(&mut self, place: usize, at: (S, &[S], &[S], &[S], &[S])) -> Result<Vec<S>, Fault>;
    /// Largest constraint residual of a configuration, which is not corrected, at the time last set.
    ///
    /// # Errors
    /// [`Fault::Shape`] if `q` has not the stated length.
    fn residual(&mut self, q: &[S]) -> Result<S, Fault> {
        self.project(&mut q.to_vec())
    }
}

impl<S: EngineScalar> Engine<S> for Interpreted<S> {
    fn set_parameters(&mut self, values: &[S]) {
        Interpreted::set_parameters(self, values);
    }
    fn speeds(&mut self, q: &[S], u: &[S]) -> Result<Vec<S>, Fault> {
        Interpreted::speeds(self, q, u)
    }
    fn outputs(&mut self, t: S, q: &[S], u: &[S], inputs: &[S]) -> Result<Vec<S>, Fault> {
        Interpreted::outputs(self, t, q, u, inputs)
    }
    fn drive(&mut self, t: S, q: &[S], u: &[S], inputs: &[S]) -> Result<S, Fault> {
        Interpreted::drive(self, t, q, u, inputs)
    }
    fn function(&mut self, place: usize, at: (S, &[S], &[S], &[S], &[S])) -> Result<Vec<S>, Fault> {
        Interpreted::function(self, place, at)
    }
}

/// The message for a fault.
#[must_use]
pub fn explain(fault: Fault) -> &'static str {
    fault.reason()
}
