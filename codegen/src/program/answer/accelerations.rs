//! Derivatives of u' along directions, in the form with the fewest operations.
//!
//! In: r = M u' - forcing with u' held constant, and directions in which symbols change. Out: columns of du' = -M^-1
//! dr. Three forms of dr compete: one sweep per direction; vertex elimination on the graph of operations
//! (`expr/jacobian.rs`); the latter with the constraints differentiated implicitly (`dynamics/implicit.rs`). Since
//! every direction pays for the operations of r, each form is also tried with r shortened by the value graph together
//! with the forward dynamics, whose values it may share.

use super::stages::Stages;
use crate::dynamics::{self, Implicit};
use crate::expr::{Dag, ExprId, SymbolId};
use crate::value::{self, Effort, States};
use rustc_hash::FxHashMap as HashMap;

/// Symbols that change together, with their rates.
pub(super) type Direction = HashMap<SymbolId, ExprId>;
type Columns = Vec<Vec<ExprId>>;

/// Limit of nodes times directions times results above which vertex elimination takes too long.
const MOST_WORK: usize = 4_000_000;
/// Number of samples at which round-off is watched: the nominal one and the last ones.
const WATCHED: usize = 3;

/// Derivatives by one sweep per direction.
pub(super) fn sweeps(dag: &mut Dag, of: &[ExprId], directions: &[Direction]) -> Columns {
    directions.iter().map(|along| of.iter().map(|&e| dag.rate(e, along)).collect()).collect()
}

/// Derivatives along all directions at once, by vertex elimination on the graph of operations.
fn eliminations(dag: &mut Dag, of: &[ExprId], directions: &[Direction]) -> Columns {
    let rows = dag.jacobian(of, directions);
    (0..directions.len()).map(|d| rows.iter().map(|row| row[d]).collect()).collect()
}

/// The functions that are differentiated.
pub(super) struct Functions<'e> {
    /// M u' - forcing with u' held constant.
    pub residual: &'e [ExprId],
    pub mass: &'e [Vec<ExprId>],
    /// Other functions of the state.
    pub others: &'e [ExprId],
    /// The other functions again, with the dependent unknowns as symbols.
    pub unsolved: &'e [ExprId],
}

/// Columns of derivatives: of u', then of the other functions.
pub(super) fn columns(stages: &mut Stages, of: &Functions, directions: &[Direction]) -> Columns {
    let n = of.residual.len();
    let all = [of.residual, of.others].concat();
    let work = stages.alg.dag.reachable(&all).len() * directions.len() * all.len();
    // If everything is linear in all directions, the forms do not differ.
    if is_linear(&mut stages.alg.dag, &all, directions) || work > MOST_WORK {
        let found = sweeps(&mut stages.alg.dag, &all, directions);
        return solved(stages, of.mass, &found);
    }
    let anew = [&expressed_anew(stages, of.residual)[..], &all[n..]].concat();
    let mut forms: Vec<Columns> = Vec::new();
    for roots in [&all, &anew] {
        forms.push(sweeps(&mut stages.alg.dag, roots, directions));
        forms.push(eliminations(&mut stages.alg.dag, roots, directions));
    }
    forms.extend(implicit(stages, of, directions));
    let forms: Vec<Columns> = forms.iter().map(|form| solved(stages, of.mass, form)).collect();
    let costs: Vec<usize> = forms.iter().map(|form| cost(stages, form)).collect();
    let least = forms.into_iter().zip(costs).min_by_key(|(_, cost)| *cost);
    least.map(|(form, _)| form).unwrap_or_default()
}

/// Columns with the constraints differentiated implicitly, for the residual as derived and for the shortened one.
fn implicit(stages: &mut Stages, of: &Functions, directions: &[Direction]) -> Vec<Columns> {
    let given = (&stages.u_dot.clone()[..], of.unsolved);
    let Some(implicit) =
        Implicit::new(stages.alg, stages.model, stages.k, stages.table, stages.solution, given)
    else {
        return Vec::new();
    };
    let directions = with_closed_forms(stages, directions);
    let closed_forms = stages.k.closed_form_values(&mut stages.alg.dag);
    let mut forms = Vec::new();
    for residual in [implicit.residual.clone(), expressed_anew(stages, &implicit.residual)] {
        let roots = [&residual[..], &implicit.others].concat();
        let mut columns = eliminations(&mut stages.alg.dag, &roots, &directions);
        for column in &mut columns {
            let whole = implicit.put_in(&mut stages.alg.dag, column);
            let solved = stages.solved(&whole);
            *column = stages.alg.dag.substitute(&solved, &closed_forms);
        }
        forms.push(columns);
    }
    forms
}

/// Operations of the columns and of the u' in them, after the value graph has shortened them.
fn cost(stages: &mut Stages, columns: &Columns) -> usize {
    let roots = [&stages.dynamics.u_dot[..], &columns.concat()].concat();
    if stages.effort == Effort::None {
        return stages.alg.dag.state_cost(&roots);
    }
    let states = states(stages, &roots);
    let mut dag = stages.alg.dag.clone();
    let shorter = value::shorten(&mut dag, &[roots], &states, &states, Effort::Default);
    dag.state_cost(&shorter.concat())
}

/// Is every function linear in the changing symbols, so that no derivative depends on them?
fn is_linear(dag: &mut Dag, of: &[ExprId], directions: &[Direction]) -> bool {
    let changing: Vec<SymbolId> = directions.iter().flat_map(Direction::keys).copied().collect();
    let slopes = sweeps(dag, of, directions).concat();
    let reads = |&slope: &ExprId| dag.symbols_of(slope).iter().any(|symbol| changing.contains(symbol));
    !slopes.iter().any(reads)
}

/// Adds to each direction the rates of the symbols of coordinates in closed form.
fn with_closed_forms(stages: &mut Stages, directions: &[Direction]) -> Vec<Direction> {
    let mut all = directions.to_vec();
    for (coordinate, form) in stages.k.closed_forms.clone() {
        let Some(symbol) = stages.k.variable(&stages.alg.dag, coordinate) else { continue };
        for direction in &mut all {
            let slope = stages.alg.dag.rate(form, direction);
            direction.insert(symbol, slope);
        }
    }
    all
}

/// The residual, shortened by the value graph; operations that u' and the mass matrix share with it are counted once.
fn expressed_anew(stages: &mut Stages, residual: &[ExprId]) -> Vec<ExprId> {
    if stages.effort == Effort::None {
        return residual.to_vec();
    }
    let forward = [&stages.dynamics.u_dot[..], &stages.dynamics.mass_matrix.concat()].concat();
    let groups = [forward, residual.to_vec()];
    let states = states(stages, &groups.concat());
    let mut shorter = value::shorten(&mut stages.alg.dag, &groups, &states, &states, Effort::All);
    shorter.pop().unwrap_or_default()
}

/// The values of all symbols in the expressions at some samples.
fn states(stages: &mut Stages, of: &[ExprId]) -> States {
    let n = stages.table.points();
    let chosen: Vec<usize> = (0..n).filter(|&sample| sample == 0 || sample + WATCHED > n).collect();
    let mut symbols = HashMap::default();
    for node in stages.alg.dag.reachable(of) {
        if let Some(symbol) = stages.alg.dag.as_symbol(node) {
            let values = stages.table.values(&stages.alg.dag, node);
            symbols.insert(symbol, chosen.iter().map(|&sample| values[sample]).collect());
        }
    }
    States { points: chosen.len(), symbols }
}

/// Columns in which the derivatives of the residual are replaced by those of u'.
fn solved(stages: &mut Stages, mass: &[Vec<ExprId>], columns: &[Vec<ExprId>]) -> Columns {
    let dag = &mut stages.alg.dag;
    let residual: Columns = columns.iter().map(|column| column[..mass.len()].to_vec()).collect();
    let u_dot = dynamics::response(dag, mass, &residual);
    // Afterwards the symbols for the constant u' get their values at the state.
    let held: HashMap<SymbolId, ExprId> = (stages.u_dot.iter().zip(&stages.dynamics.u_dot))
        .filter_map(|(&symbol, &value)| Some((dag.as_symbol(symbol)?, value)))
        .collect();
    let both = u_dot.iter().zip(columns).map(|(u_dot, column)| [u_dot, &column[mass.len()..]].concat());
    both.collect::<Columns>().iter().map(|column| dag.substitute(column, &held)).collect()
}
