//! Sections -> [`Draft`]: names declared first, then every entry read with names resolved to ids.
//!
//! Values that are numbers in the end (nominal values, ranges, starts) stay expressions here; they
//! are evaluated once the parameters have been put in order and checked.

use super::build_mechanics::PlannedSpeed;
use super::document::{Key, Table, Value};
use super::entry::unreadable;
use super::expression::Expr;
use super::fields::Fields;
use super::repeat::{Sections, wrong_kind};
use super::scope::{Binding, Scope, duplicate};
use super::unit::{Scale, Unit};
use super::*;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::id::Id;

/// Units of everything that is declared with one.
#[derive(Debug, Default)]
pub struct Units {
    /// Of parameters.
    pub parameters: IdVec<ParameterId, Unit>,
    /// Of coordinates: plain numbers in ranges, configurations and starts are multiples of it.
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
    /// Nominal value and range of each coordinate.
    pub coordinate_values: IdVec<CoordinateId, [Option<Expr>; 3]>,
    /// Values of each configuration.
    pub configuration_values: Vec<Vec<(CoordinateId, Expr)>>,
    /// Start values.
    pub start_values: Vec<(StartRef, Expr)>,
}

/// A scale of factor 1.
pub(super) const fn si(unit: Unit) -> Scale {
    Scale { unit, factor: 1.0 }
}

/// Reads all sections.
pub fn build(source: &Source, sections: &Sections, found: &mut Diagnostics) -> Draft {
    let mut scope = Scope::default();
    let mut builder = Builder {
        draft: Draft::empty(source),
        sections,
        scope: &mut scope,
        found,
        planned_speeds: Vec::new(),
    };
    builder.header();
    builder.declare();
    builder.parameters();
    builder.coordinates();
    builder.speeds();
    builder.inputs();
    builder.definitions();
    builder.frames();
    builder.points();
    builder.bodies();
    builder.constraints();
    builder.loads();
    builder.outputs();
    builder.values();
    builder.draft
}

impl Draft {
    fn empty(source: &Source) -> Self {
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
            outputs: Vec::new(),
            configurations: Vec::new(),
            order: Vec::new(),
            start: Vec::new(),
            laws: Vec::new(),
            run: Run::default(),
        };
        Self {
            model,
            units: Units::default(),
            coordinate_values: IdVec::default(),
            configuration_values: Vec::new(),
            start_values: Vec::new(),
        }
    }
}

/// What the n-th entry of a section stands for.
type Bind = fn(usize) -> Binding;

/// Reads entries into the draft.
pub(super) struct Builder<'a> {
    pub(super) draft: Draft,
    pub(super) sections: &'a Sections,
    pub(super) scope: &'a mut Scope,
    pub(super) found: &'a mut Diagnostics,
    pub(super) planned_speeds: Vec<PlannedSpeed>,
}

impl<'a> Builder<'a> {
    /// Entries of a section.
    pub(super) fn entries(&self, section: &str) -> &'a [(Key, Value)] {
        self.sections.tables.get(section).map_or(&[], Vec::as_slice)
    }

    /// Top-level fields.
    fn header(&mut self) {
        let table = Table { entries: self.sections.scalars.clone(), span: Span::default() };
        let fields = Fields::of("the model", Span { start: 0, end: 1, file: 0 }, &table);
        match fields.need("format", "1", self.found) {
            Some(Value::Number(1.0, _)) | None => {}
            Some(other) => self.found.push(
                Diagnostic::error("this format of models is not known")
                    .label(other.span(), "expected 1")
                    .help("this program reads format = 1"),
            ),
        }
        let model = &mut self.draft.model;
        model.doc = fields.doc(self.found);
        if let Some(Value::Text(name)) = fields.need("name", "\"pendulum\"", self.found) {
            scope::check_name(&name.text, name.span, self.found);
            model.name = name.text.clone();
        }
        match fields.get("dof") {
            Some(Value::Number(n, span)) if n.fract() == 0.0 && (0.0..=1000.0).contains(n) => {
                model.dof = Some((*n as usize, *span));
            }
            Some(other) => self.found.push(wrong_kind("dof", "a whole number", other)),
            None => {}
        }
        fields.get("gravity");
        fields.get("extends");
        fields.finish(self.found);
    }

    /// Declares every name, so that expressions may refer to what stands further down.
    fn declare(&mut self) {
        let nowhere = Span::default();
        self.scope.frames.insert("N".to_owned(), (FrameId::from_index(0), nowhere));
        self.scope.values.insert("O".to_owned(), (Binding::Point(PointId::from_index(0)), nowhere));
        let kinds: [(&str, Bind); 5] = [
            ("parameters", |i| Binding::Parameter(ParameterId::from_index(i))),
            ("coordinates", |i| Binding::Coordinate(CoordinateId::from_index(i))),
            ("inputs", |i| Binding::Input(InputId::from_index(i))),
            ("definitions", |i| Binding::Definition(DefinitionId::from_index(i))),
            ("points", |i| Binding::Point(PointId::from_index(i + 1))),
        ];
        for (section, binding) in kinds {
            for (i, (key, _)) in self.entries(section).iter().enumerate() {
                self.scope.declare(&key.name, key.span, binding(i), self.found);
            }
        }
        for (i, (key, _)) in self.entries("frames").iter().enumerate() {
            self.scope.declare_frame(&key.name, key.span, FrameId::from_index(i + 1), self.found);
        }
        for (i, (key, _)) in self.entries("bodies").iter().enumerate() {
            self.scope.declare_body(&key.name, key.span, BodyId::from_index(i), self.found);
        }
        for section in
            ["forces", "torques", "springs", "outputs", "constraints.configuration", "constraints.motion"]
        {
            for (i, (key, _)) in self.entries(section).iter().enumerate() {
                match section {
                    // Columns of a table beside those of time and of the quantities.
                    "outputs" => scope::check_name(&key.name, key.span, self.found),
                    _ => scope::check_word(&key.name, key.span, self.found),
                }
                if let Some((first, _)) = self.entries(section)[..i].iter().find(|(k, _)| k.name == key.name)
                {
                    self.found.push(duplicate(&key.name, key.span, first.span, "in this section"));
                }
            }
        }
        self.declare_speeds();
    }

    fn parameters(&mut self) {
        for (key, value) in self.entries("parameters") {
            let parameter = match value {
                Value::Table(_) => {
                    let Some(fields) = Fields::new(key, value, self.found) else { continue };
                    let doc = fields.doc(self.found);
                    let (unit, scale) = self.unit(&fields);
                    let scale = scale.unwrap_or(Scale { unit: Unit::NONE, factor: 1.0 });
                    let value = match fields.need("value", "0.5", self.found) {
                        Some(value) => self.quantity(value, scale),
                        None => unreadable(key.span),
                    };
                    let tunable = !fields.boolean("fixed", self.found).unwrap_or(false);
                    fields.finish(self.found);
                    self.draft.units.parameters.push(scale.unit);
                    Parameter { name: key.name.clone(), doc, unit, value, tunable, span: key.span }
                }
                bare => {
                    let value = self.expression(bare);
                    let (name, doc, unit) = (key.name.clone(), String::new(), "1".to_owned());
                    self.draft.units.parameters.push(Unit::NONE);
                    Parameter { name, doc, unit, value, tunable: true, span: key.span }
                }
            };
            self.draft.model.parameters.push(parameter);
        }
    }

    fn inputs(&mut self) {
        for (key, value) in self.entries("inputs") {
            let Some(fields) = Fields::new(key, value, self.found) else { continue };
            let doc = fields.doc(self.found);
            let (unit, scale) = self.unit(&fields);
            fields.finish(self.found);
            self.draft.units.inputs.push(scale.unwrap_or(si(Unit::NONE)));
            self.draft.model.inputs.push(Input { name: key.name.clone(), doc, unit, span: key.span });
        }
    }

    fn definitions(&mut self) {
        for (key, value) in self.entries("definitions") {
            let (value, unit) = match value {
                Value::Table(_) => {
                    let Some(fields) = Fields::new(key, value, self.found) else { continue };
                    fields.doc(self.found);
                    let (_, scale) = self.unit(&fields);
                    let value = fields.need("value", "\"...\"", self.found);
                    let value = value.map_or_else(|| unreadable(key.span), |value| self.expression(value));
                    fields.finish(self.found);
                    (value, scale.map(|s| s.unit))
                }
                bare => (self.expression(bare), None),
            };
            self.draft.units.definitions.push(unit);
            self.draft.model.definitions.push(Definition { name: key.name.clone(), value, span: key.span });
        }
    }

    fn outputs(&mut self) {
        for (key, value) in self.entries("outputs") {
            let (value, unit) = match value {
                Value::Table(_) => {
                    let Some(fields) = Fields::new(key, value, self.found) else { continue };
                    fields.doc(self.found);
                    let (_, scale) = self.unit(&fields);
                    let value = fields.need("value", "\"...\"", self.found);
                    let value = value.map_or_else(|| unreadable(key.span), |value| self.expression(value));
                    fields.finish(self.found);
                    (value, scale.map(|s| s.unit))
                }
                bare => (self.expression(bare), None),
            };
            self.draft.units.outputs.push(unit);
            let output = Output { name: key.name.clone(), value, unit: String::new(), span: key.span };
            self.draft.model.outputs.push(output);
        }
    }
}
