//! Shared reciprocals: x/d, y/d -> r = 1/d, x r, y r.
//!
//! A division costs ten to fifteen multiplications on the targets; one more operation in the count
//! buys all but one of the divisions by the same divisor.

use super::Program;
use crate::expr::{Binary, ExprId, Node};
use crate::id::Id;
use rustc_hash::FxHashMap as HashMap;

/// Rewrites all answers of a program.
pub(super) fn share(program: &mut Program) {
    let roots = program.all_roots();
    let order = program.dag.reachable(&roots);
    let mut quotients: HashMap<ExprId, usize> = HashMap::default();
    for &id in &order {
        if let Node::Binary(Binary::Div, _, divisor) = program.dag.node(id) {
            *quotients.entry(divisor).or_insert(0) += 1;
        }
    }
    let dag = &mut program.dag;
    let mut image: Vec<ExprId> =
        (0..order.last().map_or(0, |id| id.index() + 1)).map(ExprId::from_index).collect();
    for &id in &order {
        let of = |a: ExprId| image[a.index()];
        let new = match dag.node(id) {
            Node::Number(_) | Node::Pi | Node::Symbol(_) => id,
            Node::Negate(a) => dag.negate(of(a)),
            Node::Unary(function, a) => dag.unary(function, of(a)),
            Node::Binary(Binary::Div, a, divisor) if quotients[&divisor] > 1 => {
                let one = dag.one();
                let reciprocal = dag.div(one, of(divisor));
                dag.mul(of(a), reciprocal)
            }
            Node::Binary(operator, a, b) => dag.binary(operator, of(a), of(b)),
        };
        if new != id
            && let Some(name) = dag.name_of(id).map(str::to_owned)
        {
            dag.name(new, &name);
        }
        image[id.index()] = new;
    }
    program.map_roots(|e| image[e.index()]);
    for pivot in &mut program.pivots {
        pivot.value = image.get(pivot.value.index()).copied().unwrap_or(pivot.value);
    }
}
