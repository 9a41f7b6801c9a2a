//! Contact geometry of pairs of rigid shapes: distances against independent computations, rates against finite
//! differences.

use crate::random::Random;
use crate::vector::{Vector, along, dot, sub, turned, unit};
use smartbed_runtime::rigid::narrow::{Feature, Placed, features};
use smartbed_runtime::surface::{Capsule, Cuboid, Frame, Shape, Sphere, Surface};

fn random_frame(random: &mut Random, reach: f64) -> Frame<f64> {
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    Frame {
        origin: random.vector(reach),
        axes: turned(axes, unit(random.vector(1.0)), random.between(0.0, 3.0)),
        velocity: random.vector(1.0),
        angular_velocity: random.vector(2.0),
    }
}

/// The frame a time later, turning at a constant rate.
fn later(frame: &Frame<f64>, t: f64) -> Frame<f64> {
    let rate = dot(frame.angular_velocity, frame.angular_velocity).sqrt();
    Frame {
        origin: along(frame.origin, t, frame.velocity),
        axes: turned(frame.axes, frame.angular_velocity.map(|x| x / rate), rate * t),
        ..*frame
    }
}

fn shapes() -> [Shape<f64>; 4] {
    [
        Shape::Sphere(Sphere { radius: 0.3 }),
        Shape::Capsule(Capsule { radius: 0.2, half_length: 0.5 }),
        Shape::Cuboid(Cuboid { half: [0.4, 0.3, 0.2] }),
        Shape::HalfSpace,
    ]
}

fn found(
    one: (&Shape<f64>, &Frame<f64>),
    other: (&Shape<f64>, &Frame<f64>),
    margin: f64,
) -> Vec<Feature<f64>> {
    let placed = |(shape, frame)| Placed { shape, frame };
    features(placed(one), placed(other), margin).iter().collect()
}

/// Smallest value of a convex function over [-1, 1], by thirds.
fn least(f: &dyn Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (-1.0, 1.0);
    for _ in 0..200 {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if f(a) < f(b) { high = b } else { low = a }
    }
    f(0.5 * (low + high))
}

/// Distance from a ball or capsule to a shape: the least over the axis, of convex functions.
fn distance(round: (&Shape<f64>, &Frame<f64>), other: (&Shape<f64>, &Frame<f64>)) -> f64 {
    let (radius, half) = match round.0 {
        Shape::Sphere(s) => (s.radius, 0.0),
        Shape::Capsule(c) => (c.radius, c.half_length),
        _ => unreachable!("round shapes only"),
    };
    let over = |s: f64| other.0.nearest(other.1.place(round.1.point([0.0, 0.0, s * half]))).gap;
    least(&over) - radius
}

#[test]
fn the_nearest_feature_of_a_round_shape_lies_at_the_distance() {
    let mut random = Random::new(5);
    let mut near = 0;
    for _ in 0..20_000 {
        let (one, other) = (random_frame(&mut random, 0.7), random_frame(&mut random, 0.7));
        for round in &shapes()[..2] {
            for shape in &shapes() {
                let exact = distance((round, &one), (shape, &other));
                // Deep inside a box its faces compete; a rigid contact is never there.
                if exact < -0.15 {
                    continue;
                }
                let list = found((round, &one), (shape, &other), 0.3);
                let gap = list.iter().map(|f| f.gap).fold(f64::INFINITY, f64::min);
                if exact < 0.3 {
                    near += 1;
                    assert!((gap - exact).abs() <= 1e-9, "{round:?} {shape:?}: {gap} {exact}");
                } else {
                    assert!(list.is_empty());
                }
                // The other way round: the same features with the opposite normals.
                let back = found((shape, &other), (round, &one), 0.3);
                let least = back.iter().map(|f| f.gap).fold(f64::INFINITY, f64::min);
                assert!(least == gap || (least - gap).abs() <= 1e-12);
            }
        }
    }
    assert!(near > 20_000, "{near}");
}

#[test]
fn features_move_as_their_rates_say() {
    let mut random = Random::new(6);
    let (mut compared, d) = ([0; 10], 1e-6);
    for _ in 0..10_000 {
        let (one, other) = (random_frame(&mut random, 0.6), random_frame(&mut random, 0.6));
        let second = shapes();
        for (i, a) in shapes().iter().enumerate() {
            for (j, b) in second.iter().enumerate().skip(i) {
                if i == 3 || (i == 2 && j == 2) {
                    continue;
                }
                let at = |t: f64| found((a, &later(&one, t)), (b, &later(&other, t)), 0.1);
                let (before, now, after) = (at(-d), at(0.0), at(d));
                for feature in now {
                    let same = |list: &[Feature<f64>]| list.iter().find(|f| f.id == feature.id).copied();
                    let (Some(p), Some(q)) = (same(&before), same(&after)) else { continue };
                    let half = 0.5 / d;
                    let turned = sub(q.normal, p.normal).map(|x| x * half);
                    // Jumps where the nearest part changes, and close to a core, are left out.
                    let calm = feature.gap > -0.05 && dot(turned, turned) < 400.0;
                    if !calm {
                        continue;
                    }
                    compared[3 * i + j] += 1;
                    let close = |x: Vector, y: Vector, what: &str| {
                        let off = sub(x, y).iter().fold(0.0_f64, |m, e| m.max(e.abs()));
                        assert!(off <= 1e-6, "{a:?} on {b:?}, {what}: {x:?} {y:?} {feature:?}");
                    };
                    close(turned, feature.normal_rate, "normal");
                    let c = feature.point;
                    let relative = sub(one.velocity_at(c), other.velocity_at(c));
                    let rate = dot(relative, feature.normal);
                    assert!(((q.gap - p.gap) * half - rate).abs() <= 1e-6, "{a:?} on {b:?}: {rate}");
                    // The point of contact itself, where the shapes touch: here near enough to compare as it stands.
                    close(sub(q.point, p.point).map(|x| x * half), feature.point_rate, "point");
                }
            }
        }
    }
    // Pairs ball, capsule, box, half-space in turn: each but box on box, which has its own test.
    for pair in [0, 1, 2, 3, 4, 5, 6, 9] {
        assert!(compared[pair] > 500, "{compared:?}");
    }
}

/// The corner of a box that lies farthest along a direction, measured along it.
fn reach(half: Vector, frame: &Frame<f64>, way: Vector) -> f64 {
    let corners = (0..8).map(|n| std::array::from_fn(|i| if n & (1 << i) == 0 { -half[i] } else { half[i] }));
    corners.map(|c| dot(frame.point(c), way)).fold(f64::NEG_INFINITY, f64::max)
}

#[test]
fn boxes_touch_when_their_distance_is_nothing() {
    let mut random = Random::new(7);
    let halves = [[0.4, 0.3, 0.2], [0.25, 0.25, 0.25]];
    let shapes = halves.map(|half| Shape::Cuboid(Cuboid { half }));
    let (mut faces, mut edges) = (0, 0);
    for _ in 0..300 {
        let (one, mut other) = (random_frame(&mut random, 0.1), random_frame(&mut random, 0.1));
        let way = unit(random.vector(1.0));
        let least = |other: &Frame<f64>| {
            let list = found((&shapes[0], &one), (&shapes[1], other), 1e-3);
            list.iter().map(|f| f.gap).fold(1e-3, f64::min)
        };
        // From far away to the touch.
        let (mut far, mut close) = (2.0, 0.0);
        for _ in 0..60 {
            let middle = 0.5 * (far + close);
            other.origin = along(one.origin, middle, way);
            if least(&other) > 0.0 { far = middle } else { close = middle }
        }
        other.origin = along(one.origin, far, way);
        let list = found((&shapes[0], &one), (&shapes[1], &other), 1e-9);
        assert!(!list.is_empty());
        // A plane lies between them, and the features lie on both: nothing else is a touch.
        let n = list[0].normal;
        let between = -reach(halves[0], &one, n.map(|x| -x)) - reach(halves[1], &other, n);
        assert!(between.abs() <= 1e-9, "{between}");
        for f in &list {
            assert!(dot(f.normal, sub(one.origin, other.origin)) > 0.0, "from the other to the one");
            for (shape, frame) in [(&shapes[0], &one), (&shapes[1], &other)] {
                assert!(shape.nearest(frame.place(f.point)).gap.abs() <= 1e-6, "on both: {f:?}");
            }
            if f.id >= 64 { edges += 1 } else { faces += 1 }
        }
    }
    assert!(faces > 30 && edges > 30, "{faces} {edges}");
}

#[test]
fn a_face_on_a_face_touches_in_the_corners_of_what_they_share() {
    let level = Frame::inertial();
    let cube = Shape::Cuboid(Cuboid { half: [0.5, 0.5, 0.5] });
    let at = |origin: Vector, angle: f64| Frame {
        origin,
        axes: turned(level.axes, [0.0, 0.0, 1.0], angle),
        ..level
    };
    let corners = |frame: &Frame<f64>, shape: &Shape<f64>| found((shape, frame), (&cube, &level), 1e-9);
    // Flush: four. Shifted: four, at the corners of the overlap. Turned by 45 degrees: an octagon. Small on large:
    // four.
    for (origin, angle, wanted) in [
        ([0.0, 0.0, 1.0], 0.0, 4),
        ([0.3, 0.2, 1.0], 0.0, 4),
        ([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_4, 8),
        ([0.4, 0.0, 1.0], 0.3, 6),
    ] {
        let list = corners(&at(origin, angle), &cube);
        assert_eq!(list.len(), wanted, "{origin:?}, {angle}: {list:?}");
        for f in &list {
            assert!(f.gap.abs() <= 1e-12 && sub(f.normal, [0.0, 0.0, 1.0]).iter().all(|x| x.abs() < 1e-12));
            assert!(f.point[0].abs() <= 0.5 + 1e-12 && f.point[1].abs() <= 0.5 + 1e-12);
        }
    }
    let small = Shape::Cuboid(Cuboid { half: [0.1, 0.1, 0.2] });
    assert_eq!(corners(&at([0.2, 0.0, 0.7], 0.4), &small).len(), 4);
    // A box on the ground, and a rod lying on it.
    let ground = |shape: &Shape<f64>, z: f64, axes: [Vector; 3]| {
        let frame = Frame { origin: [0.0, 0.0, z], axes, ..level };
        found((shape, &frame), (&Shape::HalfSpace, &level), 1e-9).len()
    };
    assert_eq!(ground(&cube, 0.5, level.axes), 4);
    let rod = Shape::Capsule(Capsule { radius: 0.1, half_length: 0.4 });
    assert_eq!(ground(&rod, 0.1, turned(level.axes, [0.0, 1.0, 0.0], std::f64::consts::FRAC_PI_2)), 2);
    assert_eq!(ground(&rod, 0.5, level.axes), 1);
    // Two rods side by side: a line, two points; two ends that meet: one.
    let beside = at([0.2, 0.0, 0.2], 0.0);
    assert_eq!(found((&rod, &beside), (&rod, &level), 1e-9).len(), 2);
    let above = at([0.0, 0.0, 1.0], 0.0);
    assert_eq!(found((&rod, &above), (&rod, &level), 1e-9).len(), 1);
    assert_eq!(found((&Shape::HalfSpace, &level), (&Shape::HalfSpace, &above), 1.0).len(), 0);
}

/// What two rectangles share: the one, cut along each side of the other (Sutherland & Hodgman 1974).
fn shared(one: [[f64; 2]; 4], [a, b]: [f64; 2]) -> Vec<[f64; 2]> {
    let mut polygon = one.to_vec();
    for (axis, sense, half) in [(0, 1.0, a), (0, -1.0, a), (1, 1.0, b), (1, -1.0, b)] {
        let beyond = |p: &[f64; 2]| sense * p[axis] - half;
        let mut cut = Vec::new();
        for (n, p) in polygon.iter().enumerate() {
            let q = &polygon[(n + 1) % polygon.len()];
            if beyond(p) <= 0.0 {
                cut.push(*p);
            }
            if (beyond(p) <= 0.0) != (beyond(q) <= 0.0) {
                let part = beyond(p) / (beyond(p) - beyond(q));
                cut.push([p[0] + part * (q[0] - p[0]), p[1] + part * (q[1] - p[1])]);
            }
        }
        polygon = cut;
    }
    polygon
}

/// Boxes whose sides are flush, nearly so, or cross in corners, one upon the other in any order and attitude: the
/// points span what the faces share, and where sides are flush to rounding no point stands twice.
#[test]
fn what_faces_share_is_spanned_however_their_sides_lie() {
    let mut random = Random::new(41);
    let sizes = [0.1, 0.15, 0.2, 0.1 * std::f64::consts::SQRT_2, 0.2 * std::f64::consts::SQRT_2];
    let offsets = [1e-10, 3e-10, 1e-9, 3e-9, 1e-7, 1e-4, -3e-10, -1e-8, 1e-13, -1e-13, 1e-16, 0.0];
    for trial in 0..40_000 {
        let of = |random: &mut Random, list: &[f64]| {
            let place = random.between(0.0, list.len() as f64) as usize;
            list[place.min(list.len() - 1)]
        };
        // Half of the trials differ from exact ones by rounding alone.
        let is_exact = trial % 2 == 0;
        let mut some = |list: &[f64]| {
            let offset = of(&mut random, if is_exact { &offsets[8..] } else { &offsets });
            of(&mut random, list) + offset
        };
        let [below, above] = [(); 2].map(|()| [(); 3].map(|()| some(&sizes)));
        let shift = [0, 1].map(|k| {
            let flush = below[k] - above[k];
            some(&[0.0, flush, -flush, 0.05, below[k], -below[k]])
        });
        let angle = std::f64::consts::PI * some(&[0.0, 0.25, 0.5, 0.75, 1.0, 0.1]);
        let (sine, cosine) = angle.sin_cos();
        let corner = |[u, v]: [f64; 2]| [shift[0] + cosine * u - sine * v, shift[1] + sine * u + cosine * v];
        let [u, v, _] = above;
        let polygon = shared([[-u, -v], [u, -v], [u, v], [-u, v]].map(corner), [below[0], below[1]]);
        let span = |k: usize| {
            let along =
                |worst: fn(f64, f64) -> f64| polygon.iter().map(|p| p[k]).reduce(worst).unwrap_or(0.0);
            along(f64::max) - along(f64::min)
        };
        if span(0).min(span(1)) < 1e-3 {
            continue;
        }
        let base = random_frame(&mut random, 0.5);
        let upper = Frame {
            origin: base.point([shift[0], shift[1], below[2] + above[2]]),
            axes: turned(base.axes, base.axes[2], angle),
            ..base
        };
        let [low, high] = [below, above].map(|half| Shape::Cuboid(Cuboid { half }));
        let (one, other) = ((&low, &base), (&high, &upper));
        let both = [found(one, other, 1e-6), found(other, one, 1e-6)];
        for list in &both {
            let points = list.iter().map(|f| base.place(f.point));
            let points: Vec<[f64; 2]> = points.map(|place| [place[0], place[1]]).collect();
            for direction in 0..32 {
                let (y, x) = (f64::from(direction) * std::f64::consts::TAU / 32.0).sin_cos();
                let along = |p: &[f64; 2]| x * p[0] + y * p[1];
                let reach = |list: &[[f64; 2]]| list.iter().map(along).fold(f64::NEG_INFINITY, f64::max);
                let (expected, reached) = (reach(&polygon), reach(&points));
                let told = format!("{below:?} {above:?} {shift:?} {angle}: {points:?}, shared {polygon:?}");
                assert!((expected - reached).abs() < 2e-8, "{expected} {reached}: {told}");
            }
        }
        if is_exact {
            for list in &both {
                let twice = list.iter().enumerate().any(|(n, f)| {
                    list[..n].iter().any(|g| dot(sub(f.point, g.point), sub(f.point, g.point)) < 1e-16)
                });
                assert!(!twice && list.len() <= 8, "a point stands twice: {list:?}");
            }
        }
    }
}

#[test]
fn a_capsule_across_a_box_touches_both_rims_of_the_face() {
    let mut random = Random::new(8);
    let half = [0.4, 0.3, 0.2];
    let (rod, cuboid) =
        (Shape::Capsule(Capsule { radius: 0.02, half_length: 0.9 }), Shape::Cuboid(Cuboid { half }));
    let tilts = [0.0, 1e-12, 1e-9, 1e-6, 1e-3, 0.02];
    for trial in 0..2000 {
        let body = random_frame(&mut random, 0.5);
        // Over one of the six faces, at any angle in the face and any gap.
        let (face, upper) = (trial % 3, trial % 2 == 0);
        let normal = body.axes[face].map(|x| if upper { x } else { -x });
        let (side, yaw) = (body.axes[(face + 1) % 3], random.between(0.0, 6.3));
        // The axis stays outside: inside the box the distance to it is not that of a segment.
        let gap = random.between(-0.007, 0.05);
        let [u, v] = [random.between(-0.1, 0.1), random.between(-0.1, 0.1)];
        let shift = along(along([0.0; 3], u, side), v, body.axes[(face + 2) % 3]);
        let level = turned([side, side, side], normal, yaw)[0];
        let at = |tilt: f64| {
            // Right-handed axes whose last is the rod's.
            let across = turned([level; 3], normal, std::f64::consts::FRAC_PI_2)[0];
            let axes = turned([across, normal, level], across, tilt);
            let up = half[face] + 0.02 + gap;
            let origin = along(along(body.origin, up, normal), 1.0, shift);
            Frame { origin, axes, velocity: [0.0; 3], angular_velocity: [0.0; 3] }
        };
        let mut before: Option<(f64, Vec<Feature<f64>>)> = None;
        let both = tilts.iter().rev().map(|t| -t).chain(tilts);
        for tilt in both {
            let frame = at(tilt);
            let list = found((&rod, &frame), (&cuboid, &body), 0.1);
            let deepest = list.iter().map(|f| f.gap).fold(f64::INFINITY, f64::min);
            let exact = distance((&rod, &frame), (&cuboid, &body));
            assert!((deepest - exact).abs() <= 1e-9, "{trial}, {tilt}: {deepest} {exact}");
            // The features span the centre: none lies alone on one side of it.
            let places = list.iter().map(|f| dot(sub(f.point, frame.origin), level));
            let (low, high) =
                places.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), s| (a.min(s), b.max(s)));
            assert!(low < -0.05 && high > 0.05, "{trial}, {tilt}: {list:?}");
            // A turn moves no crossing by more than that of two lines at this angle, and none appears or goes.
            if let Some((last, old)) = &before {
                for f in list.iter().filter(|f| f.id > 16) {
                    let cosine = dot(level, body.axes[(f.id as usize - 17) / 4]);
                    let way = 2.0 * (tilt - last).abs() / (1.0 - cosine * cosine).sqrt() + 1e-13;
                    let Some(g) = old.iter().find(|g| g.id == f.id) else {
                        // Near a corner of the box the corner's own feature was there before.
                        let near =
                            |g: &&Feature<f64>| (2..10).contains(&g.id) && (f.gap - g.gap).abs() <= way;
                        assert!(old.iter().any(|g| near(&g)), "{trial}: {f:?} appears, {last} to {tilt}");
                        continue;
                    };
                    assert!((f.gap - g.gap).abs() <= way, "{trial}, {last} to {tilt}: {f:?} {g:?}");
                    let turn = sub(f.normal, g.normal);
                    assert!(dot(turn, turn).sqrt() <= way, "{trial}, {last} to {tilt}: {f:?} {g:?}");
                }
            }
            before = Some((tilt, list));
        }
    }
}
