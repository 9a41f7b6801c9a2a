//! Heaps and stacks of rigid bodies, as they are thrown: no energy is gained, nothing passes through.

use crate::random::Random;
use crate::rigid_scene::{World, ball, close, cuboid, depth, stronge};
use smartbed_runtime::rigid::attitude::Attitude;
use smartbed_runtime::rigid::scene::Part;
use smartbed_runtime::rigid::{RigidBody, RigidState};
use smartbed_runtime::surface::{Capsule, Shape};

/// Heaps of balls, boxes and rods thrown on the ground; `SMARTBED_HEAPS` for another number of them.
#[test]
fn heaps_thrown_together_gain_no_energy_and_do_not_pass_through_one_another() {
    let wanted = std::env::var("SMARTBED_HEAPS").ok().and_then(|n| n.parse().ok());
    let mut random = Random::new(77);
    let (mut impulsive, mut forced, mut steps, mut deepest, mut gained) = (0, 0, 0, 0.0_f64, 0.0_f64);
    let heaps: u32 = wanted.unwrap_or(10);
    for heap in 0..heaps {
        let law = stronge(random.between(-0.2, 0.9).max(0.0), random.between(-0.1, 1.0).max(0.0));
        let mut bodies = Vec::new();
        for k in 0..3 {
            let size = random.between(0.1, 0.3);
            let mass = random.between(0.5, 3.0);
            let part = match (random.between(0.0, 3.0) as usize).min(2) {
                0 => ball(mass, size),
                1 => cuboid(mass, [size, 0.7 * size, 0.5 * size]),
                _ => {
                    let (radius, half_length) = (0.4 * size, size);
                    let across = mass * (half_length * half_length / 3.0 + 0.25 * radius * radius);
                    let body = RigidBody { mass, inertia: [across, across, 0.5 * mass * radius * radius] };
                    Part { shape: Shape::Capsule(Capsule { radius, half_length }), body: Some(body) }
                }
            };
            let [a, b, c] = random.vector(1.0);
            let attitude = Attitude::new([1.1 - a, a, b, c]);
            let [x, y, _] = random.vector(0.15);
            let position = [x, y, 0.6 + 0.8 * f64::from(k)];
            let velocity = random.vector(1.0);
            let angular_momentum = random.vector(0.02 * mass);
            bodies.push((part, RigidState { position, velocity, attitude, angular_momentum }));
        }
        let mut world = World::new(0.0, law, &bodies);
        let start = world.energy();
        for _ in 0..300 {
            let before = world.energy();
            let report = world.step(5e-3);
            steps += 1;
            forced += u32::from(report.forced);
            impulsive += u32::from(report.impulsive);
            gained = gained.max((world.energy() - before) / start);
            assert!(
                world.energy() <= before + 1e-3 * start,
                "{heap}: {before} {} {report:?}",
                world.energy()
            );
            deepest = deepest.max(depth(&world));
        }
    }
    println!(
        "{steps} steps: energy gained {gained:.1e} of all in one, depth {deepest:.1e} m, forced {forced}, impulsive {impulsive}"
    );
    assert!(deepest <= 1e-3 && forced * 100 <= steps && impulsive * 100 <= steps);
}

#[test]
fn stacks_with_much_friction_go_on_without_gaining_energy() {
    // Three boxes with mu = 3, the upper one pushed: at 22 and 94 ms no forces of the redundant contacts were found.
    let stacks = [
        (
            0.3,
            [
                [0.012, 0.018, 0.992808636, 0.119712207, 0.0, 0.0],
                [0.017, -0.019, 0.992808636, 0.119712207, 0.0, 0.0],
                [0.018, 0.006, 0.999887502, -0.014999438, 1.6, -1.5],
            ],
            0.05,
        ),
        (
            0.0,
            [
                [-0.01, -0.02, 0.9999875, -0.004999979, 0.0, 0.0],
                [-0.001, 0.01, 0.996801706, 0.079914694, 0.0, 0.0],
                [0.011, -0.009, 0.997888244, -0.064954239, 1.2, 0.9],
            ],
            0.12,
        ),
    ];
    let mut impulsive = 0;
    for (e, boxes, seconds) in stacks {
        let bodies = [0, 1, 2].map(|k| {
            let ([x, y, c, s, vx, vy], side) = (boxes[k], 0.15 - 0.025 * k as f64);
            let attitude = Attitude::new([c, 0.0, 0.0, s]);
            let start = RigidState::at_rest([x, y, 0.05 + 0.1 * k as f64]);
            let state = RigidState { attitude, velocity: [vx, vy, 0.0], ..start };
            (cuboid(3.0 - k as f64, [side, side, 0.05]), state)
        });
        let mut world = World::new(0.0, stronge(e, 3.0), &bodies);
        world.room = 256;
        for _ in 0..(seconds / 2e-3) as usize {
            let before = world.energy();
            let report = world.step(2e-3);
            impulsive += u32::from(report.impulsive);
            let lost = report.impact_loss + report.friction_loss;
            assert!(world.energy() <= before + 1e-5, "{e}: {before} {} {report:?}", world.energy());
            close(before - world.energy(), lost, 0.02);
        }
        assert!(depth(&world) <= 1e-4, "{e}: {}", depth(&world));
    }
    assert!(impulsive > 0, "none was needed");
}
