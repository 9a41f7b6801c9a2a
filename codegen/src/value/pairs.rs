//! One-operation resubstitution: a live value that is the sum, difference or product of two others.

use super::field::Field;
use super::graph::{ClassId, Graph, Operation, Signed, Value};
use crate::id::Id;
use rustc_hash::FxHashSet as HashSet;

/// Bits of a key that the filter looks at.
const FILTER_BITS: u32 = 17;

/// A set of keys that answers most questions about absent ones from the first-level cache.
struct Filter(Vec<u64>);

impl Filter {
    fn new() -> Self {
        Self(vec![0; (1 << FILTER_BITS) / 64])
    }
    fn place(key: Field) -> (usize, u64) {
        let bits = key.bits() & ((1 << FILTER_BITS) - 1);
        ((bits / 64) as usize, 1 << (bits % 64))
    }
    fn insert(&mut self, key: Field) {
        for key in [key, -key] {
            let (word, bit) = Self::place(key);
            self.0[word] |= bit;
        }
    }
    fn may_hold(&self, key: Field) -> bool {
        let (word, bit) = Self::place(key);
        self.0[word] & bit != 0
    }
}

/// Proposes every sum, difference and product of two classes that is itself among the classes.
///
/// Pairs of classes that are not `new` have been looked at before.
pub(super) fn resubstitute(graph: &mut Graph, classes: &[ClassId], new: &[ClassId]) {
    let new: HashSet<ClassId> = new.iter().copied().collect();
    let is_new: Vec<bool> = classes.iter().map(|c| new.contains(c)).collect();
    let values: Vec<Value> = classes.iter().map(|&c| graph.classes[c].value).collect();
    let mut filter = Filter::new();
    let mut is_target = vec![false; graph.classes.len()];
    for (&class, value) in classes.iter().zip(&values) {
        if !graph.classes[class].is_leaf() {
            filter.insert(value[0]);
            is_target[class.index()] = true;
        }
    }
    let signed = |class: ClassId, negative: bool| Signed { class, negative };
    for (i, &a) in classes.iter().enumerate() {
        for (j, &b) in classes.iter().enumerate().skip(i) {
            if !is_new[i] && !is_new[j] {
                continue;
            }
            let (x, y) = (values[i][0], values[j][0]);
            let mut offer = |operation: Operation, minus: bool| {
                let (a, b) = (signed(a, false), signed(b, minus));
                let value = graph.apply(operation, a, b);
                let target = value.and_then(|value| graph.find(value));
                if let Some(target) = target
                    && is_target.get(target.class.index()) == Some(&true)
                {
                    graph.propose(target, operation, a, b);
                }
            };
            if filter.may_hold(x * y) {
                offer(Operation::Product, false);
            }
            if i != j && filter.may_hold(x + y) {
                offer(Operation::Sum, false);
            }
            if i != j && filter.may_hold(x - y) {
                offer(Operation::Sum, true);
            }
        }
    }
}
