//! Articulated-body algorithm: u' of a tree, joint by joint, without a mass matrix (Featherstone 2008, chapter 7).
//!
//! In: the bodies as a tree in which every joint has speeds of its own, and the active forces. Out: u' and its pivots,
//! by a number of operations that grows linearly with the length of the tree.
//!
//! Accelerations are counted relative to those at u' = 0 (`tree_motion`). Inwards, from the leaves, every joint is
//! released: with s its twist, U = I s and D = s . U, its u' = (F - s . wrench) / D - (U / D) . A, where A is the
//! acceleration of the body inside relative to that at u' = 0; that body then carries the articulated inertia I - U U'
//! / D. Outwards, A follows. The three speeds of a ball joint are released one after the other; what remains has
//! exactly no resistance to rotation. The D are the pivots of M = L' D L.

use super::articulated_inertia::Articulated;
use super::given::Given;
use super::mass_and_force::MassAndForce;
use super::solve::NO_INERTIA;
use super::spatial::Wrench;
use super::tree::{self, JointTurn, TreeNode};
use super::tree_motion::{self, Base, Moves, NodeMotion, power};
use super::{active_force, shared_axis};
use crate::expr::tape::SampleTable;
use crate::expr::{Dag, ExprId, Label};
use crate::kinematics::eliminate::{Pivot, Solution, Step, pivot_of};
use crate::kinematics::{Kinematics, UnknownId, derivative_of};
use crate::model::Model;
use crate::section::Section;
use crate::vector::{Algebra, Components, cross_components, dot_components};
use std::collections::BTreeMap;

/// With fewer speeds little is gained: six point masses on hinges take 623 operations, through the mass matrix 638.
const FEWEST_SPEEDS: usize = 7;

/// u' by the articulated-body algorithm.
#[derive(Clone, Debug)]
pub(super) struct HingeByHinge {
    /// The independent accelerations.
    pub u_dot: Vec<ExprId>,
    /// The divisors D.
    pub pivots: Vec<Pivot>,
}

/// A released speed with its twist (v, w).
struct Released {
    unknown: UnknownId,
    v: Components,
    w: Components,
    /// U / D.
    share: Wrench,
    /// (F - s . wrench) / D.
    alone: ExprId,
    pivot: ExprId,
}

/// A place in a node's triad where other nodes hang.
struct JointPlace {
    parent: usize,
    offset: Components,
}

/// A speed with its acceleration and the pivot.
struct Solved {
    unknown: UnknownId,
    acceleration: ExprId,
    pivot: ExprId,
}

/// An acceleration relative to that at u' = 0: of the origin, and angular.
type Beyond = (Components, Components);

/// u' of a tree whose joints share no speeds; `None` for other mechanisms, or if a pivot vanishes.
pub(super) fn derive(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    solution: &Solution,
    table: &mut SampleTable,
    mass_matrix: &[Vec<ExprId>],
) -> Option<HingeByHinge> {
    if k.unknowns.len() < FEWEST_SPEEDS {
        return None;
    }
    // Dependent speeds that are constantly zero, such as the one along the Euler parameters, do not matter.
    let still = |step: &Step| step.coefficients.is_empty() && alg.dag.is_zero(step.bias);
    let independent = k.unknowns.clock().is_none() && solution.steps.iter().all(still);
    let bodies = shared_axis::bodies(alg, model, k);
    if !independent || bodies.is_empty() || bodies.iter().any(|m| !m.body.weight) {
        return None;
    }
    let forest = tree::build(alg, model, k, &bodies, tree::Joints::All);
    let roots: Vec<usize> = forest.roots().into_keys().collect();
    let moving =
        roots.iter().filter(|&&root| !derivative_of(alg, k, &forest.nodes[root].origin).partials.is_empty());
    if moving.count() > 1 {
        return None; // their motions hold the same speeds
    }
    let mut active = MassAndForce::default();
    active_force::accumulate(alg, model, k, &mut active);
    let mut found: BTreeMap<UnknownId, Solved> = BTreeMap::new();
    for root in roots {
        for solved in Tree::new(alg, model, k, &forest.nodes, root)?.solve(&mut alg.dag, &active) {
            if found.insert(solved.unknown, solved).is_some() {
                return None;
            }
        }
    }
    let unknowns = k.unknowns.independent();
    let mut pivots = Vec::new();
    for (row, unknown) in unknowns.iter().enumerate() {
        let &Solved { pivot, .. } = found.get(unknown)?;
        let whole = table.values(&alg.dag, mass_matrix[row][row]).to_vec();
        let values = table.values(&alg.dag, pivot);
        if !values.iter().zip(&whole).all(|(d, m)| *d > NO_INERTIA * m.abs()) {
            return None;
        }
        if !alg.dag.is_constant(pivot) {
            alg.dag.label(pivot, Label::named(Section::Inertia, format!("pivot_{row}")));
            pivots.push(pivot_of(&alg.dag, table, pivot));
        }
    }
    Some(HingeByHinge { u_dot: unknowns.iter().map(|u| found[u].acceleration).collect(), pivots })
}

/// The nodes that hang on a root, with their motions.
struct Tree {
    nodes: Vec<TreeNode>,
    root: usize,
    base: Base,
    states: Vec<Option<NodeMotion>>,
    moves: Vec<Option<Moves>>,
    places: Vec<JointPlace>,
    /// By node: the place where it hangs, if it does.
    place_of: Vec<Option<usize>>,
}

impl Tree {
    /// `None` if one speed moves several places of the tree.
    fn new(
        alg: &mut Algebra,
        model: &Model,
        k: &Kinematics,
        nodes: &[TreeNode],
        root: usize,
    ) -> Option<Self> {
        let mut nodes = nodes.to_vec();
        tree::move_inwards(alg, &mut nodes, root, tree::Wheels::Whole);
        let base = Base::new(alg, model, k, &Given::default(), &nodes[root]);
        let (states, moves) = tree_motion::motions(alg, k, &Given::default(), &nodes, root, &base.state);
        let (mut places, mut place_of): (Vec<JointPlace>, _) = (Vec::new(), vec![None; nodes.len()]);
        for (i, node) in nodes.iter().enumerate() {
            let (Some(joint), Some(_)) = (&node.joint, &moves[i]) else { continue };
            let same = places.iter().position(|p| p.parent == joint.parent && p.offset == joint.offset);
            place_of[i] = Some(same.unwrap_or(places.len()));
            if same.is_none() {
                places.push(JointPlace { parent: joint.parent, offset: joint.offset });
            }
        }
        let one = alg.dag.one();
        let mut balls = moves.iter().flatten().filter_map(|motion| motion.ball.as_ref()).flatten();
        if !balls.clone().all(|rate| rate.partials.len() == 1 && rate.partials.values().all(|p| *p == one)) {
            return None;
        }
        let turning = moves.iter().flatten().flat_map(|motion| motion.turn.partials.keys());
        let turning = turning.chain(balls.by_ref().flat_map(|rate| rate.partials.keys()));
        let sliding = moves.iter().flatten().flat_map(|motion| slides(&mut alg.dag, motion).into_keys());
        let sliding: Vec<UnknownId> = sliding.collect();
        let mut speeds: Vec<UnknownId> =
            base.twists.iter().map(|(u, ..)| u).chain(turning).chain(&sliding).copied().collect();
        let n = speeds.len();
        speeds.sort();
        speeds.dedup();
        (speeds.len() == n).then_some(Self { nodes, root, base, states, moves, places, place_of })
    }

    /// Solves for the derivatives of all speeds.
    fn solve(&self, dag: &mut Dag, active: &MassAndForce) -> Vec<Solved> {
        // By node: the released speeds of its joint, with their twists in its triad.
        let mut freed: Vec<Vec<Released>> = Vec::new();
        freed.resize_with(self.nodes.len(), Vec::new);
        // By place: the articulated body that hangs there, in the triad of the node that has the place.
        let mut hanging: Vec<Option<Articulated>> = self.places.iter().map(|_| None).collect();
        let zero = [dag.zero(); 3];
        for i in (self.root..self.nodes.len()).rev() {
            let (node, Some(state)) = (&self.nodes[i], &self.states[i]) else { continue };
            let wrench = node.own.resistance(dag, &state.acceleration);
            let mut body = Articulated::rigid(dag, &node.own, wrench);
            for (p, place) in self.places.iter().enumerate().filter(|(_, place)| place.parent == i) {
                let Some(outer) = hanging[p].take() else { continue };
                let outer = outer.shifted(dag, &place.offset);
                body = body.plus(dag, &outer);
            }
            let (Some(joint), Some(motion), Some(p)) = (&node.joint, &self.moves[i], self.place_of[i]) else {
                freed[i] = self.base.twists.iter().map(|t| set_free(dag, &mut body, *t, active)).collect();
                continue;
            };
            let body = match &joint.turn {
                JointTurn::Hinge(axis, angle) => {
                    for (&unknown, &partial) in &motion.turn.partials {
                        let mut w = zero;
                        w[*axis as usize] = partial;
                        freed[i].push(set_free(dag, &mut body, (unknown, zero, w), active));
                    }
                    body.turned(dag, *axis, *angle)
                }
                JointTurn::Ball(ball) => {
                    let one = dag.one();
                    let mut moment = zero;
                    for (axis, rate) in motion.ball.iter().flatten().enumerate() {
                        let mut w = zero;
                        w[axis] = one;
                        for &unknown in rate.partials.keys() {
                            freed[i].push(set_free(dag, &mut body, (unknown, zero, w), active));
                            moment[axis] = active.force.coefficient(dag, unknown);
                        }
                    }
                    body.held_by_force(dag, &ball.0, moment)
                }
                JointTurn::Slide => {
                    for (unknown, v) in slides(dag, motion) {
                        freed[i].push(set_free(dag, &mut body, (unknown, v, zero), active));
                    }
                    body
                }
            };
            hanging[p] =
                Some(hanging[p].take().map_or_else(|| body.clone(), |beside| beside.plus(dag, &body)));
        }
        self.outwards(dag, &freed)
    }

    /// Computes u' from the root to the leaves.
    fn outwards(&self, dag: &mut Dag, freed: &[Vec<Released>]) -> Vec<Solved> {
        let mut found = Vec::new();
        let zero = [dag.zero(); 3];
        let mut beyond: Vec<Option<Beyond>> = vec![None; self.nodes.len()];
        let mut at_place: Vec<Option<Beyond>> = vec![None; self.places.len()];
        beyond[self.root] = Some(accelerate(dag, (zero, zero), &freed[self.root], &mut found));
        for (i, node) in self.nodes.iter().enumerate().skip(self.root + 1) {
            let (Some(joint), Some(p)) = (&node.joint, self.place_of[i]) else { continue };
            let Some((a, alpha)) = beyond[joint.parent] else { continue };
            let (a, alpha) = at_place[p].unwrap_or_else(|| {
                let carried = cross_components(dag, &alpha, &joint.offset);
                (std::array::from_fn(|n| dag.add(a[n], carried[n])), alpha)
            });
            at_place[p] = Some((a, alpha));
            let [a, alpha] = [a, alpha].map(|v| joint.outwards(dag, v));
            beyond[i] = Some(accelerate(dag, (a, alpha), &freed[i], &mut found));
        }
        found
    }
}

/// The unknowns by which a joint slides, each with its direction in the parent's triad.
fn slides(dag: &mut Dag, motion: &Moves) -> BTreeMap<UnknownId, Components> {
    let zero = dag.zero();
    let mut found: BTreeMap<UnknownId, Components> = BTreeMap::new();
    for (i, rate) in motion.slide.iter().enumerate() {
        for (&unknown, &partial) in &rate.partials {
            found.entry(unknown).or_insert([zero; 3])[i] = partial;
        }
    }
    found
}

/// Releases a speed; `body` becomes the articulated body without that motion.
fn set_free(
    dag: &mut Dag,
    body: &mut Articulated,
    (unknown, v, w): (UnknownId, Components, Components),
    active: &MassAndForce,
) -> Released {
    let column = body.resistance(dag, &v, &w);
    let pivot = power(dag, &v, &w, &column);
    let share = column.map(|e| dag.div(e, pivot));
    let taken = power(dag, &v, &w, &body.wrench);
    let force = active.force.get(&unknown).copied().unwrap_or_else(|| dag.zero());
    let rest = dag.sub(force, taken);
    let alone = dag.div(rest, pivot);
    body.release(dag, &column, &share);
    let carried = column.map(|e| dag.mul(e, alone));
    body.wrench = body.wrench.plus(dag, &carried);
    Released { unknown, v, w, share, alone, pivot }
}

/// Adds the accelerations of the speeds released at one place, the innermost first.
fn accelerate(
    dag: &mut Dag,
    (mut a, mut alpha): Beyond,
    freed: &[Released],
    found: &mut Vec<Solved>,
) -> Beyond {
    for free in freed.iter().rev() {
        let [straight, turning] = [(&free.share.force, &a), (&free.share.moment, &alpha)]
            .map(|(share, acceleration)| dot_components(dag, share, acceleration));
        let given = dag.add(straight, turning);
        let acceleration = dag.sub(free.alone, given);
        for i in 0..3 {
            let [v, w] = [free.v[i], free.w[i]].map(|part| dag.mul(part, acceleration));
            a[i] = dag.add(a[i], v);
            alpha[i] = dag.add(alpha[i], w);
        }
        found.push(Solved { unknown: free.unknown, acceleration, pivot: free.pivot });
    }
    (a, alpha)
}
