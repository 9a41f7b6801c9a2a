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
pub(super) fn parameters(program: &Program, names: &[String], scalar: &ScalarType) -> String {
    let named = || program.parameters.iter().zip(names);
    let fields = named().map(|(p, name)| {
        let what = name::sentence(&p.doc, &p.name);
        let doc = escape::markdown(&format!("{what} ({}), {}:{}.", p.unit, program.path, p.line));
        format!("///{doc}\n    pub {name}: S")
    });
    let defaults = named().map(|(p, name)| format!("{name}: {}", scalar.literal(p.value)));
    let values = layout::block("Self", defaults, "        ");
    format!(
        "/// Tunable parameters, SI units.\n{PLAIN_STRUCT}{}impl Default for Parameters {{\n    fn default() -> Self {{\n{values}    }}\n}}\n",
        layout::block("pub struct Parameters", fields, "")
    )
}
