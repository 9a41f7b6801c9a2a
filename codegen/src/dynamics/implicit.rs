//! The residual M u' - forcing in a form that is cheap to differentiate: the eliminations are held as symbols.
//!
//! In: rows J y = 0 and J y' + b = 0, forces f missing on the unknowns y at given y'. Out: r = T' (f - J' lambda) as a
//! function of coordinates, independent speeds and inputs, in which T, lambda of J_d' lambda = f_d and the factors of
//! J_d are symbols. y and y' are corrected once by Newton's method, y <- y - J_d^-1 (J y); the derivative of this step
//! is that of the implicit function theorem, so that no coefficient of the eliminations is differentiated.

use super::given::Given;
use super::inverse::{missing_at, on_independent};
use crate::expr::tape::SampleTable;
use crate::expr::{Dag, Dependence, ExprId, SymbolId};
use crate::kinematics::eliminate::Solution;
use crate::kinematics::factored::Factored;
use crate::kinematics::{Kinematics, LinearForm};
use crate::model::Model;
use crate::vector::Algebra;
use rustc_hash::FxHashMap as HashMap;

type ByUnknown = LinearForm;

/// r, and the values of its symbols.
pub(crate) struct Implicit {
    /// r, one entry per independent speed.
    pub residual: Vec<ExprId>,
    /// Other expressions of q and y, with the corrected y.
    pub others: Vec<ExprId>,
    /// The expressions that replace its symbols, to be substituted list by list: each list depends on symbols of later
    /// lists.
    values: [HashMap<SymbolId, ExprId>; 3],
}

impl Implicit {
    /// The residual at given u'. `None` if nothing was eliminated, or if there are more rows than eliminated unknowns.
    /// Adds the values of the symbols to the table.
    pub fn new(
        alg: &mut Algebra,
        model: &Model,
        k: &Kinematics,
        table: &mut SampleTable,
        solution: &Solution,
        (u_dot, others): (&[ExprId], &[ExprId]),
    ) -> Option<Self> {
        if solution.steps.is_empty() {
            return None;
        }
        let factored = Factored::new(alg, k, table, solution)?;
        let mut coefficients = Held::default();
        let factors = factored.map(|e| coefficients.hold(&mut alg.dag, e));
        let mut held = solution.clone();
        for c in held.steps.iter_mut().flat_map(|step| step.coefficients.values_mut()) {
            *c = coefficients.hold(&mut alg.dag, *c);
        }
        let mut y_dot: ByUnknown = k.unknowns.independent().into_iter().zip(u_dot.iter().copied()).collect();
        let derivatives = solution.derivatives(alg, y_dot.clone());
        let mut accelerations = Held::default();
        for y in k.unknowns.dependent() {
            y_dot.insert(y, accelerations.fresh(&mut alg.dag, derivatives[&y]));
        }
        let mut forces = missing_at(alg, model, k, &Given::all(y_dot.clone()));
        let mut multipliers = Held::default();
        take_multipliers(alg, k, solution, &factored, (&y_dot, &mut forces), &mut multipliers);
        let corrected = corrected(alg, k, solution, &factors, &y_dot);
        let residual = on_independent(alg, k, &held, forces);
        let residual = alg.dag.substitute(&residual, &corrected);
        let others = alg.dag.substitute(others, &corrected);
        for held in [&coefficients, &accelerations, &multipliers] {
            let values = held.values.iter().map(|(&s, &value)| (s, table.values(&alg.dag, value).to_vec()));
            let values = values.collect();
            table.set_symbols(values);
        }
        Some(Self {
            residual,
            others,
            values: [multipliers, accelerations, coefficients].map(|held| held.values),
        })
    }

    /// Replaces the symbols in these expressions by their values.
    pub fn put_in(&self, dag: &mut Dag, list: &[ExprId]) -> Vec<ExprId> {
        self.values.iter().fold(list.to_vec(), |list, values| dag.substitute(&list, values))
    }
}

/// f - J' lambda, with lambda of J_d' lambda = f_d as symbols.
fn take_multipliers(
    alg: &mut Algebra,
    k: &Kinematics,
    solution: &Solution,
    factored: &Factored,
    (y_dot, forces): (&ByUnknown, &mut ByUnknown),
    held: &mut Held,
) {
    let dependent = k.unknowns.dependent();
    let of_dependent = dependent.into_iter().filter_map(|y| Some((y, *forces.get(&y)?))).collect();
    let lambda = factored.solve_transposed(&mut alg.dag, of_dependent);
    for (row, lambda) in solution.rows.iter().zip(lambda) {
        let lambda = held.hold(&mut alg.dag, lambda);
        for (&y, &coefficient) in row.coefficients.iter().filter(|(y, _)| y_dot.contains_key(y)) {
            let term = alg.dag.mul(coefficient, lambda);
            let force = forces.get(&y).copied().unwrap_or_else(|| alg.dag.zero());
            forces.insert(y, alg.dag.sub(force, term));
        }
    }
}

/// The expressions for the symbols of the dependent y and y': each less its Newton correction.
fn corrected(
    alg: &mut Algebra,
    k: &Kinematics,
    solution: &Solution,
    factors: &Factored,
    y_dot: &ByUnknown,
) -> HashMap<SymbolId, ExprId> {
    let dependent = k.unknowns.dependent();
    let (mut velocity, mut acceleration) = (Vec::new(), Vec::new());
    for row in &solution.rows {
        let (mut first, mut second) = (alg.dag.zero(), row.bias);
        for (unknown, &coefficient) in &row.coefficients {
            let term = alg.dag.mul(coefficient, k.unknowns[*unknown].value);
            first = alg.dag.add(first, term);
            // The clock has no y'.
            if let Some(&y_dot) = y_dot.get(unknown) {
                let term = alg.dag.mul(coefficient, y_dot);
                second = alg.dag.add(second, term);
            }
        }
        velocity.push(first);
        acceleration.push(second);
    }
    let mut corrected: HashMap<SymbolId, ExprId> = HashMap::default();
    let values: Vec<ExprId> = dependent.iter().map(|&y| k.unknowns[y].value).collect();
    let derivatives: Vec<ExprId> = dependent.iter().map(|y| y_dot[y]).collect();
    for (rows, symbols) in [(velocity, values), (acceleration, derivatives)] {
        let rows = alg.dag.substitute(&rows, &corrected);
        let change = factors.solve(&mut alg.dag, rows);
        for (y, symbol) in dependent.iter().zip(symbols) {
            let new = alg.dag.sub(symbol, change[y]);
            corrected.extend(alg.dag.as_symbol(symbol).map(|id| (id, new)));
        }
    }
    corrected
}

/// Symbols in place of expressions that shall not be differentiated.
#[derive(Default)]
struct Held {
    symbols: HashMap<ExprId, ExprId>,
    values: HashMap<SymbolId, ExprId>,
}

impl Held {
    /// The symbol for an expression; an expression of parameters alone is returned as it is.
    fn hold(&mut self, dag: &mut Dag, value: ExprId) -> ExprId {
        if dag.dependence(value) < Dependence::State {
            return value;
        }
        let unsigned = dag.unsigned(value);
        if unsigned != value {
            let symbol = self.hold(dag, unsigned);
            return dag.negate(symbol);
        }
        if let Some(&symbol) = self.symbols.get(&value) {
            return symbol;
        }
        let symbol = self.fresh(dag, value);
        self.symbols.insert(value, symbol);
        symbol
    }

    /// A new symbol for an expression.
    fn fresh(&mut self, dag: &mut Dag, value: ExprId) -> ExprId {
        let symbol = dag.symbol("held");
        self.values.extend(dag.as_symbol(symbol).map(|id| (id, value)));
        symbol
    }
}
