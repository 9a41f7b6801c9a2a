//! Operation counts: + - * / sqrt sin cos and the other functions count 1 each, negation 0.

use super::{Dag, Dependence, ExprId, Node};
use rustc_hash::FxHashSet as HashSet;
use std::collections::BTreeMap;

impl Dag {
    /// Operations needed for `roots` together at every evaluation, shared parts once: what depends
    /// on parameters alone is computed when they change.
    #[must_use]
    pub fn state_cost(&self, roots: &[ExprId]) -> usize {
        let of_state = |&&id: &&ExprId| self.dependence(id) == Dependence::State && self.is_operation(id);
        self.reachable(roots).iter().filter(of_state).count()
    }

    /// Operations needed for `roots` together, shared parts once.
    #[must_use]
    pub fn cone_cost(&self, roots: &[ExprId]) -> usize {
        let mut seen = HashSet::default();
        let mut stack: Vec<ExprId> = roots.to_vec();
        let mut operations = 0;
        while let Some(id) = stack.pop() {
            if !seen.insert(id) {
                continue;
            }
            operations += usize::from(self.is_operation(id));
            stack.extend(self.operands(id).into_iter().flatten());
        }
        operations
    }

    /// Does the node cost an operation at run time? Constants and negations do not.
    #[must_use]
    pub fn is_operation(&self, id: ExprId) -> bool {
        matches!(self.node(id), Node::Unary(..) | Node::Binary(..)) && !self.is_constant(id)
    }

    /// Free of symbols?
    #[must_use]
    pub fn is_constant(&self, id: ExprId) -> bool {
        self.dependence(id) == Dependence::Constant
    }

    /// Operations of `roots` with this dependence, by kind.
    #[must_use]
    pub fn operations_by_kind(
        &self,
        roots: &[ExprId],
        dependence: Dependence,
    ) -> BTreeMap<&'static str, usize> {
        let mut counts = BTreeMap::new();
        let counted = |&id: &ExprId| self.is_operation(id) && self.dependence(id) == dependence;
        for id in self.reachable(roots).into_iter().filter(counted) {
            let kind = match self.node(id) {
                Node::Unary(function, _) => super::print::unary_name(function),
                Node::Binary(operator, ..) => super::print::binary_name(operator),
                _ => continue,
            };
            *counts.entry(kind).or_insert(0) += 1;
        }
        counts
    }
}
