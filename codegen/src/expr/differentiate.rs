//! Derivatives on the DAG: partial ones, memoised per node and symbol, and rates along given rates of the symbols.

use super::node::symbol_bit;
use super::number::Number;
use super::{Binary, Dag, ExprId, Node, SymbolId, Unary};
use crate::id::Id;
use rustc_hash::FxHashMap as HashMap;

/// Lengths below this one count as it where they divide a slope. Its square is the least normal number in f32.
const LEAST_NORM: f64 = 1e-19;

impl Dag {
    /// Partial derivative of `expr` with respect to `symbol`.
    pub fn derivative(&mut self, expr: ExprId, symbol: SymbolId) -> ExprId {
        let bit = symbol_bit(symbol);
        let is_known = |dag: &Self, id| !dag.may_read(id, bit) || dag.derivatives.contains_key(&(id, symbol));
        if is_known(self, expr) {
            return self.known_derivative(expr, symbol);
        }
        // Ascending order visits operands before their node, so no recursion is needed.
        for id in self.reachable_above(&[expr], |id| is_known(self, id)) {
            if !is_known(self, id) {
                let derivative = match self.as_symbol(id) {
                    Some(s) if s == symbol => self.one(),
                    _ => {
                        let changes = self.operands(id).map(|a| a.map(|a| self.known_derivative(a, symbol)));
                        self.change_of_node(id, changes)
                    }
                };
                self.derivatives.insert((id, symbol), derivative);
            }
        }
        self.known_derivative(expr, symbol)
    }

    /// A derivative that is known already; 0 if the expression does not contain the symbol.
    fn known_derivative(&mut self, id: ExprId, symbol: SymbolId) -> ExprId {
        if self.may_read(id, symbol_bit(symbol)) { self.derivatives[&(id, symbol)] } else { self.zero() }
    }

    /// Rate of `expr` when its symbols have the given rates and all others are constant.
    ///
    /// One forward sweep (directional derivative) that keeps factors whole: shorter than the sum of partial derivatives
    /// times rates wherever a node depends on several symbols.
    pub fn rate(&mut self, expr: ExprId, rates: &HashMap<SymbolId, ExprId>) -> ExprId {
        let moving = rates.keys().fold(0, |bits, &symbol| bits | symbol_bit(symbol));
        let zero = self.zero();
        let order = self.reachable_above(&[expr], |id| !self.may_read(id, moving));
        // Changes by node, starting at the first one in the cone.
        let first = order.first().map_or(0, |id| id.index());
        let mut changes: Vec<ExprId> = vec![zero; expr.index() + 1 - first];
        for id in order {
            let change_of = |a: ExprId| a.index().checked_sub(first).map_or(zero, |place| changes[place]);
            let change = match self.as_symbol(id).and_then(|symbol| rates.get(&symbol)) {
                Some(&rate) => rate,
                None => {
                    let operands = self.operands(id).map(|a| a.map(change_of));
                    self.change_of_node(id, operands)
                }
            };
            changes[id.index() - first] = change;
        }
        changes[expr.index() - first]
    }

    /// Change of a node from the changes of its operands (`None`: 0).
    pub(super) fn change_of_node(&mut self, id: ExprId, changes: [Option<ExprId>; 2]) -> ExprId {
        let zero = self.zero();
        if changes.iter().flatten().all(|&change| change == zero) {
            return zero;
        }
        let [da, db] = changes.map(|change| change.unwrap_or(zero));
        match self.node(id) {
            Node::Number(_) | Node::Pi | Node::Symbol(_) => zero,
            Node::Negate(_) => self.negate(da),
            Node::Unary(function, a) => {
                let slope = self.slope(function, a, id);
                self.mul(slope, da)
            }
            Node::Binary(operator, a, b) => self.derivative_of_binary(operator, [a, b], [da, db], id),
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
                if !self.is_norm(f) {
                    return self.div(half, f);
                }
                // |v|' = (v . v')/|v|: 0 where v is, and not 0/0.
                let least = self.number(Number::from_f64(LEAST_NORM));
                let length = self.binary(Binary::Max, f, least);
                self.div(half, length)
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
                // min = (a + b - |a - b|)/2: the slope of the smaller operand, the mean of both where they are equal.
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
        self.symbols_of_all(&[expr])
    }

    /// The symbols that some of `roots` depend on, ascending.
    #[must_use]
    pub fn symbols_of_all(&self, roots: &[ExprId]) -> Vec<SymbolId> {
        let mut symbols: Vec<_> = self.cone(roots).iter().filter_map(|id| self.as_symbol(id)).collect();
        symbols.sort_by_key(|s| s.index());
        symbols
    }
}
