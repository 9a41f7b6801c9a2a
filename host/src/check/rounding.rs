//! The rounding error of each output in single precision, and the operation that causes most of it.
//!
//! In: a program and sampled configurations. Out: for each output the largest difference between the program in f32 and
//! in f64 at the same f32 arguments, relative to the largest value of the output; and, where it is largest, the
//! operation whose rounding changes the output most: each operation of the f64 evaluation in turn is rounded to f32
//! while all others stay exact. Deterministic.

use serde_json::{Value, json};
use smartbed_codegen::Program;
use smartbed_codegen::expr::tape::Tape;
use smartbed_codegen::expr::{Dag, ExprId, Node, SymbolId, evaluate};
use smartbed_codegen::id::Id;
use smartbed_runtime::real::Scalar;

/// States drawn per sampled configuration.
const DRAWS: usize = 4;
/// Speeds are drawn between plus and minus this (rad/s, m/s).
const SPEEDS: f64 = 1.0;
/// Inputs are drawn between plus and minus this (N, N m).
const INPUTS: f64 = 10.0;
/// Fractional parts of multiples of the golden ratio cover the unit interval evenly.
const GOLDEN: f64 = 0.618_033_988_749_894_9;
/// Longest expression that is shown.
const SHOWN: usize = 64;

/// An output and its rounding error.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Rounding {
    /// Its name: a rate as `q'`, an energy, or an output of the model.
    pub output: String,
    /// Largest difference of f32 from f64, over the largest value of the output.
    pub error: f64,
    /// The operation whose rounding changes it most at that state; `None` if nothing is rounded.
    pub operation: Option<String>,
    /// The change, relative to the same value.
    pub moves: f64,
}

/// Surveys every output that is not zero throughout.
pub(super) fn survey(program: &Program, samples: (&[Vec<f64>], &[f64])) -> Vec<Rounding> {
    let symbols = symbols(program);
    let (names, roots): (Vec<String>, Vec<ExprId>) = outputs(program).into_iter().unzip();
    let states = states(program, samples);
    let double = run::<f64>(program, &roots, &symbols, &states);
    let single = run::<f32>(program, &roots, &symbols, &states);
    let mut found = Vec::new();
    for (k, output) in names.into_iter().enumerate() {
        let scale = double.iter().fold(0.0_f64, |most, row| most.max(row[k].abs()));
        let errors = double.iter().zip(&single).map(|(d, s)| (d[k] - s[k]).abs());
        let worst = errors.enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
        let Some((state, error)) = worst.filter(|_| scale > 0.0) else { continue };
        let cause = Trace::new(&program.dag, roots[k], &symbols, &states[state]).worst();
        found.push(Rounding {
            output,
            error: error / scale,
            operation: cause.map(|(id, _)| name(&program.dag, id)),
            moves: cause.map_or(0.0, |(_, by)| by / scale),
        });
    }
    found
}

/// The survey as JSON.
pub(super) fn facts(found: &[Rounding]) -> Value {
    let row = |r: &Rounding| json!({ "output": r.output, "error": r.error, "operation": r.operation, "moves": r.moves });
    found.iter().map(row).collect()
}

/// All arguments of the program: time, state, inputs, parameters.
fn symbols(program: &Program) -> Vec<SymbolId> {
    let groups = [&program.q, &program.u, &program.inputs, &program.parameters];
    let named = groups.into_iter().flatten().map(|quantity| quantity.symbol);
    std::iter::once(program.time).chain(named).collect()
}

fn outputs(program: &Program) -> Vec<(String, ExprId)> {
    let rates = program.q.iter().chain(&program.u).zip(program.forward_dynamics());
    let mut outputs: Vec<(String, ExprId)> =
        rates.map(|(of, rate)| (format!("{}'", of.name), rate)).collect();
    let [kinetic, potential] = program.energy;
    outputs.extend([("kinetic energy".to_owned(), kinetic), ("potential energy".to_owned(), potential)]);
    outputs.extend(program.outputs.iter().cloned());
    outputs
}

/// Numbers for [`symbols`], all exact in f32, at the samples' times.
fn states(program: &Program, (samples, times): (&[Vec<f64>], &[f64])) -> Vec<Vec<f64>> {
    let mut drawn = 0;
    let mut draw = |within: f64| {
        drawn += 1;
        within * (2.0 * (f64::from(drawn) * GOLDEN).fract() - 1.0)
    };
    let mut states = Vec::new();
    for (q, &t) in samples.iter().zip(times) {
        for _ in 0..DRAWS {
            let mut state = vec![t];
            state.extend(q);
            state.extend(program.u.iter().map(|_| draw(SPEEDS)));
            state.extend(program.inputs.iter().map(|_| draw(INPUTS)));
            state.extend(program.parameters.iter().map(|p| p.value));
            states.push(state.into_iter().map(single).collect());
        }
    }
    states
}

/// A number rounded to f32.
fn single(x: f64) -> f64 {
    f64::from(x as f32)
}

/// The roots at all states, row by row.
fn run<S: Scalar>(
    program: &Program,
    roots: &[ExprId],
    symbols: &[SymbolId],
    states: &[Vec<f64>],
) -> Vec<Vec<f64>> {
    // A symbol that the program does not use has no node.
    let node = |(k, &symbol): (usize, &SymbolId)| Some((k, program.dag.find(Node::Symbol(symbol))?));
    let (places, known): (Vec<usize>, Vec<ExprId>) = symbols.iter().enumerate().filter_map(node).unzip();
    let mut tape = Tape::<S>::above(&program.dag, roots, &known);
    let mut out = vec![S::ZERO; roots.len()];
    let mut rows = Vec::new();
    for state in states {
        let inputs: Vec<S> = places.iter().map(|&k| S::from_f64(state[k])).collect();
        tape.run(&inputs, &mut out);
        rows.push(out.iter().map(|x| x.to_f64()).collect());
    }
    rows
}

/// Evaluation of one output at one state, operation by operation in f64.
struct Trace<'a> {
    dag: &'a Dag,
    order: Vec<ExprId>,
    /// By node.
    values: Vec<f64>,
}

impl<'a> Trace<'a> {
    fn new(dag: &'a Dag, root: ExprId, symbols: &[SymbolId], state: &[f64]) -> Self {
        let order = dag.reachable_above(&[root], |id| dag.is_constant(id));
        let mut values = vec![0.0; root.index() + 1];
        for &id in &order {
            let given = dag.as_symbol(id).and_then(|symbol| symbols.iter().position(|s| *s == symbol));
            values[id.index()] = match given {
                Some(k) => state[k],
                None if dag.is_constant(id) => dag.evaluate_constant(id),
                None => operation(dag, id, &values),
            };
        }
        Self { dag, order, values }
    }

    /// The node whose rounding changes the root most, and by how much.
    fn worst(&self) -> Option<(ExprId, f64)> {
        let rounded = self.order.iter().enumerate().filter(|(_, id)| {
            let value = self.values[id.index()];
            single(value) != value && !matches!(self.dag.node(**id), Node::Negate(_))
        });
        let moved = rounded.map(|(at, &id)| (id, self.moved_by(at)));
        moved.filter(|(_, by)| *by > 0.0).max_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// Change of the root if the node at this index of the order alone is rounded.
    fn moved_by(&self, at: usize) -> f64 {
        let mut values = self.values.clone();
        let mut changed = vec![false; values.len()];
        let start = self.order[at].index();
        values[start] = single(values[start]);
        changed[start] = true;
        for &id in &self.order[at + 1..] {
            let above = self.dag.operands(id).into_iter().flatten().any(|a| changed[a.index()]);
            if above && !self.dag.is_constant(id) {
                values[id.index()] = operation(self.dag, id, &values);
                changed[id.index()] = true;
            }
        }
        let root = values.len() - 1;
        (values[root] - self.values[root]).abs()
    }
}

/// The value of a node, computed from its operands.
fn operation(dag: &Dag, id: ExprId, values: &[f64]) -> f64 {
    match dag.node(id) {
        Node::Negate(a) => -values[a.index()],
        Node::Unary(function, a) => evaluate::unary(function, values[a.index()]),
        Node::Binary(operator, a, b) => evaluate::binary(operator, values[a.index()], values[b.index()]),
        Node::Number(_) | Node::Pi | Node::Symbol(_) => f64::NAN,
    }
}

/// The label and the expression of a node.
fn name(dag: &Dag, id: ExprId) -> String {
    let text = dag.print(id, SHOWN);
    dag.name_of(id).map_or(text.clone(), |name| format!("{name} = {text}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use smartbed_codegen::expr::Unary;

    /// exp(x) - 1 for a small x: the exponential is near 1 and its rounding large beside the difference.
    #[test]
    fn the_operation_that_cancels_is_named() {
        let mut dag = Dag::default();
        let x = dag.symbol("x");
        let root = dag.unary(Unary::Exp, x);
        let one = dag.one();
        let root = dag.sub(root, one);
        let symbol = dag.as_symbol(x).expect("a symbol");
        let at = single(1e-4);
        let trace = Trace::new(&dag, root, &[symbol], &[at]);
        let (cause, by) = trace.worst().expect("something is rounded");
        assert_eq!(dag.print(cause, SHOWN), "exp(x)");
        // Half a unit in the last place of 1 at most; that of the difference is ten thousand times smaller.
        let expected = (single(at.exp()) - at.exp()).abs();
        assert!((by - expected).abs() <= 1e-15 && by > 1e-10, "{by:e} {expected:e}");
    }
}
