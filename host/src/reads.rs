//! What an expression of a model reads.
//!
//! In: an expression. Out: its nodes and those of its definitions, whether some kind is among them, and whether its
//! value depends on the time or on the state.

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

/// What a value depends on, through whatever names.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Dependence {
    /// On the time.
    pub time: bool,
    /// On the state: coordinates that have no closed form, speeds, inputs.
    pub state: bool,
}

impl Dependence {
    /// That of an expression. Coordinates in closed form, points, frames and their velocities depend on what gives
    /// them.
    pub fn of(model: &Model, expr: &Expr) -> Self {
        let mut found = Self { time: false, state: false };
        walk(expr, &|kind| behind(model, kind), &mut |e| match e.kind {
            ExprKind::Time => found.time = true,
            ExprKind::Speed(_) | ExprKind::Input(_) => found.state = true,
            ExprKind::Coordinate(id) | ExprKind::Rate(id) => {
                found.state |= model.coordinates[id].closed_form.is_none();
            }
            _ => {}
        });
        found
    }

    /// On the time and on nothing else that changes?
    pub fn is_time_alone(self) -> bool {
        self.time && !self.state
    }
}

/// The expressions that give what an expression of this kind stands for.
fn behind<'m>(model: &'m Model, kind: &ExprKind) -> Vec<&'m Expr> {
    use ExprKind::{AngularVelocity, Axis, Coordinate, Definition, Point, Rate, Velocity};
    match *kind {
        Definition(id) => vec![&model.definitions[id].value],
        Coordinate(id) | Rate(id) => model.coordinates[id].closed_form.iter().collect(),
        Point(id) | Velocity(id) => {
            let point = &model.points[id];
            std::iter::once(&point.position).chain(&point.velocity).collect()
        }
        Axis(id, _) | AngularVelocity(id) => {
            let frames = std::iter::successors(Some(id), |id| model.frames[*id].orientation.parent());
            frames.flat_map(|id| model.frames[id].orientation.expressions()).map(|(_, e)| e).collect()
        }
        _ => Vec::new(),
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
    let definition = |kind: &ExprKind| match kind {
        ExprKind::Definition(_) => behind(model, kind),
        _ => Vec::new(),
    };
    walk(root, &definition, show);
}

/// Shows every node of an expression and of those `behind` its nodes, each of these once.
fn walk<'m>(root: &'m Expr, behind: &dyn Fn(&ExprKind) -> Vec<&'m Expr>, show: &mut dyn FnMut(&Expr)) {
    let (mut all, mut next) = (vec![root], 0);
    while let Some(&expr) = all.get(next) {
        next += 1;
        expr.visit(&mut |e| {
            show(e);
            for own in behind(&e.kind) {
                if !all.iter().any(|known| std::ptr::eq(*known, own)) {
                    all.push(own);
                }
            }
        });
    }
}

/// Does the expression, or a definition in it, contain such a node?
pub(crate) fn mentions(model: &Model, expr: &Expr, wanted: &dyn Fn(&Expr) -> bool) -> bool {
    let mut found = false;
    visit(model, expr, &mut |e| found |= wanted(e));
    found
}
