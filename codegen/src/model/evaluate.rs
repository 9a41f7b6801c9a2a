//! Constant expressions in f64: parameter defaults, nominal values, ranges, starts.
//!
//! Only what does not depend on the state can be evaluated; anything else is NaN, which the
//! checks before have ruled out.

use super::expression::{Expr, ExprKind, Function};
use super::*;

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
        let mut constants = Self {
            parameters: model.parameters.iter().map(|_| f64::NAN).collect(),
            definitions: model.definitions.iter().map(|_| f64::NAN).collect(),
        };
        for entity in &model.order {
            match *entity {
                Entity::Parameter(id) => {
                    constants.parameters[id] = constants.value(&model.parameters[id].value);
                }
                Entity::Definition(id) => {
                    constants.definitions[id] = constants.value(&model.definitions[id].value);
                }
                Entity::Frame(_) | Entity::Point(_) | Entity::Coordinate(_) => {}
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

/// Value of a function.
fn call(function: Function, arguments: &[f64]) -> f64 {
    let (x, y) = (arguments[0], arguments.get(1).copied().unwrap_or(f64::NAN));
    match function {
        Function::Sin => x.sin(),
        Function::Cos => x.cos(),
        Function::Tan => x.tan(),
        Function::Asin => x.asin(),
        Function::Acos => x.acos(),
        Function::Atan2 => x.atan2(y),
        Function::Sqrt => x.sqrt(),
        Function::Exp => x.exp(),
        Function::Ln => x.ln(),
        Function::Tanh => x.tanh(),
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

impl Model {
    /// Default value of every parameter, SI.
    #[must_use]
    pub fn parameter_defaults(&self) -> IdVec<ParameterId, f64> {
        Constants::of(self).parameters
    }
}
