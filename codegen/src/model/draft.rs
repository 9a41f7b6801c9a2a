//! A model before its checks: sections read, names resolved, units as declared, numbers still as expressions.

use super::data::*;
use super::ids::*;
use super::unit::{Scale, Unit};
use crate::id::IdVec;
use crate::source::Source;

/// Units of everything that is declared with one.
#[derive(Debug, Default)]
pub struct Units {
    /// Of parameters.
    pub parameters: IdVec<ParameterId, Unit>,
    /// Of coordinates: plain numbers in ranges, configurations and starts are multiples of this unit.
    pub coordinates: IdVec<CoordinateId, Scale>,
    /// Of speeds.
    pub speeds: IdVec<SpeedId, Scale>,
    /// Of inputs.
    pub inputs: IdVec<InputId, Scale>,
    /// Of definitions that state one.
    pub definitions: IdVec<DefinitionId, Option<Unit>>,
    /// Of outputs that state one.
    pub outputs: Vec<Option<Unit>>,
}

/// A model whose units are unchecked and whose constants are unevaluated.
#[derive(Debug)]
pub struct Draft {
    /// The model; `order`, numbers and inferred units are still to be filled in.
    pub model: Model,
    /// Declared units.
    pub units: Units,
}

impl Draft {
    /// Nothing declared yet.
    pub fn empty(source: &Source) -> Self {
        let model = Model {
            source: source.clone(),
            name: String::new(),
            doc: String::new(),
            dof: None,
            parameters: IdVec::default(),
            coordinates: IdVec::default(),
            speeds: IdVec::default(),
            inputs: IdVec::default(),
            definitions: IdVec::default(),
            frames: IdVec::default(),
            points: IdVec::default(),
            bodies: IdVec::default(),
            configuration_constraints: Vec::new(),
            motion_constraints: Vec::new(),
            gravity: None,
            loads: Vec::new(),
            ports: Vec::new(),
            outputs: Vec::new(),
            configurations: Vec::new(),
            order: Vec::new(),
            start: Vec::new(),
            start_written: Vec::new(),
            laws: Vec::new(),
            commanded: Vec::new(),
            run: Run::default(),
            view: View::default(),
        };
        Self { model, units: Units::default() }
    }
}
