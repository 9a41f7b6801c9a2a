//! Evaluates nodes over any scalar: the oracle that emitted Rust is tested against.

use super::dag::Dag;
use super::node::{Binary, ExprId, Node, SymbolId, Unary};
use super::number::Number;
use smartbed_runtime::real::Real;

/// f(a) over `S`, exactly as the emitted code computes it.
pub fn unary<S: Real>(function: Unary, a: S) -> S {
    match function {
        Unary::Sqrt => a.sqrt(),
        Unary::Sin => a.sin_cos().0,
        Unary::Cos => a.sin_cos().1,
        Unary::Tan => a.tan(),
        Unary::Asin => a.asin(),
        Unary::Acos => a.acos(),
        Unary::Exp => a.exp(),
        Unary::Ln => a.ln(),
        Unary::Tanh => a.tanh(),
        Unary::Abs => a.abs(),
        Unary::Sign => a.sign(),
    }
}

/// |f'(x)|, where f(x) is `value`: the factor by which f magnifies a small error of x.
pub(crate) fn steepness(function: Unary, x: f64, value: f64) -> f64 {
    let slope = match function {
        Unary::Sqrt => 0.5 / value,
        Unary::Sin => unary(Unary::Cos, x),
        Unary::Cos => unary(Unary::Sin, x),
        Unary::Tan => 1.0 + value * value,
        Unary::Asin | Unary::Acos => 1.0 / unary(Unary::Sqrt, 1.0 - x * x),
        Unary::Exp => value,
        Unary::Ln => 1.0 / x,
        Unary::Tanh => 1.0 - value * value,
        Unary::Abs => 1.0,
        Unary::Sign => 0.0,
    };
    slope.abs()
}

/// a (op) b over `S`, exactly as the emitted code computes it.
#[inline]
pub fn binary<S: Real>(operator: Binary, a: S, b: S) -> S {
    match operator {
        Binary::Add => a + b,
        Binary::Sub => a - b,
        Binary::Mul => a * b,
        Binary::Div => a / b,
        Binary::Atan2 => a.atan2(b),
        Binary::Min => a.min(b),
        Binary::Max => a.max(b),
    }
}

/// A constant, rounded once.
pub fn number<S: Real>(number: Number) -> S {
    S::from_f64(number.to_f64())
}

impl Dag {
    /// Values of `roots` with the symbols' values from `value_of`.
    pub fn evaluate<S: Real>(&self, roots: &[ExprId], value_of: &dyn Fn(SymbolId) -> S) -> Vec<S> {
        let order = self.reachable(roots);
        // Few of all nodes, in ascending order: a search takes less than a list by node.
        let of = |values: &[S], id: ExprId| values[order.partition_point(|&other| other < id)];
        let mut values: Vec<S> = Vec::with_capacity(order.len());
        for &id in &order {
            let value = match self.node(id) {
                Node::Number(c) => number(c),
                Node::Pi => S::from_f64(std::f64::consts::PI),
                Node::Symbol(symbol) => value_of(symbol),
                Node::Negate(a) => -of(&values, a),
                Node::Unary(function @ (Unary::Sin | Unary::Cos), angle) => {
                    let (sin, cos) = match self.as_difference(angle) {
                        Some([a, b]) => S::sin_cos_of_difference(of(&values, a), of(&values, b)),
                        None => of(&values, angle).sin_cos(),
                    };
                    if function == Unary::Sin { sin } else { cos }
                }
                Node::Unary(function, a) => unary(function, of(&values, a)),
                Node::Binary(operator, a, b) => binary(operator, of(&values, a), of(&values, b)),
            };
            values.push(value);
        }
        roots.iter().map(|&root| of(&values, root)).collect()
    }
}
