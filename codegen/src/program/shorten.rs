//! Shortens all answers by the value graph, forward dynamics first.

use super::derived::Program;
use crate::expr::tape::SampleTable;
use crate::expr::{Dag, ExprId, Node, SymbolId};
use crate::value::{self, Effort, Search, States};
use rustc_hash::{FxHashMap as HashMap, FxHashSet as HashSet};

/// Number of samples at the end of the table at which round-off is watched, besides the nominal and the worst ones.
const RANDOM: usize = 2;
/// Number of pivots, the weakest first, at whose worst samples round-off is watched.
const PIVOTS: usize = 4;

/// Index of the requested answers among the groups. They may take thousands of operations, so that a search over pairs
/// of values is worth its time even at the default effort.
const ON_REQUEST: usize = 2;

/// Rewrites the answers of a program; the augmented form is left alone.
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
    let shorten = |dag: &mut Dag, groups: &[Vec<ExprId>]| -> HashMap<ExprId, ExprId> {
        let shorter = value::shorten(dag, groups, &guard, &samples, search);
        groups.concat().into_iter().zip(shorter.concat()).collect()
    };
    let mut image = shorten(&mut program.dag, &groups);
    let all: Vec<ExprId> = groups.concat();
    let given: HashSet<SymbolId> = program.u_dot.iter().map(|quantity| quantity.symbol).collect();
    let shorter: Vec<ExprId> = all.iter().map(|root| image[root]).collect();
    let reads = depending(&program.dag, &given, &[&all[..], &shorter].concat());
    if all.iter().any(|root| !reads.contains(root) && reads.contains(&image[root])) {
        // A value of what reads given accelerations was found to be one of an answer that does not, since they cancel;
        // but its function is not given them. Both are shortened apart.
        let of = |wanted: bool| -> Vec<Vec<ExprId>> {
            let own = |group: &Vec<ExprId>| {
                group.iter().copied().filter(|root| reads.contains(root) == wanted).collect()
            };
            groups.iter().map(own).collect()
        };
        image = shorten(&mut program.dag, &of(false));
        image.extend(shorten(&mut program.dag, &of(true)));
    }
    program.map_answers(|e| image[&e]);
}

/// The nodes below `roots` that depend on some of these symbols.
fn depending(dag: &Dag, symbols: &HashSet<SymbolId>, roots: &[ExprId]) -> HashSet<ExprId> {
    let mut found: HashSet<ExprId> = HashSet::default();
    if symbols.is_empty() {
        return found;
    }
    // Operands come before what reads them.
    for id in dag.reachable(roots) {
        let is_one = dag.as_symbol(id).is_some_and(|symbol| symbols.contains(&symbol));
        if is_one || dag.operands(id).into_iter().flatten().any(|operand| found.contains(&operand)) {
            found.insert(id);
        }
    }
    found
}

/// Indices of the watched samples: the nominal one, those where the weakest pivots are smallest, and some random ones.
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

/// The values of all symbols at the chosen samples, including random speeds and inputs.
fn states(program: &Program, table: &mut SampleTable, chosen: &[usize]) -> States {
    let mut symbols: HashMap<SymbolId, Vec<f64>> = HashMap::default();
    let groups = [&program.q, &program.u, &program.inputs, &program.u_dot, &program.parameters];
    let quantities = groups.into_iter().flatten().map(|quantity| quantity.symbol);
    for symbol in quantities.chain([program.time]) {
        if let Some(expr) = program.dag.find(Node::Symbol(symbol)) {
            let values = table.values(&program.dag, expr);
            // If all samples are at time 0, the time is left out and counts as 1, so that loads that begin at 0 are
            // watched too.
            if symbol == program.time && values.iter().all(|&t| t == 0.0) {
                continue;
            }
            symbols.insert(symbol, chosen.iter().map(|&k| values[k]).collect());
        }
    }
    States { points: chosen.len(), symbols }
}
