//! The sections of values: configurations, start values, laws of the inputs, what may be commanded, settings of a run.

use super::builder::{Builder, si};
use super::document::wrong_kind;
use super::document::{Key, Table, Text, Value};
use super::fields::Fields;
use super::scope::{Binding, suggestion};
use crate::diagnostic::Diagnostic;
use crate::model::data::*;
use crate::model::ids::*;
use crate::model::unit::{Scale, Unit};
use crate::source::Span;

/// The unit of a quantity; no unit if its entry was faulty, which has been reported.
fn known(scale: Option<&Scale>) -> Scale {
    scale.copied().unwrap_or(si(Unit::NONE))
}

impl Builder<'_> {
    /// Configurations, start values, laws, what scenes may command, and the run.
    pub(super) fn values(&mut self) {
        for table in &self.sections.configurations {
            let fields = Fields::of("configuration", table.span, table);
            let name = fields.text("name", self.found).map_or_else(String::new, |text| text.text.clone());
            let mut written = Vec::new();
            for (key, value) in fields.table("values", self.found).map_or(&[][..], |t| &t.entries) {
                if let Some(id) = self.coordinate_named(key) {
                    let scale = known(self.draft.units.coordinates.get(id));
                    written.push((id, self.quantity(value, scale)));
                }
            }
            fields.finish(self.found);
            let configuration = Configuration { name, values: Vec::new(), written };
            self.draft.model.configurations.push(configuration);
        }
        self.start();
        self.laws();
        self.commanded();
        self.run();
    }

    fn start(&mut self) {
        for (key, value) in self.entries("start") {
            let (of, scale) = match self.scope.values.get(&key.name).map(|(binding, _)| *binding) {
                Some(Binding::Coordinate(id)) => {
                    (StartRef::Coordinate(id), known(self.draft.units.coordinates.get(id)))
                }
                Some(Binding::Speed(id)) => (StartRef::Speed(id), known(self.draft.units.speeds.get(id))),
                _ => {
                    let state = |b: &Binding| matches!(b, Binding::Coordinate(_) | Binding::Speed(_));
                    self.unknown_key(key, "coordinate or speed", state);
                    continue;
                }
            };
            let value = self.quantity(value, scale);
            self.draft.model.start_written.push((of, value));
        }
    }

    fn laws(&mut self) {
        for (key, value) in self.entries("law") {
            match self.scope.values.get(&key.name).map(|(binding, _)| *binding) {
                Some(Binding::Input(id)) => {
                    let value = self.quantity(value, known(self.draft.units.inputs.get(id)));
                    self.draft.model.laws.push((id, value));
                }
                _ => self.unknown_key(key, "input", |b| matches!(b, Binding::Input(_))),
            }
        }
    }

    fn commanded(&mut self) {
        for (key, value) in self.entries("commanded") {
            let Some(coordinate) = self.coordinate_named(key) else { continue };
            let Value::Text(text) = value else {
                self.found.push(wrong_kind(&key.name, "an expression of definitions in quotes", value));
                continue;
            };
            let written = text.text.clone();
            let value = self.expression(value);
            self.draft.model.commanded.push(Commanded { coordinate, value, written });
        }
    }

    fn unknown_key(&mut self, key: &Key, kind: &str, fits: impl Fn(&Binding) -> bool) {
        let known: Vec<&str> =
            self.scope.values.iter().filter(|(_, (b, _))| fits(b)).map(|(name, _)| name.as_str()).collect();
        let all = || match known.is_empty() {
            true => format!(
                "this model declares no {kind}: declare it first, in [{}s]",
                kind.split(' ').next().unwrap_or(kind)
            ),
            false => format!("known: {}", known.join(", ")),
        };
        self.found.push(
            Diagnostic::error(format!("`{}` is no {kind} of this model", key.name))
                .label(key.span, "unknown")
                .help(suggestion(&key.name, known.iter().copied()).unwrap_or_else(all)),
        );
    }

    fn run(&mut self) {
        let table = Table { entries: self.entries("run").to_vec(), span: Span::default() };
        let span = table.entries.first().map_or(table.span, |(key, _)| key.span);
        let fields = Fields::of("run", span, &table);
        let mut run = Run::default();
        for (field, target) in [("seconds", &mut run.seconds), ("step", &mut run.step)] {
            match fields.get(field) {
                Some(Value::Number(number, _)) if 0.0 < *number && number.is_finite() => *target = *number,
                Some(other) => self.found.push(wrong_kind(field, "a positive number of seconds", other)),
                None => {}
            }
        }
        match fields.get("every") {
            Some(Value::Number(n, _)) if n.fract() == 0.0 && (1.0..=1e9).contains(n) => {
                run.every = *n as usize
            }
            Some(other) => self.found.push(wrong_kind("every", "a positive whole number of steps", other)),
            None => {}
        }
        if let Some(method) = fields.text("method", self.found) {
            run.method = method.text.clone();
        }
        fields.finish(self.found);
        self.draft.model.run = run;
    }

    fn coordinate_named(&mut self, key: &Key) -> Option<CoordinateId> {
        let text = Text::bare(&key.name, key.span);
        self.coordinate_of(Some(&Value::Text(text)))
    }
}
