//! Rebuilds expressions with some nodes replaced; the rebuilt nodes are simplified again.

use super::{Dag, ExprId, Node, SymbolId};
use crate::id::Id;
use rustc_hash::FxHashMap as HashMap;

/// The map from old nodes to new ones: the image of every node that was rebuilt, the node itself elsewhere.
pub struct Image(Vec<ExprId>);

impl Image {
    /// The image of `id`.
    #[must_use]
    pub fn of(&self, id: ExprId) -> ExprId {
        self.0.get(id.index()).copied().unwrap_or(id)
    }
}

impl Dag {
    /// Rebuilds everything that `roots` need, operands first. `replace` may return another image for a node than its
    /// operator applied to the images of its operands. Names are carried over.
    pub fn rebuild(
        &mut self,
        roots: &[ExprId],
        replace: impl FnMut(&mut Self, ExprId, &Image) -> Option<ExprId>,
    ) -> Image {
        let order = self.reachable(roots);
        self.rebuild_in(&order, replace)
    }

    /// [`Self::rebuild`] of these nodes, which are all that some roots need, operands first.
    pub fn rebuild_in(
        &mut self,
        order: &[ExprId],
        mut replace: impl FnMut(&mut Self, ExprId, &Image) -> Option<ExprId>,
    ) -> Image {
        let n = order.last().map_or(0, |id| id.index() + 1);
        let mut image = Image((0..n).map(ExprId::from_index).collect());
        for &id in order {
            let new = match replace(self, id, &image) {
                Some(new) => new,
                None => self.with_operands(id, &image),
            };
            if new != id
                && let Some(label) = self.label_of(id).cloned()
            {
                self.label(new, label);
            }
            if new != id && self.is_norm(id) {
                self.mark_norm(new);
            }
            image.0[id.index()] = new;
        }
        image
    }

    /// The same operator on the images of its operands.
    fn with_operands(&mut self, id: ExprId, image: &Image) -> ExprId {
        match self.node(id) {
            Node::Number(_) | Node::Pi | Node::Symbol(_) => id,
            Node::Negate(a) if image.of(a) == a => id,
            Node::Negate(a) => self.negate(image.of(a)),
            Node::Unary(_, a) if image.of(a) == a => id,
            Node::Unary(function, a) => self.unary(function, image.of(a)),
            Node::Binary(_, a, b) if image.of(a) == a && image.of(b) == b => id,
            Node::Binary(operator, a, b) => self.binary(operator, image.of(a), image.of(b)),
        }
    }

    /// `roots` with every symbol in `replacement` replaced by its expression, whose own symbols are not replaced again.
    pub fn substitute(&mut self, roots: &[ExprId], replacement: &HashMap<SymbolId, ExprId>) -> Vec<ExprId> {
        let image = self.rebuild(roots, |dag, id, _| replacement.get(&dag.as_symbol(id)?).copied());
        roots.iter().map(|&root| image.of(root)).collect()
    }

    /// Copies `roots` of another DAG into this one; `of_symbol` gives the expression for each of the other's symbols.
    pub fn graft(
        &mut self,
        other: &Self,
        roots: &[ExprId],
        of_symbol: &HashMap<SymbolId, ExprId>,
    ) -> Option<Vec<ExprId>> {
        let mut image: HashMap<ExprId, ExprId> = HashMap::default();
        for id in other.reachable(roots) {
            let new = match other.node(id) {
                Node::Number(number) => self.number(number),
                Node::Pi => self.pi(),
                Node::Symbol(symbol) => *of_symbol.get(&symbol)?,
                Node::Negate(a) => self.negate(image[&a]),
                Node::Unary(function, a) => self.unary(function, image[&a]),
                Node::Binary(operator, a, b) => self.binary(operator, image[&a], image[&b]),
            };
            if other.is_norm(id) {
                self.mark_norm(new);
            }
            image.insert(id, new);
        }
        Some(roots.iter().map(|root| image[root]).collect())
    }
}
