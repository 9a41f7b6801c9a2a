//! Rods on the ground against closed forms and independent computations: falling over, sticking, turning back, jamming.

use crate::random::Random;
use crate::rigid_scene::{G, World, close, depth, stronge};
use smartbed_runtime::rigid::attitude::Attitude;
use smartbed_runtime::rigid::impact::{Touch, resolve};
use smartbed_runtime::rigid::scene::Part;
use smartbed_runtime::rigid::{RigidBody, RigidState};
use smartbed_runtime::surface::{Capsule, Shape};

/// A rod that stands at an angle on a frictionless or rough ground and falls over.
fn falling_rod(mu: f64, h: f64, seconds: f64) -> (World, f64) {
    let (radius, half, mass) = (0.02, 0.5, 1.0);
    let angle = 0.4_f64;
    let across = mass * half * half / 3.0;
    let body = RigidBody { mass, inertia: [across, across, 1e-3] };
    let part = Part { shape: Shape::Capsule(Capsule { radius, half_length: half }), body: Some(body) };
    let attitude = Attitude::new([(0.5 * angle).cos(), 0.0, (0.5 * angle).sin(), 0.0]);
    let state = RigidState { attitude, ..RigidState::at_rest([0.0, 0.0, radius + half * angle.cos()]) };
    let mut world = World::new(0.0, stronge(0.0, mu), &[(part, state)]);
    let steps = (seconds / h).round() as usize;
    let mut friction = 0.0;
    for _ in 0..steps {
        let report = world.step(h);
        assert_eq!(report.impacts, 0);
        friction += report.friction_loss;
    }
    (world, friction)
}

#[test]
fn a_falling_rod_is_followed_to_second_order_with_its_foot_on_the_ground() {
    // Without friction: the mass centre falls straight, and energy stays.
    for mu in [0.0, 5.0] {
        let at = |h: f64| falling_rod(mu, h, 0.3).0.states[1].position[2];
        let (a, b, c) = (at(1e-2), at(5e-3), at(2.5e-3));
        let order = ((a - b) / (b - c)).abs().log2();
        assert!(order > 1.7, "mu = {mu}: order {order}");
        let (world, friction) = falling_rod(mu, 1e-3, 0.3);
        let start = falling_rod(mu, 1e-3, 0.0).0.energy();
        close(world.energy() + friction, start, 2e-5);
        if mu == 0.0 {
            close(world.states[1].position[0], 0.0, 1e-12);
        }
    }
    // Energy by quadrature-free closed form: w^2 (J + m l^2 sin^2)/2 = m g l (cos - cos), l half the length.
    let (world, _) = falling_rod(0.0, 2.5e-4, 0.3);
    let state = world.states[1];
    let cos = (state.position[2] - 0.02) / 0.5;
    let (sin2, across) = (1.0 - cos * cos, 0.25 / 3.0);
    let rate = state.angular_momentum[1] / across;
    let exact = (2.0 * G * 0.5 * (0.4_f64.cos() - cos) / (across + 0.25 * sin2)).sqrt();
    close(rate, exact, 1e-5);
}

#[test]
fn a_rod_falls_on_rough_ground_and_sticks_or_turns_back() {
    let mut random = Random::new(9);
    let (mut stuck, mut reversed) = (0, 0);
    for _ in 0..200 {
        let (radius, half, mass) = (0.01, random.between(0.1, 0.6), random.between(0.2, 3.0));
        let angle = random.between(-1.4, 1.4);
        let (mu, e) = (random.between(0.05, 1.5), random.between(0.0, 1.0));
        let (along, drop) = (random.between(-2.0, 2.0), random.between(0.05, 0.5));
        let across = mass * half * half / 3.0;
        let body = RigidBody { mass, inertia: [across, across, 1e-2 * across] };
        let part = Part { shape: Shape::Capsule(Capsule { radius, half_length: half }), body: Some(body) };
        let attitude = Attitude::new([(0.5 * angle).cos(), 0.0, (0.5 * angle).sin(), 0.0]);
        let position = [0.0, 0.0, drop + radius + half * angle.cos()];
        let state = RigidState { attitude, velocity: [along, 0.0, 0.0], ..RigidState::at_rest(position) };
        let mut world = World::new(0.0, stronge(e, mu), &[(part, state)]);
        let fall = (2.0 * drop / G).sqrt();
        // The lower end's point from the centre; the plane of the fall is x, z.
        let (x, y) = (-half * angle.sin(), -half * angle.cos() - radius);
        // K of the plane with normal z and tangent x: the test of `resolve` holds this impact to the planar solution.
        let touch = Touch {
            inverse_mass: [
                [1.0 / mass + x * x / across, -x * y / across, 0.0],
                [-x * y / across, 1.0 / mass + y * y / across, 0.0],
                [0.0, 0.0, 1.0 / mass],
            ],
            velocity: [-G * fall, along, 0.0],
            friction: mu,
            restitution: e,
        };
        let [normal, tangent, _] = resolve(&touch).impulse;
        // One step over the impact, and so little beyond it that nothing touches again.
        let beyond = 1e-4 * (normal / mass) / G;
        let report = world.step(fall + beyond);
        assert_eq!(report.impacts, 1);
        let after = world.states[1];
        close(after.velocity[0], along + tangent / mass, 1e-12 * 10.0);
        close(after.velocity[2], -G * (fall + beyond) + normal / mass, 1e-12 * 10.0);
        // The moment about y of the impulse at (x, y): z x_arm - x z_arm.
        close(after.angular_momentum[1], y * tangent - x * normal, 1e-12 * 10.0);
        let slip = along + touch.inverse_mass[1][0] * normal + touch.inverse_mass[1][1] * tangent;
        stuck += usize::from(slip.abs() <= 1e-12);
        reversed += usize::from(slip * along < -1e-12);
    }
    assert!(stuck > 20 && reversed > 5, "{stuck} stuck, {reversed} reversed");
}

/// A rod of 1 m and 1 kg at 60 degrees whose lower tip slides ahead with 1 m/s: with mu = 2 every normal force would
/// press the tip together, and none holds it (Painleve).
fn pushed_rod() -> World {
    let (radius, half, angle) = (0.01, 0.5, core::f64::consts::FRAC_PI_6);
    let across = half * half / 3.0;
    let body = RigidBody { mass: 1.0, inertia: [across, across, 1e-2 * across] };
    let part = Part { shape: Shape::Capsule(Capsule { radius, half_length: half }), body: Some(body) };
    let attitude = Attitude::new([(0.5 * angle).cos(), 0.0, -(0.5 * angle).sin(), 0.0]);
    let position = [0.0, 0.0, radius + half * angle.cos()];
    let state = RigidState { attitude, velocity: [1.0, 0.0, 0.0], ..RigidState::at_rest(position) };
    World::new(0.0, stronge(0.0, 2.0), &[(part, state)])
}

#[test]
fn a_rod_that_friction_jams_sticks_at_once() {
    // An impact without collision stops the tip: K P = -v.
    let (radius, half, angle) = (0.01, 0.5, core::f64::consts::FRAC_PI_6);
    let [x, z] = [half * angle.sin(), -(half * angle.cos() + radius)];
    let j = 3.0 / (half * half);
    let [a, b, c] = [1.0 + j * x * x, -j * x * z, 1.0 + j * z * z];
    // Normal and tangential impulse for v = [0, 1].
    let det = a * c - b * b;
    let [p, q] = [b / det, -a / det];
    assert!(p > 0.0 && -q < 2.0 * p && a - 2.0 * b < 0.0, "it jams, and sticks");
    let spin = j * (z * q - x * p);
    let errors = [1e-3, 1e-4].map(|h| {
        let mut world = pushed_rod();
        let before = world.energy();
        let report = world.step(h);
        assert!(report.impulsive && report.held == 1 && !report.forced, "{report:?}");
        let lost = before - world.energy();
        close(lost, report.impact_loss + report.friction_loss, 2.0 * h);
        close(lost, -0.5 * q, 10.0 * h);
        let state = world.states[1];
        let turning = world.parts[1].body.expect("a body").angular_velocity(&state)[1];
        let off = [state.velocity[0] - (1.0 + q), state.velocity[2] - p, turning - spin];
        off.map(f64::abs).into_iter().fold(0.0, f64::max)
    });
    assert!(errors[0] < 0.05 && errors[1] < 0.12 * errors[0], "of order 1: {errors:?}");
    // It goes on as a pendulum that falls over its tip.
    let mut world = pushed_rod();
    for _ in 0..300 {
        let before = world.energy();
        world.step(1e-3);
        assert!(world.energy() <= before + 1e-6 && depth(&world) <= 1e-6);
    }
}
