//! One-operation resubstitution among neighbours: a value as sum, difference or product of two others, one of which is
//! near it in the graph.
//!
//! In: live classes and their current definitions. Out: further definitions. Of all pairs of values (`pairs`) only
//! those are tried in which one member is an operand of the value, an operand of an operand, or another user of these;
//! the other member is looked up by its value. That finds nearly as much, in time proportional to the number of values.

use super::field::Field;
use super::graph::{ClassId, Graph, Operation, Signed};
use crate::id::Id;

/// Number of neighbours that are tried.
const NEAREST: usize = 6;
/// A class used by more definitions than this is near everything: its users do not count as neighbours.
const CROWD: usize = 24;

/// Limit of the round-off bound of a new definition relative to the class's own: since many are taken, none may add to
/// it.
const NO_WORSE: f64 = 1.0;

/// Proposes t = x + y, t = y - x and t = x y for every class t, neighbour x of it, and class y.
pub(super) fn resubstitute(graph: &mut Graph, live: &[ClassId], targets: &[ClassId]) {
    let readers = Readers::new(graph, live);
    let values: Vec<Field> = graph.classes.iter().map(|class| class.value[0]).collect();
    let inverses = Field::inverses(&values);
    let mut search =
        Search { seen: vec![usize::MAX; graph.classes.len()], near: Vec::with_capacity(2 * NEAREST) };
    for (round, &target) in targets.iter().enumerate() {
        // A prepared value costs nothing. A new definition saves more than one operation only if nothing else uses some
        // operand of the current one.
        let has_own_operand = graph.classes[target].current.reads().any(|read| readers.of(read).len() == 1);
        if graph.classes[target].is_leaf() || graph.classes[target].prepared || !has_own_operand {
            continue;
        }
        search.look_around(graph, &readers, target, round);
        let own = Signed { class: target, negative: false };
        let t = graph.value(own);
        for &class in &search.near[1..] {
            let x = Signed { class, negative: false };
            let value = values[class.index()];
            let is_other = |y: &Signed| y.class != target && y.class != class;
            // Looked up by the value at the first point of the field, compared at both.
            if let Some(y) = graph.find_at_first_point(t[0] - value).filter(is_other)
                && graph.apply(Operation::Sum, x, y) == Some(t)
            {
                graph.propose_within(own, Operation::Sum, [x, y], NO_WORSE);
            }
            if let Some(y) = graph.find_at_first_point(t[0] + value).filter(is_other)
                && graph.apply(Operation::Sum, y, x.times(true)) == Some(t)
            {
                graph.propose_within(own, Operation::Sum, [y, x.times(true)], NO_WORSE);
            }
            let factor = graph.find_at_first_point(t[0] * inverses[class.index()]);
            if let Some(y) = factor.filter(is_other)
                && graph.apply(Operation::Product, x, y) == Some(t)
            {
                graph.propose_within(own, Operation::Product, [x, y], NO_WORSE);
            }
        }
    }
}

/// By class: the classes whose current definitions use it. Those of class i stand at `starts[i]..starts[i + 1]`.
struct Readers {
    starts: Vec<usize>,
    classes: Vec<ClassId>,
}

impl Readers {
    fn new(graph: &Graph, live: &[ClassId]) -> Self {
        let reads =
            || live.iter().flat_map(|&c| graph.classes[c].current.reads().map(move |read| (read.index(), c)));
        let mut starts = vec![0; graph.classes.len() + 1];
        reads().for_each(|(read, _)| starts[read + 1] += 1);
        for i in 0..graph.classes.len() {
            starts[i + 1] += starts[i];
        }
        let mut next = starts.clone();
        let nobody = ClassId::from_index(0);
        let mut classes = vec![nobody; starts[graph.classes.len()]];
        for (read, reader) in reads() {
            classes[next[read]] = reader;
            next[read] += 1;
        }
        Self { starts, classes }
    }

    fn of(&self, class: ClassId) -> &[ClassId] {
        &self.classes[self.starts[class.index()]..self.starts[class.index() + 1]]
    }
}

/// Finds the neighbours of one class after the other.
struct Search {
    /// By class: the last round in which it was found.
    seen: Vec<usize>,
    /// The class itself, then its neighbours, the nearest first.
    near: Vec<ClassId>,
}

impl Search {
    /// Finds the neighbours of a class by breadth-first search: its operands, their operands and users, and so on.
    fn look_around(&mut self, graph: &Graph, readers: &Readers, class: ClassId, round: usize) {
        self.near.clear();
        self.near.push(class);
        self.seen[class.index()] = round;
        let mut next = 0;
        while next < self.near.len() && self.near.len() < NEAREST {
            let at = self.near[next];
            let readers = if next == 0 { &[] } else { readers.of(at) };
            let readers = if readers.len() < CROWD { readers } else { &[] };
            next += 1;
            for other in graph.classes[at].current.reads().chain(readers.iter().copied()) {
                if std::mem::replace(&mut self.seen[other.index()], round) != round {
                    self.near.push(other);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::Dag;
    use crate::value::guard::Estimate;

    /// Leaves of so many random values, in a graph that watches no state.
    fn leaves<const N: usize>(graph: &mut Graph) -> [Signed; N] {
        let mut dag = Dag::default();
        std::array::from_fn(|i| {
            let seed = 7919 * (i as u64 + 1);
            let value = [Field::new(seed * seed), Field::new(seed * seed * seed)];
            graph.leaf(value, dag.symbol("x"), false, &[] as &[Estimate])
        })
    }

    fn live(graph: &Graph) -> Vec<ClassId> {
        graph.classes.ids().collect()
    }

    #[test]
    fn the_other_way_round_a_sum_is_found() {
        let mut graph = Graph::new(0);
        let [a, b, c] = leaves(&mut graph);
        let make = |graph: &mut Graph, operation, x, y| graph.class_of(operation, x, y).expect("not 0");
        // (a + b) + c beside a + c: also (a + c) + b.
        let ab = make(&mut graph, Operation::Sum, a, b);
        let whole = make(&mut graph, Operation::Sum, ab, c);
        let ac = make(&mut graph, Operation::Sum, a, c);
        // (a b) c beside b c: also a (b c).
        let product = make(&mut graph, Operation::Product, a, b);
        let all = make(&mut graph, Operation::Product, product, c);
        let bc = make(&mut graph, Operation::Product, b, c);
        let live = live(&graph);
        resubstitute(&mut graph, &live, &live);
        let reads = |graph: &Graph, of: Signed, operation, operands: [Signed; 2]| {
            graph.classes[of.class].definitions().any(|d| {
                d.operation == operation && operands.iter().all(|o| d.reads().any(|read| read == o.class))
            })
        };
        assert!(reads(&graph, whole, Operation::Sum, [ac, b]));
        assert!(reads(&graph, all, Operation::Product, [a, bc]));
        assert!(!reads(&graph, whole, Operation::Sum, [ac, ab]));
    }
}
