//! Generalised inertia forces of one body's turning: w_k . I . w_l and w_k . (I alpha_bias + w x I w), in its own triad.

use super::contributions::Contributions;
use super::given::Given;
use super::rigid_inertia::RigidInertia;
use crate::expr::Dag;
use crate::kinematics::{Kinematics, Motion, UnknownId, value_of};
use crate::vector::{Components, TriadId, cross_components, dot_components};

/// Adds what a body's turning contributes.
pub(super) fn rotation(k: &mut Kinematics, given: &Given, rigid: &RigidInertia, found: &mut Contributions) {
    let Some(frame) = rigid.body.frame else { return };
    let [xx, yy, zz, xy, xz, yz] = rigid.inertia;
    if rigid.inertia.iter().all(|&e| k.dag.is_zero(e)) {
        return;
    }
    let inertia = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let triad = k.frame_triad[frame];
    let angular = k.angular[triad].clone();
    let angular = given.motion(k, angular);
    let partials: Vec<(UnknownId, Components)> =
        angular.partials.iter().map(|(&u, w)| (u, k.triads.express(&mut k.dag, w, triad))).collect();
    let moment = bias_moment(k, triad, &angular, &inertia);
    for (i, (a, w)) in partials.iter().enumerate() {
        let momentum = times(&mut k.dag, &inertia, w);
        for (b, other) in &partials[i..] {
            let term = dot_components(&mut k.dag, &momentum, other);
            if !k.dag.is_zero(term) {
                found.mass.push((*a, *b, term));
            }
        }
        let term = dot_components(&mut k.dag, w, &moment);
        found.force.push((*a, k.dag.negate(term)));
    }
}

/// I alpha_bias + w x I w in the body's triad.
fn bias_moment(
    k: &mut Kinematics,
    triad: TriadId,
    angular: &Motion,
    inertia: &[Components; 3],
) -> Components {
    let alpha = k.triads.express(&mut k.dag, &angular.bias, triad);
    let w = value_of(k, angular);
    let w = k.triads.express(&mut k.dag, &w, triad);
    let linear = times(&mut k.dag, inertia, &alpha);
    let momentum = times(&mut k.dag, inertia, &w);
    let gyroscopic = if is_diagonal(&k.dag, inertia) {
        euler_products(&mut k.dag, inertia, &w)
    } else {
        cross_components(&mut k.dag, &w, &momentum)
    };
    std::array::from_fn(|i| k.dag.add(linear[i], gyroscopic[i]))
}

fn is_diagonal(dag: &Dag, inertia: &[Components; 3]) -> bool {
    (0..3).all(|i| (0..3).all(|j| i == j || dag.is_zero(inertia[i][j])))
}

/// Euler's form for principal axes, (I_l - I_j) w_j w_l: the difference depends on parameters only.
fn euler_products(dag: &mut Dag, inertia: &[Components; 3], w: &Components) -> Components {
    std::array::from_fn(|i| {
        let (j, l) = ((i + 1) % 3, (i + 2) % 3);
        let difference = dag.sub(inertia[l][l], inertia[j][j]);
        let product = dag.mul(w[j], w[l]);
        dag.mul(difference, product)
    })
}

fn times(dag: &mut Dag, matrix: &[Components; 3], v: &Components) -> Components {
    std::array::from_fn(|i| dot_components(dag, &matrix[i], v))
}
