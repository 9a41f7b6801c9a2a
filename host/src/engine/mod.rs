//! Engines evaluate a program: the interpreter, or the emitted Rust compiled at run time. Their results agree bit for
//! bit.

#[cfg(feature = "whole")]
pub mod cache;
#[cfg(feature = "whole")]
pub mod compiled;
#[cfg(feature = "whole")]
pub mod crate_text;
pub mod kinds;

pub use kinds::{Engine, EngineKind, EngineScalar, ScalarKind, explain};

use crate::failure::Failure;
use crate::limits;
use smartbed_codegen::{Interpreted, Program};

/// The engine of a kind, with the program's default parameters.
///
/// # Errors
/// [`Failure::Lacking`] without a compiler; [`Failure::Wrong`] if the emitted Rust does not compile, or if a number is
/// out of the scalar's range.
pub fn new<S: EngineScalar>(kind: EngineKind, program: &Program) -> Result<Box<dyn Engine<S>>, Failure> {
    limits::check_program(program, &S::scalar_type())?;
    Ok(match kind {
        EngineKind::Interpreter => Box::new(Interpreted::<S>::new(program)),
        #[cfg(feature = "whole")]
        EngineKind::Compiled => Box::new(compiled::Compiled::<S>::new(program)?),
        #[cfg(not(feature = "whole"))]
        EngineKind::Compiled => return Err(Failure::not_built("--engine compiled")),
    })
}
