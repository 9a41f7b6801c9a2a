//! Which candidate rows are solved: independent ones, few operations.
//!
//! In: candidate rows and the unknowns. Out: as many rows, independent at every sampled configuration,
//! taken one after the other by the operations that each adds to the expressions of those taken.

use super::eliminate::{norm, numeric_row, orthogonal_part};
use super::{Kinematics, Row, UnknownId, UnknownKind, rank};
use crate::diagnostic::Diagnostics;
use crate::expr::tape::SampleTable;
use crate::expr::{Dag, ExprId};
use crate::id::Id;
use crate::model::Model;
use rustc_hash::FxHashMap as HashMap;

/// A candidate row is independent if this part of its length is left at every sample.
const INDEPENDENT: f64 = 1e-3;
/// A row that adds more operations than this is worth a search for a cheaper one.
const DEAR: usize = 100;

/// Orthonormal rows at every sample.
type Bases = Vec<Vec<Vec<f64>>>;

/// Takes independent rows, each time the one that adds the fewest operations to those taken.
///
/// # Errors
/// If there are too few independent rows.
pub(super) fn rows(
    model: &Model,
    k: &Kinematics,
    table: &mut SampleTable,
    unknown: &[UnknownId],
) -> Result<Vec<Row>, Diagnostics> {
    let n = unknown.len();
    let column: HashMap<UnknownId, usize> = unknown.iter().enumerate().map(|(i, &u)| (u, i)).collect();
    let mut bases: Bases = vec![Vec::new(); table.points()];
    let mut bill = Bill::new(&k.dag);
    let mut candidates: Vec<usize> = (0..k.rows.len()).collect();
    let mut chosen = Vec::new();
    while chosen.len() < n {
        // A row that depends on the rows taken will depend on any more: it is left out for good.
        candidates.sort_by_cached_key(|&i| (bill.added_cost(k, &k.rows[i]), i));
        let found = candidates.iter().position(|&i| extend(k, table, &column, &k.rows[i], &mut bases, n));
        let Some(place) = found else { return Err(rank::explain(model, k, table, None)) };
        let row = &k.rows[candidates[place]];
        candidates.drain(..=place);
        bill.pay(row);
        chosen.push(row.clone());
    }
    exchange(k, table, &column, &mut chosen);
    Ok(chosen)
}

/// Adds the row to the bases if it is independent of them at every sample.
fn extend(
    k: &Kinematics,
    table: &mut SampleTable,
    column: &HashMap<UnknownId, usize>,
    row: &Row,
    bases: &mut Bases,
    n: usize,
) -> bool {
    let numbers = numeric_row(&k.dag, table, row, column, n);
    // Most dependent rows show at the first sample: no need to look at the others.
    let remains: Vec<Vec<f64>> = (numbers.iter().zip(bases.iter()))
        .map(|(v, basis)| orthogonal_part(v, basis))
        .take_while(|v| norm(v) > INDEPENDENT)
        .collect();
    if remains.len() < table.points() {
        return false;
    }
    for (basis, v) in bases.iter_mut().zip(remains) {
        let length = norm(&v);
        basis.push(v.into_iter().map(|x| x / length).collect());
    }
    true
}

/// Exchanges dear rows for cheaper ones as long as that saves, the dearest first: a row taken early was
/// dear where others bring what it needs.
fn exchange(k: &Kinematics, table: &mut SampleTable, column: &HashMap<UnknownId, usize>, chosen: &mut [Row]) {
    for _ in 0..chosen.len() {
        let without = |i: usize| {
            let mut bill = Bill::new(&k.dag);
            chosen.iter().enumerate().filter(|(j, _)| *j != i).for_each(|(_, row)| bill.pay(row));
            bill
        };
        let mut prices: Vec<(usize, usize)> =
            (0..chosen.len()).map(|i| (without(i).added_cost(k, &chosen[i]), i)).collect();
        prices.retain(|(price, _)| *price > DEAR);
        prices.sort_by_key(|&(price, i)| (std::cmp::Reverse(price), i));
        let better = prices.iter().find_map(|&(price, i)| {
            let others: Vec<&Row> =
                chosen.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, row)| row).collect();
            cheaper(k, table, column, &others, without(i), price).map(|row| (i, row))
        });
        let Some((i, row)) = better else { return };
        chosen[i] = row;
    }
}

/// The cheapest row below `price` that is independent of `others`.
fn cheaper(
    k: &Kinematics,
    table: &mut SampleTable,
    column: &HashMap<UnknownId, usize>,
    others: &[&Row],
    mut bill: Bill,
    price: usize,
) -> Option<Row> {
    let mut list: Vec<(usize, &Row)> =
        (k.rows.iter()).map(|row| (bill.added_cost(k, row), row)).filter(|(cost, _)| *cost < price).collect();
    list.sort_by_key(|(cost, _)| *cost);
    let mut bases: Bases = vec![Vec::new(); table.points()];
    for other in others {
        extend(k, table, column, other, &mut bases, column.len());
    }
    let mut rows = list.into_iter().map(|(_, row)| row);
    rows.find(|row| extend(k, table, column, row, &mut bases, column.len())).cloned()
}

/// Expressions paid for by the rows taken.
struct Bill<'d> {
    dag: &'d Dag,
    paid: Vec<bool>,
    /// The walk that saw a node last.
    seen: Vec<u32>,
    walk: u32,
    stack: Vec<ExprId>,
}

impl<'d> Bill<'d> {
    fn new(dag: &'d Dag) -> Self {
        Self { dag, paid: vec![false; dag.len()], seen: vec![0; dag.len()], walk: 0, stack: Vec::new() }
    }

    /// Operations that a row adds to the expressions paid for, plus what an entry costs later.
    fn added_cost(&mut self, k: &Kinematics, row: &Row) -> usize {
        /// An unknown in a row costs about a product and a sum per right-hand side in the elimination.
        const PER_UNKNOWN: usize = 6;
        /// Two dependent speeds in one row must be taken apart again.
        const COUPLING: usize = 24;
        let operations = self.visit(row);
        let is_dependent = |&&u: &&UnknownId| matches!(k.unknowns[u].kind, UnknownKind::Dependent(_));
        let own = row.coefficients.keys().filter(is_dependent).count();
        operations + PER_UNKNOWN * row.coefficients.len() + COUPLING * own.saturating_sub(1)
    }

    /// Operations of the row that are not paid for.
    fn visit(&mut self, row: &Row) -> usize {
        self.walk += 1;
        self.stack.extend(row.coefficients.values().copied().chain([row.bias]));
        let mut operations = 0;
        while let Some(id) = self.stack.pop() {
            let i = id.index();
            if self.paid[i] || self.seen[i] == self.walk {
                continue;
            }
            self.seen[i] = self.walk;
            operations += usize::from(self.dag.is_operation(id));
            self.stack.extend(self.dag.operands(id).into_iter().flatten());
        }
        operations
    }

    fn pay(&mut self, row: &Row) {
        self.visit(row);
        for (paid, seen) in self.paid.iter_mut().zip(&self.seen) {
            *paid |= *seen == self.walk;
        }
    }
}
