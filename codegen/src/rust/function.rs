//! Emits functions: one per answer or group of answers, and the one that computes the prepared values.

use super::answer::{Cost, Emitted};
use super::layout::{self, PLAIN_STRUCT, STRAIGHT_LINE};
use super::options::EmitOptions;
use super::prepared::Prepared;
use super::sines::Sines;
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
        Some(_) => format!("/// The parameter `{field}`.\n    pub {field}: S"),
        None => format!("/// Of parameters alone.\n    pub {field}: S"),
    });
    let body = Body::new(program, &prepared.roots(), options, (Parameters::Given(names), Sines::Own));
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
         ///\n/// {operations} operations.\n{STRAIGHT_LINE}{}{}    Prepared {{ {} }}\n}}\n",
        layout::block("pub struct Prepared", fields, ""),
        layout::signature("pub fn prepare", &body.arguments(), "Prepared", ""),
        body.statements,
        values.join(", ")
    )
}

/// Emits one answer, or several together, as a function.
pub(super) fn answer(
    program: &Program,
    (function, sines): (&Emitted, Sines),
    cost: &Cost,
    prepared: &Prepared,
    options: &EmitOptions,
) -> String {
    let parameters = Parameters::Prepared { prepared, takes_u_dot: function.takes_u_dot() };
    let body = Body::new(program, &function.roots(), options, (parameters, sines));
    let operations = count(cost.values().sum::<usize>(), "operation");
    let head = format!("pub fn {}", function.name);
    let signature = layout::signature(&head, &body.arguments(), &function.output(), "");
    format!(
        "/// {}\n///\n{}/// {operations}.\n{STRAIGHT_LINE}{signature}{}    {}\n}}\n",
        function.doc,
        arguments(function.takes_u_dot(), sines),
        body.statements,
        function.result(&body.results, body.handed_on())
    )
}

/// The documentation of the arguments.
fn arguments(takes_u_dot: bool, sines: Sines) -> String {
    let mut text = "\
/// - `t`: time (s)
/// - `q`, `u`, `inputs`: coordinates, speeds and inputs (SI), at the places of the modules of these names
"
    .to_owned();
    if takes_u_dot {
        text += "/// - `u_dot`: derivatives of the speeds, at their places\n";
    }
    text += "/// - `p`: what [`prepare`] makes of the parameters\n";
    if matches!(sines, Sines::Near(_)) {
        text += "/// - `near`: what [`begin_step`] hands on\n";
    }
    text + "///\n"
}
