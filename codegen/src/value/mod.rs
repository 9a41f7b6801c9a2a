//! The value graph: sub-expressions identified by value and expressed anew with fewer operations.
//!
//! In: expressions over one DAG, and states at which round-off is watched. Out: expressions of the same
//! value that take fewer operations. Knows no mechanics. An identity is tested exactly, at random
//! points of a prime field ([`field`]); whether it may be used is decided by round-off ([`guard`]).
//!
//! `import` (equal values merge) -> `rules`, `pairs` (further definitions of a value) -> `extract`
//! (the cheapest choice of definitions) -> `export`.

mod export;
mod extract;
mod field;
mod graph;
mod guard;
mod import;
mod pairs;
mod rules;

use crate::expr::{Dag, ExprId, SymbolId};
use extract::Extraction;
use graph::{ClassId, Graph, Signed};
use import::Import;
use rustc_hash::{FxHashMap as HashMap, FxHashSet as HashSet};

/// How hard to look for fewer operations.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Effort {
    /// The expressions as derived.
    None,
    /// Equal values merge and common factors are taken out: a millisecond.
    #[default]
    Default,
    /// All rules and the search over pairs: some hundred milliseconds, for release builds.
    All,
}

/// States at which round-off is watched: values by symbol.
#[derive(Clone, Debug, Default)]
pub struct States {
    /// Number of states.
    pub points: usize,
    /// One value a state. A symbol without values counts as 1.
    pub symbols: HashMap<SymbolId, Vec<f64>>,
}

impl States {
    fn value(&self, symbol: SymbolId, point: usize) -> f64 {
        self.symbols.get(&symbol).map_or(1.0, |values| values[point])
    }
}

/// Most rounds of the full effort; it stops when one gains nothing.
const ROUNDS: usize = 3;

/// Shorter expressions of the same values: `groups[0]` is made as short as can be, the others after it.
#[must_use]
pub fn shorten(dag: &mut Dag, groups: &[Vec<ExprId>], states: &States, effort: Effort) -> Vec<Vec<ExprId>> {
    let mut best: Vec<Vec<ExprId>> = groups.to_vec();
    let rounds = match effort {
        Effort::None => 0,
        Effort::Default => 1,
        Effort::All => ROUNDS,
    };
    for _ in 0..rounds {
        let next = round(dag, &best, states, effort);
        let cost =
            |groups: &[Vec<ExprId>]| -> Vec<usize> { groups.iter().map(|g| dag.cone_cost(g)).collect() };
        let (old, new) = (cost(&best), cost(&next));
        if new[0] > old[0] || (new[0] == old[0] && new.iter().sum::<usize>() >= old.iter().sum()) {
            break;
        }
        best = next;
    }
    best
}

fn round(dag: &mut Dag, groups: &[Vec<ExprId>], states: &States, effort: Effort) -> Vec<Vec<ExprId>> {
    let (zero, one) = (dag.zero(), dag.one());
    let mut graph = Graph::new(states.points);
    let mut import = Import::new(&mut graph, dag, states, zero);
    let one = import.load(&[one])[0].expect("1 is not 0");
    let classes: Vec<Vec<Option<Signed>>> = groups.iter().map(|group| import.load(group)).collect();
    let names = import.names();
    let mut locked: Vec<ClassId> = Vec::new();
    let mut treated = HashSet::default();
    let mut roots: Vec<Signed> = Vec::new();
    for group in &classes {
        roots.extend(group.iter().flatten());
        let mut live = Extraction::new(&mut graph, &roots, &[]).live();
        let all = live.clone();
        live.retain(|&class| treated.insert(class));
        match effort {
            Effort::All => {
                pairs::resubstitute(&mut graph, &all);
                rules::apply(&mut graph, &live, one);
            }
            _ => rules::apply_factoring(&mut graph, &live, one),
        }
        let mut search = Extraction::new(&mut graph, &roots, &locked);
        search.run();
        locked = search.live();
    }
    let all: Vec<Option<Signed>> = classes.concat();
    let mut exprs = export::roots(&graph, dag, &locked, &all, &names).into_iter();
    groups.iter().map(|group| exprs.by_ref().take(group.len()).collect()).collect()
}
