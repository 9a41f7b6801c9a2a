//! Infers type (scalar or vector) and unit of an expression as the author wrote it.
//!
//! In: an expression with names resolved. Out: its type and unit, or errors at the offending sub-expression with both
//! units. A literal 0 fits every unit, unless it carries one.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::draft::Draft;
use crate::model::expression::{Expr, ExprKind, Function};
use crate::model::unit::Unit;

/// Type and unit of an expression; the unit is `None` for a literal 0, which fits every unit.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Type {
    pub vector: bool,
    pub unit: Option<Unit>,
}

impl Type {
    pub const fn scalar(unit: Unit) -> Self {
        Self { vector: false, unit: Some(unit) }
    }
    pub const fn vector(unit: Unit) -> Self {
        Self { vector: true, unit: Some(unit) }
    }
    pub fn known(self) -> Unit {
        self.unit.unwrap_or(Unit::NONE)
    }
}

/// Stands for an error that has been reported already.
pub(super) struct Reported;

pub(super) type Checked = Result<Type, Reported>;

/// Checks expressions against a draft.
pub(super) struct Checker<'a> {
    pub draft: &'a Draft,
    /// Types of the definitions so far; `None` where one was faulty.
    pub definitions: Vec<Option<Type>>,
    pub found: &'a mut Diagnostics,
}

impl Checker<'_> {
    /// Requires the expression to have this type.
    pub fn expect(&mut self, expr: &Expr, wanted: Type, what: &str) {
        if let Ok(of) = self.infer(expr) {
            self.compare(expr, of, wanted, what);
        }
    }

    pub fn compare(&mut self, expr: &Expr, of: Type, wanted: Type, what: &str) {
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
                    .help(self.undeclared(expr, is, needs).unwrap_or_else(|| unit_help(is, needs))),
            );
        }
    }

    /// Advice for a product in which a quantity was probably declared without its unit.
    fn undeclared(&self, expr: &Expr, is: Unit, needs: Unit) -> Option<String> {
        let mut names = Vec::new();
        self.unitless(expr, &mut names);
        match names[..] {
            [name] => needs.per(is).map(|missing| {
                format!("a factor in {missing} is missing: was `{name}` meant to have one? Declare it with unit = \"{missing}\"")
            }),
            _ => None,
        }
    }

    /// Collects parameters and inputs without a unit among the factors.
    fn unitless<'n>(&'n self, expr: &Expr, names: &mut Vec<&'n str>) {
        let (units, model) = (&self.draft.units, &self.draft.model);
        match &expr.kind {
            ExprKind::Parameter(id) if units.parameters[*id] == Unit::NONE => {
                names.push(&model.parameters[*id].name);
            }
            ExprKind::Input(id) if units.inputs[*id].unit == Unit::NONE => {
                names.push(&model.inputs[*id].name)
            }
            ExprKind::Negate(a) => self.unitless(a, names),
            ExprKind::Multiply(a, b) => {
                self.unitless(a, names);
                self.unitless(b, names);
            }
            _ => {}
        }
    }

    /// Type and unit of an expression.
    pub fn infer(&mut self, expr: &Expr) -> Checked {
        let units = &self.draft.units;
        Ok(match &expr.kind {
            ExprKind::Number(number) if *number == 0.0 && expr.unit == Unit::NONE => {
                Type { vector: false, unit: None }
            }
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
                Type { unit: self.changed(expr, x, |unit| unit.per(y.known()))?, ..x }
            }
            ExprKind::Power(a, n) => {
                let x = self.infer(a)?;
                self.scalar(a, x, "the base of a power")?;
                if *n == 0 {
                    return Ok(Type::scalar(Unit::NONE));
                }
                Type { unit: self.changed(expr, x, |unit| unit.power(*n, 1))?, ..x }
            }
            ExprKind::Call(function, arguments) => self.call(expr, *function, arguments)?,
            ExprKind::Dot(a, b) | ExprKind::Cross(a, b) => {
                let (x, y) = self.both(a, b)?;
                self.vector(a, x)?;
                self.vector(b, y)?;
                let unit = self.times(expr, x, y)?;
                Type { vector: matches!(expr.kind, ExprKind::Cross(..)), unit }
            }
            ExprKind::Norm(a) => {
                let x = self.infer(a)?;
                self.vector(a, x)?;
                Type { vector: false, ..x }
            }
        })
    }

    /// Types of two parts; the second is examined even if the first is faulty.
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

    /// Type of two parts that are added, subtracted or compared: both must have the same type and unit.
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
        Ok(Type { vector: x.vector || y.vector, unit: self.times(expr, x, y)? })
    }

    /// Unit of a quantity after a change of its exponents: a 0 fits every unit, before and after.
    fn changed(
        &mut self,
        expr: &Expr,
        x: Type,
        change: impl FnOnce(Unit) -> Option<Unit>,
    ) -> Result<Option<Unit>, Reported> {
        x.unit.map(|unit| self.bounded(expr, change(unit))).transpose()
    }

    /// Unit of a product: 0 times anything is 0, which fits every unit.
    fn times(&mut self, expr: &Expr, x: Type, y: Type) -> Result<Option<Unit>, Reported> {
        let (Some(x), Some(y)) = (x.unit, y.unit) else { return Ok(None) };
        self.bounded(expr, x.times(y)).map(Some)
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
            Function::Sqrt => Ok(Type { unit: self.changed(expr, x, |unit| unit.power(1, 2))?, ..x }),
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

fn shape(of: Type) -> &'static str {
    if of.vector { "a vector" } else { "a scalar" }
}

/// A unit in the words of a message; numbers and angles have none.
fn shown(unit: Unit) -> String {
    if unit == Unit::NONE { "without unit".to_owned() } else { format!("in {unit}") }
}

/// Advice: the factor that is missing between two units.
fn unit_help(is: Unit, needs: Unit) -> String {
    match needs.per(is) {
        Some(missing) if is == Unit::NONE => {
            format!("a literal may carry its unit, such as 0.5_m; a factor in {missing} is missing")
        }
        Some(missing) => format!("a factor in {missing} is missing"),
        None => "the two must be equal".to_owned(),
    }
}
