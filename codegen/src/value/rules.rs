//! Rules that add classes and definitions; one identity per function, applied left to right.

use super::field::Field;
use super::graph::{ClassId, Definition, Graph, Operation, Signed};
use crate::id::{Id, IdVec};
use rustc_hash::FxHashMap as HashMap;

/// Number of definitions of an operand that a rule examines.
const LOOKED_INTO: usize = 6;
/// The same where time is short.
const SHARED_LOOKED_INTO: usize = 4;
/// Terms of a sum that are looked at together.
const MOST_TERMS: usize = 12;

/// Applies every rule to every definition of the classes.
pub(super) fn apply(graph: &mut Graph, classes: &[ClassId], one: Signed) {
    let mut factors = Factors::default();
    for &class in classes {
        let target = Signed { class, negative: false };
        // The list grows while the rules run; definitions that they add wait for the next round.
        for definition in graph.classes[class].definitions().copied().collect::<Vec<_>>() {
            match definition.operation {
                Operation::Sum => {
                    reassociate(graph, target, &definition);
                    factor_terms(graph, target, &definition.operands, one, &mut factors);
                }
                Operation::Product => reassociate(graph, target, &definition),
                Operation::Quotient => reciprocal(graph, target, &definition, one),
                _ => {}
            }
        }
    }
}

/// (p r) y = p (r y) and (p + r) + y = p + (r + y) where r y, or r + y, is a value already or would serve two values.
///
/// One that serves a single value saves nothing by itself. So candidates are counted by what they are in the field,
/// and most are never made.
pub(super) fn reassociate_shared(graph: &mut Graph, live: &[ClassId]) {
    let mut candidates: Vec<(ClassId, [Signed; 3], Field)> = Vec::with_capacity(4 * live.len());
    let mut wanted: HashMap<Field, (ClassId, bool)> = HashMap::default();
    wanted.reserve(2 * live.len());
    for &class in live.iter().filter(|&&class| !graph.classes[class].prepared) {
        let Definition { operation, operands: [a, b], .. } = graph.classes[class].current;
        if !matches!(operation, Operation::Sum | Operation::Product) {
            continue;
        }
        for (x, y) in [(a, b), (b, a)] {
            for [p, r] in splits(graph, x, operation, SHARED_LOOKED_INTO) {
                let Some([inner, _]) = graph.apply(operation, r, y) else { continue };
                let (first, is_shared) = wanted.entry(inner.canonical()).or_insert((class, false));
                *is_shared |= *first != class;
                candidates.push((class, [p, r, y], inner.canonical()));
            }
        }
    }
    for (class, [p, r, y], inner) in candidates {
        let Definition { operation, negative, .. } = graph.classes[class].current;
        if (wanted[&inner].1 || graph.find_at_first_point(inner).is_some())
            && let Some(inner) = graph.class_of(operation, r, y)
        {
            graph.propose(Signed { class, negative }, operation, p, inner);
        }
    }
}

/// Takes common factors out of the classes' sums, the only rule that shortens by itself.
pub(super) fn factor_sums(graph: &mut Graph, live: &[ClassId], classes: &[ClassId], one: Signed) {
    let readers = readers(graph, live);
    let mut factors = Factors::default();
    let mut memory = Default::default();
    for &class in classes {
        let target = Signed { class, negative: false };
        if graph.classes[class].current.operation == Operation::Sum {
            let terms = terms(graph, target, &readers, &mut memory);
            factor_terms(graph, target, terms, one, &mut factors);
        }
    }
}

/// How many current definitions of live classes read a class.
fn readers(graph: &Graph, live: &[ClassId]) -> IdVec<ClassId, u32> {
    let mut readers: IdVec<ClassId, u32> = graph.classes.ids().map(|_| 0).collect();
    for &class in live {
        for read in graph.classes[class].current.reads() {
            readers[read] += 1;
        }
    }
    readers
}

/// The terms of a sum, flattened through inner sums that nothing else uses; in the given memory, a list and a stack.
fn terms<'m>(
    graph: &Graph,
    sum: Signed,
    readers: &IdVec<ClassId, u32>,
    (terms, stack): &'m mut (Vec<Signed>, Vec<Signed>),
) -> &'m [Signed] {
    terms.clear();
    stack.push(sum);
    while let Some(x) = stack.pop() {
        let current = &graph.classes[x.class].current;
        let own = x == sum || readers[x.class] == 1;
        if own && current.operation == Operation::Sum && terms.len() + stack.len() < MOST_TERMS {
            stack.extend(current.operands.iter().rev().map(|o| o.times(x.negative)));
        } else {
            terms.push(x);
        }
    }
    terms
}

/// f x + f y + ... + r = f (x + y + ...) + r, for every factor f of two or more terms.
fn factor_terms(graph: &mut Graph, target: Signed, terms: &[Signed], one: Signed, factors: &mut Factors) {
    factors.clear();
    for (i, &term) in terms.iter().enumerate() {
        for [a, b] in parts(graph, term, Operation::Product, LOOKED_INTO) {
            factors.push(a.class, i, b.times(a.negative));
            factors.push(b.class, i, a.times(b.negative));
        }
        factors.push(term.class, i, one.times(term.negative));
    }
    let divided = factors.common(one.class);
    for quotients in divided.chunk_by(|a, b| a.0 == b.0) {
        let f = quotients[0].0;
        let taken: u32 = quotients.iter().fold(0, |set, &(_, i, _)| set | 1 << i);
        let Some(inner) = sum(graph, quotients.iter().map(|&(.., x)| x)) else { continue };
        let f = Signed { class: f, negative: false };
        if quotients.len() == terms.len() {
            graph.propose(target, Operation::Product, f, inner);
        } else if let Some(product) = graph.class_of(Operation::Product, f, inner)
            && let Some(rest) = sum(graph, (0..terms.len()).filter(|i| taken >> i & 1 == 0).map(|i| terms[i]))
        {
            graph.propose(target, Operation::Sum, rest, product);
        }
    }
}

/// Factors of the terms of one sum after the other.
#[derive(Default)]
struct Factors {
    /// (factor, index of the term, term / factor); each factor once per term.
    divided: Vec<(ClassId, usize, Signed)>,
    /// By class: the last sum and term of which it is a factor, and whether it is one of two terms of that sum.
    seen: Vec<(usize, usize, bool)>,
    sum: usize,
}

impl Factors {
    /// Begins with the next sum.
    fn clear(&mut self) {
        self.divided.clear();
        self.sum += 1;
    }

    /// Adds a factor of the i-th term, unless it is known as such; terms come in order.
    fn push(&mut self, factor: ClassId, i: usize, quotient: Signed) {
        let place = factor.index();
        if self.seen.len() <= place {
            self.seen.resize(place + 1, (0, 0, false));
        }
        let (sum, term, is_common) = &mut self.seen[place];
        if *sum != self.sum {
            (*sum, *term, *is_common) = (self.sum, i, false);
        } else if *term != i {
            (*term, *is_common) = (i, true);
        } else {
            return;
        }
        self.divided.push((factor, i, quotient));
    }

    /// The factors of two or more terms except 1, sorted by factor and term.
    fn common(&mut self, one: ClassId) -> &[(ClassId, usize, Signed)] {
        let seen = &self.seen;
        // Most are factors of one term alone: only the others are sorted.
        self.divided.retain(|&(factor, ..)| seen[factor.index()].2 && factor != one);
        self.divided.sort_unstable_by_key(|&(factor, i, _)| (factor, i));
        &self.divided
    }
}

/// The class of a sum of many, from left to right; `None` if a part of it vanishes.
fn sum(graph: &mut Graph, mut terms: impl Iterator<Item = Signed>) -> Option<Signed> {
    let first = terms.next()?;
    terms.try_fold(first, |total, term| graph.class_of(Operation::Sum, total, term))
}

/// Of the first few definitions of x those by an operation, as pairs of signed operands with the sign of x drawn in.
fn parts(graph: &Graph, x: Signed, operation: Operation, few: usize) -> impl Iterator<Item = [Signed; 2]> {
    let definitions = graph.classes[x.class].definitions().take(few);
    definitions.filter(move |d| d.operation == operation).map(move |d| {
        let [a, b] = d.operands;
        let sign = x.negative != d.negative;
        if operation == Operation::Sum { [a.times(sign), b.times(sign)] } else { [a.times(sign), b] }
    })
}

/// [`parts`], each in both orders.
fn splits(graph: &Graph, x: Signed, operation: Operation, few: usize) -> impl Iterator<Item = [Signed; 2]> {
    parts(graph, x, operation, few).flat_map(|[u, w]| [[u, w], [w, u]])
}

/// (p + r) + y = p + (r + y) and (p r) y = p (r y).
fn reassociate(graph: &mut Graph, target: Signed, definition: &Definition) {
    let operation = definition.operation;
    let target = target.times(definition.negative);
    let [a, b] = definition.operands;
    for (x, y) in [(a, b), (b, a)] {
        for [p, r] in splits(graph, x, operation, LOOKED_INTO).collect::<Vec<_>>() {
            if let Some(inner) = graph.class_of(operation, r, y) {
                graph.propose(target, operation, p, inner);
            }
        }
    }
}

/// x / y = x (1 / y).
fn reciprocal(graph: &mut Graph, target: Signed, definition: &Definition, one: Signed) {
    let [x, y] = definition.operands;
    if x.class == one.class {
        return;
    }
    if let Some(inverse) = graph.class_of(Operation::Quotient, one, y) {
        graph.propose(target.times(definition.negative), Operation::Product, x, inverse);
    }
}

#[cfg(test)]
mod tests {
    use super::super::field::mix;
    use super::super::guard::Estimate;
    use super::*;
    use crate::expr::Dag;

    /// p (r y), r y and q (r y) of (p r) y and (q r) y; s (t v) of (s t) v, which shares with nothing.
    #[test]
    fn an_order_is_made_that_two_values_share_and_no_other() {
        let mut graph = Graph::new(0);
        let mut dag = Dag::default();
        let [p, q, r, y, s, t, v] = std::array::from_fn(|i| {
            let seed = i as u64 + 1;
            let value = [Field::new(mix(seed)), Field::new(mix(seed + 100))];
            graph.leaf(value, dag.symbol("x"), false, &[] as &[Estimate])
        });
        for operation in [Operation::Product, Operation::Sum] {
            let mut of_three = |a, b, c| {
                let inner = graph.class_of(operation, a, b).expect("not 0");
                graph.class_of(operation, inner, c).expect("not 0")
            };
            let [first, second, alone] = [of_three(p, r, y), of_three(q, r, y), of_three(s, t, v)];
            let find = |graph: &Graph, a, b| graph.find(graph.apply(operation, a, b).expect("defined"));
            assert_eq!(find(&graph, r, y), None);
            let live: Vec<ClassId> = graph.classes.ids().collect();
            reassociate_shared(&mut graph, &live);
            let shared = find(&graph, r, y).expect("two values read it");
            for (whole, other) in [(first, p), (second, q)] {
                let mut definitions = graph.classes[whole.class].definitions();
                let reads = |d: &Definition| d.reads().eq([other.class, shared.class]);
                assert!(definitions.any(|d| d.operation == operation && reads(d)), "{operation:?}");
            }
            assert_eq!((find(&graph, t, v), find(&graph, s, v)), (None, None), "{operation:?}");
            assert_eq!(graph.classes[alone.class].definitions().count(), 1);
        }
    }
}
