//! Prepared values: what depends on parameters alone, computed once and again when a parameter changes.
//!
//! An evaluation uses the values at the border: those that depend on parameters only and are operands of something that
//! depends on the state. All operations below that border belong to `prepare()`.

use super::derived::Program;
use crate::expr::{Dag, Dependence, ExprId, Node, NodeSet};

impl Program {
    /// The values that must be prepared for `roots`, including tunable parameters that are used directly, in ascending
    /// order.
    #[must_use]
    pub fn prepared(&self, roots: &[ExprId]) -> Vec<ExprId> {
        let dag = &self.dag;
        let mut border = NodeSet::below(dag.len());
        for id in dag.cone_above(roots, |id| dag.dependence(id) != Dependence::State).iter() {
            if dag.dependence(id) == Dependence::State {
                dag.operands(id).into_iter().flatten().for_each(|a| border.insert(unsigned(dag, a)));
            }
        }
        roots.iter().for_each(|&root| border.insert(unsigned(dag, root)));
        border.iter().filter(|&id| dag.dependence(id) == Dependence::Parameters).collect()
    }
}

/// The node without its negations, which are free.
fn unsigned(dag: &Dag, mut id: ExprId) -> ExprId {
    while let Node::Negate(a) = dag.node(id) {
        id = a;
    }
    id
}
