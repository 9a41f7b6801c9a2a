//! Final check of accuracy: the new program in f64 against the original one in twice the digits.
//!
//! In: the original expressions and sampled states. Out: whether the errors of a new program are about as small as
//! those of the original in f64.

use super::double_double::{self, Double2};
use super::states::States;
use crate::expr::tape::Tape;
use crate::expr::{Dag, ExprId, SymbolId};

/// Largest error of a new program relative to the original's: median over the states.
const MEDIAN_WORSE: f64 = 1.5;
/// The same for the largest error over the states, which varies by a factor of a few by chance.
const WORST_WORSE: f64 = 4.0;
/// The same at a single state, where the original's error may be small by chance.
const STATE_WORSE: f64 = 64.0;
/// Errors below this many roundings count as zero.
const ROUNDINGS: f64 = 4.0 * f64::EPSILON;

/// Accurate values of groups of results at every state, and the errors of the original program.
pub(super) struct Check<'s> {
    states: &'s States,
    /// What the original program reads; no other reads more.
    symbols: Vec<SymbolId>,
    /// By state, then by result, with the groups one after the other.
    exact: Vec<Vec<Double2>>,
    /// Lengths of the groups.
    lengths: Vec<usize>,
    /// Errors of the original program.
    original: Vec<Vec<f64>>,
}

impl<'s> Check<'s> {
    pub fn new(dag: &Dag, groups: &[Vec<ExprId>], states: &'s States) -> Self {
        let roots = groups.concat();
        let exact =
            double_double::evaluate_at(dag, &roots, states.points, |symbol, k| states.value(symbol, k));
        let lengths = groups.iter().map(Vec::len).collect();
        let mut check =
            Self { states, symbols: dag.symbols_of_all(&roots), exact, lengths, original: Vec::new() };
        check.original = check.errors(dag, groups);
        check
    }

    /// Errors by group and state, relative to the largest result of the group at that state.
    fn errors(&self, dag: &Dag, groups: &[Vec<ExprId>]) -> Vec<Vec<f64>> {
        let roots = groups.concat();
        let mut errors = vec![Vec::with_capacity(self.states.points); groups.len()];
        let mut tape = Tape::<f64>::new(dag, &roots, &self.symbols);
        let mut values = vec![0.0; roots.len()];
        for (point, exact) in self.exact.iter().enumerate() {
            let inputs: Vec<f64> = self.symbols.iter().map(|&s| self.states.value(s, point)).collect();
            tape.run(&inputs, &mut values);
            let mut start = 0;
            for (errors, &length) in errors.iter_mut().zip(&self.lengths) {
                let part = start..start + length;
                let scale = exact[part.clone()].iter().fold(0.0, |m: f64, x| m.max(x.high.abs()));
                let error = exact[part.clone()].iter().zip(&values[part]).map(|(x, &y)| x.distance(y));
                let error = error.fold(0.0, |m: f64, e| if e <= m { m } else { e });
                errors.push(if scale > 0.0 { error / scale } else { error });
                start += length;
            }
        }
        errors
    }

    /// Is a new program as accurate as the original?
    pub fn passes(&self, dag: &Dag, groups: &[Vec<ExprId>]) -> bool {
        self.original.iter().zip(&self.errors(dag, groups)).all(|(old, new)| as_accurate(old, new))
    }
}

/// Compares errors at the same states. At a pole of the original the new program may have one too.
fn as_accurate(old: &[f64], new: &[f64]) -> bool {
    let pairs = || old.iter().zip(new).filter(|(old, _)| old.is_finite());
    let (mut old, mut new): (Vec<f64>, Vec<f64>) = pairs().unzip();
    let everywhere = pairs().all(|(old, new)| *new <= STATE_WORSE * (old + ROUNDINGS));
    old.sort_by(f64::total_cmp);
    new.sort_by(f64::total_cmp);
    let (Some(worst_old), Some(worst_new)) = (old.last(), new.last()) else { return true };
    let middle = old.len() / 2;
    everywhere
        && *worst_new <= WORST_WORSE * worst_old + ROUNDINGS
        && new[middle] <= MEDIAN_WORSE * old[middle] + ROUNDINGS
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two forms of the same function near x = 0, and states at which they differ in accuracy.
    fn one_less_cosine(x: f64) -> (Dag, ExprId, ExprId, States) {
        let mut dag = Dag::default();
        let symbol = dag.symbol("x");
        let (one, half, two) = (dag.one(), dag.constant(0.5), dag.constant(2.0));
        let (cos, angle) = (dag.cos(symbol), dag.mul(half, symbol));
        let (difference, sin) = (dag.sub(one, cos), dag.sin(angle));
        let square = dag.mul(sin, sin);
        let product = dag.mul(two, square);
        let mut states = States { points: 3, ..States::default() };
        states.symbols.insert(dag.as_symbol(symbol).expect("a symbol"), vec![1.0, 2.0, x]);
        (dag, difference, product, states)
    }

    #[test]
    fn a_program_that_cancels_at_one_state_fails() {
        let (dag, difference, product, states) = one_less_cosine(1e-4);
        let check = Check::new(&dag, &[vec![product]], &states);
        assert!(!check.passes(&dag, &[vec![difference]]));
        assert!(check.passes(&dag, &[vec![product]]));
    }

    #[test]
    fn the_more_accurate_program_passes() {
        let (dag, difference, product, states) = one_less_cosine(1e-4);
        assert!(Check::new(&dag, &[vec![difference]], &states).passes(&dag, &[vec![product]]));
    }

    #[test]
    fn away_from_the_hard_state_both_pass() {
        let (dag, difference, product, states) = one_less_cosine(3.0);
        assert!(Check::new(&dag, &[vec![product]], &states).passes(&dag, &[vec![difference]]));
    }

    #[test]
    fn not_a_number_fails() {
        assert!(!as_accurate(&[1e-16], &[f64::NAN]));
    }
}
