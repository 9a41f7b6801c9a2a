//! Operation counts: + - * / sqrt sin cos and the other functions count 1 each, negation 0. Also an estimate of the
//! time that the operations take.

use super::node::NO_OPERATION;
use super::print::{binary_name, unary_name};
use super::{Binary, Dag, Dependence, ExprId, Node, NodeSet, Unary};
use crate::id::Id;
use rustc_hash::{FxHashMap as HashMap, FxHashSet as HashSet};
use std::collections::BTreeMap;

/// What is minimised when one of several equivalent forms is chosen.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Optimise {
    /// Fewest operations: small cores, small programs.
    #[default]
    Operations,
    /// Least time on a superscalar host, by the estimate of [`Dag::cycles`].
    Time,
    /// Least rounding near singular configurations, such as the change points of linkages: frames turned about parallel
    /// axes are related by differences of angles that are not rounded. Fewer operations, more sines.
    Accuracy,
}

/// How long an operation occupies the core, in thirds of a cycle, and its latency in cycles.
#[derive(Clone, Copy)]
struct Timing {
    occupies: usize,
    latency: usize,
}

/// Addition, subtraction, product: three start in a cycle.
const ARITHMETIC: Timing = Timing { occupies: 1, latency: 4 };
/// Quotients and square roots.
const DIVISION: Timing = Timing { occupies: 8, latency: 13 };
/// Sine and cosine of one angle together, by the runtime's polynomials; other functions are assumed to take as long.
const FUNCTION: Timing = Timing { occupies: 70, latency: 50 };

impl Dag {
    /// The cost of `roots` by the measure that `optimise` names.
    #[must_use]
    pub fn cost(&self, roots: &[ExprId], optimise: Optimise) -> usize {
        match optimise {
            Optimise::Operations | Optimise::Accuracy => self.state_cost(roots),
            Optimise::Time => self.cycles(roots),
        }
    }

    /// Estimated cycles of one evaluation, without what depends on parameters alone: the larger of the throughput bound
    /// (all operations) and the latency of the longest chain of dependent operations.
    ///
    /// Fitted to chains of 3 to 20 links on one x86 core (opt-level 3, no target-cpu). Good enough to choose between
    /// forms, not to predict times; on an in-order core the operation count says more.
    #[must_use]
    pub fn cycles(&self, roots: &[ExprId]) -> usize {
        let mut ready: HashMap<ExprId, usize> = HashMap::default();
        let (mut turned, mut divided): (HashSet<ExprId>, HashSet<ExprId>) = Default::default();
        let (mut thirds, mut path) = (0, 0);
        for id in self.reachable(roots) {
            let begins = self.operands(id).into_iter().flatten().map(|a| ready[&a]).max().unwrap_or(0);
            let timing = self.timing(id);
            thirds += match self.node(id) {
                Node::Unary(Unary::Sin | Unary::Cos, angle) if !turned.insert(angle) => 0,
                // The compiler takes the reciprocal of a shared divisor once and multiplies from then on.
                Node::Binary(Binary::Div, _, divisor) if !divided.insert(divisor) => ARITHMETIC.occupies,
                _ => timing.occupies,
            };
            ready.insert(id, begins + timing.latency);
            path = path.max(begins + timing.latency);
        }
        path.max(thirds / 3)
    }

    fn timing(&self, id: ExprId) -> Timing {
        match self.node(id) {
            _ if !self.is_operation(id) || self.dependence(id) != Dependence::State => {
                Timing { occupies: 0, latency: 0 }
            }
            Node::Binary(Binary::Div, ..) | Node::Unary(Unary::Sqrt, _) => DIVISION,
            Node::Unary(Unary::Abs, _) => ARITHMETIC,
            Node::Unary(..) | Node::Binary(Binary::Atan2, ..) => FUNCTION,
            _ => ARITHMETIC,
        }
    }

    /// Operations of one evaluation of `roots`, shared parts counted once. What depends on parameters alone is left
    /// out: it is computed only when a parameter changes.
    #[must_use]
    pub fn state_cost(&self, roots: &[ExprId]) -> usize {
        self.costs(roots).0
    }

    /// Operations needed for `roots` together, shared parts counted once, those of parameters included.
    #[must_use]
    pub fn cone_cost(&self, roots: &[ExprId]) -> usize {
        self.costs(roots).1
    }

    /// [`Self::state_cost`] and [`Self::cone_cost`] in one pass.
    pub(crate) fn costs(&self, roots: &[ExprId]) -> (usize, usize) {
        let (mut of_state, mut all) = (0, 0);
        self.sweep_operations(roots, |id| {
            of_state += usize::from(self.dependence(id) == Dependence::State && id != NO_OPERATION);
            all += usize::from(id != NO_OPERATION);
        });
        (of_state, all)
    }

    /// The operations needed for `roots` together.
    pub(crate) fn operations_of(&self, roots: &[ExprId]) -> NodeSet {
        self.sweep_operations(roots, |_| {})
    }

    /// Visits the operations below `roots` in descending order, stepping over negations, symbols and constants. Also
    /// visits [`NO_OPERATION`].
    fn sweep_operations(&self, roots: &[ExprId], mut visit: impl FnMut(ExprId)) -> NodeSet {
        let operations = || roots.iter().map(|root| self.facts[*root].operation);
        let mut needed = NodeSet::below(operations().map(|id| id.index() + 1).max().unwrap_or(1));
        operations().for_each(|id| needed.insert(id));
        needed.sweep_down(|id| {
            visit(id);
            self.facts[id].operations_read
        });
        needed.remove(NO_OPERATION);
        needed
    }

    /// Does the node cost an operation at run time? Constants and negations do not.
    #[must_use]
    pub fn is_operation(&self, id: ExprId) -> bool {
        id != NO_OPERATION && self.facts[id].operation == id
    }

    /// Free of symbols?
    #[must_use]
    pub fn is_constant(&self, id: ExprId) -> bool {
        self.dependence(id) == Dependence::Constant
    }

    /// Number of operations of each kind below `roots` that have this dependence.
    #[must_use]
    pub fn operations_by_kind(
        &self,
        roots: &[ExprId],
        dependence: Dependence,
    ) -> BTreeMap<&'static str, usize> {
        // Kinds are compared as numbers, which is faster than by their names.
        let mut counts: Vec<(_, usize)> = Vec::new();
        let counted = |&id: &ExprId| self.dependence(id) == dependence && self.is_operation(id);
        for id in self.cone(roots).iter().filter(counted) {
            let kind = match self.node(id) {
                Node::Unary(function, _) => (Some(function), None),
                Node::Binary(operator, ..) => (None, Some(operator)),
                _ => continue,
            };
            match counts.iter_mut().find(|(known, _)| *known == kind) {
                Some((_, count)) => *count += 1,
                None => counts.push((kind, 1)),
            }
        }
        let name = |(function, operator): (Option<Unary>, Option<Binary>)| {
            function.map(unary_name).or(operator.map(binary_name)).unwrap_or_default()
        };
        counts.into_iter().map(|(kind, count)| (name(kind), count)).collect()
    }
}
