//! Shares reciprocals: x/d, y/d -> r = 1/d, x r, y r.
//!
//! A division takes as long as ten to fifteen multiplications on the targets; one more operation in the count replaces
//! all but one of the divisions by the same divisor. The reciprocal of a divisor that depends on parameters alone is
//! prepared, so that every division by it is replaced.

use super::derived::Program;
use crate::expr::{Binary, Dependence, ExprId, Node};
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
    let image = program.dag.rebuild_in(&order, |dag, id, image| match dag.node(id) {
        Node::Binary(Binary::Div, a, divisor)
            if quotients[&divisor] > 1 || dag.dependence(divisor) == Dependence::Parameters =>
        {
            let one = dag.one();
            let reciprocal = dag.div(one, image.of(divisor));
            Some(dag.mul(image.of(a), reciprocal))
        }
        _ => None,
    });
    program.map_roots(|e| image.of(e));
    for pivot in &mut program.pivots {
        pivot.value = image.of(pivot.value);
    }
}
