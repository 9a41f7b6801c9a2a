//! The results of the stages from which answers are derived.

use crate::dynamics::Dynamics;
use crate::expr::tape::SampleTable;
use crate::expr::{ExprId, SymbolId};
use crate::kinematics::eliminate::Solution;
use crate::kinematics::{Algebra, Kinematics, Marker, ParameterChoice};
use crate::model::Model;
use crate::value::Effort;
use rustc_hash::FxHashMap as HashMap;

/// Numbers in [-1, 1] without repetition: fractional parts of multiples of the golden section.
fn scattered(i: usize, sample: usize) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    2.0 * ((1 + 101 * i + sample) as f64 * GOLDEN).fract() - 1.0
}

/// Kinematics, constraints and dynamics of a model, and the symbols of given accelerations.
pub struct Stages<'s> {
    /// The algebra in which expressions are made.
    pub alg: &'s mut Algebra,
    /// The model, with the wrenches of the requested ports as inputs.
    pub model: &'s Model,
    /// Its kinematics.
    pub k: &'s Kinematics,
    /// The solution of the constraints.
    pub solution: &'s Solution,
    /// Mass matrix, forcing, values of the dependent unknowns.
    pub dynamics: &'s Dynamics,
    /// Values at the sampled configurations.
    pub table: &'s mut SampleTable,
    /// Symbols for given u', one per independent speed.
    pub u_dot: Vec<ExprId>,
    /// Number of the model's own inputs; those of wrenches follow them.
    pub own_inputs: usize,
    /// How its parameters are treated.
    pub choice: &'s ParameterChoice,
    /// Effort spent on reducing the number of operations.
    pub effort: Effort,
}

/// The subject of an answer.
#[derive(Clone, Debug)]
pub struct Target {
    /// The request as it is written, for messages.
    pub request: String,
    /// The frame and the point, if the answer is about a place.
    pub marker: Option<Marker>,
}

impl<'s> Stages<'s> {
    /// The stages of a model. If an answer needs u' as symbols, adds these, with values at the samples.
    pub fn new(
        alg: &'s mut Algebra,
        (model, choice): (&'s Model, &'s ParameterChoice),
        k: &'s Kinematics,
        (solution, dynamics): (&'s Solution, &'s Dynamics),
        table: &'s mut SampleTable,
        (own_inputs, takes_u_dot, effort): (usize, bool, Effort),
    ) -> Self {
        let mut u_dot = Vec::new();
        if takes_u_dot {
            let names = k.unknowns.independent().into_iter().map(|u| format!("{}_dot", k.unknowns[u].name));
            u_dot = names.collect::<Vec<_>>().iter().map(|name| alg.dag.symbol(name)).collect();
            let mut values = HashMap::default();
            for (i, symbol) in u_dot.iter().filter_map(|&e| alg.dag.as_symbol(e)).enumerate() {
                values.insert(symbol, (0..table.points()).map(|sample| scattered(i, sample)).collect());
            }
            table.set_symbols(values);
        }
        Self { alg, model, k, solution, dynamics, table, u_dot, own_inputs, choice, effort }
    }

    /// Number of independent speeds.
    pub fn n_speeds(&self) -> usize {
        self.k.unknowns.independent().len()
    }

    /// Names of the independent speeds.
    pub fn speed_names(&self) -> Vec<String> {
        let independent = self.k.unknowns.independent();
        independent.into_iter().map(|u| self.k.unknowns[u].name.clone()).collect()
    }

    /// Expressions with the dependent unknowns replaced by their values in the independent speeds.
    pub fn solved(&mut self, values: &[ExprId]) -> Vec<ExprId> {
        self.alg.dag.substitute(values, &self.dynamics.values)
    }

    /// Symbols of the model's own inputs.
    pub fn input_symbols(&self) -> Vec<SymbolId> {
        let inputs = self.k.inputs.iter().take(self.own_inputs);
        inputs.filter_map(|&input| self.alg.dag.as_symbol(input)).collect()
    }
}
