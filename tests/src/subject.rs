//! The mechanism under test behind one interface: a model evaluated by the interpreter or by compiled code.
//!
//! Tests use names and f64; this file converts to the scalar, the engine and the order of slots.

use crate::cases::LOAD_PARAMETERS;
use crate::generated;
use crate::interpreted::InterpretedSubject;
use smartbed_runtime::mechanism::Mechanism;
use smartbed_runtime::real::{Real, Scalar};

/// Which engine evaluates the model.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Engine {
    /// The interpreter of the generator.
    Interpreted,
    /// Emitted Rust, compiled with the tests.
    Compiled,
}

/// Both engines.
pub const ENGINES: [Engine; 2] = [Engine::Interpreted, Engine::Compiled];

/// Names of a model's slots, in its own order.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Names {
    /// Coordinates.
    pub q: Vec<String>,
    /// Independent speeds.
    pub u: Vec<String>,
    /// Inputs.
    pub inputs: Vec<String>,
    /// Outputs.
    pub outputs: Vec<String>,
}

/// A mechanism with names.
pub trait Subject<S: Real>: Mechanism<S> {
    /// Names of its slots.
    fn names(&self) -> Names;
    /// Sets a parameter.
    ///
    /// # Panics
    /// If there is no such tunable parameter: the test is wrong.
    fn set_parameter(&mut self, name: &str, value: f64);
    /// Requested outputs.
    fn outputs(&mut self, q: &[S], u: &[S], inputs: &[S]) -> Vec<S>;
}

/// Values by name.
pub type Named = Vec<(String, f64)>;

/// A state by names; missing names are an error, extra ones too.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct State {
    /// Coordinates.
    pub q: Named,
    /// Independent speeds.
    pub u: Named,
    /// Inputs; left-out ones are 0.
    pub inputs: Named,
}

/// Answers in f64, exact images of the scalar's numbers.
#[derive(Clone, PartialEq, Debug)]
pub struct Rates {
    /// q_dot in the order asked for.
    pub q_dot: Vec<f64>,
    /// u_dot in the order asked for.
    pub u_dot: Vec<f64>,
    /// The worst pivot.
    pub pivot: f64,
    /// Kinetic and potential energy (J).
    pub energy: [f64; 2],
}

/// Pairs names with values.
///
/// # Panics
/// If there are not as many of both.
pub fn named(names: &[impl ToString], values: &[f64]) -> Named {
    assert_eq!(names.len(), values.len(), "one value per name");
    names.iter().map(ToString::to_string).zip(values.iter().copied()).collect()
}

/// Values in the order of a model's slots.
///
/// # Panics
/// If a value names no slot.
pub fn arrange<S: Real>(slots: &[String], values: &Named) -> Vec<S> {
    let mut arranged = vec![S::ZERO; slots.len()];
    for (name, value) in values {
        let slot = slots.iter().position(|slot| slot == name);
        arranged[slot.unwrap_or_else(|| panic!("`{name}` is none of {slots:?}"))] = S::from_f64(*value);
    }
    arranged
}

/// Values of a model's slots in the order of `names`.
fn pick<S: Scalar>(slots: &[String], values: &[S], names: &Named) -> Vec<f64> {
    let of = |name: &str| slots.iter().position(|slot| slot == name).expect("arranged before");
    names.iter().map(|(name, _)| values[of(name)].to_f64()).collect()
}

/// Evaluates a state. A `q` that names only the independent coordinates leaves the others at 0.
///
/// # Panics
/// If the mechanism refuses the state.
pub fn evaluate<S: Scalar>(subject: &mut dyn Subject<S>, state: &State) -> Rates {
    let names = subject.names();
    let q = arrange::<S>(&names.q, &state.q);
    let u = arrange::<S>(&names.u, &state.u);
    let inputs = arrange::<S>(&names.inputs, &state.inputs);
    let mut q_dot = vec![S::ZERO; q.len()];
    let mut u_dot = vec![S::ZERO; u.len()];
    let pivot = subject.rates(S::ZERO, &q, &u, &inputs, &mut q_dot, &mut u_dot).expect("slices fit");
    let (kinetic, potential) = subject.energy(&q, &u).expect("slices fit");
    Rates {
        q_dot: pick(&names.q, &q_dot, &state.q),
        u_dot: pick(&names.u, &u_dot, &state.u),
        pivot: pivot.to_f64(),
        energy: [kinetic.to_f64(), potential.to_f64()],
    }
}

/// Outputs by name.
pub fn outputs<S: Scalar>(subject: &mut dyn Subject<S>, state: &State) -> Named {
    let names = subject.names();
    let q = arrange::<S>(&names.q, &state.q);
    let u = arrange::<S>(&names.u, &state.u);
    let inputs = arrange::<S>(&names.inputs, &state.inputs);
    let values = subject.outputs(&q, &u, &inputs);
    names.outputs.into_iter().zip(values.into_iter().map(Scalar::to_f64)).collect()
}

/// A scalar for which the tests' models are built.
pub trait Built: Scalar {
    /// A model under an engine.
    fn subject(engine: Engine, model: &str) -> Box<dyn Subject<Self>>;
    /// The same model with every fixed parameter kept adjustable.
    fn loaded(engine: Engine, model: &str) -> Box<dyn Subject<Self>>;
}

impl Built for f64 {
    fn subject(engine: Engine, model: &str) -> Box<dyn Subject<Self>> {
        match engine {
            Engine::Interpreted => Box::new(InterpretedSubject::new(model, &[])),
            Engine::Compiled => generated::double(model),
        }
    }
    fn loaded(engine: Engine, model: &str) -> Box<dyn Subject<Self>> {
        match engine {
            Engine::Interpreted => Box::new(InterpretedSubject::new(model, &LOAD_PARAMETERS)),
            Engine::Compiled => generated::double(&format!("{model} loaded")),
        }
    }
}

impl Built for f32 {
    fn subject(engine: Engine, model: &str) -> Box<dyn Subject<Self>> {
        match engine {
            Engine::Interpreted => Box::new(InterpretedSubject::new(model, &[])),
            Engine::Compiled => generated::single(model),
        }
    }
    fn loaded(engine: Engine, model: &str) -> Box<dyn Subject<Self>> {
        match engine {
            Engine::Interpreted => Box::new(InterpretedSubject::new(model, &LOAD_PARAMETERS)),
            Engine::Compiled => generated::single(&format!("{model} loaded")),
        }
    }
}
