//! How the nodes of a tree move: twists and accelerations at y' = 0, from the node where it is cut outwards.
//!
//! In: nodes and the rates of their joints. Out: by node its state, and what its joint's rates are. Everything in the
//! triad of the node at hand.

use super::given::Given;
use super::spatial::{Acceleration, Wrench, gradient};
use super::tree::{Joint, Node};
use crate::expr::{Dag, ExprId};
use crate::kinematics::{
    Kinematics, Motion, Rate, UnknownId, derivative_of, lower_vector, rate_of, scalar_rate_of, value_of,
};
use crate::model::{Axis, Model};
use crate::vector::{Components, Vector, dot_components};

/// Angular velocity, angular acceleration at y' = 0, acceleration of the origin at y' = 0 less gravity.
#[derive(Clone, Debug)]
pub(super) struct State {
    pub w: Components,
    pub alpha: Components,
    pub acceleration: Acceleration,
}

/// A joint's rates: how it turns, and how its place moves in the parent's triad.
pub(super) struct Moves {
    pub turn: Rate,
    pub turn_rate: ExprId,
    pub slide: [Rate; 3],
}

/// States of the nodes that hang on `cut`, which is in the state `base`, and what their joints do.
pub(super) fn motions(
    k: &mut Kinematics,
    given: &Given,
    nodes: &[Node],
    cut: usize,
    base: &State,
) -> (Vec<Option<State>>, Vec<Option<Moves>>) {
    let mut states: Vec<Option<State>> = vec![None; nodes.len()];
    states[cut] = Some(base.clone());
    let mut moves: Vec<Option<Moves>> = nodes.iter().map(|_| None).collect();
    for i in cut + 1..nodes.len() {
        let Some(joint) = &nodes[i].joint else { continue };
        let Some(inner) = states[joint.parent].clone() else { continue };
        let motion = Moves::new(k, given, joint);
        states[i] = Some(outwards(k, joint, &motion, &inner));
        moves[i] = Some(motion);
    }
    (states, moves)
}

impl Moves {
    fn new(k: &mut Kinematics, given: &Given, joint: &Joint) -> Self {
        let turn = scalar_rate_of(k, joint.angle);
        let turn_rate = rate_of(k, &turn);
        let turn = given.rate(k, turn);
        let slide = joint.offset.map(|c| {
            let rate = scalar_rate_of(k, c);
            given.rate(k, rate)
        });
        Self { turn, turn_rate, slide }
    }
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

/// From the parent's state to the node's.
fn outwards(k: &mut Kinematics, joint: &Joint, motion: &Moves, inner: &State) -> State {
    let slide = motion.slide.clone().map(|rate| (rate_of(k, &rate), rate.bias));
    let dag = &mut k.dag;
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
    let relative = relative_alpha(dag, joint.axis, motion, &inner.w);
    let alpha = std::array::from_fn(|i| dag.add(inner.alpha[i], relative[i]));
    let turn = |dag: &mut Dag, v| crate::vector::turn_components(dag, joint.axis, joint.angle, v, true);
    let (alpha, origin) = (turn(dag, alpha), turn(dag, origin));
    let mut w = turn(dag, inner.w);
    w[joint.axis as usize] = dag.add(w[joint.axis as usize], motion.turn_rate);
    let gradient = gradient(dag, &w, &alpha);
    State { w, alpha, acceleration: Acceleration { origin, gradient } }
}

/// v . force + w . moment.
pub(super) fn power(dag: &mut Dag, v: &Components, w: &Components, wrench: &Wrench) -> ExprId {
    let straight = dot_components(dag, v, &wrench.force);
    let turning = dot_components(dag, w, &wrench.moment);
    dag.add(straight, turning)
}

/// The node where the tree is cut: its whole twist, as linear forms in the unknowns.
pub(super) struct Base {
    pub twists: Vec<(UnknownId, Components, Components)>,
    pub state: State,
}

impl Base {
    pub(super) fn new(model: &Model, k: &mut Kinematics, given: &Given, node: &Node) -> Self {
        let velocity = derivative_of(k, &node.origin);
        let mut velocity = given.motion(k, velocity);
        if let Some(gravity) = &model.gravity {
            let gravity = lower_vector(k, gravity);
            velocity.bias = velocity.bias.minus(&mut k.dag, &gravity);
        }
        let angular = k.angular[node.triad].clone();
        let angular = given.motion(k, angular);
        let here = |k: &mut Kinematics, v: &Vector| k.triads.express(&mut k.dag, v, node.triad);
        let w = value_of(k, &angular);
        let (w, alpha) = (here(k, &w), here(k, &angular.bias));
        let origin = here(k, &velocity.bias);
        let gradient = gradient(&mut k.dag, &w, &alpha);
        let state = State { w, alpha, acceleration: Acceleration { origin, gradient } };
        let mut unknowns: Vec<UnknownId> =
            velocity.partials.keys().chain(angular.partials.keys()).copied().collect();
        unknowns.sort();
        unknowns.dedup();
        let part = |k: &mut Kinematics, motion: &Motion, unknown: UnknownId| {
            let v = motion.partials.get(&unknown).cloned().unwrap_or_default();
            here(k, &v)
        };
        let twists = unknowns.into_iter().map(|u| (u, part(k, &velocity, u), part(k, &angular, u))).collect();
        Self { twists, state }
    }
}
