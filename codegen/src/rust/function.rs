//! Functions of the emitted file: one an answer, and the one that prepares what depends on parameters alone.

use super::answer::{Answer, Cost};
use super::layout::{self, PLAIN_STRUCT, STRAIGHT_LINE};
use super::options::EmitOptions;
use super::prepared::Prepared;
use super::statement::{Body, Parameters};
use crate::program::Program;
use crate::words::count;

/// The struct `Prepared` and the function that computes it; `names` are those of the fields of `Parameters`.
pub(super) fn prepare(
    program: &Program,
    names: &[String],
    prepared: &Prepared,
    cost: &Cost,
    options: &EmitOptions,
) -> String {
    let fields = prepared.fields.iter().map(|(id, field)| match program.dag.as_symbol(*id) {
        Some(_) => format!("///The parameter `{field}`.\n    pub {field}: S"),
        None => format!("///Of parameters alone.\n    pub {field}: S"),
    });
    let body = Body::new(program, &prepared.roots(), options, Parameters::Given(names));
    let values: Vec<String> = (prepared.fields.iter().zip(&body.results))
        .map(|((_, field), value)| match field == value {
            true => field.clone(),
            false => format!("{field}: {value}"),
        })
        .collect();
    let operations: usize = cost.values().sum();
    format!(
        "/// What the functions below need of the parameters, from [`prepare`].\n{PLAIN_STRUCT}{}\
         /// Computes what depends on parameters alone: once, and again when one of them changes.\n\
         ///\n///{operations} operations.\n{STRAIGHT_LINE}{}{}    Prepared {{ {} }}\n}}\n",
        layout::block("pub struct Prepared", fields, ""),
        layout::signature("pub fn prepare", &body.arguments(), "Prepared", ""),
        body.statements,
        values.join(", ")
    )
}

/// One answer as a function.
pub(super) fn answer(
    program: &Program,
    answer: Answer,
    cost: &Cost,
    prepared: &Prepared,
    options: &EmitOptions,
) -> String {
    let roots = answer.roots(program);
    let n = roots.len();
    let (nq, nu, corrections) = (program.q.len(), program.u.len(), n.wrapping_sub(1));
    let output = match answer {
        Answer::Rates => format!("([S; {nq}usize], [S; {nu}usize], S)"),
        Answer::Energy => "(S, S)".to_owned(),
        Answer::Speeds | Answer::Outputs => format!("[S; {n}usize]"),
        Answer::Projection => format!("([S; {corrections}usize], S)"),
        Answer::Drive => "S".to_owned(),
        Answer::Augmented => {
            let lengths = augmented_lengths(program).map(|n| format!("[S; {n}usize]"));
            format!("({})", lengths.join(", "))
        }
    };
    let body = Body::new(program, &roots, options, Parameters::Prepared(prepared));
    let operations = count(cost.values().sum::<usize>(), "operation");
    let signature = layout::signature(&format!("pub fn {}", answer.name()), &body.arguments(), &output, "");
    format!(
        "///{}\n///\n///{operations}.\n{STRAIGHT_LINE}{signature}{}    {}\n}}\n",
        answer.doc(),
        body.statements,
        result(program, answer, &body.results)
    )
}

/// The result expression of an answer's function.
fn result(program: &Program, answer: Answer, results: &[String]) -> String {
    let list = |items: &[String]| format!("[{}]", items.join(", "));
    match answer {
        Answer::Rates => {
            let (q_dot, rest) = results.split_at(program.q.len());
            let (u_dot, pivot) = rest.split_at(program.u.len());
            format!("({}, {}, {})", list(q_dot), list(u_dot), pivot.concat())
        }
        Answer::Energy => format!("({})", results.join(", ")),
        Answer::Speeds | Answer::Outputs => list(results),
        Answer::Projection => {
            let (corrections, residual) = results.split_at(results.len() - 1);
            format!("({}, {})", list(corrections), residual.concat())
        }
        Answer::Drive => results.concat(),
        Answer::Augmented => {
            let mut rest = results;
            let parts = augmented_lengths(program).map(|n| {
                let (part, after) = rest.split_at(n);
                rest = after;
                list(part)
            });
            format!("({})", parts.join(", "))
        }
    }
}

fn augmented_lengths(program: &Program) -> [usize; 4] {
    let parts = &program.augmented;
    [parts.mass.len(), parts.jacobian.len(), parts.forcing.len(), parts.bias.len()]
}
