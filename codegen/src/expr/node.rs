//! Nodes of the DAG: operators with their operands.

use super::number::Number;
use crate::id::{Id, ids};

ids! {
    /// A node of the graph of expressions ([`super::Dag`]).
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

/// What the value of a node can change with.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Dependence {
    /// Free of symbols.
    Constant,
    /// Parameters only: needed once, until a parameter changes.
    Parameters,
    /// Time, coordinates, speeds or inputs.
    State,
}

/// Stands for "no operation": the first node has no operands, so it cannot be one.
pub(super) const NO_OPERATION: ExprId = ExprId(0);

/// The bit of a symbol in a 64-bit set; symbols with equal index modulo 64 share one.
pub(super) fn symbol_bit(symbol: SymbolId) -> u64 {
    1 << (symbol.index() % 64)
}
