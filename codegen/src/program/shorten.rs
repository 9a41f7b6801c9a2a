//! All answers expressed anew by the value graph, forward dynamics first.

use super::Program;
use crate::expr::tape::SampleTable;
use crate::expr::{ExprId, Node, SymbolId};
use crate::value::{self, Effort, States};
use rustc_hash::FxHashMap as HashMap;

/// Samples at the end of the table that are watched besides the nominal and the worst ones.
const RANDOM: usize = 2;

/// Rewrites the answers of a program; the augmented form stays as it is.
pub(super) fn answers(program: &mut Program, table: &mut SampleTable, effort: Effort) {
    let states = states(program, table);
    let mut rates = program.forward_dynamics();
    rates.push(program.rates.worst_pivot);
    let second = |list: &[(String, ExprId)]| -> Vec<ExprId> { list.iter().map(|(_, e)| *e).collect() };
    let mut projection: Vec<ExprId> = program.correction.iter().map(|(_, e)| *e).collect();
    projection.push(program.residual);
    let others =
        [projection, program.energy.to_vec(), second(&program.speeds), second(&program.outputs)].concat();
    let groups = [rates, others];
    let shorter = value::shorten(&mut program.dag, &groups, &states, effort);
    let image: HashMap<ExprId, ExprId> = groups.concat().into_iter().zip(shorter.concat()).collect();
    program.map_answers(|e| image[&e]);
}

/// Nominal, where each pivot is smallest, and some random samples, with random speeds and inputs.
fn states(program: &Program, table: &mut SampleTable) -> States {
    let dag = &program.dag;
    let n = table.points();
    let mut watched: Vec<usize> = vec![0];
    for pivot in &program.pivots {
        let sizes = table.values(dag, pivot.value);
        watched.extend((0..n).min_by(|&a, &b| sizes[a].abs().total_cmp(&sizes[b].abs())));
    }
    watched.extend(n.saturating_sub(RANDOM)..n);
    watched.sort_unstable();
    watched.dedup();
    let mut symbols: HashMap<SymbolId, Vec<f64>> = HashMap::default();
    let groups = [&program.q, &program.u, &program.inputs, &program.parameters];
    for symbol in groups.into_iter().flatten().map(|quantity| quantity.symbol) {
        if let Some(expr) = dag.find(Node::Symbol(symbol)) {
            let values = table.values(dag, expr);
            symbols.insert(symbol, watched.iter().map(|&k| values[k]).collect());
        }
    }
    States { points: watched.len(), symbols }
}
