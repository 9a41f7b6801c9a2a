//! Signs in loads and laws: where their arguments are 0 the equations jump.
//!
//! In: a model. Out: each `sign` that a load or a law reads, directly or through definitions, with its argument; of those
//! of speeds, as dry friction is written, a warning: in steps of fixed size friction chatters about rest, and what sticks
//! creeps.

use crate::reads::{is_speed, mentions, visit};
use smartbed_codegen::diagnostic::Diagnostic;
use smartbed_codegen::id::Id;
use smartbed_codegen::model::Model;
use smartbed_codegen::model::expression::{Expr, ExprKind, Function};
use smartbed_codegen::source::Span;

/// What to write instead.
pub const SMOOTH: &str =
    "write tanh(u/w), or 2*smooth_step(u, w) - 1, for sign(u), with a width w in the unit of the speed";

/// A `sign` in a load or a law.
#[derive(Clone, Debug)]
pub struct Jump {
    /// Name of the load, or of the input of the law.
    pub owner: String,
    /// Where it stands.
    pub span: Span,
    /// What it is the sign of.
    pub argument: Expr,
}

/// Those of the loads.
#[must_use]
pub fn of_loads(model: &Model) -> Vec<Jump> {
    let all = model.loads.iter().flat_map(|load| {
        let expressions = load.kind.expressions().into_iter().map(|(_, e)| e);
        signs(model, &load.name, expressions)
    });
    all.collect()
}

/// Those of loads and laws whose arguments depend on speeds.
#[must_use]
pub fn of_speeds(model: &Model) -> Vec<Jump> {
    let laws = model.laws.iter().flat_map(|(input, law)| {
        let name = model.inputs.iter().nth(input.index()).map_or("", |input| input.name.as_str());
        signs(model, name, std::iter::once(law))
    });
    let mut all: Vec<Jump> = of_loads(model).into_iter().chain(laws).collect();
    all.retain(|jump| mentions(model, &jump.argument, &is_speed));
    all
}

/// A warning for each of these.
pub fn warnings(model: &Model) -> impl Iterator<Item = Diagnostic> {
    of_speeds(model).into_iter().map(|Jump { owner, span, .. }| {
        Diagnostic::warning(format!(
            "`{owner}` jumps where a speed changes sign: in steps of fixed size it chatters about rest, and what it should \
             hold creeps"
        ))
        .label(span, "sign of a speed")
        .help(SMOOTH)
    })
}

/// Each `sign` in expressions and in the definitions that these read.
fn signs<'m>(model: &'m Model, owner: &str, expressions: impl Iterator<Item = &'m Expr>) -> Vec<Jump> {
    let mut found: Vec<Jump> = Vec::new();
    let mut look = |e: &Expr| {
        if let ExprKind::Call(Function::Sign, arguments) = &e.kind
            && found.iter().all(|known| known.span != e.span)
        {
            let jump =
                |argument: &Expr| Jump { owner: owner.to_owned(), span: e.span, argument: argument.clone() };
            found.extend(arguments.iter().map(jump));
        }
    };
    expressions.for_each(|e| visit(model, e, &mut look));
    found
}
