//! The arena of expression nodes (hash-consed): nodes, facts known of each, and what a set of roots depends on.
//!
//! Equal nodes exist once. The constructors, which first look for a simpler equal node, stand in `mod.rs`.

use super::intern::{Facts, Index, Results};
use super::label::Label;
use super::node::{Binary, Dependence, ExprId, NO_OPERATION, Node, SymbolId, Unary, symbol_bit};
use super::number::Number;
use super::set::NodeSet;
use crate::id::{Id, IdVec};
use rustc_hash::{FxHashMap as HashMap, FxHashSet as HashSet};

/// Capacity reserved, in nodes: address space that becomes memory only as it is filled.
const NODES: usize = 1 << 14;

/// The arena of nodes.
#[derive(Clone, Debug, Default)]
pub struct Dag {
    pub(super) nodes: IdVec<ExprId, Node>,
    pub(super) facts: IdVec<ExprId, Facts>,
    pub(super) index: Index,
    pub(super) results: Results,
    pub(super) zero: Option<ExprId>,
    pub(super) one: Option<ExprId>,
    pub(super) symbols: IdVec<SymbolId, (String, Dependence)>,
    pub(super) labels: HashMap<ExprId, Label>,
    pub(super) derivatives: HashMap<(ExprId, SymbolId), ExprId>,
    /// Roots that are the length of a vector which may vanish; see [`Dag::norm`].
    norms: HashSet<ExprId>,
    /// Sines and cosines of differences take them unrounded; see [`Dag::as_difference`].
    pub(crate) unrounded_differences: bool,
}

impl Dag {
    /// A new free symbol. Two symbols may share a name and are still different.
    pub fn symbol(&mut self, name: &str) -> ExprId {
        let symbol = self.symbols.push((name.to_owned(), Dependence::State));
        self.intern(Node::Symbol(symbol))
    }

    /// A new symbol that stands for a parameter.
    pub fn parameter(&mut self, name: &str) -> ExprId {
        let symbol = self.symbols.push((name.to_owned(), Dependence::Parameters));
        self.intern(Node::Symbol(symbol))
    }

    /// The length of a vector from its square. Its slope where it vanishes is 0, the mean over all directions: a drag
    /// |v| v has slopes at rest.
    pub fn norm(&mut self, square: ExprId) -> ExprId {
        let root = self.sqrt(square);
        self.mark_norm(root);
        root
    }

    /// Says that a root is the length of a vector; anything else is left as it is.
    pub(crate) fn mark_norm(&mut self, id: ExprId) {
        if matches!(self.node(id), Node::Unary(Unary::Sqrt, _)) {
            self.norms.insert(id);
        }
    }

    /// Is it the length of a vector which may vanish?
    #[inline]
    pub(crate) fn is_norm(&self, id: ExprId) -> bool {
        self.norms.contains(&id)
    }

    /// Number of nodes ever made.
    #[must_use]
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// No node yet?
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// The node behind an id.
    #[must_use]
    #[inline]
    pub fn node(&self, id: ExprId) -> Node {
        self.nodes[id]
    }

    /// Whether the value can change with the state, with parameters only, or not at all.
    #[must_use]
    #[inline]
    pub fn dependence(&self, id: ExprId) -> Dependence {
        self.facts[id].dependence
    }

    /// Name of a symbol.
    #[must_use]
    pub fn symbol_name(&self, symbol: SymbolId) -> &str {
        &self.symbols[symbol].0
    }

    /// The symbol that `id` is, if it is one.
    #[must_use]
    #[inline]
    pub fn as_symbol(&self, id: ExprId) -> Option<SymbolId> {
        match self.nodes[id] {
            Node::Symbol(symbol) => Some(symbol),
            _ => None,
        }
    }

    /// The constant that `id` is, if it is one.
    #[must_use]
    #[inline]
    pub fn as_number(&self, id: ExprId) -> Option<Number> {
        match self.nodes[id] {
            Node::Number(number) => Some(number),
            Node::Pi => Some(Number::from_f64(std::f64::consts::PI)),
            _ => None,
        }
    }

    /// Is it the constant 0?
    #[must_use]
    #[inline]
    pub fn is_zero(&self, id: ExprId) -> bool {
        Some(id) == self.zero
    }

    /// Is it the constant 1?
    #[must_use]
    #[inline]
    pub fn is_one(&self, id: ExprId) -> bool {
        Some(id) == self.one
    }

    /// May the node depend on the symbol? "No" is certain; "yes" is not.
    #[inline]
    pub(crate) fn may_depend(&self, id: ExprId, symbol: SymbolId) -> bool {
        self.may_read(id, symbol_bit(symbol))
    }

    /// May the node depend on one of the symbols with these bits? "No" is certain; "yes" is not (64 bits for all
    /// symbols).
    #[inline]
    pub(super) fn may_read(&self, id: ExprId, bits: u64) -> bool {
        self.facts[id].symbols_read & bits != 0
    }

    /// A constant.
    pub fn number(&mut self, number: Number) -> ExprId {
        let id = self.intern(Node::Number(number));
        match number {
            Number::ZERO => self.zero = Some(id),
            Number::ONE => self.one = Some(id),
            _ => {}
        }
        id
    }

    /// An f64 constant.
    pub fn constant(&mut self, x: f64) -> ExprId {
        self.number(Number::from_f64(x))
    }

    /// 0.
    #[inline]
    pub fn zero(&mut self) -> ExprId {
        self.zero.unwrap_or_else(|| self.number(Number::ZERO))
    }

    /// 1.
    #[inline]
    pub fn one(&mut self) -> ExprId {
        self.one.unwrap_or_else(|| self.number(Number::ONE))
    }

    /// Pi.
    pub fn pi(&mut self) -> ExprId {
        self.intern(Node::Pi)
    }

    /// The expression without its negation: a for -a and for a.
    #[must_use]
    #[inline]
    pub fn unsigned(&self, expr: ExprId) -> ExprId {
        if let Node::Negate(a) = self.nodes[expr] { a } else { expr }
    }

    /// Operands of a node.
    #[must_use]
    #[inline]
    pub fn operands(&self, id: ExprId) -> [Option<ExprId>; 2] {
        match self.nodes[id] {
            Node::Number(_) | Node::Pi | Node::Symbol(_) => [None, None],
            Node::Negate(a) | Node::Unary(_, a) => [Some(a), None],
            Node::Binary(_, a, b) => [Some(a), Some(b)],
        }
    }

    /// a and b, if the node is a - b, not a constant, and its sine and cosine shall be taken without rounding the
    /// difference (`Real::sin_cos_of_difference`).
    #[must_use]
    pub fn as_difference(&self, angle: ExprId) -> Option<[ExprId; 2]> {
        match self.nodes[angle] {
            Node::Binary(Binary::Sub, a, b) if self.unrounded_differences && !self.is_constant(angle) => {
                Some([a, b])
            }
            _ => None,
        }
    }

    /// All nodes that the roots need, in ascending (hence topological) order.
    #[must_use]
    pub fn reachable(&self, roots: &[ExprId]) -> Vec<ExprId> {
        self.reachable_above(roots, |_| false)
    }

    /// [`Self::reachable`], without the nodes below those for which `is_leaf` holds.
    #[must_use]
    pub fn reachable_above(&self, roots: &[ExprId], is_leaf: impl Fn(ExprId) -> bool) -> Vec<ExprId> {
        self.cone_above(roots, is_leaf).to_vec()
    }

    /// All nodes that the roots need, as a set.
    pub(crate) fn cone(&self, roots: &[ExprId]) -> NodeSet {
        self.cone_above(roots, |_| false)
    }

    /// [`Self::cone`], without the nodes below those for which `is_leaf` holds; `is_leaf` is called once per node.
    pub(crate) fn cone_above(&self, roots: &[ExprId], mut is_leaf: impl FnMut(ExprId) -> bool) -> NodeSet {
        let bound = roots.iter().map(|root| root.index() + 1).max().unwrap_or(0);
        let mut needed = NodeSet::below(bound);
        roots.iter().for_each(|&root| needed.insert(root));
        // Operands always have smaller ids than their node, so one sweep downwards marks everything.
        // A node that reads fewer than two names itself instead, which is in the set already.
        needed.sweep_down(|id| {
            let operands = if is_leaf(id) { [None, None] } else { self.operands(id) };
            operands.map(|operand| operand.unwrap_or(id))
        });
        needed
    }
}

impl Dag {
    /// The id of a node; adds the node if it does not exist yet.
    pub(super) fn intern(&mut self, node: Node) -> ExprId {
        let slot = match self.index.find(&self.nodes, &node) {
            Ok(id) => return id,
            Err(slot) => slot,
        };
        if self.nodes.is_empty() {
            self.nodes.reserve(NODES);
            self.facts.reserve(NODES);
        }
        let id = ExprId::from_index(self.nodes.len());
        let facts = self.facts_of(id, node);
        self.nodes.push(node);
        self.facts.push(facts);
        self.index.insert(slot, &self.nodes);
        id
    }

    /// The facts of a new node, from those of its operands.
    #[inline]
    fn facts_of(&self, id: ExprId, node: Node) -> Facts {
        let of = |a: ExprId| &self.facts[a];
        let (dependence, symbols_read, operations_read) = match node {
            Node::Number(_) | Node::Pi => (Dependence::Constant, 0, [NO_OPERATION; 2]),
            Node::Symbol(symbol) => (self.symbols[symbol].1, symbol_bit(symbol), [NO_OPERATION; 2]),
            Node::Negate(a) | Node::Unary(_, a) => {
                (of(a).dependence, of(a).symbols_read, [of(a).operation, NO_OPERATION])
            }
            Node::Binary(_, a, b) => {
                let (a, b) = (of(a), of(b));
                let dependence = a.dependence.max(b.dependence);
                (dependence, a.symbols_read | b.symbols_read, [a.operation, b.operation])
            }
        };
        let operation = match node {
            Node::Negate(_) => operations_read[0],
            Node::Unary(..) | Node::Binary(..) if dependence != Dependence::Constant => id,
            _ => NO_OPERATION,
        };
        Facts { dependence, symbols_read, operation, operations_read, is_labelled: false }
    }
}

impl Dag {
    /// Labels a node for the generated code; constants and symbols need none.
    pub fn label(&mut self, id: ExprId, label: Label) {
        if matches!(self.nodes[id], Node::Number(_) | Node::Symbol(_) | Node::Pi) {
            return;
        }
        match self.labels.get_mut(&id) {
            Some(known) => known.join(&label),
            None => {
                self.labels.insert(id, label);
                self.facts[id].is_labelled = true;
            }
        }
    }

    /// The label of a node.
    #[must_use]
    #[inline]
    pub fn label_of(&self, id: ExprId) -> Option<&Label> {
        if self.facts[id].is_labelled { self.labels.get(&id) } else { None }
    }

    /// The name of a node.
    #[must_use]
    pub fn name_of(&self, id: ExprId) -> Option<&str> {
        self.label_of(id)?.name()
    }
}
