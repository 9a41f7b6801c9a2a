//! Types and units of everything that is declared, section by section.
//!
//! In: a draft whose entities are in order. Out: errors at the offending sub-expression with both units;
//! inferred units of outputs.

use super::infer::{Checker, Type};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::data::*;
use crate::model::draft::Draft;
use crate::model::unit::Unit;
use crate::words::count;

/// Checks every expression of the draft and fills in the units of outputs.
pub fn check(draft: &mut Draft, found: &mut Diagnostics) {
    let mut checker = Checker { draft, definitions: vec![None; draft.model.definitions.len()], found };
    checker.entities();
    checker.mechanics();
    checker.loads();
    let units = checker.outputs();
    for (output, unit) in draft.model.outputs.iter_mut().zip(units) {
        output.unit = unit.to_string();
    }
    check_dof(&draft.model, found);
}

/// The stated degrees of freedom against the declared independent speeds.
fn check_dof(model: &Model, found: &mut Diagnostics) {
    let independent: Vec<&str> =
        model.speeds.iter().filter(|s| s.independent).map(|s| s.name.as_str()).collect();
    match model.dof {
        Some((stated, span)) if stated != independent.len() => found.push(
            Diagnostic::error(format!(
                "dof = {stated}, but the model declares {}",
                count(independent.len(), "independent speed")
            ))
            .label(
                span,
                format!(
                    "independent: {}",
                    if independent.is_empty() { "none".to_owned() } else { independent.join(", ") }
                ),
            )
            .help("correct dof, or mark coordinates as `independent = true` or `false`"),
        ),
        _ => {}
    }
}

impl Checker<'_> {
    fn entities(&mut self) {
        let draft = self.draft;
        for entity in &draft.model.order {
            match *entity {
                Entity::Parameter(id) => {
                    let parameter = &draft.model.parameters[id];
                    let unit = draft.units.parameters[id];
                    match self.infer(&parameter.value) {
                        Ok(Type { vector: false, unit: Some(of) }) if unit == Unit::NONE && of != unit => {
                            self.without_unit(parameter, of);
                        }
                        Ok(of) => {
                            self.compare(&parameter.value, of, Type::scalar(unit), &quoted(&parameter.name));
                        }
                        Err(_) => {}
                    }
                }
                Entity::Definition(id) => {
                    let definition = &draft.model.definitions[id];
                    let mut result = self.infer(&definition.value).ok();
                    if let (Some(of), Some(unit)) = (result, draft.units.definitions[id]) {
                        self.compare(
                            &definition.value,
                            of,
                            Type { vector: of.vector, unit: Some(unit) },
                            &definition.name,
                        );
                        result = Some(Type { vector: of.vector, unit: Some(unit) });
                    }
                    self.definitions[crate::id::Id::index(id)] = result;
                }
                Entity::Frame(id) => match &draft.model.frames[id].orientation {
                    Orientation::Inertial => {}
                    Orientation::Rotations { rotations, .. } => {
                        for (_, angle) in rotations {
                            self.expect(angle, Type::scalar(Unit::NONE), "an angle of rotation");
                        }
                    }
                    Orientation::Directions { axes } => {
                        for axis in axes.iter().flatten() {
                            self.expect(axis, Type::vector(Unit::NONE), "a unit vector");
                        }
                    }
                },
                Entity::Coordinate(_) => {}
                Entity::Point(id) if crate::id::Id::index(id) == 0 => {}
                Entity::Point(id) => {
                    self.expect(&draft.model.points[id].position, Type::vector(Unit::LENGTH), "a position");
                }
            }
        }
    }

    fn without_unit(&mut self, parameter: &Parameter, of: Unit) {
        self.found.push(
            Diagnostic::error(format!("parameter `{}` is declared without a unit", parameter.name))
                .label(parameter.value.span, format!("this is in {of}"))
                .help(format!("declare {} = {{ value = ..., unit = \"{of}\" }}", parameter.name)),
        );
    }

    fn mechanics(&mut self) {
        let draft = self.draft;
        let model = &draft.model;
        for frame in model.frames.iter() {
            for fixed in &frame.fixed_vectors {
                let Ok(of) = self.infer(&fixed.vector) else { continue };
                self.compare(&fixed.vector, of, Type { vector: true, ..of }, "a fixed vector");
                for component in &fixed.components {
                    self.expect(component, Type { vector: false, ..of }, "a component of this vector");
                }
            }
        }
        for point in model.points.iter() {
            for closure in &point.closures {
                self.expect(closure, Type::vector(Unit::LENGTH), "a position");
            }
            if let Some(velocity) = &point.velocity {
                self.expect(velocity, Type::vector(Unit::VELOCITY), "a velocity");
            }
        }
        for body in model.bodies.iter() {
            if let Some(mass) = &body.mass {
                self.expect(mass, Type::scalar(Unit::MASS), "a mass");
            }
            for moment in body.inertia.iter().flatten() {
                self.expect(moment, Type::scalar(Unit::INERTIA), "a moment of inertia");
            }
        }
        for constraint in model.configuration_constraints.iter().chain(&model.motion_constraints) {
            let _ = self.infer(&constraint.expression);
        }
        if let Some(gravity) = &model.gravity {
            self.expect(gravity, Type::vector(Unit::ACCELERATION), "gravity");
        }
        for (id, coordinate) in model.coordinates.enumerate() {
            let unit = Type::scalar(draft.units.coordinates[id].unit);
            let numbers = draft.coordinate_values[id].iter().flatten();
            for value in coordinate.closed_form.iter().chain(numbers) {
                self.expect(value, unit, &quoted(&coordinate.name));
            }
        }
        for (id, speed) in model.speeds.enumerate() {
            if let SpeedMeaning::Combination(value) = &speed.meaning {
                self.expect(value, Type::scalar(draft.units.speeds[id].unit), &quoted(&speed.name));
            }
        }
        for (of, value) in &draft.start_values {
            let unit = match of {
                StartRef::Coordinate(id) => draft.units.coordinates[*id].unit,
                StartRef::Speed(id) => draft.units.speeds[*id].unit,
            };
            self.expect(value, Type::scalar(unit), "this start value");
        }
        for (id, value) in draft.configuration_values.iter().flatten() {
            self.expect(
                value,
                Type::scalar(draft.units.coordinates[*id].unit),
                &quoted(&model.coordinates[*id].name),
            );
        }
        for (id, value) in &model.laws {
            self.expect(value, Type::scalar(draft.units.inputs[*id].unit), &quoted(&model.inputs[*id].name));
        }
    }

    fn loads(&mut self) {
        let draft = self.draft;
        let over = |a: Unit, b: Unit| a.per(b).unwrap_or(Unit::NONE);
        for load in &draft.model.loads {
            match &load.kind {
                LoadKind::Force { force, .. } => self.expect(force, Type::vector(Unit::FORCE), "a force"),
                LoadKind::Torque { torque, .. } => {
                    self.expect(torque, Type::vector(Unit::TORQUE), "a torque")
                }
                LoadKind::Spring { stiffness, rest_length, damping, .. } => {
                    let per_length = over(Unit::FORCE, Unit::LENGTH);
                    self.expect(stiffness, Type::scalar(per_length), "a stiffness");
                    self.expect(rest_length, Type::scalar(Unit::LENGTH), "a rest length");
                    if let Some(damping) = damping {
                        self.expect(damping, Type::scalar(over(Unit::FORCE, Unit::VELOCITY)), "a damping");
                    }
                }
                LoadKind::CoordinateSpring { coordinate, stiffness, rest, damping } => {
                    let q = draft.units.coordinates[*coordinate].unit;
                    // A generalised force works along q: its unit is J per unit of q.
                    let stiff = over(over(Unit::TORQUE, q), q);
                    self.expect(stiffness, Type::scalar(stiff), "a stiffness");
                    self.expect(rest, Type::scalar(q), "a rest value");
                    if let Some(damping) = damping {
                        let damp = stiff.times(Unit::TIME).unwrap_or(Unit::NONE);
                        self.expect(damping, Type::scalar(damp), "a damping");
                    }
                }
            }
        }
    }

    fn outputs(&mut self) -> Vec<Unit> {
        let draft = self.draft;
        let mut units = Vec::new();
        for (output, stated) in draft.model.outputs.iter().zip(&draft.units.outputs) {
            let of = self.infer(&output.value).unwrap_or(Type::scalar(Unit::NONE));
            let wanted = Type { vector: false, unit: stated.or(of.unit) };
            self.compare(&output.value, of, wanted, &quoted(&output.name));
            units.push(wanted.known());
        }
        units
    }
}

fn quoted(name: &str) -> String {
    format!("`{name}`")
}
