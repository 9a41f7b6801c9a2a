//! Partial derivatives on the DAG, memoised: each node is differentiated once per symbol.

use super::number::Number;
use super::{Binary, Dag, ExprId, Node, SymbolId, Unary};
use crate::id::Id;

impl Dag {
    /// Partial derivative of `expr` with respect to `symbol`.
    pub fn derivative(&mut self, expr: ExprId, symbol: SymbolId) -> ExprId {
        // Ascending order: operands come before their node, so no recursion is needed.
        for id in self.reachable(&[expr]) {
            if !self.derivatives.contains_key(&(id, symbol)) {
                let derivative = self.derivative_of_node(id, symbol);
                self.derivatives.insert((id, symbol), derivative);
            }
        }
        self.derivatives[&(expr, symbol)]
    }

    fn derivative_of_node(&mut self, id: ExprId, symbol: SymbolId) -> ExprId {
        match self.node(id) {
            Node::Number(_) | Node::Pi => self.zero(),
            Node::Symbol(s) => {
                if s == symbol {
                    self.one()
                } else {
                    self.zero()
                }
            }
            Node::Negate(a) => {
                let da = self.derivatives[&(a, symbol)];
                self.negate(da)
            }
            Node::Unary(function, a) => {
                let da = self.derivatives[&(a, symbol)];
                if self.is_zero(da) {
                    return da;
                }
                let slope = self.slope(function, a, id);
                self.mul(slope, da)
            }
            Node::Binary(operator, a, b) => {
                let (da, db) = (self.derivatives[&(a, symbol)], self.derivatives[&(b, symbol)]);
                if self.is_zero(da) && self.is_zero(db) {
                    return da;
                }
                self.derivative_of_binary(operator, [a, b], [da, db], id)
            }
        }
    }

    /// f'(a), where `f` is the node of f(a).
    fn slope(&mut self, function: Unary, a: ExprId, f: ExprId) -> ExprId {
        let one = self.one();
        match function {
            Unary::Sin => self.cos(a),
            Unary::Cos => {
                let sin = self.sin(a);
                self.negate(sin)
            }
            Unary::Tan => {
                let square = self.mul(f, f); // tan' = 1 + tan^2
                self.add(one, square)
            }
            Unary::Sqrt => {
                let half = self.number(Number::rational(1, 2));
                self.div(half, f)
            }
            Unary::Asin | Unary::Acos => {
                let square = self.mul(a, a);
                let rest = self.sub(one, square);
                let root = self.sqrt(rest);
                let slope = self.div(one, root); // asin' = 1/sqrt(1 - a^2) = -acos'
                if function == Unary::Asin { slope } else { self.negate(slope) }
            }
            Unary::Exp => f,
            Unary::Ln => self.div(one, a),
            Unary::Tanh => {
                let square = self.mul(f, f); // tanh' = 1 - tanh^2
                self.sub(one, square)
            }
            Unary::Abs => self.unary(Unary::Sign, a),
            Unary::Sign => self.zero(),
        }
    }

    fn derivative_of_binary(
        &mut self,
        operator: Binary,
        [a, b]: [ExprId; 2],
        [da, db]: [ExprId; 2],
        f: ExprId,
    ) -> ExprId {
        match operator {
            Binary::Add => self.add(da, db),
            Binary::Sub => self.sub(da, db),
            Binary::Mul => {
                let (left, right) = (self.mul(da, b), self.mul(a, db));
                self.add(left, right)
            }
            Binary::Div => {
                let change = self.mul(f, db); // (a/b)' = (a' - (a/b) b') / b
                let numerator = self.sub(da, change);
                self.div(numerator, b)
            }
            Binary::Atan2 => {
                // atan2(a, b)' = (b a' - a b') / (a^2 + b^2)
                let (left, right) = (self.mul(b, da), self.mul(a, db));
                let (aa, bb) = (self.mul(a, a), self.mul(b, b));
                let (numerator, square) = (self.sub(left, right), self.add(aa, bb));
                self.div(numerator, square)
            }
            Binary::Min | Binary::Max => {
                // min = (a + b - |a - b|)/2: slope of the smaller one, the mean where they meet.
                let (difference, slope_difference) = (self.sub(a, b), self.sub(da, db));
                let sign = self.unary(Unary::Sign, difference);
                let (sum, change) = (self.add(da, db), self.mul(sign, slope_difference));
                let twice =
                    if operator == Binary::Min { self.sub(sum, change) } else { self.add(sum, change) };
                let half = self.number(Number::rational(1, 2));
                self.mul(half, twice)
            }
        }
    }

    /// The symbols that `expr` depends on, ascending.
    #[must_use]
    pub fn symbols_of(&self, expr: ExprId) -> Vec<SymbolId> {
        let mut symbols: Vec<_> =
            self.reachable(&[expr]).into_iter().filter_map(|id| self.as_symbol(id)).collect();
        symbols.sort_by_key(|s| s.index());
        symbols
    }
}
