//! Meshes as bodies: moments against closed forms, the distance field against exact distances, a ball of triangles on
//! the bed against an exact ball, refusals.

use smartbed_bed::body::mesh::{Mesh, MeshFault, Solid};
use smartbed_bed::body::{Body, Segment, Shape, Surface};
use smartbed_bed::dynamics::{Matter, Method, Motion, dropped};
use smartbed_bed::equilibrium::{Bed, Cover, Solution, Tile, put_down, stiffness};
use smartbed_bed::pose::Pose;
use smartbed_bed::sheet::Lattice;
use smartbed_bed::sheet::air::Air;
use smartbed_runtime::vec3::{Vec3, dot, norm, scale, sub};
use std::collections::BTreeMap;
use std::sync::Arc;

/// A ball of triangles: an icosahedron, each face in four so often; corners lie on the ball.
pub fn ball(radius: f64, halvings: usize) -> Mesh {
    let g = 0.5 * (1.0 + 5.0_f64.sqrt());
    let mut corners: Vec<Vec3<f64>> = Vec::new();
    for (a, b) in [(1.0, g), (-1.0, g), (1.0, -g), (-1.0, -g)] {
        corners.extend([[0.0, a, b], [a, b, 0.0], [b, 0.0, a]]);
    }
    let near = |a: usize, b: usize| norm(sub(corners[a], corners[b])) < 2.1;
    let mut triangles = Vec::new();
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if near(a, b) && near(b, c) && near(a, c) {
                    let out = smartbed_runtime::vec3::cross(
                        sub(corners[b], corners[a]),
                        sub(corners[c], corners[a]),
                    );
                    triangles.push(if dot(out, corners[a]) > 0.0 { [a, b, c] } else { [a, c, b] });
                }
            }
        }
    }
    for _ in 0..halvings {
        let mut middles: BTreeMap<[usize; 2], usize> = BTreeMap::new();
        let mut finer = Vec::new();
        for [a, b, c] in triangles {
            let [ab, bc, ca] = [[a, b], [b, c], [c, a]].map(|[p, q]| {
                *middles.entry([p.min(q), p.max(q)]).or_insert_with(|| {
                    corners.push([0, 1, 2].map(|k| 0.5 * (corners[p][k] + corners[q][k])));
                    corners.len() - 1
                })
            });
            finer.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
        }
        triangles = finer;
        corners.iter_mut().for_each(|c| *c = scale(*c, 1.0 / norm(*c)));
    }
    let corners = corners.into_iter().map(|c| scale(c, radius / norm(c))).collect();
    Mesh { corners, triangles }
}

/// A box of twelve triangles about a middle.
fn cuboid(half: Vec3<f64>, middle: Vec3<f64>) -> Mesh {
    let corner = |n: usize| [0, 1, 2].map(|k| middle[k] + if n >> k & 1 == 1 { half[k] } else { -half[k] });
    let quads = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    let triangles = quads.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).collect();
    Mesh { corners: (0..8).map(corner).collect(), triangles }
}

/// A torus about z of so many corners around either circle.
fn torus(large: f64, small: f64, around: [usize; 2]) -> Mesh {
    let [m, n] = around;
    let corner = |k: usize| {
        let turn = |i: usize, of: usize| (i as f64 / of as f64 * std::f64::consts::TAU).sin_cos();
        let ((s, c), (v, u)) = (turn(k / n, m), turn(k % n, n));
        let out = large + small * u;
        [out * c, out * s, small * v]
    };
    let at = |i: usize, j: usize| (i % m) * n + j % n;
    let cell = |k: usize| {
        let (i, j) = (k / n, k % n);
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        [[a, b, c], [a, c, d]]
    };
    Mesh { corners: (0..m * n).map(corner).collect(), triangles: (0..m * n).flat_map(cell).collect() }
}

/// Numbers from 0 to 1 that look random.
fn random(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
    (*state >> 11) as f64 / (1_u64 << 53) as f64
}

#[test]
fn moments_of_a_box_a_ball_and_a_torus_are_those_of_closed_forms() {
    // A box far from its file's origin, turned in it: exact but for rounding.
    let half = [0.2, 0.1, 0.05];
    let turned = Pose::turned([0.7, -0.4, 1.1], scale([1.0, 2.0, -1.0], 1.0 / 6.0_f64.sqrt()), 0.3);
    let mut mesh = cuboid(half, [0.0; 3]);
    mesh.corners.iter_mut().for_each(|c| *c = turned.outwards(*c));
    let (solid, pose) = Solid::new(mesh).unwrap();
    assert!((solid.volume() - 0.008).abs() < 1e-15, "{}", solid.volume());
    assert!(norm(sub(pose.place, turned.place)) < 1e-14);
    for (found, half) in solid.gyration().into_iter().zip(half) {
        // <x^2> of a box is h^2/3.
        assert!((found - half).abs() < 1e-12, "{found} {half}");
    }
    for axis in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
        let [found, made] = [&pose, &turned].map(|p| p.attitude.to_inertial(axis));
        assert!((dot(found, made).abs() - 1.0).abs() < 1e-12, "{found:?} {made:?}");
    }
    // A ball and a torus of triangles come near with the square of their sides.
    let pi = std::f64::consts::PI;
    let errors = |mesh: Mesh, volume: f64, squares: Vec3<f64>| {
        let (solid, _) = Solid::new(mesh).unwrap();
        let gyration = solid.gyration();
        let one = |k: usize| (gyration[k] * gyration[k] / 3.0 / squares[k] - 1.0).abs();
        [(solid.volume() / volume - 1.0).abs(), (0..3).map(one).fold(0.0, f64::max)]
    };
    let of_ball = |halvings| errors(ball(0.1, halvings), 4.0 / 3.0 * pi * 1e-3, [0.2 * 0.01; 3]);
    let (large, small) = (0.2, 0.06);
    // <x^2> = R^2/2 + 3 r^2/8, <z^2> = r^2/4.
    let across = 0.5 * large * large + 0.375 * small * small;
    let squares = [across, across, 0.25 * small * small];
    let of_torus =
        |n| errors(torus(large, small, [2 * n, n]), 2.0 * pi * pi * large * small * small, squares);
    for [coarse, fine] in [[of_ball(3), of_ball(4)], [of_torus(24), of_torus(48)]] {
        for (coarse, fine) in coarse.into_iter().zip(fine) {
            assert!(fine < 5e-3 && (3.8..4.2).contains(&(coarse / fine)), "{coarse} {fine}");
        }
    }
}

#[test]
fn the_exact_distance_of_a_box_is_that_of_its_formula() {
    let half = [0.2, 0.1, 0.05];
    let (solid, pose) = Solid::new(cuboid(half, [0.3, 0.0, 0.0])).unwrap();
    let (shape, mut state) = (Shape { half, radius: 0.0 }, 7);
    for _ in 0..4000 {
        let point = [0, 1, 2].map(|k| 2.0 * half[k] * (2.0 * random(&mut state) - 1.0));
        let (found, truth) = (solid.distance(pose.inwards(pose.outwards(point))), shape.gap(point).0);
        assert!((found - truth).abs() < 1e-14, "{point:?}: {found} {truth}");
    }
}

#[test]
fn the_field_is_the_distance_but_for_rounded_edges_and_its_derivatives_are_its_own() {
    let mut state = 3;
    // Of a fine torus: as near to the closed form as its triangles are, by the sags of both circles.
    let (large, small) = (0.2, 0.06);
    let (solid, _) = Solid::new(torus(large, small, [192, 96])).unwrap();
    let (mut worst, mut steep) = (0.0_f64, 0.0_f64);
    for _ in 0..2000 {
        let turn = [0, 1].map(|_| (std::f64::consts::TAU * random(&mut state)).sin_cos());
        let deep = small + 0.01 * (2.0 * random(&mut state) - 1.0);
        let [(s, c), (v, u)] = turn;
        let point = [(large + deep * u) * c, (large + deep * u) * s, deep * v];
        let near = solid.field().near(point).unwrap();
        worst = worst.max((near.distance - (deep - small)).abs());
        steep = steep.max(norm(sub(near.gradient, [u * c, u * s, v])));
    }
    let sag = |radius: f64, count: f64| radius * (1.0 - (std::f64::consts::PI / count).cos());
    let sags = sag(large + small, 192.0) + sag(small, 96.0);
    assert!(worst < sags + 1e-6 && steep < 0.03, "{worst} {steep}");
    // Of a box: exact away from edges by two cells, and off by a fifth of a cell at most where faces meet.
    let half = [0.2, 0.15, 0.05];
    let (solid, _) = Solid::new(cuboid(half, [0.0; 3])).unwrap();
    let (shape, cell) = (Shape { half, radius: 0.0 }, solid.field().cell());
    let (mut flat, mut edge) = (0.0_f64, 0.0_f64);
    for _ in 0..20_000 {
        let mut point = [0, 1, 2].map(|k| half[k] * (2.0 * random(&mut state) - 1.0));
        point[2] = half[2] + cell * (2.0 * random(&mut state) - 1.0);
        let error = (solid.field().near(point).unwrap().distance - shape.gap(point).0).abs() / cell;
        let is_flat = (0..2).all(|k| point[k].abs() < half[k] - 6.0 * cell);
        if is_flat { flat = flat.max(error) } else { edge = edge.max(error) }
    }
    assert!(flat < 1e-3 && edge < 0.2, "{flat} {edge}");
    // Derivatives against differences, anywhere.
    for _ in 0..300 {
        let point = [0, 1, 2].map(|k| half[k] * (2.0 * random(&mut state) - 1.0));
        let near = solid.field().near(point).unwrap();
        let step = 1e-3 * cell;
        for k in 0..3 {
            let ends = [step, -step].map(|way| {
                let mut moved = point;
                moved[k] += way;
                solid.field().near(moved).unwrap()
            });
            let slope = (ends[0].distance - ends[1].distance) / (2.0 * step);
            assert!((slope - near.gradient[k]).abs() < 1e-5, "{slope} {:?}", near.gradient);
            for n in 0..3 {
                let bend = (ends[0].gradient[n] - ends[1].gradient[n]) / (2.0 * step);
                assert!((bend - near.hessian[k][n]).abs() < 2e-3 / cell, "{bend} {:?}", near.hessian);
            }
        }
    }
}

/// Four tiles with a gap of 6 mm under a body of one segment.
fn four(friction: f64) -> Bed {
    let lattice = Lattice::new([10, 12], [0.219, 0.2797], 5000.0).unwrap();
    let at = |x: f64, y: f64| Tile { pose: Pose::at([x, y, 0.0]), air: Air::Regulated(4000.0) };
    let tiles = vec![at(-0.1125, 0.14285), at(0.1125, 0.14285), at(-0.1125, -0.14285), at(0.1125, -0.14285)];
    Bed { lattice, depth: 0.1, tiles, friction, rubbing: 0.0, beside: Vec::new(), cover: Cover::default() }
}

fn single(shape: Surface) -> Body {
    let name = "ball".to_owned();
    Body::single(Segment { name, shape, mass: 12.0, centre: [0.0; 3], foundation: 1e6, free: [true; 6] })
}

/// Of an equilibrium: height of the middle (m), largest pressure (Pa).
fn read(solution: &Solution) -> [f64; 2] {
    let peak = solution.contacts.iter().flatten().map(|c| c.pressure()).fold(0.0, f64::max);
    [solution.state.segments[0].place[2], peak]
}

#[test]
fn a_ball_of_triangles_rests_as_the_ball_does_the_finer_the_nearer() {
    let radius = 0.15;
    let rest = |shape: Surface| {
        let (bed, body) = (four(0.4), single(shape));
        let found = put_down(&bed, &body, &bed.start(vec![Pose::at([0.0, 0.0, 0.19])])).unwrap();
        assert!(found.imbalance < 1e-6, "{}", found.imbalance);
        read(&found)
    };
    let truth = rest(Shape::ball(radius).into());
    let errors = [2, 3, 4].map(|halvings| {
        let (solid, _) = Solid::new(ball(radius, halvings)).unwrap();
        let found = rest(Surface::Mesh(Arc::new(solid)));
        [(found[0] - truth[0]).abs(), (found[1] / truth[1] - 1.0).abs()]
    });
    // The middle of a face lies this far inside the ball; one smaller by that sinks by more, as it is held by slopes.
    let sags = [2, 3, 4].map(|n: i32| radius * (1.0 - (37.377_f64.to_radians() / 2.0_f64.powi(n)).cos()));
    for (error, sag) in errors.iter().zip(sags) {
        assert!(error[0] < 1.5 * sag, "{errors:?} {sags:?}");
    }
    assert!(errors.windows(2).all(|pair| pair[0][0] > 3.0 * pair[1][0]), "{errors:?}");
    assert!(errors[2][1] < 0.005 && errors[2][1] < 0.1 * errors[0][1], "{errors:?}");
}

#[test]
fn a_mesh_falls_and_comes_to_rest_as_the_box_with_round_edges_does() {
    let slab = |shape: Surface| {
        let (bed, body) = (four(0.4), single(shape));
        let start = dropped(&bed, &body, &[Pose::at([0.0, 0.0, 0.3])], 0.01).unwrap();
        let still = bed.clone();
        let mut motion = Motion::new(bed, body, start, Matter::default(), Method::Bdf2, 4e-3);
        for _ in 0..60 {
            motion.step(|_| still.clone()).unwrap();
            assert!(motion.now.imbalance < 1e-6, "{}", motion.now.imbalance);
        }
        (motion.now.state.segments[0].place[2], motion.ledger.left_over().abs())
    };
    let (solid, _) = Solid::new(ball(0.15, 4)).unwrap();
    let [(found, left), (truth, _)] = [Surface::Mesh(Arc::new(solid)), Shape::ball(0.15).into()].map(slab);
    assert!((found - truth).abs() < 2e-4 && left < 0.05, "{found} {truth} {left}");
}

#[test]
fn stiffness_under_a_mesh_is_the_difference_of_its_forces() {
    // Held at two heights: the force changes by what the exact stiffness says.
    let (solid, _) = Solid::new(ball(0.15, 3)).unwrap();
    let mut body = single(Surface::Mesh(Arc::new(solid)));
    body.segments[0].free = [false; 6];
    let bed = four(0.0);
    let at = |height: f64| {
        let found = put_down(&bed, &body, &bed.start(vec![Pose::at([0.01, 0.0, height])])).unwrap();
        stiffness(&bed, &body, &found.state, 0).unwrap()
    };
    let ([low, high], (_, matrix)) = ([0.1399995, 0.1400005].map(|z| at(z).0[2]), at(0.14));
    let slope = (high - low) / 1e-6;
    assert!((slope + matrix[2][2]).abs() < 1e-3 * slope.abs(), "{slope} {matrix:?}");
}

#[test]
fn what_is_no_solid_is_refused_by_name() {
    let whole = cuboid([0.1; 3], [0.0; 3]);
    let fault = |change: &dyn Fn(&mut Mesh)| {
        let mut mesh = whole.clone();
        change(&mut mesh);
        Solid::new(mesh).map(|_| ()).unwrap_err()
    };
    assert_eq!(fault(&|m| m.triangles.clear()), MeshFault::Empty);
    assert!(matches!(fault(&|m| m.triangles.truncate(11)), MeshFault::Open(3, _)));
    assert_eq!(fault(&|m| m.corners[3][1] = f64::NAN), MeshFault::NotFinite(4));
    assert_eq!(fault(&|m| m.triangles[2][0] = 99), MeshFault::NoCorner(3));
    assert!(matches!(fault(&|m| m.triangles[4].swap(0, 1)), MeshFault::Turned(_)));
    assert!(
        matches!(fault(&|m| m.corners.iter_mut().for_each(|c| *c = scale(*c, 1e3))), MeshFault::Size(x) if x == 200.0)
    );
    let third = |m: &mut Mesh| {
        m.corners.push([0.0, 0.0, 0.3]);
        m.triangles.extend([[0, 1, 8], [1, 3, 8], [3, 0, 8]]);
    };
    assert!(matches!(fault(&third), MeshFault::NotManifold(..) | MeshFault::Turned(_)));
    // Two boxes that share one corner.
    let touching = |m: &mut Mesh| {
        let other = cuboid([0.1; 3], [0.2; 3]);
        let number = |c: usize| if c == 0 { 7 } else { 7 + c };
        m.corners.extend(&other.corners[1..]);
        m.triangles.extend(other.triangles.iter().map(|t| t.map(number)));
    };
    assert!(matches!(fault(&touching), MeshFault::Pinched(_)));
    let flat = |m: &mut Mesh| m.corners[1] = m.corners[0];
    assert!(matches!(fault(&flat), MeshFault::Flat(_)));
    let many = |m: &mut Mesh| m.triangles = vec![[0, 1, 2]; 200_001];
    assert_eq!(fault(&many), MeshFault::TooMany(200_001));
    // Seen from inside it is turned round, and corners that stand in the list twice are welded.
    let mut inside = whole.clone();
    inside.triangles.iter_mut().for_each(|t| t.swap(0, 1));
    assert!((Solid::new(inside).unwrap().0.volume() - 0.008).abs() < 1e-15);
    let welded = Mesh::welded((0..12).flat_map(|t| whole.places(t)));
    assert_eq!((welded.corners.len(), welded.triangles.len()), (8, 12));
    assert!(Solid::new(welded).is_ok());
}

/// Two surfaces as one mesh.
fn both(one: &Mesh, other: &Mesh) -> Mesh {
    let mut mesh = one.clone();
    let from = mesh.corners.len();
    mesh.corners.extend(&other.corners);
    mesh.triangles.extend(other.triangles.iter().map(|t| t.map(|c| from + c)));
    mesh
}

/// The same seen from inside.
fn turned(mut mesh: Mesh) -> Mesh {
    mesh.triangles.iter_mut().for_each(|t| t.swap(0, 1));
    mesh
}

#[test]
fn a_surface_that_runs_through_itself_is_refused_with_the_place() {
    let fault = |mesh: Mesh| Solid::new(mesh).map(|_| ()).expect_err("refused");
    let is_crossed = |mesh: Mesh| matches!(fault(mesh), MeshFault::Crossed(_));
    let whole = cuboid([0.1; 3], [0.0; 3]);
    // A bar through a box; boxes with sides in common planes; the same box twice; one that stands on another.
    assert!(is_crossed(both(&whole, &cuboid([0.2, 0.05, 0.05], [0.0; 3]))));
    assert!(is_crossed(both(&whole, &cuboid([0.1; 3], [0.1, 0.0, 0.0]))));
    assert!(is_crossed(both(&whole, &whole)));
    assert!(is_crossed(both(&whole, &cuboid([0.05; 3], [0.0, 0.0, 0.15]))));
    // A box that has corners in the other's top, half of it below: no edge goes through a face.
    let ring = both(&cuboid([0.05, 0.05, 0.05], [0.0, 0.0, 0.05]), &cuboid([0.05; 3], [0.0, 0.0, 0.15]));
    let top: Vec<usize> = (0..4).map(|k| 4 + k).collect();
    let mut column = ring.clone();
    column.triangles.retain(|t| {
        let z = t.map(|c| ring.corners[c][2]);
        z.iter().any(|z| (z - 0.1).abs() > 1e-12)
    });
    let number = |c: usize| if (8..12).contains(&c) { top[c - 8] } else { c };
    column.triangles.iter_mut().for_each(|t| *t = t.map(number));
    assert!(Solid::new(column.clone()).is_ok(), "a column with a ring of corners half way up");
    assert!(is_crossed(both(&whole, &column)));
    // Two tetrahedra whose edges cross in their middles, and a torus whose tube is wider than its ring.
    let corners = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
    let star = |size: f64| Mesh {
        corners: corners.map(|c| c.map(|x| size * x)).to_vec(),
        triangles: vec![[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]],
    };
    assert!(is_crossed(both(&star(0.1), &turned(star(-0.1)))));
    assert!(is_crossed(torus(0.08, 0.1, [40, 24])) && Solid::new(torus(0.12, 0.1, [40, 24])).is_ok());
    // The place is where it happens, to the size of what meets there.
    let MeshFault::Crossed(place) = fault(both(&whole, &cuboid([0.01; 3], [0.1, 0.03, -0.02]))) else {
        panic!()
    };
    assert!(norm(sub(place, [0.1, 0.03, -0.02])) < 0.02, "{place:?}");
    assert!(fault(both(&whole, &whole)).to_string().starts_with("the mesh intersects itself at ("));
}

#[test]
fn tetrahedra_cross_where_points_of_an_edge_say_so() {
    let mut seed = 5;
    let mut tetrahedron = || {
        let corners: Vec<Vec3<f64>> = (0..4).map(|_| [0, 1, 2].map(|_| 0.2 * random(&mut seed))).collect();
        let out = |k: [usize; 3]| {
            let [a, b, c] = k.map(|k| corners[k]);
            dot(smartbed_runtime::vec3::cross(sub(b, a), sub(c, a)), sub(corners[6 - k[0] - k[1] - k[2]], a))
                < 0.0
        };
        let triangles = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]];
        let triangles = triangles.map(|t| if out(t) { t } else { [t[0], t[2], t[1]] }).to_vec();
        Mesh { corners, triangles }
    };
    // How deep a point is: the least distance from the four planes.
    let depth = |mesh: &Mesh, x: Vec3<f64>| {
        let of = |t: &[usize; 3]| {
            let [a, b, c] = t.map(|k| mesh.corners[k]);
            let n = smartbed_runtime::vec3::cross(sub(b, a), sub(c, a));
            -dot(n, sub(x, a)) / norm(n)
        };
        mesh.triangles.iter().map(of).fold(f64::INFINITY, f64::min)
    };
    let (mut crossed, mut apart) = (0, 0);
    for _ in 0..400 {
        let pair = [tetrahedron(), tetrahedron()];
        // Least and largest depth along the edges of one in the other.
        let along = |one: &Mesh, other: &Mesh| {
            let edges = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];
            let points = edges.iter().flat_map(|[a, b]| {
                let [a, b] = [a, b].map(|k| one.corners[*k]);
                (0..=100).map(move |k| [0, 1, 2].map(|i| a[i] + f64::from(k) / 100.0 * (b[i] - a[i])))
            });
            let depths: Vec<f64> = points.map(|x| depth(other, x)).collect();
            [f64::min, f64::max].map(|pick| depths.iter().copied().reduce(pick).expect("points"))
        };
        let [one, other] = [along(&pair[0], &pair[1]), along(&pair[1], &pair[0])];
        let found = Solid::new(both(&pair[0], &pair[1])).map(|_| ());
        if [one, other].iter().any(|[least, most]| *least < -1e-6 && *most > 1e-4) {
            assert!(matches!(found, Err(MeshFault::Crossed(_))), "{pair:?} {found:?}");
            crossed += 1;
        } else if one[1] < -2e-3 && other[1] < -2e-3 {
            assert_eq!(found, Ok(()), "{pair:?}");
            apart += 1;
        }
    }
    assert!(crossed > 50 && apart > 50, "{crossed} {apart}");
}

#[test]
fn rounded_numbers_cross_nothing_and_parts_face_outwards() {
    // As files hold them: turned somehow, far from the origin, in f32, welded again.
    let pose = Pose::turned([0.4, -0.3, 0.5], [0.48, 0.6, 0.64], 0.7);
    for mesh in [ball(0.1, 5), torus(0.12, 0.05, [200, 90]), cuboid([0.3, 0.2, 0.001], [0.0; 3])] {
        let rounded = |x: Vec3<f64>| pose.outwards(x).map(|x| f64::from(x as f32));
        let places = (0..mesh.triangles.len()).flat_map(|t| mesh.places(t)).map(rounded);
        let read = Solid::new(Mesh::welded(places)).map(|(solid, _)| solid.mesh().triangles.len());
        assert_eq!(read, Ok(mesh.triangles.len()));
    }
    let volume = |mesh: Mesh| Solid::new(mesh).map(|(solid, _)| solid.volume());
    let (whole, small) = (cuboid([0.1; 3], [0.0; 3]), cuboid([0.05; 3], [0.0; 3]));
    let beside = cuboid([0.05; 3], [0.3, 0.0, 0.0]);
    for (mesh, expected) in [
        (both(&whole, &turned(small.clone())), 0.007),
        (turned(both(&whole, &turned(small.clone()))), 0.007),
        (both(&both(&whole, &turned(small.clone())), &cuboid([0.01; 3], [0.0; 3])), 0.007008),
        (both(&whole, &beside), 0.009),
    ] {
        assert!((volume(mesh).expect("a solid") - expected).abs() < 1e-15);
    }
    for mesh in [both(&whole, &small), both(&whole, &turned(beside))] {
        assert!(matches!(volume(mesh), Err(MeshFault::InsideOut(_))));
    }
}
