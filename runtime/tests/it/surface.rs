//! Surfaces: nearest points against the definition of nearest, normals and rates against finite differences.

use crate::random::Random;
use crate::vector::{Vector, along, cross, dot, sub, unit};
use smartbed_runtime::surface::facet::{Facet, vertex_normals, weight_slopes};
use smartbed_runtime::surface::{Capsule, Cuboid, Frame, Proximity, Shape, Sphere, Surface, proximity};

fn shapes() -> [Shape<f64>; 5] {
    [
        Shape::HalfSpace,
        Shape::Sphere(Sphere { radius: 0.7 }),
        Shape::Capsule(Capsule { radius: 0.3, half_length: 0.6 }),
        Shape::Capsule(Capsule { radius: 0.5, half_length: 0.0 }),
        Shape::Cuboid(Cuboid { half: [0.8, 0.5, 0.3] }),
    ]
}

/// Is the place inside? By the definition of each shape alone.
fn contains(shape: &Shape<f64>, [x, y, z]: Vector, slack: f64) -> bool {
    match shape {
        Shape::HalfSpace => z <= slack,
        Shape::Sphere(s) => (x * x + y * y + z * z).sqrt() <= s.radius + slack,
        Shape::Capsule(c) => {
            let beyond = (z.abs() - c.half_length).max(0.0);
            (x * x + y * y + beyond * beyond).sqrt() <= c.radius + slack
        }
        Shape::Cuboid(b) => [x, y, z].iter().zip(b.half).all(|(p, h)| p.abs() <= h + slack),
    }
}

#[test]
fn the_foot_is_nearest_of_all_points_of_the_shape() {
    let mut random = Random::new(1);
    for shape in shapes() {
        for _ in 0..2000 {
            let place = random.vector(1.5);
            let near = shape.nearest(place);
            assert!((dot(near.normal, near.normal) - 1.0).abs() <= 1e-14);
            let back = along(near.foot, near.gap, near.normal);
            assert!(sub(back, place).iter().all(|x| x.abs() <= 1e-14), "x = foot + g n");
            assert_eq!(near.gap > 0.0, !contains(&shape, place, 0.0), "{shape:?} {place:?}");
            assert!(contains(&shape, near.foot, 1e-14) && !contains(&shape, near.foot, -1e-14));
            for _ in 0..20 {
                let other = random.vector(1.5);
                if near.gap > 0.0 && contains(&shape, other, 0.0) {
                    // A convex set lies beyond the plane through the foot.
                    assert!(dot(sub(place, near.foot), sub(other, near.foot)) <= 1e-13);
                }
                if near.gap < 0.0 {
                    // From inside: the ball up to the foot lies in the shape.
                    let within = along(place, near.gap, unit(other));
                    assert!(contains(&shape, within, 1e-13), "{shape:?} {place:?}");
                }
            }
        }
    }
}

/// A frame that moves with constant acceleration and turns at a constant rate about a fixed axis.
struct Motion {
    start: Vector,
    velocity: Vector,
    acceleration: Vector,
    axis: Vector,
    rate: f64,
}

impl Motion {
    fn at(&self, t: f64) -> Frame<f64> {
        let (sin, cos) = (self.rate * t).sin_cos();
        // Rodrigues' formula.
        let turn = |a: Vector| {
            let k = self.axis;
            along(along(a.map(|x| x * cos), sin, cross(k, a)), (1.0 - cos) * dot(k, a), k)
        };
        let origin = along(along(self.start, t, self.velocity), 0.5 * t * t, self.acceleration);
        Frame {
            origin,
            axes: [turn([0.6, 0.8, 0.0]), turn([-0.8, 0.6, 0.0]), turn([0.0, 0.0, 1.0])],
            velocity: along(self.velocity, t, self.acceleration),
            angular_velocity: self.axis.map(|x| x * self.rate),
        }
    }
}

#[test]
fn gaps_change_as_their_rates_say_in_frames_that_move_and_turn() {
    let mut random = Random::new(2);
    let (mut compared, d) = (0, 1e-4);
    for shape in shapes() {
        for _ in 0..500 {
            let frame = Motion {
                start: random.vector(0.3),
                velocity: random.vector(1.0),
                acceleration: random.vector(1.0),
                axis: unit(random.vector(1.0)),
                rate: random.between(-2.0, 2.0),
            };
            let (start, velocity, acceleration) =
                (random.vector(1.5), random.vector(1.0), random.vector(1.0));
            let near = |t: f64| -> Proximity<f64> {
                let point = along(along(start, t, velocity), 0.5 * t * t, acceleration);
                proximity(&shape, &frame.at(t), point, along(velocity, t, acceleration))
            };
            let nearest = |t: f64| shape.nearest(frame.at(t).place(along(start, t, velocity)));
            let features = [-d, 0.0, d].map(|t| std::mem::discriminant(&nearest(t).feature));
            let now = near(0.0);
            // Where the nearest feature or the nearest inner face changes, or close to the core, nothing is smooth.
            let smooth =
                nearest(0.0).distance > 0.2 && features[0] == features[1] && features[1] == features[2];
            if !smooth {
                continue;
            }
            compared += 1;
            let rate = (near(d).gap - near(-d).gap) / (2.0 * d);
            let second = (near(d).gap_rate - near(-d).gap_rate) / (2.0 * d);
            let accelerations = dot(now.normal, sub(acceleration, frame.acceleration));
            assert!((rate - now.gap_rate).abs() <= 2e-6, "{shape:?}: {rate} {}", now.gap_rate);
            assert!((second - accelerations - now.bias).abs() <= 1e-4, "{shape:?}: {second} {}", now.bias);
        }
    }
    assert!(compared > 1200, "{compared}");
}

#[test]
fn places_without_a_direction_have_a_normal() {
    for shape in shapes() {
        let near = shape.nearest([0.0; 3]);
        assert_eq!(dot(near.normal, near.normal), 1.0, "{shape:?}");
        assert!(near.gap <= 0.0 && near.foot.iter().all(|x| x.is_finite()));
    }
    // On an edge and on a corner of a box, and on the plane.
    for place in [[0.8, 0.5, 0.0], [0.8, 0.5, 0.3]] {
        let near = shapes()[4].nearest(place);
        assert_eq!((near.gap, near.foot, dot(near.normal, near.normal)), (0.0, place, 1.0));
    }
}

/// A ball of radius 1 as a grid of facets by latitude and longitude, with triangles at the poles.
fn ball(rings: usize, columns: usize) -> (Vec<[usize; 4]>, Vec<Vector>) {
    let mut points = vec![[0.0, 0.0, -1.0]];
    for ring in 1..rings {
        let latitude = std::f64::consts::PI * (ring as f64 / rings as f64 - 0.5);
        for column in 0..columns {
            let longitude = 2.0 * std::f64::consts::PI * column as f64 / columns as f64;
            let (sin, cos) = longitude.sin_cos();
            points.push([latitude.cos() * cos, latitude.cos() * sin, latitude.sin()]);
        }
    }
    points.push([0.0, 0.0, 1.0]);
    let top = points.len() - 1;
    let at = |ring: usize, column: usize| 1 + (ring - 1) * columns + column % columns;
    let mut facets = Vec::new();
    for column in 0..columns {
        facets.push([at(1, column + 1), at(1, column), 0, 0]);
        for ring in 1..rings - 1 {
            facets.push([
                at(ring, column),
                at(ring, column + 1),
                at(ring + 1, column + 1),
                at(ring + 1, column),
            ]);
        }
        facets.push([at(rings - 1, column), at(rings - 1, column + 1), top, top]);
    }
    (facets, points)
}

#[test]
fn a_ball_of_facets_is_a_ball_to_second_order() {
    let mut random = Random::new(3);
    let mut worst = [0.0_f64; 2];
    for (level, rings) in [16, 32].into_iter().enumerate() {
        let (facets, points) = ball(rings, 2 * rings);
        let mut normals = vec![[0.0; 3]; points.len()];
        vertex_normals(&facets, &points, 0..points.len(), &mut normals);
        for (point, normal) in points.iter().zip(&normals) {
            assert!(dot(*point, *normal) > 0.995, "outwards: {point:?} {normal:?}");
        }
        for _ in 0..300 {
            let point = unit(random.vector(1.0)).map(|x| x * 1.1);
            // Near a pole the facets' places crowd together.
            if point[2].abs() > 0.95 {
                continue;
            }
            let over = |margin: f64| {
                let near = facets.iter().filter_map(|f| {
                    let facet = Facet { corners: f.map(|k| points[k]), normals: f.map(|k| normals[k]) };
                    facet.nearest(point, margin)
                });
                near.filter(|n| n.gap.abs() < 0.5).collect::<Vec<_>>()
            };
            let found = over(1e-12);
            assert!(!found.is_empty(), "every point outside is over a facet: {point:?}");
            for near in found {
                assert!((near.weights.iter().sum::<f64>() - 1.0).abs() <= 1e-14);
                let back = along(near.foot, near.gap, near.normal);
                assert!(sub(back, point).iter().all(|x| x.abs() <= 1e-12));
                worst[level] =
                    worst[level].max((near.gap - 0.1).abs()).max(1.0 - dot(near.normal, unit(point)));
            }
        }
    }
    assert!(worst[0] < 2e-2 && (worst[0] / worst[1]).log2() > 1.7, "{worst:?}");
}

#[test]
fn over_an_edge_both_facets_agree_and_rates_are_those_of_finite_differences() {
    let mut random = Random::new(4);
    let d = 1e-6;
    for _ in 0..300 {
        // Two facets, warped, that share the edge 1 - 2.
        let flat = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [2.0, 0.0], [2.0, 1.0]];
        let points = flat.map(|[x, y]| along([x, y, 0.0], 0.1, random.vector(1.0)));
        let speeds = points.map(|_| random.vector(1.0));
        let facets = [[0, 1, 2, 3], [1, 4, 5, 2]];
        let facet = |number: usize, t: f64| {
            let moved: Vec<Vector> = points.iter().zip(&speeds).map(|(x, v)| along(*x, t, *v)).collect();
            let mut normals = vec![[0.0; 3]; 6];
            vertex_normals(&facets, &moved, 0..moved.len(), &mut normals);
            Facet { corners: facets[number].map(|k| moved[k]), normals: facets[number].map(|k| normals[k]) }
        };
        let first = facet(0, 0.0);
        // A place on the shared edge, lifted along the normal there.
        let s = random.between(0.1, 0.9);
        let mix = |a: Vector, b: Vector| along(a.map(|x| x * (1.0 - s)), s, b);
        let normal = unit(mix(first.normals[1], first.normals[2]));
        let point = along(mix(first.corners[1], first.corners[2]), 0.05, normal);
        let [one, two] = [0, 1].map(|n| facet(n, 0.0).nearest(point, 1e-9).expect("over the edge"));
        assert!((one.gap - 0.05).abs() <= 1e-12 && (two.gap - 0.05).abs() <= 1e-12);
        assert!(sub(one.normal, two.normal).iter().all(|x| x.abs() <= 1e-12), "no jump");
        // The gradient, apart from the surface; the rate with everything moving, at the surface.
        let start = along([0.5, 0.5, 0.0], 0.2, random.vector(1.0));
        let near = |x: Vector| first.nearest(x, 1.0).expect("near");
        for i in 0..3 {
            let step = std::array::from_fn(|j| if i == j { d } else { 0.0 });
            let slope = (near(along(start, 1.0, step)).gap - near(along(start, -1.0, step)).gap) / (2.0 * d);
            assert!((slope - near(start).gradient[i]).abs() <= 1e-8);
        }
        let (foot, velocity) = (near(start).foot, random.vector(1.0));
        let gap = |t: f64| facet(0, t).nearest(along(foot, t, velocity), 1.0).expect("near").gap;
        let rate = near(foot).gap_rate(velocity, &facets[0].map(|k| speeds[k]));
        assert!(((gap(d) - gap(-d)) / (2.0 * d) - rate).abs() <= 1e-7, "{rate}");
    }
}

/// What lies a gap off a facet turns with its tangent plane: shares of an impulse at the corners, w_i P + n (c_i . P),
/// have the sum P and the moment x x P of the place itself, also where the normals are not the facet's own.
#[test]
fn shares_below_a_facet_leave_no_moment() {
    let mut random = Random::new(5);
    for case in 0..1000 {
        let mut corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]
            .map(|[x, y]| along([x, y, 0.0], 0.2, random.vector(1.0)));
        if case % 2 == 1 {
            corners[3] = corners[2];
        }
        let normals = corners.map(|_| unit(along([0.0, 0.0, 1.0], 0.5, random.vector(1.0))));
        let start = along([0.5, 0.4, random.between(-0.1, 0.1)], 0.2, random.vector(1.0));
        let Some(near) = (Facet { corners, normals }).nearest(start, 0.0) else { continue };
        let (impulse, slopes) = (random.vector(1.0), weight_slopes(&corners, &near));
        let (mut sum, mut moment) = ([0.0; 3], [0.0; 3]);
        for ((corner, weight), slope) in corners.iter().zip(near.weights).zip(slopes) {
            let turning = -near.gap * dot(slope, impulse);
            let share = along(impulse.map(|p| weight * p), turning, near.normal);
            (sum, moment) = (along(sum, 1.0, share), along(moment, 1.0, cross(*corner, share)));
        }
        let place = along(near.foot, near.gap, near.normal);
        assert!(sub(sum, impulse).iter().all(|x| x.abs() <= 1e-12), "{sum:?}, {impulse:?}");
        assert!(sub(moment, cross(place, impulse)).iter().all(|x| x.abs() <= 1e-12), "case {case}");
    }
}
