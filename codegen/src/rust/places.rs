//! Indices of named quantities in arrays, as constants: `q[q::hA]` instead of `q[0]`.
//!
//! In: a program. Out: one module each for coordinates, speeds, inputs and outputs; every constant is documented by
//! description, unit, range and the model's line.

use super::layout;
use super::name::{self, Scope};
use crate::program::{Program, Quantity};

/// The four modules.
pub(super) fn modules(program: &Program) -> String {
    let outputs = program.outputs.iter().zip(&program.output_facts);
    let outputs = outputs.map(|((name, _), [unit, place])| {
        (name.as_str(), sentence(("output", name.as_str()), "", unit, "", place))
    });
    [
        module("q", "Places of the coordinates in `q`.", described("coordinate", &program.q)),
        module("u", "Places of the speeds in `u`.", described("speed", &program.u)),
        module("inputs", "Places of the inputs in `inputs`.", described("input", &program.inputs)),
        module("outputs", "Places of the outputs in what `outputs` returns.", outputs),
    ]
    .concat()
}

fn described<'p>(kind: &'static str, list: &'p [Quantity]) -> impl Iterator<Item = (&'p str, String)> {
    list.iter().map(move |x| {
        let range = match x.range.0.is_finite() || x.range.1.is_finite() {
            true => format!(", {} to {}", short(x.range.0), short(x.range.1)),
            false => String::new(),
        };
        (x.name.as_str(), sentence((kind, x.name.as_str()), &x.doc, &x.unit, &range, &x.place))
    })
}

/// Rounds to six digits.
fn short(x: f64) -> f64 {
    format!("{x:.5e}").parse().unwrap_or(x)
}

/// `Height of screw A (m), 0 to 0.2, tile.toml:30.`
fn sentence(named: (&str, &str), doc: &str, unit: &str, range: &str, place: &str) -> String {
    name::documented(named, doc, &layout::text(format_args!("({unit}){range}, {place}.")))
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
