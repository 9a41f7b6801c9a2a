//! The data of an answer: named parts, each a number, a list or a matrix of expressions.

use crate::expr::ExprId;

/// An answer: one function of the emitted file, or a field of what such a function returns.
#[derive(Clone, Debug)]
pub struct Answer {
    /// The request as it is written, such as `rates` or `pose:platform`.
    pub name: String,
    /// What it returns, in a sentence.
    pub doc: String,
    /// Its parts, in order.
    pub parts: Vec<Part>,
    /// Is it emitted as a tuple of its parts (or a bare part if there is only one)? Otherwise as a struct with a field
    /// per part.
    pub is_tuple: bool,
    /// Do the functions that return it take derivatives of the speeds as arguments?
    pub takes_u_dot: bool,
}

/// A part of an answer.
#[derive(Clone, Debug)]
pub struct Part {
    /// Its name.
    pub name: &'static str,
    /// What it is, with units or axes.
    pub doc: String,
    /// Number and arrangement of its values.
    pub shape: Shape,
    /// The values; those of a matrix row by row.
    pub values: Vec<ExprId>,
    /// Names of the entries of a list, or of the rows of a matrix; empty if they have none.
    pub labels: Vec<String>,
}

/// Number, list or matrix.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Shape {
    /// One number.
    Number,
    /// This many numbers.
    List(usize),
    /// Rows and columns.
    Matrix(usize, usize),
}

impl Answer {
    /// All numbers, part by part.
    #[must_use]
    pub fn roots(&self) -> Vec<ExprId> {
        self.parts.iter().flat_map(|part| part.values.iter().copied()).collect()
    }
}

impl Part {
    /// One number.
    pub fn number(name: &'static str, doc: &str, value: ExprId) -> Self {
        Self { name, doc: doc.to_owned(), shape: Shape::Number, values: vec![value], labels: Vec::new() }
    }

    /// A list; `labels` name its entries.
    pub fn list(name: &'static str, doc: &str, labels: Vec<String>, values: Vec<ExprId>) -> Self {
        Self { name, doc: doc.to_owned(), shape: Shape::List(values.len()), values, labels }
    }

    /// A matrix with this number of columns.
    pub fn matrix(
        name: &'static str,
        doc: &str,
        labels: Vec<String>,
        columns: usize,
        rows: &[Vec<ExprId>],
    ) -> Self {
        let shape = Shape::Matrix(rows.len(), columns);
        Self { name, doc: doc.to_owned(), shape, values: rows.concat(), labels }
    }
}
