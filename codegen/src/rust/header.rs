//! The comment that an emitted file opens with: provenance and cost.

use super::answer::Cost;
use super::options::EmitOptions;
use crate::escape;
use crate::program::Program;
use crate::words::count;
use std::fmt::Write;

/// The header lines.
#[must_use]
pub(super) fn text<'a>(
    program: &Program,
    options: &'a EmitOptions,
    functions: impl Iterator<Item = (&'a str, &'a Cost)>,
    prepare: &Cost,
) -> String {
    let scalar = options.scalar.path();
    let mut text = format!(
        "// Generated from {} by smartbed-codegen {}; do not edit, change the model instead.\n",
        escape::line(&program.path),
        env!("CARGO_PKG_VERSION")
    );
    let _ = writeln!(
        text,
        "// {}: {}, {}, {}, {}; scalar {scalar}.",
        escape::line(&program.name),
        count(program.q.len(), "coordinate"),
        count(program.u.len(), if program.is_redundant() { "speed" } else { "independent speed" }),
        count(program.inputs.len(), "input"),
        count(program.parameters.len(), "tunable parameter")
    );
    if let Some(worst) = program.pivots.iter().min_by(|a, b| a.worst.total_cmp(&b.worst)) {
        let _ = writeln!(
            text,
            "// Pivots: {}; the worst over {} is {:.3} of its nominal size.",
            program.pivots.len(),
            count(program.n_samples, "sampled configuration"),
            worst.worst
        );
    }
    for (name, kinds) in functions {
        cost(&mut text, name, kinds);
    }
    cost(&mut text, "prepare", prepare);
    text
}

fn cost(text: &mut String, name: &str, kinds: &Cost) {
    let total: usize = kinds.values().sum();
    let kinds: Vec<String> = kinds.iter().map(|(kind, n)| format!("{n} {kind}")).collect();
    let _ = writeln!(text, "// Cost of {name}: {} ({}).", count(total, "operation"), kinds.join(", "));
}
