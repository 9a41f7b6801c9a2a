//! What was checked when the model was derived, checked again at the parameters of a state.
//!
//! In: the parameters of each state. Out: the refusal of a derivation at these values, with the state's place. The
//! checks run once for each set of those parameters on which they rest (codegen's `program::conditions`).

use super::states::State;
use crate::configuration::Configurations;
use crate::failure::Failure;
use crate::model_argument;
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::kinematics::Unreachable;
use smartbed_codegen::model::Model;
use smartbed_codegen::{ParameterChoice, Program, program};
use std::collections::BTreeMap;

/// What to do about a constraint that no longer follows from the others.
pub(super) const FOLLOWS: &str =
    "expected parameters at which it follows from the others, or a model without it";

/// The results of the checks so far.
pub(super) struct Conditions<'m> {
    model: &'m Model,
    /// The places, among the program's parameters, of those on which the checks rest.
    places: Vec<usize>,
    /// By the values of these parameters, bit by bit: what was found wrong.
    found: BTreeMap<Vec<u64>, Result<(), Diagnostics>>,
}

impl<'m> Conditions<'m> {
    /// For a program derived from `model` with `choice`, whose parameters some of the states may name.
    pub fn new(model: &'m Model, choice: &ParameterChoice, program: &Program) -> Result<Self, Failure> {
        let names = match choice.keep.is_empty() {
            true => Vec::new(),
            false => program::conditions(model, choice).map_err(|found| model_argument::wrong(&found))?,
        };
        let of = |name: &String| program.parameters.iter().position(|own| own.name == *name);
        let places: Vec<usize> = names.iter().filter_map(of).collect();
        let mut conditions = Self { model, places, found: BTreeMap::new() };
        let defaults: Vec<f64> = program.parameters.iter().map(|own| own.value).collect();
        conditions.found.insert(conditions.key(&defaults), Ok(()));
        Ok(conditions)
    }

    fn key(&self, parameters: &[f64]) -> Vec<u64> {
        self.places.iter().map(|&place| parameters[place].to_bits()).collect()
    }

    /// Checks the parameters of a state, in the program's order; `at` is its place.
    ///
    /// # Errors
    /// What a derivation refuses at these parameters.
    pub fn check(
        &mut self,
        at: &str,
        (state, parameters): (&State, &[f64]),
        program: &Program,
        configurations: &mut Configurations,
    ) -> Result<(), Failure> {
        let model = self.model;
        let key = self.key(parameters);
        let found = self.found.entry(key).or_insert_with(|| {
            let mut changed = model.with_values(&state.parameters.iter().cloned().collect())?;
            match configurations.nominal_at(parameters) {
                // The checks then begin on the same branch as the state.
                Ok(nominal) => {
                    for id in changed.coordinates.ids() {
                        let name = &model.coordinates[id].name;
                        if let Some(place) = program.q.iter().position(|own| own.name == *name) {
                            changed.coordinates[id].nominal = nominal[place];
                        }
                    }
                }
                Err(unreachable) if unreachable.locked => {
                    return Err(no_longer_follows(model, &unreachable));
                }
                Err(_) => {}
            }
            program::check(&changed, &ParameterChoice::default())
        });
        found.clone().map_err(|mut found| {
            for item in &mut found.items {
                item.message = format!("{at}: parameters: {}", item.message);
            }
            Failure::Found(Box::new(found))
        })
    }
}

/// A constraint that follows from the others at the model's parameters, not at those of a state.
fn no_longer_follows(model: &Model, unreachable: &Unreachable) -> Diagnostics {
    let mut error = Diagnostic::error(unreachable.to_string()).help(FOLLOWS);
    let name = unreachable.constraint.as_deref();
    if let Some(constraint) = model.configuration_constraints.iter().find(|c| Some(c.name.as_str()) == name) {
        error = error.label(constraint.span, "it follows from the others at the model's own parameters");
    }
    Diagnostics::one(model.source.clone(), error)
}
