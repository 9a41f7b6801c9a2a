//! The text of an expression, with the parentheses that keep the order of its operations.

use super::Body;
use crate::expr::print::{binary_name, infix, unary_name};
use crate::expr::{Binary, ExprId, Node};
use crate::id::Id;

impl Body<'_> {
    /// The name given to a node.
    pub(super) fn ident(&self, id: ExprId) -> Option<&str> {
        let place = self.named[id.index()].checked_sub(1)?;
        Some(self.idents.at(place as usize))
    }

    /// Has the node got a name?
    pub(super) fn has_ident(&self, id: ExprId) -> bool {
        self.named[id.index()] > 0
    }

    /// The text of a node as an operand: its name, or its expression.
    pub(super) fn operand(&self, id: ExprId) -> String {
        let mut text = String::new();
        self.write_operand(&mut text, id);
        text
    }

    pub(super) fn write_operand(&self, text: &mut String, id: ExprId) {
        match self.ident(id) {
            Some(ident) => text.push_str(ident),
            None => self.write_expression(text, id),
        }
    }

    pub(super) fn write_expression(&self, text: &mut String, id: ExprId) {
        let dag = self.dag();
        if dag.is_constant(id) {
            text.push_str(&self.options.scalar.literal(dag.evaluate_constant(id)));
            return;
        }
        match dag.node(id) {
            Node::Number(_) | Node::Pi | Node::Symbol(_) => text.push_str(self.ident(id).unwrap_or_default()),
            Node::Negate(a) => {
                text.push('-');
                self.write_wrapped(text, a, is_sum);
            }
            Node::Unary(function, a) => {
                for part in ["Real::", unary_name(function), "("] {
                    text.push_str(part);
                }
                self.write_argument(text, a);
                text.push(')');
            }
            Node::Binary(operator, a, b) => self.write_binary(text, operator, a, b),
        }
    }

    /// Writes a binary operation with parentheses that keep the DAG's order of operations: a + (b + c) is not (a + b) +
    /// c.
    fn write_binary(&self, text: &mut String, operator: Binary, a: ExprId, b: ExprId) {
        let sum_or_negation = |n: Node| is_sum(n) || matches!(n, Node::Negate(_));
        let any = |n: Node| sum_or_negation(n) || matches!(n, Node::Binary(Binary::Mul | Binary::Div, ..));
        let symbol = infix(operator).unwrap_or_default();
        match operator {
            Binary::Add | Binary::Sub => {
                self.write_operand(text, a);
                text.push_str(symbol);
                self.write_wrapped(text, b, sum_or_negation);
            }
            Binary::Mul | Binary::Div => {
                self.write_wrapped(text, a, is_sum);
                text.push_str(symbol);
                self.write_wrapped(text, b, any);
            }
            Binary::Atan2 | Binary::Min | Binary::Max => {
                let is_size = |id| operator != Binary::Atan2 && self.dag().is_never_negative(id);
                let of_sizes = if is_size(a) && is_size(b) { "_size" } else { "" };
                for part in ["Real::", binary_name(operator), of_sizes, "("] {
                    text.push_str(part);
                }
                self.write_argument(text, a);
                text.push_str(", ");
                self.write_argument(text, b);
                text.push(')');
            }
        }
    }

    /// Writes what stands alone between parentheses, commas or behind `=`: a negative constant needs no parentheses.
    pub(super) fn write_argument(&self, text: &mut String, id: ExprId) {
        let start = text.len();
        self.write_operand(text, id);
        if self.dag().is_constant(id) && text[start..].starts_with('(') {
            text.pop();
            text.remove(start);
        }
    }

    /// Writes an operand, in parentheses if it has no name and its node satisfies `needs`.
    fn write_wrapped(&self, text: &mut String, id: ExprId, needs: impl Fn(Node) -> bool) {
        let inline = !self.has_ident(id) && !self.dag().is_constant(id);
        if inline && needs(self.dag().node(id)) {
            text.push('(');
            self.write_operand(text, id);
            text.push(')');
        } else {
            self.write_operand(text, id);
        }
    }
}

fn is_sum(node: Node) -> bool {
    matches!(node, Node::Binary(Binary::Add | Binary::Sub, ..))
}
