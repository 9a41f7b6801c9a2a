//! Types (scalar or vector) and units, on the expressions as written; then numbers.
//!
//! In: a draft whose entities are in order. Out: errors at the offending sub-expression with
//! both units; inferred units of outputs; values of everything constant.

use super::build::Draft;
use super::evaluate::Constants;
use super::expression::{Expr, ExprKind, Function};
use super::unit::Unit;
use super::*;
use crate::diagnostic::{Diagnostic, Diagnostics};

/// Type and unit of an expression. No unit: a literal 0, which fits all.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Type {
    vector: bool,
    unit: Option<Unit>,
}

impl Type {
    const fn scalar(unit: Unit) -> Self {
        Self { vector: false, unit: Some(unit) }
    }
    const fn vector(unit: Unit) -> Self {
        Self { vector: true, unit: Some(unit) }
    }
    fn known(self) -> Unit {
        self.unit.unwrap_or(Unit::NONE)
    }
}

/// An error has been reported.
struct Reported;

type Checked = Result<Type, Reported>;

struct Checker<'a> {
    draft: &'a Draft,
    /// Types of definitions so far; none where one was faulty.
    definitions: Vec<Option<Type>>,
    found: &'a mut Diagnostics,
}

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
            Diagnostic::error(format!("dof = {stated}, but independent speeds: {}", independent.len()))
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
                    self.expect(
                        &parameter.value,
                        Type::scalar(draft.units.parameters[id]),
                        &quoted(&parameter.name),
                    );
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

    /// The expression must have this type.
    fn expect(&mut self, expr: &Expr, wanted: Type, what: &str) {
        if let Ok(of) = self.infer(expr) {
            self.compare(expr, of, wanted, what);
        }
    }

    fn compare(&mut self, expr: &Expr, of: Type, wanted: Type, what: &str) {
        if of.vector != wanted.vector {
            let (is, needs) = (shape(of), shape(wanted));
            let help = match wanted.vector {
                true => "multiply it by a unit vector such as N.z",
                false => "take a component with dot(vector, N.x), or its length with norm(vector)",
            };
            self.found.push(
                Diagnostic::error(format!("{what} must be {needs}"))
                    .label(expr.span, format!("this is {is}"))
                    .help(help),
            );
        } else if let (Some(is), Some(needs)) = (of.unit, wanted.unit)
            && is != needs
        {
            self.found.push(
                Diagnostic::error(format!("{what} must be {}", shown(needs)))
                    .label(expr.span, format!("this is {}", shown(is)))
                    .help(unit_help(is, needs)),
            );
        }
    }

    /// Type and unit of an expression.
    fn infer(&mut self, expr: &Expr) -> Checked {
        let units = &self.draft.units;
        Ok(match &expr.kind {
            ExprKind::Number(number) if *number == 0.0 => Type { vector: false, unit: None },
            ExprKind::Number(_) => Type::scalar(expr.unit),
            ExprKind::Pi | ExprKind::Degree => Type::scalar(Unit::NONE),
            ExprKind::Time => Type::scalar(Unit::TIME),
            ExprKind::Parameter(id) => Type::scalar(units.parameters[*id]),
            ExprKind::Coordinate(id) => Type::scalar(units.coordinates[*id].unit),
            ExprKind::Rate(id) => Type::scalar(units.coordinates[*id].unit.per(Unit::TIME).ok_or(Reported)?),
            ExprKind::Speed(id) => Type::scalar(units.speeds[*id].unit),
            ExprKind::Input(id) => Type::scalar(units.inputs[*id].unit),
            ExprKind::Definition(id) => self.definitions[crate::id::Id::index(*id)].ok_or(Reported)?,
            ExprKind::Point(_) => Type::vector(Unit::LENGTH),
            ExprKind::Velocity(_) => Type::vector(Unit::VELOCITY),
            ExprKind::AngularVelocity(_) => Type::vector(Unit::RATE),
            ExprKind::Axis(..) => Type::vector(Unit::NONE),
            ExprKind::Negate(a) => self.infer(a)?,
            ExprKind::Add(a, b) => {
                let (x, y) = self.both(a, b)?;
                self.alike("added", (a, x, b, y))?
            }
            ExprKind::Subtract(a, b) => {
                let (x, y) = self.both(a, b)?;
                self.alike("subtracted", (a, x, b, y))?
            }
            ExprKind::Multiply(a, b) => self.product(expr, a, b)?,
            ExprKind::Divide(a, b) => {
                let (x, y) = self.both(a, b)?;
                self.scalar(b, y, "a divisor")?;
                Type { vector: x.vector, unit: Some(self.bounded(expr, x.known().per(y.known()))?) }
            }
            ExprKind::Power(a, n) => {
                let x = self.infer(a)?;
                self.scalar(a, x, "the base of a power")?;
                Type::scalar(self.bounded(expr, x.known().power(*n, 1))?)
            }
            ExprKind::Call(function, arguments) => self.call(expr, *function, arguments)?,
            ExprKind::Dot(a, b) | ExprKind::Cross(a, b) => {
                let (x, y) = self.both(a, b)?;
                self.vector(a, x)?;
                self.vector(b, y)?;
                let unit = self.bounded(expr, x.known().times(y.known()))?;
                Type { vector: matches!(expr.kind, ExprKind::Cross(..)), unit: Some(unit) }
            }
            ExprKind::Norm(a) => {
                let x = self.infer(a)?;
                self.vector(a, x)?;
                Type { vector: false, ..x }
            }
        })
    }

    /// Types of two parts; both are looked at even if the first is faulty.
    fn both(&mut self, a: &Expr, b: &Expr) -> Result<(Type, Type), Reported> {
        let (x, y) = (self.infer(a), self.infer(b));
        Ok((x?, y?))
    }

    fn scalar(&mut self, expr: &Expr, of: Type, what: &str) -> Result<(), Reported> {
        if of.vector {
            self.found.push(
                Diagnostic::error(format!("{what} must be a scalar"))
                    .label(expr.span, "this is a vector")
                    .help("take a component with dot(vector, N.x), or its length with norm(vector)"),
            );
            return Err(Reported);
        }
        Ok(())
    }

    fn vector(&mut self, expr: &Expr, of: Type) -> Result<(), Reported> {
        if !of.vector {
            self.found.push(
                Diagnostic::error("dot, cross and norm want vectors")
                    .label(expr.span, "this is a scalar")
                    .help("vectors are made of unit vectors such as N.x, points and velocities"),
            );
            return Err(Reported);
        }
        Ok(())
    }

    fn bounded(&mut self, expr: &Expr, unit: Option<Unit>) -> Result<Unit, Reported> {
        if unit.is_none() {
            self.found.push(
                Diagnostic::error("the exponents of this unit are beyond all bounds")
                    .label(expr.span, "here")
                    .help("divide by reference values to keep the powers small"),
            );
        }
        unit.ok_or(Reported)
    }

    /// Two that are added, subtracted or compared: type and unit must be the same.
    fn alike(&mut self, word: &str, (a, x, b, y): (&Expr, Type, &Expr, Type)) -> Checked {
        if x.vector != y.vector {
            self.found.push(
                Diagnostic::error(format!("a vector and a scalar cannot be {word}"))
                    .label(b.span, format!("this is {}", shape(y)))
                    .label(a.span, format!("this is {}", shape(x)))
                    .help("multiply the scalar by a unit vector such as N.z"),
            );
            return Err(Reported);
        }
        match (x.unit, y.unit) {
            (Some(left), Some(right)) if left != right => {
                self.found.push(
                    Diagnostic::error(format!(
                        "a quantity {} and one {} cannot be {word}",
                        shown(left),
                        shown(right)
                    ))
                    .label(b.span, format!("this is {}", shown(right)))
                    .label(a.span, format!("this is {}", shown(left)))
                    .help(unit_help(right, left)),
                );
                Err(Reported)
            }
            (left, right) => Ok(Type { vector: x.vector, unit: left.or(right) }),
        }
    }

    fn product(&mut self, expr: &Expr, a: &Expr, b: &Expr) -> Checked {
        let (x, y) = self.both(a, b)?;
        if x.vector && y.vector {
            self.found.push(
                Diagnostic::error("two vectors cannot be multiplied with *")
                    .label(expr.span, "both sides are vectors")
                    .help("write dot(a, b) or cross(a, b)"),
            );
            return Err(Reported);
        }
        let unit = match (x.unit, y.unit) {
            (None, None) => None,
            _ => Some(self.bounded(expr, x.known().times(y.known()))?),
        };
        Ok(Type { vector: x.vector || y.vector, unit })
    }

    fn call(&mut self, expr: &Expr, function: Function, arguments: &[Expr]) -> Checked {
        let types: Vec<Checked> = arguments.iter().map(|argument| self.infer(argument)).collect();
        let types = types.into_iter().collect::<Result<Vec<Type>, Reported>>()?;
        for (argument, of) in arguments.iter().zip(&types) {
            self.scalar(argument, *of, "an argument of this function")?;
        }
        let x = types[0];
        let pair = || Some((&arguments[0], x, arguments.get(1)?, *types.get(1)?));
        match function {
            Function::Sqrt => Ok(Type::scalar(self.bounded(expr, x.known().power(1, 2))?)),
            Function::Abs => Ok(x),
            Function::Sign => Ok(Type::scalar(Unit::NONE)),
            Function::Min | Function::Max => self.alike("compared", pair().ok_or(Reported)?),
            Function::Atan2 | Function::SmoothStep => {
                self.alike("compared", pair().ok_or(Reported)?)?;
                Ok(Type::scalar(Unit::NONE))
            }
            _ => {
                self.compare(&arguments[0], x, Type::scalar(Unit::NONE), "the argument of this function");
                Ok(Type::scalar(Unit::NONE))
            }
        }
    }
}

fn quoted(name: &str) -> String {
    format!("`{name}`")
}

fn shape(of: Type) -> &'static str {
    if of.vector { "a vector" } else { "a scalar" }
}

/// A unit in messages. Numbers and angles have none.
fn shown(unit: Unit) -> String {
    if unit == Unit::NONE { "without unit".to_owned() } else { format!("in {unit}") }
}

/// What is missing between two units.
fn unit_help(is: Unit, needs: Unit) -> String {
    match needs.per(is) {
        Some(missing) if is == Unit::NONE => {
            format!("a literal may carry its unit, such as 0.5_m; a factor in {missing} is missing")
        }
        Some(missing) => format!("a factor in {missing} is missing"),
        None => "the two must be equal".to_owned(),
    }
}

/// Fills in all numbers, once everything has been checked.
pub fn evaluate(draft: Draft, found: &mut Diagnostics) -> Model {
    let mut model = draft.model;
    let constants = Constants::of(&model);
    for (id, value) in constants.parameters.enumerate() {
        finite(*value, model.parameters[id].value.span, found);
    }
    let mut value = |expr: &Expr| finite(constants.value(expr), expr.span, found);
    for id in model.coordinates.ids() {
        let [nominal, low, high] = &draft.coordinate_values[id];
        let nominal = nominal.as_ref().map_or(0.0, &mut value);
        // Without a range: once around for angles, one unit to both sides for the rest.
        let reach = if draft.units.coordinates[id].unit == Unit::NONE { std::f64::consts::PI } else { 1.0 };
        let low = low.as_ref().map_or(nominal - reach, &mut value);
        let high = high.as_ref().map_or(nominal + reach, &mut value);
        let coordinate = &mut model.coordinates[id];
        (coordinate.nominal, coordinate.range) = (nominal, (low, high));
    }
    for (configuration, values) in model.configurations.iter_mut().zip(&draft.configuration_values) {
        configuration.values = values.iter().map(|(id, expr)| (*id, value(expr))).collect();
    }
    model.start = draft.start_values.iter().map(|(of, expr)| (*of, value(expr))).collect();
    model
}

fn finite(value: f64, span: Span, found: &mut Diagnostics) -> f64 {
    if !value.is_finite() {
        found.push(
            Diagnostic::error("this has no finite constant value")
                .label(span, format!("evaluates to {value}"))
                .help("look for a division by 0, a root or logarithm of a negative number, or a number too large"),
        );
    }
    value
}
