//! A model read from `models/` and run by the interpreter.

use crate::subject::{Names, Subject};
use smartbed_codegen::kinematics::ParameterChoice;
use smartbed_codegen::model;
use smartbed_codegen::program::interpreter::Interpreted;
use smartbed_codegen::program::{self, Program};
use smartbed_codegen::rust::{self, EmitOptions, ScalarType};
use smartbed_codegen::{Effort, Settings};
use smartbed_runtime::mechanism::{Fault, Mechanism};
use smartbed_runtime::real::Real;
use std::path::{Path, PathBuf};

/// A model's file.
#[must_use]
pub fn path(model: &str) -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("tests/ lies in the workspace");
    root.join("models").join(format!("{model}.toml"))
}

/// Derives a model; `keep` names fixed parameters that stay.
///
/// # Panics
/// With the diagnosis, if the model is refused.
#[must_use]
pub fn program(model: &str, keep: &[&str]) -> Program {
    program_with(model, keep, Effort::Default)
}

/// [`program()`] with other settings.
///
/// # Panics
/// With the diagnosis, if the model is refused.
#[must_use]
pub fn program_with(model: &str, keep: &[&str], settings: impl Into<Settings>) -> Program {
    let choice = ParameterChoice {
        keep: keep.iter().map(ToString::to_string).collect(),
        ..ParameterChoice::default()
    };
    let model = model::read(&path(model)).unwrap_or_else(|found| panic!("{found}"));
    program::derive_with(&model, &choice, settings).unwrap_or_else(|found| panic!("{found}"))
}

/// The Rust emitted for a model, with a path in it that does not depend on where the tests run.
///
/// # Panics
/// With the diagnosis, if the model is refused.
#[must_use]
pub fn emitted(name: &str, scalar: ScalarType) -> String {
    emitted_with(name, scalar, Effort::Default)
}

/// [`emitted()`] with another effort to shorten the program.
///
/// # Panics
/// With the diagnosis, if the model is refused.
#[must_use]
pub fn emitted_with(name: &str, scalar: ScalarType, effort: Effort) -> String {
    let text = std::fs::read_to_string(path(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    // Paths count from the root of the workspace, wherever the tests run.
    let root = path(name).parent().and_then(Path::parent).map(Path::to_path_buf).unwrap_or_default();
    let load = |base: &Path| std::fs::read_to_string(root.join(base)).map_err(|error| error.to_string());
    let model = model::parse_with(&format!("models/{name}.toml"), &text, &load);
    let model = model.unwrap_or_else(|found| panic!("{found}"));
    let program = program::derive_with(&model, &ParameterChoice::default(), effort)
        .unwrap_or_else(|found| panic!("{found}"));
    rust::emit(&program, &EmitOptions { scalar, ..EmitOptions::default() })
}

/// The interpreter with names.
pub struct InterpretedSubject<S> {
    engine: Interpreted<S>,
    names: Names,
    parameters: Vec<(String, f64)>,
}

impl<S: Real> InterpretedSubject<S> {
    /// Derives a model.
    #[must_use]
    pub fn new(model: &str, keep: &[&str]) -> Self {
        Self::of(&program(model, keep))
    }

    /// Runs a derived program.
    #[must_use]
    pub fn of(program: &Program) -> Self {
        let of = |group: &[program::Quantity]| group.iter().map(|quantity| quantity.name.clone()).collect();
        Self {
            engine: Interpreted::new(program),
            names: Names {
                q: of(&program.q),
                u: of(&program.u),
                inputs: of(&program.inputs),
                outputs: program.outputs.iter().map(|(name, _)| name.clone()).collect(),
            },
            parameters: program.parameters.iter().map(|p| (p.name.clone(), p.value)).collect(),
        }
    }
}

impl<S: Real> Mechanism<S> for InterpretedSubject<S> {
    fn n_q(&self) -> usize {
        self.engine.n_q()
    }
    fn n_u(&self) -> usize {
        self.engine.n_u()
    }
    fn n_inputs(&self) -> usize {
        self.engine.n_inputs()
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
        self.engine.rates(t, q, u, inputs, q_dot, u_dot)
    }
    fn set_time(&mut self, t: S) {
        self.engine.set_time(t);
    }
    fn project(&mut self, q: &mut [S]) -> Result<S, Fault> {
        self.engine.project(q)
    }
    fn project_speeds(&mut self, q: &[S], u: &mut [S]) -> Result<(), Fault> {
        self.engine.project_speeds(q, u)
    }
    fn energy(&mut self, q: &[S], u: &[S]) -> Result<(S, S), Fault> {
        self.engine.energy(q, u)
    }
}

impl<S: Real> Subject<S> for InterpretedSubject<S> {
    fn names(&self) -> Names {
        self.names.clone()
    }

    fn set_parameter(&mut self, name: &str, value: f64) {
        let known = self.parameters.iter_mut().find(|(known, _)| known == name);
        known.unwrap_or_else(|| panic!("no tunable parameter `{name}`")).1 = value;
        let values: Vec<S> = self.parameters.iter().map(|(_, value)| S::from_f64(*value)).collect();
        self.engine.set_parameters(&values);
    }

    fn outputs(&mut self, q: &[S], u: &[S], inputs: &[S]) -> Vec<S> {
        self.engine.outputs(S::ZERO, q, u, inputs).expect("slices fit")
    }
}
