//! What time alone does in the equations of a mechanism.
//!
//! In: a model. Out: the commands by which time moves it; the functions at whose zeros commands, laws and loads switch
//! (`jumps.rs` knows which expressions do); all functions of time alone, which steps must not pass over.

use crate::jumps;
use crate::reads::{Dependence, is_time, is_vector, mentions, visit};
use crate::terms::{components, node};
use smartbed_codegen::model::expression::{Expr, ExprKind};
use smartbed_codegen::model::{Model, SpeedMeaning};

/// Where time moves the mechanism through functions that switch: a coordinate in closed form, a position, an
/// orientation, a speed or a constraint that reads the time.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Command {
    /// What it is, in words before its name.
    pub what: &'static str,
    /// The name in the model.
    pub name: String,
    /// The coordinate in closed form, by its number among these.
    pub closed: Option<usize>,
    /// Number of arguments by which it switches.
    pub switches: usize,
    /// Number of its values, which may not jump; those of motions may, and are left out.
    pub values: usize,
}

impl Command {
    /// In words with its name, as one of a part of that name if there is one.
    #[must_use]
    pub fn words(&self, part: Option<&str>) -> String {
        let Self { what, name, .. } = self;
        part.map_or_else(|| format!("{what} `{name}`"), |part| format!("{what} `{part}.{name}`"))
    }
}

/// Whether a commanded speed may change at once: what commands it has abs, sign, min or max of the time, or the like.
#[must_use]
pub fn may_leap(model: &Model) -> bool {
    commands(model).into_iter().any(|(_, read, _)| !kinks_of(model, read).is_empty())
}

/// Whether a law or a load may jump or have a kink at a time.
#[must_use]
pub fn may_switch(model: &Model) -> bool {
    !switches(model).1.is_empty()
}

/// A command, the functions of time at whose zeros it may switch, and its values.
pub(crate) type Switching = (Command, Vec<Expr>, Vec<Expr>);

/// The commands that may have a kink or a jump in time, and the functions at whose zeros a law or a load may.
pub(crate) fn switches(model: &Model) -> (Vec<Switching>, Vec<Expr>) {
    if !model.reads_time() {
        return (Vec::new(), Vec::new());
    }
    let commands = commands(model).into_iter().filter_map(|(mut command, read, values)| {
        let own = switches_of(model, read);
        (command.switches, command.values) = (own.len(), values.len());
        (!own.is_empty()).then_some((command, own, values))
    });
    // Kinks of what is commanded, such as its end stops, cost no more than an order: only what jumps there counts.
    let jumps = |e| arguments_of_time(model, e, &|e| jumps::sign(e).into_iter().collect());
    let others = laws_and_loads(model).flat_map(|e| {
        let stated = switches_of(model, e).into_iter().filter(|e| mentions(model, e, &is_time));
        stated.chain(jumps(e).into_iter().filter(|e| !mentions(model, e, &is_time)))
    });
    (commands.collect(), others.collect())
}

/// Everything by which time may move the mechanism: what it is, its expression, its values (none of what gives speeds).
fn commands(model: &Model) -> Vec<(Command, &Expr, Vec<Expr>)> {
    let named =
        |what, name: &str| Command { what, name: name.to_owned(), closed: None, switches: 0, values: 0 };
    let all = |e: &Expr| match is_vector(model, e) {
        true => components(e.clone()).to_vec(),
        false => vec![e.clone()],
    };
    let mut found = Vec::new();
    let closed = model.coordinates.enumerate().filter_map(|(id, c)| Some((id, c, c.closed_form.as_ref()?)));
    for (number, (id, coordinate, form)) in closed.enumerate() {
        let command = Command { closed: Some(number), ..named("the command of", &coordinate.name) };
        found.push((command, form, vec![node(ExprKind::Coordinate(id))]));
    }
    for frame in model.frames.iter() {
        let parts = frame.orientation.expressions().into_iter();
        found.extend(parts.map(|(_, e)| (named("the orientation of", &frame.name), e, all(e))));
        let fixed = frame.fixed_vectors.iter().map(|fixed| &fixed.vector);
        found.extend(fixed.map(|e| (named("a fixed vector of", &frame.name), e, all(e))));
    }
    for point in model.points.iter() {
        let places = std::iter::once(&point.position).chain(&point.closures);
        found.extend(places.map(|e| (named("the position of", &point.name), e, all(e))));
        found.extend(point.velocity.iter().map(|e| (named("the velocity of", &point.name), e, Vec::new())));
    }
    // A state of such a speed says what the rates are: these must not jump.
    for speed in model.speeds.iter() {
        if let SpeedMeaning::Combination(e) = &speed.meaning {
            found.push((named("the speed", &speed.name), e, rates_in(e)));
        }
    }
    for constraint in &model.configuration_constraints {
        let e = &constraint.expression;
        found.push((named("the constraint", &constraint.name), e, all(e)));
    }
    for constraint in &model.motion_constraints {
        found.push((named("the constraint", &constraint.name), &constraint.expression, Vec::new()));
    }
    found
}

/// The rates of coordinates in a combination.
fn rates_in(combination: &Expr) -> Vec<Expr> {
    let mut rates: Vec<Expr> = Vec::new();
    combination.visit(&mut |e| {
        if let ExprKind::Rate(id) = e.kind {
            rates.push(node(ExprKind::Rate(id)));
        }
    });
    rates
}

/// The functions of time alone at whose zeros an expression, or a definition that it reads, may switch. Poles count where
/// the time itself stands: the geometry that follows commanded coordinates is regular where it can be assembled.
fn switches_of(model: &Model, expr: &Expr) -> Vec<Expr> {
    let mut found = kinks_of(model, expr);
    found.extend(
        arguments_of_time(model, expr, &|e| jumps::pole(e).into_iter().collect())
            .into_iter()
            .filter(|e| mentions(model, e, &is_time)),
    );
    found
}

/// Those of kinks.
fn kinks_of(model: &Model, expr: &Expr) -> Vec<Expr> {
    arguments_of_time(model, expr, &|e| jumps::switch(model, e))
}

/// Arguments in an expression, and in the definitions that it reads, that are functions of time alone: each factor of
/// them, since two that change sign at once, or shortly one after the other, leave no trace in their product.
fn arguments_of_time(model: &Model, expr: &Expr, arguments: &dyn Fn(&Expr) -> Vec<Expr>) -> Vec<Expr> {
    let mut found = Vec::new();
    visit(model, expr, &mut |e| {
        found.extend(arguments(e).iter().flat_map(|argument| jumps::factors(model, argument)));
    });
    found.retain(|e| Dependence::of(model, e).is_time_alone());
    found
}

/// Functions of time alone that commands read, and those that laws, loads and gravity read: each part of them that is a
/// number and depends on the time but not on the state, of sums the part that does. Of what reads the time through
/// names only, the whole: what the names stand for are commands themselves.
pub(crate) fn functions(model: &Model) -> [Vec<Expr>; 2] {
    if !model.reads_time() {
        return [Vec::new(), Vec::new()];
    }
    let commands = commands(model).into_iter().map(|(_, read, _)| read);
    [of_all(model, commands), of_all(model, laws_and_loads(model).chain(&model.gravity))]
}

fn laws_and_loads(model: &Model) -> impl Iterator<Item = &Expr> {
    let laws = model.laws.iter().map(|(_, law)| law);
    laws.chain(model.loads.iter().flat_map(|load| load.kind.expressions()).map(|(_, e)| e))
}

fn of_all<'e>(model: &Model, expressions: impl Iterator<Item = &'e Expr>) -> Vec<Expr> {
    let mut found: Vec<Expr> = Vec::new();
    for expression in expressions {
        let mut inside: Vec<*const Expr> = Vec::new();
        visit(model, expression, &mut |e| {
            if inside.contains(&std::ptr::from_ref(e)) {
                return;
            }
            if let Some(own) = of_time(model, e) {
                if !mentions(model, e, &is_time) {
                    e.visit(&mut |part| inside.push(std::ptr::from_ref(part)));
                }
                found.push(own);
            }
        });
    }
    found
}

/// The expression, or the terms of a sum that depend on the time alone.
fn of_time(model: &Model, e: &Expr) -> Option<Expr> {
    if is_of_time(model, e) {
        return (!is_time(e)).then(|| e.clone());
    }
    let is_sum = matches!(e.kind, ExprKind::Add(..) | ExprKind::Subtract(..));
    if is_sum && !is_vector(model, e) { terms(model, e) } else { None }
}

/// A number that depends on the time and on no state.
fn is_of_time(model: &Model, e: &Expr) -> bool {
    !is_vector(model, e) && Dependence::of(model, e).is_time_alone()
}

/// The terms of a sum that depend on the time alone, as a sum.
fn terms(model: &Model, e: &Expr) -> Option<Expr> {
    let with = |kind| Some(Expr { kind, span: e.span, unit: e.unit });
    match &e.kind {
        _ if is_of_time(model, e) => Some(e.clone()),
        ExprKind::Add(a, b) => match (terms(model, a), terms(model, b)) {
            (Some(a), Some(b)) => with(ExprKind::Add(Box::new(a), Box::new(b))),
            (one, other) => one.or(other),
        },
        ExprKind::Subtract(a, b) => match (terms(model, a), terms(model, b)) {
            (Some(a), Some(b)) => with(ExprKind::Subtract(Box::new(a), Box::new(b))),
            (one, other) => one.or(other),
        },
        ExprKind::Negate(a) => terms(model, a).and_then(|a| with(ExprKind::Negate(Box::new(a)))),
        ExprKind::Definition(id) => terms(model, &model.definitions[*id].value),
        _ => None,
    }
}
