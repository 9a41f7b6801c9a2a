//! The emitted file, from its first line to its last.

use super::answer::{Answer, Cost};
use super::options::EmitOptions;
use super::prepared::Prepared;
use super::{function, glue, header, items, name};
use crate::expr::{Dependence, ExprId};
use crate::program::Program;

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
    text += &format!("pub type S = {};\n", options.scalar.path());
    text += &items::constants(program, &options.scalar);
    let fields = name::fields(program);
    text += &items::parameters(program, &fields, &options.scalar);
    if answers.contains(&Answer::Augmented) {
        let doc = "Speeds and lifted twists of the augmented form, in order.";
        text += &items::names("UNKNOWN_NAMES", doc, &program.augmented.unknowns);
    }
    text += &function::prepare(program, &fields, &prepared, &preparing, options);
    for (&answer, cost) in answers.iter().zip(&costs) {
        text += &function::answer(program, answer, cost, &prepared, options);
    }
    if options.answers.is_empty() {
        text += &glue::mechanism(program, &fields, runtime, &options.scalar);
    }
    text
}
