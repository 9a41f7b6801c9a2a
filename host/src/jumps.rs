//! Signs in loads and laws, where the equations jump; and kinks of loads, where their slopes do.
//!
//! In: a model. Out: each `sign` that a load or a law reads, directly or through definitions, with its argument; each
//! `abs`, `min` and `max` that a load reads, and what else is an absolute value, with what is 0 at its kink; for signs
//! of speeds, as dry friction is written, a warning: in steps of fixed size friction chatters about rest, and what
//! sticks creeps.

use crate::reads::{is_speed, is_vector, mentions, visit};
use smartbed_codegen::diagnostic::Diagnostic;
use smartbed_codegen::id::Id;
use smartbed_codegen::model::Model;
use smartbed_codegen::model::expression::{Expr, ExprKind, Function};
use smartbed_codegen::source::Span;

/// What to write instead.
pub const SMOOTH: &str =
    "write tanh(u/w), or 2*smooth_step(u, w) - 1, for sign(u), with a width w in the unit of the speed";

/// A function in a load or a law that jumps, or has a kink.
#[derive(Clone, Debug)]
pub struct Jump {
    /// Name of the load, or of the input of the law.
    pub owner: String,
    /// Where it stands.
    pub span: Span,
    /// What is 0 where it jumps.
    pub argument: Expr,
}

/// Each `sign` of the loads.
#[must_use]
pub fn of_loads(model: &Model) -> Vec<Jump> {
    in_loads(model, &|e| sign(e).into_iter().collect())
}

/// Each `abs`, `min` and `max` of the loads, and each root of squares and norm of a vector that keeps its direction.
#[must_use]
pub fn kinks_of_loads(model: &Model) -> Vec<Jump> {
    in_loads(model, &|e| kink(e).into_iter().chain(folds(model, e)).collect())
}

fn in_loads(model: &Model, arguments: &dyn Fn(&Expr) -> Vec<Expr>) -> Vec<Jump> {
    let all = model.loads.iter().flat_map(|load| {
        let expressions = load.kind.expressions().into_iter().map(|(_, e)| e);
        found(model, &load.name, expressions, arguments)
    });
    all.collect()
}

/// The argument of a `sign`.
pub(crate) fn sign(e: &Expr) -> Option<Expr> {
    match &e.kind {
        ExprKind::Call(Function::Sign, arguments) => arguments.first().cloned(),
        _ => None,
    }
}

/// What is 0 at the kink of an `abs`, `min` or `max`.
pub(crate) fn kink(e: &Expr) -> Option<Expr> {
    match &e.kind {
        ExprKind::Call(Function::Abs, arguments) => arguments.first().cloned(),
        ExprKind::Call(Function::Min | Function::Max, arguments) => {
            let [a, b] = &arguments[..] else { return None };
            let kind = ExprKind::Subtract(Box::new(a.clone()), Box::new(b.clone()));
            Some(Expr { kind, span: e.span, unit: a.unit })
        }
        _ => None,
    }
}

/// What is 0 where an expression may have a kink or a jump: the argument of a `sign`, `abs`, `min` or `max`, or what
/// [`folds`].
pub(crate) fn switch(model: &Model, e: &Expr) -> Vec<Expr> {
    sign(e).into_iter().chain(kink(e)).chain(folds(model, e)).collect()
}

/// What is 0 at the kink of a root of squares, or of the norm of a vector that keeps its direction: both are absolute
/// values.
fn folds(model: &Model, e: &Expr) -> Vec<Expr> {
    match &e.kind {
        ExprKind::Call(Function::Sqrt, arguments) => {
            arguments.first().map_or_else(Vec::new, |root| squared(model, root))
        }
        ExprKind::Norm(vector) => along(model, vector),
        _ => Vec::new(),
    }
}

/// The factors that an expression has as squares or other even powers.
fn squared(model: &Model, e: &Expr) -> Vec<Expr> {
    match &e.kind {
        ExprKind::Power(base, n) if n % 2 == 0 => vec![(**base).clone()],
        ExprKind::Multiply(a, b) if same(a, b) => vec![(**a).clone()],
        ExprKind::Multiply(a, b) => [squared(model, a), squared(model, b)].concat(),
        ExprKind::Divide(a, _) => squared(model, a),
        ExprKind::Dot(a, b) if same(a, b) => along(model, a),
        ExprKind::Definition(id) => squared(model, &model.definitions[*id].value),
        _ => Vec::new(),
    }
}

/// The factors of a number by which it changes sign; the number itself where it is no product.
pub(crate) fn factors(model: &Model, e: &Expr) -> Vec<Expr> {
    match &e.kind {
        ExprKind::Multiply(a, b) | ExprKind::Divide(a, b) => [factors(model, a), factors(model, b)].concat(),
        ExprKind::Negate(a) => factors(model, a),
        ExprKind::Power(base, n) if n % 2 != 0 => factors(model, base),
        ExprKind::Definition(id) => {
            let own = factors(model, &model.definitions[*id].value);
            if own.len() == 1 { vec![e.clone()] } else { own }
        }
        _ => vec![e.clone()],
    }
}

/// The scalar factors of a vector.
fn along(model: &Model, vector: &Expr) -> Vec<Expr> {
    match &vector.kind {
        ExprKind::Multiply(a, b) => {
            let (scalar, vector) = if is_vector(model, a) { (b, a) } else { (a, b) };
            [vec![(**scalar).clone()], along(model, vector)].concat()
        }
        ExprKind::Negate(a) | ExprKind::Divide(a, _) => along(model, a),
        ExprKind::Definition(id) => along(model, &model.definitions[*id].value),
        ExprKind::Point(id) => along(model, &model.points[*id].position),
        _ => Vec::new(),
    }
}

/// Do two expressions say the same, wherever they stand?
fn same(a: &Expr, b: &Expr) -> bool {
    let (parts, others) = (a.parts(), b.parts());
    let alike = match (&a.kind, &b.kind) {
        (ExprKind::Power(_, m), ExprKind::Power(_, n)) => m == n,
        (ExprKind::Call(f, _), ExprKind::Call(g, _)) => f == g,
        (x, y) if parts.is_empty() => x == y,
        (x, y) => std::mem::discriminant(x) == std::mem::discriminant(y),
    };
    alike && parts.len() == others.len() && parts.iter().zip(others).all(|(a, b)| same(a, b))
}

/// What is 0 where an expression may jump although it seldom does: `y` of an `atan2(y, x)`, whose angle jumps where x < 0,
/// the cosine of the argument of a `tan`, a divisor.
pub(crate) fn pole(e: &Expr) -> Option<Expr> {
    match &e.kind {
        ExprKind::Call(Function::Atan2, arguments) => arguments.first().cloned(),
        ExprKind::Call(Function::Tan, arguments) => {
            let kind = ExprKind::Call(Function::Cos, arguments.clone());
            Some(Expr { kind, ..e.clone() })
        }
        ExprKind::Divide(_, divisor) => Some((**divisor).clone()),
        ExprKind::Power(base, n) if *n < 0 => Some((**base).clone()),
        _ => None,
    }
}

/// Those of loads and laws whose arguments depend on speeds.
#[must_use]
pub fn of_speeds(model: &Model) -> Vec<Jump> {
    let laws = model.laws.iter().flat_map(|(input, law)| {
        let name = model.inputs.iter().nth(input.index()).map_or("", |input| input.name.as_str());
        found(model, name, std::iter::once(law), &|e| sign(e).into_iter().collect())
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

/// Each such function in expressions and in the definitions that these read.
fn found<'m>(
    model: &'m Model,
    owner: &str,
    expressions: impl Iterator<Item = &'m Expr>,
    arguments: &dyn Fn(&Expr) -> Vec<Expr>,
) -> Vec<Jump> {
    let mut found: Vec<Jump> = Vec::new();
    let mut look = |e: &Expr| {
        if found.iter().all(|known| known.span != e.span) {
            let jump = |argument| Jump { owner: owner.to_owned(), span: e.span, argument };
            found.extend(arguments(e).into_iter().map(jump));
        }
    };
    expressions.for_each(|e| visit(model, e, &mut look));
    found
}
