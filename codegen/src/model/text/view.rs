//! The section `[view]`, which controls pictures: names resolved to bodies, points and springs, sizes as expressions.

use super::builder::{Builder, si};
use super::document::{Key, Table, Value, wrong_kind};
use super::fields::Fields;
use super::scope::suggestion;
use crate::diagnostic::Diagnostic;
use crate::model::colour::{self, COLOURS};
use crate::model::data::*;
use crate::model::expression::Axis;
use crate::model::ids::{BodyId, PointId};
use crate::model::unit::Unit;
use crate::source::Span;

/// Advice for an unknown colour.
fn colour_help(text: &str) -> String {
    let names = COLOURS.map(|(name, _)| name);
    let all = || format!("colours are {}, or \"#rrggbb\"", names.join(", "));
    suggestion(text, names).unwrap_or_else(all)
}

impl Builder<'_> {
    pub(super) fn view(&mut self) {
        let table = Table { entries: self.entries("view").to_vec(), span: Span::default() };
        let span = table.entries.first().map_or(table.span, |(key, _)| key.span);
        let fields = Fields::of("view", span, &table);
        let hidden = fields.array("hide", self.found).map_or(&[][..], |(items, _)| items);
        for item in hidden {
            match item {
                Value::Text(text) => {
                    let key = Key { name: text.text.clone(), span: text.span };
                    let shown = self.shown(&key, true);
                    self.draft.model.view.hidden.extend(shown);
                }
                other => self.found.push(wrong_kind("hide", "a list of names in quotes", other)),
            }
        }
        if let Some((items, _)) = fields.array("links", self.found) {
            let links = items.iter().filter_map(|item| self.link(item)).collect();
            self.draft.model.view.links = Some(links);
        }
        fields.finish(self.found);
        for (key, value) in self.entries("view.colours") {
            let of = self.shown(key, false);
            match value {
                Value::Text(text) => match colour::parse(&text.text) {
                    Some(rgb) => self.draft.model.view.colours.extend(of.into_iter().map(|of| (of, rgb))),
                    None => self.found.push(
                        Diagnostic::error(format!("unknown colour `{}`", text.text))
                            .label(text.span, "no colour has this name")
                            .help(colour_help(&text.text)),
                    ),
                },
                other => self.found.push(wrong_kind(&key.name, "a colour in quotes", other)),
            }
        }
        for (key, value) in self.entries("view.shapes") {
            let body = self.body_of(key);
            let shape = self.shape(key, value);
            // A shape stated in `[view]` overrides the shape from which the mass was computed.
            self.draft.model.view.shapes.retain(|(of, _)| Some(*of) != body);
            self.draft.model.view.shapes.extend(body.zip(shape));
        }
    }

    fn link(&mut self, item: &Value) -> Option<[PointId; 2]> {
        match item {
            Value::Array(ends, _) if ends.len() == 2 => {
                let (a, b) = (self.point_of(ends.first()), self.point_of(ends.get(1)));
                Some([a?, b?])
            }
            other => {
                self.found.push(wrong_kind("links", "a list of pairs of points: [[\"O\", \"A\"]]", other));
                None
            }
        }
    }

    fn body_of(&mut self, key: &Key) -> Option<BodyId> {
        let found = self.scope.bodies.get(&key.name).map(|(id, _)| *id);
        if found.is_none() {
            self.not_shown(key, "body", self.scope.bodies.keys().cloned().collect());
        }
        found
    }

    /// Everything of this name: bodies and springs and, if `points` is true, points.
    fn shown(&mut self, key: &Key, points: bool) -> Vec<Shown> {
        let model = &self.draft.model;
        let bodies = model.bodies.enumerate().map(|(id, b)| (b.name.clone(), Shown::Body(id)));
        let is_spring = |load: &Load| matches!(load.kind, LoadKind::Spring { .. });
        let springs = model.loads.iter().enumerate().filter(|(_, load)| is_spring(load));
        let springs = springs.map(|(n, load)| (load.name.clone(), Shown::Spring(n)));
        let places = model.points.enumerate().map(|(id, p)| (p.name.clone(), Shown::Point(id)));
        let places = places.filter(|_| points);
        let all: Vec<(String, Shown)> = bodies.chain(springs).chain(places).collect();
        let of: Vec<Shown> = all.iter().filter(|(name, _)| *name == key.name).map(|(_, s)| *s).collect();
        if of.is_empty() {
            let kind = if points { "body, spring or point" } else { "body or spring" };
            self.not_shown(key, kind, all.into_iter().map(|(name, _)| name).collect());
        }
        of
    }

    fn not_shown(&mut self, key: &Key, kind: &str, known: Vec<String>) {
        let all = || match known.is_empty() {
            true => "this model has none".to_owned(),
            false => format!("known: {}", known.join(", ")),
        };
        self.found.push(
            Diagnostic::error(format!("`{}` is no {kind} of this model", key.name))
                .label(key.span, "nothing to show has this name")
                .help(suggestion(&key.name, known.iter().map(String::as_str)).unwrap_or_else(all)),
        );
    }

    /// `{ box = [a, b, c] }`, `{ cylinder = [radius, length], axis = "z" }`, `{ ball = radius }`, perhaps `at` a point.
    fn shape(&mut self, key: &Key, value: &Value) -> Option<Shape> {
        let fields = Fields::new(key, value, self.found)?;
        let at = self.point_of(fields.get("at"));
        let axis = fields.get("axis").and_then(|axis| self.axis_of(axis)).unwrap_or(Axis::Z);
        let kinds =
            [("box", ShapeKind::Box, 3), ("cylinder", ShapeKind::Cylinder, 2), ("ball", ShapeKind::Ball, 1)];
        let mut given = Vec::new();
        for (name, kind, sizes) in kinds {
            match fields.get(name) {
                None => {}
                Some(Value::Array(items, _)) if items.len() == sizes => given.push((kind, items.as_slice())),
                Some(one @ (Value::Number(..) | Value::Text(_))) if sizes == 1 => {
                    given.push((kind, std::slice::from_ref(one)));
                }
                Some(other) => {
                    let expected = match kind {
                        ShapeKind::Box => "the lengths of three edges: box = [1, 0.5, \"20_mm\"]",
                        ShapeKind::Cylinder => "radius and length: cylinder = [\"R\", 0.1]",
                        ShapeKind::Ball => "a radius: ball = 0.02",
                    };
                    self.found.push(wrong_kind(name, expected, other));
                    fields.finish(self.found);
                    return None;
                }
            }
        }
        fields.finish(self.found);
        let [(kind, items)] = given[..] else {
            self.found.push(
                Diagnostic::error(format!("the shape of `{}` is none, or more than one", key.name))
                    .label(key.span, "expected one of box, cylinder, ball")
                    .help("box = [1, 0.5, 0.02], or cylinder = [0.1, 0.02], or ball = 0.02; lengths in m"),
            );
            return None;
        };
        let sizes = items.iter().map(|item| self.quantity(item, si(Unit::LENGTH))).collect();
        Some(Shape { kind, sizes, axis, at })
    }
}
