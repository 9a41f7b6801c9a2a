//! Generalised inertia forces F*_r = -(M y' + h) over all unknowns.
//!
//! M_kl = sum m v_k . v_l + w_k . I . w_l over all bodies; the bias is h_k = sum m v_k . a_bias + w_k . (I alpha_bias +
//! w x I w). Bodies that hang on one another may instead be treated as a tree of composite bodies; the form with fewer
//! operations is kept.

use super::composite;
use super::given::Given;
use super::mass_and_force::{MassAndForce, Terms};
use super::rigid_inertia::RigidInertia;
use super::rotation::rotation;
use super::{shared_axis, tree};
use crate::kinematics::{Kinematics, Motion, UnknownId, lower_scalar, lower_vector};
use crate::model::{Body, Model};
use crate::vector::{Algebra, TriadId, Vector};

/// Above this number of scalar products the body-by-body form of a tree is not tried: that of a chain of fifteen
/// hinges.
const LONG: usize = 680;

/// Adds every body's inertia. With given accelerations the forces are the whole inertia force, and the masses are not
/// used.
pub(super) fn accumulate(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    given: &Given,
    parts: &mut MassAndForce,
) {
    // A composite body has the weight of all its parts: a body without weight is treated by itself.
    let bodies = shared_axis::bodies(alg, model, k);
    let (hanging, alone): (Vec<RigidInertia>, Vec<RigidInertia>) =
        bodies.into_iter().partition(|m| m.body.weight);
    let mut all = body_by_body(alg, model, k, given, &alone);
    // In a long tree, what slides within a triad must not be the root of a tree of its own, moved by all speeds inside.
    let joints = if n_products(k, &hanging) > LONG { tree::Joints::Slides } else { tree::Joints::Hinges };
    let forest = tree::build(alg, model, k, &hanging, joints);
    for (root, bodies) in forest.roots() {
        let bodies: Vec<RigidInertia> = bodies.into_iter().map(|i| hanging[i].clone()).collect();
        // For a long tree the body-by-body form takes products of all pairs of joints below each body and is never
        // shorter.
        let is_long = forest.has_joints(root) && n_products(k, &bodies) > LONG;
        let mut best = (!is_long).then(|| body_by_body(alg, model, k, given, &bodies));
        if forest.has_joints(root) {
            let cut = tree::cut(alg, k, &forest.nodes, root);
            let candidate = composite::contributions(alg, model, k, given, &forest.nodes, cut);
            if best
                .as_ref()
                .is_none_or(|best| candidate.state_cost(&alg.dag, given) < best.state_cost(&alg.dag, given))
            {
                best = Some(candidate);
            }
        }
        let best = best.unwrap_or_default();
        all.extend(best);
    }
    parts.add(&mut alg.dag, all);
}

/// Number of scalar products for the translations in the body-by-body form.
fn n_products(k: &Kinematics, bodies: &[RigidInertia]) -> usize {
    let moving = bodies.iter().map(|rigid| k.velocities[rigid.body.centre].partials.len());
    moving.map(|n| n * (n + 1) / 2).sum()
}

/// Adds the rotational inertia of every body.
pub(super) fn rotations(alg: &mut Algebra, model: &Model, k: &Kinematics, parts: &mut MassAndForce) {
    let mut found = Terms::default();
    for rigid in shared_axis::bodies(alg, model, k) {
        rotation(alg, k, &Given::default(), &rigid, &mut found);
    }
    parts.add(&mut alg.dag, found);
}

/// The body-by-body form.
fn body_by_body(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    given: &Given,
    bodies: &[RigidInertia],
) -> Terms {
    let mut found = Terms::default();
    for rigid in bodies {
        translation(alg, model, k, given, rigid.body, &mut found);
        rotation(alg, k, given, rigid, &mut found);
    }
    found
}

/// Translation of a body. Weight enters as an acceleration of the inertial frame: m v_k . (a_bias - g).
fn translation(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    given: &Given,
    body: &Body,
    found: &mut Terms,
) {
    let Some(mass) = body.mass.as_ref().map(|m| lower_scalar(alg, k, m)) else { return };
    if alg.dag.is_zero(mass) {
        return;
    }
    let motion = k.velocities[body.centre].clone();
    let mut motion = given.motion(alg, motion);
    if let (true, Some(gravity)) = (body.weight, &model.gravity) {
        let gravity = lower_vector(alg, k, gravity);
        motion.bias = motion.bias.minus(&mut alg.dag, &gravity);
    }
    let products = cheapest_products(alg, k, given, body, &motion);
    for (a, b, product) in products.mass {
        found.mass.push((a, b, alg.dag.mul(mass, product)));
    }
    for (a, product) in products.force {
        let term = alg.dag.mul(mass, product);
        found.force.push((a, alg.dag.negate(term)));
    }
}

/// The products of a motion with every vector kept in the triads where it is short, or with all vectors resolved in the
/// body's triad or in the inertial one; the form with the fewest operations is returned.
fn cheapest_products(
    alg: &mut Algebra,
    k: &Kinematics,
    given: &Given,
    body: &Body,
    motion: &Motion,
) -> Terms {
    let mixed = products(alg, motion);
    let terms = motion.partials.values().chain([&motion.bias]).map(|v| v.terms.len());
    if terms.max().unwrap_or(0) <= 1 {
        return mixed;
    }
    let own = body.frame.map(|f| k.frame_triad[f]);
    let deepest = motion.partials.values().flat_map(|v| v.terms.keys()).max().copied();
    let candidates = [own.or(deepest), Some(TriadId::INERTIAL)];
    let mut best = (mixed.cone_cost(&alg.dag, given), mixed);
    for triad in candidates.into_iter().flatten() {
        let resolved = resolve(alg, motion, triad);
        let products = products(alg, &resolved);
        let cost = products.cone_cost(&alg.dag, given);
        if cost < best.0 {
            best = (cost, products);
        }
    }
    best.1
}

/// v_k . v_l for k <= l, and v_k . bias; zeros left out.
fn products(alg: &mut Algebra, motion: &Motion) -> Terms {
    let partials: Vec<(UnknownId, &Vector)> = motion.partials.iter().map(|(&u, v)| (u, v)).collect();
    let mut found = Terms::default();
    for (i, (a, v)) in partials.iter().enumerate() {
        for (b, w) in &partials[i..] {
            let product = alg.dot(v, w);
            if !alg.dag.is_zero(product) {
                found.mass.push((*a, *b, product));
            }
        }
        let product = alg.dot(v, &motion.bias);
        if !alg.dag.is_zero(product) {
            found.force.push((*a, product));
        }
    }
    found
}

fn resolve(alg: &mut Algebra, motion: &Motion, triad: TriadId) -> Motion {
    let mut in_triad = |v: &Vector| {
        let components = alg.express(v, triad);
        Vector::new(&alg.dag, triad, components)
    };
    Motion {
        partials: motion.partials.iter().map(|(&u, v)| (u, in_triad(v))).collect(),
        bias: in_triad(&motion.bias),
    }
}
