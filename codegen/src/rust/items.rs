//! Emits the constants of the file and the struct of its parameters.

use super::layout::{NUMBERS, PLAIN_STRUCT, UNREAD};
use super::options::ScalarType;
use super::{layout, name, places};
use crate::escape;
use crate::expr::ExprId;
use crate::program::{Program, Quantity};

/// An array of names.
pub(super) fn names(name: &str, doc: &str, names: &[String]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("{name:?}")).collect();
    list(&format!("{name}: [&str; {}usize]", names.len()), doc, &quoted)
}

/// A constant that is a list.
fn list(declared: &str, doc: &str, elements: &[String]) -> String {
    marked(UNREAD, declared, doc, elements)
}

fn marked(attribute: &str, declared: &str, doc: &str, elements: &[String]) -> String {
    layout::doc(doc) + attribute + &layout::array(&format!("pub const {declared} = "), elements, "")
}

/// Sizes, names, and facts about the coordinates.
pub(super) fn constants(program: &Program, scalar: &ScalarType) -> String {
    let of = |list: &[Quantity]| list.iter().map(|x| x.name.clone()).collect::<Vec<_>>();
    let firsts = |list: &[(String, ExprId)]| list.iter().map(|(n, _)| n.clone()).collect::<Vec<_>>();
    let nq = program.q.len();
    let mut text = String::new();
    let sizes = [
        ("NQ", "Number of coordinates q.", nq),
        (
            "NU",
            if program.is_redundant() { "Number of speeds u." } else { "Number of independent speeds u." },
            program.u.len(),
        ),
        ("N_INPUTS", "Number of inputs.", program.inputs.len()),
    ];
    for (name, doc, size) in sizes {
        text += &format!("/// {doc}\n{UNREAD}pub const {name}: usize = {size}usize;\n");
    }
    text += &names("Q_NAMES", "Coordinates in order.", &of(&program.q));
    let speeds = match program.is_redundant() {
        true => "Speeds in order: all of them are state, tied by the constraints.",
        false => "Independent speeds in order.",
    };
    text += &names("U_NAMES", speeds, &of(&program.u));
    text += &names("INPUT_NAMES", "Inputs in order.", &of(&program.inputs));
    text += &names("PARAMETER_NAMES", "Tunable parameters in order.", &of(&program.parameters));
    text += &names("SPEED_NAMES", "All speeds in order.", &firsts(&program.speeds));
    text += &names("OUTPUT_NAMES", "Outputs in order.", &firsts(&program.outputs));
    text += &places::modules(program);
    let corrected: Vec<String> = program.correction.iter().map(|(i, _)| format!("{i}usize")).collect();
    let declared = format!("CORRECTED: [usize; {}usize]", corrected.len());
    text += &list(&declared, "Indices of the coordinates that the projection corrects.", &corrected);
    let angles: Vec<String> = program.q.iter().map(|q| q.is_angle.to_string()).collect();
    let doc = "Coordinates read only by sines and cosines: they may be wrapped by whole turns.";
    text += &list(&format!("IS_ANGLE: [bool; {nq}usize]"), doc, &angles);
    let nominal: Vec<f64> = program.q.iter().map(|q| q.value).collect();
    text += &numbers("NOMINAL", "The nominal configuration.", &nominal, scalar);
    match program.start() {
        Ok(start) => {
            let doc =
                "Coordinates where the model starts, on the constraints; nominal ones if it does not say.";
            text += &numbers("START_Q", doc, &start.q, scalar);
            text += &numbers("START_U", "Speeds where the model starts.", &start.u, scalar);
        }
        Err(why) => text += &format!("// No START_Q and START_U: {}.\n", escape::line(&why)),
    }
    text
}

/// A list of numbers: of the file's scalar, or in f64 if the scalar is not a primitive type.
fn numbers(name: &str, doc: &str, values: &[f64], scalar: &ScalarType) -> String {
    let (scalar, values): (_, Vec<String>) = match scalar {
        ScalarType::F32 => ("f32", values.iter().map(|x| format!("{}f32", *x as f32)).collect()),
        _ => ("f64", values.iter().map(|x| format!("{x}f64")).collect()),
    };
    marked(NUMBERS, &format!("{name}: [{scalar}; {}usize]", values.len()), doc, &values)
}

/// The struct of tunable parameters, with these field names, and its defaults.
pub(super) fn parameters(program: &Program, names: &[String], scalar: &ScalarType, runtime: &str) -> String {
    let named = || program.parameters.iter().zip(names);
    let fields = named().map(|(p, name)| {
        let rest = layout::text(format_args!("({}), {}.", p.unit, p.place));
        let doc = name::documented(("parameter", p.name.as_str()), &p.doc, &rest);
        ["/// ", &doc, "\n    pub ", name, ": S"].concat()
    });
    let defaults = named().map(|(p, name)| [name, ": ", &scalar.literal(p.value)].concat());
    let values = layout::block("Self", defaults, "        ");
    let check = match scalar {
        ScalarType::F32 | ScalarType::F64 => check(program, names, scalar, runtime),
        // Lanes hold several mechanisms and cannot be compared.
        ScalarType::Path(_) => String::new(),
    };
    format!(
        "/// Tunable parameters, SI units.\n{PLAIN_STRUCT}{}impl Default for Parameters {{\n    fn default() -> Self {{\n{values}    }}\n}}\n{check}",
        layout::block("pub struct Parameters", fields, "")
    )
}

/// The ranges of the parameters, and the method that checks them.
fn check(program: &Program, names: &[String], scalar: &ScalarType, runtime: &str) -> String {
    let ends = |p: &Quantity| {
        let [low, high] = [p.range.0, p.range.1].map(|end| scalar.literal(scalar.within(end)));
        layout::text(format_args!("[{low}, {high}]"))
    };
    let ranges: Vec<String> = program.parameters.iter().map(ends).collect();
    let count = ranges.len();
    let declared = format!("PARAMETER_RANGES: [[S; 2]; {count}usize]");
    let mut text = list(&declared, "Lowest and highest value of every tunable parameter, SI units.", &ranges);
    let values: Vec<String> = names.iter().map(|name| format!("self.{name}")).collect();
    let values = layout::array("let values = ", &values, "        ");
    text += &format!(
        "\
{UNREAD}impl Parameters {{
    /// Is every parameter a finite number within its range?
    ///
    /// # Errors
    /// The first that is not, with its value and range.
    pub fn check(&self) -> Result<(), {runtime}::mechanism::OutOfRange<S>> {{
{values}        {runtime}::mechanism::check_parameters(&PARAMETER_NAMES, &values, &PARAMETER_RANGES)
    }}
}}
"
    );
    text
}
