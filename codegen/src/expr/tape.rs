//! A flat instruction list for the interpreter: the nodes that some roots need, in order, over any scalar.
//!
//! It performs the same operations on the same operands as the emitted Rust, hence gives the same bits. Sine and cosine
//! of one angle are one instruction. Constants are rounded once, when the tape is made.

use super::evaluate;
use super::rounding::Rounded;
use super::{Binary, Dag, ExprId, Node, SymbolId, Unary};
use crate::id::Id;
use rustc_hash::FxHashMap as HashMap;
use smartbed_runtime::real::Real;

#[derive(Clone, Copy, Debug)]
enum Instruction {
    Negate { to: u32, a: u32 },
    Unary { function: Unary, to: u32, a: u32 },
    SinCos { sin: u32, cos: u32, a: u32 },
    SinCosOfDifference { sin: u32, cos: u32, a: u32, b: u32 },
    // The most frequent ones are told apart by one jump instead of two.
    Sum { to: u32, a: u32, b: u32 },
    Difference { to: u32, a: u32, b: u32 },
    Product { to: u32, a: u32, b: u32 },
    Binary { operator: Binary, to: u32, a: u32, b: u32 },
}

/// An executable copy of part of a DAG.
#[derive(Clone, Debug)]
pub struct Tape<S> {
    instructions: Vec<Instruction>,
    inputs: Vec<(usize, u32)>,
    outputs: Vec<u32>,
    values: Vec<S>,
}

impl<S: Real> Tape<S> {
    /// The nodes that `roots` need; `inputs[k]` is the symbol that takes the k-th argument.
    ///
    /// # Panics
    /// If a root depends on a symbol that is not among `inputs`: a fault of the derivation.
    #[must_use]
    pub fn new(dag: &Dag, roots: &[ExprId], inputs: &[SymbolId]) -> Self {
        let symbol = |&symbol: &SymbolId| dag.find(Node::Symbol(symbol)).expect("a symbol is a node");
        Self::above(dag, roots, &inputs.iter().map(symbol).collect::<Vec<_>>())
    }

    /// [`Self::new`] with nodes of any kind as arguments: nothing below them is computed.
    ///
    /// # Panics
    /// If a root depends on a symbol other than through `inputs`: a fault of the derivation.
    #[must_use]
    pub fn above(dag: &Dag, roots: &[ExprId], inputs: &[ExprId]) -> Self {
        // By node: which argument it is, if it is one.
        let mut arguments = vec![UNKNOWN; inputs.iter().map(|id| id.index() + 1).max().unwrap_or(0)];
        inputs.iter().zip(0..).for_each(|(id, k)| arguments[id.index()] = k);
        let argument = |id: ExprId| arguments.get(id.index()).copied().filter(|&k| k != UNKNOWN);
        let order = dag.reachable_above(roots, |id| argument(id).is_some());
        // By node: its slot among the values, if it has one.
        let mut slots = vec![UNKNOWN; order.last().map_or(0, |id| id.index() + 1)];
        order.iter().zip(0..).for_each(|(id, k)| slots[id.index()] = k);
        let slot = |id: ExprId| slots[id.index()];
        let mut tape = Self {
            instructions: Vec::with_capacity(order.len()),
            inputs: Vec::with_capacity(inputs.len()),
            outputs: roots.iter().map(|&root| slot(root)).collect(),
            values: vec![S::ZERO; order.len() + 1],
        };
        let spare = u32::try_from(order.len()).expect("fewer than 2^32 nodes");
        let mut paired = vec![false; order.len()];
        for &id in &order {
            let to = slot(id);
            if dag.is_constant(id) {
                tape.values[to as usize] = S::from_f64(dag.evaluate_constant(id));
                continue;
            }
            if let Some(k) = argument(id) {
                tape.inputs.push((k as usize, to));
                continue;
            }
            match dag.node(id) {
                Node::Number(_) | Node::Pi => {}
                Node::Symbol(symbol) => {
                    panic!("symbol `{}` is not an input of this program", dag.symbol_name(symbol))
                }
                Node::Negate(a) => tape.instructions.push(Instruction::Negate { to, a: slot(a) }),
                Node::Unary(Unary::Sin | Unary::Cos, _) if paired[to as usize] => {}
                Node::Unary(function @ (Unary::Sin | Unary::Cos), a) => {
                    let other = if function == Unary::Sin { Unary::Cos } else { Unary::Sin };
                    let twin =
                        dag.find(Node::Unary(other, a)).and_then(|twin| slots.get(twin.index()).copied());
                    let twin = twin.filter(|&twin| twin != UNKNOWN);
                    if let Some(twin) = twin {
                        paired[twin as usize] = true;
                    }
                    let twin = twin.unwrap_or(spare);
                    let (sin, cos) = if function == Unary::Sin { (to, twin) } else { (twin, to) };
                    tape.instructions.push(match dag.as_difference(a).filter(|_| argument(a).is_none()) {
                        Some([a, b]) => Instruction::SinCosOfDifference { sin, cos, a: slot(a), b: slot(b) },
                        None => Instruction::SinCos { sin, cos, a: slot(a) },
                    });
                }
                Node::Unary(function, a) => {
                    tape.instructions.push(Instruction::Unary { function, to, a: slot(a) });
                }
                Node::Binary(operator, a, b) => {
                    let (a, b) = (slot(a), slot(b));
                    tape.instructions.push(match operator {
                        Binary::Add => Instruction::Sum { to, a, b },
                        Binary::Sub => Instruction::Difference { to, a, b },
                        Binary::Mul => Instruction::Product { to, a, b },
                        _ => Instruction::Binary { operator, to, a, b },
                    });
                }
            }
        }
        tape
    }

    /// Runs the tape; `outputs` receives the roots' values in order (as many as it has room for).
    pub fn run(&mut self, inputs: &[S], outputs: &mut [S]) {
        let v = &mut self.values[..];
        for &(k, to) in &self.inputs {
            v[to as usize] = inputs[k];
        }
        for &instruction in &self.instructions {
            match instruction {
                Instruction::Negate { to, a } => v[to as usize] = -v[a as usize],
                Instruction::Unary { function, to, a } => {
                    v[to as usize] = evaluate::unary(function, v[a as usize]);
                }
                Instruction::SinCos { sin, cos, a } => {
                    (v[sin as usize], v[cos as usize]) = v[a as usize].sin_cos();
                }
                Instruction::SinCosOfDifference { sin, cos, a, b } => {
                    let of_difference = S::sin_cos_of_difference(v[a as usize], v[b as usize]);
                    (v[sin as usize], v[cos as usize]) = of_difference;
                }
                Instruction::Sum { to, a, b } => v[to as usize] = v[a as usize] + v[b as usize],
                Instruction::Difference { to, a, b } => v[to as usize] = v[a as usize] - v[b as usize],
                Instruction::Product { to, a, b } => v[to as usize] = v[a as usize] * v[b as usize],
                Instruction::Binary { operator, to, a, b } => {
                    v[to as usize] = evaluate::binary(operator, v[a as usize], v[b as usize]);
                }
            }
        }
        for (out, &from) in outputs.iter_mut().zip(&self.outputs) {
            *out = v[from as usize];
        }
    }

    /// Number of outputs.
    #[must_use]
    pub fn n_outputs(&self) -> usize {
        self.outputs.len()
    }
}

impl Dag {
    /// Value of an expression without symbols, in f64.
    #[must_use]
    pub fn evaluate_constant(&self, id: ExprId) -> f64 {
        match self.node(id) {
            Node::Number(c) => c.to_f64(),
            Node::Pi => std::f64::consts::PI,
            Node::Symbol(_) => f64::NAN,
            Node::Negate(a) => -self.evaluate_constant(a),
            Node::Unary(function, a) => evaluate::unary(function, self.evaluate_constant(a)),
            Node::Binary(operator, a, b) => {
                evaluate::binary(operator, self.evaluate_constant(a), self.evaluate_constant(b))
            }
        }
    }

    /// The id of a node that exists already.
    #[must_use]
    pub fn find(&self, node: Node) -> Option<ExprId> {
        self.index.find(&self.nodes, &node).ok()
    }
}

/// Values of nodes at several sample points, computed on demand and kept.
#[derive(Clone, Debug)]
pub struct SampleTable {
    symbols: HashMap<SymbolId, Vec<f64>>,
    /// Sizes to which the errors of symbols are relative, where these exceed their values.
    sizes: HashMap<SymbolId, f64>,
    points: usize,
    /// By node: the row of `values` that is its own, or `UNKNOWN` if it has not been computed.
    place: Vec<u32>,
    values: Vec<f64>,
    /// Scratch of [`SampleTable::compute`].
    stack: Vec<ExprId>,
}

const UNKNOWN: u32 = u32::MAX;
/// Capacity reserved, in nodes: address space that becomes memory only as it is filled.
const NODES: usize = 1 << 13;

impl SampleTable {
    /// `symbols[k](s)` is the value of symbol k at sample s.
    #[must_use]
    pub fn new(symbols: HashMap<SymbolId, Vec<f64>>, points: usize) -> Self {
        Self {
            symbols,
            sizes: HashMap::default(),
            points,
            place: Vec::new(),
            values: Vec::with_capacity(NODES * points),
            stack: Vec::new(),
        }
    }

    /// Adds sizes of symbols that were solved for: a value that should be 0 is so only up to the rounding of its size.
    #[must_use]
    pub(crate) fn with_sizes(self, sizes: HashMap<SymbolId, f64>) -> Self {
        Self { sizes, ..self }
    }

    /// The same points with other values of some symbols; nothing computed is kept.
    #[must_use]
    pub(crate) fn with_symbols(mut self, symbols: HashMap<SymbolId, Vec<f64>>) -> Self {
        self.clear();
        self.symbols.extend(symbols);
        self
    }

    /// Sets the values of new symbols; forgets everything computed.
    pub(crate) fn set_symbols(&mut self, symbols: HashMap<SymbolId, Vec<f64>>) {
        self.clear();
        self.symbols.extend(symbols);
    }

    /// Bounds of the rounding errors of expressions at one sample: a value below its bound cannot be told from 0.
    #[must_use]
    pub fn rounding_errors(&self, dag: &Dag, exprs: &[ExprId], sample: usize) -> Vec<f64> {
        let symbol = |symbol: SymbolId| {
            let value = self.symbols.get(&symbol).map_or(f64::NAN, |values| values[sample]);
            Rounded::new(value, f64::EPSILON * self.sizes.get(&symbol).copied().unwrap_or(0.0))
        };
        dag.evaluate(exprs, &symbol).iter().map(|x| x.error).collect()
    }

    /// Number of sample points.
    #[must_use]
    pub fn points(&self) -> usize {
        self.points
    }

    /// Forgets all values and keeps their memory for reuse.
    pub fn clear(&mut self) {
        self.place.clear();
        self.values.clear();
    }

    /// Values of `expr` at every sample; NaN where it depends on a symbol without value.
    pub fn values(&mut self, dag: &Dag, expr: ExprId) -> &[f64] {
        self.compute(dag, expr);
        self.computed(expr)
    }

    /// The values of an expression that has been computed.
    pub(crate) fn computed(&self, expr: ExprId) -> &[f64] {
        let start = self.place[expr.index()] as usize * self.points;
        &self.values[start..start + self.points]
    }

    /// Computes the values of `expr`, unless they are known.
    pub(crate) fn compute(&mut self, dag: &Dag, expr: ExprId) {
        if self.place.len() < dag.len() {
            self.place.resize(dag.len(), UNKNOWN);
        }
        if self.place[expr.index()] != UNKNOWN {
            return;
        }
        let mut stack = std::mem::take(&mut self.stack);
        stack.push(expr);
        while let Some(&id) = stack.last() {
            let depth = stack.len();
            if self.place[id.index()] == UNKNOWN {
                let operands = dag.operands(id).into_iter().flatten();
                stack.extend(operands.filter(|a| self.place[a.index()] == UNKNOWN));
            }
            if stack.len() == depth {
                stack.pop();
                self.append(dag, id);
            }
        }
        self.stack = stack;
    }

    /// Appends the values of a node whose operands are known, unless they are there.
    fn append(&mut self, dag: &Dag, id: ExprId) {
        if self.place[id.index()] != UNKNOWN {
            return;
        }
        let start = self.values.len();
        self.place[id.index()] = u32::try_from(start / self.points).expect("fewer than 2^32 nodes");
        self.values.resize(start + self.points, 0.0);
        let (known, new) = self.values.split_at_mut(start);
        let of = |a: ExprId| &known[self.place[a.index()] as usize * self.points..];
        match dag.node(id) {
            Node::Number(c) => new.fill(c.to_f64()),
            Node::Pi => new.fill(std::f64::consts::PI),
            Node::Symbol(symbol) => match self.symbols.get(&symbol) {
                Some(values) => new.copy_from_slice(values),
                None => new.fill(f64::NAN),
            },
            Node::Negate(a) => new.iter_mut().zip(of(a)).for_each(|(y, a)| *y = -a),
            Node::Unary(function, a) => {
                new.iter_mut().zip(of(a)).for_each(|(y, &a)| *y = evaluate::unary(function, a));
            }
            // The operator is chosen outside the loop over the samples.
            Node::Binary(Binary::Add, a, b) => fill(new, of(a), of(b), |a, b| a + b),
            Node::Binary(Binary::Sub, a, b) => fill(new, of(a), of(b), |a, b| a - b),
            Node::Binary(Binary::Mul, a, b) => fill(new, of(a), of(b), |a, b| a * b),
            Node::Binary(operator, a, b) => {
                fill(new, of(a), of(b), |a, b| evaluate::binary(operator, a, b));
            }
        }
    }
}

/// A function of its own, in which the lists are known not to overlap, so that several samples are taken at a time.
#[inline(never)]
fn fill(to: &mut [f64], a: &[f64], b: &[f64], f: impl Fn(f64, f64) -> f64) {
    to.iter_mut().zip(a.iter().zip(b)).for_each(|(to, (&a, &b))| *to = f(a, b));
}
