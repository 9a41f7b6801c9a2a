//! One-operation resubstitution over all pairs: a live value as the sum, difference or product of two others.

use super::field::Field;
use super::graph::{ClassId, Graph, Operation, Signed};
use crate::id::Id;
use rustc_hash::FxHashMap as HashMap;

/// Number of bits of a key that index the filter.
const FILTER_BITS: u32 = 17;

/// Words of the filter.
const WORDS: usize = 1 << (FILTER_BITS - 6);

/// A Bloom filter for keys; it answers most questions about absent keys from the first-level cache.
struct Filter(Box<[u64; WORDS]>);

impl Filter {
    fn new() -> Self {
        Self(Box::new([0; WORDS]))
    }
    fn insert(&mut self, key: Field) {
        for key in [key.bits(), (-key).bits()] {
            self.0[key as usize / 64 % WORDS] |= 1 << (key % 64);
        }
    }
    fn may_hold(&self, key: Field) -> bool {
        self.0[key.bits() as usize / 64 % WORDS] >> (key.bits() % 64) & 1 == 1
    }
}

/// All values met so far, and all pairs whose sum, difference or product is among them. Kept over the rounds, so that a
/// pair is tested once.
pub(super) struct Pairs {
    /// The values, with canonical signs, and their inverses.
    values: Vec<(Field, Field)>,
    place: HashMap<Field, usize>,
    filter: Filter,
    /// Index pairs of values whose sum, difference or product is a third one.
    found: Vec<[usize; 2]>,
}

impl Pairs {
    pub fn new() -> Self {
        Self { values: Vec::new(), place: HashMap::default(), filter: Filter::new(), found: Vec::new() }
    }

    /// Index of a non-zero value; a new value is combined with all values met before.
    fn index_of(&mut self, x: Field) -> usize {
        let new = self.values.len();
        if let Some(&known) = self.place.get(&x) {
            return known;
        }
        self.filter.insert(x);
        self.place.insert(x, new);
        self.values.push((x, x.inverse().unwrap_or(Field::ZERO)));
        for (other, &(y, inverse)) in self.values.iter().enumerate() {
            // A single branch for all four combinations, which is rarely taken.
            let [sum, difference, product, quotient] = [x + y, x - y, x * y, x * inverse];
            let may_hold = |value| self.filter.may_hold(value);
            if may_hold(sum) | may_hold(difference) | may_hold(product) | may_hold(quotient) {
                let place_of = |value: Field| self.place.get(&value.canonical()).copied();
                for third in [sum, difference].into_iter().filter_map(place_of) {
                    self.found.extend([[new, other], [new, third], [other, third]]);
                }
                self.found.extend(place_of(product).map(|_| [new, other]));
                self.found.extend(place_of(quotient).map(|factor| [other, factor]));
            }
        }
        new
    }

    /// Proposes every sum, difference and product of two classes that is itself a class.
    ///
    /// Pairs without a `new` class have been proposed before.
    pub fn resubstitute(&mut self, graph: &mut Graph, classes: &[ClassId], new: &[ClassId]) {
        let mut is_new = vec![false; graph.classes.len()];
        new.iter().for_each(|class| is_new[class.index()] = true);
        let mut is_target = vec![false; graph.classes.len()];
        for &class in classes.iter().filter(|&&class| !graph.classes[class].is_leaf()) {
            is_target[class.index()] = true;
        }
        let places: Vec<usize> = classes.iter().map(|&c| self.index_of(graph.classes[c].value[0])).collect();
        // Several classes may have the same value, if the guard keeps them apart.
        let mut with_value: Vec<Vec<usize>> = vec![Vec::new(); self.values.len()];
        places.iter().enumerate().for_each(|(i, &place)| with_value[place].push(i));
        let mut pairs: Vec<(usize, usize)> = Vec::new();
        for &[p, q] in &self.found {
            for &i in &with_value[p] {
                pairs.extend(with_value[q].iter().map(|&j| (i.min(j), i.max(j))));
            }
        }
        // Sorted by class, so that the result does not depend on the order of discovery.
        pairs.retain(|&(i, j)| is_new[classes[i].index()] || is_new[classes[j].index()]);
        pairs.sort_unstable();
        pairs.dedup();
        for (i, j) in pairs {
            offer(graph, &is_target, [classes[i], classes[j]]);
        }
    }
}

/// Proposes a b, a + b and a - b as definitions of the classes that have their values, if these are targets.
fn offer(graph: &mut Graph, is_target: &[bool], [a, b]: [ClassId; 2]) {
    for (operation, minus) in [(Operation::Product, false), (Operation::Sum, false), (Operation::Sum, true)] {
        if operation == Operation::Sum && a == b {
            continue;
        }
        let (a, b) = (Signed { class: a, negative: false }, Signed { class: b, negative: minus });
        let target = graph.apply(operation, a, b).and_then(|value| graph.find(value));
        if let Some(target) = target
            && is_target.get(target.class.index()) == Some(&true)
        {
            graph.propose(target, operation, a, b);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn relations_are_found_whichever_value_comes_last() {
        let [a, b] = [3, 11].map(Field::new);
        let values = [a, b, (a + b).canonical(), (a - b).canonical(), (a * b).canonical()];
        for last in 0..values.len() {
            let mut order: Vec<Field> = values.to_vec();
            order.rotate_left(last);
            let mut pairs = Pairs::new();
            let places: Vec<usize> = order.iter().map(|&x| pairs.index_of(x)).collect();
            assert_eq!(places, [0, 1, 2, 3, 4]);
            let [a, b] = [a, b].map(|x| pairs.index_of(x));
            assert!(pairs.found.contains(&[a, b]) || pairs.found.contains(&[b, a]), "{last}");
            let unrelated = [pairs.index_of(values[2]), pairs.index_of(values[4])];
            assert!(!pairs.found.contains(&unrelated), "{last}");
        }
    }
}
