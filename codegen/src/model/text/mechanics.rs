//! The mechanical sections: coordinates, speeds, frames, points, constraints.

use super::builder::{Builder, PlannedSpeed, si};
use super::document::wrong_kind;
use super::document::{Key, Value};
use super::fields::Fields;
use super::scope::Binding;
use crate::diagnostic::Diagnostic;
use crate::id::Id;
use crate::model::data::*;
use crate::model::expression::{Axis, Expr, ExprKind};
use crate::model::ids::*;
use crate::model::unit::{Scale, Unit};
use crate::source::Span;
use crate::words::count;

impl Builder<'_> {
    /// Declares the speeds: every coordinate has `u_<name>` unless it names another one or has none; those of
    /// `[speeds]` follow.
    pub(super) fn declare_speeds(&mut self) {
        let mut plan = Vec::new();
        for (i, (key, value)) in self.entries("coordinates").iter().enumerate() {
            let coordinate = Some(CoordinateId::from_index(i));
            let mut speed = PlannedSpeed {
                name: format!("u_{}", key.name),
                span: key.span,
                coordinate,
                independent: None,
            };
            let given = if let Value::Table(table) = value { table.get("speed") } else { None };
            match given {
                None => {}
                Some(Value::Boolean(false, _)) => continue,
                Some(Value::Text(text)) => (speed.name, speed.span) = (text.text.clone(), text.span),
                Some(Value::Table(table)) => {
                    let fields = Fields::of("speed", table.span, table);
                    if let Some(text) = fields.text("name", self.found) {
                        (speed.name, speed.span) = (text.text.clone(), text.span);
                    }
                    speed.independent = fields.boolean("independent", self.found);
                    fields.finish(self.found);
                }
                Some(other) => {
                    self.found.push(wrong_kind("speed", "a name, { name, independent } or false", other))
                }
            }
            plan.push(speed);
        }
        for (key, _) in self.entries("speeds") {
            plan.push(PlannedSpeed {
                name: key.name.clone(),
                span: key.span,
                coordinate: None,
                independent: None,
            });
        }
        for (i, speed) in plan.iter().enumerate() {
            self.scope.declare(&speed.name, speed.span, Binding::Speed(SpeedId::from_index(i)), self.found);
        }
        self.planned_speeds = plan;
    }

    pub(super) fn coordinates(&mut self) {
        let constrained = self.sections.constrained;
        for (key, value) in self.entries("coordinates") {
            let Some(fields) = Fields::new(key, value, self.found) else { continue };
            let doc = fields.doc(self.found);
            let (unit, scale) = self.unit(&fields);
            let scale = scale.unwrap_or(si(Unit::NONE));
            let written = Self::written_unit(&fields, &unit);
            let closed_form = fields.get("closed_form").map(|value| self.quantity(value, scale));
            let independent = fields.boolean("independent", self.found).unwrap_or(!constrained);
            let nominal = fields.get("nominal").map(|value| self.quantity(value, scale));
            let mut range = [None, None];
            match fields.array("range", self.found) {
                Some(([low, high], _)) => {
                    range = [Some(self.quantity(low, scale)), Some(self.quantity(high, scale))];
                }
                Some((_, span)) => self.found.push(
                    Diagnostic::error("a range has two ends")
                        .label(span, "not two")
                        .help("range = [-0.1, 0.1]"),
                ),
                None => {}
            }
            fields.get("speed");
            fields.finish(self.found);
            let [low, high] = range;
            self.draft.units.coordinates.push(scale);
            self.draft.model.coordinates.push(Coordinate {
                name: key.name.clone(),
                doc,
                unit,
                written_unit: (written, scale.factor),
                independent: independent && closed_form.is_none(),
                nominal: 0.0,
                range: (0.0, 0.0),
                written: [nominal, low, high],
                closed_form,
                span: key.span,
            });
        }
    }

    pub(super) fn speeds(&mut self) {
        let mut combinations = self.entries("speeds").iter();
        for planned in std::mem::take(&mut self.planned_speeds) {
            match planned.coordinate {
                Some(id) => {
                    let Some(coordinate) = self.draft.model.coordinates.as_slice().get(id.index()) else {
                        continue;
                    };
                    // The speed of a coordinate in degrees is in degrees per second.
                    let Scale { unit, factor } = self.draft.units.coordinates[id];
                    let unit = unit.per(Unit::TIME).unwrap_or(Unit::NONE);
                    self.draft.units.speeds.push(Scale { unit, factor });
                    let speed = Speed {
                        name: planned.name,
                        unit: rate_unit(&coordinate.unit, unit),
                        meaning: SpeedMeaning::RateOf(id),
                        independent: planned.independent.unwrap_or(coordinate.independent),
                        span: coordinate.span,
                    };
                    self.draft.model.speeds.push(speed);
                }
                None => {
                    let Some((key, value)) = combinations.next() else { continue };
                    let Some(fields) = Fields::new(key, value, self.found) else { continue };
                    self.combination(&fields);
                    fields.finish(self.found);
                }
            }
        }
        // A coordinate in closed form is not part of the state and may go without a speed.
        let model = &self.draft.model;
        let with_speed = |c: CoordinateId| {
            model.speeds.iter().any(|s| matches!(s.meaning, SpeedMeaning::RateOf(of) if of == c))
        };
        let needed =
            model.coordinates.enumerate().filter(|(id, c)| c.closed_form.is_none() || with_speed(*id));
        let (speeds, coordinates) = (model.speeds.len(), needed.count());
        let missing =
            model.coordinates.enumerate().find(|(id, c)| c.closed_form.is_none() && !with_speed(*id));
        let place = self.entries("speeds").first().map(|(key, _)| key.span).or(missing.map(|(_, c)| c.span));
        if let Some(place) = place.filter(|_| speeds != coordinates) {
            self.found.push(
                Diagnostic::error(format!("{} for {}", count(speeds, "speed"), count(coordinates, "coordinate")))
                    .label(place, "there must be one speed per coordinate")
                    .help("a coordinate whose rate enters [speeds] has no speed of its own: give it `speed = false`"),
            );
        }
    }

    /// A speed that is a linear combination of rates.
    fn combination(&mut self, fields: &Fields<'_>) {
        fields.doc(self.found);
        let (unit, scale) = self.unit(fields);
        let value = match fields.need("value", "\"q_dot(q1)*cos(q2)\"", self.found) {
            Some(value) => self.expression(value),
            None => return,
        };
        let constrained = self.sections.constrained || self.sections.restricted;
        self.draft.units.speeds.push(scale.unwrap_or(si(Unit::NONE)));
        self.draft.model.speeds.push(Speed {
            name: fields.name.to_owned(),
            unit,
            meaning: SpeedMeaning::Combination(value),
            independent: fields.boolean("independent", self.found).unwrap_or(!constrained),
            span: fields.span,
        });
    }

    pub(super) fn frames(&mut self) {
        self.draft.model.frames.push(Frame {
            name: "N".to_owned(),
            orientation: Orientation::Inertial,
            fixed_vectors: Vec::new(),
            span: Span::default(),
        });
        for (key, value) in self.entries("frames") {
            let Some(fields) = Fields::new(key, value, self.found) else { continue };
            let orientation = self.orientation(key, &fields);
            let fixed_vectors = match fields.array("fixed", self.found) {
                Some((items, _)) => items.iter().filter_map(|item| self.fixed_vector(item)).collect(),
                None => Vec::new(),
            };
            fields.finish(self.found);
            let frame = Frame { name: key.name.clone(), orientation, fixed_vectors, span: key.span };
            self.draft.model.frames.push(frame);
        }
    }

    fn orientation(&mut self, key: &Key, fields: &Fields<'_>) -> Orientation {
        let parent = fields.get("parent");
        if let Some((steps, _)) = fields.array("rotations", self.found) {
            return Orientation::Rotations { parent: self.parent(parent), rotations: self.rotations(steps) };
        }
        if let Some((list, span)) = fields.array("euler", self.found) {
            let parent = self.parent(parent);
            let Ok(four) = <&[Value; 4]>::try_from(list) else {
                self.found.push(
                    Diagnostic::error(format!("frame `{}` has not four Euler parameters", key.name))
                        .label(span, format!("{} of them", list.len()))
                        .help("euler = [\"e0\", \"e1\", \"e2\", \"e3\"]: cos(angle/2), axis*sin(angle/2)"),
                );
                return Orientation::Inertial;
            };
            let parameters = Box::new(four.each_ref().map(|e| self.expression(e)));
            return Orientation::Euler { parent, parameters };
        }
        let axes = ["x", "y", "z"].map(|axis| self.optional(fields, axis, Unit::NONE));
        if axes.iter().flatten().count() < 2 {
            self.found.push(
                Diagnostic::error(format!("frame `{}` has no orientation", key.name))
                    .label(key.span, "neither rotations nor two unit vectors are given")
                    .help("rotations = [[\"z\", \"q\"]] from a parent frame, or x = \"...\" and y = \"...\""),
            );
        }
        Orientation::Directions { axes }
    }

    /// The frame from which an orientation starts: N unless another one is given.
    fn parent(&mut self, given: Option<&Value>) -> FrameId {
        let inertial = FrameId::from_index(0);
        match given {
            None => inertial,
            given => self.frame_of(given).unwrap_or(inertial),
        }
    }

    fn rotations(&mut self, steps: &[Value]) -> Vec<(Axis, Expr)> {
        let mut rotations = Vec::new();
        for step in steps {
            match step {
                Value::Array(pair, _) if pair.len() == 2 => {
                    let (axis, angle) = (self.axis_of(&pair[0]), self.expression(&pair[1]));
                    rotations.extend(axis.map(|axis| (axis, angle)));
                }
                other => self.found.push(
                    Diagnostic::error("a rotation is a pair of axis and angle")
                        .label(other.span(), "not such a pair")
                        .help("rotations = [[\"z\", \"psi\"], [\"y\", \"theta\"]]"),
                ),
            }
        }
        rotations
    }

    fn fixed_vector(&mut self, item: &Value) -> Option<FixedVector> {
        let Value::Table(table) = item else {
            self.found.push(wrong_kind("fixed", "a list of { vector, components }", item));
            return None;
        };
        let fields = Fields::of("fixed vector", table.span, table);
        let vector = self.needed(&fields, "vector", Unit::NONE, "\"...\"");
        let components = match fields.array("components", self.found) {
            Some(([x, y, z], _)) => [x, y, z].map(|c| self.expression(c)),
            _ => {
                let message = "a fixed vector has three components";
                self.found
                    .push(Diagnostic::error(message).label(table.span, "components = [x, y, z] is missing"));
                return None;
            }
        };
        fields.finish(self.found);
        Some(FixedVector { vector, components, span: item.span() })
    }

    pub(super) fn points(&mut self) {
        let node = |kind, unit| Expr { kind, span: Span::default(), unit };
        let zero = Box::new(node(ExprKind::Number(0.0), Unit::LENGTH));
        let along = Box::new(node(ExprKind::Axis(FrameId::from_index(0), Axis::X), Unit::NONE));
        let origin = node(ExprKind::Multiply(zero, along), Unit::NONE);
        self.draft.model.points.push(Point {
            name: "O".to_owned(),
            position: origin,
            closures: Vec::new(),
            velocity: None,
            span: Span::default(),
        });
        for (key, value) in self.entries("points") {
            let (position, closures, velocity) = match value {
                Value::Table(_) => {
                    let Some(fields) = Fields::new(key, value, self.found) else { continue };
                    let position = self.needed(&fields, "position", Unit::LENGTH, "\"l*link.x\"");
                    let closures = match fields.array("closures", self.found) {
                        Some((items, _)) => items.iter().map(|item| self.expression(item)).collect(),
                        None => Vec::new(),
                    };
                    let velocity = self.optional(&fields, "velocity", Unit::VELOCITY);
                    fields.finish(self.found);
                    if let (Some(_), Some(_)) = (closures.first(), &velocity) {
                        self.found.push(
                            Diagnostic::error(format!("point `{}` has closures and a velocity", key.name))
                                .label(key.span, "its velocity follows from the closures")
                                .help("leave one of them out"),
                        );
                    }
                    (position, closures, velocity)
                }
                bare => (self.expression(bare), Vec::new(), None),
            };
            let (name, span) = (key.name.clone(), key.span);
            self.draft.model.points.push(Point { name, position, closures, velocity, span });
        }
    }

    pub(super) fn constraints(&mut self) {
        for (section, configuration) in [("constraints.configuration", true), ("constraints.motion", false)] {
            for (key, value) in self.entries(section) {
                let (name, expression) = (key.name.clone(), self.expression(value));
                let constraint = Constraint { name, expression, unit: Unit::NONE, span: key.span };
                let model = &mut self.draft.model;
                match configuration {
                    true => model.configuration_constraints.push(constraint),
                    false => model.motion_constraints.push(constraint),
                }
            }
        }
    }
}

/// Unit text of a rate: that of the coordinate per second.
fn rate_unit(coordinate: &str, unit: Unit) -> String {
    match coordinate {
        "rad" => "rad/s".to_owned(),
        _ => unit.to_string(),
    }
}
