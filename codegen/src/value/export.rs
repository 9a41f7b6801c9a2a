//! Classes -> expressions: builds the chosen definitions as nodes of the DAG.

use super::graph::{ClassId, Graph, Operation, Signed};
use crate::expr::{Dag, ExprId, Label, Node};
use crate::id::IdVec;
use rustc_hash::{FxHashMap as HashMap, FxHashSet as HashSet};

/// The expression built for a class: its value, or the negative of its value.
#[derive(Clone, Copy)]
struct Made {
    expr: ExprId,
    negative: bool,
}

/// Builds the live classes (operands first) and returns the roots' expressions.
///
/// `labels` says which classes have a label in the generated code, and with which sign; `norms`, which are lengths of
/// vectors.
pub(super) fn roots(
    graph: &Graph,
    dag: &mut Dag,
    live: &[ClassId],
    roots: &[Option<Signed>],
    (labels, norms): (&HashMap<ClassId, (bool, Label)>, &HashSet<ClassId>),
) -> Vec<ExprId> {
    let nothing = Made { expr: dag.zero(), negative: false };
    let mut made: IdVec<ClassId, Made> = graph.classes.ids().map(|_| nothing).collect();
    for &class in live {
        let label = labels.get(&class);
        let result = build(graph, dag, class, &made, label.is_some_and(|(negative, _)| *negative));
        if let Some((negative, label)) = label
            && *negative == result.negative
        {
            dag.label(result.expr, label.clone());
        }
        if norms.contains(&class) {
            dag.mark_norm(result.expr);
        }
        made[class] = result;
    }
    let mut root = |root: &Option<Signed>| match root {
        None => dag.zero(),
        Some(x) => signed(dag, made[x.class], x.negative),
    };
    roots.iter().map(&mut root).collect()
}

/// Builds a class from its definition in use. A difference is built in the order that gives the sign `wanted`.
fn build(graph: &Graph, dag: &mut Dag, class: ClassId, made: &IdVec<ClassId, Made>, wanted: bool) -> Made {
    let definition = graph.classes[class].current;
    let [x, y] = definition.operands;
    let of = |x: Signed| {
        let m = made[x.class];
        Made { negative: m.negative != x.negative, ..m }
    };
    let (expr, negative) = match definition.operation {
        Operation::Leaf(expr) => (expr, definition.negative),
        Operation::Sum => {
            let (a, b) = (of(x), of(y));
            match (a.negative, b.negative) {
                (false, false) => (dag.add(a.expr, b.expr), false),
                (true, true) => (dag.add(a.expr, b.expr), true),
                (minus, _) if minus != wanted => (dag.sub(b.expr, a.expr), wanted),
                _ => (dag.sub(a.expr, b.expr), wanted),
            }
        }
        Operation::Product | Operation::Quotient => {
            let (a, b) = (of(x), of(y));
            let product = definition.operation == Operation::Product;
            let expr = if product { dag.mul(a.expr, b.expr) } else { dag.div(a.expr, b.expr) };
            (expr, definition.negative ^ a.negative ^ b.negative)
        }
        Operation::Unary(f) => {
            let a = signed(dag, of(x), false);
            (dag.unary(f, a), definition.negative)
        }
        Operation::Binary(f) => {
            let (a, b) = (signed(dag, of(x), false), signed(dag, of(y), false));
            (dag.binary(f, a, b), definition.negative)
        }
    };
    match dag.node(expr) {
        Node::Negate(inner) => Made { expr: inner, negative: !negative },
        _ => Made { expr, negative },
    }
}

fn signed(dag: &mut Dag, x: Made, negative: bool) -> ExprId {
    if x.negative != negative { dag.negate(x.expr) } else { x.expr }
}
