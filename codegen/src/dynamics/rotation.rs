//! Rotational inertia forces of one body, w_k . I . w_l and w_k . (I alpha_bias + w x I w), in its own triad.

use super::given::Given;
use super::mass_and_force::Terms;
use super::rigid_inertia::RigidInertia;
use crate::expr::Dag;
use crate::kinematics::{Kinematics, Motion, UnknownId};
use crate::vector::{Algebra, Components, TriadId, cross_components, dot_components};

/// Adds the contributions of a body's rotation.
pub(super) fn rotation(
    alg: &mut Algebra,
    k: &Kinematics,
    given: &Given,
    rigid: &RigidInertia,
    found: &mut Terms,
) {
    let Some(frame) = rigid.body.frame else { return };
    let [xx, yy, zz, yz, zx, xy] = rigid.inertia;
    if rigid.inertia.iter().all(|&e| alg.dag.is_zero(e)) {
        return;
    }
    let inertia = [[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]];
    let triad = k.frame_triad[frame];
    let angular = k.angular[triad].clone();
    let angular = given.motion(alg, angular);
    let partials: Vec<(UnknownId, Components)> =
        angular.partials.iter().map(|(&u, w)| (u, alg.express(w, triad))).collect();
    let moment = bias_moment(alg, k, triad, &angular, &inertia);
    for (i, (a, w)) in partials.iter().enumerate() {
        let momentum = times(&mut alg.dag, &inertia, w);
        for (b, other) in &partials[i..] {
            let term = dot_components(&mut alg.dag, &momentum, other);
            if !alg.dag.is_zero(term) {
                found.mass.push((*a, *b, term));
            }
        }
        let term = dot_components(&mut alg.dag, w, &moment);
        found.force.push((*a, alg.dag.negate(term)));
    }
}

/// I alpha_bias + w x I w in the body's triad.
fn bias_moment(
    alg: &mut Algebra,
    k: &Kinematics,
    triad: TriadId,
    angular: &Motion,
    inertia: &[Components; 3],
) -> Components {
    let alpha = alg.express(&angular.bias, triad);
    let w = angular.value(alg, k);
    let w = alg.express(&w, triad);
    let linear = times(&mut alg.dag, inertia, &alpha);
    let momentum = times(&mut alg.dag, inertia, &w);
    let gyroscopic = if is_diagonal(&alg.dag, inertia) {
        euler_products(&mut alg.dag, inertia, &w)
    } else {
        cross_components(&mut alg.dag, &w, &momentum)
    };
    std::array::from_fn(|i| alg.dag.add(linear[i], gyroscopic[i]))
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
