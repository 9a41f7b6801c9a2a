//! Reorders sums of three and more terms so that they round least.
//!
//! (a + b) + c = a + (b + c): the error of a sum is at most one rounding times the sum of the sizes of its partial
//! sums. So small partial sums come first, those of small terms and those that cancel. Greedy: each time the two terms
//! are added whose sum is smallest over the sampled states. As many operations as before, in any scalar.

use super::derived::Program;
use crate::expr::tape::SampleTable;
use crate::expr::{Binary, Dag, Dependence, ExprId, Node};
use crate::id::Id;

/// Sums with more terms are left alone, because every pair of terms is tried.
const MOST_TERMS: usize = 40;
/// Programs with more values over all samples are left alone, because they would fill the memory.
const MOST_VALUES: usize = 4_000_000;
/// A new order is used only if its partial sums are smaller than the old ones by this factor.
const WORTH: f64 = 0.9;

/// Reorders the sums of all answers, unless that would take more operations.
pub(super) fn sums(program: &mut Program, table: &mut SampleTable) {
    let roots = program.groups().concat();
    let needed = program.dag.reachable(&roots);
    if needed.len() * table.points() > MOST_VALUES {
        return;
    }
    let inner = inner_sums(&program.dag, &roots, &needed);
    // Few nodes of the equations remain in use: their values would occupy memory beside those of the program.
    table.clear();
    let image = program.dag.rebuild_in(&needed, |dag, id, image| {
        if inner[id.index()] {
            return None;
        }
        let (terms, partial_sums) = taken_apart(dag, id, &inner)?;
        let old: f64 = partial_sums.into_iter().map(|sum| size(table.values(dag, sum).iter().copied())).sum();
        let (order, new) = order(terms.iter().map(|term| term.values(dag, table)).collect());
        // NaN, which occurs if a sample lies outside a function's domain, is no reason to reorder.
        if old.is_nan() || new > WORTH * old {
            return None;
        }
        let mut sums: Vec<Term> = terms.iter().map(|t| Term { value: image.of(t.value), ..*t }).collect();
        for (i, j) in order {
            let last = sums[j];
            sums[i] = sums[i].plus(dag, last);
        }
        let total = sums[0];
        Some(if total.negative { dag.negate(total.value) } else { total.value })
    });
    let mapped: Vec<ExprId> = roots.iter().map(|&root| image.of(root)).collect();
    if program.dag.state_cost(&mapped) <= program.dag.state_cost(&roots) {
        program.map_answers(|e| image.of(e));
    }
}

/// Sums that are operands of exactly one other sum and of nothing else, among the nodes that the roots need.
fn inner_sums(dag: &Dag, roots: &[ExprId], order: &[ExprId]) -> Vec<bool> {
    let n = order.last().map_or(0, |id| id.index() + 1);
    // Only whether a count is 1 matters.
    let (mut reads, mut in_sums) = (vec![0_u8; n], vec![0_u8; n]);
    let add = |count: &mut u8, more: u8| *count = count.saturating_add(more);
    roots.iter().for_each(|root| add(&mut reads[root.index()], 2));
    for &id in order {
        for operand in dag.operands(id).into_iter().flatten() {
            add(&mut reads[operand.index()], 1);
            add(&mut in_sums[operand.index()], u8::from(is_sum(dag, id)));
        }
    }
    let is_inner = |&id: &ExprId| is_sum(dag, id) && reads[id.index()] == 1 && in_sums[id.index()] == 1;
    let mut inner = vec![false; n];
    order.iter().filter(|id| is_inner(id)).for_each(|id| inner[id.index()] = true);
    inner
}

/// Is it a sum without a label?
fn is_sum(dag: &Dag, id: ExprId) -> bool {
    dag.label_of(id).is_none() && has_terms(dag, id)
}

fn has_terms(dag: &Dag, id: ExprId) -> bool {
    dag.dependence(id) == Dependence::State
        && matches!(dag.node(id), Node::Binary(Binary::Add | Binary::Sub, ..))
}

/// A value with a sign.
#[derive(Clone, Copy)]
struct Term {
    value: ExprId,
    negative: bool,
}

impl Term {
    fn values(&self, dag: &Dag, table: &mut SampleTable) -> Vec<f64> {
        let sign = if self.negative { -1.0 } else { 1.0 };
        table.values(dag, self.value).iter().map(|x| sign * x).collect()
    }

    fn plus(self, dag: &mut Dag, other: Self) -> Self {
        let (a, b) = (self.value, other.value);
        match (self.negative, other.negative) {
            (false, true) => Self { value: dag.sub(a, b), negative: false },
            (true, false) => Self { value: dag.sub(b, a), negative: false },
            (negative, _) => Self { value: dag.add(a, b), negative },
        }
    }
}

/// The terms of a sum, if there are at least three and not too many, and the existing partial sums except the total.
fn taken_apart(dag: &Dag, sum: ExprId, inner: &[bool]) -> Option<(Vec<Term>, Vec<ExprId>)> {
    let is_inner = |operand: ExprId| inner[dag.unsigned(operand).index()];
    if !has_terms(dag, sum) || !dag.operands(sum).into_iter().flatten().any(is_inner) {
        return None;
    }
    let (mut terms, mut partial_sums) = (Vec::new(), Vec::new());
    let mut stack = vec![Term { value: sum, negative: false }];
    while let Some(Term { value, negative }) = stack.pop() {
        match dag.node(value) {
            Node::Binary(operator @ (Binary::Add | Binary::Sub), a, b)
                if value == sum || inner[value.index()] =>
            {
                partial_sums.extend((value != sum).then_some(value));
                stack.push(Term { value: b, negative: negative != (operator == Binary::Sub) });
                stack.push(Term { value: a, negative });
            }
            Node::Negate(a) => stack.push(Term { value: a, negative: !negative }),
            _ => terms.push(Term { value, negative }),
        }
    }
    (3..=MOST_TERMS).contains(&terms.len()).then_some((terms, partial_sums))
}

/// Root mean square.
fn size(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let n = values.len().max(1) as f64;
    (values.map(|x| x * x).sum::<f64>() / n).sqrt()
}

/// The order of the additions, as pairs of indices (the sum replaces the first), and the total size of the partial
/// sums, without the final sum.
fn order(mut sums: Vec<Vec<f64>>) -> (Vec<(usize, usize)>, f64) {
    let size_of = |a: &[f64], b: &[f64]| size(a.iter().zip(b).map(|(a, b)| a + b));
    let mut pairs: Vec<(usize, usize, f64)> = Vec::new();
    for (j, last) in sums.iter().enumerate() {
        pairs.extend(sums[..j].iter().enumerate().map(|(i, first)| (i, j, size_of(first, last))));
    }
    pairs.sort_by_key(|&(i, j, _)| (i, j));
    let (mut order, mut total) = (Vec::new(), 0.0);
    while let Some(&(first, second, _)) = pairs.first() {
        // If no sum is a number, the first two terms.
        let mut best = (first, second, f64::INFINITY);
        for &pair in &pairs {
            best = if pair.2 < best.2 { pair } else { best };
        }
        let (i, j, size) = best;
        total += if pairs.len() > 1 { size } else { 0.0 };
        let added = std::mem::take(&mut sums[j]);
        sums[i].iter_mut().zip(&added).for_each(|(a, b)| *a += b);
        pairs.retain(|&(a, b, _)| a != j && b != j);
        for (a, b, size) in pairs.iter_mut().filter(|(a, b, _)| *a == i || *b == i) {
            *size = size_of(&sums[*a], &sums[*b]);
        }
        order.push((i, j));
    }
    (order, total)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// p + q - r + s, with p and r large and nearly equal.
    #[test]
    fn what_cancels_and_what_is_small_comes_first() {
        let terms = [[1e6, 2e6], [0.5, 0.25], [-1e6, -2e6], [0.25, 0.5]].map(Vec::from);
        let (order, size) = order(terms.to_vec());
        assert_eq!(order, [(0, 2), (0, 1), (0, 3)]);
        assert!(size < 1.0, "{size}");
        let (order, size) = super::order(vec![vec![f64::NAN]; 3]);
        assert_eq!(order, [(0, 1), (0, 2)]);
        assert!(!size.is_finite());
    }

    #[test]
    fn a_sum_that_is_read_twice_is_a_term_of_its_own() {
        let mut dag = Dag::default();
        let [a, b, c, d] = ["a", "b", "c", "d"].map(|name| dag.symbol(name));
        let ab = dag.add(a, b);
        let abc = dag.sub(ab, c);
        let all = dag.sub(d, abc);
        let signs = |roots: &[ExprId]| {
            let inner = inner_sums(&dag, roots, &dag.reachable(roots));
            let (terms, _) = taken_apart(&dag, all, &inner).unwrap_or_default();
            terms.iter().map(|t| (t.value, t.negative)).collect::<Vec<_>>()
        };
        assert_eq!(signs(&[all]), [(d, false), (a, true), (b, true), (c, false)]);
        assert_eq!(signs(&[all, ab]), [(d, false), (ab, true), (c, false)]);
        assert_eq!(signs(&[all, abc]), []);
    }
}
