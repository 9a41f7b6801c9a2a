//! Reads sections into the draft: the names of all sections, the header, and entries that are a single value.

use super::document::wrong_kind;
use super::document::{Key, Table, Value};
use super::fields::Fields;
use super::repeat::Sections;
use super::scope::{Binding, Scope, check_name, check_word};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::id::Id;
use crate::model::data::*;
use crate::model::draft::Draft;
use crate::model::expression::{Expr, ExprKind};
use crate::model::ids::*;
use crate::model::unit::{Scale, Unit};
use crate::source::Span;

/// A scale without a factor: the SI unit itself.
pub(super) const fn si(unit: Unit) -> Scale {
    Scale { unit, factor: 1.0 }
}

/// Stands for an expression that could not be read; never used, because an error was reported.
pub(super) fn unreadable(span: Span) -> Expr {
    Expr { kind: ExprKind::Number(0.0), span, unit: Unit::NONE }
}

/// A speed as declared, before its meaning is read.
pub(super) struct PlannedSpeed {
    pub name: String,
    pub span: Span,
    /// The coordinate whose rate it is; `None` for an entry of `[speeds]`.
    pub coordinate: Option<CoordinateId>,
    pub independent: Option<bool>,
}

/// The error for two entries of a section with one name. What drives a joint's coordinate, or holds it as a spring, has
/// the coordinate's name.
fn twice_in(section: &str, key: &Key, first: &Key) -> Diagnostic {
    let of_joint = match section {
        "forces" | "torques" => "; the drive of a joint is one of them, under the name of its coordinate",
        "springs" => "; stiffness and damping of a joint are one of them, under the name of its coordinate",
        _ => "",
    };
    Diagnostic::error(format!("`{}` is declared twice in [{section}]", key.name))
        .label(key.span, "declared here again")
        .label(first.span, "declared here")
        .help(format!("entries of [{section}] have different names{of_joint}: rename one of the two"))
}

/// The binding of the n-th entry of a section.
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
    pub(super) fn header(&mut self) {
        let table = Table { entries: self.sections.scalars.clone(), span: Span::default() };
        let fields = Fields::of("the model", Span { start: 0, end: 1, file: 0 }, &table);
        match fields.need("format", "1", self.found) {
            Some(Value::Number(1.0, _)) | None => {}
            Some(other) => self.found.push(
                Diagnostic::error("this format of models is not known")
                    .label(other.span(), "expected 1")
                    .help(
                        "models are of format = 1; scenes, which have a `shape` or `parts`, of format 1 or 2",
                    ),
            ),
        }
        let model = &mut self.draft.model;
        model.doc = fields.doc(self.found);
        if let Some(Value::Text(name)) = fields.need("name", "\"pendulum\"", self.found) {
            check_name(&name.text, name.span, self.found);
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

    /// Declares all names first, so that expressions may refer to entries further down.
    pub(super) fn declare(&mut self) {
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
        for section in [
            "forces",
            "torques",
            "springs",
            "ports",
            "commanded",
            "outputs",
            "constraints.configuration",
            "constraints.motion",
        ] {
            for (i, (key, _)) in self.entries(section).iter().enumerate() {
                match section {
                    // Outputs are columns of a table, beside time and the quantities: their names must differ from
                    // these.
                    "outputs" => check_name(&key.name, key.span, self.found),
                    _ => check_word(&key.name, key.span, self.found),
                }
                if let Some((first, _)) = self.entries(section)[..i].iter().find(|(k, _)| k.name == key.name)
                {
                    self.found.push(twice_in(section, key, first));
                }
            }
        }
        self.declare_speeds();
    }

    pub(super) fn parameters(&mut self) {
        for (key, value) in self.entries("parameters") {
            let parameter = match value {
                Value::Table(_) => {
                    let Some(fields) = Fields::new(key, value, self.found) else { continue };
                    let doc = fields.doc(self.found);
                    let (unit, scale) = self.unit(&fields);
                    let scale = scale.unwrap_or(si(Unit::NONE));
                    let written_unit = (Self::written_unit(&fields, &unit), scale.factor);
                    let value = match fields.need("value", "0.5", self.found) {
                        Some(value) => self.quantity(value, scale),
                        None => unreadable(key.span),
                    };
                    let tunable = !fields.boolean("fixed", self.found).unwrap_or(false);
                    let range = self.range(&fields, scale);
                    fields.finish(self.found);
                    self.draft.units.parameters.push(scale.unit);
                    Parameter {
                        name: key.name.clone(),
                        doc,
                        unit,
                        written_unit,
                        value,
                        tunable,
                        range,
                        span: key.span,
                    }
                }
                bare => {
                    let value = self.expression(bare);
                    let (name, doc, unit) = (key.name.clone(), String::new(), "1".to_owned());
                    let written_unit = (unit.clone(), 1.0);
                    self.draft.units.parameters.push(Unit::NONE);
                    let range = (f64::NEG_INFINITY, f64::INFINITY);
                    Parameter { name, doc, unit, written_unit, value, tunable: true, range, span: key.span }
                }
            };
            self.draft.model.parameters.push(parameter);
        }
    }

    /// A parameter's range: two numbers in its unit. A mass without a range must be 0 or more.
    fn range(&mut self, fields: &Fields<'_>, scale: Scale) -> (f64, f64) {
        let lowest = if scale.unit == Unit::MASS { 0.0 } else { f64::NEG_INFINITY };
        let Some((items, span)) = fields.array("range", self.found) else { return (lowest, f64::INFINITY) };
        let ends: Vec<f64> = items
            .iter()
            .filter_map(|item| match self.quantity(item, scale).kind {
                ExprKind::Number(number) => Some(number),
                _ => None,
            })
            .collect();
        match ends[..] {
            [low, high] if items.len() == 2 && low <= high => (low, high),
            _ => {
                self.found.push(
                    Diagnostic::error(format!("the range of parameter `{}` is not two numbers", fields.name))
                        .label(span, "expected the lowest and the highest value")
                        .help("range = [0, 0.5], in the parameter's unit"),
                );
                (lowest, f64::INFINITY)
            }
        }
    }

    pub(super) fn inputs(&mut self) {
        for (key, value) in self.entries("inputs") {
            let Some(fields) = Fields::new(key, value, self.found) else { continue };
            let doc = fields.doc(self.found);
            let (unit, scale) = self.unit(&fields);
            let scale = scale.unwrap_or(si(Unit::NONE));
            let written_unit = (Self::written_unit(&fields, &unit), scale.factor);
            fields.finish(self.found);
            self.draft.units.inputs.push(scale);
            let input = Input { name: key.name.clone(), doc, unit, written_unit, span: key.span };
            self.draft.model.inputs.push(input);
        }
    }

    /// A bare expression, or a table with `value` and perhaps `unit`; `None` if the table cannot be read.
    fn stated_value(&mut self, key: &'a Key, value: &'a Value) -> Option<(Expr, Option<(String, Scale)>)> {
        if !matches!(value, Value::Table(_)) {
            return Some((self.expression(value), None));
        }
        let fields = Fields::new(key, value, self.found)?;
        fields.doc(self.found);
        let (unit, scale) = self.unit(&fields);
        let value = fields.need("value", "\"...\"", self.found);
        let value = match (value, scale) {
            (Some(value), Some(scale)) => self.quantity(value, scale),
            (Some(value), None) => self.expression(value),
            (None, _) => unreadable(key.span),
        };
        let stated = scale.map(|scale| (Self::written_unit(&fields, &unit), scale));
        fields.finish(self.found);
        Some((value, stated))
    }

    pub(super) fn definitions(&mut self) {
        for (key, value) in self.entries("definitions") {
            let Some((value, unit)) = self.stated_value(key, value) else { continue };
            self.draft.units.definitions.push(unit.as_ref().map(|(_, scale)| scale.unit));
            let written_unit = unit.map(|(written, scale)| (written, scale.factor));
            let definition = Definition { name: key.name.clone(), value, written_unit, span: key.span };
            self.draft.model.definitions.push(definition);
        }
    }

    pub(super) fn outputs(&mut self) {
        for (key, value) in self.entries("outputs") {
            let Some((value, unit)) = self.stated_value(key, value) else { continue };
            self.draft.units.outputs.push(unit.map(|(_, scale)| scale.unit));
            let output = Output { name: key.name.clone(), value, unit: String::new(), span: key.span };
            self.draft.model.outputs.push(output);
        }
    }
}
