//! Program -> Rust: straight-line functions, one per answer, and the glue to the runtime's trait.
//!
//! In: a [`Program`]. Out: formatted source text, the same bytes for the same input. Knows names and
//! layout, no mechanics. Every node with more than one use is one `let`; sine and cosine of an
//! angle are one call, in f64 of two angles; constants are rounded once, from f64, to the file's scalar.

mod few;
mod glue;
mod header;
mod layout;
mod name;
mod pairs;
mod prepared;
mod schedule;
mod statement;

use crate::escape;
use crate::expr::{Dependence, ExprId};
use crate::program::{Program, Quantity};
use crate::words::count;
use prepared::Prepared;
use statement::{Body, Parameters};

/// The scalar of an emitted file.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub enum ScalarType {
    /// 32-bit floating point.
    F32,
    /// 64-bit floating point.
    #[default]
    F64,
    /// Any type that implements the runtime's `Real`, by its path: lanes, a counting scalar.
    Path(String),
}

/// What is emitted and how.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct EmitOptions {
    /// The scalar.
    pub scalar: ScalarType,
    /// Path of the runtime crate or of the module that carries its numbers.
    pub runtime: String,
    /// Only these answers, and no glue; all with glue if empty.
    pub answers: Vec<Answer>,
}

impl Default for EmitOptions {
    fn default() -> Self {
        Self { scalar: ScalarType::F64, runtime: "smartbed_runtime".to_owned(), answers: Vec::new() }
    }
}

/// A function of the emitted file.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Answer {
    /// q', u' and the worst pivot.
    Rates,
    /// Kinetic and potential energy.
    Energy,
    /// All speeds, dependent ones included.
    Speeds,
    /// Requested outputs.
    Outputs,
    /// Newton's correction of the dependent coordinates.
    Projection,
    /// Power of the drive; a program that is not driven has none.
    Drive,
    /// The equations before the elimination; emitted only on request.
    Augmented,
}

impl Answer {
    /// Answers that need no mass.
    pub const KINEMATIC: [Self; 3] = [Self::Speeds, Self::Outputs, Self::Projection];

    /// Every answer of a complete file, in its order; [`Answer::Augmented`] is a form of its own.
    pub const ALL: [Self; 6] =
        [Self::Rates, Self::Energy, Self::Speeds, Self::Outputs, Self::Projection, Self::Drive];

    /// Those of [`Answer::ALL`] that a program has.
    #[must_use]
    pub fn of(program: &Program) -> Vec<Self> {
        Self::ALL.into_iter().filter(|&answer| answer != Self::Drive || program.drive.is_some()).collect()
    }

    /// Name of the emitted function and of the answer on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Rates => "rates",
            Self::Energy => "energy",
            Self::Speeds => "speeds",
            Self::Outputs => "outputs",
            Self::Projection => "projection",
            Self::Drive => "drive",
            Self::Augmented => "augmented",
        }
    }

    /// The results of the answer in the emitted function's order.
    #[must_use]
    pub fn roots(self, program: &Program) -> Vec<ExprId> {
        let second = |list: &[(String, ExprId)]| list.iter().map(|(_, e)| *e).collect();
        match self {
            Self::Rates => {
                let mut roots = program.forward_dynamics();
                roots.push(program.rates.worst_pivot);
                roots
            }
            Self::Energy => program.energy.to_vec(),
            Self::Speeds => second(&program.speeds),
            Self::Outputs => second(&program.outputs),
            Self::Projection => {
                let mut roots: Vec<_> = program.correction.iter().map(|(_, e)| *e).collect();
                roots.push(program.residual);
                roots
            }
            Self::Drive => program.drive.into_iter().collect(),
            Self::Augmented => program.augmented_roots(),
        }
    }

    fn doc(self) -> &'static str {
        match self {
            Self::Rates => {
                "Rates of the coordinates, of the independent speeds, and the worst pivot relative to nominal."
            }
            Self::Energy => "Kinetic and potential energy (J).",
            Self::Speeds => "All speeds in the order of `SPEED_NAMES`, dependent ones included.",
            Self::Outputs => "Requested outputs in the order of `OUTPUT_NAMES`.",
            Self::Projection => {
                "Newton's corrections of the coordinates `CORRECTED`, and the largest residual before them."
            }
            Self::Drive => "Power that what drives the mechanism puts in (W).",
            Self::Augmented => {
                "Mass matrix M, Jacobian J (row-major), forcing f and bias b of M y' - J' lambda = f, J y' = -b, y as in `UNKNOWN_NAMES`."
            }
        }
    }
}

/// Of a function that nobody reads line by line.
const STRAIGHT_LINE: &str = "\
#[allow(
    non_snake_case,
    clippy::all,
    clippy::pedantic,
    reason = \"generated straight-line arithmetic\"
)]
#[must_use]
";
/// Of structs whose fields are the model's.
const PLAIN_STRUCT: &str = "\
#[derive(Clone, Copy, Debug)]
#[repr(C)]
#[allow(non_snake_case, reason = \"names are the model's\")]
";

/// The formatted source text; a program that is not driven has no [`Answer::Drive`].
#[must_use]
pub fn emit(program: &Program, options: &EmitOptions) -> String {
    let mut answers = Answer::of(program);
    if !options.answers.is_empty() {
        let wanted = options.answers.iter().copied();
        answers = wanted.filter(|&answer| answer == Answer::Augmented || answers.contains(&answer)).collect();
    }
    let roots: Vec<ExprId> = answers.iter().flat_map(|answer| answer.roots(program)).collect();
    let prepared = Prepared::new(program, &roots);
    let costs: Vec<Cost> = answers
        .iter()
        .map(|answer| program.dag.operations_by_kind(&answer.roots(program), Dependence::State))
        .collect();
    let preparing = prepared.operations(program);
    let mut text = header::text(program, options, answers.iter().zip(&costs), &preparing);
    let runtime = options.runtime.trim();
    text += &format!("\nuse {runtime}::real::Real;\n/// The scalar of this file.\n");
    text += &format!("pub type S = {};\n", scalar_name(&options.scalar));
    text += &constants(program, options);
    let fields = name::fields(program);
    text += &parameters(program, &fields, options);
    if answers.contains(&Answer::Augmented) {
        let doc = "Speeds and lifted twists of the augmented form, in order.";
        text += &names_constant("UNKNOWN_NAMES", doc, &program.augmented.unknowns);
    }
    text += &prepared.items(program, &fields, &options.scalar, &preparing);
    for (&answer, cost) in answers.iter().zip(&costs) {
        text += &function(program, answer, cost, &options.scalar, &prepared);
    }
    if options.answers.is_empty() {
        text += &glue::mechanism(program, &fields, runtime);
    }
    text
}

/// Operations by kind.
type Cost = std::collections::BTreeMap<&'static str, usize>;

fn scalar_name(scalar: &ScalarType) -> &str {
    match scalar {
        ScalarType::F32 => "f32",
        ScalarType::F64 => "f64",
        ScalarType::Path(path) => path.trim(),
    }
}

/// A constant of the file's scalar: a literal, or a conversion for other scalars.
fn literal(value: f64, scalar: &ScalarType) -> String {
    let special = match value {
        v if v.is_nan() => Some("S::NAN"),
        v if v == f64::INFINITY => Some("S::INFINITY"),
        v if v == f64::NEG_INFINITY => Some("S::NEG_INFINITY"),
        _ => None,
    };
    let text = match (scalar, special) {
        (ScalarType::F32 | ScalarType::F64, Some(name)) => name.to_owned(),
        // Rounded once to f32; the shortest text that reads back as that number.
        (ScalarType::F32, None) => format!("{:?}_f32", value as f32),
        (ScalarType::F64, None) => format!("{value:?}_f64"),
        (ScalarType::Path(_), None) => format!("<S as Real>::from_f64({value:?}_f64)"),
        (ScalarType::Path(_), Some(name)) => {
            format!("<S as Real>::from_f64({})", name.replace("S::", "f64::"))
        }
    };
    if text.starts_with('-') { format!("({text})") } else { text }
}

fn names_constant(name: &str, doc: &str, names: &[String]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("{name:?}")).collect();
    layout::doc(doc) + &layout::array(&format!("pub const {name}: [&str; {}usize] = ", names.len()), &quoted)
}

fn constants(program: &Program, options: &EmitOptions) -> String {
    let names = |list: &[Quantity]| list.iter().map(|x| x.name.clone()).collect::<Vec<_>>();
    let firsts = |list: &[(String, ExprId)]| list.iter().map(|(n, _)| n.clone()).collect::<Vec<_>>();
    let nq = program.q.len();
    let mut text = String::new();
    let sizes = [
        ("NQ", "Number of coordinates q.", nq),
        ("NU", "Number of independent speeds u.", program.u.len()),
        ("N_INPUTS", "Number of inputs.", program.inputs.len()),
    ];
    for (name, doc, size) in sizes {
        text += &format!("/// {doc}\npub const {name}: usize = {size}usize;\n");
    }
    text += &names_constant("Q_NAMES", "Coordinates in order.", &names(&program.q));
    text += &names_constant("U_NAMES", "Independent speeds in order.", &names(&program.u));
    text += &names_constant("INPUT_NAMES", "Inputs in order.", &names(&program.inputs));
    text += &names_constant("PARAMETER_NAMES", "Tunable parameters in order.", &names(&program.parameters));
    text += &names_constant("SPEED_NAMES", "All speeds in order.", &firsts(&program.speeds));
    text += &names_constant("OUTPUT_NAMES", "Outputs in order.", &firsts(&program.outputs));
    let corrected: Vec<String> = program.correction.iter().map(|(i, _)| format!("{i}usize")).collect();
    text += "/// Indices of the coordinates that the projection corrects.\n";
    text += &layout::array(&format!("pub const CORRECTED: [usize; {}usize] = ", corrected.len()), &corrected);
    let angles: Vec<String> = program.q.iter().map(|q| q.is_angle.to_string()).collect();
    text += "/// Coordinates read only by sines and cosines: they may be wrapped by whole turns.\n";
    text += &layout::array(&format!("pub const IS_ANGLE: [bool; {nq}usize] = "), &angles);
    let (scalar, nominal): (_, Vec<String>) = match options.scalar {
        ScalarType::F32 => ("f32", program.q.iter().map(|q| format!("{}f32", q.value as f32)).collect()),
        _ => ("f64", program.q.iter().map(|q| format!("{}f64", q.value)).collect()),
    };
    text += "/// The nominal configuration.\n";
    text += &layout::array(&format!("pub const NOMINAL: [{scalar}; {nq}usize] = "), &nominal);
    text
}

/// The struct of tunable parameters, with these names for its fields, and its defaults.
fn parameters(program: &Program, names: &[String], options: &EmitOptions) -> String {
    let named = || program.parameters.iter().zip(names);
    let fields = named().map(|(p, name)| {
        let what = name::sentence(&p.doc, &p.name);
        let doc = escape::markdown(&format!("{what} ({}), {}:{}.", p.unit, program.path, p.line));
        format!("///{doc}\n    pub {name}: S")
    });
    let defaults = named().map(|(p, name)| format!("{name}: {}", literal(p.value, &options.scalar)));
    let values = layout::block("Self", defaults, "        ");
    format!(
        "/// Tunable parameters, SI units.\n{PLAIN_STRUCT}{}impl Default for Parameters {{\n    fn default() -> Self {{\n{values}    }}\n}}\n",
        layout::block("pub struct Parameters", fields, "")
    )
}

/// One answer as a function.
fn function(
    program: &Program,
    answer: Answer,
    cost: &Cost,
    scalar: &ScalarType,
    prepared: &Prepared,
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
    let body = Body::new(program, &roots, scalar, Parameters::Prepared(prepared));
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
