//! Assembles the emitted file, from its first line to its last.

use super::answer::{self, Cost, Role};
use super::options::EmitOptions;
use super::prepared::Prepared;
use super::sines::{self, Sines};
use super::{function, glue, header, items, name};
use crate::expr::{Dependence, ExprId};
use crate::program::Program;

/// Room for a text: that of most mechanisms fits.
const MOST_TEXT: usize = 1 << 16;

/// The formatted source text; answers that the program does not have are omitted.
#[must_use]
pub fn emit(program: &Program, options: &EmitOptions) -> String {
    let functions = answer::functions(program, options);
    let roots: Vec<ExprId> = functions.iter().flat_map(answer::Emitted::roots).collect();
    let prepared = Prepared::new(program, &roots);
    let costs: Vec<Cost> = functions
        .iter()
        .map(|function| program.dag.operations_by_kind(&function.roots(), Dependence::State))
        .collect();
    let preparing = prepared.operations(program);
    let names = functions.iter().map(|function| function.name.as_str());
    let mut text = header::text(program, options, names.zip(&costs), &preparing);
    // Room for all at once: a text of this size would be moved whenever it grows.
    text.reserve(MOST_TEXT);
    let runtime = options.runtime.trim();
    text += &format!(
        "\n#[allow(unused_imports, reason = \"sums and products need no function\")]\nuse {runtime}::real::Real;\n/// The scalar of this file.\n"
    );
    text += &format!("pub type S = {};\n", options.scalar.path());
    text += &items::constants(program, &options.scalar);
    let fields = name::fields(program);
    text += &items::parameters(program, &fields, &options.scalar, runtime);
    if functions.iter().any(|function| function.gives("augmented")) {
        let doc = "Speeds and lifted twists of the augmented form, in order.";
        text += &items::names("UNKNOWN_NAMES", doc, &program.augmented.unknowns);
    }
    text += &function::prepare(program, &fields, &prepared, &preparing, options);
    let mut defined = Vec::new();
    let angles = if options.shared_work { sines::angles(program, &prepared) } else { Vec::new() };
    for (function, cost) in functions.iter().zip(&costs) {
        let sines = match function.role {
            Role::Alone => Sines::Own,
            Role::First => Sines::HandedOn(&angles),
            Role::Close => Sines::Near(&angles),
        };
        text += &function.structures(&mut defined, angles.len(), runtime);
        text += &function::answer(program, (function, sines), cost, &prepared, options);
    }
    if options.functions.is_empty() {
        text += &glue::mechanism(program, &fields, runtime, &options.scalar);
    }
    text
}
