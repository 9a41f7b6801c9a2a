//! Indices of named quantities in arrays, as constants: `q[q::hA]` instead of `q[0]`.
//!
//! In: a program. Out: one module each for coordinates, speeds, inputs and outputs; every constant is documented by
//! description, unit, range and the model's line.

use super::layout;
use super::name::{self, Scope};
use crate::escape;
use crate::program::{Program, Quantity};

/// The four modules.
pub(super) fn modules(program: &Program) -> String {
    let outputs = program.outputs.iter().zip(&program.output_facts);
    let outputs =
        outputs.map(|((name, _), [unit, place])| (name.as_str(), sentence("", name, unit, "", place)));
    [
        module("q", "Places of the coordinates in `q`.", described(&program.q)),
        module("u", "Places of the speeds in `u`.", described(&program.u)),
        module("inputs", "Places of the inputs in `inputs`.", described(&program.inputs)),
        module("outputs", "Places of the outputs in what `outputs` returns.", outputs),
    ]
    .concat()
}

fn described(list: &[Quantity]) -> impl Iterator<Item = (&str, String)> {
    list.iter().map(|x| {
        let range = match x.range.0.is_finite() || x.range.1.is_finite() {
            true => format!(", {} to {}", short(x.range.0), short(x.range.1)),
            false => String::new(),
        };
        (x.name.as_str(), sentence(&x.doc, &x.name, &x.unit, &range, &x.place))
    })
}

/// Rounds to six digits.
fn short(x: f64) -> f64 {
    format!("{x:.5e}").parse().unwrap_or(x)
}

/// `Height of screw A (m), 0 to 0.2, tile.toml:30.`
fn sentence(doc: &str, name: &str, unit: &str, range: &str, place: &str) -> String {
    let what = name::sentence(doc, name);
    escape::markdown(&layout::text(format_args!("{what} ({unit}){range}, {place}.")))
}

fn module<'p>(module: &str, doc: &str, entries: impl Iterator<Item = (&'p str, String)>) -> String {
    let mut scope = Scope::default();
    let constant = |(place, (name, doc)): (usize, (&str, String))| {
        format!("    /// {doc}\n    pub const {}: usize = {place};\n", scope.unique(name))
    };
    let constants: String = entries.enumerate().map(constant).collect();
    let open = "#[allow(dead_code, non_upper_case_globals, reason = \"names are the model's\")]\n";
    match constants.is_empty() {
        true => format!("/// {doc}\n{open}pub mod {module} {{}}\n"),
        false => format!("/// {doc}\n{open}pub mod {module} {{\n{constants}}}\n"),
    }
}
