//! Signs that follow from the form of an expression alone.

use super::dag::Dag;
use super::node::{Binary, ExprId, Node, Unary};

impl Dag {
    /// Is the value certainly >= 0, whatever its symbols are? False if the form does not tell.
    pub(crate) fn is_never_negative(&self, id: ExprId) -> bool {
        let is = |id| self.is_never_negative(id);
        match self.node(id) {
            Node::Number(number) => !number.is_negative(),
            Node::Pi | Node::Unary(Unary::Abs | Unary::Sqrt | Unary::Exp, _) => true,
            Node::Binary(Binary::Mul, a, b) => a == b || (is(a) && is(b)),
            Node::Binary(Binary::Add | Binary::Div | Binary::Min, a, b) => is(a) && is(b),
            Node::Binary(Binary::Max, a, b) => is(a) || is(b),
            _ => false,
        }
    }
}
