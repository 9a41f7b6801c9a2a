//! Chooses which candidate rows are solved: independent ones that take few operations.
//!
//! In: candidate rows and the unknowns. Out: as many rows as unknowns, independent at every sampled configuration.
//! Greedy: each time the row that adds the fewest operations to those of the rows taken before; then exchanges that
//! save more.

use super::basis::{Bases, NumericRow, longest_entry};
use super::quantities::{Kinematics, Row};
use super::unknowns::{UnknownId, UnknownKind};
use crate::expr::NodeSet;
use crate::expr::tape::SampleTable;
use crate::vector::Algebra;
use rustc_hash::FxHashMap as HashMap;

/// A row counts as independent of others if this share of its length is left after projection, at every sample.
pub(super) const INDEPENDENT: f64 = 1e-3;
/// A row counts as well independent of others if this share of its length is left, at every sample.
pub(super) const WELL_INDEPENDENT: f64 = 0.1;
/// A row that adds more operations than this is worth the search for a cheaper one.
const DEAR: usize = 100;

/// The candidates, and the criterion of independence.
pub(super) struct Choice<'a> {
    /// Candidate rows.
    pub rows: &'a [Row],
    /// Columns: the unknowns to be solved for.
    pub unknown: &'a [UnknownId],
    /// Number of rows to take: as many as unknowns, or fewer.
    pub count: usize,
    /// Share of a row's length that must be left after projection on the others, at every sample.
    pub independent: f64,
}

/// Takes independent rows, each time the one that adds the fewest operations; `None` if there are too few of them.
pub(super) fn rows(
    alg: &Algebra,
    k: &Kinematics,
    table: &mut SampleTable,
    choice: &Choice<'_>,
) -> Option<Vec<Row>> {
    let n = choice.unknown.len();
    let column: HashMap<UnknownId, usize> = choice.unknown.iter().enumerate().map(|(i, &u)| (u, i)).collect();
    let costs: Vec<RowCost> = choice.rows.iter().map(|row| RowCost::new(alg, k, row)).collect();
    let mut bases = Bases::new(n, longest_entry(&alg.dag, choice.rows, table), table.points());
    let mut paid = NodeSet::default();
    let mut candidates: Vec<usize> = (0..choice.rows.len()).collect();
    let mut chosen = Vec::new();
    while chosen.len() < choice.count {
        // A row that depends on the rows taken depends on any larger set: it is removed for good.
        candidates.sort_by_cached_key(|&i| (costs[i].added_cost(&paid), i));
        let place = candidates.iter().position(|&i| extend(alg, table, &column, choice, i, &mut bases))?;
        let row = candidates[place];
        candidates.drain(..=place);
        paid.unite(&costs[row].operations);
        chosen.push(row);
    }
    exchange(alg, table, &column, choice, &costs, &mut chosen);
    Some(chosen.into_iter().map(|i| choice.rows[i].clone()).collect())
}

/// Adds the row to the bases if it is independent of them at every sample.
fn extend(
    alg: &Algebra,
    table: &mut SampleTable,
    column: &HashMap<UnknownId, usize>,
    choice: &Choice<'_>,
    row: usize,
    bases: &mut Bases,
) -> bool {
    let row = NumericRow::new(&alg.dag, table, &choice.rows[row], column);
    bases.extend(&alg.dag, &row, choice.independent)
}

/// Exchanges expensive rows for cheaper ones, the most expensive first, as long as that saves operations: once all rows
/// are chosen, an alternative may be cheaper because other rows bring sub-expressions that it needs.
fn exchange(
    alg: &Algebra,
    table: &mut SampleTable,
    column: &HashMap<UnknownId, usize>,
    choice: &Choice<'_>,
    costs: &[RowCost],
    chosen: &mut [usize],
) {
    for _ in 0..chosen.len() {
        let others = |place: usize| -> Vec<usize> {
            let others = chosen.iter().enumerate().filter(|(j, _)| *j != place);
            others.map(|(_, &row)| row).collect()
        };
        let paid_by = |rows: &[usize]| {
            let mut paid = NodeSet::default();
            rows.iter().for_each(|&row| paid.unite(&costs[row].operations));
            paid
        };
        let mut prices: Vec<(usize, usize)> = (0..chosen.len())
            .map(|place| (costs[chosen[place]].added_cost(&paid_by(&others(place))), place))
            .collect();
        prices.retain(|(price, _)| *price > DEAR);
        prices.sort_by_key(|&(price, place)| (std::cmp::Reverse(price), place));
        let better = prices.iter().find_map(|&(price, place)| {
            let others = others(place);
            let paid = paid_by(&others);
            let costs = costs.iter().map(|cost| cost.added_cost(&paid)).enumerate();
            let mut list: Vec<(usize, usize)> = costs.filter(|(_, cost)| *cost < price).collect();
            list.sort_by_key(|(_, cost)| *cost);
            cheaper(alg, table, column, choice, &others, &list).map(|row| (place, row))
        });
        let Some((place, row)) = better else { return };
        chosen[place] = row;
    }
}

/// The first of the listed rows that is independent of the others.
fn cheaper(
    alg: &Algebra,
    table: &mut SampleTable,
    column: &HashMap<UnknownId, usize>,
    choice: &Choice<'_>,
    others: &[usize],
    list: &[(usize, usize)],
) -> Option<usize> {
    let mut bases = Bases::new(column.len(), longest_entry(&alg.dag, choice.rows, table), table.points());
    for &other in others {
        extend(alg, table, column, choice, other, &mut bases);
    }
    let mut rows = list.iter().map(|&(row, _)| row);
    rows.find(|&row| extend(alg, table, column, choice, row, &mut bases))
}

/// The operations that a row costs.
struct RowCost {
    /// The operations of its expressions; those that another chosen row needs too are counted once.
    operations: NodeSet,
    /// What its entries will cost in the elimination.
    entries: usize,
}

impl RowCost {
    fn new(alg: &Algebra, k: &Kinematics, row: &Row) -> Self {
        /// Each unknown in a row costs about a product and a sum per right-hand side in the elimination.
        const PER_UNKNOWN: usize = 6;
        /// Charge for every further dependent speed in a row: the elimination must separate them.
        const COUPLING: usize = 24;
        let is_dependent = |&&u: &&UnknownId| matches!(k.unknowns[u].kind, UnknownKind::Dependent(_));
        let own = row.coefficients.keys().filter(is_dependent).count();
        let roots: Vec<_> = row.coefficients.values().copied().chain([row.bias]).collect();
        Self {
            operations: alg.dag.operations_of(&roots),
            entries: PER_UNKNOWN * row.coefficients.len() + COUPLING * own.saturating_sub(1),
        }
    }

    /// Operations of the row that the rows taken (`paid`) do not need, plus what its entries will cost.
    fn added_cost(&self, paid: &NodeSet) -> usize {
        self.operations.count_without(paid) + self.entries
    }
}
