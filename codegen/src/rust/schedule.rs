//! Instruction scheduling: the order in which a function computes its values, for one of two kinds of core.
//!
//! In: steps, each after those that it depends on. Out: an order of them. An in-order core executes the order of the
//! text, which its compiler mostly keeps: few values shall be alive at a time, so that few go through memory. Three
//! orders are tried, and the one with the least register overflow is kept: depth first, with the operand that needs
//! more registers first (Sethi & Ullman, The generation of optimal code for arithmetic expressions, 1970); from the
//! first step forwards, always the step that frees most registers; from the last step backwards, likewise (Goodman &
//! Hsu, Code scheduling and register allocation in large basic blocks, 1988). On request a search improves the order
//! (`refine.rs`).
//!
//! An out-of-order core looks a few hundred instructions ahead, and moves to memory and back are cheap for it. There
//! the longest chain of dependent operations comes first (Hu, Parallel sequencing and assembly line problems, 1961).

mod ready;

use self::ready::{MOST_VALUES, Ready};
use super::few::Few;
use super::options::Core;
use super::refine::refine;
use crate::expr::ExprId;
use rustc_hash::FxHashMap as HashMap;
use std::cmp::Reverse;

/// Registers of single precision on a Cortex-M4F.
const REGISTERS: usize = 32;

/// Values that a step makes: one, or sine and cosine of one or two angles.
pub(super) type Makes<T> = Few<T, MOST_VALUES>;
/// Values that a step uses: two operands, or the angles of two differences.
pub(super) type Reads<T> = Few<T, MOST_VALUES>;

/// A step: the values that are computed at once, either one, or sine and cosine of one or two angles.
#[derive(Clone, Copy)]
pub(super) struct Step {
    /// Values that it makes.
    pub makes: Makes<ExprId>,
    /// Values that it uses, each once, in the order of the operands; constants are omitted.
    pub reads: Reads<ExprId>,
    /// Latency on a host, in cycles.
    pub latency: usize,
}

/// The kind of order that is wanted.
#[derive(Clone, Copy)]
pub(super) struct Order {
    /// The core that it is for.
    pub core: Core,
    /// Shall an order for a microcontroller be improved by a search?
    pub is_refined: bool,
}

/// The values that a function computes.
#[derive(Clone, Copy)]
pub(super) struct Results<'r> {
    /// All of them, in order.
    pub all: &'r [ExprId],
    /// The number of those, from the first on, that are written to memory as soon as they are computed. The others are
    /// returned, and stay alive to the end.
    pub written: usize,
}

/// An order of the steps, as indices.
pub(super) fn order(steps: &[Step], results: Results, order: Order) -> Vec<usize> {
    let graph = Graph::new(steps, results);
    if order.core == Core::Host {
        return graph.critical_path_first(steps);
    }
    let best = graph.least_overfull();
    if !order.is_refined {
        return best;
    }
    let values: Vec<(&[usize], &[usize])> =
        graph.makes.iter().zip(&graph.reads).map(|(makes, reads)| (&**makes, &**reads)).collect();
    refine(&best, &values, graph.maker.len())
}

/// Largest number of values alive at once in the order of [`order()`].
pub(super) fn most_waiting(steps: &[Step], results: Results, order: Order) -> usize {
    Graph::new(steps, results).waiting(&self::order(steps, results, order)).max().unwrap_or(0)
}

/// Position of each step in an order.
fn ranks(order: &[usize]) -> Vec<usize> {
    let mut ranks = vec![0; order.len()];
    order.iter().enumerate().for_each(|(rank, &step)| ranks[step] = rank);
    ranks
}

/// Steps and values as indices.
struct Graph {
    makes: Vec<Makes<usize>>,
    reads: Vec<Reads<usize>>,
    /// By value: the step that makes it; `None` for an argument.
    maker: Vec<Option<usize>>,
    readers: Readers,
    results: Vec<usize>,
    /// Of the results, those that are returned, and stay alive to the end.
    returned: Vec<usize>,
}

/// By value: the steps that use it, in order.
struct Readers {
    /// By value: the end of its range in `steps`, which is the beginning of the next value's.
    ends: Vec<usize>,
    steps: Vec<usize>,
}

impl Readers {
    fn new(reads: &[Reads<usize>], values: usize) -> Self {
        let mut ends = vec![0; values + 1];
        reads.iter().flat_map(|reads| reads.iter()).for_each(|&value| ends[value + 1] += 1);
        (1..ends.len()).for_each(|value| ends[value] += ends[value - 1]);
        let mut steps = vec![0; ends[values]];
        for (step, reads) in reads.iter().enumerate() {
            for &value in reads.iter() {
                steps[ends[value]] = step;
                ends[value] += 1;
            }
        }
        Self { ends, steps }
    }

    fn of(&self, value: usize) -> &[usize] {
        let start = value.checked_sub(1).map_or(0, |before| self.ends[before]);
        &self.steps[start..self.ends[value]]
    }

    /// Number of steps that use each value.
    fn counts(&self, values: usize) -> Vec<usize> {
        let mut start = 0;
        self.ends[..values].iter().map(|&end| end - std::mem::replace(&mut start, end)).collect()
    }
}

impl Graph {
    fn new(steps: &[Step], Results { all, written }: Results) -> Self {
        // By node: the index of its value.
        let mut number: HashMap<ExprId, usize> = HashMap::default();
        number.reserve(2 * steps.len());
        let mut value = |id: &ExprId| {
            let next = number.len();
            *number.entry(*id).or_insert(next)
        };
        let reads: Vec<Reads<usize>> =
            steps.iter().map(|step| step.reads.iter().map(&mut value).collect()).collect();
        let makes: Vec<Makes<usize>> =
            steps.iter().map(|step| step.makes.iter().map(&mut value).collect()).collect();
        let results: Vec<usize> = all.iter().map(&mut value).collect();
        let returned = results.get(written..).unwrap_or_default().to_vec();
        let n = number.len();
        let mut maker = vec![None; n];
        for (step, makes) in makes.iter().enumerate() {
            makes.iter().for_each(|&value| maker[value] = Some(step));
        }
        Self { readers: Readers::new(&reads, n), makes, reads, maker, results, returned }
    }

    /// Of the three orders the one with the least register overflow; of equally good ones the first, which is the
    /// easiest to read. Those after one without overflow are not made.
    fn least_overfull(&self) -> Vec<usize> {
        type Make = fn(&Graph, &[usize]) -> Vec<usize>;
        let mut last = self.depth_first();
        let mut best = (self.overfull(&last), last.clone());
        for make in [Self::forward as Make, Self::backward] {
            if best.0 == 0 {
                break;
            }
            last = make(self, &ranks(&last));
            let overfull = self.overfull(&last);
            if overfull < best.0 {
                best = (overfull, last.clone());
            }
        }
        best.1
    }

    /// Operands before their users, the operand that needs more registers first (Sethi & Ullman).
    fn depth_first(&self) -> Vec<usize> {
        let mut need = vec![1; self.maker.len()];
        let mut operands: Vec<Reads<usize>> = Vec::with_capacity(self.reads.len());
        for (reads, makes) in self.reads.iter().zip(&self.makes) {
            let mut sorted = *reads;
            sorted.sort_by_key(|&value| Reverse(need[value]));
            let held = sorted.iter().enumerate().map(|(waiting, &value)| need[value] + waiting);
            let most = held.max().unwrap_or(1);
            makes.iter().for_each(|&value| need[value] = most);
            operands.push(sorted);
        }
        let (mut order, mut seen) = (Vec::new(), vec![false; self.reads.len()]);
        let roots = self.results.iter().rev().filter_map(|&value| self.maker[value]);
        let mut stack: Vec<(usize, bool)> = roots.map(|step| (step, false)).collect();
        while let Some((step, ready)) = stack.pop() {
            if ready {
                order.push(step);
            } else if !std::mem::replace(&mut seen[step], true) {
                stack.push((step, true));
                let makers = operands[step].iter().rev().filter_map(|&value| self.maker[value]);
                stack.extend(makers.map(|step| (step, false)));
            }
        }
        order
    }

    /// Forwards: of the ready steps the one after which the fewest values are alive; among equals by rank.
    fn forward(&self, ranks: &[usize]) -> Vec<usize> {
        let mut readers_left = self.readers.counts(self.maker.len());
        self.returned.iter().for_each(|&value| readers_left[value] += 1);
        let mut live = vec![false; self.maker.len()];
        let is_made = |value: &&usize| self.maker[**value].is_some();
        let mut missing: Vec<usize> = self.reads.iter().map(|r| r.iter().filter(is_made).count()).collect();
        let growth = |step: usize, left: &[usize], live: &[bool]| -> isize {
            let made = self.makes[step].iter().map(|&value| isize::from(left[value] > 0));
            let read = self.reads[step].iter();
            let read = read.map(|&value| isize::from(left[value] > 1) - isize::from(live[value]));
            made.sum::<isize>() + read.sum::<isize>()
        };
        let mut ready = Ready::new(ranks);
        for step in (0..missing.len()).filter(|&step| missing[step] == 0) {
            ready.set(step, growth(step, &readers_left, &live));
        }
        let mut order = Vec::with_capacity(missing.len());
        while let Some(step) = ready.pop() {
            order.push(step);
            for &value in self.reads[step].iter() {
                readers_left[value] -= 1;
                let was_live = std::mem::replace(&mut live[value], true);
                if !was_live || readers_left[value] == 1 {
                    ready.touch(self.readers.of(value));
                }
            }
            for &value in self.makes[step].iter() {
                live[value] = true;
                for &reader in self.readers.of(value) {
                    missing[reader] -= 1;
                    if missing[reader] == 0 {
                        ready.refresh.push(reader);
                    }
                }
            }
            ready.update(|step| growth(step, &readers_left, &live));
        }
        order
    }

    /// The step with the longest path to a result first; among equals in depth-first order.
    fn critical_path_first(&self, steps: &[Step]) -> Vec<usize> {
        let mut order = self.depth_first();
        let mut way = vec![0; steps.len()];
        for &step in order.iter().rev() {
            let readers = self.makes[step].iter().flat_map(|&value| self.readers.of(value));
            way[step] = steps[step].latency + readers.map(|&reader| way[reader]).max().unwrap_or(0);
        }
        order.sort_by_key(|&step| Reverse(way[step]));
        order
    }

    /// Backwards: of the steps whose users are all placed, the one before which the fewest values are alive; among
    /// equals the last by rank.
    fn backward(&self, ranks: &[usize]) -> Vec<usize> {
        let n = self.reads.len();
        let from_the_end: Vec<usize> = ranks.iter().map(|rank| n - rank).collect();
        let mut live = vec![false; self.maker.len()];
        self.returned.iter().for_each(|&value| live[value] = true);
        let pending = |makes: &Makes<usize>| makes.iter().map(|&value| self.readers.of(value).len()).sum();
        let mut missing: Vec<usize> = self.makes.iter().map(pending).collect();
        let growth = |step: usize, live: &[bool]| -> isize {
            let end = self.makes[step].iter().filter(|&&value| live[value]).count();
            let begin = self.reads[step].iter().filter(|&&value| !live[value]).count();
            begin.cast_signed() - end.cast_signed()
        };
        let mut ready = Ready::new(&from_the_end);
        for step in (0..n).filter(|&step| missing[step] == 0) {
            ready.set(step, growth(step, &live));
        }
        let mut order = Vec::with_capacity(n);
        while let Some(step) = ready.pop() {
            order.push(step);
            for &value in self.reads[step].iter() {
                if !std::mem::replace(&mut live[value], true) {
                    ready.touch(self.readers.of(value));
                }
                if let Some(maker) = self.maker[value] {
                    missing[maker] -= 1;
                    if missing[maker] == 0 {
                        ready.refresh.push(maker);
                    }
                }
            }
            ready.update(|step| growth(step, &live));
        }
        order.reverse();
        order
    }

    /// Register overflow: live values beyond the number of registers, summed over the steps.
    fn overfull(&self, order: &[usize]) -> usize {
        self.waiting(order).map(|waiting| waiting.saturating_sub(REGISTERS)).sum()
    }

    /// Number of values alive after each step; arguments count from their first use on.
    fn waiting(&self, order: &[usize]) -> impl Iterator<Item = usize> {
        let mut left = self.readers.counts(self.maker.len());
        self.returned.iter().for_each(|&value| left[value] += 1);
        let mut live = vec![false; self.maker.len()];
        let mut waiting = 0_usize;
        order.iter().map(move |&step| {
            for &value in self.reads[step].iter() {
                waiting += usize::from(!std::mem::replace(&mut live[value], true));
                left[value] -= 1;
                waiting -= usize::from(left[value] == 0);
            }
            for &value in self.makes[step].iter() {
                live[value] = true;
                waiting += usize::from(left[value] > 0);
            }
            waiting
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{Core, Graph, Order, Results, Step, order, ranks};
    use crate::expr::ExprId;
    use crate::id::Id;

    /// Steps of one result each: number and operands.
    fn steps(all: &[(usize, &[usize])]) -> Vec<Step> {
        let id = ExprId::from_index;
        let step = |&(makes, reads): &(usize, &[usize])| Step {
            makes: [id(makes)].into_iter().collect(),
            reads: reads.iter().map(|&n| id(n)).collect(),
            latency: 4,
        };
        all.iter().map(step).collect()
    }

    fn returned(all: &[ExprId]) -> Results<'_> {
        Results { all, written: 0 }
    }

    const CHIP: Order = Order { core: Core::CortexM4, is_refined: false };

    /// Sums of `n` pairs of products of arguments, in an order that makes all products first.
    fn products_first(n: usize) -> (Vec<Step>, ExprId) {
        let mut all: Vec<(usize, Vec<usize>)> = (0..n).map(|i| (1000 + i, vec![2 * i, 2 * i + 1])).collect();
        all.push((2000, vec![1000, 1001]));
        all.extend((2..n).map(|i| (1999 + i, vec![1998 + i, 1000 + i])));
        let last = all.last().map_or(0, |(makes, _)| *makes);
        let borrowed: Vec<(usize, &[usize])> =
            all.iter().map(|(makes, reads)| (*makes, &reads[..])).collect();
        (steps(&borrowed), ExprId::from_index(last))
    }

    #[test]
    fn operands_come_before_their_users() {
        let (steps, last) = products_first(50);
        let graph = Graph::new(&steps, returned(&[last]));
        let depth_first = graph.depth_first();
        let forward = graph.forward(&ranks(&depth_first));
        let backward = graph.backward(&ranks(&forward));
        let critical = graph.critical_path_first(&steps);
        for order in [depth_first, forward, backward, critical] {
            let ranks = ranks(&order);
            assert_eq!(order.len(), steps.len());
            for (step, reads) in graph.reads.iter().enumerate() {
                let makers = reads.iter().filter_map(|&value| graph.maker[value]);
                assert!(makers.into_iter().all(|maker| ranks[maker] < ranks[step]), "{order:?}");
            }
        }
    }

    #[test]
    fn what_would_wait_is_made_when_it_is_needed() {
        let (steps, last) = products_first(50);
        let graph = Graph::new(&steps, returned(&[last]));
        assert!(graph.overfull(&(0..steps.len()).collect::<Vec<_>>()) > 0);
        assert_eq!(graph.overfull(&order(&steps, returned(&[last]), CHIP)), 0);
    }

    /// 10 = a b, 11 = a + b and 12 = c d, all results: a returned one takes a register to the end, a written one only
    /// while it is computed.
    #[test]
    fn a_written_result_takes_no_register() {
        let steps = steps(&[(10, &[0, 1]), (11, &[0, 1]), (12, &[2, 3])]);
        let all = [10, 11, 12].map(ExprId::from_index);
        let most = |written| super::most_waiting(&steps, Results { all: &all, written }, CHIP);
        assert_eq!([most(0), most(2), most(3)], [3, 2, 2]);
    }

    #[test]
    fn the_operand_that_needs_more_registers_is_made_first() {
        // 10 = a + b; 14 = ((a + b) (c + d)); 15 = e - 14: e alone needs one register.
        let steps = steps(&[(10, &[0, 1]), (11, &[4]), (12, &[2, 3]), (14, &[10, 12]), (15, &[11, 14])]);
        let order = order(&steps, returned(&[ExprId::from_index(15)]), CHIP);
        assert_eq!(order, [0, 2, 3, 1, 4]);
    }

    #[test]
    fn the_longest_way_to_a_result_is_begun_first() {
        // 12 = ((a + b) + c) + d and 20 = a c; the chain's steps come before the single product.
        let steps = steps(&[(20, &[0, 2]), (10, &[0, 1]), (11, &[10, 2]), (12, &[11, 3])]);
        let results = [20, 12].map(ExprId::from_index);
        assert_eq!(
            order(&steps, returned(&results), Order { core: Core::Host, is_refined: false }),
            [1, 2, 0, 3]
        );
    }
}
