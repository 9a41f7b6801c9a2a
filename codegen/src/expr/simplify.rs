//! Local identities, one per line, applied left to right: the right side never costs more than the left (a square root
//! counts less than two transcendental functions).

use super::dag::Dag;
use super::evaluate;
use super::node::{Binary, Dependence, ExprId, Node, Unary};
use super::number::Number;
use smartbed_runtime::real::Real;

/// Shorter form of -a.
pub(super) fn negate(dag: &mut Dag, a: ExprId) -> Option<ExprId> {
    match dag.node(a) {
        Node::Number(c) => Some(dag.number(c.negate())), // -(c) folds
        Node::Negate(x) => Some(x),                      // -(-x) = x
        Node::Binary(Binary::Sub, x, y) => Some(dag.sub(y, x)), // -(x - y) = y - x
        _ => None,
    }
}

/// Shorter form of f(a).
pub(super) fn unary(dag: &mut Dag, function: Unary, a: ExprId) -> Option<ExprId> {
    use Unary::{Abs, Acos, Asin, Cos, Sign, Sin, Sqrt, Tan, Tanh};
    if let Node::Negate(x) = dag.node(a) {
        match function {
            Sin | Tan | Asin | Tanh | Sign => {
                let f = dag.unary(function, x); // odd: f(-x) = -f(x)
                return Some(dag.negate(f));
            }
            Cos | Abs => return Some(dag.unary(function, x)), // even: f(-x) = f(x)
            _ => {}
        }
    }
    if let (Abs, Node::Binary(Binary::Mul, x, y)) = (function, dag.node(a))
        && x == y
    {
        return Some(a); // |x^2| = x^2
    }
    if let (Sin | Cos, Node::Unary(inverse @ (Asin | Acos), x)) = (function, dag.node(a)) {
        if (function == Sin) == (inverse == Asin) {
            return Some(x); // sin(asin x) = x, cos(acos x) = x
        }
        let one = dag.one();
        let square = dag.mul(x, x);
        let rest = dag.sub(one, square);
        return Some(dag.sqrt(rest)); // cos(asin x) = sin(acos x) = sqrt(1 - x^2): both ranges have it >= 0
    }
    if let (Sin | Cos, Some(angle)) = (function, degrees(dag, a))
        && let Some(exact) = sine_of_degrees(if function == Sin { angle } else { angle + 90.0 })
    {
        return Some(dag.number(exact)); // sin, cos of multiples of 30 and 45 degrees
    }
    let c = dag.as_number(a)?;
    Some(match function {
        Sqrt => dag.number(c.sqrt()),
        _ => dag.constant(evaluate::unary(function, c.to_f64())),
    })
}

/// The angle in degrees, if `a` is a rational multiple of pi.
fn degrees(dag: &Dag, a: ExprId) -> Option<f64> {
    match dag.node(a) {
        Node::Number(c) if c == Number::ZERO => Some(0.0),
        Node::Pi => Some(180.0),
        Node::Negate(x) => degrees(dag, x).map(|d| -d),
        Node::Binary(Binary::Mul, c, x) => Some(snap(dag.as_number(c)?.to_f64() * degrees(dag, x)?)),
        _ => None,
    }
}

/// Rounds to the whole degree that k pi/180 stands for, since it has gone through two roundings.
fn snap(degrees: f64) -> f64 {
    if (degrees - degrees.round()).abs() < 1e-12 * degrees.abs().max(1.0) { degrees.round() } else { degrees }
}

/// Exact sine of a multiple of 30 or 45 degrees.
fn sine_of_degrees(angle: f64) -> Option<Number> {
    let angle = angle.rem_euclid(360.0);
    let (angle, negative) = if angle >= 180.0 { (angle - 180.0, true) } else { (angle, false) };
    let first = if angle > 90.0 { 180.0 - angle } else { angle };
    let sine = match first {
        0.0 => Number::ZERO,
        30.0 => Number::rational(1, 2),
        45.0 => Number::rational(1, 2).sqrt(),
        60.0 => Number::rational(3, 4).sqrt(),
        90.0 => Number::ONE,
        _ => return None,
    };
    Some(if negative { sine.negate() } else { sine })
}

/// Shorter form of a (op) b; operands of sums and products come ordered by id.
pub(super) fn binary(dag: &mut Dag, operator: Binary, a: ExprId, b: ExprId) -> Option<ExprId> {
    match operator {
        Binary::Add => add(dag, a, b),
        Binary::Sub => sub(dag, a, b),
        Binary::Mul => mul(dag, a, b),
        Binary::Div => div(dag, a, b),
        Binary::Atan2 => fold_two(dag, a, b, Real::atan2),
        Binary::Min if a == b => Some(a), // min(x, x) = x
        Binary::Max if a == b => Some(a), // max(x, x) = x
        Binary::Min => fold_two(dag, a, b, f64::min),
        Binary::Max => fold_two(dag, a, b, f64::max),
    }
}

fn fold_two(dag: &mut Dag, a: ExprId, b: ExprId, f: fn(f64, f64) -> f64) -> Option<ExprId> {
    let (x, y) = (dag.as_number(a)?.to_f64(), dag.as_number(b)?.to_f64());
    Some(dag.constant(f(x, y)))
}

fn add(dag: &mut Dag, a: ExprId, b: ExprId) -> Option<ExprId> {
    if dag.is_zero(a) || dag.is_zero(b) {
        return Some(if dag.is_zero(a) { b } else { a }); // 0 + x = x + 0 = x
    }
    if let (Some(x), Some(y)) = (dag.as_number(a), dag.as_number(b)) {
        return Some(dag.number(x.plus(y))); // constants fold
    }
    match (dag.node(a), dag.node(b)) {
        (Node::Negate(x), Node::Negate(y)) => {
            let sum = dag.add(x, y); // -x - y = -(x + y)
            Some(dag.negate(sum))
        }
        (_, Node::Negate(y)) => Some(dag.sub(a, y)), // x + -y = x - y
        (Node::Negate(x), _) => Some(dag.sub(b, x)), // -x + y = y - x
        (Node::Binary(Binary::Sub, x, y), _) if y == b => Some(x), // (x - y) + y = x
        (_, Node::Binary(Binary::Sub, x, y)) if y == a => Some(x), // y + (x - y) = x
        _ if a == b => {
            let two = dag.number(Number::integer(2)); // x + x = 2 x
            Some(dag.mul(two, a))
        }
        _ if is_sine_and_cosine_squared(dag, a, b) => Some(dag.one()), // sin^2 + cos^2 = 1
        _ => like_terms(dag, a, b, false),
    }
}

fn sub(dag: &mut Dag, a: ExprId, b: ExprId) -> Option<ExprId> {
    if dag.is_zero(a) || dag.is_zero(b) {
        return Some(if dag.is_zero(b) { a } else { dag.negate(b) }); // x - 0 = x, 0 - x = -x
    }
    if let (Some(x), Some(y)) = (dag.as_number(a), dag.as_number(b)) {
        return Some(dag.number(x.plus(y.negate()))); // constants fold
    }
    match (dag.node(a), dag.node(b)) {
        _ if a == b => Some(dag.zero()),             // x - x = 0
        (_, Node::Negate(y)) => Some(dag.add(a, y)), // x - -y = x + y
        (Node::Negate(x), _) => {
            let sum = dag.add(x, b); // -x - y = -(x + y)
            Some(dag.negate(sum))
        }
        (Node::Binary(Binary::Add, x, y), _) if y == b => Some(x), // (x + y) - y = x
        (Node::Binary(Binary::Add, x, y), _) if x == b => Some(y), // (x + y) - x = y
        (_, Node::Binary(Binary::Sub, x, y)) if x == a => Some(y), // x - (x - y) = y
        (_, Node::Binary(Binary::Add, x, y)) if x == a => Some(dag.negate(y)), // x - (x + y) = -y
        (_, Node::Binary(Binary::Add, x, y)) if y == a => Some(dag.negate(x)), // y - (x + y) = -x
        (Node::Number(Number::ONE), Node::Binary(Binary::Mul, x, y)) if x == y => match dag.node(x) {
            Node::Unary(Unary::Sin, angle) => {
                let cos = dag.cos(angle); // 1 - sin^2 = cos^2
                Some(dag.mul(cos, cos))
            }
            Node::Unary(Unary::Cos, angle) => {
                let sin = dag.sin(angle); // 1 - cos^2 = sin^2
                Some(dag.mul(sin, sin))
            }
            _ => None,
        },
        _ => like_terms(dag, a, b, true),
    }
}

/// c x + d x = (c + d) x for constants c, d (and the same with minus).
fn like_terms(dag: &mut Dag, a: ExprId, b: ExprId, minus: bool) -> Option<ExprId> {
    let (c, x) = coefficient(dag, a);
    let (d, y) = coefficient(dag, b);
    if x != y || (c == Number::ONE && d == Number::ONE) {
        return None;
    }
    let sum = dag.number(c.plus(if minus { d.negate() } else { d }));
    Some(dag.mul(sum, x))
}

fn coefficient(dag: &Dag, a: ExprId) -> (Number, ExprId) {
    match dag.node(a) {
        Node::Binary(Binary::Mul, c, x) => match dag.node(c) {
            Node::Number(number) => (number, x),
            _ => (Number::ONE, a),
        },
        _ => (Number::ONE, a),
    }
}

fn is_sine_and_cosine_squared(dag: &Dag, a: ExprId, b: ExprId) -> bool {
    let squared = |id| match dag.node(id) {
        Node::Binary(Binary::Mul, x, y) if x == y => match dag.node(x) {
            Node::Unary(function, angle) => Some((function, angle)),
            _ => None,
        },
        _ => None,
    };
    match (squared(a), squared(b)) {
        (Some((Unary::Sin, x)), Some((Unary::Cos, y))) | (Some((Unary::Cos, x)), Some((Unary::Sin, y))) => {
            x == y
        }
        _ => false,
    }
}

fn mul(dag: &mut Dag, a: ExprId, b: ExprId) -> Option<ExprId> {
    if dag.is_zero(a) || dag.is_zero(b) {
        return Some(dag.zero()); // 0 x = x 0 = 0
    }
    // A numeric factor, if any, is handled first and kept on the left by `times_constant`.
    match (dag.node(a), dag.node(b)) {
        (Node::Number(x), Node::Number(y)) => Some(dag.number(x.multiply(y))), // constants fold
        (Node::Number(c), _) => times_constant(dag, c, a, b),
        (_, Node::Number(c)) => times_constant(dag, c, b, a),
        (Node::Negate(x), Node::Negate(y)) => Some(dag.mul(x, y)), // -x -y = x y
        (Node::Negate(x), _) => {
            let product = dag.mul(x, b); // (-x) y = -(x y)
            Some(dag.negate(product))
        }
        (_, Node::Negate(y)) => {
            let product = dag.mul(a, y); // x (-y) = -(x y)
            Some(dag.negate(product))
        }
        (Node::Unary(Unary::Sqrt, x), _) if a == b => Some(x), // sqrt(x)^2 = x
        (Node::Binary(Binary::Div, x, y), _) if y == b => Some(x), // (x / y) y = x
        (_, Node::Binary(Binary::Div, x, y)) if y == a => Some(x), // y (x / y) = x
        _ => prepared_factor(dag, a, b).or_else(|| prepared_factor(dag, b, a)),
    }
}

/// p (r x) = (p r) x for p, r of parameters alone: p r is computed once per change of parameters.
fn prepared_factor(dag: &mut Dag, p: ExprId, product: ExprId) -> Option<ExprId> {
    let (r, x) = prepared_part(dag, product)?;
    if dag.dependence(p) == Dependence::State {
        return None;
    }
    let factor = dag.mul(p, r);
    Some(dag.mul(factor, x))
}

/// z / (r y) = ((1 / r) z) / y and (p x) / (r y) = ((p / r) x) / y for p, r of parameters alone.
fn prepared_divisor(dag: &mut Dag, dividend: ExprId, divisor: ExprId) -> Option<ExprId> {
    let (r, y) = prepared_part(dag, divisor)?;
    let (p, x) = prepared_part(dag, dividend).unwrap_or((dag.one(), dividend));
    let ratio = dag.div(p, r);
    let scaled = dag.mul(ratio, x);
    Some(dag.div(scaled, y))
}

/// (r, x) of a product r x where r depends on parameters alone and x does not.
fn prepared_part(dag: &Dag, product: ExprId) -> Option<(ExprId, ExprId)> {
    let Node::Binary(Binary::Mul, x, y) = dag.node(product) else { return None };
    let is_state = |e| dag.dependence(e) == Dependence::State;
    match (is_state(x), is_state(y)) {
        (false, true) if dag.as_number(x).is_none() => Some((x, y)),
        (true, false) if dag.as_number(y).is_none() => Some((y, x)),
        _ => None,
    }
}

/// c x. The constant is always the left operand, whatever the ids: see [`ordered_constant_product`].
fn times_constant(dag: &mut Dag, c: Number, constant: ExprId, x: ExprId) -> Option<ExprId> {
    if dag.is_one(constant) {
        return Some(x); // 1 x = x
    }
    if c.is_negative() {
        let positive = dag.number(c.negate());
        let product = dag.mul(positive, x); // (-c) x = -(c x)
        return Some(dag.negate(product));
    }
    match dag.node(x) {
        Node::Negate(y) => {
            let product = dag.mul(constant, y); // c (-y) = -(c y)
            Some(dag.negate(product))
        }
        Node::Binary(Binary::Mul, d, y) => match dag.node(d) {
            Node::Number(number) => {
                let folded = dag.number(c.multiply(number)); // c (d y) = (c d) y
                Some(dag.mul(folded, y))
            }
            _ => Some(ordered_constant_product(dag, constant, x)),
        },
        _ => Some(ordered_constant_product(dag, constant, x)),
    }
}

fn ordered_constant_product(dag: &mut Dag, constant: ExprId, x: ExprId) -> ExprId {
    dag.intern(Node::Binary(Binary::Mul, constant, x))
}

fn div(dag: &mut Dag, a: ExprId, b: ExprId) -> Option<ExprId> {
    match (dag.node(a), dag.node(b)) {
        (_, Node::Number(c)) if c != Number::ZERO => {
            let reciprocal = dag.number(c.reciprocal()); // x / c = (1/c) x
            Some(dag.mul(reciprocal, a))
        }
        (_, Node::Number(_)) => None,   // x / 0 is no number, nor is 0 / 0
        _ if dag.is_zero(a) => Some(a), // 0 / x = 0
        _ if a == b => Some(dag.one()), // x / x = 1
        (Node::Negate(x), Node::Negate(y)) => Some(dag.div(x, y)), // -x / -y = x / y
        (Node::Negate(x), _) => {
            let quotient = dag.div(x, b); // -x / y = -(x / y)
            Some(dag.negate(quotient))
        }
        (_, Node::Negate(y)) => {
            let quotient = dag.div(a, y); // x / -y = -(x / y)
            Some(dag.negate(quotient))
        }
        (Node::Binary(Binary::Mul, x, y), _) if y == b => Some(x), // (x y) / y = x
        (Node::Binary(Binary::Mul, x, y), _) if x == b => Some(y), // (x y) / x = y
        (_, Node::Binary(Binary::Mul, x, y)) if x == a => {
            let one = dag.one(); // x / (x y) = 1 / y
            Some(dag.div(one, y))
        }
        (_, Node::Binary(Binary::Mul, x, y)) if y == a => {
            let one = dag.one(); // y / (x y) = 1 / x
            Some(dag.div(one, x))
        }
        (_, Node::Unary(Unary::Sqrt, x)) if x == a => Some(b), // x / sqrt(x) = sqrt(x)
        (_, Node::Binary(Binary::Div, x, y)) if dag.is_one(x) => Some(dag.mul(a, y)), // z / (1 / y) = z y
        _ => prepared_divisor(dag, a, b),
    }
}
