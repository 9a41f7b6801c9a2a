//! Bodies as a tree of nodes, one per simple rotation, each with the inertia that turns with it.
//!
//! A body centred at O + c, with c resolved in the body's own triad, belongs to the node (triad, O). The node of a
//! simple rotation hangs on the node of the triad it is turned against, at the part of O that is resolved in that
//! triad. A body that slides within a triad has a node of its own there (`slide`), if slides are joints. Inertia that a
//! rotation does not change is moved inwards: mass and moments along a hinge's axis, and all of a wheel but its spin.
//! The sums then depend on parameters alone.

use super::rigid_inertia::RigidInertia;
use super::slide::Slides;
use super::spatial::Inertia;
use crate::expr::{Dag, Dependence, ExprId};
use crate::kinematics::{Kinematics, derivative_of, is_lifted_triad, lower_scalar};
use crate::model::{Axis, Model};
use crate::vector::{Algebra, Components, Spin, TriadId, Turn, Vector, dot_components, turn_components};
use std::collections::BTreeMap;

/// A triad with an origin, and the inertia that moves with both.
#[derive(Clone, Debug)]
pub(super) struct TreeNode {
    pub triad: TriadId,
    /// Position of the origin.
    pub origin: Vector,
    /// The joint by which it hangs on another node; `None` for a root.
    pub joint: Option<Joint>,
    /// Inertia that moves with the node, about its origin, in its triad.
    pub own: Inertia,
    /// Moment of inertia about the joint's axis that counts only in the joint's own rotation (kg m^2).
    pub spin: ExprId,
}

/// The joint of a node: a rotation relative to the parent, at `offset` in the parent's triad.
#[derive(Clone, Debug)]
pub(super) struct Joint {
    pub parent: usize,
    pub turn: JointTurn,
    pub offset: Components,
}

/// How a node is turned against its parent.
#[derive(Clone, Debug)]
pub(super) enum JointTurn {
    /// By an angle about an axis.
    Hinge(Axis, ExprId),
    /// Any rotation: the node's axes in the parent's components, and its angular velocity relative to the parent along
    /// the node's axes.
    Ball(Box<([Components; 3], Spin)>),
    /// Not at all: it slides, by an offset that moves.
    Slide,
}

impl Joint {
    /// Axis and angle of a hinge.
    pub(super) fn hinge(&self) -> Option<(Axis, ExprId)> {
        match self.turn {
            JointTurn::Hinge(axis, angle) => Some((axis, angle)),
            JointTurn::Ball(_) | JointTurn::Slide => None,
        }
    }

    /// Converts a vector from the parent's triad to the node's.
    pub(super) fn outwards(&self, dag: &mut Dag, v: Components) -> Components {
        match &self.turn {
            JointTurn::Hinge(axis, angle) => turn_components(dag, *axis, *angle, v, true),
            JointTurn::Ball(ball) => ball.0.each_ref().map(|row| dot_components(dag, row, &v)),
            JointTurn::Slide => v,
        }
    }
}

/// Which joints connect nodes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Joints {
    /// Hinges, whose offsets may move. A node of any other rotation is the root of a tree of its own.
    Hinges,
    /// Hinges and slides; the offsets of hinges do not move.
    Slides,
    /// Ball joints as well.
    All,
}

/// Nodes, each parent before its children, and the node of every body.
#[derive(Clone, Debug)]
pub(super) struct Forest {
    pub nodes: Vec<TreeNode>,
    node_of_body: Vec<usize>,
}

impl Forest {
    /// Every root that carries bodies, with their indices.
    pub(super) fn roots(&self) -> BTreeMap<usize, Vec<usize>> {
        let mut roots: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (body, &node) in self.node_of_body.iter().enumerate() {
            let mut at = node;
            while let Some(joint) = &self.nodes[at].joint {
                at = joint.parent;
            }
            roots.entry(at).or_default().push(body);
        }
        roots
    }

    /// Is any node turned against `root`?
    pub(super) fn has_joints(&self, root: usize) -> bool {
        self.nodes.iter().any(|node| node.joint.as_ref().is_some_and(|joint| joint.parent == root))
    }
}

/// Builds the tree of the given bodies.
pub(super) fn build(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    bodies: &[RigidInertia],
    joints: Joints,
) -> Forest {
    let centres = bodies.iter().map(|m| &k.positions[m.body.centre]);
    let slides = (joints != Joints::Hinges).then(|| Slides::new(&mut alg.dag, centres));
    let mut tree = Builder { model, k, joints, slides, nodes: Vec::new() };
    let mut node_of_body = Vec::new();
    for RigidInertia { body, inertia } in bodies {
        let position = k.positions[body.centre].clone();
        let own = body.frame.map(|f| k.frame_triad[f]);
        let triad = own.or(position.terms.keys().max().copied()).unwrap_or(TriadId::INERTIAL);
        let zero = alg.dag.zero();
        let (mut origin, mut centre) = tree.hold(alg, &position, triad);
        if centre.iter().any(|&c| alg.dag.dependence(c) == Dependence::State) {
            // The mass centre slides in its own triad: the origin moves with it.
            (origin, centre) = (position, [zero; 3]);
        }
        let mass = body.mass.as_ref().map_or(zero, |m| lower_scalar(alg, k, m));
        let inertia = Inertia::of_body(&mut alg.dag, mass, &centre, inertia);
        let node = tree.node_of(alg, triad, &origin);
        tree.nodes[node].own = tree.nodes[node].own.plus(&mut alg.dag, &inertia);
        node_of_body.push(node);
    }
    Forest { nodes: tree.nodes, node_of_body }
}

/// The vector without its part in `triad`, and that part.
fn without(alg: &mut Algebra, vector: &Vector, triad: TriadId) -> (Vector, Components) {
    let mut rest = vector.clone();
    let part = rest.terms.remove(&triad);
    (rest, part.unwrap_or([alg.dag.zero(); 3]))
}

/// The nodes built so far.
struct Builder<'m> {
    model: &'m Model,
    k: &'m Kinematics,
    joints: Joints,
    /// What slides; `None` if only hinges are joints.
    slides: Option<Slides>,
    nodes: Vec<TreeNode>,
}

impl Builder<'_> {
    /// The origin of the node in `triad` that holds a place, and the place's components about it.
    fn hold(&self, alg: &mut Algebra, place: &Vector, triad: TriadId) -> (Vector, Components) {
        let (rest, part) = without(alg, place, triad);
        let Some(slides) = &self.slides else { return (rest, part) };
        let (constant, displacements) = slides.split(&mut alg.dag, triad, &part);
        let moved = displacements.into_iter().fold(rest, |origin, displacement| {
            let displacement = Vector::new(&alg.dag, triad, displacement);
            origin.plus(&mut alg.dag, &displacement)
        });
        (moved, constant)
    }

    /// The node of a triad with this origin, with the nodes on which it hangs.
    fn node_of(&mut self, alg: &mut Algebra, triad: TriadId, origin: &Vector) -> usize {
        if let Some(found) = self.nodes.iter().position(|n| n.triad == triad && n.origin == *origin) {
            return found;
        }
        let joint = self.slide(alg, triad, origin).or_else(|| self.turn(alg, triad, origin));
        let (own, spin) = (Inertia::zero(&mut alg.dag), alg.dag.zero());
        self.nodes.push(TreeNode { triad, origin: origin.clone(), joint, own, spin });
        self.nodes.len() - 1
    }

    /// The joint by which an origin slides in its own triad.
    fn slide(&mut self, alg: &mut Algebra, triad: TriadId, origin: &Vector) -> Option<Joint> {
        let (mut rest, part) = without(alg, origin, triad);
        let (_, mut displacements) = self.slides.as_ref()?.split(&mut alg.dag, triad, &part);
        let offset = displacements.pop()?;
        for inner in displacements {
            let inner = Vector::new(&alg.dag, triad, inner);
            rest = rest.plus(&mut alg.dag, &inner);
        }
        let parent = self.node_of(alg, triad, &rest);
        Some(Joint { parent, turn: JointTurn::Slide, offset })
    }

    /// The joint that turns a triad; `None` for a root.
    fn turn(&mut self, alg: &mut Algebra, triad: TriadId, origin: &Vector) -> Option<Joint> {
        let (parent, turn) = match alg.triads.turn(triad).clone() {
            _ if is_lifted_triad(self.model, self.k, triad) => return None,
            Turn::Simple { parent, axis, angle } => (parent, JointTurn::Hinge(axis, angle)),
            Turn::Directions { parent, rows, spin: Some(spin) } if self.joints == Joints::All => {
                (parent, JointTurn::Ball(Box::new((rows, spin))))
            }
            Turn::Directions { .. } | Turn::Inertial => return None,
        };
        let (held_at, offset) = self.hold(alg, origin, parent);
        let parent = self.node_of(alg, parent, &held_at);
        Some(Joint { parent, turn, offset })
    }
}

/// The node at which the tree of `root` is cut: the first, from `root` outwards, that carries inertia or branches.
///
/// Any farther in, the inertia of the first body would be shifted to points about which it turns and its moments would
/// be turned back; there they are large compared with their differences.
pub(super) fn cut(alg: &mut Algebra, k: &Kinematics, nodes: &[TreeNode], root: usize) -> usize {
    if derivative_of(alg, k, &nodes[root].origin).partials.is_empty() {
        return root; // what is moved inwards to a place at rest has no inertia
    }
    let mut at = root;
    loop {
        let mut children = (at + 1..nodes.len())
            .filter(|&i| nodes[i].joint.as_ref().is_some_and(|joint| joint.parent == at));
        match (children.next(), children.next()) {
            (Some(only), None) if nodes[at].own.is_zero(&alg.dag) => at = only,
            _ => return at,
        }
    }
}

/// Is a wheel's inertia moved inwards except for its spin, or is a wheel treated as any other body?
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Wheels {
    Spin,
    Whole,
}

/// Base parameters: moves inertia that a joint's rotation does not change inwards, as far as the node `cut`.
pub(super) fn move_inwards(alg: &mut Algebra, nodes: &mut [TreeNode], cut: usize, wheels: Wheels) {
    let mut hangs = vec![false; nodes.len()];
    hangs[cut] = true;
    for i in cut + 1..nodes.len() {
        hangs[i] = nodes[i].joint.as_ref().is_some_and(|joint| hangs[joint.parent]);
    }
    for i in (cut + 1..nodes.len()).rev().filter(|&i| hangs[i]) {
        let Some(joint) = nodes[i].joint.clone() else { continue };
        let Some((axis, angle)) = joint.hinge() else { continue };
        let dag = &mut alg.dag;
        if joint.offset.iter().any(|&c| dag.dependence(c) == Dependence::State) {
            continue;
        }
        let own = nodes[i].own.clone();
        let (inner, outer) = if dag.dependence(angle) < Dependence::State {
            (own.turned(dag, axis, angle), Inertia::zero(dag))
        } else if wheels == Wheels::Spin && own.is_axisymmetric(dag, axis) {
            nodes[i].spin = own.about(dag, axis);
            (own, Inertia::zero(dag))
        } else {
            own.split(dag, axis)
        };
        nodes[i].own = outer;
        let inner = inner.shifted(dag, &joint.offset);
        nodes[joint.parent].own = nodes[joint.parent].own.plus(dag, &inner);
    }
}
