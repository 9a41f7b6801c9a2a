//! Impact between two flexible bodies on random pairs: energy, momentum and angular momentum of the whole, J >= 0,
//! no remaining approach velocity; and two springs head on, where by symmetry each acts as the other's ground.

use smartbed_runtime::contact::pair::{Touch, apply};
use smartbed_runtime::flexible::{Body, Massless, Spring};
use smartbed_tests::random::Random;

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Energy, momentum, angular momentum; and the sizes of the sums of the latter two.
fn totals(mass: &[f64], pos: &[Vector], vel: &[Vector]) -> (f64, Vector, Vector, f64) {
    let (mut energy, mut momentum, mut angular, mut size) = (0.0, [0.0; 3], [0.0; 3], 0.0);
    for ((m, x), v) in mass.iter().zip(pos).zip(vel) {
        energy += 0.5 * m * dot(*v, *v);
        let moment = cross(*x, *v);
        (0..3).for_each(|c| {
            momentum[c] += m * v[c];
            angular[c] += m * moment[c];
        });
        size += m * dot(*v, *v).sqrt() * (1.0 + dot(*x, *x).sqrt());
    }
    (energy, momentum, angular, size)
}

fn largest(a: Vector, b: Vector) -> f64 {
    (0..3).map(|c| (a[c] - b[c]).abs()).fold(0.0, f64::max)
}

#[test]
fn random_pairs_conserve() {
    let mut random = Random::new(7);
    let mut worst = [0.0_f64; 4];
    for _ in 0..20_000 {
        // Point 0 touches, 1 to 4 are the facet; 5 and 6 belong to the point, 7 and 8 to the facet.
        let mass: Vec<f64> = (0..9).map(|_| 10.0_f64.powf(random.between(-3.0, 3.0))).collect();
        let tilt = [random.between(-0.5, 0.5), random.between(-0.5, 0.5), 1.0];
        let normal = tilt.map(|c| c / dot(tilt, tilt).sqrt());
        let mut weights = [0.0; 4].map(|_: f64| random.between(0.0, 1.0));
        let sum: f64 = weights.iter().sum();
        weights.iter_mut().for_each(|w| *w /= sum);
        let mut pos: Vec<Vector> = (0..9).map(|_| random.vector(1.0)).collect();
        pos[0] = [0, 1, 2].map(|c| (0..4).map(|j| weights[j] * pos[j + 1][c]).sum());
        let mut vel: Vec<Vector> = (0..9).map(|_| random.vector(5.0)).collect();
        let rate = |vel: &[Vector]| {
            let facet = [0, 1, 2].map(|c| (0..4).map(|j| weights[j] * vel[j + 1][c]).sum());
            dot(vel[0], normal) - dot(facet, normal)
        };
        let correction = rate(&vel) + random.between(0.01, 5.0);
        (0..3).for_each(|c| vel[0][c] -= correction * normal[c]);
        let springs: Vec<Spring<f64>> =
            [[0, 5], [6, 0], [5, 6], [1, 7], [7, 2], [3, 8], [8, 4], [7, 8], [1, 2], [3, 4]]
                .map(|[tail, head]| Spring { tail, head, stiffness: 1.0, damping: 0.0, rest_length: 1.0 })
                .to_vec();
        let body = Body::new(Body {
            mass: &mass,
            fixed: &[false; 9],
            inverse_mass: &[],
            springs: &springs,
            gravity: [0.0; 3],
            air_drag: 0.0,
            facets: &[],
            inflation: None,
            massless: Massless::default(),
            grids: &[],
            patches: None,
        })
        .expect("body");
        let before = totals(&mass, &pos, &vel);
        let eta = if random.between(0.0, 1.0) < 0.5 { 1.0 } else { random.between(0.0, 1.0) };
        let touch = Touch { point: 0, corners: [1, 2, 3, 4], weights, normal };
        let impact = apply(&body, &touch, eta, &pos, &mut vel, &mut [[0.0; 3]; 9]).expect("they close");
        let after = totals(&mass, &pos, &vel);
        assert!(impact.impulse >= 0.0 && impact.impulse.is_finite());
        let size = before.3 + after.3;
        let speed = vel.iter().map(|v| dot(*v, *v).sqrt()).fold(0.0, f64::max);
        // Without a receiver the two rebound; else they stay together along n.
        let left = (-rate(&vel)).max(0.0) / speed;
        let found = [
            ((after.0 + impact.lost) / before.0 - 1.0).abs(),
            largest(before.1, after.1) / size,
            largest(before.2, after.2) / size,
            left,
        ];
        worst.iter_mut().zip(found).for_each(|(w, f)| *w = w.max(f));
    }
    let [energy, momentum, angular, left] = worst;
    println!(
        "20000 pairs: energy {energy:.1e}, momentum {momentum:.1e}, angular {angular:.1e}, approach left {left:.1e}"
    );
    assert!(worst.iter().all(|w| *w <= 1e-12), "{worst:?}");
}

#[test]
fn two_springs_head_on_are_each_the_others_ground() {
    // Points 1 - 0 above, 2 - 3 below; on each side the touching point moves at 3 m/s and the point behind it at 4 m/s.
    let springs = [[0, 1], [2, 3]].map(|[tail, head]| Spring {
        tail,
        head,
        stiffness: 1.0,
        damping: 0.0,
        rest_length: 1.0,
    });
    let body = Body::new(Body {
        mass: &[1.0; 4],
        fixed: &[false; 4],
        inverse_mass: &[],
        springs: &springs,
        gravity: [0.0; 3],
        air_drag: 0.0,
        facets: &[],
        inflation: None,
        massless: Massless::default(),
        grids: &[],
        patches: None,
    })
    .expect("body");
    let pos = [[0.0; 3], [0.0, 0.0, 1.0], [0.0; 3], [0.0, 0.0, -1.0]];
    let mut vel = [[0.0, 0.0, -4.0], [0.0, 0.0, -3.0], [0.0, 0.0, 4.0], [0.0, 0.0, 3.0]];
    let touch = Touch { point: 0, corners: [2; 4], weights: [1.0, 0.0, 0.0, 0.0], normal: [0.0, 0.0, 1.0] };
    let impact = apply(&body, &touch, 1.0, &pos, &mut vel, &mut [[0.0; 3]; 4]).expect("they close");
    // Eq. 4.13 on both sides: sqrt(3^2 + 4^2) = 5 towards each other, and the ground's J = 4 - (5 - 3).
    assert_eq!(vel, [[0.0; 3], [0.0, 0.0, -5.0], [0.0; 3], [0.0, 0.0, 5.0]]);
    assert_eq!(impact.impulse, 2.0);
}
