//! Rigid shapes on meshes of facets against closed forms: a flat mesh is a half-space, wherever its nodes are.

use crate::scenery::Scene;
use smartbed_runtime::rigid::law::Kind;
use smartbed_runtime::vec3::Vec3;
use smartbed_runtime::world::Thing;

const G: f64 = 9.81;

/// Ways through time: steps without location, energy-momentum steps, located touches by each law.
#[derive(Clone, Copy, Debug)]
enum Way {
    Moreau,
    Conserving,
    Located(Kind),
}

const WAYS: [Way; 5] = [
    Way::Moreau,
    Way::Conserving,
    Way::Located(Kind::Stronge),
    Way::Located(Kind::Newton),
    Way::Located(Kind::Compensation),
];

impl Way {
    /// Runs; the end, the energy that is in no account, the energy that contacts took.
    fn run(self, scene: &mut Scene, h: f64, steps: u32) -> (Vec<f64>, f64, f64) {
        let (x, imbalance, accounts) = match self {
            Way::Moreau => scene.run(h, steps, |report, _, _| assert!(report.settled)),
            Way::Conserving => scene.run_conserving((h, steps), |report, _, _| assert!(report.settled)),
            Way::Located(kind) => scene.run_located(kind, (h, steps), |report, _, _| {
                assert!(!report.forced && report.settled);
            }),
        };
        (x, imbalance, accounts.impact + accounts.friction)
    }
}

/// A held mesh of `n` by `m` facets of this edge, from a corner on, at a height; its number as a thing.
fn mesh(
    scene: &mut Scene,
    [n, m]: [usize; 2],
    cell: f64,
    corner: [f64; 2],
    height: impl Fn(usize, usize) -> f64,
) -> usize {
    let (first, facet) = (scene.pos.len(), scene.facets.len());
    for (j, i) in (0..=m).flat_map(|j| (0..=n).map(move |i| (j, i))) {
        let place = [corner[0] + cell * i as f64, corner[1] + cell * j as f64, height(i, j)];
        scene.node(1.0, true, place, [0.0; 3]);
    }
    let at = |i: usize, j: usize| first + j * (n + 1) + i;
    for (j, i) in (0..m).flat_map(|j| (0..n).map(move |i| (j, i))) {
        scene.facets.push([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
    let (nodes, facets) = ([first, scene.pos.len()], [facet, scene.facets.len()]);
    scene.thing(Thing::Mesh { nodes, facets, depth: 0.3 * cell })
}

/// What a ball of 1 kg does in 0.5 s on a mesh.
fn ball_on(
    way: Way,
    radius: f64,
    position: Vec3<f64>,
    floor: impl Fn(&mut Scene) -> usize,
) -> (Vec<f64>, f64) {
    let mut scene = Scene::falling();
    let floor = floor(&mut scene);
    let ball = scene.ball(1.0, radius, position, [0.0; 3]);
    scene.pair(ball, floor, 0.0, 0.0);
    let (x, imbalance, _) = way.run(&mut scene, 1e-3, 500);
    (x, imbalance)
}

#[test]
fn a_ball_rests_on_a_facet_wherever_it_falls() {
    // In the middle, on an edge, near a node, on it, beside it by a rounding error.
    for place in [[0.5, 0.5], [0.5, 0.0], [0.1, 0.1], [0.003, 0.002], [1e-9, 0.0], [0.0, 1e-15], [0.0, 0.0]] {
        for way in WAYS {
            let floor = |scene: &mut Scene| mesh(scene, [2, 2], 1.0, [-1.0, -1.0], |_, _| 0.0);
            let (x, imbalance) = ball_on(way, 0.02, [place[0], place[1], 0.03], floor);
            let sunk = 0.02 - x[2];
            println!(
                "{way:?} {place:?}: sunk by {sunk:e}, moved {:e}, ledger {imbalance:e}",
                x[0] - place[0]
            );
            // Without located touches the fall ends within a step of its last.
            let within = if matches!(way, Way::Located(_)) { 1e-11 } else { 2.0 * G * 1e-6 };
            assert!(sunk.abs() < within && (x[0] - place[0]).abs() < 1e-9 && imbalance.abs() < 1e-9);
            assert!(x[7..10].iter().all(|v| v.abs() < 1e-9), "{:?}", &x[7..]);
        }
    }
}

/// A ball that rolls for 1.5 s: its place, velocity, speed of its surface; what contacts took, and what is in no
/// account.
fn rolled(way: Way, y: f64, floor: impl Fn(&mut Scene) -> usize) -> ([f64; 6], [f64; 2]) {
    let (radius, speed) = (0.1, 0.5);
    let friction = if matches!(way, Way::Located(Kind::Newton)) { 0.0 } else { 0.5 };
    let mut scene = Scene::falling();
    let floor = floor(&mut scene);
    let ball = scene.ball(1.0, radius, [0.0, y, radius], [speed, 0.0, 0.0]);
    scene.u[4] = 0.4 * radius * speed;
    scene.pair(ball, floor, friction, 0.0);
    let (x, imbalance, lost) = way.run(&mut scene, 1e-3, 1500);
    ([x[0], x[1], x[2], x[7], x[8], x[11] / (0.4 * radius)], [lost, imbalance])
}

#[test]
fn a_ball_rolls_on_facets_as_on_a_half_space() {
    for (cell, y) in [(0.1, 0.0), (0.1, 0.013), (0.1, 0.03), (0.05, 0.01), (0.2, 0.03)] {
        for way in WAYS {
            let n = (1.2_f64 / cell).round() as usize;
            let facets =
                |scene: &mut Scene| mesh(scene, [n, 6], cell, [-2.0 * cell, -3.0 * cell], |_, _| 0.0);
            let (found, [lost, imbalance]) = rolled(way, y, facets);
            let closed = match way {
                // Its error of order 2 is that on a half-space.
                Way::Conserving => rolled(way, y, Scene::floor),
                _ => ([0.75, y, 0.1, 0.5, 0.0, 0.5], [0.0; 2]),
            };
            let off = found.iter().zip(closed.0).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
            println!("{way:?} cell {cell} y {y}: off by {off:e}, lost {lost:e}, ledger {imbalance:e}");
            assert!(off < 1e-9, "{way:?} {cell} {y}: {found:?}");
            assert!((lost - closed.1[0]).abs() < 1e-9 && imbalance.abs() < 1e-9, "{lost:e} {imbalance:e}");
        }
    }
}

#[test]
fn a_box_rests_on_a_facet_wider_or_narrower_than_itself() {
    // Its corners are near the facet's, on them, beyond them.
    for edge in [0.2, 0.34, 0.39, 0.4, 0.41, 0.5] {
        for way in WAYS {
            let mut scene = Scene::falling();
            let floor = mesh(&mut scene, [1, 1], 0.4, [-0.2, -0.2], |_, _| 0.0);
            let half = [0.5 * edge, 0.5 * edge, 0.05];
            let block = scene.cuboid(2.0, half, [0.0, 0.0, 0.051], [0.0; 3]);
            scene.pair(block, floor, 0.0, 0.0);
            let (x, imbalance, _) = way.run(&mut scene, 1e-3, 300);
            println!("{way:?} edge {edge}: sunk by {:e}, ledger {imbalance:e}", 0.05 - x[2]);
            let within = if matches!(way, Way::Located(_)) { 1e-10 } else { 2.0 * G * 1e-6 };
            assert!((x[2] - 0.05).abs() < within && imbalance.abs() < 1e-9, "{way:?} {edge}: {}", x[2]);
            assert!((x[3] - 1.0).abs() < 1e-12, "level");
        }
    }
}

#[test]
fn a_box_slides_over_nodes_without_friction_as_on_a_half_space() {
    let (speed, h, steps) = (0.5, 1e-3, 600);
    for (n, cell, size, y, level) in [
        (2, 1.0, 0.4, 0.01, 0.0),
        (16, 0.1, 0.125, 0.013, 0.0),
        (16, 0.1, 0.125, 0.0, 0.0),
        (16, 0.1, 0.125, 0.013, 2e-3),
    ] {
        // Fallen boxes in steps without location only: an impact at many redundant points leaves some spin.
        for way in WAYS.into_iter().filter(|way| level == 0.0 || !matches!(way, Way::Located(_))) {
            let mut scene = Scene::falling();
            let floor =
                mesh(&mut scene, [n, n], cell, [-0.5 * cell * n as f64, -0.5 * cell * n as f64], |_, _| 0.0);
            let block = scene.cuboid(1.0, [size, size, 0.1], [-0.5, y, 0.1 + level], [speed, 0.0, 0.0]);
            scene.pair(block, floor, 0.0, 0.0);
            let (x, imbalance, _) = way.run(&mut scene, h, steps);
            let off = [x[0] + 0.5 - speed * 0.6, x[1] - y, x[7] - speed, x[8], x[10], x[11], x[12]];
            println!("{way:?} cell {cell} y {y}: off by {off:?}, z {:e}, ledger {imbalance:e}", x[2] - 0.1);
            assert!(off.iter().all(|off| off.abs() < 1e-9), "{way:?} {cell} {y}: {off:?}");
            assert!((x[2] - 0.1).abs() < 2.0 * G * h * h && imbalance.abs() < 1e-9, "{imbalance:e}");
        }
    }
}

#[test]
fn a_ball_in_a_pit_of_facets_stays_there() {
    // Four facets, their common node 0.1 m deep. Located touches do not book what sliding into a fold takes.
    for way in WAYS {
        let mut scene = Scene::falling();
        let depth = |i, j| if (i, j) == (1, 1) { 0.1 } else { 0.2 };
        let pit = mesh(&mut scene, [2, 2], 0.2, [-0.2, -0.2], depth);
        let ball = scene.ball(0.5, 0.02, [0.1, 0.0, 0.19], [0.0; 3]);
        scene.pair(ball, pit, 0.0, 0.0);
        let (x, imbalance, _) = way.run(&mut scene, 1e-3, 600);
        println!("{way:?}: at {:?}, speeds {:?}, ledger {imbalance:e}", &x[..3], &x[7..10]);
        assert!(x[2] > 0.115 && x[0].abs() < 0.15 && x[1].abs() < 1e-9, "{way:?}: {:?}", &x[..3]);
        assert!(matches!(way, Way::Located(_)) || imbalance.abs() < 1e-9, "{imbalance:e}");
    }
}

#[test]
fn a_box_stops_at_a_wall_of_facets() {
    // Floor and wall share the nodes of an edge, which lie flush with the box's lower edge all the way.
    for way in [Way::Moreau, Way::Conserving] {
        let mut scene = Scene::falling();
        let rows = [[-1.0, 0.0], [0.0, 0.0], [0.0, 1.0]];
        for [x, z] in rows {
            for y in [-1.0, 0.0, 1.0] {
                scene.node(1.0, true, [x, y, z], [0.0; 3]);
            }
        }
        for k in [0, 1, 3, 4] {
            scene.facets.push([k, k + 3, k + 4, k + 1]);
        }
        let floor = scene.thing(Thing::Mesh { nodes: [0, 9], facets: [0, 4], depth: 0.1 });
        let block = scene.cuboid(1.0, [0.1, 0.1, 0.1], [-0.3, 0.02, 0.1], [0.5, 0.0, 0.0]);
        scene.pair(block, floor, 0.0, 0.0);
        let (x, imbalance, lost) = way.run(&mut scene, 1e-3, 600);
        println!("{way:?}: {:?} lost {lost}, ledger {imbalance:e}", &x[..10]);
        assert!(
            (x[0] + 0.1).abs() < 1e-3 && x[7].abs() < 1e-9 && (x[2] - 0.1).abs() < 1e-6,
            "{:?}",
            &x[..10]
        );
        assert!((lost - 0.125).abs() < 1e-6 && imbalance.abs() < 1e-9, "{lost}");
    }
}
