//! What an expression of a model reads.
//!
//! In: an expression. Out: its nodes and those of its definitions, and whether some kind is among them.

use smartbed_codegen::model::Model;
use smartbed_codegen::model::expression::{Expr, ExprKind};

/// Is it a speed or a velocity?
pub(crate) fn is_speed(e: &Expr) -> bool {
    use ExprKind::{AngularVelocity, Rate, Speed, Velocity};
    matches!(e.kind, Speed(_) | Rate(_) | Velocity(_) | AngularVelocity(_))
}

/// Is it the time?
pub(crate) fn is_time(e: &Expr) -> bool {
    matches!(e.kind, ExprKind::Time)
}

/// Does it depend on more than time?
pub(crate) fn is_state(model: &Model, e: &Expr) -> bool {
    use ExprKind::{AngularVelocity, Axis, Coordinate, Input, Point, Rate, Speed, Velocity};
    match &e.kind {
        Coordinate(id) => match &model.coordinates[*id].closed_form {
            Some(form) => mentions(model, form, &|e| is_state(model, e)),
            None => true,
        },
        Rate(_) | Speed(_) | Input(_) | Point(_) | Velocity(_) | AngularVelocity(_) | Axis(..) => true,
        _ => false,
    }
}

/// Is it a vector?
pub(crate) fn is_vector(model: &Model, e: &Expr) -> bool {
    use ExprKind::{
        Add, AngularVelocity, Axis, Cross, Definition, Divide, Multiply, Negate, Point, Subtract, Velocity,
    };
    match &e.kind {
        Point(_) | Velocity(_) | AngularVelocity(_) | Axis(..) | Cross(..) => true,
        Negate(a) | Divide(a, _) => is_vector(model, a),
        Add(a, b) | Subtract(a, b) | Multiply(a, b) => is_vector(model, a) || is_vector(model, b),
        Definition(id) => is_vector(model, &model.definitions[*id].value),
        _ => false,
    }
}

/// Shows every node of an expression and of the definitions that it reads, each of these once.
pub(crate) fn visit(model: &Model, root: &Expr, show: &mut dyn FnMut(&Expr)) {
    let (mut definitions, mut next, mut expr) = (Vec::new(), 0, root);
    loop {
        expr.visit(&mut |e| {
            show(e);
            if let ExprKind::Definition(id) = e.kind
                && !definitions.contains(&id)
            {
                definitions.push(id);
            }
        });
        let Some(&id) = definitions.get(next) else { break };
        (expr, next) = (&model.definitions[id].value, next + 1);
    }
}

/// Does the expression, or a definition in it, contain such a node?
pub(crate) fn mentions(model: &Model, expr: &Expr, wanted: &dyn Fn(&Expr) -> bool) -> bool {
    let mut found = false;
    visit(model, expr, &mut |e| found |= wanted(e));
    found
}
