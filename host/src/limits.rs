//! Refuses numbers that the chosen scalar cannot represent, and angles too large for its sine.
//!
//! Sine and cosine are accurate up to [`Scalar::LARGEST_ANGLE`]. A larger angle is reduced by whole turns if it is used
//! in sines and cosines only, which does not change them; any other one is refused.

use crate::engine::kinds::{EngineScalar, explain};
use crate::failure::Failure;
use smartbed_codegen::program::limits::fits_single;
use smartbed_codegen::{Interpreted, Program, ScalarType};
use smartbed_runtime::real::Scalar;

/// Refuses a program with parameters or constants that single precision cannot represent, if it is to run in that.
///
/// # Errors
/// [`Failure::Wrong`] names the number.
pub fn check_program(program: &Program, scalar: &ScalarType) -> Result<(), Failure> {
    match program.beyond_single().filter(|_| scalar.is_single()) {
        Some(why) => Err(Failure::Wrong(format!("{why}; compute in f64, or choose other units"))),
        None => Ok(()),
    }
}

/// Refuses named numbers that the scalar cannot represent.
///
/// # Errors
/// The first one, in words.
pub fn check_numbers<'a, S: EngineScalar>(
    numbers: impl IntoIterator<Item = (&'a str, f64)>,
) -> Result<(), String> {
    let is_single = S::scalar_type().is_single();
    match numbers.into_iter().find(|(_, x)| is_single && !fits_single(*x)) {
        Some((name, x)) => Err(format!("`{name}` = {x:e} is beyond single precision; compute in f64")),
        None => Ok(()),
    }
}

/// The arguments of a program's sines and cosines, for checking them.
#[derive(Debug)]
pub struct Angles {
    names: Vec<String>,
    arguments: Interpreted<f64>,
    largest: f64,
}

impl Angles {
    /// For a program that runs in the scalar S.
    #[must_use]
    pub fn new<S: Scalar>(program: &Program) -> Self {
        let angles = program.angles();
        let names = angles.outputs.iter().map(|(name, _)| name.clone()).collect();
        Self { names, arguments: Interpreted::new(&angles), largest: S::LARGEST_ANGLE.to_f64() }
    }

    /// Sets the tunable parameters.
    pub fn set_parameters(&mut self, values: &[f64]) {
        self.arguments.set_parameters(values);
    }

    /// Refuses a state in which such an angle is too large.
    ///
    /// # Errors
    /// The angle, in words.
    pub fn check(&mut self, t: f64, q: &[f64], u: &[f64], inputs: &[f64]) -> Result<(), String> {
        if self.names.is_empty() {
            return Ok(());
        }
        let values = self.arguments.outputs(t, q, u, inputs).map_err(|fault| explain(fault).to_owned())?;
        let beyond = self.names.iter().zip(&values).find(|(_, x)| x.is_finite() && x.abs() > self.largest);
        match beyond {
            None => Ok(()),
            Some((name, x)) => Err(format!(
                "an angle of {x:.6e} rad ({}) is beyond the domain of sine and cosine, {:e} rad in this \
                 precision; subtract whole turns from it",
                if name.is_empty() { "a constant".to_owned() } else { format!("from {name}") },
                self.largest
            )),
        }
    }
}

/// Removes whole turns from coordinates that allow it and are too large for the scalar; the others keep every bit.
#[must_use]
pub fn less_turns<S: Scalar>(program: &Program, q: &[f64]) -> Vec<f64> {
    let largest = S::LARGEST_ANGLE.to_f64();
    let wrap = |(quantity, x): (&smartbed_codegen::program::Quantity, &f64)| {
        if quantity.is_angle && x.abs() > largest { x.less_whole_turns() } else { *x }
    };
    program.q.iter().zip(q).map(wrap).collect()
}
