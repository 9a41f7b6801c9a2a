//! Moves inertia to another body along a shared axis, where it is constant.
//!
//! A body with an axis e that is also fixed in another frame turns relative to that frame about e alone, whatever loop
//! it is part of. Both have the same angular velocity w across e, hence a part J (1 - e e') of the inertia, symmetric
//! about e, has the same angular momentum J w across e in either. This part is moved to the body of the other frame,
//! where it is constant and adds to that body's own inertia. What turns about e stays.

use super::given::Given;
use super::mass_and_force::Terms;
use super::rigid_inertia::RigidInertia;
use super::rotation::rotation;
use super::spatial::{Symmetric, entry};
use crate::expr::ExprId;
use crate::kinematics::{Kinematics, is_lifted_triad, lower_scalar};
use crate::model::{Axis, Model};
use crate::vector::{Algebra, Components};

/// All bodies, with inertia moved wherever that takes fewer operations.
pub(super) fn bodies<'m>(alg: &mut Algebra, model: &'m Model, k: &Kinematics) -> Vec<RigidInertia<'m>> {
    let zero = alg.dag.zero();
    let mut list: Vec<RigidInertia> = Vec::new();
    for body in model.bodies.iter() {
        let inertia =
            std::array::from_fn(|i| body.inertia[i].as_ref().map_or(zero, |e| lower_scalar(alg, k, e)));
        list.push(RigidInertia { body, inertia });
    }
    for i in 0..list.len() {
        let Some((carrier, axis, direction)) = carrier(alg, model, k, &list, i) else { continue };
        let parts = [0, 1, 2].map(|other| if other == axis { zero } else { list[i].inertia[other] });
        let rest = parts.map(|part| without(alg, &list[i], axis, part));
        let least = (0..3).min_by_key(|&n| (cost(alg, k, &rest[n]), parts[n] != zero)).unwrap_or(axis);
        list[i] = rest[least].clone();
        add_across(alg, &mut list[carrier].inertia, parts[least], &direction);
    }
    list
}

/// A body whose frame is lifted and in which an axis of body `i` is fixed: its index, the axis, the axis's components
/// there.
fn carrier(
    alg: &Algebra,
    model: &Model,
    k: &Kinematics,
    list: &[RigidInertia],
    i: usize,
) -> Option<(usize, usize, Components)> {
    let triad_of = |rigid: &RigidInertia| rigid.body.frame.map(|frame| k.frame_triad[frame]);
    let own = triad_of(&list[i])?;
    for axis in [Axis::X, Axis::Y, Axis::Z] {
        for &(other, direction) in alg.triads.constants_of(own, axis) {
            let place = list.iter().position(|rigid| triad_of(rigid) == Some(other));
            if let (Some(place), true) = (place, other != own && is_lifted_triad(model, k, other)) {
                return Some((place, axis as usize, direction));
            }
        }
    }
    None
}

/// The body without `part`, which is symmetric about the axis.
fn without<'m>(alg: &mut Algebra, rigid: &RigidInertia<'m>, axis: usize, part: ExprId) -> RigidInertia<'m> {
    let mut rest = rigid.clone();
    for other in (0..3).filter(|&other| other != axis) {
        rest.inertia[other] = alg.dag.sub(rest.inertia[other], part);
    }
    rest
}

/// Number of mass matrix entries due to the body's rotation, and their operations. Compared in this order, because
/// every entry goes through all eliminations.
fn cost(alg: &mut Algebra, k: &Kinematics, rigid: &RigidInertia) -> (usize, usize) {
    let mut found = Terms::default();
    rotation(alg, k, &Given::default(), rigid, &mut found);
    (found.mass.len(), found.state_cost(&alg.dag, &Given::default()))
}

/// Adds part (1 - e e').
fn add_across(alg: &mut Algebra, inertia: &mut Symmetric, part: ExprId, e: &Components) {
    let dag = &mut alg.dag;
    for (i, j) in [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)] {
        let along = dag.mul(e[i], e[j]);
        let identity = if i == j { dag.one() } else { dag.zero() };
        let across = dag.sub(identity, along);
        let term = dag.mul(part, across);
        let own = &mut inertia[entry(i, j)];
        *own = dag.add(*own, term);
    }
}
