//! Sorts parameters, definitions, frames and points into an order in which they can be computed.
//!
//! In: a draft model. Out: its entities, each after all that it refers to. Closures of points are equations, not
//! computations, and do not take part; a frame comes after the vectors that are fixed in it. A coordinate with a closed
//! form counts as a reference to everything in that form.

use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::data::*;
use crate::model::expression::{Expr, ExprKind};
use crate::model::ids::*;
use crate::model::walk::Role;
use crate::source::Span;

/// An entity or a coordinate with a closed form.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Node {
    Parameter(ParameterId),
    Definition(DefinitionId),
    Frame(FrameId),
    Point(PointId),
    Coordinate(CoordinateId),
}

/// By node: the nodes that it refers to, with the places.
type References = BTreeMap<Node, Vec<(Node, Span)>>;

/// Sorts the entities; a cycle is an error that names its members.
pub fn sort(model: &Model, found: &mut Diagnostics) -> Vec<Entity> {
    let mut state: BTreeMap<Node, bool> = BTreeMap::new();
    let mut order = Vec::new();
    let references = references(model);
    for root in all(model) {
        visit(model, &references, root, &mut state, &mut order, found);
    }
    order
}

fn all(model: &Model) -> Vec<Node> {
    let mut nodes: Vec<Node> = model.parameters.ids().map(Node::Parameter).collect();
    nodes.extend(model.coordinates.ids().map(Node::Coordinate));
    nodes.extend(model.frames.ids().map(Node::Frame));
    nodes.extend(model.points.ids().map(Node::Point));
    nodes.extend(model.definitions.ids().map(Node::Definition));
    nodes
}

/// Depth-first search with an explicit stack; `state` is false while a node is on the stack, true once it is done.
fn visit(
    model: &Model,
    references: &References,
    root: Node,
    state: &mut BTreeMap<Node, bool>,
    order: &mut Vec<Entity>,
    found: &mut Diagnostics,
) {
    if state.contains_key(&root) {
        return;
    }
    state.insert(root, false);
    let of = |node: Node| references.get(&node).map_or(&[][..], Vec::as_slice);
    let mut stack = vec![(root, of(root), 0)];
    while let Some((node, next, at)) = stack.last_mut() {
        let node = *node;
        let Some((reference, _)) = next.get(*at).copied() else {
            state.insert(node, true);
            order.extend(entity(model, node));
            stack.pop();
            continue;
        };
        *at += 1;
        match state.get(&reference) {
            None => {
                state.insert(reference, false);
                stack.push((reference, of(reference), 0));
            }
            Some(false) => {
                let start = stack.iter().position(|(n, ..)| *n == reference).unwrap_or(0);
                let cycle: Vec<(Node, Span)> =
                    stack[start..].iter().map(|(n, r, at)| (*n, r[at - 1].1)).collect();
                found.push(report(model, &cycle));
            }
            Some(true) => {}
        }
    }
}

fn entity(model: &Model, node: Node) -> Option<Entity> {
    match node {
        Node::Parameter(id) => Some(Entity::Parameter(id)),
        Node::Definition(id) => Some(Entity::Definition(id)),
        Node::Frame(id) => Some(Entity::Frame(id)),
        Node::Point(id) => Some(Entity::Point(id)),
        Node::Coordinate(id) => model.coordinates[id].closed_form.as_ref().map(|_| Entity::Coordinate(id)),
    }
}

fn report(model: &Model, cycle: &[(Node, Span)]) -> Diagnostic {
    let name = |node: Node| match node {
        Node::Parameter(id) => &model.parameters[id].name,
        Node::Definition(id) => &model.definitions[id].name,
        Node::Frame(id) => &model.frames[id].name,
        Node::Point(id) => &model.points[id].name,
        Node::Coordinate(id) => &model.coordinates[id].name,
    };
    let first = cycle.first().map_or("", |(node, _)| name(*node));
    let path: Vec<&str> = cycle.iter().map(|(node, _)| name(*node).as_str()).chain([first]).collect();
    let message = format!("cyclic definition: {}", path.join(" -> "));
    let mut error = Diagnostic::error(message).help("nothing can be computed from itself: break the cycle");
    for (i, (node, span)) in cycle.iter().enumerate().take(6) {
        let next = cycle.get(i + 1).map_or(first, |(n, _)| name(*n));
        error = error.label(*span, format!("`{}` needs `{next}`", name(*node)));
    }
    error
}

/// The references of each node, with their places.
fn references(model: &Model) -> References {
    let mut all = References::new();
    for (id, frame) in model.frames.enumerate() {
        if let Some(parent) = frame.orientation.parent() {
            all.entry(Node::Frame(id)).or_default().push((Node::Frame(parent), frame.span));
        }
    }
    for (role, expression) in model.expressions() {
        let node = match role {
            Role::Parameter(id) => Node::Parameter(id),
            Role::Definition(id) => Node::Definition(id),
            Role::Orientation(id, _) | Role::FixedVector(id, _) | Role::FixedComponent(id, _) => {
                Node::Frame(id)
            }
            Role::Position(id) | Role::StatedVelocity(id) => Node::Point(id),
            Role::ClosedForm(id) => Node::Coordinate(id),
            _ => continue,
        };
        collect(expression, all.entry(node).or_default());
    }
    all
}

fn collect(expr: &Expr, into: &mut Vec<(Node, Span)>) {
    expr.visit(&mut |e| {
        let node = match &e.kind {
            ExprKind::Parameter(id) => Node::Parameter(*id),
            ExprKind::Definition(id) => Node::Definition(*id),
            ExprKind::Point(id) | ExprKind::Velocity(id) => Node::Point(*id),
            ExprKind::Axis(id, _) | ExprKind::AngularVelocity(id) => Node::Frame(*id),
            ExprKind::Coordinate(id) | ExprKind::Rate(id) => Node::Coordinate(*id),
            _ => return,
        };
        into.push((node, e.span));
    });
}
