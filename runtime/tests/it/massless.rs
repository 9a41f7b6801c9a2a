//! Massless points against Coulomb's law in the form of inequalities, which does not depend on how the position is
//! found; friction loss of points guided along the ground against force times displacement.

use crate::random::Random;
use smartbed_runtime::contact::massless::{friction_loss, settle};
use smartbed_runtime::contact::{ContactLaw, Ground};
use smartbed_runtime::flexible::{Body, Massless, Spring};
use smartbed_runtime::vec3::{self, Vec3};

const STIFFNESS: f64 = 100.0;

fn tilted(random: &mut Random, friction: f64) -> Ground<f64> {
    let (normal, _) = vec3::direction(vec3::add([0.0, 0.0, 1.0], random.vector(0.5)));
    Ground { normal, offset: 0.3, law: ContactLaw::MasslessPoint, friction, tolerance: 1e-12 }
}

/// Point 0 has no mass and hangs in springs from the others.
fn hung(springs: &[Spring<f64>]) -> Body<'_, f64> {
    Body {
        mass: &[0.0, 1.0, 1.0, 1.0],
        fixed: &[false; 4],
        inverse_mass: &[],
        springs,
        massless: Massless { points: &[0], first: &[0, 3], springs: &[0, 1, 2] },
        grids: &[],
        patches: None,
        ..Body::none()
    }
}

/// The springs' force on point 0, written out.
fn pull(springs: &[Spring<f64>], pos: &[Vec3<f64>]) -> Vec3<f64> {
    springs.iter().fold([0.0; 3], |sum, spring| {
        let (direction, length) = vec3::direction(vec3::sub(pos[spring.head], pos[0]));
        vec3::axpy(sum, spring.stiffness * (length - spring.rest_length), direction)
    })
}

/// A point above a surface, from a foot on it along a tangent.
fn place(ground: &Ground<f64>, height: f64, along: Vec3<f64>) -> Vec3<f64> {
    let along = vec3::tangential(along, ground.normal);
    vec3::axpy(along, ground.offset + height, ground.normal)
}

#[test]
fn a_massless_point_obeys_coulombs_law() {
    let mut random = Random::new(71);
    let mut met = [0; 3];
    for _ in 0..20_000 {
        let friction = random.between(0.05, 2.0);
        let ground = tilted(&mut random, friction);
        let spring = |head| Spring { tail: 0, head, stiffness: STIFFNESS, damping: 0.0, rest_length: 0.02 };
        let springs = [1, 2, 3].map(spring);
        let foot = place(&ground, 0.0, random.vector(0.1));
        // Taut springs to points that lie mostly below the surface.
        let ends: [_; 3] = std::array::from_fn(|_| {
            place(&ground, random.between(-0.4, 0.1), vec3::add(foot, random.vector(0.3)))
        });
        let mut pos = [foot, ends[0], ends[1], ends[2]];
        settle(&hung(&springs), &ground, &mut pos, &mut [[0.0; 3]; 4]);
        let (force, gap) = (pull(&springs, &pos), ground.gap(pos[0]));
        let side = vec3::tangential(force, ground.normal);
        let push = -vec3::dot(force, ground.normal);
        let way = vec3::tangential(vec3::sub(pos[0], foot), ground.normal);
        if gap > 1e-9 {
            assert!(vec3::norm(force) < 1e-7, "apart, the springs balance: {force:?}");
            met[0] += 1;
        } else if vec3::norm(way) < 1e-12 {
            assert!(gap.abs() < 1e-12 && push >= 0.0, "{gap} {push}");
            assert!(vec3::norm(side) <= friction * push * (1.0 + 1e-9), "stuck outside of the cone");
            met[1] += 1;
        } else {
            assert!(gap.abs() < 1e-12 && push >= 0.0, "{gap} {push}");
            let (along, _) = vec3::direction(way);
            let off = vec3::norm(vec3::axpy(side, -friction * push, along));
            assert!(off < 1e-6, "slid: friction holds what the springs pull, against the way: {off}");
            met[2] += 1;
        }
    }
    assert!(met.iter().all(|&n| n > 500), "apart, stuck, slid: {met:?}");
}

#[test]
fn friction_takes_force_times_way_on_the_ground_alone() {
    let mut random = Random::new(72);
    let ground = tilted(&mut random, 0.4);
    let body =
        Body { massless: Massless { points: &[0, 1], first: &[0, 0, 0], springs: &[] }, ..Body::none() };
    for _ in 0..100 {
        let [from, way, force] = [0.1, 0.2, 10.0].map(|size| random.vector(size));
        let way = vec3::tangential(way, ground.normal);
        let work = vec3::dot(force, way);
        let [x0, up] = [0.0, 0.01].map(|height| place(&ground, height, from));
        let loss = |from, to| {
            // The second point stands; the first is led by a force that is the mean of two.
            let places = [[from, from], [vec3::add(to, way), from]];
            let forces = [vec3::scale(force, 0.5), vec3::scale(force, 1.5)].map(|f| [f, f]);
            friction_loss(&body, &ground, [&places[0], &places[1]], [&forces[0], &forces[1]])
        };
        assert!((loss(x0, x0) - work.max(0.0)).abs() < 1e-12, "a force against the way is not friction's");
        assert_eq!([loss(up, x0), loss(x0, up), loss(up, up)], [0.0; 3], "above the ground there is none");
    }
}
