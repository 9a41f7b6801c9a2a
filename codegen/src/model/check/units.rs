//! Types and units of everything that is declared, section by section.
//!
//! In: a draft whose entities are in order. Out: errors at the offending sub-expression with both units;
//! inferred units of outputs.

use super::infer::{Checker, Type};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::id::Id;
use crate::model::data::*;
use crate::model::draft::Draft;
use crate::model::expression::Expr;
use crate::model::ids::CoordinateId;
use crate::model::unit::Unit;
use crate::model::walk::Role;
use crate::words::count;

/// Checks every expression of the draft and fills in the units of outputs.
pub fn check(draft: &mut Draft, found: &mut Diagnostics) {
    let mut checker = Checker { draft, definitions: vec![None; draft.model.definitions.len()], found };
    checker.definitions();
    for (role, expression) in draft.model.expressions() {
        checker.role(role, expression);
    }
    // What is faulty has been reported; asked again it would be twice.
    let sound = checker.found.items.is_empty();
    let mut of = |c: &Constraint| match sound {
        true => checker.infer(&c.expression).map_or(Unit::NONE, Type::known),
        false => Unit::NONE,
    };
    let of_configuration: Vec<Unit> = draft.model.configuration_constraints.iter().map(&mut of).collect();
    let of_motion: Vec<Unit> = draft.model.motion_constraints.iter().map(&mut of).collect();
    let units: Vec<Unit> = (0..draft.model.outputs.len()).map(|n| checker.output(n).known()).collect();
    for (output, unit) in draft.model.outputs.iter_mut().zip(units) {
        output.unit = unit.to_string();
    }
    for (constraints, units) in [
        (&mut draft.model.configuration_constraints, of_configuration),
        (&mut draft.model.motion_constraints, of_motion),
    ] {
        constraints.iter_mut().zip(units).for_each(|(constraint, unit)| constraint.unit = unit);
    }
    check_dof(&draft.model, found);
}

/// Compares the stated degrees of freedom with the number of independent speeds.
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
    /// Infers the types of definitions, each after what it refers to.
    fn definitions(&mut self) {
        let draft = self.draft;
        for entity in &draft.model.order {
            let Entity::Definition(id) = *entity else { continue };
            let definition = &draft.model.definitions[id];
            let mut result = self.infer(&definition.value).ok();
            if let (Some(of), Some(unit)) = (result, draft.units.definitions[id]) {
                let wanted = Type { vector: of.vector, unit: Some(unit) };
                self.compare(&definition.value, of, wanted, &quoted(&definition.name));
                result = Some(wanted);
            }
            self.definitions[id.index()] = result;
        }
    }

    /// Requires the type that the expression's role demands.
    fn role(&mut self, role: Role, expression: &Expr) {
        let draft = self.draft;
        let (model, units) = (&draft.model, &draft.units);
        let over = |a: Unit, b: Unit| a.per(b).unwrap_or(Unit::NONE);
        // A generalised force does work along q: its unit is J per unit of q.
        let stiff = |id: CoordinateId| {
            over(over(Unit::TORQUE, units.coordinates[id].unit), units.coordinates[id].unit)
        };
        let of_coordinate = |id: CoordinateId| {
            (Type::scalar(units.coordinates[id].unit), quoted(&model.coordinates[id].name))
        };
        let plain = |wanted: Type, what: &str| (wanted, what.to_owned());
        let (wanted, what) = match role {
            // Types of definitions have been inferred already.
            Role::Definition(_) => return,
            Role::Position(id) if id.index() == 0 => return,
            Role::Parameter(id) => return self.parameter(&model.parameters[id], units.parameters[id]),
            Role::ConfigurationConstraint | Role::MotionConstraint => return drop(self.infer(expression)),
            Role::FixedVector(..) => match self.infer(expression) {
                Ok(of) => plain(Type { vector: true, ..of }, "a fixed vector"),
                Err(_) => return,
            },
            Role::FixedComponent(id, n) => match self.infer(&model.frames[id].fixed_vectors[n].vector) {
                Ok(of) => plain(Type { vector: false, ..of }, "a component of this vector"),
                Err(_) => return,
            },
            Role::Output(n) => (self.output(n), quoted(&model.outputs[n].name)),
            Role::Orientation(_, part) => {
                plain(Type { vector: part.is_vector, unit: Some(Unit::NONE) }, part.what)
            }
            Role::Position(_) | Role::Closure(_) => plain(Type::vector(Unit::LENGTH), "a position"),
            Role::StatedVelocity(_) => plain(Type::vector(Unit::VELOCITY), "a velocity"),
            Role::Mass(_) => plain(Type::scalar(Unit::MASS), "a mass"),
            Role::Inertia(_) => plain(Type::scalar(Unit::INERTIA), "a moment of inertia"),
            Role::Gravity => plain(Type::vector(Unit::ACCELERATION), "gravity"),
            Role::ClosedForm(id) | Role::Nominal(id) | Role::Configuration(id) | Role::Commanded(id) => {
                of_coordinate(id)
            }
            Role::Speed(id) => (Type::scalar(units.speeds[id].unit), quoted(&model.speeds[id].name)),
            Role::Start(StartRef::Coordinate(id)) => {
                plain(Type::scalar(units.coordinates[id].unit), "this start value")
            }
            Role::Start(StartRef::Speed(id)) => {
                plain(Type::scalar(units.speeds[id].unit), "this start value")
            }
            Role::Law(id) => (Type::scalar(units.inputs[id].unit), quoted(&model.inputs[id].name)),
            Role::Force => plain(Type::vector(Unit::FORCE), "a force"),
            Role::Torque => plain(Type::vector(Unit::TORQUE), "a torque"),
            Role::Stiffness => plain(Type::scalar(over(Unit::FORCE, Unit::LENGTH)), "a stiffness"),
            Role::Size => plain(Type::scalar(Unit::LENGTH), "a length of a shape"),
            Role::RestLength => plain(Type::scalar(Unit::LENGTH), "a rest length"),
            Role::Damping => plain(Type::scalar(over(Unit::FORCE, Unit::VELOCITY)), "a damping"),
            Role::CoordinateStiffness(id) => plain(Type::scalar(stiff(id)), "a stiffness"),
            Role::CoordinateRest(id) => plain(Type::scalar(units.coordinates[id].unit), "a rest value"),
            Role::CoordinateDamping(id) => plain(Type::scalar(over(stiff(id), Unit::RATE)), "a damping"),
        };
        self.expect(expression, wanted, &what);
    }

    /// Requires a parameter's value to have its declared unit.
    fn parameter(&mut self, parameter: &Parameter, unit: Unit) {
        match self.infer(&parameter.value) {
            Ok(Type { vector: false, unit: Some(of) }) if unit == Unit::NONE && of != unit => {
                self.without_unit(parameter, of);
            }
            Ok(of) => self.compare(&parameter.value, of, Type::scalar(unit), &quoted(&parameter.name)),
            Err(_) => {}
        }
    }

    /// The type of an output: a scalar in the stated unit, or in the unit inferred.
    fn output(&mut self, n: usize) -> Type {
        let draft = self.draft;
        let of = self.infer(&draft.model.outputs[n].value).unwrap_or(Type::scalar(Unit::NONE));
        Type { vector: false, unit: draft.units.outputs[n].or(of.unit) }
    }

    fn without_unit(&mut self, parameter: &Parameter, of: Unit) {
        self.found.push(
            Diagnostic::error(format!("parameter `{}` is declared without a unit", parameter.name))
                .label(parameter.value.span, format!("this is in {of}"))
                .help(format!("declare {} = {{ value = ..., unit = \"{of}\" }}", parameter.name)),
        );
    }
}

fn quoted(name: &str) -> String {
    format!("`{name}`")
}
