//! The mechanical sections: coordinates, speeds, frames, points, bodies, constraints, loads, values.

use super::build::Builder;
use super::document::Value;
use super::expression::{Expr, ExprKind};
use super::fields::Fields;
use super::repeat::wrong_kind;
use super::scope::{Binding, suggestion};
use super::unit::{Scale, Unit};
use super::*;
use crate::diagnostic::Diagnostic;
use crate::id::Id;

/// A scale of factor 1.
const fn si(unit: Unit) -> Scale {
    Scale { unit, factor: 1.0 }
}

impl Builder<'_> {
    /// Every coordinate has the speed `u_<name>` unless it names another one.
    pub(super) fn declare_speeds(&mut self) {
        for (i, (key, value)) in self.entries("coordinates").iter().enumerate() {
            let given = match value {
                Value::Table(table) => match table.get("speed") {
                    Some(Value::Text(text)) => Some((text.text.clone(), text.span)),
                    _ => None,
                },
                _ => None,
            };
            let (name, span) = given.unwrap_or_else(|| (format!("u_{}", key.name), key.span));
            self.scope.declare(&name, span, Binding::Speed(SpeedId::from_index(i)), self.found);
        }
    }

    /// Does the model constrain anything? Then a coordinate is dependent unless it says otherwise.
    fn is_constrained(&self) -> bool {
        let closes =
            |(_, value): &(_, Value)| matches!(value, Value::Table(t) if t.get("closures").is_some());
        let closed =
            |(_, value): &(_, Value)| matches!(value, Value::Table(t) if t.get("closed_form").is_some());
        !self.entries("constraints.configuration").is_empty()
            || self.entries("points").iter().any(closes)
            || self.entries("coordinates").iter().any(closed)
    }

    pub(super) fn coordinates(&mut self) {
        let constrained = self.is_constrained();
        for (key, value) in self.entries("coordinates") {
            let Some(fields) = Fields::new(key, value, self.found) else { continue };
            let doc = fields.doc(self.found);
            let (unit, scale) = self.unit(&fields);
            let scale = scale.unwrap_or(si(Unit::NONE));
            let closed_form = fields.get("closed_form").map(|value| self.expression(value));
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
            self.draft.coordinate_values.push([nominal, low, high]);
            self.draft.units.coordinates.push(scale.unit);
            self.draft.model.coordinates.push(Coordinate {
                name: key.name.clone(),
                doc,
                unit,
                independent: independent && closed_form.is_none(),
                nominal: 0.0,
                range: (0.0, 0.0),
                closed_form,
                span: key.span,
            });
        }
    }

    pub(super) fn speeds(&mut self) {
        let names: Vec<(SpeedId, String)> = self
            .scope
            .values
            .iter()
            .filter_map(|(name, (binding, _))| match binding {
                Binding::Speed(id) => Some((*id, name.clone())),
                _ => None,
            })
            .collect();
        for (id, coordinate) in self.draft.model.coordinates.enumerate() {
            let speed = SpeedId::from_index(id.index());
            let name = names.iter().find(|(known, _)| *known == speed).map_or("", |(_, name)| name.as_str());
            let unit = self.draft.units.coordinates[id].per(Unit::TIME).unwrap_or(Unit::NONE);
            self.draft.units.speeds.push(unit);
            self.draft.model.speeds.push(Speed {
                name: name.to_owned(),
                unit: rate_unit(&coordinate.unit, unit),
                meaning: SpeedMeaning::RateOf(id),
                independent: coordinate.independent,
                span: coordinate.span,
            });
        }
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
            let orientation = match fields.array("rotations", self.found) {
                Some((steps, _)) => {
                    let parent = match fields.get("parent") {
                        None => FrameId::from_index(0),
                        given => self.frame_of(given).unwrap_or(FrameId::from_index(0)),
                    };
                    Orientation::Rotations { parent, rotations: self.rotations(steps) }
                }
                None => {
                    let axes = ["x", "y", "z"].map(|axis| self.optional(&fields, axis, Unit::NONE));
                    if axes.iter().flatten().count() < 2 {
                        self.found.push(
                            Diagnostic::error(format!("frame `{}` has no orientation", key.name))
                                .label(key.span, "neither rotations nor two unit vectors are given")
                                .help("rotations = [[\"z\", \"q\"]] from a parent frame, or x = \"...\" and y = \"...\""),
                        );
                    }
                    Orientation::Directions { axes }
                }
            };
            let fixed_vectors = match fields.array("fixed", self.found) {
                Some((items, _)) => items.iter().filter_map(|item| self.fixed_vector(item)).collect(),
                None => Vec::new(),
            };
            fields.finish(self.found);
            let frame = Frame { name: key.name.clone(), orientation, fixed_vectors, span: key.span };
            self.draft.model.frames.push(frame);
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
            span: Span::default(),
        });
        for (key, value) in self.entries("points") {
            let (position, closures) = match value {
                Value::Table(_) => {
                    let Some(fields) = Fields::new(key, value, self.found) else { continue };
                    let position = self.needed(&fields, "position", Unit::LENGTH, "\"l*link.x\"");
                    let closures = match fields.array("closures", self.found) {
                        Some((items, _)) => items.iter().map(|item| self.expression(item)).collect(),
                        None => Vec::new(),
                    };
                    fields.finish(self.found);
                    (position, closures)
                }
                bare => (self.expression(bare), Vec::new()),
            };
            self.draft.model.points.push(Point {
                name: key.name.clone(),
                position,
                closures,
                span: key.span,
            });
        }
    }

    pub(super) fn bodies(&mut self) {
        for (key, value) in self.entries("bodies") {
            let Some(fields) = Fields::new(key, value, self.found) else { continue };
            let centre = fields.need("centre", "\"P\"", self.found);
            let centre = self.point_of(centre);
            let mass = self.optional(&fields, "mass", Unit::MASS);
            let given = fields.get("frame");
            let frame = self.frame_of(given);
            let inertia = match fields.table("inertia", self.found) {
                Some(table) => {
                    let moments = Fields::of("inertia", table.span, table);
                    let inertia = ["Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"];
                    let inertia = inertia.map(|name| self.optional(&moments, name, Unit::INERTIA));
                    moments.finish(self.found);
                    inertia
                }
                None => Default::default(),
            };
            let weight = fields.boolean("weight", self.found).unwrap_or(true);
            fields.finish(self.found);
            self.check_body(key.span, &key.name, mass.is_some(), given.is_some(), &inertia);
            let centre = centre.unwrap_or(PointId::from_index(0));
            let name = key.name.clone();
            self.draft.model.bodies.push(Body { name, centre, mass, frame, inertia, weight, span: key.span });
        }
        self.draft.model.gravity = self
            .sections
            .scalars
            .iter()
            .find(|(key, _)| key.name == "gravity")
            .map(|(_, value)| self.expression(value));
    }

    fn check_body(&mut self, span: Span, name: &str, mass: bool, frame: bool, inertia: &[Option<Expr>; 6]) {
        let inertial = inertia.iter().any(Option::is_some);
        let fault = match (mass, frame, inertial) {
            (false, _, false) => Some(("has neither mass nor inertia", "mass = \"m\"")),
            (_, false, true) => Some(("has inertia, but no frame to measure it in", "frame = \"link\"")),
            (_, true, false) => Some((
                "has a frame, but no inertia",
                "inertia = { Izz = \"I\" }; or leave `frame` out: the body is then a particle",
            )),
            _ => None,
        };
        if let Some((what, example)) = fault {
            self.found.push(
                Diagnostic::error(format!("body `{name}` {what}"))
                    .label(span, "this body")
                    .help(format!("add {example}")),
            );
        }
    }

    pub(super) fn constraints(&mut self) {
        for (section, configuration) in [("constraints.configuration", true), ("constraints.motion", false)] {
            for (key, value) in self.entries(section) {
                let constraint =
                    Constraint { name: key.name.clone(), expression: self.expression(value), span: key.span };
                let model = &mut self.draft.model;
                match configuration {
                    true => model.configuration_constraints.push(constraint),
                    false => model.motion_constraints.push(constraint),
                }
            }
        }
    }

    pub(super) fn loads(&mut self) {
        for section in ["forces", "torques", "springs"] {
            for (key, value) in self.entries(section) {
                let Some(fields) = Fields::new(key, value, self.found) else { continue };
                let kind = match section {
                    "forces" => self.force(&fields),
                    "torques" => self.torque(&fields),
                    _ => self.spring(&fields),
                };
                fields.finish(self.found);
                let name = key.name.clone();
                self.draft.model.loads.extend(kind.map(|kind| Load { name, kind, span: key.span }));
            }
        }
    }

    fn force(&mut self, fields: &Fields<'_>) -> Option<LoadKind> {
        let point = fields.need("point", "\"P\"", self.found);
        let point = self.point_of(point);
        let force = self.needed(fields, "force", Unit::FORCE, "\"F*N.z\"");
        let reaction = self.point_of(fields.get("reaction"));
        Some(LoadKind::Force { point: point?, force, reaction })
    }

    fn torque(&mut self, fields: &Fields<'_>) -> Option<LoadKind> {
        let frame = fields.need("frame", "\"link\"", self.found);
        let frame = self.frame_of(frame);
        let torque = self.needed(fields, "torque", Unit::TORQUE, "\"T*N.z\"");
        let reaction = self.frame_of(fields.get("reaction"));
        Some(LoadKind::Torque { frame: frame?, torque, reaction })
    }

    fn spring(&mut self, fields: &Fields<'_>) -> Option<LoadKind> {
        if let Some(coordinate) = fields.get("coordinate") {
            let coordinate = self.coordinate_of(Some(coordinate));
            let stiffness = self.needed(fields, "stiffness", Unit::NONE, "\"k\"");
            let rest = match fields.get("rest") {
                Some(value) => self.expression(value),
                None => Expr { kind: ExprKind::Number(0.0), span: fields.span, unit: Unit::NONE },
            };
            let damping = self.optional(fields, "damping", Unit::NONE);
            return Some(LoadKind::CoordinateSpring { coordinate: coordinate?, stiffness, rest, damping });
        }
        let ends = match fields.array("between", self.found) {
            Some(([a, b], _)) => self.point_of(Some(a)).zip(self.point_of(Some(b))),
            _ => {
                self.found.push(
                    Diagnostic::error(format!("spring `{}` has no ends", fields.name))
                        .label(fields.span, "`between` or `coordinate` is missing")
                        .help("between = [\"P\", \"Q\"] or coordinate = \"q\""),
                );
                None
            }
        };
        let stiffness = self.needed(fields, "stiffness", Unit::NONE, "\"k\"");
        let rest_length = self.needed(fields, "rest_length", Unit::LENGTH, "\"l0\"");
        let damping = self.optional(fields, "damping", Unit::NONE);
        let (a, b) = ends?;
        Some(LoadKind::Spring { ends: [a, b], stiffness, rest_length, damping })
    }

    /// Configurations, start values, laws and the run.
    pub(super) fn values(&mut self) {
        for table in &self.sections.configurations {
            let fields = Fields::of("configuration", table.span, table);
            let name = fields.text("name", self.found).map_or_else(String::new, |text| text.text.clone());
            let mut values = Vec::new();
            for (key, value) in fields.table("values", self.found).map_or(&[][..], |t| &t.entries) {
                if let Some(id) = self.coordinate_named(key) {
                    let unit = self.draft.units.coordinates[id];
                    values.push((id, self.quantity(value, si(unit))));
                }
            }
            fields.finish(self.found);
            self.draft.model.configurations.push(Configuration { name, values: Vec::new() });
            self.draft.configuration_values.push(values);
        }
        self.start();
        self.laws();
        self.run();
    }

    fn start(&mut self) {
        for (key, value) in self.entries("start") {
            let (of, unit) = match self.scope.values.get(&key.name).map(|(binding, _)| *binding) {
                Some(Binding::Coordinate(id)) => (StartRef::Coordinate(id), self.draft.units.coordinates[id]),
                Some(Binding::Speed(id)) => (StartRef::Speed(id), self.draft.units.speeds[id]),
                _ => {
                    let state = |b: &Binding| matches!(b, Binding::Coordinate(_) | Binding::Speed(_));
                    self.unknown_key(key, "coordinate or speed", state);
                    continue;
                }
            };
            let value = self.quantity(value, si(unit));
            self.draft.start_values.push((of, value));
        }
    }

    fn laws(&mut self) {
        for (key, value) in self.entries("law") {
            match self.scope.values.get(&key.name).map(|(binding, _)| *binding) {
                Some(Binding::Input(id)) => {
                    let value = self.quantity(value, si(self.draft.units.inputs[id]));
                    self.draft.model.laws.push((id, value));
                }
                _ => self.unknown_key(key, "input", |b| matches!(b, Binding::Input(_))),
            }
        }
    }

    fn unknown_key(&mut self, key: &document::Key, kind: &str, fits: impl Fn(&Binding) -> bool) {
        let known: Vec<&str> =
            self.scope.values.iter().filter(|(_, (b, _))| fits(b)).map(|(name, _)| name.as_str()).collect();
        let all =
            || format!("known: {}", if known.is_empty() { "none".to_owned() } else { known.join(", ") });
        self.found.push(
            Diagnostic::error(format!("`{}` is no {kind} of this model", key.name))
                .label(key.span, "unknown")
                .help(suggestion(&key.name, known.iter().copied()).unwrap_or_else(all)),
        );
    }

    fn run(&mut self) {
        let table = document::Table { entries: self.entries("run").to_vec(), span: Span::default() };
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

    fn coordinate_named(&mut self, key: &document::Key) -> Option<CoordinateId> {
        let text = document::Text::bare(&key.name, key.span);
        self.coordinate_of(Some(&Value::Text(text)))
    }
}

/// Unit text of a rate: that of the coordinate per second.
fn rate_unit(coordinate: &str, unit: Unit) -> String {
    match coordinate {
        "rad" => "rad/s".to_owned(),
        _ => unit.to_string(),
    }
}
