//! Ids by node: open addressing over the arena, which alone holds the nodes.

use super::{ExprId, Node};
use crate::id::{Id, IdVec};
use rustc_hash::FxBuildHasher;
use std::hash::BuildHasher;

/// Slots at the start: a small mechanism never grows them.
const SLOTS: usize = 1 << 12;
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
        let mut slot = FxBuildHasher.hash_one(node) as usize & last;
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
