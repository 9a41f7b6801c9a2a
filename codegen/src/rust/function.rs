//! Emits functions: one per answer or group of answers, and the one that computes the prepared values.

use super::answer::{Cost, Emitted};
use super::layout::{self, PLAIN_STRUCT, STRAIGHT_LINE, UNREAD};
use super::name::RATES;
use super::options::{EmitOptions, ScalarType};
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
    let body = Body::new(program, (&prepared.roots(), None), options, (Parameters::Given(names), Sines::Own));
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

/// Emits one answer, or several together, as a function; rates as two, of which one writes them to memory.
pub(super) fn answer(
    program: &Program,
    (function, sines): (&Emitted, Sines),
    cost: &Cost,
    prepared: &Prepared,
    options: &EmitOptions,
) -> String {
    let parameters = Parameters::Prepared { prepared, takes_u_dot: function.takes_u_dot() };
    let (roots, places) = (function.roots(), function.places());
    let body = Body::new(program, (&roots, places.as_deref()), options, (parameters, sines));
    let operations = count(cost.values().sum::<usize>(), "operation");
    let (name, output, result) = match &function.into {
        Some(into) => (into, "S".to_owned(), body.results.concat()),
        None => (&function.name, function.output(), function.result(&body.results, body.handed_on())),
    };
    let signature = layout::signature(&format!("pub fn {name}"), &body.arguments(), &output, "");
    let frame = if matches!(options.scalar, ScalarType::Path(_)) { ALIGN_FRAME } else { "" };
    let text = format!(
        "/// {}\n///\n{}/// {operations}.\n{STRAIGHT_LINE}{signature}{frame}{}    {result}\n}}\n",
        function.doc,
        arguments(function, sines),
        body.statements,
    );
    match &function.into {
        Some(into) => text + &returning(function, into, &body.arguments()),
        None => text,
    }
}

/// Lanes that find no register are stored in the frame.
const ALIGN_FRAME: &str = "    <S as Real>::align_frame();\n";

/// The function that returns the rates, from that which writes them to memory and has these arguments.
fn returning(function: &Emitted, into: &str, arguments: &[String]) -> String {
    let given = &arguments[..arguments.len() - RATES.len()];
    let given: Vec<String> = given.iter().map(|a| a.trim_start_matches('_').to_owned()).collect();
    let signature = layout::signature(&format!("pub fn {}", function.name), &given, &function.output(), "");
    let zeros = RATES.iter().zip(["NQ", "NU"]);
    let zeros: String =
        zeros.map(|(name, n)| format!("    let mut {name} = [<S as Real>::ZERO; {n}];\n")).collect();
    let passed: Vec<&str> = given.iter().filter_map(|a| a.split(':').next()).collect();
    let [q_dot, u_dot] = RATES;
    format!(
        "/// {}\n///\n/// As [`{into}`], which writes them to memory.\n{UNREAD}#[must_use]\n#[inline]\n{signature}{zeros}    \
         let worst_pivot = {into}({}, &mut {q_dot}, &mut {u_dot});\n    ({q_dot}, {u_dot}, worst_pivot)\n}}\n",
        function.doc,
        passed.join(", "),
    )
}

/// The documentation of the arguments.
fn arguments(function: &Emitted, sines: Sines) -> String {
    let mut text = "\
/// - `t`: time (s)
/// - `q`, `u`, `inputs`: coordinates, speeds and inputs (SI), at the places of the modules of these names
"
    .to_owned();
    if function.takes_u_dot() {
        text += "/// - `u_dot`: derivatives of the speeds, at their places\n";
    }
    text += "/// - `p`: what [`prepare`] makes of the parameters\n";
    if matches!(sines, Sines::Near(_)) {
        text += "/// - `near`: what [`begin_step`] hands on\n";
    }
    if function.into.is_some() {
        text += "/// - `q_dot`, `u_dot`: where the rates are written\n///\n/// Returns the worst pivot.\n";
    }
    text + "///\n"
}
