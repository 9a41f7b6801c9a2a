//! Energy compensation on random bodies: energy, momentum, angular momentum, J >= 0, friction inside its cone.
//!
//! The oracle rebuilds the change of every velocity from the reported lambda and ground impulses alone:
//! +lambda w d on the receiver, -lambda w d on the touching point, J n from the ground.

use smartbed_runtime::contact::compensation::{Compensation, PointImpact, apply};
use smartbed_runtime::contact::{ContactLaw, Ground, System, friction};
use smartbed_runtime::flexible::{Body, Massless, Spring};
use smartbed_runtime::real::Scalar;
use smartbed_runtime::vec3::Vec3;
use smartbed_tests::random::Random;

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

struct Case {
    mass: Vec<f64>,
    pos: Vec<[f64; 3]>,
    vel: Vec<[f64; 3]>,
    springs: Vec<[usize; 2]>,
    touching: usize,
    normal: [f64; 3],
}

/// Points 0.. touch, the others lie above; every point has springs to some of the others.
fn random_case(random: &mut Random, decades: f64) -> Case {
    let touching = 1 + random.below(6);
    let n = touching + 1 + random.below(6);
    let tilt = [random.between(-0.5, 0.5), random.between(-0.5, 0.5), 1.0];
    let length = dot(tilt, tilt).sqrt();
    let normal = tilt.map(|c| c / length);
    let mass = (0..n).map(|_| 10.0_f64.powf(random.between(-decades, decades))).collect();
    let mut pos = Vec::new();
    let mut vel = Vec::new();
    for i in 0..n {
        let mut x = [random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(0.1, 2.0)];
        let mut v = [0; 3].map(|_| random.between(-5.0, 5.0));
        if i < touching {
            let gap = dot(x, normal);
            x = [0, 1, 2].map(|c| x[c] - gap * normal[c]);
            let rate = dot(v, normal);
            let approach = random.between(0.01, 5.0);
            v = [0, 1, 2].map(|c| v[c] - (rate + approach) * normal[c]);
        }
        pos.push(x);
        vel.push(v);
    }
    let mut springs = Vec::new();
    for i in 0..n {
        for j in i + 1..n {
            if random.unit() < 0.6 {
                springs.push(if random.unit() < 0.5 { [i, j] } else { [j, i] });
            }
        }
    }
    Case { mass, pos, vel, springs, touching, normal }
}

struct Worst {
    energy: f64,
    momentum: f64,
    angular: f64,
    impulses: f64,
    cone: f64,
}

fn kinetic(mass: &[f64], vel: &[[f64; 3]]) -> f64 {
    mass.iter().zip(vel).map(|(m, v)| 0.5 * m * dot(*v, *v)).sum()
}

fn check<S: Scalar>(case: &Case, eta: f64, mu: f64, worst: &mut Worst) {
    let n = case.mass.len();
    let real = S::from_f64;
    let mass: Vec<S> = case.mass.iter().map(|m| real(*m)).collect();
    let pos: Vec<Vec3<S>> = case.pos.iter().map(|x| x.map(real)).collect();
    let mut vel: Vec<Vec3<S>> = case.vel.iter().map(|x| x.map(real)).collect();
    let fixed = vec![false; n];
    let spring = |s: &[usize; 2]| Spring {
        tail: s[0],
        head: s[1],
        stiffness: S::ONE,
        damping: S::ZERO,
        rest_length: S::ONE,
    };
    let springs: Vec<Spring<S>> = case.springs.iter().map(spring).collect();
    let body = Body::new(Body {
        mass: &mass,
        fixed: &fixed,
        inverse_mass: &[],
        springs: &springs,
        gravity: [S::ZERO; 3],
        air_drag: S::ZERO,
        facets: &[],
        inflation: None,
        massless: Massless::default(),
        grids: &[],
        patches: None,
    })
    .expect("body");
    let law =
        ContactLaw::Compensation { eta: real(eta), anchor: false, plastic_alone: false, first_receiver: 0 };
    let normal = case.normal.map(real);
    let ground = Ground { normal, offset: S::ZERO, law, friction: real(mu), tolerance: real(1e-6) };
    let system = System::new(body, Some(ground));
    let mut points = vec![PointImpact::none(); n];
    points.iter_mut().take(case.touching).for_each(|p| p.touching = true);
    let widen = |rows: &[Vec3<S>]| -> Vec<[f64; 3]> { rows.iter().map(|x| x.map(Scalar::to_f64)).collect() };
    let masses: Vec<f64> = mass.iter().map(|m| m.to_f64()).collect();
    let before = widen(&vel);
    let compensation =
        Compensation { eta: real(eta), anchor: S::ZERO, plastic_alone: false, first_receiver: 0 };
    let impact = apply(&system, compensation, &pos, &mut vel, &mut points, |_| true);
    let after = widen(&vel);
    let start = kinetic(&masses, &before);
    let lost = impact.lost.to_f64();
    worst.energy = worst.energy.max(((kinetic(&masses, &after) + lost) / start - 1.0).abs());
    balances(case, &masses, &before, &after, impact.lambda.to_f64(), &points, worst);
    for (i, point) in points.iter().enumerate().take(case.touching) {
        let j = point.impulse;
        assert!(j >= S::ZERO && j.is_finite(), "J = {j:?}");
        let mut v = vel[i];
        let lost = friction::apply(&mut v, normal, mass[i], real(mu), j).to_f64();
        let (old, new) = (vel[i].map(Scalar::to_f64), v.map(Scalar::to_f64));
        let change = [0, 1, 2].map(|c| masses[i] * (new[c] - old[c]));
        let spent = dot(change, change).sqrt();
        let scale = masses[i] * dot(old, old).sqrt() + mu * j.to_f64();
        worst.cone = worst.cone.max((spent - mu * j.to_f64()) / scale);
        let exact = 0.5 * masses[i] * (dot(old, old) - dot(new, new));
        worst.energy = worst.energy.max((lost - exact).abs() / start);
    }
}

/// Change of velocities against the impulses that were reported.
fn balances<S: Scalar>(
    case: &Case,
    mass: &[f64],
    before: &[[f64; 3]],
    after: &[[f64; 3]],
    lambda: f64,
    points: &[PointImpact<S>],
    worst: &mut Worst,
) {
    let mut expected = vec![[0.0; 3]; mass.len()];
    let mut exchanged = 0.0;
    let mut give = |i: usize, p: [f64; 3]| (0..3).for_each(|c| expected[i][c] += p[c]);
    for s in &case.springs {
        for [i, k] in [[s[0], s[1]], [s[1], s[0]]] {
            if i < case.touching && k >= case.touching {
                let d = [0, 1, 2].map(|c| case.pos[k][c] - case.pos[i][c]);
                let length = dot(d, d).sqrt();
                let w = dot(d, case.normal) / length;
                if w > 1e-6 {
                    let p = d.map(|c| lambda * w * c / length);
                    give(k, p);
                    give(i, p.map(|c| -c));
                    exchanged += dot(p, p).sqrt();
                }
            }
        }
    }
    let (mut ground, mut ground_moment) = ([0.0; 3], [0.0; 3]);
    for (i, point) in points.iter().enumerate().take(case.touching) {
        let p = case.normal.map(|c| c * point.impulse.to_f64());
        give(i, p);
        exchanged += point.impulse.to_f64();
        let moment = cross(case.pos[i], p);
        (0..3).for_each(|c| (ground[c] += p[c], ground_moment[c] += moment[c]).0);
    }
    let (mut momentum, mut angular) = (ground.map(|c| -c), ground_moment.map(|c| -c));
    for i in 0..mass.len() {
        let change = [0, 1, 2].map(|c| mass[i] * (after[i][c] - before[i][c]));
        let moment = cross(case.pos[i], change);
        // Rounding of m v itself is not the law's.
        let size = exchanged + mass[i] * (dot(before[i], before[i]).sqrt() + dot(after[i], after[i]).sqrt());
        for c in 0..3 {
            momentum[c] += change[c];
            angular[c] += moment[c];
            worst.impulses = worst.impulses.max((change[c] - expected[i][c]).abs() / size);
        }
    }
    let total: f64 = (0..mass.len()).map(|i| mass[i] * dot(before[i], before[i]).sqrt()).sum();
    let size = exchanged + total;
    worst.momentum = worst.momentum.max(dot(momentum, momentum).sqrt() / size);
    worst.angular = worst.angular.max(dot(angular, angular).sqrt() / size);
}

fn survey<S: Scalar>(bodies: usize, decades: f64, seed: u64) -> Worst {
    let mut random = Random::new(seed);
    let mut worst = Worst { energy: 0.0, momentum: 0.0, angular: 0.0, impulses: 0.0, cone: 0.0 };
    for _ in 0..bodies {
        let case = random_case(&mut random, decades);
        let eta = if random.unit() < 0.5 { 1.0 } else { random.unit() };
        let mu = random.between(0.0, 1.0);
        check::<S>(&case, eta, mu, &mut worst);
    }
    println!(
        "{bodies} bodies, masses 1e-{decades} to 1e{decades}: energy {:.1e}, momentum {:.1e}, angular {:.1e}, impulses {:.1e}, cone {:.1e}",
        worst.energy, worst.momentum, worst.angular, worst.impulses, worst.cone
    );
    worst
}

#[test]
fn compensation_conserves_on_100_000_bodies() {
    let worst = survey::<f64>(100_000, 3.0, 1);
    assert!(worst.energy <= 1e-12);
    assert!(worst.momentum <= 1e-12 && worst.angular <= 1e-12 && worst.impulses <= 1e-12);
    assert!(worst.cone <= 1e-12);
}

#[test]
fn compensation_survives_mass_ratios_of_1e12() {
    let worst = survey::<f64>(20_000, 6.0, 2);
    assert!(worst.energy <= 1e-12 && worst.cone <= 1e-12);
    let worst = survey::<f32>(20_000, 6.0, 3);
    assert!(worst.energy <= 1e-5 && worst.cone <= 1e-5);
}

#[test]
fn two_stacked_unit_masses_give_the_thesis_formula() {
    let springs = [Spring { tail: 0, head: 1, stiffness: 1.0, damping: 0.0, rest_length: 1.0 }];
    let body = Body {
        mass: &[1.0, 1.0],
        fixed: &[false, false],
        inverse_mass: &[],
        springs: &springs,
        gravity: [0.0; 3],
        air_drag: 0.0,
        facets: &[],
        inflation: None,
        massless: Massless::default(),
        grids: &[],
        patches: None,
    };
    let law = ContactLaw::Compensation { eta: 1.0, anchor: false, plastic_alone: false, first_receiver: 0 };
    let ground = Ground { normal: [0.0, 0.0, 1.0], offset: 0.0, law, friction: 0.0, tolerance: 1e-11 };
    let system = System::new(Body::new(body).expect("body"), Some(ground));
    let pos = [[0.0; 3], [0.0, 0.0, 1.0]];
    let mut vel = [[0.0, 0.0, -3.0], [0.0, 0.0, -4.0]];
    let mut points = [PointImpact::none(); 2];
    points[0].touching = true;
    let law = Compensation { eta: 1.0, anchor: 0.0, plastic_alone: false, first_receiver: 0 };
    let impact = apply(&system, law, &pos, &mut vel, &mut points, |_| true);
    // Eqs. 4.12, 4.13: v_b' = 0, v_a' = -sqrt(3^2 + 4^2) = -5; the ground gives J = 7 - 5.
    assert_eq!(vel, [[0.0; 3], [0.0, 0.0, -5.0]]);
    assert_eq!((impact.lambda, points[0].impulse), (-1.0, 2.0));
}
