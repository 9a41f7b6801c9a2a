//! Sections -> [`Draft`]: names declared first, then every entry read with names resolved to ids.
//!
//! Values that are numbers in the end (nominal values, ranges, starts) stay expressions here; they
//! are evaluated once the parameters have been put in order and checked.

use super::build_mechanics::PlannedSpeed;
use super::document::{Key, Table, Text, Value};
use super::expression::{Axis, Expr, ExprKind};
use super::fields::Fields;
use super::repeat::{Sections, wrong_kind};
use super::scope::{Binding, Scope, duplicate, suggestion};
use super::unit::{self, Scale, Unit};
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

/// The number 0 in the place of something that could not be read; never used, because an error was reported.
fn unreadable(span: Span) -> Expr {
    Expr { kind: ExprKind::Number(0.0), span, unit: Unit::NONE }
}

impl<'a> Builder<'a> {
    /// Entries of a section.
    pub(super) fn entries(&self, section: &str) -> &'a [(Key, Value)] {
        self.sections.tables.get(section).map_or(&[], Vec::as_slice)
    }

    /// An expression in its own units.
    pub(super) fn expression(&mut self, value: &Value) -> Expr {
        match value {
            Value::Text(text) => {
                parse_expression::parse(text, self.scope, self.found).unwrap_or_else(|| unreadable(text.span))
            }
            Value::Number(number, span) => {
                self.finite(*number, *span);
                Expr { kind: ExprKind::Number(*number), span: *span, unit: Unit::NONE }
            }
            other => {
                self.found.push(wrong_kind("expression", "a number or an expression in quotes", other));
                unreadable(other.span())
            }
        }
    }

    fn finite(&mut self, number: f64, span: Span) {
        if !number.is_finite() {
            self.found.push(
                Diagnostic::error("the number is not finite")
                    .label(span, "here")
                    .help("write a finite number"),
            );
        }
    }

    /// A quantity: a plain number, quoted or not, is in the declared unit; an expression carries its own units.
    pub(super) fn quantity(&mut self, value: &Value, scale: Scale) -> Expr {
        let plain = match value {
            Value::Number(number, _) => Some(*number),
            Value::Text(text) if text.text.contains(|c: char| c.is_ascii_digit()) => {
                text.text.trim().parse().ok()
            }
            _ => None,
        };
        match plain {
            Some(number) => {
                self.finite(number, value.span());
                Expr { kind: ExprKind::Number(number * scale.factor), span: value.span(), unit: scale.unit }
            }
            None => self.expression(value),
        }
    }

    /// A vector or scalar field that may be missing.
    pub(super) fn optional(&mut self, fields: &Fields<'_>, name: &'static str, unit: Unit) -> Option<Expr> {
        fields.get(name).map(|value| self.quantity(value, si(unit)))
    }

    /// A vector or scalar field that must be there.
    pub(super) fn needed(
        &mut self,
        fields: &Fields<'_>,
        name: &'static str,
        unit: Unit,
        example: &str,
    ) -> Expr {
        match fields.need(name, example, self.found) {
            Some(value) => self.quantity(value, si(unit)),
            None => unreadable(fields.span),
        }
    }

    /// The field `unit`: text for people (coherent SI), and scale. No dimension if missing.
    pub(super) fn unit(&mut self, fields: &Fields<'_>) -> (String, Option<Scale>) {
        let Some(text) = fields.text("unit", self.found) else { return ("1".to_owned(), None) };
        match unit::parse(text.text.trim()) {
            Ok(scale) if scale.factor == 1.0 => (text.text.trim().to_owned(), Some(scale)),
            Ok(scale) if scale.unit == Unit::NONE => ("rad".to_owned(), Some(scale)),
            Ok(scale) => (scale.unit.to_string(), Some(scale)),
            Err((message, range)) => {
                let name = text.text.get(range.clone()).unwrap_or("");
                let help = suggestion(name, unit::names())
                    .unwrap_or_else(|| "units are products of powers: kg m^2, N s/m, m/s^2, deg".to_owned());
                self.found
                    .push(Diagnostic::error(message).label(text.place(range), "in this unit").help(help));
                ("1".to_owned(), None)
            }
        }
    }

    /// The name in a field, looked up.
    pub(super) fn name_of<T: Copy>(
        &mut self,
        value: Option<&Value>,
        kind: &str,
        look_up: impl Fn(&Scope, &str) -> Option<T>,
        known: impl Fn(&Scope) -> Vec<String>,
    ) -> Option<T> {
        let text = match value? {
            Value::Text(text) => text,
            other => {
                self.found.push(wrong_kind(kind, "a name in quotes", other));
                return None;
            }
        };
        let result = look_up(self.scope, &text.text);
        let is_name = text.text.chars().all(|c| c.is_alphanumeric() || c == '_');
        if result.is_none() && !is_name {
            self.found.push(
                Diagnostic::error(format!("expected the name of a {kind}, found an expression"))
                    .label(text.span, "this is no name")
                    .help(format!(
                        "declare the {kind} in [{kind}s] under a name of its own, and write that name here"
                    )),
            );
        } else if result.is_none() {
            let known = known(self.scope);
            self.found.push(
                Diagnostic::error(format!("unknown {kind} `{}`", text.text))
                    .label(text.span, format!("no {kind} of this model has this name"))
                    .help(suggestion(&text.text, known.iter().map(String::as_str)).unwrap_or_else(|| {
                        format!(
                            "known: {}",
                            if known.is_empty() { "none".to_owned() } else { known.join(", ") }
                        )
                    })),
            );
        }
        result
    }

    pub(super) fn frame_of(&mut self, value: Option<&Value>) -> Option<FrameId> {
        self.name_of(
            value,
            "frame",
            |scope, name| scope.frames.get(name).map(|(id, _)| *id),
            |scope| scope.frames.keys().cloned().collect(),
        )
    }

    pub(super) fn point_of(&mut self, value: Option<&Value>) -> Option<PointId> {
        let point = |binding: &Binding| if let Binding::Point(id) = binding { Some(*id) } else { None };
        self.name_of(
            value,
            "point",
            |scope, name| scope.values.get(name).and_then(|(b, _)| point(b)),
            |scope| {
                scope.values.iter().filter(|(_, (b, _))| point(b).is_some()).map(|(n, _)| n.clone()).collect()
            },
        )
    }

    pub(super) fn coordinate_of(&mut self, value: Option<&Value>) -> Option<CoordinateId> {
        let coordinate =
            |binding: &Binding| if let Binding::Coordinate(id) = binding { Some(*id) } else { None };
        self.name_of(
            value,
            "coordinate",
            |scope, name| scope.values.get(name).and_then(|(b, _)| coordinate(b)),
            |scope| {
                scope
                    .values
                    .iter()
                    .filter(|(_, (b, _))| coordinate(b).is_some())
                    .map(|(n, _)| n.clone())
                    .collect()
            },
        )
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

    /// An axis by its letter.
    pub(super) fn axis_of(&mut self, value: &Value) -> Option<Axis> {
        let letter = if let Value::Text(Text { text, .. }) = value { text.as_str() } else { "" };
        match letter {
            "x" => Some(Axis::X),
            "y" => Some(Axis::Y),
            "z" => Some(Axis::Z),
            _ => {
                self.found.push(
                    Diagnostic::error("an axis is \"x\", \"y\" or \"z\"")
                        .label(value.span(), "not an axis")
                        .help("rotations = [[\"z\", \"angle\"]]"),
                );
                None
            }
        }
    }
}
