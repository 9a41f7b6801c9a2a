//! Jumps: states at which the argument of a `sign` is 0, so that the equations have no slopes there.
//!
//! In: a model. Out: the model with one more output for the argument of each `sign` that its loads read, directly or
//! through definitions and laws; and, at a state, a warning for each of them that is 0 up to its rounding.

use super::balance::BOUNDS;
use super::search::Search;
use crate::jumps::{self, Jump};
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::{Model, Output};

/// A `sign` in a load, and the index of its argument among the outputs.
pub(super) struct Watched {
    jump: Jump,
    output: usize,
}

/// The model that shows the arguments as its last outputs.
pub(super) fn watched(model: &Model) -> (Model, Vec<Watched>) {
    let mut watched = model.clone();
    let mut all = Vec::new();
    for jump in jumps::of_loads(model) {
        let name = format!("argument of sign {}", all.len() + 1);
        let output = watched.outputs.len();
        let value = jump.argument.clone();
        watched.outputs.push(Output { name, value, unit: "1".to_owned(), span: jump.span });
        all.push(Watched { jump, output });
    }
    (watched, all)
}

/// Warnings of the jumps at the state of the search.
pub(super) fn warnings(model: &Model, jumps: &[Watched], search: &mut Search<'_>) -> Diagnostics {
    let mut warnings = Diagnostics::new(model.source.clone());
    let outputs = search.rounded_outputs();
    for Watched { jump, output } in jumps {
        let is_zero = |x: &(f64, f64)| x.0.abs() <= BOUNDS * x.1;
        if outputs.get(*output).is_some_and(is_zero) {
            let message = format!(
                "`{}` jumps at this state: the linearisation and its modes leave the jump out",
                jump.owner
            );
            let help = "its slope counts as 0, so that dry friction damps nothing and holds nothing; to include it write \
                        tanh(u/w) with a width w for sign(u)";
            warnings.push(Diagnostic::warning(message).label(jump.span, "sign of 0").help(help));
        }
    }
    warnings
}
