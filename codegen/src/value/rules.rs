//! Rules that add classes and definitions; one identity per function, applied left to right.

use super::graph::{ClassId, Definition, Graph, Operation, Signed};
use crate::id::IdVec;

/// Number of definitions of an operand that a rule examines.
const LOOKED_INTO: usize = 6;
/// Most terms of a sum that are examined together.
const MOST_TERMS: usize = 12;

/// Applies every rule to every definition of the classes.
pub(super) fn apply(graph: &mut Graph, classes: &[ClassId], one: Signed) {
    for &class in classes {
        let target = Signed { class, negative: false };
        // The list grows while the rules run; definitions that they add wait for the next round.
        for definition in graph.classes[class].definitions().copied().collect::<Vec<_>>() {
            match definition.operation {
                Operation::Sum => {
                    reassociate(graph, target, &definition);
                    factor_terms(graph, target, &definition.operands, one);
                }
                Operation::Product => reassociate(graph, target, &definition),
                Operation::Quotient => reciprocal(graph, target, &definition, one),
                _ => {}
            }
        }
    }
}

/// Factors the classes' sums; the only rule that saves operations by itself.
pub(super) fn factor_sums(graph: &mut Graph, live: &[ClassId], classes: &[ClassId], one: Signed) {
    let readers = readers(graph, live);
    for &class in classes {
        let target = Signed { class, negative: false };
        if graph.classes[class].current.operation == Operation::Sum {
            let terms = terms(graph, target, &readers);
            factor_terms(graph, target, &terms, one);
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

/// The terms of a sum, flattened through inner sums that nothing else uses.
fn terms(graph: &Graph, sum: Signed, readers: &IdVec<ClassId, u32>) -> Vec<Signed> {
    let (mut terms, mut stack) = (Vec::with_capacity(MOST_TERMS), Vec::with_capacity(MOST_TERMS));
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
fn factor_terms(graph: &mut Graph, target: Signed, terms: &[Signed], one: Signed) {
    // (factor, index of the term, term / factor); each factor once per term.
    let mut divided: Vec<(ClassId, usize, Signed)> = Vec::with_capacity(4 * terms.len());
    for (i, &term) in terms.iter().enumerate() {
        for [a, b] in parts(graph, term, Operation::Product) {
            divided.extend([[a, b], [b, a]].map(|[f, x]| (f.class, i, x.times(f.negative))));
        }
        divided.push((term.class, i, one.times(term.negative)));
    }
    divided.retain(|(f, ..)| *f != one.class);
    divided.sort_by_key(|&(f, i, _)| (f, i));
    divided.dedup_by_key(|&mut (f, i, _)| (f, i));
    for quotients in divided.chunk_by(|a, b| a.0 == b.0).filter(|quotients| quotients.len() > 1) {
        let f = quotients[0].0;
        let others = (0..terms.len()).filter(|i| quotients.iter().all(|(_, k, _)| k != i)).map(|i| terms[i]);
        let others: Vec<Signed> = others.collect();
        let quotients: Vec<Signed> = quotients.iter().map(|&(.., x)| x).collect();
        let Some(inner) = sum(graph, &quotients) else { continue };
        let f = Signed { class: f, negative: false };
        if others.is_empty() {
            graph.propose(target, Operation::Product, f, inner);
        } else if let Some(product) = graph.class_of(Operation::Product, f, inner)
            && let Some(rest) = sum(graph, &others)
        {
            graph.propose(target, Operation::Sum, rest, product);
        }
    }
}

/// The class of a sum of several terms, from left to right; `None` if a partial sum is zero.
fn sum(graph: &mut Graph, terms: &[Signed]) -> Option<Signed> {
    let (&first, rest) = terms.split_first()?;
    rest.iter().try_fold(first, |total, &term| graph.class_of(Operation::Sum, total, term))
}

/// The first few definitions of x by this operation, as pairs of signed operands that include the sign of x.
fn parts(graph: &Graph, x: Signed, operation: Operation) -> impl Iterator<Item = [Signed; 2]> {
    let definitions = graph.classes[x.class].definitions().take(LOOKED_INTO);
    definitions.filter(move |d| d.operation == operation).map(move |d| {
        let [a, b] = d.operands;
        let sign = x.negative != d.negative;
        if operation == Operation::Sum { [a.times(sign), b.times(sign)] } else { [a.times(sign), b] }
    })
}

/// (p + r) + y = p + (r + y) and (p r) y = p (r y).
fn reassociate(graph: &mut Graph, target: Signed, definition: &Definition) {
    let operation = definition.operation;
    let target = target.times(definition.negative);
    let [a, b] = definition.operands;
    for (x, y) in [(a, b), (b, a)] {
        for [u, w] in parts(graph, x, operation).collect::<Vec<_>>() {
            for (p, r) in [(u, w), (w, u)] {
                if let Some(inner) = graph.class_of(operation, r, y) {
                    graph.propose(target, operation, p, inner);
                }
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
