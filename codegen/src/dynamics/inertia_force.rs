//! Generalised inertia forces F*_r.
//!
//! M_kl = sum m v_k . v_l + w_k . I . w_l over all bodies; the bias is
//! h_k = sum m v_k . a_bias + w_k . (I alpha_bias + w x I w). Sign: h stands beside M y', as in Kane.
//! Bodies that hang on one another may instead be taken as a tree of composite bodies: whichever
//! takes fewer operations.

use super::composite;
use super::contributions::Contributions;
use super::given::Given;
use super::rigid_inertia::RigidInertia;
use super::rotation::rotation;
use super::unprojected::Unprojected;
use super::{shared_axis, tree};
use crate::expr::ExprId;
use crate::kinematics::{Kinematics, Motion, UnknownId, lower_scalar, lower_vector};
use crate::model::{Body, Model};
use crate::vector::{TriadId, Vector};

/// A tree whose bodies, each for itself, take more scalar products than this is taken as composite bodies at once:
/// that of a chain of fifteen hinges.
const LONG: usize = 680;

/// Adds every body's inertia; with given accelerations the forces are all of it, and masses have no meaning.
pub(super) fn accumulate(model: &Model, k: &mut Kinematics, given: &Given, parts: &mut Unprojected) {
    // A tree weighs all that it carries: a body without weight stands alone.
    let bodies = shared_axis::bodies(model, k);
    let (hanging, alone): (Vec<RigidInertia>, Vec<RigidInertia>) =
        bodies.into_iter().partition(|m| m.body.weight);
    let mut all = body_by_body(model, k, given, &alone);
    let forest = tree::build(model, k, &hanging);
    for (root, bodies) in forest.roots() {
        let bodies: Vec<RigidInertia> = bodies.into_iter().map(|i| hanging[i].clone()).collect();
        // Of a long tree every body for itself takes products of all pairs of joints below it: never the cheaper way.
        let is_long = forest.has_joints(root) && n_products(k, &bodies) > LONG;
        let mut best = (!is_long).then(|| body_by_body(model, k, given, &bodies));
        if forest.has_joints(root) {
            let cut = tree::cut(k, &forest.nodes, root);
            let candidate = composite::contributions(model, k, given, &forest.nodes, cut);
            if best.as_ref().is_none_or(|best| candidate.cost(&k.dag, given) < best.cost(&k.dag, given)) {
                best = Some(candidate);
            }
        }
        let best = best.unwrap_or_default();
        all.mass.extend(best.mass);
        all.force.extend(best.force);
    }
    all.join(&mut k.dag, parts);
}

/// How many scalar products the translations of the bodies, each for itself, take.
fn n_products(k: &Kinematics, bodies: &[RigidInertia]) -> usize {
    let moving = bodies.iter().map(|rigid| k.velocities[rigid.body.centre].partials.len());
    moving.map(|n| n * (n + 1) / 2).sum()
}

/// Adds every body's moment of inertia only.
pub(super) fn rotations(model: &Model, k: &mut Kinematics, parts: &mut Unprojected) {
    let mut found = Contributions::default();
    for rigid in shared_axis::bodies(model, k) {
        rotation(k, &Given::default(), &rigid, &mut found);
    }
    found.join(&mut k.dag, parts);
}

/// Every body for itself.
fn body_by_body(model: &Model, k: &mut Kinematics, given: &Given, bodies: &[RigidInertia]) -> Contributions {
    let mut found = Contributions::default();
    for rigid in bodies {
        translation(model, k, given, rigid.body, &mut found);
        rotation(k, given, rigid, &mut found);
    }
    found
}

/// Weight enters as an acceleration of the inertial frame: m v_k . (a_bias - g).
fn translation(model: &Model, k: &mut Kinematics, given: &Given, body: &Body, found: &mut Contributions) {
    let Some(mass) = body.mass.as_ref().map(|m| lower_scalar(k, m)) else { return };
    if k.dag.is_zero(mass) {
        return;
    }
    let motion = k.velocities[body.centre].clone();
    let mut motion = given.motion(k, motion);
    if let (true, Some(gravity)) = (body.weight, &model.gravity) {
        let gravity = lower_vector(k, gravity);
        motion.bias = motion.bias.minus(&mut k.dag, &gravity);
    }
    let products = cheapest_products(k, given, body, &motion);
    for (a, b, product) in products.mass {
        found.mass.push((a, b, k.dag.mul(mass, product)));
    }
    for (a, product) in products.force {
        let term = k.dag.mul(mass, product);
        found.force.push((a, k.dag.negate(term)));
    }
}

/// v_k . v_l for k <= l, and v_k . bias; zeros left out.
struct Products {
    mass: Vec<(UnknownId, UnknownId, ExprId)>,
    force: Vec<(UnknownId, ExprId)>,
}

/// The products of a motion with every vector kept in the triads where it is short, or all of them
/// resolved in the body's triad, or in the inertial one: whichever takes fewest operations.
fn cheapest_products(k: &mut Kinematics, given: &Given, body: &Body, motion: &Motion) -> Products {
    let mixed = products(k, motion);
    let terms = motion.partials.values().chain([&motion.bias]).map(|v| v.terms.len());
    if terms.max().unwrap_or(0) <= 1 {
        return mixed;
    }
    let own = body.frame.map(|f| k.frame_triad[f]);
    let deepest = motion.partials.values().flat_map(|v| v.terms.keys()).max().copied();
    let candidates = [own.or(deepest), Some(TriadId::INERTIAL)];
    let mut best = (cost(k, given, &mixed), mixed);
    for triad in candidates.into_iter().flatten() {
        let resolved = resolve(k, motion, triad);
        let products = products(k, &resolved);
        let cost = cost(k, given, &products);
        if cost < best.0 {
            best = (cost, products);
        }
    }
    best.1
}

fn products(k: &mut Kinematics, motion: &Motion) -> Products {
    let partials: Vec<(UnknownId, &Vector)> = motion.partials.iter().map(|(&u, v)| (u, v)).collect();
    let mut found = Products { mass: Vec::new(), force: Vec::new() };
    for (i, (a, v)) in partials.iter().enumerate() {
        for (b, w) in &partials[i..] {
            let product = k.triads.dot(&mut k.dag, v, w);
            if !k.dag.is_zero(product) {
                found.mass.push((*a, *b, product));
            }
        }
        let product = k.triads.dot(&mut k.dag, v, &motion.bias);
        if !k.dag.is_zero(product) {
            found.force.push((*a, product));
        }
    }
    found
}

fn resolve(k: &mut Kinematics, motion: &Motion, triad: TriadId) -> Motion {
    let mut in_triad = |v: &Vector| {
        let components = k.triads.express(&mut k.dag, v, triad);
        Vector::new(&k.dag, triad, components)
    };
    Motion {
        partials: motion.partials.iter().map(|(&u, v)| (u, in_triad(v))).collect(),
        bias: in_triad(&motion.bias),
    }
}

/// Operations of the products that count: of the forces alone where accelerations are given.
fn cost(k: &Kinematics, given: &Given, products: &Products) -> usize {
    let mass = products.mass.iter().filter(|_| !given.is_given()).map(|(_, _, e)| *e);
    let roots: Vec<_> = mass.chain(products.force.iter().map(|(_, e)| *e)).collect();
    k.dag.cone_cost(&roots)
}
