//! Linearisation: derivatives of the rates and the outputs by state, inputs and parameters.
//!
//! In: the equations with u' held as symbols, r = M u' - forcing. Out: by the implicit function theorem du'/dx = -M^-1
//! dr/dx (`accelerations`). The state is the coordinates that the configuration constraints leave independent, and the
//! independent speeds. The other coordinates follow, dq = P dq_i with f_q P = 0; motion constraints restrict the speeds
//! only (Peterson, Gede, Hubbard 2015). The state need not be an equilibrium.

use super::accelerations::{self, Direction, Functions};
use super::inertia;
use super::part::Part;
use super::stages::{Stages, Target};
use crate::diagnostic::Diagnostic;
use crate::expr::{ExprId, SymbolId};
use crate::kinematics;
use crate::model::CoordinateId;
use rustc_hash::FxHashSet as HashSet;

type Parts = Result<Vec<Part>, Diagnostic>;

/// The functions that are differentiated.
struct Equations {
    /// M u' - forcing with u' held constant.
    residual: Vec<ExprId>,
    /// Rates of the independent coordinates.
    q_dot: Vec<ExprId>,
    outputs: Vec<ExprId>,
    /// Rates and outputs again, with the dependent unknowns as symbols.
    unsolved: Vec<ExprId>,
    mass: Vec<Vec<ExprId>>,
    /// Names of the independent coordinates and speeds.
    state: Vec<String>,
    output_names: Vec<String>,
}

/// Columns of derivatives, one per direction: of the rates of the state, and of the outputs.
struct Columns {
    rates: Vec<Vec<ExprId>>,
    outputs: Vec<Vec<ExprId>>,
}

pub(super) fn linearisation(stages: &mut Stages, target: &Target) -> Parts {
    let independent = coordinates(stages, true);
    let mut directions =
        independent_directions(stages, &independent).ok_or_else(|| not_following(stages, target))?;
    let equations = Equations::new(stages, &independent);
    let one = stages.alg.dag.one();
    for unknown in stages.k.unknowns.independent() {
        let symbol = stages.alg.dag.as_symbol(stages.k.unknowns[unknown].value);
        directions.push(symbol.into_iter().map(|symbol| (symbol, one)).collect());
    }
    let inputs = stages.k.inputs.iter().copied().collect::<Vec<_>>();
    let inputs = inputs.into_iter().filter_map(|input| stages.alg.dag.as_symbol(input));
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
    let one = stages.alg.dag.one();
    let parameters: Vec<SymbolId> =
        stages.k.parameters.iter().filter_map(|&p| stages.alg.dag.as_symbol(p)).collect();
    let directions: Vec<Direction> = parameters.iter().map(|&p| Direction::from_iter([(p, one)])).collect();
    let columns = equations.columns(stages, &directions);
    let n_q = equations.q_dot.len();
    let row = |i: usize| columns.rates.iter().map(|column| column[n_q + i]).collect::<Vec<_>>();
    let rows: Vec<Vec<ExprId>> = (0..equations.mass.len()).map(row).collect();
    let doc = "u' by the tunable parameters in the order of `PARAMETER_NAMES`, all coordinates and independent speeds held";
    Ok(vec![Part::matrix("u_dot", doc, stages.speed_names(), parameters.len(), &rows)])
}

/// The coordinates in the state that are independent, or those that are not.
fn coordinates(stages: &Stages, independent: bool) -> Vec<CoordinateId> {
    let all = stages.model.coordinates.enumerate().filter(|(_, c)| c.independent == independent);
    all.map(|(id, _)| id).filter(|&id| stages.k.coordinate_symbol(&stages.alg.dag, id).is_some()).collect()
}

/// The error for dependent coordinates that the configuration constraints do not give, with those that none of them
/// reads.
fn not_following(stages: &mut Stages, target: &Target) -> Diagnostic {
    let dag = &stages.alg.dag;
    let read: HashSet<SymbolId> =
        stages.k.residuals.iter().flat_map(|&residual| dag.symbols_of(residual)).collect();
    let is_read = |id| stages.k.coordinate_symbol(dag, id).is_some_and(|symbol| read.contains(&symbol));
    let free = stages.model.coordinates.enumerate().filter(|(id, c)| !c.independent && !is_read(*id));
    let free: Vec<_> = free.filter(|(_, c)| c.closed_form.is_none()).map(|(_, c)| c).collect();
    let error = Diagnostic::error(format!(
        "`{}`: the dependent coordinates do not follow the independent ones",
        target.request
    ));
    let help = "state as many coordinates independent as the configuration constraints leave free";
    match free.as_slice() {
        [] => error.help(help),
        _ => {
            let names: Vec<String> = free.iter().map(|c| format!("`{}`", c.name)).collect();
            free.iter()
                .fold(error, |error, c| error.label(c.span, "no configuration constraint reads it"))
                .help(format!("{help}: mark {} `independent = true`", names.join(", ")))
        }
    }
}

/// One direction an independent coordinate: itself, and the dependent ones that follow it.
fn independent_directions(stages: &mut Stages, independent: &[CoordinateId]) -> Option<Vec<Direction>> {
    let dependent = coordinates(stages, false);
    let one = stages.alg.dag.one();
    let symbols = |stages: &Stages, list: &[CoordinateId]| -> Vec<SymbolId> {
        list.iter().filter_map(|&c| stages.k.coordinate_symbol(&stages.alg.dag, c)).collect()
    };
    let own = symbols(stages, independent);
    let mut directions: Vec<Direction> =
        own.iter().map(|&symbol| Direction::from_iter([(symbol, one)])).collect();
    if dependent.is_empty() {
        return Some(directions);
    }
    let follow = symbols(stages, &dependent);
    let slopes =
        match kinematics::speeds_by_rates(stages.alg, stages.model, stages.k, stages.solution, independent) {
            Some(speeds) => {
                kinematics::slopes_by_speeds(stages.alg, stages.k, stages.solution, &dependent, &speeds)
            }
            None => kinematics::dependent_slopes(stages.alg, stages.k, stages.table, &follow, &own)?,
        };
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
            q_dot.push(rate.value(stages.alg, stages.k));
        }
        let outputs =
            stages.model.outputs.iter().map(|o| kinematics::lower_scalar(stages.alg, stages.k, &o.value));
        let outputs: Vec<ExprId> = outputs.collect();
        let unsolved = [&q_dot[..], &outputs].concat();
        let (q_dot, outputs) = (stages.solved(&q_dot), stages.solved(&outputs));
        // Coordinates in closed form change with those that they depend on.
        let forms = stages.k.closed_form_values(&mut stages.alg.dag);
        let mut closed = |list: &[ExprId]| stages.alg.dag.substitute(list, &forms);
        let (residual, q_dot, outputs) = (closed(&residual), closed(&q_dot), closed(&outputs));
        let mass = stages.dynamics.mass_matrix.iter().map(|row| closed(row)).collect();
        let names = independent.iter().map(|&c| stages.model.coordinates[c].name.clone());
        let state = names.chain(stages.speed_names()).collect();
        let output_names = stages.model.outputs.iter().map(|o| o.name.clone()).collect();
        Self { residual, q_dot, outputs, unsolved, mass, state, output_names }
    }

    fn columns(&self, stages: &mut Stages, directions: &[Direction]) -> Columns {
        let Self { residual, mass, unsolved, .. } = self;
        let others = [&self.q_dot[..], &self.outputs].concat();
        let functions = Functions { residual, mass, others: &others, unsolved };
        let mut columns = Columns { rates: Vec::new(), outputs: Vec::new() };
        for column in accelerations::columns(stages, &functions, directions) {
            let (u_dot, others) = column.split_at(residual.len());
            let (q_dot, outputs) = others.split_at(self.q_dot.len());
            columns.rates.push([q_dot, u_dot].concat());
            columns.outputs.push(outputs.to_vec());
        }
        columns
    }
}
