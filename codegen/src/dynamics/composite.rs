//! Generalised inertia forces of a tree by composite bodies.
//!
//! With tw the twist of a node, s what its joint adds to its parent's twist, and C the inertia of all
//! that hangs on the node, 2 T = sum over nodes of s' C s + 2 s' C (twist of the parent, moved): each
//! column C s is formed once and carried inwards. The bias is Newton and Euler's recursion: outwards
//! the accelerations at y' = 0, inwards the wrenches that they take. Walker, Orin 1982; Featherstone
//! 2008, chapters 5 and 6. Everything in the triad of the node at hand.

use super::given::Given;
use super::parallel::{self, Turning};
use super::spatial::{Acceleration, Inertia, Wrench, gradient};
use super::tree::{self, Joint, Node};
use crate::expr::{Dag, ExprId};
use crate::kinematics::{
    Kinematics, Motion, Rate, UnknownId, derivative_of, lower_vector, rate_of, scalar_rate_of, value_of,
};
use crate::model::{Axis, Model};
use crate::vector::{Components, Vector, dot_components};
use std::collections::BTreeMap;

/// Contributions to M_y (keys k <= l) and to the forces.
#[derive(Clone, Debug, Default)]
pub(super) struct Contributions {
    pub mass: Vec<(UnknownId, UnknownId, ExprId)>,
    pub force: Vec<(UnknownId, ExprId)>,
}

/// Angular velocity, angular acceleration at y' = 0, acceleration of the origin at y' = 0 less gravity.
#[derive(Clone, Debug)]
pub(super) struct State {
    w: Components,
    alpha: Components,
    pub acceleration: Acceleration,
}

/// A joint's rates: how it turns, and how its place moves in the parent's triad.
pub(super) struct Moves {
    pub turn: Rate,
    turn_rate: ExprId,
    pub slide: [Rate; 3],
}

/// What hangs on a node, in its triad about its origin.
#[derive(Clone, Debug)]
struct Load {
    inertia: Inertia,
    bias: Wrench,
    columns: BTreeMap<UnknownId, Wrench>,
    /// Columns that leave a parallel hinge farther out unturned, and that hinge's unknown: the column of the
    /// first rate alone is both together.
    beside: BTreeMap<UnknownId, UnknownId>,
}

/// Contributions of the nodes that hang on `cut`, itself included, its whole twist being its own.
pub(super) fn contributions(
    model: &Model,
    k: &mut Kinematics,
    given: &Given,
    nodes: &[Node],
    cut: usize,
) -> Contributions {
    let mut nodes = nodes.to_vec();
    tree::move_inwards(k, &mut nodes, cut, tree::Wheels::Spin);
    let nodes = &nodes[..];
    let mut found = Contributions::default();
    let base = Base::new(model, k, given, &nodes[cut]);
    let (states, moves) = motions(k, given, nodes, cut, &base.state);
    let mut turning = parallel::turning(k, nodes, &moves);
    let dag = &mut k.dag;
    let mut loads: Vec<Option<Load>> = Vec::new();
    for (node, state) in nodes.iter().zip(&states) {
        loads.push(state.as_ref().map(|state| Load {
            inertia: node.own.clone(),
            bias: node.own.resistance(dag, &state.acceleration),
            columns: BTreeMap::new(),
            beside: BTreeMap::new(),
        }));
    }
    for i in (cut + 1..nodes.len()).rev() {
        let (Some(joint), Some(motion), Some(load)) = (&nodes[i].joint, &moves[i], loads[i].take()) else {
            continue;
        };
        let Some(inner) = states[joint.parent].clone() else { continue };
        let load = inwards(k, &nodes[i], joint, motion, (load, turning[i].take()), &inner, &mut found);
        if let Some(parent) = &mut loads[joint.parent] {
            if let Some(turning) = &mut turning[joint.parent] {
                turning.add(&mut k.dag, i, &load.inertia, &joint.offset);
            }
            parent.add(&mut k.dag, &load);
        }
    }
    if let Some(load) = loads[cut].take() {
        base.close(k, load, &mut found);
    }
    found.mass.retain(|(_, _, e)| !k.dag.is_zero(*e));
    found.force.retain(|(_, e)| !k.dag.is_zero(*e));
    found
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

impl Load {
    fn add(&mut self, dag: &mut Dag, other: &Self) {
        self.inertia = self.inertia.plus(dag, &other.inertia);
        self.bias = self.bias.plus(dag, &other.bias);
        for (&unknown, wrench) in &other.columns {
            self.add_column(dag, unknown, wrench);
        }
        self.beside.extend(&other.beside);
    }

    fn add_column(&mut self, dag: &mut Dag, unknown: UnknownId, wrench: &Wrench) {
        let sum = match self.columns.get(&unknown) {
            Some(mine) => mine.plus(dag, wrench),
            None => wrench.clone(),
        };
        self.columns.insert(unknown, sum);
    }
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
fn relative_alpha(dag: &mut Dag, axis: Axis, motion: &Moves, w: &Components) -> Components {
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

/// Columns and contributions of a joint; the load as its parent feels it.
fn inwards(
    k: &mut Kinematics,
    node: &Node,
    joint: &Joint,
    motion: &Moves,
    (mut load, turning): (Load, Option<Turning>),
    inner: &State,
    found: &mut Contributions,
) -> Load {
    let dag = &mut k.dag;
    let zero = [dag.zero(); 3];
    let axis = joint.axis as usize;
    let mut own: Vec<(UnknownId, Components, Components)> = Vec::new();
    for (&unknown, &partial) in &motion.turn.partials {
        let mut w = zero;
        w[axis] = partial;
        own.push((unknown, zero, w));
    }
    match turning {
        Some(turning) => load.meet_parallel(dag, &own[0], &turning, found),
        None => load.meet(dag, &own, found),
    }
    let mut load = load.turned(dag, joint);
    load.spin(dag, node.spin, joint.axis, motion, inner, found);
    let sliding: Vec<UnknownId> = motion.slide.iter().flat_map(|r| r.partials.keys().copied()).collect();
    let mut own = BTreeMap::new();
    for unknown in sliding {
        let v = std::array::from_fn(|i| motion.slide[i].partials.get(&unknown).copied().unwrap_or(zero[0]));
        own.insert(unknown, v);
    }
    let own: Vec<_> = own.into_iter().map(|(unknown, v)| (unknown, v, zero)).collect();
    load.meet(dag, &own, found);
    load.shifted(dag, &joint.offset)
}

impl Load {
    /// Adds what the twists `own` (unknown, v, w) contribute against this load, and their columns.
    fn meet(
        &mut self,
        dag: &mut Dag,
        own: &[(UnknownId, Components, Components)],
        found: &mut Contributions,
    ) {
        let new: Vec<Wrench> = own.iter().map(|(_, v, w)| self.inertia.momentum(dag, v, w)).collect();
        for (n, (unknown, v, w)) in own.iter().enumerate() {
            for (other, product) in self.powers(dag, v, w) {
                found.add_mass(dag, *unknown, other, product);
            }
            for ((other, ..), column) in own.iter().zip(&new).skip(n) {
                let product = power(dag, v, w, column);
                found.mass.push((*unknown.min(other), *unknown.max(other), product));
            }
            let work = power(dag, v, w, &self.bias);
            found.force.push((*unknown, dag.negate(work)));
        }
        for ((unknown, ..), column) in own.iter().zip(&new) {
            self.add_column(dag, *unknown, column);
        }
    }

    /// What a twist contributes against every column: products with the rates' own columns.
    fn powers(&self, dag: &mut Dag, v: &Components, w: &Components) -> BTreeMap<UnknownId, ExprId> {
        let mut products: BTreeMap<UnknownId, ExprId> =
            self.columns.iter().map(|(&unknown, column)| (unknown, power(dag, v, w, column))).collect();
        // The outermost hinge of several first: its column is its own.
        let mut waiting = self.beside.clone();
        while let Some((&inner, &outer)) = waiting.iter().find(|(_, outer)| !waiting.contains_key(outer)) {
            let sum = dag.add(products[&inner], products[&outer]);
            products.insert(inner, sum);
            waiting.remove(&inner);
        }
        products
    }

    /// [`Load::meet()`] of a hinge that leaves a parallel one farther out unturned: with M'_aa its own part, and
    /// d = M_ab - M_bb what the translation of the other takes, M_aa = M'_aa + d + M_ab.
    fn meet_parallel(
        &mut self,
        dag: &mut Dag,
        (unknown, v, w): &(UnknownId, Components, Components),
        turning: &Turning,
        found: &mut Contributions,
    ) {
        let products = self.powers(dag, v, w);
        let (outer, own, column) = turning.column(dag, w);
        let lever = dag.sub(products[&outer], found.mass_of(outer));
        let sum = dag.add(own, lever);
        let diagonal = dag.add(sum, products[&outer]);
        for (other, product) in products {
            found.add_mass(dag, *unknown, other, product);
        }
        found.mass.push((*unknown, *unknown, diagonal));
        let work = power(dag, v, w, &self.bias);
        found.force.push((*unknown, dag.negate(work)));
        self.add_column(dag, *unknown, &column);
        self.beside.insert(*unknown, outer);
    }

    fn turned(&self, dag: &mut Dag, joint: &Joint) -> Self {
        Self {
            inertia: self.inertia.turned(dag, joint.axis, joint.angle),
            bias: self.bias.turned(dag, joint.axis, joint.angle),
            columns: (self.columns.iter())
                .map(|(&unknown, column)| (unknown, column.turned(dag, joint.axis, joint.angle)))
                .collect(),
            beside: self.beside.clone(),
        }
    }

    fn shifted(&self, dag: &mut Dag, offset: &Components) -> Self {
        Self {
            inertia: self.inertia.shifted(dag, offset),
            bias: self.bias.shifted(dag, offset),
            columns: (self.columns.iter())
                .map(|(&unknown, column)| (unknown, column.shifted(dag, offset)))
                .collect(),
            beside: self.beside.clone(),
        }
    }

    /// A wheel's spin: its moment of momentum J angle' e, beside what moves with the carrier.
    fn spin(
        &mut self,
        dag: &mut Dag,
        inertia: ExprId,
        axis: Axis,
        motion: &Moves,
        inner: &State,
        found: &mut Contributions,
    ) {
        if dag.is_zero(inertia) {
            return;
        }
        let partials: Vec<(UnknownId, ExprId)> = motion.turn.partials.iter().map(|(&u, &r)| (u, r)).collect();
        // J (angle'' + alpha of the carrier along the axis), at y' = 0.
        let about = dag.add(motion.turn.bias, inner.alpha[axis as usize]);
        let resistance = dag.mul(inertia, about);
        for (n, &(unknown, partial)) in partials.iter().enumerate() {
            let momentum = dag.mul(inertia, partial);
            for &(other, rate) in &partials[n..] {
                let product = dag.mul(momentum, rate);
                found.mass.push((unknown, other, product));
            }
            let mut column = Wrench::zero(dag);
            column.moment[axis as usize] = momentum;
            self.add_column(dag, unknown, &column);
            let work = dag.mul(resistance, partial);
            found.force.push((unknown, dag.negate(work)));
        }
        let alpha = relative_alpha(dag, axis, motion, &inner.w);
        let moment = alpha.map(|c| dag.mul(inertia, c));
        let gyroscopic = Wrench { force: [dag.zero(); 3], moment };
        self.bias = self.bias.plus(dag, &gyroscopic);
    }
}

impl Contributions {
    /// Operations at every evaluation: of the forces alone where accelerations are given.
    pub(super) fn cost(&self, dag: &Dag, given: &Given) -> usize {
        let mass = self.mass.iter().filter(|_| !given.is_given()).map(|(_, _, e)| *e);
        let roots: Vec<ExprId> = mass.chain(self.force.iter().map(|(_, e)| *e)).collect();
        dag.state_cost(&roots)
    }

    /// The entry M_aa of a hinge that has been met.
    fn mass_of(&self, unknown: UnknownId) -> ExprId {
        let entry = self.mass.iter().find(|(a, b, _)| *a == unknown && *b == unknown);
        entry.expect("a hinge farther out is met before").2
    }

    /// An unknown that meets its own column of a joint farther out counts twice.
    fn add_mass(&mut self, dag: &mut Dag, a: UnknownId, b: UnknownId, product: ExprId) {
        let two = dag.number(crate::expr::number::Number::integer(2));
        let entry = if a == b { dag.mul(two, product) } else { product };
        self.mass.push((a.min(b), a.max(b), entry));
    }
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

    fn close(self, k: &mut Kinematics, mut load: Load, found: &mut Contributions) {
        load.meet(&mut k.dag, &self.twists, found);
    }
}
