//! Evaluates constant expressions in f64: parameter defaults, nominal values, ranges, starts.
//!
//! Only what does not depend on the state has a value; anything else gives NaN, and earlier checks have ruled it out.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::id::IdVec;
use crate::model::data::*;
use crate::model::draft::Draft;
use crate::model::expression::{Expr, ExprKind, Function};
use crate::model::ids::*;
use crate::model::unit::{self, Unit};
use crate::source::Span;
use smartbed_runtime::real::Real;
use std::collections::BTreeMap;

/// Values of everything constant.
#[derive(Debug)]
pub struct Constants {
    /// Parameters.
    pub parameters: IdVec<ParameterId, f64>,
    /// Definitions; NaN where not constant.
    pub definitions: IdVec<DefinitionId, f64>,
}

impl Constants {
    /// Values of the model's own defaults.
    pub fn of(model: &Model) -> Self {
        Self::set(model, &BTreeMap::new())
    }

    /// Values with these parameters set, by name; what is an expression of them follows.
    fn set(model: &Model, set: &BTreeMap<String, f64>) -> Self {
        let mut constants = Self {
            parameters: model.parameters.iter().map(|_| f64::NAN).collect(),
            definitions: model.definitions.iter().map(|_| f64::NAN).collect(),
        };
        for entity in &model.order {
            match *entity {
                Entity::Parameter(id) => {
                    let parameter = &model.parameters[id];
                    let given = set.get(&parameter.name).copied();
                    constants.parameters[id] = given.unwrap_or_else(|| constants.value(&parameter.value));
                }
                Entity::Definition(id) => {
                    constants.definitions[id] = constants.value(&model.definitions[id].value);
                }
                Entity::Frame(_) | Entity::Point(_) | Entity::Coordinate(_) => {}
            }
        }
        constants
    }

    /// Values at other parameters.
    pub fn with(model: &Model, parameters: &IdVec<ParameterId, f64>) -> Self {
        let definitions = model.definitions.iter().map(|_| f64::NAN).collect();
        let mut constants = Self { parameters: parameters.clone(), definitions };
        for entity in &model.order {
            if let Entity::Definition(id) = *entity {
                constants.definitions[id] = constants.value(&model.definitions[id].value);
            }
        }
        constants
    }

    /// Value of an expression, NaN if it is not constant or not a scalar.
    pub fn value(&self, expr: &Expr) -> f64 {
        match &expr.kind {
            ExprKind::Number(number) => *number,
            ExprKind::Pi => std::f64::consts::PI,
            ExprKind::Degree => std::f64::consts::PI / 180.0,
            ExprKind::Parameter(id) => self.parameters[*id],
            ExprKind::Definition(id) => self.definitions[*id],
            ExprKind::Negate(a) => -self.value(a),
            ExprKind::Add(a, b) => self.value(a) + self.value(b),
            ExprKind::Subtract(a, b) => self.value(a) - self.value(b),
            ExprKind::Multiply(a, b) => self.value(a) * self.value(b),
            ExprKind::Divide(a, b) => self.value(a) / self.value(b),
            ExprKind::Power(a, n) => self.value(a).powi(*n),
            ExprKind::Call(function, arguments) => {
                let values: Vec<f64> = arguments.iter().map(|a| self.value(a)).collect();
                call(*function, &values)
            }
            _ => f64::NAN,
        }
    }
}

/// Fills in all numbers, after everything has been checked.
pub fn evaluate(draft: Draft, found: &mut Diagnostics) -> Model {
    let mut model = draft.model;
    fill_in(&mut model, found);
    model
}

fn fill_in(model: &mut Model, found: &mut Diagnostics) {
    let constants = Constants::of(model);
    for (id, value) in constants.parameters.enumerate() {
        let parameter = &model.parameters[id];
        finite(*value, parameter.value.span, found);
        if let Some(message) = parameter.refuses(*value) {
            found.push(
                Diagnostic::error(message)
                    .label(parameter.value.span, "this value")
                    .help("correct the value, or give another `range`"),
            );
        }
    }
    let mut value = |expr: &Expr| finite(constants.value(expr), expr.span, found);
    for id in model.coordinates.ids() {
        let [nominal, low, high] = &model.coordinates[id].written;
        let nominal = nominal.as_ref().map_or(0.0, &mut value);
        // Default range: one full turn for angles, one unit to either side for everything else.
        let is_angle = unit::parse(&model.coordinates[id].unit).is_ok_and(|scale| scale.unit == Unit::NONE);
        let reach = if is_angle { std::f64::consts::PI } else { 1.0 };
        let low = low.as_ref().map_or(nominal - reach, &mut value);
        let high = high.as_ref().map_or(nominal + reach, &mut value);
        let coordinate = &mut model.coordinates[id];
        (coordinate.nominal, coordinate.range) = (nominal, (low, high));
    }
    for configuration in &mut model.configurations {
        configuration.values = configuration.written.iter().map(|(id, expr)| (*id, value(expr))).collect();
    }
    model.start = model.start_written.iter().map(|(of, expr)| (*of, value(expr))).collect();
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

/// Value of a function, by the runtime's implementation: those of the system round differently from machine to machine.
fn call(function: Function, arguments: &[f64]) -> f64 {
    let (x, y) = (arguments[0], arguments.get(1).copied().unwrap_or(f64::NAN));
    match function {
        Function::Sin => Real::sin_cos(x).0,
        Function::Cos => Real::sin_cos(x).1,
        Function::Tan => Real::tan(x),
        Function::Asin => Real::asin(x),
        Function::Acos => Real::acos(x),
        Function::Atan2 => Real::atan2(x, y),
        Function::Sqrt => Real::sqrt(x),
        Function::Exp => Real::exp(x),
        Function::Ln => Real::ln(x),
        Function::Tanh => Real::tanh(x),
        Function::Abs => x.abs(),
        Function::Sign if x == 0.0 => 0.0,
        Function::Sign => x.signum(),
        Function::Min => x.min(y),
        Function::Max => x.max(y),
        Function::SmoothStep => {
            let s = ((x / y).clamp(-1.0, 1.0) + 1.0) / 2.0;
            s * s * (3.0 - 2.0 * s)
        }
    }
}

impl Parameter {
    /// The reason why the parameter cannot have this value (SI), if it is outside the range.
    #[must_use]
    pub fn refuses(&self, value: f64) -> Option<String> {
        let (low, high) = self.range;
        // The same number in another unit is rounded otherwise.
        let rounding = |bound: f64| 4.0 * f64::EPSILON * bound.abs();
        let outside = value < low - rounding(low) || high + rounding(high) < value;
        outside.then(|| {
            let unit = if self.unit == "1" { String::new() } else { format!(" {}", self.unit) };
            format!("parameter `{}` is {value}; expected a number from {low} to {high}{unit}", self.name)
        })
    }
}

impl Model {
    /// The reason why the parameter of this name cannot have this value (SI); `None` also if there is no such
    /// parameter.
    #[must_use]
    pub fn refuses(&self, name: &str, value: f64) -> Option<String> {
        self.parameters.iter().find(|parameter| parameter.name == name)?.refuses(value)
    }

    /// The model with other values of parameters (SI), by name. What it states as expressions of them follows: other
    /// parameters, nominal values, ranges, configurations and the start.
    ///
    /// # Errors
    /// What has no finite value then, and parameters that leave their ranges.
    pub fn with_values(&self, values: &BTreeMap<String, f64>) -> Result<Self, Diagnostics> {
        let mut model = self.clone();
        for id in self.parameters.ids() {
            let Parameter { name, value, .. } = &mut model.parameters[id];
            if let Some(number) = values.get(name) {
                value.kind = ExprKind::Number(*number);
            }
        }
        let mut found = Diagnostics::new(self.source.clone());
        fill_in(&mut model, &mut found);
        if found.has_errors() { Err(found) } else { Ok(model) }
    }

    /// Values of all parameters (SI) with some of them set, by name: those that are expressions of others follow.
    #[must_use]
    pub fn parameter_values(&self, set: &BTreeMap<String, f64>) -> IdVec<ParameterId, f64> {
        Constants::set(self, set).parameters
    }

    /// Default value of every parameter, SI.
    #[must_use]
    pub fn parameter_defaults(&self) -> IdVec<ParameterId, f64> {
        Constants::of(self).parameters
    }
}
