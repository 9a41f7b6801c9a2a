//! Rules that make new classes and with them new definitions. One identity a function, directed.

use super::graph::{ClassId, Definition, Graph, Operation, Signed};

/// Definitions of an operand that a rule looks into.
const LOOKED_INTO: usize = 6;

/// Applies every rule to every definition of the classes.
pub(super) fn apply(graph: &mut Graph, classes: &[ClassId], one: Signed) {
    for &class in classes {
        let target = Signed { class, negative: false };
        // The list grows under the rules; what they add is left to the next round.
        for definition in graph.classes[class].definitions.clone() {
            match definition.operation {
                Operation::Sum => {
                    reassociate(graph, target, &definition);
                    factor(graph, target, &definition, one);
                }
                Operation::Product => reassociate(graph, target, &definition),
                Operation::Quotient => reciprocal(graph, target, &definition, one),
                _ => {}
            }
        }
    }
}

/// Applies the factoring rule alone, the only one that shortens by itself.
pub(super) fn apply_factoring(graph: &mut Graph, classes: &[ClassId], one: Signed) {
    for &class in classes {
        let target = Signed { class, negative: false };
        for definition in graph.classes[class].definitions.clone() {
            if definition.operation == Operation::Sum {
                factor(graph, target, &definition, one);
            }
        }
    }
}

/// The first few definitions of x by an operation, as pairs of signed operands with the sign of x drawn in.
fn parts(graph: &Graph, x: Signed, operation: Operation) -> Vec<[Signed; 2]> {
    let definitions = graph.classes[x.class].definitions.iter().take(LOOKED_INTO);
    definitions
        .filter(|d| d.operation == operation)
        .map(|d| {
            let [a, b] = d.operands;
            let sign = x.negative != d.negative;
            if operation == Operation::Sum { [a.times(sign), b.times(sign)] } else { [a.times(sign), b] }
        })
        .collect()
}

/// (p + r) + y = p + (r + y) and (p r) y = p (r y).
fn reassociate(graph: &mut Graph, target: Signed, definition: &Definition) {
    let operation = definition.operation;
    let target = target.times(definition.negative);
    let [a, b] = definition.operands;
    for (x, y) in [(a, b), (b, a)] {
        for [u, w] in parts(graph, x, operation) {
            for (p, r) in [(u, w), (w, u)] {
                if let Some(inner) = graph.class_of(operation, r, y) {
                    graph.propose(target, operation, p, inner);
                }
            }
        }
    }
}

/// f x + f y = f (x + y), also f x + f = f (x + 1).
fn factor(graph: &mut Graph, target: Signed, definition: &Definition, one: Signed) {
    let factors = |graph: &Graph, x: Signed| {
        let mut found = parts(graph, x, Operation::Product);
        found.push([x, one]);
        found
    };
    let [a, b] = definition.operands;
    for p in factors(graph, a) {
        for q in factors(graph, b) {
            for (f, x) in [(p[0], p[1]), (p[1], p[0])] {
                for (g, y) in [(q[0], q[1]), (q[1], q[0])] {
                    if f.class != g.class || f.class == one.class {
                        continue;
                    }
                    let y = y.times(f.negative != g.negative);
                    if let Some(sum) = graph.class_of(Operation::Sum, x, y) {
                        graph.propose(target, Operation::Product, f, sum);
                    }
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
