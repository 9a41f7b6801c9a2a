//! The comment that an emitted file opens with: provenance and cost.

use super::prepared::Prepared;
use super::{Answer, EmitOptions, ScalarType};
use crate::expr::Dependence;
use crate::program::Program;
use std::collections::BTreeMap;
use std::fmt::Write;

/// The header lines.
#[must_use]
pub(super) fn text(
    program: &Program,
    options: &EmitOptions,
    answers: &[Answer],
    prepared: &Prepared,
) -> String {
    let scalar = match &options.scalar {
        ScalarType::F32 => "f32",
        ScalarType::F64 => "f64",
        ScalarType::Path(path) => path,
    };
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
    for answer in answers {
        let kinds = program.dag.operations_by_kind(&answer.roots(program), Dependence::State);
        cost(&mut text, answer.name(), &kinds);
    }
    cost(&mut text, "prepare", &prepared.operations(program));
    text
}

fn cost(text: &mut String, name: &str, kinds: &BTreeMap<&str, usize>) {
    let total: usize = kinds.values().sum();
    let kinds: Vec<String> = kinds.iter().map(|(kind, n)| format!("{n} {kind}")).collect();
    let _ = writeln!(text, "// Cost of {name}: {total} operations ({}).", kinds.join(", "));
}
