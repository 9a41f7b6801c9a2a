//! Generalised inertia forces of a tree by composite rigid bodies (Walker, Orin 1982; Featherstone 2008, chapters 5 and
//! 6).
//!
//! With s the twist that a node's joint adds to its parent's twist, and C the inertia of everything that hangs on the
//! node, 2 T = sum over nodes of s' C s + 2 s' C (twist of the parent, shifted): each column C s is formed once and
//! carried inwards. The bias is the Newton-Euler recursion: outwards the accelerations at y' = 0, inwards the wrenches
//! that they take. Everything is in the triad of the node at hand.

use super::given::Given;
use super::mass_and_force::Terms;
use super::parallel::{self, Turning};
use super::spatial::{Inertia, Wrench};
use super::tree::{self, Joint, TreeNode};
use super::tree_motion::{Base, Moves, NodeMotion, motions, power, relative_alpha};
use crate::expr::{Dag, ExprId};
use crate::kinematics::{Kinematics, LinearForm, UnknownId};
use crate::model::{Axis, Model};
use crate::vector::{Algebra, Components};
use std::collections::BTreeMap;

/// The composite body on a node: its inertia, bias wrench and columns C s, in the node's triad about its origin.
#[derive(Clone, Debug)]
struct Composite {
    inertia: Inertia,
    bias: Wrench,
    columns: BTreeMap<UnknownId, Wrench>,
    /// Keys are rates of hinges whose column leaves out a parallel hinge farther out (`parallel`); values are the rates
    /// of those hinges. The complete column of the key is the sum of both columns.
    completed_by: BTreeMap<UnknownId, UnknownId>,
}

/// Terms of `cut` and all nodes that hang on it; all components of the twist of `cut` are its own.
pub(super) fn contributions(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    given: &Given,
    nodes: &[TreeNode],
    cut: usize,
) -> Terms {
    let mut nodes = nodes.to_vec();
    tree::move_inwards(alg, &mut nodes, cut, tree::Wheels::Spin);
    let nodes = &nodes[..];
    let mut found = Terms::default();
    let base = Base::new(alg, model, k, given, &nodes[cut]);
    let (states, moves) = motions(alg, k, given, nodes, cut, &base.state);
    let mut turning = parallel::turning(alg, k, nodes, &moves);
    let dag = &mut alg.dag;
    let mut composites: Vec<Option<Composite>> = Vec::new();
    for (node, state) in nodes.iter().zip(&states) {
        composites.push(state.as_ref().map(|state| Composite {
            inertia: node.own.clone(),
            bias: node.own.resistance(dag, &state.acceleration),
            columns: BTreeMap::new(),
            completed_by: BTreeMap::new(),
        }));
    }
    for i in (cut + 1..nodes.len()).rev() {
        let (Some(joint), Some(motion), Some(composite)) = (&nodes[i].joint, &moves[i], composites[i].take())
        else {
            continue;
        };
        let Some(inner) = states[joint.parent].clone() else { continue };
        let composite = match joint.hinge() {
            Some(hinge) => {
                let turning = turning[i].take();
                turned_inwards(alg, &nodes[i], motion, (composite, turning), (&inner, hinge), &mut found)
            }
            None => composite,
        };
        let composite = slid_inwards(alg, joint, motion, composite, &mut found);
        if let Some(parent) = &mut composites[joint.parent] {
            if let Some(turning) = &mut turning[joint.parent] {
                turning.add(&mut alg.dag, i, &composite.inertia, &joint.offset);
            }
            parent.add(&mut alg.dag, &composite);
        }
    }
    if let Some(mut composite) = composites[cut].take() {
        composite.project(&mut alg.dag, &base.twists, &mut found);
    }
    found.mass.retain(|(_, _, e)| !alg.dag.is_zero(*e));
    found.force.retain(|(_, e)| !alg.dag.is_zero(*e));
    found
}

impl Composite {
    fn add(&mut self, dag: &mut Dag, other: &Self) {
        self.inertia = self.inertia.plus(dag, &other.inertia);
        self.bias = self.bias.plus(dag, &other.bias);
        for (&unknown, wrench) in &other.columns {
            self.add_column(dag, unknown, wrench);
        }
        self.completed_by.extend(&other.completed_by);
    }

    fn add_column(&mut self, dag: &mut Dag, unknown: UnknownId, wrench: &Wrench) {
        let sum = match self.columns.get(&unknown) {
            Some(mine) => mine.plus(dag, wrench),
            None => wrench.clone(),
        };
        self.columns.insert(unknown, sum);
    }
}

/// Adds the columns and contributions of a hinge's rotation; returns the composite in the parent's triad.
fn turned_inwards(
    alg: &mut Algebra,
    node: &TreeNode,
    motion: &Moves,
    (mut composite, turning): (Composite, Option<Turning>),
    (inner, hinge): (&NodeMotion, (Axis, ExprId)),
    found: &mut Terms,
) -> Composite {
    let dag = &mut alg.dag;
    let zero = [dag.zero(); 3];
    let axis = hinge.0 as usize;
    let mut own: Vec<(UnknownId, Components, Components)> = Vec::new();
    for (&unknown, &partial) in &motion.turn.partials {
        let mut w = zero;
        w[axis] = partial;
        own.push((unknown, zero, w));
    }
    match turning {
        Some(turning) => composite.project_parallel(dag, &own[0], &turning, found),
        None => composite.project(dag, &own, found),
    }
    let mut composite = composite.turned(dag, hinge);
    composite.spin(dag, node.spin, hinge.0, motion, inner, found);
    composite
}

/// Adds the columns and contributions of a joint's translation to a composite in the parent's triad; returns it about the
/// parent's origin.
fn slid_inwards(
    alg: &mut Algebra,
    joint: &Joint,
    motion: &Moves,
    mut composite: Composite,
    found: &mut Terms,
) -> Composite {
    let dag = &mut alg.dag;
    let zero = [dag.zero(); 3];
    let sliding: Vec<UnknownId> = motion.slide.iter().flat_map(|r| r.partials.keys().copied()).collect();
    let mut own = BTreeMap::new();
    for unknown in sliding {
        let v = std::array::from_fn(|i| motion.slide[i].partials.get(&unknown).copied().unwrap_or(zero[0]));
        own.insert(unknown, v);
    }
    let own: Vec<_> = own.into_iter().map(|(unknown, v)| (unknown, v, zero)).collect();
    composite.project(dag, &own, found);
    composite.shifted(dag, &joint.offset)
}

impl Composite {
    /// Projects the composite on the twists `own` (unknown, v, w) of a joint: adds v . f + w . n of columns and bias to M_y
    /// and to the forces, and adds the twists' own columns for the joints inside.
    fn project(&mut self, dag: &mut Dag, own: &[(UnknownId, Components, Components)], found: &mut Terms) {
        let new: Vec<Wrench> = own.iter().map(|(_, v, w)| self.inertia.momentum(dag, v, w)).collect();
        for (n, (unknown, v, w)) in own.iter().enumerate() {
            for (other, product) in self.powers(dag, v, w) {
                found.add_product(dag, *unknown, other, product);
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

    /// Products of a twist with the complete columns of all rates, by rate.
    fn powers(&self, dag: &mut Dag, v: &Components, w: &Components) -> LinearForm {
        let mut products: LinearForm =
            self.columns.iter().map(|(&unknown, column)| (unknown, power(dag, v, w, column))).collect();
        // The outermost of several parallel hinges first: its column is complete.
        let mut waiting = self.completed_by.clone();
        while let Some((&inner, &outer)) = waiting.iter().find(|(_, outer)| !waiting.contains_key(outer)) {
            let sum = dag.add(products[&inner], products[&outer]);
            products.insert(inner, sum);
            waiting.remove(&inner);
        }
        products
    }

    /// [`Composite::project()`] for a hinge that carries a parallel hinge farther out along without turning it. With M'_aa
    /// its own part and d = M_ab - M_bb the part due to the translation of the outer hinge, M_aa = M'_aa + d + M_ab.
    fn project_parallel(
        &mut self,
        dag: &mut Dag,
        (unknown, v, w): &(UnknownId, Components, Components),
        turning: &Turning,
        found: &mut Terms,
    ) {
        let products = self.powers(dag, v, w);
        let (outer, own, column) = turning.column(dag, w);
        let lever = dag.sub(products[&outer], found.mass_of(outer));
        let sum = dag.add(own, lever);
        let diagonal = dag.add(sum, products[&outer]);
        for (other, product) in products {
            found.add_product(dag, *unknown, other, product);
        }
        found.mass.push((*unknown, *unknown, diagonal));
        let work = power(dag, v, w, &self.bias);
        found.force.push((*unknown, dag.negate(work)));
        self.add_column(dag, *unknown, &column);
        self.completed_by.insert(*unknown, outer);
    }

    fn turned(&self, dag: &mut Dag, (axis, angle): (Axis, ExprId)) -> Self {
        Self {
            inertia: self.inertia.turned(dag, axis, angle),
            bias: self.bias.turned(dag, axis, angle),
            columns: (self.columns.iter())
                .map(|(&unknown, column)| (unknown, column.turned(dag, axis, angle)))
                .collect(),
            completed_by: self.completed_by.clone(),
        }
    }

    fn shifted(&self, dag: &mut Dag, offset: &Components) -> Self {
        Self {
            inertia: self.inertia.shifted(dag, offset),
            bias: self.bias.shifted(dag, offset),
            columns: (self.columns.iter())
                .map(|(&unknown, column)| (unknown, column.shifted(dag, offset)))
                .collect(),
            completed_by: self.completed_by.clone(),
        }
    }

    /// Adds the spin of a wheel: angular momentum J angle' e, in addition to what moves with the carrier.
    fn spin(
        &mut self,
        dag: &mut Dag,
        inertia: ExprId,
        axis: Axis,
        motion: &Moves,
        inner: &NodeMotion,
        found: &mut Terms,
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
