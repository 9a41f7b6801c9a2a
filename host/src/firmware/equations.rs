//! The cost of the generated equations on the chip: instructions per operation, bytes of code.
//!
//! In: the settings, from which the model is derived as in the firmware's build script; the image and the counts of its
//! run. Out: [`Equations`].
//!
//! Sine and cosine are counted separately, at the number of instructions that the function `tile_sin_cos` executes per
//! angle. In the rates they are inlined and share their constants, so that a second, stricter figure counts loading
//! these with the rates. Everything else in the rates (arguments, results, the worst pivot, which is not an operation
//! of the rates) is counted with the operations.

use super::emulator::Count;
use super::image::{Image, straight};
use super::settings::{RATES, SIN_COS, Settings};
use super::thumb::Kind;
use crate::failure::Failure;
use crate::model_argument::{assignment, wrong};
use smartbed_codegen::expr::{ExprId, Node, Unary};
use smartbed_codegen::{Effort, ParameterChoice, model, program};
use std::collections::BTreeSet;

/// The image's functions for the equations: rates, projection, energy.
const ANSWERS: [&str; 3] = [RATES, "tile_project", "tile_energy"];

/// Cost of the equations on the chip.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Equations {
    /// Operations of the rates without sines and cosines.
    pub operations: u64,
    /// Angles whose sine or cosine the rates need.
    pub angles: u64,
    /// Instructions for sine and cosine of an angle as a function call.
    pub sin_cos: u64,
    /// Instructions of an evaluation of the rates without sines and cosines.
    pub apart: u64,
    /// The same, with loading the constants of sines and cosines included.
    pub apart_with_constants: u64,
    /// Code of rates, projection and energy with all functions that they call (bytes).
    pub bytes: u32,
}

impl Equations {
    /// Computes the cost; `rates` and `sin_cos` are the counts of [`RATES`] and [`SIN_COS`].
    ///
    /// # Errors
    /// [`Failure::Wrong`] if the model cannot be derived or a function is not in the image.
    pub fn new(settings: &Settings, image: &Image, rates: &Count, sin_cos: &Count) -> Result<Self, Failure> {
        let (operations, angles) = rates_of(settings)?;
        let missing = || Failure::Wrong("the image lacks a function of the equations".to_owned());
        let function = image.find(SIN_COS).ok_or_else(missing)?;
        let effects = &image.functions[function].effects;
        let constants = effects.iter().filter(|(_, kind)| *kind == Kind::Constant).count() as u64;
        let ([_, evaluation, _], [_, angle, _]) = (rates.instructions, sin_cos.instructions);
        let without = |each: u64| evaluation.saturating_sub(angles * each);
        let (apart, apart_with_constants) = (without(angle), without(angle.saturating_sub(constants)));
        let bytes = bytes(image).ok_or_else(missing)?;
        Ok(Self { operations, angles, sin_cos: angle, apart, apart_with_constants, bytes })
    }

    /// Instructions per operation, without sines and cosines.
    #[must_use]
    pub fn by_operation(&self) -> f64 {
        self.apart as f64 / self.operations as f64
    }

    /// The same, with loading the constants of sines and cosines included.
    #[must_use]
    pub fn by_operation_with_constants(&self) -> f64 {
        self.apart_with_constants as f64 / self.operations as f64
    }
}

/// Operations of the rates without sines and cosines, and angles.
fn rates_of(settings: &Settings) -> Result<(u64, u64), Failure> {
    let values = settings.set.iter().map(|change| assignment("--set", change)).collect::<Result<_, _>>()?;
    let derived = model::read(&settings.model).and_then(|model| {
        let tunable = model.parameters.iter().filter(|_| settings.everything);
        let keep = tunable.map(|p| p.name.clone()).collect();
        program::derive_with(&model, &ParameterChoice { values, keep }, Effort::All)
    });
    let program = derived.map_err(|errors| wrong(&errors))?;
    let turned = |id: ExprId| match program.dag.node(id) {
        Node::Unary(Unary::Sin | Unary::Cos, angle) => Some(angle),
        _ => None,
    };
    let reached = program.dag.reachable(&program.forward_dynamics());
    let functions: Vec<ExprId> = reached.into_iter().filter_map(turned).collect();
    let angles: BTreeSet<ExprId> = functions.iter().copied().collect();
    Ok(((program.operations() - functions.len()) as u64, angles.len() as u64))
}

/// Bytes of the answers and of all functions that they call.
fn bytes(image: &Image) -> Option<u32> {
    let answers: Vec<usize> = ANSWERS.iter().map(|name| image.find(name)).collect::<Option<_>>()?;
    Some(straight::bytes(image, &answers))
}

#[cfg(test)]
mod tests {
    use super::bytes;
    use crate::firmware::image::tests::image;

    #[test]
    fn what_the_answers_call_counts_once() {
        let call_next: [u16; 3] = [0xF000, 0xF801, 0x4770]; // bl .+6; bx lr
        let image = image(&[
            ("tile_rates", &call_next),
            ("helper", &[0x4770]),
            ("tile_project", &[0x4770]),
            ("tile_energy", &[0xF7FF, 0xFFFA, 0x4770]), // bl .-8: the helper
            ("other", &[0x4770]),
        ]);
        assert_eq!(bytes(&image), Some(6 + 2 + 2 + 6));
    }
}
