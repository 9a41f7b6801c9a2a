//! Lowers the model's expression trees into the shared DAG.

use super::choice::ParameterChoice;
use super::lifted;
use super::quantities::{Kinematics, Value};
use super::unknowns::{Unknown, UnknownKind, Unknowns};
use crate::expr::number::Number;
use crate::expr::{Binary, Dag, ExprId, Unary};
use crate::id::IdVec;
use crate::model::expression::{Expr, ExprKind, Function};
use crate::model::{Entity, Model};
use crate::vector::{Algebra, Turn, Vector};

/// Creates symbols for time, coordinates, inputs, parameters and speeds; leaves all other tables empty.
pub(super) fn symbols(alg: &mut Algebra, model: &Model, choice: &ParameterChoice) -> Kinematics {
    let Algebra { dag, triads } = alg;
    let time = dag.symbol("t");
    let zero = dag.zero();
    let is_state: IdVec<_, bool> = model.coordinates.iter().map(|c| c.closed_form.is_none()).collect();
    let q =
        model.coordinates.iter().map(|c| if c.closed_form.is_none() { dag.symbol(&c.name) } else { zero });
    let q = q.collect();
    let inputs = model.inputs.iter().map(|i| dag.symbol(&i.name)).collect();
    let mut unknowns = Unknowns::default();
    for (speed, declared) in model.speeds.enumerate() {
        let value = dag.symbol(&declared.name);
        let kind = match declared.independent {
            true => UnknownKind::Independent(speed),
            false => UnknownKind::Dependent(speed),
        };
        unknowns.push(Unknown { name: declared.name.clone(), value, kind });
    }
    let one = dag.one();
    let clock = Unknown { name: "clock".to_owned(), value: one, kind: UnknownKind::Clock };
    if model.is_driven() {
        unknowns.push(clock);
    }
    let inertial = triads.push(Turn::Inertial);
    let k = Kinematics {
        time,
        q,
        is_state,
        closed_forms: Vec::new(),
        inputs,
        parameters: model.parameters.iter().map(|_| zero).collect(),
        parameter_values: model.parameter_values(&choice.values),
        unknowns,
        frame_triad: model.frames.iter().map(|_| inertial).collect(),
        positions: model.points.iter().map(|_| Vector::zero()).collect(),
        flat_positions: Default::default(),
        definitions: model.definitions.iter().map(|_| None).collect(),
        rates: IdVec::default(),
        angular: IdVec::default(),
        velocities: IdVec::default(),
        term_derivatives: Default::default(),
        rows: Vec::new(),
        spare_rows: Vec::new(),
        residuals: Vec::new(),
        residual_names: Vec::new(),
        implied: Vec::new(),
        implied_names: Vec::new(),
        implied_motions: Vec::new(),
        fixed_vectors: Vec::new(),
        combinations: Vec::new(),
        rate_pivots: Vec::new(),
        samples: Vec::new(),
        sample_times: Vec::new(),
    };
    parameters(alg, model, choice, k)
}

/// Makes tunable parameters symbols and replaces fixed ones by their values.
fn parameters(alg: &mut Algebra, model: &Model, choice: &ParameterChoice, mut k: Kinematics) -> Kinematics {
    for entity in &model.order {
        let Entity::Parameter(id) = *entity else { continue };
        let parameter = &model.parameters[id];
        let set = choice.values.get(&parameter.name).copied();
        let kept = parameter.tunable || choice.keep.contains(&parameter.name);
        k.parameters[id] = match (kept, set) {
            (true, _) => alg.dag.parameter(&parameter.name),
            (false, Some(value)) => alg.dag.constant(value),
            (false, None) => scalar(alg, &k, &parameter.value),
        };
    }
    k
}

/// Lowers an expression that must be a scalar.
///
/// # Panics
/// If it is a vector, which the model's type check excludes.
pub(crate) fn scalar(alg: &mut Algebra, k: &Kinematics, expr: &Expr) -> ExprId {
    match value(alg, k, expr) {
        Value::Scalar(e) => e,
        Value::Vector(_) => unreachable!("type-checked: a scalar was expected"),
    }
}

/// Lowers an expression that must be a vector.
///
/// # Panics
/// If it is a scalar other than a literal 0, which the model's type check excludes.
pub(crate) fn vector(alg: &mut Algebra, k: &Kinematics, expr: &Expr) -> Vector {
    match value(alg, k, expr) {
        Value::Vector(v) => v,
        Value::Scalar(e) if alg.dag.is_zero(e) => Vector::zero(),
        Value::Scalar(_) => unreachable!("type-checked: a vector was expected"),
    }
}

/// Does the expression depend on velocities?
pub(super) fn needs_motion(k: &Kinematics, expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Velocity(_) | ExprKind::AngularVelocity(_) | ExprKind::Rate(_) => true,
        ExprKind::Definition(d) => k.definitions[*d].is_none(),
        ExprKind::Negate(a) | ExprKind::Power(a, _) | ExprKind::Norm(a) => needs_motion(k, a),
        ExprKind::Add(a, b)
        | ExprKind::Subtract(a, b)
        | ExprKind::Multiply(a, b)
        | ExprKind::Divide(a, b)
        | ExprKind::Dot(a, b)
        | ExprKind::Cross(a, b) => needs_motion(k, a) || needs_motion(k, b),
        ExprKind::Call(_, arguments) => arguments.iter().any(|a| needs_motion(k, a)),
        _ => false,
    }
}

/// Does the expression depend on definitions that have not been lowered yet?
pub(super) fn needs_definitions(k: &Kinematics, expr: &Expr) -> bool {
    let mut found = false;
    expr.visit(&mut |e| {
        found |= matches!(e.kind, ExprKind::Definition(id) if k.definitions[id].is_none());
    });
    found
}

/// Lowers an expression (nesting is limited by the parser).
pub(super) fn value(alg: &mut Algebra, k: &Kinematics, expr: &Expr) -> Value {
    match &expr.kind {
        ExprKind::Number(x) => Value::Scalar(alg.dag.constant(*x)),
        ExprKind::Pi => Value::Scalar(alg.dag.pi()),
        ExprKind::Degree => {
            let (pi, half_turn) = (alg.dag.pi(), alg.dag.number(Number::rational(1, 180)));
            Value::Scalar(alg.dag.mul(half_turn, pi))
        }
        ExprKind::Time => Value::Scalar(k.time),
        ExprKind::Parameter(id) => Value::Scalar(k.parameters[*id]),
        ExprKind::Coordinate(id) => Value::Scalar(k.q[*id]),
        ExprKind::Rate(id) => Value::Scalar(k.rates[*id].value(alg, k)),
        ExprKind::Speed(id) => Value::Scalar(k.unknowns[k.unknowns.of(*id)].value),
        ExprKind::Input(id) => Value::Scalar(k.inputs[*id]),
        ExprKind::Definition(id) => {
            k.definitions[*id].clone().expect("definitions are lowered before what reads them")
        }
        ExprKind::Point(id) => Value::Vector(k.positions[*id].clone()),
        ExprKind::Velocity(id) => Value::Vector(k.velocities[*id].value(alg, k)),
        ExprKind::AngularVelocity(id) => Value::Vector(k.angular[k.frame_triad[*id]].value(alg, k)),
        ExprKind::Axis(frame, axis) => {
            let triad = k.frame_triad[*frame];
            Value::Vector(Vector::axis(&mut alg.dag, triad, *axis))
        }
        ExprKind::Power(a, n) => {
            let a = scalar(alg, k, a);
            Value::Scalar(alg.dag.powi(a, *n))
        }
        ExprKind::Call(function, arguments) => {
            let arguments: Vec<_> = arguments.iter().map(|a| scalar(alg, k, a)).collect();
            Value::Scalar(call(&mut alg.dag, *function, &arguments))
        }
        _ => operator(alg, k, &expr.kind),
    }
}

fn operator(alg: &mut Algebra, k: &Kinematics, kind: &ExprKind) -> Value {
    match kind {
        ExprKind::Negate(a) => match value(alg, k, a) {
            Value::Vector(v) => Value::Vector(v.negated(&mut alg.dag)),
            Value::Scalar(x) => Value::Scalar(alg.dag.negate(x)),
        },
        ExprKind::Add(a, b) | ExprKind::Subtract(a, b) => {
            let minus = matches!(kind, ExprKind::Subtract(..));
            match (value(alg, k, a), value(alg, k, b)) {
                (Value::Scalar(x), Value::Scalar(y)) => {
                    Value::Scalar(if minus { alg.dag.sub(x, y) } else { alg.dag.add(x, y) })
                }
                (x, y) => {
                    let (x, y) = (as_vector(x), as_vector(y));
                    Value::Vector(if minus { x.minus(&mut alg.dag, &y) } else { x.plus(&mut alg.dag, &y) })
                }
            }
        }
        ExprKind::Multiply(a, b) => match (value(alg, k, a), value(alg, k, b)) {
            (Value::Scalar(x), Value::Scalar(y)) => Value::Scalar(alg.dag.mul(x, y)),
            (Value::Vector(v), Value::Scalar(x)) | (Value::Scalar(x), Value::Vector(v)) => {
                Value::Vector(v.scaled(&mut alg.dag, x))
            }
            (Value::Vector(_), Value::Vector(_)) => {
                unreachable!("type-checked: vectors are multiplied by dot or cross")
            }
        },
        ExprKind::Divide(a, b) => {
            let divisor = scalar(alg, k, b);
            match value(alg, k, a) {
                Value::Scalar(x) => Value::Scalar(alg.dag.div(x, divisor)),
                Value::Vector(v) => {
                    let one = alg.dag.one();
                    let reciprocal = alg.dag.div(one, divisor);
                    Value::Vector(v.scaled(&mut alg.dag, reciprocal))
                }
            }
        }
        ExprKind::Dot(a, b) => {
            let (a, b) = (flat_vector(alg, k, a), flat_vector(alg, k, b));
            Value::Scalar(alg.dot(&a, &b))
        }
        ExprKind::Cross(a, b) => {
            let (a, b) = (flat_vector(alg, k, a), flat_vector(alg, k, b));
            Value::Vector(alg.cross(&a, &b))
        }
        ExprKind::Norm(a) => {
            let a = flat_vector(alg, k, a);
            let square = alg.square(&a);
            if reads_speeds(alg, k, square) {
                Value::Scalar(alg.dag.norm(square))
            } else {
                Value::Scalar(alg.dag.sqrt(square))
            }
        }
        _ => unreachable!("every other kind is lowered by `value`"),
    }
}

fn reads_speeds(alg: &Algebra, k: &Kinematics, e: ExprId) -> bool {
    let read = alg.dag.symbols_of(e);
    k.unknowns
        .iter()
        .any(|unknown| alg.dag.as_symbol(unknown.value).is_some_and(|symbol| read.contains(&symbol)))
}

/// A literal 0 may stand for the zero vector.
fn as_vector(value: Value) -> Vector {
    match value {
        Value::Vector(v) => v,
        Value::Scalar(_) => Vector::zero(),
    }
}

fn flat_vector(alg: &mut Algebra, k: &Kinematics, expr: &Expr) -> Vector {
    let v = vector(alg, k, expr);
    lifted::flatten(alg, k, &v)
}

fn call(dag: &mut Dag, function: Function, arguments: &[ExprId]) -> ExprId {
    let first = arguments[0];
    match function {
        Function::Sin => dag.unary(Unary::Sin, first),
        Function::Cos => dag.unary(Unary::Cos, first),
        Function::Tan => dag.unary(Unary::Tan, first),
        Function::Asin => dag.unary(Unary::Asin, first),
        Function::Acos => dag.unary(Unary::Acos, first),
        Function::Sqrt => dag.unary(Unary::Sqrt, first),
        Function::Exp => dag.unary(Unary::Exp, first),
        Function::Ln => dag.unary(Unary::Ln, first),
        Function::Tanh => dag.unary(Unary::Tanh, first),
        Function::Abs => dag.unary(Unary::Abs, first),
        Function::Sign => dag.unary(Unary::Sign, first),
        Function::Atan2 => dag.binary(Binary::Atan2, first, arguments[1]),
        Function::Min => dag.binary(Binary::Min, first, arguments[1]),
        Function::Max => dag.binary(Binary::Max, first, arguments[1]),
        Function::SmoothStep => smooth_step(dag, first, arguments[1]),
    }
}

/// s^2 (3 - 2 s) with s = (x + width)/(2 width) limited to [0, 1]: cubic, once differentiable.
fn smooth_step(dag: &mut Dag, x: ExprId, width: ExprId) -> ExprId {
    let (zero, one) = (dag.zero(), dag.one());
    let (two, three) = (dag.number(Number::integer(2)), dag.number(Number::integer(3)));
    let (shifted, span) = (dag.add(x, width), dag.mul(two, width));
    let ratio = dag.div(shifted, span);
    let below = dag.binary(Binary::Max, ratio, zero);
    let s = dag.binary(Binary::Min, below, one);
    let (square, twice) = (dag.mul(s, s), dag.mul(two, s));
    let rest = dag.sub(three, twice);
    dag.mul(square, rest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smooth_step_is_zero_one_and_a_half() {
        let mut dag = Dag::default();
        let x = dag.symbol("x");
        let width = dag.constant(2.0);
        let step = smooth_step(&mut dag, x, width);
        let at = |value: f64| dag.evaluate::<f64>(&[step], &|_| value)[0];
        assert_eq!((at(-5.0), at(0.0), at(9.0)), (0.0, 0.5, 1.0));
        assert_eq!(at(1.0) + at(-1.0), 1.0);
    }
}
