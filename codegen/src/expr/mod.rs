//! The expression DAG: hash-consed, simplified as it is built, never expanded to a tree.
//!
//! Every constructor first asks `simplify` for a shorter equal node, then looks the node up: equal expressions have
//! equal ids, so common sub-expressions exist once. Sums and products order their operands by id; negation moves
//! outwards (it is free at run time).
//! Semantics: real arithmetic; parameters and states are assumed finite.

pub mod cost;
mod dag;
pub mod differentiate;
pub mod evaluate;
mod intern;
mod jacobian;
mod label;
mod node;
pub mod number;
pub mod print;
pub mod rounding;
mod set;
mod sign;
mod simplify;
pub mod substitute;
pub mod tape;

pub use dag::Dag;
pub use label::Label;
pub use node::{Binary, Dependence, ExprId, Node, SymbolId, Unary};
use number::Number;
pub(crate) use set::NodeSet;

impl Dag {
    /// -a.
    pub fn negate(&mut self, a: ExprId) -> ExprId {
        match simplify::negate(self, a) {
            Some(simpler) => simpler,
            None => self.intern(Node::Negate(a)),
        }
    }

    /// A function of one argument.
    pub fn unary(&mut self, function: Unary, a: ExprId) -> ExprId {
        // A node that exists already has no shorter form, or it would not have been created.
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
    #[inline]
    pub fn add(&mut self, a: ExprId, b: ExprId) -> ExprId {
        // Half of all sums and products have a 0 among their operands: components along an axis.
        if self.is_zero(a) {
            return b;
        }
        if self.is_zero(b) {
            return a;
        }
        self.binary(Binary::Add, a, b)
    }

    /// a - b.
    pub fn sub(&mut self, a: ExprId, b: ExprId) -> ExprId {
        self.binary(Binary::Sub, a, b)
    }

    /// a b.
    #[inline]
    pub fn mul(&mut self, a: ExprId, b: ExprId) -> ExprId {
        if self.is_zero(a) {
            return a;
        }
        if self.is_zero(b) {
            return b;
        }
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

    /// Splits c x into (c, x) with c a number; x is 1 if the expression is a number, c is 1 or -1 if it has no numeric
    /// factor.
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
}
