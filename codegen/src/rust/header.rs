//! The comment that an emitted file opens with: provenance and cost.

use super::{Answer, Cost, EmitOptions, scalar_name};
use crate::program::Program;
use std::fmt::Write;

/// The header lines.
#[must_use]
pub(super) fn text<'a>(
    program: &Program,
    options: &'a EmitOptions,
    answers: impl Iterator<Item = (&'a Answer, &'a Cost)>,
    prepare: &Cost,
) -> String {
    let scalar = scalar_name(&options.scalar);
    let mut text = format!(
        "// Generated from {} by smartbed-codegen {}; do not edit, change the model instead.\n",
        program.path,
        env!("CARGO_PKG_VERSION")
    );
    let _ = writeln!(
        text,
        "// {}: {} coordinates, {} independent speeds, {} inputs, {} tunable parameters; scalar {scalar}.",
        program.name,
        program.q.len(),
        program.u.len(),
        program.inputs.len(),
        program.parameters.len()
    );
    if let Some(worst) = program.pivots.iter().min_by(|a, b| a.worst.total_cmp(&b.worst)) {
        let _ = writeln!(
            text,
            "// Pivots: {}; the worst over {} sampled configurations is {:.3} of its nominal size.",
            program.pivots.len(),
            program.n_samples,
            worst.worst
        );
    }
    for (answer, kinds) in answers {
        cost(&mut text, answer.name(), kinds);
    }
    cost(&mut text, "prepare", prepare);
    text
}

fn cost(text: &mut String, name: &str, kinds: &Cost) {
    let total: usize = kinds.values().sum();
    let kinds: Vec<String> = kinds.iter().map(|(kind, n)| format!("{n} {kind}")).collect();
    let _ = writeln!(text, "// Cost of {name}: {total} operations ({}).", kinds.join(", "));
}
