//! The steps that a function's body computes, and which of them get a statement of their own.

use super::super::options::Core;
use super::super::pairs::pair_angles;
use super::super::schedule::{Makes, Reads, Step};
use super::{Body, LONGEST_STATEMENT};
use crate::expr::{Binary, ExprId, Node, Unary};
use crate::id::Id;
use rustc_hash::{FxHashMap as HashMap, FxHashSet as HashSet};

impl<'p> Body<'p> {
    /// The value behind an operand: unnamed negations are skipped, because they are written where they are used.
    pub(super) fn value(&self, mut id: ExprId) -> ExprId {
        let dag = self.dag();
        while let Node::Negate(positive) = dag.node(id)
            && self.field(id).is_none()
            && dag.label_of(id).is_none()
        {
            id = positive;
        }
        id
    }

    /// Values that a node uses, in the order of its operands, without constants.
    fn reads(&self, id: ExprId) -> impl DoubleEndedIterator<Item = ExprId> + use<'p> {
        let values =
            self.operands(id).map(|a| a.map(|a| self.value(a)).filter(|&a| !self.dag().is_constant(a)));
        values.into_iter().flatten()
    }

    /// The steps that the body computes, operands first.
    pub(super) fn steps(&mut self, roots: &[ExprId]) -> Vec<Step> {
        let dag = self.dag();
        let order = dag.reachable_above(roots, |id| self.field(id).is_some());
        if self.options.core() == Core::Host && self.sines.given().is_empty() {
            self.pairs = pair_angles(dag, &order, |id| self.field(id).is_some());
        }
        let mut steps: Vec<Step> = Vec::with_capacity(order.len());
        let mut angles: HashMap<ExprId, usize> = HashMap::default();
        for id in order {
            let computed =
                dag.is_operation(id) || (matches!(dag.node(id), Node::Negate(_)) && self.value(id) == id);
            if !computed || dag.is_constant(id) || self.field(id).is_some() {
                continue;
            }
            if let Node::Unary(Unary::Sin | Unary::Cos, angle) = dag.node(id) {
                let other = self.pairs.get(&angle);
                let known = angles.get(&angle).or_else(|| angles.get(other?)).copied();
                angles.insert(angle, known.unwrap_or(steps.len()));
                if let Some(step) = known {
                    steps[step].makes.push(id);
                    for read in self.reads(id) {
                        if !steps[step].reads.contains(&read) {
                            steps[step].reads.push(read);
                        }
                    }
                    continue;
                }
            }
            let (mut makes, mut reads) = (Makes::default(), Reads::default());
            makes.push(id);
            for read in self.reads(id) {
                if !reads.contains(&read) {
                    reads.push(read);
                }
            }
            steps.push(Step { makes, reads, latency: latency(dag.node(id)) });
        }
        if dag.unrounded_differences {
            self.drop_idle_differences(&mut steps, roots);
        }
        steps
    }

    /// Removes differences of angles that nothing uses except unrounded sines and cosines.
    fn drop_idle_differences(&self, steps: &mut Vec<Step>, roots: &[ExprId]) {
        let mut read: HashSet<ExprId> = roots.iter().map(|&root| self.value(root)).collect();
        steps.iter().for_each(|step| read.extend(step.reads.iter()));
        steps.retain(|step| step.makes.iter().any(|made| read.contains(made)));
    }

    pub(super) fn count_uses(&mut self, steps: &[Step], results: &[ExprId]) {
        let mut uses = std::mem::take(&mut self.uses);
        let mut add = |id: ExprId, n: u8| uses[id.index()] = uses[id.index()].saturating_add(n);
        for step in steps {
            step.reads.iter().for_each(|&read| add(read, 1));
            if let [Some(a), Some(b)] = self.operands(step.makes[0]).map(|a| a.map(|a| self.value(a)))
                && a == b
            {
                add(a, 1); // x x reads x twice
            }
        }
        results.iter().for_each(|&result| add(result, 2));
        self.uses = uses;
    }

    /// Decides which steps get a statement of their own. A step that could be written inside its only user is held
    /// back; if another step comes in between, it gets a statement, so that the order is kept.
    pub(super) fn break_up<'s>(&mut self, order: impl Iterator<Item = &'s Step>) {
        let dag = self.dag();
        let mut waiting: Vec<(ExprId, usize)> = Vec::new();
        for step in order {
            let id = step.makes[0];
            let mut size = 1;
            for read in step.reads.iter().rev() {
                if let Some((_, inside)) = waiting.pop_if(|(last, _)| last == read) {
                    size += inside;
                }
            }
            let angle = matches!(dag.node(id), Node::Unary(Unary::Sin | Unary::Cos, _));
            let shared = self.uses[id.index()] > 1;
            let own = shared || angle || dag.label_of(id).is_some() || size > LONGEST_STATEMENT;
            if own || waiting.iter().any(|(late, _)| step.reads.contains(late)) {
                waiting.drain(..).for_each(|(late, _)| self.own_statement.insert(late));
            }
            if own {
                self.own_statement.insert(id);
            } else {
                waiting.push((id, size));
            }
        }
    }
}

/// Latency on a present-day host, in cycles, roughly.
fn latency(node: Node) -> usize {
    match node {
        Node::Unary(Unary::Sin | Unary::Cos, _) => 60,
        Node::Unary(..) => 18,
        Node::Binary(Binary::Div, ..) => 13,
        Node::Binary(..) => 4,
        _ => 0,
    }
}
