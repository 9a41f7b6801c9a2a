//! Jumps: states at which the argument of a `sign` is 0, so that the equations have no slopes there.
//!
//! In: a model. Out: the model with one more output for the argument of each `sign` that its loads read, directly or
//! through definitions and laws; and, at a state, a warning for each of them that is 0 up to its rounding.

use super::balance::BOUNDS;
use super::search::Search;
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::expression::{Expr, ExprKind, Function};
use smartbed_codegen::model::{Model, Output};
use smartbed_codegen::source::Span;

/// A `sign` in a load.
pub(super) struct Jump {
    load: String,
    span: Span,
    /// Index of its argument among the outputs.
    output: usize,
}

/// The model that shows the arguments as its last outputs.
pub(super) fn watched(model: &Model) -> (Model, Vec<Jump>) {
    let mut watched = model.clone();
    let mut jumps = Vec::new();
    for load in &model.loads {
        let mut found = Vec::new();
        load.kind.expressions().into_iter().for_each(|(_, e)| signs(model, e, &mut found));
        for (span, argument) in found {
            jumps.push(Jump { load: load.name.clone(), span, output: watched.outputs.len() });
            let name = format!("argument of sign {}", jumps.len());
            watched.outputs.push(Output { name, value: argument, unit: "1".to_owned(), span });
        }
    }
    (watched, jumps)
}

/// The places and arguments of `sign` in an expression and in the definitions that it reads.
fn signs(model: &Model, expression: &Expr, found: &mut Vec<(Span, Expr)>) {
    expression.visit(&mut |e| match &e.kind {
        ExprKind::Call(Function::Sign, arguments) if found.iter().all(|(span, _)| *span != e.span) => {
            found.extend(arguments.iter().map(|argument| (e.span, argument.clone())));
        }
        ExprKind::Definition(id) => signs(model, &model.definitions[*id].value, found),
        _ => {}
    });
}

/// Warnings of the jumps at the state of the search.
pub(super) fn warnings(model: &Model, jumps: &[Jump], search: &mut Search<'_>) -> Diagnostics {
    let mut warnings = Diagnostics::new(model.source.clone());
    let outputs = search.rounded_outputs();
    for jump in jumps {
        let is_zero = |x: &(f64, f64)| x.0.abs() <= BOUNDS * x.1;
        if outputs.get(jump.output).is_some_and(is_zero) {
            let message = format!(
                "`{}` jumps at this state: the linearisation and its modes leave the jump out",
                jump.load
            );
            let help = "its slope counts as 0, so that dry friction damps nothing and holds nothing; to include it write \
                        tanh(u/w) with a width w for sign(u)";
            warnings.push(Diagnostic::warning(message).label(jump.span, "sign of 0").help(help));
        }
    }
    warnings
}
