//! Hinges with parallel axes, one outside the other.
//!
//! A rotation of the inner hinge also turns what hangs on the outer one, unless the outer hinge turns back. With the
//! absolute rate w = u_a + u_b of the outer part instead of u_b the two rates share little inertia: the inner one
//! carries the outer part along without turning it. In relative rates M_aa, M_ab and M_bb all contain the outer part's
//! inertia; the elimination takes their difference and loses digits. So the entries are formed as M_bb, M_ab = M_bb +
//! d, M_aa = M'_aa + d + M_ab, and solved in absolute rates (`absolute`), where the shared part is never formed.

use super::spatial::{Inertia, Wrench};
use super::tree::{Joint, TreeNode};
use super::tree_motion::{Moves, power};
use crate::expr::{Dag, ExprId};
use crate::kinematics::{Kinematics, UnknownId};
use crate::vector::{Algebra, Components, cross_components};

/// The inertia that the rotation of a hinge moves, if a part that it carries hangs on a parallel hinge.
#[derive(Clone, Debug)]
pub(super) struct Turning {
    /// The node on the outer, parallel hinge, and the unknown that is its rate.
    outer: (usize, UnknownId),
    /// The inertia that turns with the hinge: all but the part on the outer hinge.
    inertia: Inertia,
    /// Inertia of that part about the outer hinge, and the position of the outer hinge.
    carried: Option<(Inertia, Components)>,
}

/// By node: its parallel outer hinge, if it has one; none at all if some speeds are dependent.
pub(super) fn turning(
    alg: &Algebra,
    k: &Kinematics,
    nodes: &[TreeNode],
    moves: &[Option<Moves>],
) -> Vec<Option<Turning>> {
    let mut found: Vec<Option<Turning>> = vec![None; nodes.len()];
    if !k.unknowns.are_independent() {
        return found;
    }
    for (i, node) in nodes.iter().enumerate() {
        let Some(joint) = &node.joint else { continue };
        let inner = &nodes[joint.parent];
        let axis = |joint: &Joint| joint.hinge().map(|(axis, _)| axis);
        let same_axis = axis(joint).is_some() && inner.joint.as_ref().and_then(axis) == axis(joint);
        let rigid = moves[i].as_ref().is_some_and(|m| m.slide.iter().all(|rate| rate.partials.is_empty()));
        let weight = !node.own.is_zero(&alg.dag) && alg.dag.is_zero(node.spin) && alg.dag.is_zero(inner.spin);
        if let (true, Some(outer), Some(_)) =
            (same_axis && rigid && weight, rate(alg, moves, i), rate(alg, moves, joint.parent))
        {
            let turning = Turning { outer: (i, outer), inertia: inner.own.clone(), carried: None };
            found[joint.parent].get_or_insert(turning);
        }
    }
    found
}

/// The unknown that is the rate of a node's hinge and of no other joint: M_bb is then due to the outer part alone.
fn rate(alg: &Algebra, moves: &[Option<Moves>], node: usize) -> Option<UnknownId> {
    let turn = &moves[node].as_ref()?.turn;
    let (&unknown, &partial) = turn.partials.iter().next()?;
    let rates =
        |m: &Moves| std::iter::once(&m.turn).chain(&m.slide).any(|r| r.partials.contains_key(&unknown));
    let joints = moves.iter().flatten().filter(|&m| rates(m)).count();
    (joints == 1 && turn.partials.len() == 1 && alg.dag.is_one(partial)).then_some(unknown)
}

impl Turning {
    /// Adds a load that hangs on `node` at `offset` from the hinge.
    pub fn add(&mut self, dag: &mut Dag, node: usize, inertia: &Inertia, offset: &Components) {
        if node == self.outer.0 {
            self.carried = Some((inertia.clone(), *offset));
        } else {
            self.inertia = self.inertia.plus(dag, inertia);
        }
    }

    /// The outer unknown; then M'_aa and the momentum for a rotation w of this hinge while what hangs on the outer
    /// hinge keeps its orientation, so that all of it moves at w x p.
    pub fn column(&self, dag: &mut Dag, w: &Components) -> (UnknownId, ExprId, Wrench) {
        let zero = [dag.zero(); 3];
        let mut column = self.inertia.momentum(dag, &zero, w);
        let mut own = power(dag, &zero, w, &column);
        if let Some((inertia, offset)) = &self.carried {
            let velocity = cross_components(dag, w, offset);
            let carried = inertia.momentum(dag, &velocity, &zero);
            let product = power(dag, &velocity, &zero, &carried);
            own = dag.add(own, product);
            column = column.plus(dag, &carried);
        }
        (self.outer.1, own, column)
    }
}
