//! Expressions -> classes: merges equal values, removes zeros, makes signs canonical.

use super::field::{Field, mix};
use super::graph::{ClassId, Definition, Graph, Operation, Signed, Value};
use super::guard::{self, Estimate};
use super::states::States;
use crate::expr::number::Number;
use crate::expr::{Binary, Dag, Dependence, ExprId, Label, Node, SymbolId, Unary};
use crate::id::Id;
use rustc_hash::{FxHashMap as HashMap, FxHashSet as HashSet};

/// Loads expressions into a graph.
pub(super) struct Import<'a> {
    pub graph: &'a mut Graph,
    dag: &'a Dag,
    states: &'a States,
    /// The node 0 of the DAG.
    zero: ExprId,
    /// Does a definition with less round-off replace an equal one? Otherwise both are kept, for the search over pairs.
    replaces: bool,
    /// By node: not loaded, or loaded as a class with a sign, or as zero (inner `None`).
    classes: Vec<Option<Option<Signed>>>,
}

impl<'a> Import<'a> {
    pub fn new(graph: &'a mut Graph, dag: &'a Dag, states: &'a States, zero: ExprId, replaces: bool) -> Self {
        Self { graph, dag, states, zero, replaces, classes: vec![None; dag.len()] }
    }

    /// Loads the nodes that `roots` depend on and returns the classes of the roots.
    pub fn load(&mut self, roots: &[ExprId]) -> Vec<Option<Signed>> {
        let nodes = self.dag.reachable(roots);
        for id in nodes {
            if self.classes[id.index()].is_none() {
                self.classes[id.index()] = Some(self.class(id));
            }
        }
        roots.iter().map(|&root| self.of(root)).collect()
    }

    /// The class of a loaded node; `None` for zero.
    pub fn of(&self, id: ExprId) -> Option<Signed> {
        self.classes[id.index()].expect("operands are loaded before what reads them")
    }

    /// Labels by class, each with whether it is for the class's negative. A label of the other sign than the first is
    /// not merged.
    pub fn labels(&self) -> HashMap<ClassId, (bool, Label)> {
        let mut labels: HashMap<ClassId, (bool, Label)> = HashMap::default();
        for (index, class) in self.classes.iter().enumerate() {
            if let Some(Some(class)) = class
                && let Some(label) = self.dag.label_of(ExprId::from_index(index))
            {
                let known = labels.entry(class.class).or_insert_with(|| (class.negative, label.clone()));
                if known.0 == class.negative {
                    known.1.join(label);
                }
            }
        }
        labels
    }

    /// Classes of the loaded nodes that are lengths of vectors which may vanish.
    pub fn norms(&self) -> HashSet<ClassId> {
        let loaded = self.classes.iter().enumerate();
        let norms = loaded.filter(|(index, _)| self.dag.is_norm(ExprId::from_index(*index)));
        norms.filter_map(|(_, class)| Some((*class)??.class)).collect()
    }

    fn class(&mut self, id: ExprId) -> Option<Signed> {
        if self.dag.is_constant(id) {
            return (!self.dag.is_zero(id)).then(|| self.constant(id));
        }
        let (operation, a, b) = match self.dag.node(id) {
            Node::Number(_) | Node::Pi => return Some(self.constant(id)),
            Node::Symbol(symbol) => return Some(self.symbol(id, symbol)),
            Node::Negate(a) => return self.of(a).map(|x| x.times(true)),
            Node::Unary(f, a) => (Operation::Unary(f), a, a),
            Node::Binary(Binary::Add | Binary::Sub, a, b) => (Operation::Sum, a, b),
            Node::Binary(Binary::Mul, a, b) => (Operation::Product, a, b),
            Node::Binary(Binary::Div, a, b) => (Operation::Quotient, a, b),
            Node::Binary(f, a, b) => (Operation::Binary(f), a, b),
        };
        let minus = matches!(self.dag.node(id), Node::Binary(Binary::Sub, ..));
        match (operation, self.of(a), self.of(b).map(|b| b.times(minus))) {
            (Operation::Sum, None, other) | (Operation::Sum, other, None) => other, // 0 + x = x
            (Operation::Product, None, _) | (Operation::Product, _, None) => None,  // 0 x = 0
            (Operation::Quotient, None, Some(_)) => None,                           // 0 / x = 0
            (_, a, b) => {
                let a = a.unwrap_or_else(|| self.constant(self.zero));
                let b = b.unwrap_or_else(|| self.constant(self.zero));
                self.merge(operation, a, b)
            }
        }
    }

    /// The class with the value of a (operation) b; a new one if the guard admits no definition of the existing class.
    fn merge(&mut self, operation: Operation, a: Signed, b: Signed) -> Option<Signed> {
        let graph = &mut *self.graph;
        let value = graph.apply(operation, a, b).unwrap_or_else(|| opaque(graph, operation, a, b));
        if value[0] == Field::ZERO {
            return None;
        }
        if let Some(known) = graph.find(value) {
            let estimates: Vec<Estimate> =
                graph.estimates_of(&Definition::new(operation, a, b, false)).collect();
            let own = graph.signed_estimates(known);
            if guard::admits(estimates.iter().copied(), own).is_some() {
                graph.propose(known, operation, a, b);
                graph.sharpen(known.class, &estimates);
                return Some(known);
            }
            // The known definition rounds off more: the new one replaces it.
            let own: Vec<Estimate> = graph.signed_estimates(known).collect();
            let is_better = guard::admits(own.into_iter(), estimates.iter().copied()).is_some();
            if self.replaces && is_better && graph.adopt(known, operation, a, b) {
                graph.sharpen(known.class, &estimates);
                return Some(known);
            }
        }
        Some(graph.add(value, operation, a, b))
    }

    fn constant(&mut self, id: ExprId) -> Signed {
        let number =
            self.dag.as_number(id).unwrap_or_else(|| Number::from_f64(self.dag.evaluate_constant(id)));
        // A constant has the same value at both points; a square root that is not in the field is replaced by a random
        // element.
        let value = Field::from_number(number).unwrap_or_else(|| Field::new(mix(0xC0 + id.index() as u64)));
        let estimate = match number {
            Number::Exact { denominator, root, .. } if root > 1 || denominator.count_ones() > 1 => {
                Estimate::rounded(number.to_f64())
            }
            _ => Estimate::exact(number.to_f64()),
        };
        self.graph.leaf([value, value], id, true, &vec![estimate; self.states.points])
    }

    fn symbol(&mut self, id: ExprId, symbol: SymbolId) -> Signed {
        let seed = mix(symbol.index() as u64);
        let value = [Field::new(mix(seed)), Field::new(mix(seed ^ 0x5EED))];
        let estimates: Vec<Estimate> =
            (0..self.states.points).map(|k| Estimate::exact(self.states.value(symbol, k))).collect();
        let prepared = self.dag.dependence(id) != Dependence::State;
        self.graph.leaf(value, id, prepared, &estimates)
    }
}

/// A pseudo-random value for a result that is not rational in the operands; the same for equal operands.
fn opaque(graph: &Graph, operation: Operation, a: Signed, b: Signed) -> Value {
    let (x, y) = (graph.value(a), graph.value(b));
    let of_two = |tag: u64, k: usize| random(tag, Field::new(mix(x[k].bits())) + y[k]);
    let one = |k: usize| match operation {
        Operation::Unary(f) => unary(f, x[k]),
        Operation::Binary(f) => of_two(100 + f as u64, k),
        _ => of_two(200, k), // a division by zero: left as it is
    };
    [one(0), one(1)]
}

fn random(tag: u64, x: Field) -> Field {
    Field::new(mix(mix(x.bits()).wrapping_add(tag)))
}

/// f(x): sine, cosine and tangent from one point of the unit circle, others pseudo-random. Odd functions are odd in the
/// field, even ones even.
fn unary(f: Unary, x: Field) -> Field {
    let (negative, size) = if x.is_upper() { (true, -x) } else { (false, x) };
    let (sin, cos) = Field::circle(random(0, size)).unwrap_or((Field::ZERO, Field::ONE));
    let own = 1 + f as u64;
    let odd = match f {
        Unary::Sin => sin,
        Unary::Tan => cos.inverse().map_or_else(|| random(own, size), |inverse| sin * inverse),
        Unary::Asin | Unary::Tanh | Unary::Sign => random(own, size),
        Unary::Cos => return cos,
        Unary::Abs => return random(own, size),
        Unary::Sqrt | Unary::Acos | Unary::Exp | Unary::Ln => return random(own, x),
    };
    if negative { -odd } else { odd }
}
