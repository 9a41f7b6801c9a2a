//! Jacobians by vertex elimination on the graph of operations.
//!
//! In: expressions, and directions in which symbols change. Out: the derivative of each expression along each
//! direction. Edges of the graph are local derivatives; eliminating a vertex connects its predecessors to its
//! successors by products (chain rule). Operands first is the forward mode, results first the reverse mode. Here
//! vertices with a single predecessor or successor go first, which adds no edge, then the rest in reverse mode (orders
//! of elimination: Griewank and Walther 2008, chapter 10).

use super::node::symbol_bit;
use super::{Dag, ExprId, Node, SymbolId};
use rustc_hash::FxHashMap as HashMap;
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// The graph. Vertices are numbered: directions, then nodes, then results.
struct Graph {
    /// By vertex: its predecessors, each with the local derivative.
    reads: Vec<BTreeMap<usize, ExprId>>,
    /// By vertex: its successors.
    read_by: Vec<BTreeSet<usize>>,
}

impl Dag {
    /// Derivatives of the roots (rows) along the directions (columns).
    pub fn jacobian(
        &mut self,
        roots: &[ExprId],
        directions: &[HashMap<SymbolId, ExprId>],
    ) -> Vec<Vec<ExprId>> {
        let bits =
            directions.iter().flat_map(HashMap::keys).fold(0, |bits, &symbol| bits | symbol_bit(symbol));
        let nodes = self.reachable_above(roots, |id| !self.may_read(id, bits));
        let mut graph = Graph::of(self, &nodes, roots, directions);
        let inner = directions.len()..directions.len() + nodes.len();
        graph.eliminate(self, inner.clone());
        let zero = self.zero();
        let of_root = |row: &BTreeMap<usize, ExprId>| {
            (0..directions.len()).map(|d| row.get(&d).copied().unwrap_or(zero)).collect()
        };
        graph.reads[inner.end..].iter().map(of_root).collect()
    }

    /// Derivatives of a node by its operands.
    fn local_derivatives(&mut self, id: ExprId) -> Vec<(ExprId, ExprId)> {
        let (one, zero) = (self.one(), self.zero());
        let operands = self.operands(id);
        let mut found = Vec::new();
        for (place, operand) in operands.into_iter().enumerate() {
            let Some(operand) = operand else { continue };
            let changes = std::array::from_fn(|i| operands[i].map(|_| if i == place { one } else { zero }));
            found.push((operand, self.change_of_node(id, changes)));
        }
        found
    }
}

impl Graph {
    fn of(
        dag: &mut Dag,
        nodes: &[ExprId],
        roots: &[ExprId],
        directions: &[HashMap<SymbolId, ExprId>],
    ) -> Self {
        let first = directions.len();
        let vertex: HashMap<ExprId, usize> =
            nodes.iter().enumerate().map(|(place, &id)| (id, first + place)).collect();
        let total = first + nodes.len() + roots.len();
        let mut graph = Self { reads: vec![BTreeMap::new(); total], read_by: vec![BTreeSet::new(); total] };
        for &id in nodes {
            let to = vertex[&id];
            if let Node::Symbol(symbol) = dag.node(id) {
                for (from, direction) in directions.iter().enumerate() {
                    if let Some(&slope) = direction.get(&symbol) {
                        graph.join(dag, from, to, slope);
                    }
                }
                continue;
            }
            for (operand, slope) in dag.local_derivatives(id) {
                if let Some(&from) = vertex.get(&operand) {
                    graph.join(dag, from, to, slope);
                }
            }
        }
        let one = dag.one();
        for (place, root) in roots.iter().enumerate() {
            if let Some(&from) = vertex.get(root) {
                graph.join(dag, from, first + nodes.len() + place, one);
            }
        }
        graph
    }

    /// Adds `slope` to the derivative of `to` by `from`.
    fn join(&mut self, dag: &mut Dag, from: usize, to: usize, slope: ExprId) {
        let sum = match self.reads[to].get(&from) {
            Some(&mine) => dag.add(mine, slope),
            None => slope,
        };
        if dag.is_zero(sum) {
            self.reads[to].remove(&from);
            self.read_by[from].remove(&to);
        } else {
            self.reads[to].insert(from, sum);
            self.read_by[from].insert(to);
        }
    }

    /// Eliminates all of these vertices. Each elimination changes the turns of its neighbours, which are queued anew.
    fn eliminate(&mut self, dag: &mut Dag, vertices: Range<usize>) {
        let mut turns: Vec<Turn> = vertices.clone().map(|v| self.turn(v)).collect();
        let mut queue: BTreeSet<(Turn, usize)> = turns.iter().copied().zip(vertices.clone()).collect();
        while let Some((_, vertex)) = queue.pop_first() {
            let reads = std::mem::take(&mut self.reads[vertex]);
            let read_by = std::mem::take(&mut self.read_by[vertex]);
            for from in reads.keys() {
                self.read_by[*from].remove(&vertex);
            }
            for &to in &read_by {
                let Some(outer) = self.reads[to].remove(&vertex) else { continue };
                for (&from, &inner) in &reads {
                    let product = dag.mul(outer, inner);
                    self.join(dag, from, to, product);
                }
            }
            let beside: BTreeSet<usize> = reads.keys().chain(&read_by).copied().collect();
            for other in beside.into_iter().filter(|other| vertices.contains(other)) {
                let turn = &mut turns[other - vertices.start];
                if queue.remove(&(*turn, other)) {
                    *turn = self.turn(other);
                    queue.insert((*turn, other));
                }
            }
        }
    }

    /// The place of a vertex in the order of elimination.
    fn turn(&self, vertex: usize) -> Turn {
        match (self.reads[vertex].len(), self.read_by[vertex].len()) {
            (_, ..=1) => Turn::ReadByOne(Reverse(vertex)),
            (..=1, _) => Turn::ReadsOne(vertex),
            _ => Turn::FromTheResults(Reverse(vertex)),
        }
    }
}

/// The order of elimination. A vertex with a single predecessor or successor adds no edge to the graph and goes first;
/// the others follow from the results towards the directions.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Turn {
    ReadByOne(Reverse<usize>),
    ReadsOne(usize),
    FromTheResults(Reverse<usize>),
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_jacobian_is_that_of_derivatives_along_directions() {
        let mut dag = Dag::default();
        let (x, y, z) = (dag.symbol("x"), dag.symbol("y"), dag.symbol("z"));
        let (s, square) = (dag.sin(x), dag.mul(y, y));
        let product = dag.mul(s, square);
        let sum = dag.add(product, z);
        let quotient = dag.div(sum, y);
        let root = dag.sqrt(square);
        let roots = [sum, quotient, y, root];
        let symbol = |e| dag.as_symbol(e).expect("a symbol");
        let symbols = [symbol(x), symbol(y), symbol(z)];
        let (one, two) = (dag.one(), dag.number(crate::expr::number::Number::integer(2)));
        // x alone; y with z at twice its rate; nothing.
        let directions = [
            HashMap::from_iter([(symbols[0], one)]),
            HashMap::from_iter([(symbols[1], one), (symbols[2], two)]),
            HashMap::default(),
        ];
        let found = dag.jacobian(&roots, &directions);
        let at =
            |symbol: SymbolId| [0.3, 1.7, -0.4][symbols.iter().position(|s| *s == symbol).expect("known")];
        for (row, &root) in found.iter().zip(&roots) {
            for (&entry, along) in row.iter().zip(&directions) {
                let expected = dag.rate(root, along);
                let values: Vec<f64> = dag.evaluate(&[entry, expected], &at);
                assert!((values[0] - values[1]).abs() <= 1e-15 * values[1].abs().max(1.0), "{values:?}");
            }
        }
        assert_eq!(found.len(), 4);
    }
}
