//! Steps that sum over blocks of nodes against the same method computed node by node.

use smartbed_runtime::contact::frozen::Frozen;
use smartbed_runtime::contact::{ContactLaw, ContactState, Ground, System};
use smartbed_runtime::flexible::{Body, Spring};
use smartbed_runtime::ode::nodes::method::{Rk4, Step};
use smartbed_runtime::ode::nodes::{MOTION_ROWS, Motion, Workspace, workspace_len};
use smartbed_runtime::ode::tableau::RK4;
use smartbed_runtime::vec3::{self, Vec3};

/// Nodes of chains: few, which are taken one by one; two blocks, and a part of a third.
const NODES: [usize; 2] = [5, 300];

/// Changes of positions and velocities over a step: k_s = a(x + c_s h v + h^2 sum abar_sj k_j, v + h sum a_sj k_j).
fn node_by_node(
    system: &System<f64>,
    modes: &[ContactState],
    start: &Motion<f64>,
    h: f64,
) -> [Vec<Vec3<f64>>; 2] {
    let n = modes.len();
    let weighted = |stages: &[Vec<Vec3<f64>>], weights: &[f64], i: usize| {
        let used = stages.iter().zip(weights).filter(|(_, weight)| **weight != 0.0);
        used.fold([0.0; 3], |sum, (stage, weight)| vec3::axpy(sum, *weight, stage[i]))
    };
    let accelerate = |force: [&[Vec3<f64>]; 2]| -> Vec<Vec3<f64>> {
        let total = |i: usize| vec3::add(force[0][i], force[1][i]);
        (0..n).map(|i| system.acceleration(i, modes[i], total(i))).collect()
    };
    let mut stages = vec![accelerate([start.elastic, start.viscous])];
    for s in 1..4 {
        let bend = |i| vec3::axpy(start.pos[i], h * RK4.drift[s], start.vel[i]);
        let mut pos: Vec<_> =
            (0..n).map(|i| vec3::axpy(bend(i), h * h, weighted(&stages, &RK4.abar[s], i))).collect();
        let vel: Vec<_> =
            (0..n).map(|i| vec3::axpy(start.vel[i], h, weighted(&stages, &RK4.a[s], i))).collect();
        let [mut elastic, mut viscous] = [(); 2].map(|()| vec![[0.0; 3]; n]);
        system.elastic(&mut pos, &mut elastic).expect("forces");
        system.viscous(&pos, &vel, &mut viscous);
        stages.push(accelerate([&elastic, &viscous]));
    }
    let way =
        |i: usize| if system.body.inverse_mass(i) > 0.0 { vec3::scale(start.vel[i], h) } else { [0.0; 3] };
    let dx = (0..n).map(|i| vec3::axpy(way(i), h * h, weighted(&stages, &RK4.bbar, i))).collect();
    [dx, (0..n).map(|i| vec3::scale(weighted(&stages, &RK4.b, i), h)).collect()]
}

#[test]
fn a_runge_kutta_step_by_blocks_has_the_bits_of_its_equations() {
    NODES.into_iter().for_each(check);
}

/// A chain with dampers, two fixed nodes and a part held on the ground; inverse masses given or computed by division.
fn check(n: usize) {
    let place = |i: usize| [0.1 * i as f64, (0.3 * i as f64).sin(), (0.2 * i as f64).cos()];
    let mass: Vec<f64> = (0..n).map(|i| 0.5 + 0.01 * (i % 7) as f64).collect();
    let fixed: Vec<bool> = (0..n).map(|i| i == 0 || i == n / 2).collect();
    let (stiffness, damping, rest_length) = (40.0, 0.3, 0.4);
    let springs: Vec<Spring<f64>> =
        (1..n).map(|head| Spring { tail: head - 1, head, stiffness, damping, rest_length }).collect();
    let mut modes = vec![ContactState::Free; n];
    modes[n / 3..n / 2].fill(ContactState::Held);
    modes[n - 1] = ContactState::Stuck;
    let plain = Body {
        mass: &mass,
        fixed: &fixed,
        springs: &springs,
        gravity: [0.0, 0.1, -9.81],
        air_drag: 0.05,
        ..Body::none()
    };
    let inverse: Vec<Vec3<f64>> = (0..n).map(|i| [plain.inverse_mass(i); 3]).collect();
    for inverse_mass in [&[][..], &inverse] {
        let body = Body::new(Body { inverse_mass, ..plain }).expect("a body");
        let law = ContactLaw::Newton { restitution: 0.5 };
        let ground = Ground { normal: [0.0, 0.6, 0.8], offset: 0.0, law, friction: 0.0, tolerance: 1e-11 };
        let system = System::new(body, Some(ground));
        let frozen = Frozen { system: &system, modes: &modes };
        let (mut memory, mut scratch) =
            (vec![[0.0; 3]; MOTION_ROWS * n], vec![[0.0; 3]; workspace_len(n, 4)]);
        let (mut start, _) = Motion::cut(&mut memory, n).expect("room");
        for i in 0..n {
            (start.pos[i], start.vel[i]) = (place(i), place(3 * i + 1));
        }
        start.refresh(&frozen).expect("forces");
        let mut work = Workspace::new(&mut scratch, n, 4).expect("room");
        Rk4.step(&frozen, &start, 1e-2, &mut work).expect("a step");
        let [dx, dv] = node_by_node(&system, &modes, &start, 1e-2);
        let bits =
            |rows: &[Vec3<f64>]| -> Vec<u64> { rows.as_flattened().iter().map(|x| x.to_bits()).collect() };
        assert!(dx.iter().flatten().any(|x| *x != 0.0), "it moves");
        assert_eq!([bits(work.dx), bits(work.dv)], [bits(&dx), bits(&dv)]);
    }
}
