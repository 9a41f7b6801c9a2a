//! Replacing symbols by expressions, rebuilding (and so simplifying) what depends on them.

use super::{Dag, ExprId, Node, SymbolId};
use crate::id::Id;
use rustc_hash::FxHashMap as HashMap;

impl Dag {
    /// `roots` with every symbol of `replacement` replaced, once, by its expression.
    pub fn substitute(&mut self, roots: &[ExprId], replacement: &HashMap<SymbolId, ExprId>) -> Vec<ExprId> {
        let order = self.reachable(roots);
        let mut image: Vec<Option<ExprId>> = vec![None; order.last().map_or(0, |id| id.index() + 1)];
        for &id in &order {
            let of = |a: ExprId| image[a.index()].unwrap_or(a);
            let new = match self.node(id) {
                Node::Number(_) | Node::Pi => id,
                Node::Symbol(symbol) => replacement.get(&symbol).copied().unwrap_or(id),
                Node::Negate(a) => match of(a) {
                    x if x == a => id,
                    x => self.negate(x),
                },
                Node::Unary(function, a) => match of(a) {
                    x if x == a => id,
                    x => self.unary(function, x),
                },
                Node::Binary(operator, a, b) => match (of(a), of(b)) {
                    (x, y) if x == a && y == b => id,
                    (x, y) => self.binary(operator, x, y),
                },
            };
            if new != id
                && let Some(name) = self.name_of(id).map(str::to_owned)
            {
                self.name(new, &name);
            }
            image[id.index()] = Some(new);
        }
        roots.iter().map(|r| image[r.index()].unwrap_or(*r)).collect()
    }
}
