//! What an expression of a model reads.
//!
//! In: an expression and a kind of node. Out: whether it contains one, directly or through definitions.

use smartbed_codegen::model::Model;
use smartbed_codegen::model::expression::{Expr, ExprKind};

/// Is it a speed or a velocity?
pub(crate) fn is_speed(e: &Expr) -> bool {
    use ExprKind::{AngularVelocity, Rate, Speed, Velocity};
    matches!(e.kind, Speed(_) | Rate(_) | Velocity(_) | AngularVelocity(_))
}

/// Does the expression, or a definition in it, contain such a node?
pub(crate) fn mentions(model: &Model, expr: &Expr, wanted: &dyn Fn(&Expr) -> bool) -> bool {
    let mut found = false;
    let mut definitions = Vec::new();
    let mut look = |root: &Expr, definitions: &mut Vec<_>| {
        root.visit(&mut |e| {
            found |= wanted(e);
            if let ExprKind::Definition(id) = e.kind
                && !definitions.contains(&id)
            {
                definitions.push(id);
            }
        });
    };
    look(expr, &mut definitions);
    let mut next = 0;
    while let Some(&id) = definitions.get(next) {
        look(&model.definitions[id].value, &mut definitions);
        next += 1;
    }
    found
}
