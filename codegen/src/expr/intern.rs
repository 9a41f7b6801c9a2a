//! Ids by node: open addressing over the arena, which alone holds the nodes. What is known of a node, and results of
//! operations.

use super::node::{Binary, Dependence, ExprId, Node};
use crate::id::{Id, IdVec};
use rustc_hash::FxBuildHasher;
use std::hash::BuildHasher;

/// Slots at the start: most mechanisms never grow them.
const SLOTS: usize = 1 << 15;
/// Nothing here yet; else an id and 1.
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

    /// Puts the newest node where [`Index::find`] said; every node goes to a new place if that half fills the table.
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

/// What is known of a node since it was made.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facts {
    pub dependence: Dependence,
    /// Bit k is set if it depends on a symbol whose index is k modulo 64.
    pub symbols_read: u64,
    /// Itself if it is an operation, what it is the negative of; [`super::node::NO_OPERATION`] for constants and symbols.
    pub operation: ExprId,
    /// The operations that its operands are.
    pub operations_read: [ExprId; 2],
}

fn hash(node: &Node) -> u64 {
    match *node {
        Node::Binary(operator, a, b) => hash_operation(operator, [a, b]),
        Node::Unary(function, a) => spread((a.index() as u64) << 8 | function as u64),
        Node::Negate(a) => spread((a.index() as u64) << 8 | 0xFF),
        _ => FxBuildHasher.hash_one(node),
    }
}

fn hash_operation(operator: Binary, [a, b]: [ExprId; 2]) -> u64 {
    spread(((a.index() as u64) << 32 | b.index() as u64) ^ (operator as u64) << 61)
}

/// A hash by one multiplication: operands are small numbers, and their upper bits are wanted.
fn spread(key: u64) -> u64 {
    key.wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 32
}

/// Places for results of operations.
const RESULTS: usize = 1 << 11;

/// What operations on two operands have given: most are asked for again before long.
#[derive(Clone, Debug)]
pub(super) struct Results(Vec<Option<(Binary, [ExprId; 2], ExprId)>>);

impl Default for Results {
    fn default() -> Self {
        Self(vec![None; RESULTS])
    }
}

impl Results {
    fn place(operator: Binary, operands: [ExprId; 2]) -> usize {
        hash_operation(operator, operands) as usize % RESULTS
    }

    /// The result, if the last operation at its place was this one.
    pub fn find(&self, operator: Binary, operands: [ExprId; 2]) -> Option<ExprId> {
        let (known, of, result) = self.0[Self::place(operator, operands)]?;
        (known == operator && of == operands).then_some(result)
    }

    pub fn insert(&mut self, operator: Binary, operands: [ExprId; 2], result: ExprId) {
        self.0[Self::place(operator, operands)] = Some((operator, operands, result));
    }
}
