//! Constants of the emitted file and the struct of its parameters.

use super::layout::PLAIN_STRUCT;
use super::options::ScalarType;
use super::{layout, name};
use crate::escape;
use crate::expr::ExprId;
use crate::program::{Program, Quantity};

/// An array of names.
pub(super) fn names(name: &str, doc: &str, names: &[String]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("{name:?}")).collect();
    layout::doc(doc) + &layout::array(&format!("pub const {name}: [&str; {}usize] = ", names.len()), &quoted)
}

/// Sizes, names, and what is known of the coordinates.
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
        text += &format!("/// {doc}\npub const {name}: usize = {size}usize;\n");
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
    let corrected: Vec<String> = program.correction.iter().map(|(i, _)| format!("{i}usize")).collect();
    text += "/// Indices of the coordinates that the projection corrects.\n";
    text += &layout::array(&format!("pub const CORRECTED: [usize; {}usize] = ", corrected.len()), &corrected);
    let angles: Vec<String> = program.q.iter().map(|q| q.is_angle.to_string()).collect();
    text += "/// Coordinates read only by sines and cosines: they may be wrapped by whole turns.\n";
    text += &layout::array(&format!("pub const IS_ANGLE: [bool; {nq}usize] = "), &angles);
    let (scalar, nominal): (_, Vec<String>) = match scalar {
        ScalarType::F32 => ("f32", program.q.iter().map(|q| format!("{}f32", q.value as f32)).collect()),
        _ => ("f64", program.q.iter().map(|q| format!("{}f64", q.value)).collect()),
    };
    text += "/// The nominal configuration.\n";
    text += &layout::array(&format!("pub const NOMINAL: [{scalar}; {nq}usize] = "), &nominal);
    text
}

/// The struct of tunable parameters, with these names for its fields, and its defaults.
pub(super) fn parameters(program: &Program, names: &[String], scalar: &ScalarType, runtime: &str) -> String {
    let named = || program.parameters.iter().zip(names);
    let fields = named().map(|(p, name)| {
        let what = name::sentence(&p.doc, &p.name);
        let doc = escape::markdown(&format!("{what} ({}), {}:{}.", p.unit, program.path, p.line));
        format!("///{doc}\n    pub {name}: S")
    });
    let defaults = named().map(|(p, name)| format!("{name}: {}", scalar.literal(p.value)));
    let values = layout::block("Self", defaults, "        ");
    let check = match scalar {
        ScalarType::F32 | ScalarType::F64 => check(program, names, scalar, runtime),
        // Lanes hold several mechanisms and do not compare.
        ScalarType::Path(_) => String::new(),
    };
    format!(
        "/// Tunable parameters, SI units.\n{PLAIN_STRUCT}{}impl Default for Parameters {{\n    fn default() -> Self {{\n{values}    }}\n}}\n{check}",
        layout::block("pub struct Parameters", fields, "")
    )
}

/// The ranges of the parameters, and the method that compares.
fn check(program: &Program, names: &[String], scalar: &ScalarType, runtime: &str) -> String {
    let ends = |p: &Quantity| format!("[{}, {}]", scalar.literal(p.range.0), scalar.literal(p.range.1));
    let ranges: Vec<String> = program.parameters.iter().map(ends).collect();
    let count = ranges.len();
    let mut text = "/// Lowest and highest value of every tunable parameter, SI units.\n".to_owned();
    text += &layout::array(&format!("pub const PARAMETER_RANGES: [[S; 2]; {count}usize] = "), &ranges);
    let values: String = names.iter().map(|name| format!("            self.{name},\n")).collect();
    let values = if count == 0 {
        "let values = [];".to_owned()
    } else {
        format!("let values = [\n{values}        ];")
    };
    text += &format!(
        "\
impl Parameters {{
    /// Is every parameter a finite number within its range?
    ///
    /// # Errors
    /// The first that is not, with its value and range.
    pub fn check(&self) -> Result<(), {runtime}::mechanism::OutOfRange<S>> {{
        {values}
        {runtime}::mechanism::check_parameters(&PARAMETER_NAMES, &values, &PARAMETER_RANGES)
    }}
}}
"
    );
    text
}
