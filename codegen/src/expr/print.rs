//! Expressions as text in a stable form: for snapshots, tests and messages.

use super::{Binary, Dag, ExprId, Node, Unary};
use crate::expr::number::Number;

impl Dag {
    /// The expression as text, fully parenthesised, at most `limit` characters.
    #[must_use]
    pub fn print(&self, expr: ExprId, limit: usize) -> String {
        let mut text = String::new();
        self.write(expr, limit, &mut text);
        if text.len() > limit {
            text.truncate(limit);
            text.push_str("...");
        }
        text
    }

    fn write(&self, expr: ExprId, limit: usize, text: &mut String) {
        if text.len() > limit {
            return;
        }
        match self.node(expr) {
            Node::Number(number) => text.push_str(&print_number(number)),
            Node::Pi => text.push_str("pi"),
            Node::Symbol(symbol) => text.push_str(self.symbol_name(symbol)),
            Node::Negate(a) => {
                text.push('-');
                self.write(a, limit, text);
            }
            Node::Unary(function, a) => self.write_call(unary_name(function), &[a], limit, text),
            Node::Binary(operator, a, b) => match infix(operator) {
                Some(symbol) => {
                    text.push('(');
                    self.write(a, limit, text);
                    text.push_str(symbol);
                    self.write(b, limit, text);
                    text.push(')');
                }
                None => self.write_call(binary_name(operator), &[a, b], limit, text),
            },
        }
    }

    fn write_call(&self, name: &str, arguments: &[ExprId], limit: usize, text: &mut String) {
        text.push_str(name);
        text.push('(');
        for (k, &argument) in arguments.iter().enumerate() {
            if k > 0 {
                text.push_str(", ");
            }
            self.write(argument, limit, text);
        }
        text.push(')');
    }
}

fn print_number(number: Number) -> String {
    match number {
        Number::Exact { numerator, denominator, root } => {
            let root = if root == 1 { String::new() } else { format!(" sqrt({root})") };
            let over = if denominator == 1 { String::new() } else { format!("/{denominator}") };
            format!("{numerator}{over}{root}")
        }
        Number::Float(bits) => format!("{:?}", f64::from_bits(bits)),
    }
}

/// Name of a function, as in Rust.
#[must_use]
pub fn unary_name(function: Unary) -> &'static str {
    match function {
        Unary::Sqrt => "sqrt",
        Unary::Sin => "sin",
        Unary::Cos => "cos",
        Unary::Tan => "tan",
        Unary::Asin => "asin",
        Unary::Acos => "acos",
        Unary::Exp => "exp",
        Unary::Ln => "ln",
        Unary::Tanh => "tanh",
        Unary::Abs => "abs",
        Unary::Sign => "sign",
    }
}

/// Name of an operator, as in Rust's method or operator trait.
#[must_use]
pub fn binary_name(operator: Binary) -> &'static str {
    match operator {
        Binary::Add => "add",
        Binary::Sub => "sub",
        Binary::Mul => "mul",
        Binary::Div => "div",
        Binary::Atan2 => "atan2",
        Binary::Min => "min",
        Binary::Max => "max",
    }
}

/// The operator between its operands, with spaces.
#[must_use]
pub fn infix(operator: Binary) -> Option<&'static str> {
    match operator {
        Binary::Add => Some(" + "),
        Binary::Sub => Some(" - "),
        Binary::Mul => Some(" * "),
        Binary::Div => Some(" / "),
        _ => None,
    }
}
