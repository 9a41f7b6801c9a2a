//! Sets of nodes as bit sets: a cone is a few machine words, so cones are walked, united and compared word by word.

use super::node::ExprId;
use crate::id::Id;

/// Nodes in one word.
const WORD: usize = u64::BITS as usize;

/// A set of nodes.
#[derive(Clone, Debug, Default)]
pub(crate) struct NodeSet(Vec<u64>);

impl NodeSet {
    /// The empty set, with room for nodes below `bound`.
    pub fn below(bound: usize) -> Self {
        // Memory that is asked for as zeroed bypasses the allocator's cache of small blocks.
        Self(std::iter::repeat_n(0, bound.div_ceil(WORD)).collect())
    }

    /// Adds a node below the bound.
    #[inline]
    pub fn insert(&mut self, id: ExprId) {
        self.0[id.index() / WORD] |= 1 << (id.index() % WORD);
    }

    /// Is a node below the bound in the set?
    #[inline]
    pub fn contains(&self, id: ExprId) -> bool {
        self.0[id.index() / WORD] >> (id.index() % WORD) & 1 == 1
    }

    /// Adds the nodes of another set.
    pub fn unite(&mut self, other: &Self) {
        if self.0.len() < other.0.len() {
            self.0.resize(other.0.len(), 0);
        }
        self.0.iter_mut().zip(&other.0).for_each(|(mine, theirs)| *mine |= theirs);
    }

    /// Takes a node below the bound out.
    #[inline]
    pub fn remove(&mut self, id: ExprId) {
        self.0[id.index() / WORD] &= !(1 << (id.index() % WORD));
    }

    /// How many nodes of this set are not in another.
    pub fn count_without(&self, other: &Self) -> usize {
        let theirs = other.0.iter().copied().chain(std::iter::repeat(0));
        let words = self.0.iter().zip(theirs).map(|(mine, theirs)| mine & !theirs);
        count(words)
    }

    /// The number of nodes.
    pub fn len(&self) -> usize {
        count(self.0.iter().copied())
    }

    /// The nodes, ascending, as a list.
    pub fn to_vec(&self) -> Vec<ExprId> {
        let mut list = Vec::with_capacity(self.len());
        for (k, &word) in self.0.iter().enumerate() {
            let mut left = word;
            while left != 0 {
                list.push(ExprId::from_index(k * WORD + left.trailing_zeros() as usize));
                left &= left - 1;
            }
        }
        list
    }

    /// The nodes, ascending.
    pub fn iter(&self) -> impl Iterator<Item = ExprId> {
        self.0.iter().enumerate().flat_map(|(k, &word)| {
            let mut left = word;
            std::iter::from_fn(move || {
                let bit = (left != 0).then(|| left.trailing_zeros() as usize)?;
                left &= left - 1;
                Some(ExprId::from_index(k * WORD + bit))
            })
        })
    }

    /// Visits the nodes in descending order; `operands` may add nodes smaller than the one it is given.
    pub fn sweep_down<I: IntoIterator<Item = ExprId>>(&mut self, mut operands: impl FnMut(ExprId) -> I) {
        for k in (0..self.0.len()).rev() {
            // Bits at and above the current node are done; bits below it may still be set by it.
            let mut below = u64::MAX;
            while self.0[k] & below != 0 {
                let bit = u64::BITS - 1 - (self.0[k] & below).leading_zeros();
                below = (1 << bit) - 1;
                for operand in operands(ExprId::from_index(k * WORD + bit as usize)) {
                    self.insert(operand);
                }
            }
        }
    }
}

/// The number of nodes in some words.
fn count(words: impl Iterator<Item = u64>) -> usize {
    // Most words are empty; skipping them is faster than counting their bits.
    words.filter(|word| *word != 0).map(|word| word.count_ones() as usize).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn set(ids: &[usize]) -> NodeSet {
        let mut set = NodeSet::below(ids.iter().max().map_or(0, |most| most + 1));
        ids.iter().for_each(|&id| set.insert(ExprId::from_index(id)));
        set
    }

    fn ids(set: &NodeSet) -> Vec<usize> {
        set.iter().map(Id::index).collect()
    }

    #[test]
    fn sets_of_unequal_length_are_united_and_compared() {
        let (short, long) = (set(&[0, 5, 63]), set(&[5, 64, 200]));
        let mut both = short.clone();
        both.unite(&long);
        assert_eq!(ids(&both), [0, 5, 63, 64, 200]);
        assert_eq!((short.count_without(&long), long.count_without(&short)), (2, 2));
    }

    #[test]
    fn a_sweep_reaches_what_nodes_on_the_way_add() {
        // Every node reads its half and the one before: all below an odd root, in its word and in others.
        let mut cone = set(&[131]);
        cone.sweep_down(|id| match id.index() {
            0 => Vec::new(),
            n if n % 2 == 0 => vec![ExprId::from_index(n / 2)],
            n => [n / 2, n - 1].map(ExprId::from_index).to_vec(),
        });
        assert_eq!(ids(&cone), [0, 1, 2, 4, 8, 16, 32, 64, 65, 130, 131]);
    }
}
