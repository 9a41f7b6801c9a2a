//! The expression DAG: hash-consed, simplified as it is built, never expanded to a tree.
//!
//! Every constructor first asks `simplify` for a shorter equal node, then looks the node up:
//! equal expressions have equal ids, so common subexpressions exist once. Sums and products
//! order their operands by id; negation floats outwards (it is free at run time).
//! Semantics: real arithmetic; parameters and states are taken as finite.

pub mod cost;
pub mod differentiate;
pub mod evaluate;
mod intern;
mod jacobian;
mod label;
pub mod number;
pub mod print;
pub(crate) mod rounding;
mod set;
mod simplify;
pub mod substitute;
pub mod tape;

use crate::id::{Id, IdVec, ids};
use intern::{Facts, Index, Results};
pub use label::Label;
use number::Number;
use rustc_hash::FxHashMap as HashMap;
pub(crate) use set::NodeSet;

ids! {
    /// A node of the [`Dag`].
    ExprId,
    /// A free symbol: time, coordinate, speed, input or parameter.
    SymbolId,
}

/// Operator with its operands.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Node {
    /// A constant.
    Number(Number),
    /// Pi, kept apart so that sines of multiples of 30 and 45 degrees are exact.
    Pi,
    /// A free symbol.
    Symbol(SymbolId),
    /// -a.
    Negate(ExprId),
    /// A function of one argument.
    Unary(Unary, ExprId),
    /// An operator of two arguments.
    Binary(Binary, ExprId, ExprId),
}

/// Functions of one argument.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[expect(missing_docs, reason = "the names are the functions")]
pub enum Unary {
    Sqrt,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Exp,
    Ln,
    Tanh,
    Abs,
    Sign,
}

/// Operators of two arguments.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[expect(missing_docs, reason = "the names are the operators")]
pub enum Binary {
    Add,
    Sub,
    Mul,
    Div,
    Atan2,
    Min,
    Max,
}

/// What the value of a node may change with.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Dependence {
    /// Free of symbols.
    Constant,
    /// Parameters only: needed once, until a parameter changes.
    Parameters,
    /// Time, coordinates, speeds or inputs.
    State,
}

/// The arena of nodes.
#[derive(Clone, Debug, Default)]
pub struct Dag {
    nodes: IdVec<ExprId, Node>,
    facts: IdVec<ExprId, Facts>,
    index: Index,
    results: Results,
    zero: Option<ExprId>,
    one: Option<ExprId>,
    symbols: IdVec<SymbolId, (String, Dependence)>,
    labels: HashMap<ExprId, Label>,
    derivatives: HashMap<(ExprId, SymbolId), ExprId>,
    /// Sines and cosines of differences take them unrounded; see [`Dag::as_difference`].
    pub(crate) unrounded_differences: bool,
}

impl Dag {
    /// A new free symbol. Two symbols may share a name; they stay two.
    pub fn symbol(&mut self, name: &str) -> ExprId {
        let symbol = self.symbols.push((name.to_owned(), Dependence::State));
        self.intern(Node::Symbol(symbol))
    }

    /// A new symbol that stands for a parameter.
    pub fn parameter(&mut self, name: &str) -> ExprId {
        let symbol = self.symbols.push((name.to_owned(), Dependence::Parameters));
        self.intern(Node::Symbol(symbol))
    }

    /// Number of nodes ever made.
    #[must_use]
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// No node yet?
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// The node behind an id.
    #[must_use]
    pub fn node(&self, id: ExprId) -> Node {
        self.nodes[id]
    }

    /// What its value may change with.
    #[must_use]
    pub fn dependence(&self, id: ExprId) -> Dependence {
        self.facts[id].dependence
    }

    /// Name of a symbol.
    #[must_use]
    pub fn symbol_name(&self, symbol: SymbolId) -> &str {
        &self.symbols[symbol].0
    }

    /// The symbol that `id` is, if it is one.
    #[must_use]
    pub fn as_symbol(&self, id: ExprId) -> Option<SymbolId> {
        match self.nodes[id] {
            Node::Symbol(symbol) => Some(symbol),
            _ => None,
        }
    }

    /// The constant that `id` is, if it is one.
    #[must_use]
    pub fn as_number(&self, id: ExprId) -> Option<Number> {
        match self.nodes[id] {
            Node::Number(number) => Some(number),
            Node::Pi => Some(Number::from_f64(std::f64::consts::PI)),
            _ => None,
        }
    }

    /// Is it the constant 0?
    #[must_use]
    pub fn is_zero(&self, id: ExprId) -> bool {
        Some(id) == self.zero
    }

    /// Is it the constant 1?
    #[must_use]
    pub fn is_one(&self, id: ExprId) -> bool {
        Some(id) == self.one
    }

    /// Does the node depend on one of the symbols with these bits? Perhaps not even if the answer is yes.
    fn may_read(&self, id: ExprId, bits: u64) -> bool {
        self.facts[id].symbols_read & bits != 0
    }

    /// A constant.
    pub fn number(&mut self, number: Number) -> ExprId {
        let id = self.intern(Node::Number(number));
        match number {
            Number::ZERO => self.zero = Some(id),
            Number::ONE => self.one = Some(id),
            _ => {}
        }
        id
    }

    /// An f64 constant.
    pub fn constant(&mut self, x: f64) -> ExprId {
        self.number(Number::from_f64(x))
    }

    /// 0.
    pub fn zero(&mut self) -> ExprId {
        self.zero.unwrap_or_else(|| self.number(Number::ZERO))
    }

    /// 1.
    pub fn one(&mut self) -> ExprId {
        self.one.unwrap_or_else(|| self.number(Number::ONE))
    }

    /// Pi.
    pub fn pi(&mut self) -> ExprId {
        self.intern(Node::Pi)
    }

    /// -a.
    pub fn negate(&mut self, a: ExprId) -> ExprId {
        match simplify::negate(self, a) {
            Some(simpler) => simpler,
            None => self.intern(Node::Negate(a)),
        }
    }

    /// A function of one argument.
    pub fn unary(&mut self, function: Unary, a: ExprId) -> ExprId {
        // A node that is there has no shorter form: else it would not have been made.
        if let Some(known) = self.find(Node::Unary(function, a)) {
            return known;
        }
        match simplify::unary(self, function, a) {
            Some(simpler) => simpler,
            None => self.intern(Node::Unary(function, a)),
        }
    }

    /// An operator of two arguments.
    pub fn binary(&mut self, operator: Binary, a: ExprId, b: ExprId) -> ExprId {
        let commutes = matches!(operator, Binary::Add | Binary::Mul);
        let (a, b) = if commutes && b < a { (b, a) } else { (a, b) };
        if let Some(known) = self.results.find(operator, [a, b]) {
            return known;
        }
        let result = match simplify::binary(self, operator, a, b) {
            Some(simpler) => simpler,
            None => self.intern(Node::Binary(operator, a, b)),
        };
        self.results.insert(operator, [a, b], result);
        result
    }

    /// a + b.
    pub fn add(&mut self, a: ExprId, b: ExprId) -> ExprId {
        self.binary(Binary::Add, a, b)
    }

    /// a - b.
    pub fn sub(&mut self, a: ExprId, b: ExprId) -> ExprId {
        self.binary(Binary::Sub, a, b)
    }

    /// a b.
    pub fn mul(&mut self, a: ExprId, b: ExprId) -> ExprId {
        self.binary(Binary::Mul, a, b)
    }

    /// a / b.
    pub fn div(&mut self, a: ExprId, b: ExprId) -> ExprId {
        self.binary(Binary::Div, a, b)
    }

    /// sin a.
    pub fn sin(&mut self, a: ExprId) -> ExprId {
        self.unary(Unary::Sin, a)
    }

    /// cos a.
    pub fn cos(&mut self, a: ExprId) -> ExprId {
        self.unary(Unary::Cos, a)
    }

    /// Square root of a.
    pub fn sqrt(&mut self, a: ExprId) -> ExprId {
        self.unary(Unary::Sqrt, a)
    }

    /// Integer power by repeated squaring; negative exponents divide.
    pub fn powi(&mut self, a: ExprId, exponent: i32) -> ExprId {
        let mut result = self.one();
        let (mut base, mut left) = (a, exponent.unsigned_abs());
        while left > 0 {
            if left & 1 == 1 {
                result = self.mul(result, base);
            }
            left >>= 1;
            if left > 0 {
                base = self.mul(base, base);
            }
        }
        if exponent < 0 {
            let one = self.one();
            return self.div(one, result);
        }
        result
    }

    /// Sum of many, in order.
    pub fn sum(&mut self, terms: &[ExprId]) -> ExprId {
        let zero = self.zero();
        terms.iter().fold(zero, |total, &term| self.add(total, term))
    }

    /// (c, x) with the expression = c x for a number c; x is 1 for a number.
    pub fn split_coefficient(&mut self, expr: ExprId) -> (Number, ExprId) {
        match self.nodes[expr] {
            Node::Number(c) => (c, self.one()),
            Node::Negate(a) => {
                let (c, x) = self.split_coefficient(a);
                (c.negate(), x)
            }
            Node::Binary(Binary::Mul, c, x) => match self.nodes[c] {
                Node::Number(number) => (number, x),
                _ => (Number::ONE, expr),
            },
            _ => (Number::ONE, expr),
        }
    }

    /// a of -a, else the expression itself.
    #[must_use]
    pub fn unsigned(&self, expr: ExprId) -> ExprId {
        if let Node::Negate(a) = self.nodes[expr] { a } else { expr }
    }

    /// Operands of a node.
    #[must_use]
    pub fn operands(&self, id: ExprId) -> [Option<ExprId>; 2] {
        match self.nodes[id] {
            Node::Number(_) | Node::Pi | Node::Symbol(_) => [None, None],
            Node::Negate(a) | Node::Unary(_, a) => [Some(a), None],
            Node::Binary(_, a, b) => [Some(a), Some(b)],
        }
    }

    /// a and b, if sine and cosine of the node, no constant, are to be those of a - b unrounded:
    /// `Real::sin_cos_of_difference`.
    #[must_use]
    pub fn as_difference(&self, angle: ExprId) -> Option<[ExprId; 2]> {
        match self.nodes[angle] {
            Node::Binary(Binary::Sub, a, b) if self.unrounded_differences && !self.is_constant(angle) => {
                Some([a, b])
            }
            _ => None,
        }
    }

    /// All nodes that the roots need, in ascending (hence topological) order.
    #[must_use]
    pub fn reachable(&self, roots: &[ExprId]) -> Vec<ExprId> {
        self.reachable_above(roots, |_| false)
    }

    /// The same without what is below the nodes that `is_leaf` names.
    #[must_use]
    pub fn reachable_above(&self, roots: &[ExprId], is_leaf: impl Fn(ExprId) -> bool) -> Vec<ExprId> {
        self.cone_above(roots, is_leaf).to_vec()
    }

    /// All nodes that the roots need, as a set.
    pub(crate) fn cone(&self, roots: &[ExprId]) -> NodeSet {
        self.cone_above(roots, |_| false)
    }

    /// The same without what is below the nodes that `is_leaf` names; it is asked once about every node.
    pub(crate) fn cone_above(&self, roots: &[ExprId], mut is_leaf: impl FnMut(ExprId) -> bool) -> NodeSet {
        let bound = roots.iter().map(|root| root.index() + 1).max().unwrap_or(0);
        let mut needed = NodeSet::below(bound);
        roots.iter().for_each(|&root| needed.insert(root));
        // Operands are always older than their node: one sweep downwards marks everything.
        needed.sweep_down(|id| {
            if is_leaf(id) { [None, None] } else { self.operands(id) }.into_iter().flatten()
        });
        needed
    }
}

/// The bit that stands for a symbol, among others.
fn symbol_bit(symbol: SymbolId) -> u64 {
    1 << (symbol.index() % 64)
}
