//! Motions of the nodes of a tree: twists and accelerations at y' = 0, from the node where it is cut outwards.
//!
//! In: nodes and the rates of their joints. Out: by node its state and the rates of its joint. Everything is in the
//! triad of the node at hand.

use super::given::Given;
use super::spatial::{Acceleration, Wrench, gradient};
use super::tree::{Joint, JointTurn, TreeNode};
use crate::expr::{Dag, ExprId};
use crate::kinematics::{
    Kinematics, LinearForm, Motion, Rate, UnknownId, derivative_of, lower_vector, scalar_rate_of,
    sum_of_rates,
};
use crate::model::{Axis, Model};
use crate::vector::{Algebra, Components, Vector, dot_components};

/// Angular velocity, angular acceleration at y' = 0, acceleration of the origin at y' = 0 less gravity.
#[derive(Clone, Debug)]
pub(super) struct NodeMotion {
    pub w: Components,
    pub alpha: Components,
    pub acceleration: Acceleration,
}

/// A joint's rates: its rotation, and the translation of its place in the parent's triad.
pub(super) struct Moves {
    /// Rate of a hinge's angle; zero for other joints.
    pub turn: Rate,
    pub turn_rate: ExprId,
    /// Angular velocity of a ball joint, along the node's axes.
    pub ball: Option<[Rate; 3]>,
    pub slide: [Rate; 3],
}

/// States and joint rates of the nodes that hang on `cut`, whose state is `base`.
pub(super) fn motions(
    alg: &mut Algebra,
    k: &Kinematics,
    given: &Given,
    nodes: &[TreeNode],
    cut: usize,
    base: &NodeMotion,
) -> (Vec<Option<NodeMotion>>, Vec<Option<Moves>>) {
    let mut states: Vec<Option<NodeMotion>> = vec![None; nodes.len()];
    states[cut] = Some(base.clone());
    let mut moves: Vec<Option<Moves>> = nodes.iter().map(|_| None).collect();
    for i in cut + 1..nodes.len() {
        let Some(joint) = &nodes[i].joint else { continue };
        let Some(inner) = states[joint.parent].clone() else { continue };
        let motion = Moves::new(alg, k, given, joint);
        states[i] = Some(outwards(alg, k, joint, &motion, &inner));
        moves[i] = Some(motion);
    }
    (states, moves)
}

impl Moves {
    fn new(alg: &mut Algebra, k: &Kinematics, given: &Given, joint: &Joint) -> Self {
        let (turn, ball) = match &joint.turn {
            JointTurn::Hinge(_, angle) => (scalar_rate_of(alg, k, *angle), None),
            JointTurn::Ball(ball) => {
                let spin = ball.1.each_ref().map(|terms| {
                    let rate = sum_of_rates(alg, k, terms);
                    given.rate(alg, rate)
                });
                (still(alg), Some(spin))
            }
            JointTurn::Slide => (still(alg), None),
        };
        let turn_rate = turn.value(alg, k);
        let turn = given.rate(alg, turn);
        let slide = joint.offset.map(|c| {
            let rate = scalar_rate_of(alg, k, c);
            given.rate(alg, rate)
        });
        Self { turn, turn_rate, ball, slide }
    }
}

/// The rate of a constant.
fn still(alg: &mut Algebra) -> Rate {
    Rate { partials: LinearForm::default(), bias: alg.dag.zero() }
}

/// angle'' e at y' = 0 and w x angle' e, in the parent's triad.
pub(super) fn relative_alpha(dag: &mut Dag, axis: Axis, motion: &Moves, w: &Components) -> Components {
    let a = axis as usize;
    let (i, j) = ((a + 1) % 3, (a + 2) % 3);
    let mut alpha = [motion.turn.bias; 3];
    alpha[i] = dag.mul(motion.turn_rate, w[j]);
    let negative = dag.mul(motion.turn_rate, w[i]);
    alpha[j] = dag.negate(negative);
    alpha
}

/// The state of a node from that of its parent.
fn outwards(
    alg: &mut Algebra,
    k: &Kinematics,
    joint: &Joint,
    motion: &Moves,
    inner: &NodeMotion,
) -> NodeMotion {
    let slide = motion.slide.clone().map(|rate| (rate.value(alg, k), rate.bias));
    let ball = motion
        .ball
        .as_ref()
        .map(|spin| (spin.each_ref().map(|rate| rate.value(alg, k)), spin.each_ref().map(|rate| rate.bias)));
    let dag = &mut alg.dag;
    // a + U c + c'' + 2 w x c'
    let mut origin = inner.acceleration.at(dag, &joint.offset);
    let velocity = slide.map(|(rate, _)| rate);
    let coriolis = crate::vector::cross_components(dag, &inner.w, &velocity);
    let two = dag.number(crate::expr::number::Number::integer(2));
    for i in 0..3 {
        let term = dag.mul(two, coriolis[i]);
        let term = dag.add(term, slide[i].1);
        origin[i] = dag.add(origin[i], term);
    }
    let (w, alpha, origin) = match (joint.hinge(), ball) {
        (Some((axis, _)), _) => {
            let relative = relative_alpha(dag, axis, motion, &inner.w);
            let alpha = std::array::from_fn(|i| dag.add(inner.alpha[i], relative[i]));
            let (alpha, origin) = (joint.outwards(dag, alpha), joint.outwards(dag, origin));
            let mut w = joint.outwards(dag, inner.w);
            w[axis as usize] = dag.add(w[axis as usize], motion.turn_rate);
            (w, alpha, origin)
        }
        // alpha + s' + w x s, with s the angular velocity of the joint
        (None, ball) => {
            let (s, bias) = ball.unwrap_or(([dag.zero(); 3], [dag.zero(); 3]));
            let [w, alpha, origin] = [inner.w, inner.alpha, origin].map(|v| joint.outwards(dag, v));
            let turning = crate::vector::cross_components(dag, &w, &s);
            let relative: Components = std::array::from_fn(|i| dag.add(bias[i], turning[i]));
            let sum = |dag: &mut Dag, a: Components, b: Components| -> Components {
                std::array::from_fn(|i| dag.add(a[i], b[i]))
            };
            (sum(dag, w, s), sum(dag, alpha, relative), origin)
        }
    };
    let gradient = gradient(dag, &w, &alpha);
    NodeMotion { w, alpha, acceleration: Acceleration { origin, gradient } }
}

/// v . force + w . moment.
pub(super) fn power(dag: &mut Dag, v: &Components, w: &Components, wrench: &Wrench) -> ExprId {
    let straight = dot_components(dag, v, &wrench.force);
    let turning = dot_components(dag, w, &wrench.moment);
    dag.add(straight, turning)
}

/// The node where the tree is cut: its twist as linear forms in the unknowns.
pub(super) struct Base {
    pub twists: Vec<(UnknownId, Components, Components)>,
    pub state: NodeMotion,
}

impl Base {
    pub(super) fn new(
        alg: &mut Algebra,
        model: &Model,
        k: &Kinematics,
        given: &Given,
        node: &TreeNode,
    ) -> Self {
        let velocity = derivative_of(alg, k, &node.origin);
        let mut velocity = given.motion(alg, velocity);
        if let Some(gravity) = &model.gravity {
            let gravity = lower_vector(alg, k, gravity);
            velocity.bias = velocity.bias.minus(&mut alg.dag, &gravity);
        }
        let angular = k.angular[node.triad].clone();
        let angular = given.motion(alg, angular);
        let here = |alg: &mut Algebra, v: &Vector| alg.express(v, node.triad);
        let w = angular.value(alg, k);
        let (w, alpha) = (here(alg, &w), here(alg, &angular.bias));
        let origin = here(alg, &velocity.bias);
        let gradient = gradient(&mut alg.dag, &w, &alpha);
        let state = NodeMotion { w, alpha, acceleration: Acceleration { origin, gradient } };
        let mut unknowns: Vec<UnknownId> =
            velocity.partials.keys().chain(angular.partials.keys()).copied().collect();
        unknowns.sort();
        unknowns.dedup();
        let part = |alg: &mut Algebra, motion: &Motion, unknown: UnknownId| {
            let v = motion.partials.get(&unknown).cloned().unwrap_or_default();
            here(alg, &v)
        };
        let twists =
            unknowns.into_iter().map(|u| (u, part(alg, &velocity, u), part(alg, &angular, u))).collect();
        Self { twists, state }
    }
}
