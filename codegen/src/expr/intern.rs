//! The hash table from nodes to ids (open addressing; the arena alone holds the nodes), facts of a node, and a cache of
//! results of binary operations.

use super::node::{Binary, Dependence, ExprId, Node};
use crate::id::{Id, IdVec};
use rustc_hash::FxBuildHasher;
use std::hash::BuildHasher;

/// Initial number of slots: most mechanisms never outgrow it.
const SLOTS: usize = 1 << 14;
/// Marks an empty slot; any other entry is an id plus 1.
const FREE: u32 = 0;

/// A table of ids, at most half full.
#[derive(Clone, Debug)]
pub(super) struct Index(Vec<u32>);

impl Default for Index {
    fn default() -> Self {
        Self(vec![FREE; SLOTS])
    }
}

impl Index {
    /// The id of a node, or the slot where it belongs.
    #[inline]
    pub fn find(&self, nodes: &IdVec<ExprId, Node>, node: &Node) -> Result<ExprId, usize> {
        let last = self.0.len() - 1;
        let mut slot = hash(node) as usize & last;
        loop {
            if self.0[slot] == FREE {
                return Err(slot);
            }
            let id = ExprId::from_index(self.0[slot] as usize - 1);
            if nodes[id] == *node {
                return Ok(id);
            }
            slot = (slot + 1) & last;
        }
    }

    /// Puts the newest node into the slot that [`Index::find`] returned; rehashes into a larger table once it is half
    /// full.
    #[inline]
    pub fn insert(&mut self, slot: usize, nodes: &IdVec<ExprId, Node>) {
        self.0[slot] = nodes.len() as u32;
        if 2 * nodes.len() > self.0.len() {
            self.0 = vec![FREE; 2 * self.0.len()];
            for (id, node) in nodes.enumerate() {
                if let Err(slot) = self.find(nodes, node) {
                    self.0[slot] = id.index() as u32 + 1;
                }
            }
        }
    }
}

/// Facts of a node, computed when it is created.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facts {
    pub dependence: Dependence,
    /// Bit k is set if the node depends on a symbol whose index is k modulo 64.
    pub symbols_read: u64,
    /// The node itself if it is an operation; for a negation, the operation that is negated;
    /// [`super::node::NO_OPERATION`] for constants and symbols.
    pub operation: ExprId,
    /// The operations that its operands are, negations skipped.
    pub operations_read: [ExprId; 2],
    /// Has it got a label? Few nodes have.
    pub is_labelled: bool,
}

#[inline]
fn hash(node: &Node) -> u64 {
    match *node {
        Node::Binary(operator, a, b) => hash_operation(operator, [a, b]),
        Node::Unary(function, a) => spread((a.index() as u64) << 8 | function as u64),
        Node::Negate(a) => spread((a.index() as u64) << 8 | 0xFF),
        _ => FxBuildHasher.hash_one(node),
    }
}

#[inline]
fn hash_operation(operator: Binary, [a, b]: [ExprId; 2]) -> u64 {
    spread(((a.index() as u64) << 32 | b.index() as u64) ^ (operator as u64) << 61)
}

/// Hash by one multiplication: operands are small integers, and the upper bits of the product are used.
#[inline]
fn spread(key: u64) -> u64 {
    key.wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 32
}

/// Number of entries in the cache of results.
const RESULTS: usize = 1 << 11;

/// Direct-mapped cache of results of binary operations: most are asked for again soon.
#[derive(Clone, Debug)]
pub(super) struct Results(Vec<Option<(Binary, [ExprId; 2], ExprId)>>);

impl Default for Results {
    fn default() -> Self {
        Self(vec![None; RESULTS])
    }
}

impl Results {
    #[inline]
    fn place(operator: Binary, operands: [ExprId; 2]) -> usize {
        hash_operation(operator, operands) as usize % RESULTS
    }

    /// The cached result, if the entry at this place is of the same operation.
    #[inline]
    pub fn find(&self, operator: Binary, operands: [ExprId; 2]) -> Option<ExprId> {
        let (known, of, result) = self.0[Self::place(operator, operands)]?;
        (known == operator && of == operands).then_some(result)
    }

    #[inline]
    pub fn insert(&mut self, operator: Binary, operands: [ExprId; 2], result: ExprId) {
        self.0[Self::place(operator, operands)] = Some((operator, operands, result));
    }
}
