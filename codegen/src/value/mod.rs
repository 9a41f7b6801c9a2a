//! The value graph: finds sub-expressions of equal value and expresses them with fewer operations.
//!
//! In: expressions over one DAG, and states at which round-off is watched. Out: expressions of the same values with
//! fewer operations. Knows no mechanics. An identity is tested exactly, at random points of a prime field (`field`);
//! whether it may be used depends on its round-off (`guard`); the program as a whole is compared with twice the digits
//! (`check`).
//!
//! `import` (equal values merge) -> `multiples`, `near`, `pairs`, `rules` (further definitions of a value) -> `extract`
//! (the cheapest choice of definitions) -> `export`.

mod check;
mod double_double;
mod export;
mod extract;
mod field;
mod graph;
mod guard;
mod import;
mod multiples;
mod near;
mod pairs;
mod rules;
mod states;

use crate::expr::{Dag, ExprId};
use crate::id::Id;
use check::Check;
use extract::Extraction;
use graph::{ClassId, Graph, Signed};
use import::Import;
use pairs::Pairs;
pub use states::States;

/// How much effort is spent on reducing the number of operations.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Effort {
    /// The expressions as derived.
    None,
    /// Equal values merge, common factors are taken out; constant multiples, neighbours and products in another order
    /// are looked at: two milliseconds.
    #[default]
    Default,
    /// All rules and the search over all pairs: a tenth of a second, for release builds.
    All,
}

/// The effort, and the groups on which more of it is spent.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Search {
    /// How hard.
    pub effort: Effort,
    /// Groups from this index on are searched over pairs of values even at the default effort.
    pub paired: usize,
}

impl From<Effort> for Search {
    fn from(effort: Effort) -> Self {
        Self { effort, paired: usize::MAX }
    }
}

/// Sweeps of the search in each round at the default effort.
const PASSES_DEFAULT: usize = 2;
/// Sweeps in each round at full effort: more rounds gain more than more sweeps.
const PASSES_ALL: usize = 5;
/// Most rounds at full effort, first on the first group alone, then on all groups.
const ROUNDS: (usize, usize) = (6, 2);
/// Most rounds at the default effort if answers are asked for.
const ROUNDS_ON_REQUEST: usize = 3;

/// Groups with more values than this are not searched over pairs at the default effort: the time is quadratic.
const MOST_PAIRED: usize = 10_000;

/// Shorter expressions of the same values. `groups[0]` is made as short as possible, then the groups after it.
///
/// The guard bounds round-off at the states of `guard`; a program whose errors at the states of `samples` are
/// noticeably worse than the original's is discarded.
#[must_use]
pub fn shorten(
    dag: &mut Dag,
    groups: &[Vec<ExprId>],
    guard: &States,
    samples: &States,
    search: impl Into<Search>,
) -> Vec<Vec<ExprId>> {
    let search = search.into();
    let mut best: Vec<Vec<ExprId>> = groups.to_vec();
    let all = groups.len();
    let is_requested = groups.iter().skip(search.paired).any(|group| !group.is_empty());
    let rounds: &[(usize, usize)] = match search.effort {
        Effort::None => return best,
        Effort::Default if is_requested => &[(ROUNDS_ON_REQUEST, all)],
        Effort::Default => &[(1, all)],
        Effort::All => &[(ROUNDS.0, 1), (ROUNDS.1, all)],
    };
    let check = Check::new(dag, groups, samples);
    let mut pairs = Pairs::new();
    let costs_of =
        |dag: &Dag, groups: &[Vec<ExprId>]| -> Vec<Cost> { groups.iter().map(|g| dag.costs(g)).collect() };
    let original = costs_of(dag, groups);
    let mut costs = original.clone();
    for &(most, searched) in rounds {
        for _ in 0..most {
            let next = round(dag, &best, guard, (search, &mut pairs), searched);
            let next_costs = costs_of(dag, &next);
            if !is_less(&next_costs[..searched], &costs[..searched]) || !check.passes(dag, &next) {
                break;
            }
            (best, costs) = (next, next_costs);
        }
    }
    // A group may have become longer by what the first group gained: it then keeps its original expressions.
    for place in (1..all).filter(|&place| costs[place] > original[place]) {
        best[place].clone_from(&groups[place]);
    }
    best
}

/// Operations of every evaluation, and those of `prepare()`.
type Cost = (usize, usize);

/// Fewer operations in the first group, or as many there and fewer in all.
fn is_less(new: &[Cost], old: &[Cost]) -> bool {
    let of = |costs: &[Cost]| (costs[0], costs.iter().fold((0, 0), |s, c| (s.0 + c.0, s.1 + c.1)));
    of(new) < of(old)
}

/// One round: import, further definitions, search, export. Groups from `searched` on reuse what was found for the
/// others.
fn round(
    dag: &mut Dag,
    groups: &[Vec<ExprId>],
    guard: &States,
    (Search { effort, paired }, pairs): (Search, &mut Pairs),
    searched: usize,
) -> Vec<Vec<ExprId>> {
    let (zero, one) = (dag.zero(), dag.one());
    let mut graph = Graph::new(guard.points);
    graph.reserve(dag.cone(&groups.concat()).len() + 1);
    let mut import = Import::new(&mut graph, dag, guard, zero, effort == Effort::Default);
    let one = import.load(&[one])[0].expect("1 is not 0");
    let classes: Vec<Vec<Option<Signed>>> = groups.iter().map(|group| import.load(group)).collect();
    let (labels, norms) = (import.labels(), import.norms());
    let mut roots: Vec<Signed> = Vec::new();
    let mut settled: Vec<ClassId> = Vec::new();
    let mut treated: Vec<bool> = Vec::new();
    for (place, group) in classes[..searched].iter().enumerate() {
        roots.extend(group.iter().flatten());
        let mut search = Extraction::new(&mut graph, &roots, &settled);
        search.keeps_depths = effort == Effort::All;
        let live = search.live();
        treated.resize(search.graph.classes.len(), false);
        let is_new = |class: &ClassId| !std::mem::replace(&mut treated[class.index()], true);
        let new: Vec<ClassId> = live.iter().copied().filter(is_new).collect();
        let mut passes = PASSES_DEFAULT;
        let on_request = place >= paired;
        let is_quick = effort == Effort::Default && (place == 0 || on_request);
        if is_quick || effort == Effort::All {
            multiples::propose(search.graph, &live);
        }
        if effort == Effort::All || (on_request && live.len() <= MOST_PAIRED) {
            pairs.resubstitute(search.graph, &live, &new);
        } else if place == 0 {
            near::resubstitute(search.graph, &live, &new);
        }
        if is_quick {
            rules::reassociate_shared(search.graph, &live);
        }
        if effort == Effort::All {
            passes = PASSES_ALL;
            rules::apply(search.graph, &new, one);
        }
        rules::factor_sums(search.graph, &live, &new, one);
        search.grow();
        search.run(passes);
        settled = search.live();
    }
    let all: Vec<Option<Signed>> = classes.concat();
    if searched < groups.len() {
        let roots: Vec<Signed> = all.iter().copied().flatten().collect();
        settled = Extraction::new(&mut graph, &roots, &[]).live();
    }
    let mut exprs = export::roots(&graph, dag, &settled, &all, (&labels, &norms)).into_iter();
    groups.iter().map(|group| exprs.by_ref().take(group.len()).collect()).collect()
}
