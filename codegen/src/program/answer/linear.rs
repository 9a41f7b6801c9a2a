//! Linearisation: how the rates and the outputs answer to small changes of state, inputs and parameters.
//!
//! In: the equations with u' held as symbols, r = M u' - forcing. Out: by the implicit function theorem
//! du'/dx = -M^-1 dr/dx, with dr/dx by one sweep a direction or by eliminations on the graph of operations. State: the
//! coordinates that the configuration constraints leave independent, and the independent speeds; the other coordinates
//! follow, dq = P dq_i with f_q P = 0, while motion constraints restrict the speeds only (Peterson, Gede, Hubbard
//! 2015). The state need not be an equilibrium.

use super::inertia;
use super::part::Part;
use super::stages::{Stages, Target};
use crate::diagnostic::Diagnostic;
use crate::dynamics;
use crate::expr::{ExprId, SymbolId};
use crate::kinematics;
use crate::model::CoordinateId;
use rustc_hash::FxHashMap as HashMap;

type Parts = Result<Vec<Part>, Diagnostic>;
/// Symbols that change together, and how fast.
type Direction = HashMap<SymbolId, ExprId>;

/// Operations by eliminations on the graph over those by one sweep a direction, from which on the former are taken: the
/// value graph shortens the latter by up to a tenth more (bicycle: 5,696 and 6,130 become 5,777 and 5,049).
const CLEARLY_LESS: f64 = 0.9;
/// Nodes times directions times results, beyond which eliminations on the graph take too long.
const MOST_WORK: usize = 4_000_000;

/// What is differentiated.
struct Equations {
    /// M u' - forcing at held u'.
    residual: Vec<ExprId>,
    /// Rates of the independent coordinates.
    q_dot: Vec<ExprId>,
    outputs: Vec<ExprId>,
    mass: Vec<Vec<ExprId>>,
    /// Names of the independent coordinates and speeds.
    state: Vec<String>,
    output_names: Vec<String>,
}

/// Columns of derivatives, one a direction: of the rates of the state, and of the outputs.
struct Columns {
    rates: Vec<Vec<ExprId>>,
    outputs: Vec<Vec<ExprId>>,
}

pub(super) fn linearisation(stages: &mut Stages, target: &Target) -> Parts {
    let independent = coordinates(stages, true);
    let mut directions = independent_directions(stages, &independent).ok_or_else(|| {
        Diagnostic::error(format!(
            "`{}`: the dependent coordinates do not follow the independent ones",
            target.request
        ))
        .help("state as many coordinates independent as the configuration constraints leave free")
    })?;
    let equations = Equations::new(stages, &independent);
    let one = stages.k.dag.one();
    for unknown in stages.k.independent_unknowns() {
        let symbol = stages.k.dag.as_symbol(stages.k.unknowns[unknown].value);
        directions.push(symbol.into_iter().map(|symbol| (symbol, one)).collect());
    }
    let inputs = stages.k.inputs.iter().copied().collect::<Vec<_>>();
    let inputs = inputs.into_iter().filter_map(|input| stages.k.dag.as_symbol(input));
    let inputs: Vec<Direction> = inputs.map(|symbol| Direction::from_iter([(symbol, one)])).collect();
    let by_state = equations.columns(stages, &directions);
    let by_input = equations.columns(stages, &inputs);
    let Equations { state, output_names, .. } = equations;
    let matrix = |name, doc: &str, labels: &[String], columns: &[Vec<ExprId>]| {
        let rows: Vec<Vec<ExprId>> =
            (0..labels.len()).map(|i| columns.iter().map(|column| column[i]).collect()).collect();
        Part::matrix(name, doc, labels.to_vec(), columns.len(), &rows)
    };
    Ok(vec![
        matrix(
            "a",
            "rates of the state by the state, x = (independent q, independent u)",
            &state,
            &by_state.rates,
        ),
        matrix("b", "rates of the state by the inputs", &state, &by_input.rates),
        matrix("c", "outputs by the state", &output_names, &by_state.outputs),
        matrix("d", "outputs by the inputs", &output_names, &by_input.outputs),
    ])
}

pub(super) fn parameter_derivatives(stages: &mut Stages, _: &Target) -> Parts {
    let all = coordinates(stages, true);
    let equations = Equations::new(stages, &all);
    let one = stages.k.dag.one();
    let parameters: Vec<SymbolId> =
        stages.k.parameters.iter().filter_map(|&p| stages.k.dag.as_symbol(p)).collect();
    let directions: Vec<Direction> = parameters.iter().map(|&p| Direction::from_iter([(p, one)])).collect();
    let columns = equations.columns(stages, &directions);
    let n_q = equations.q_dot.len();
    let row = |i: usize| columns.rates.iter().map(|column| column[n_q + i]).collect::<Vec<_>>();
    let rows: Vec<Vec<ExprId>> = (0..equations.mass.len()).map(row).collect();
    let doc = "u' by the tunable parameters in the order of `PARAMETER_NAMES`, all coordinates and independent speeds held";
    Ok(vec![Part::matrix("u_dot", doc, stages.speed_names(), parameters.len(), &rows)])
}

/// Coordinates that are state: independent or not.
fn coordinates(stages: &Stages, independent: bool) -> Vec<CoordinateId> {
    let all = stages.model.coordinates.enumerate().filter(|(_, c)| c.independent == independent);
    all.map(|(id, _)| id).filter(|&id| stages.k.coordinate_symbol(id).is_some()).collect()
}

/// One direction an independent coordinate: itself, and the dependent ones that follow it.
fn independent_directions(stages: &mut Stages, independent: &[CoordinateId]) -> Option<Vec<Direction>> {
    let dependent = coordinates(stages, false);
    let one = stages.k.dag.one();
    let symbols = |stages: &Stages, list: &[CoordinateId]| -> Vec<SymbolId> {
        list.iter().filter_map(|&c| stages.k.coordinate_symbol(c)).collect()
    };
    let own = symbols(stages, independent);
    let mut directions: Vec<Direction> =
        own.iter().map(|&symbol| Direction::from_iter([(symbol, one)])).collect();
    if dependent.is_empty() {
        return Some(directions);
    }
    let follow = symbols(stages, &dependent);
    let slopes = kinematics::dependent_slopes(stages.k, stages.table, &follow, &own)?;
    for (&symbol, row) in follow.iter().zip(&slopes) {
        for (direction, &slope) in directions.iter_mut().zip(row) {
            direction.insert(symbol, slope);
        }
    }
    Some(directions)
}

impl Equations {
    fn new(stages: &mut Stages, independent: &[CoordinateId]) -> Self {
        let residual = inertia::recursive(stages);
        let mut q_dot = Vec::new();
        for &c in independent {
            let rate = stages.k.rates[c].clone();
            q_dot.push(kinematics::rate_of(stages.k, &rate));
        }
        let outputs = stages.model.outputs.iter().map(|o| kinematics::lower_scalar(stages.k, &o.value));
        let outputs: Vec<ExprId> = outputs.collect();
        let (q_dot, outputs) = (stages.solved(&q_dot), stages.solved(&outputs));
        // Coordinates in closed form change with those that they are forms of.
        let forms = stages.k.closed_form_values();
        let mut closed = |list: &[ExprId]| stages.k.dag.substitute(list, &forms);
        let (residual, q_dot, outputs) = (closed(&residual), closed(&q_dot), closed(&outputs));
        let mass = stages.dynamics.mass_matrix.iter().map(|row| closed(row)).collect();
        let names = independent.iter().map(|&c| stages.model.coordinates[c].name.clone());
        let state = names.chain(stages.speed_names()).collect();
        let output_names = stages.model.outputs.iter().map(|o| o.name.clone()).collect();
        Self { residual, q_dot, outputs, mass, state, output_names }
    }

    fn columns(&self, stages: &mut Stages, directions: &[Direction]) -> Columns {
        let q_dot = forward(stages, &self.q_dot, directions);
        let outputs = forward(stages, &self.outputs, directions);
        let residual = forward(stages, &self.residual, directions);
        let mut u_dot = self.accelerations(stages, &residual);
        let work = stages.k.dag.reachable(&self.residual).len() * directions.len() * self.residual.len();
        if work <= MOST_WORK {
            let residual = eliminated(stages, &self.residual, directions);
            let other = self.accelerations(stages, &residual);
            let cost = |columns: &[Vec<ExprId>]| {
                stages.k.dag.state_cost(&[&stages.dynamics.u_dot[..], &columns.concat()].concat()) as f64
            };
            if cost(&other) < CLEARLY_LESS * cost(&u_dot) {
                u_dot = other;
            }
        }
        let rates = q_dot.into_iter().zip(u_dot).map(|(first, second)| [first, second].concat()).collect();
        Columns { rates, outputs }
    }

    /// Columns of u' from those of the residual.
    fn accelerations(&self, stages: &mut Stages, residual: &[Vec<ExprId>]) -> Vec<Vec<ExprId>> {
        let dag = &mut stages.k.dag;
        let u_dot = dynamics::response(dag, &self.mass, residual);
        // The u' that were held are those of the state.
        let held: HashMap<SymbolId, ExprId> = (stages.u_dot.iter().zip(&stages.dynamics.u_dot))
            .filter_map(|(&symbol, &value)| Some((dag.as_symbol(symbol)?, value)))
            .collect();
        u_dot.iter().map(|column| dag.substitute(column, &held)).collect()
    }
}

/// One sweep a direction.
fn forward(stages: &mut Stages, of: &[ExprId], directions: &[Direction]) -> Vec<Vec<ExprId>> {
    let dag = &mut stages.k.dag;
    directions.iter().map(|along| of.iter().map(|&e| dag.rate(e, along)).collect()).collect()
}

/// All of them at once, by eliminations on the graph of operations.
fn eliminated(stages: &mut Stages, of: &[ExprId], directions: &[Direction]) -> Vec<Vec<ExprId>> {
    let rows = stages.k.dag.jacobian(of, directions);
    (0..directions.len()).map(|d| rows.iter().map(|row| row[d]).collect()).collect()
}
