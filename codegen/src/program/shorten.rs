//! All answers expressed anew by the value graph, forward dynamics first.

use super::derived::Program;
use crate::expr::tape::SampleTable;
use crate::expr::{ExprId, Node, SymbolId};
use crate::value::{self, Effort, Search, States};
use rustc_hash::FxHashMap as HashMap;

/// Samples at the end of the table that are watched besides the nominal and the worst ones.
const RANDOM: usize = 2;
/// Pivots, the weakest first, at whose worst samples round-off is watched.
const PIVOTS: usize = 4;

/// Place of the answers on request among the groups: who asks for one waits for it, and it may take thousands of
/// operations, so that a search over pairs of values is worth its time at the default effort too.
const ON_REQUEST: usize = 2;

/// Rewrites the answers of a program; the augmented form stays as it is.
pub(super) fn answers(program: &mut Program, table: &mut SampleTable, effort: Effort) {
    let n = table.points();
    let chosen = watched(program, table);
    let guard = states(program, table, &chosen);
    let samples = if effort == Effort::All {
        states(program, table, &(0..n).collect::<Vec<_>>())
    } else {
        guard.clone()
    };
    let groups = program.groups();
    let search = Search { effort, paired: ON_REQUEST };
    let shorter = value::shorten(&mut program.dag, &groups, &guard, &samples, search);
    let image: HashMap<ExprId, ExprId> = groups.concat().into_iter().zip(shorter.concat()).collect();
    program.map_answers(|e| image[&e]);
}

/// Nominal, where the weakest pivots are smallest, and some random samples.
fn watched(program: &Program, table: &mut SampleTable) -> Vec<usize> {
    let n = table.points();
    let mut watched: Vec<usize> = vec![0];
    let mut weakest: Vec<_> = program.pivots.iter().collect();
    weakest.sort_by(|a, b| a.worst.total_cmp(&b.worst));
    for pivot in weakest.into_iter().take(PIVOTS) {
        let sizes = table.values(&program.dag, pivot.value);
        watched.extend((0..n).min_by(|&a, &b| sizes[a].abs().total_cmp(&sizes[b].abs())));
    }
    watched.extend(n.saturating_sub(RANDOM)..n);
    watched.sort_unstable();
    watched.dedup();
    watched
}

/// The chosen samples of the table, with its random speeds and inputs.
fn states(program: &Program, table: &mut SampleTable, chosen: &[usize]) -> States {
    let mut symbols: HashMap<SymbolId, Vec<f64>> = HashMap::default();
    let groups = [&program.q, &program.u, &program.inputs, &program.u_dot, &program.parameters];
    let quantities = groups.into_iter().flatten().map(|quantity| quantity.symbol);
    for symbol in quantities.chain([program.time]) {
        if let Some(expr) = program.dag.find(Node::Symbol(symbol)) {
            let values = table.values(&program.dag, expr);
            // Without values, where every sample is at time 0, time counts as 1: loads that begin at 0 are watched too.
            if symbol == program.time && values.iter().all(|&t| t == 0.0) {
                continue;
            }
            symbols.insert(symbol, chosen.iter().map(|&k| values[k]).collect());
        }
    }
    States { points: chosen.len(), symbols }
}
