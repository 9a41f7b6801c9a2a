//! Worlds stepped with mean forces: energy and both momenta are conserved to rounding for every kind of part; order 2.

use crate::scenery::{Law, Part, Scene};
use smartbed_runtime::gas::{Chamber, Gas, GasState};
use smartbed_runtime::ode::Method;
use smartbed_runtime::surface::Frame;
use smartbed_runtime::vec3::{self, Vec3};
use smartbed_runtime::world::{Commanded, Content};

/// A ball falls 20 mm onto a bladder without dampers: the ledger's error, and the largest mean force over 10 ms.
fn drop(h: f64, friction: f64, restitution: f64) -> (f64, f64, f64) {
    let mut scene = Scene { room: 600, ..Scene::falling() };
    let sheet = scene.bladder(13, 0.4, 1500.0, None);
    scene.springs.iter_mut().for_each(|spring| spring.damping = 0.0);
    let ball = scene.ball(5.0, 0.1, [0.0, 0.0, 0.12], [0.1, 0.0, 0.0]);
    scene.pair(sheet, ball, friction, restitution);
    let (window, mut forces) = ((0.01 / h).round() as usize, Vec::new());
    let (_, imbalance, accounts) = scene.run_conserving((h, (0.12 / h).round() as u32), |_, contacts, _| {
        let up = contacts.iter().map(|touch| -touch.contact.to_inertial(touch.contact.impulse)[2] / h);
        forces.push(up.sum::<f64>());
    });
    let mean = |at: &[f64]| at.iter().sum::<f64>() / window as f64;
    let peak = forces.windows(window).map(mean).fold(0.0, f64::max);
    println!("h = {h}: ledger {imbalance:e} of {accounts:?}, peak {peak} N");
    (imbalance, peak, accounts.impact)
}

#[test]
fn a_drop_of_20_mm_without_dampers_closes_its_ledger_to_rounding_at_any_step() {
    let weight = 5.0 * 9.81 * 0.02;
    let runs = [2e-4, 1e-4, 5e-5].map(|h| drop(h, 0.4, 0.0));
    for (imbalance, ..) in runs {
        assert!(imbalance.abs() < 1e-9 * weight, "{imbalance:e}");
    }
    let [_, (_, coarse, _), (_, fine, _)] = runs;
    assert!((fine / coarse - 1.0).abs() < 0.02, "{coarse} {fine}");
    assert!(runs[2].2 > 0.0);
}

#[test]
fn nodes_that_bounce_back_lose_nothing_to_the_ball() {
    let (imbalance, _, impact) = drop(1e-4, 0.0, 1.0);
    assert!(imbalance.abs() < 1e-9, "{imbalance:e}");
    assert!(impact.abs() < 0.05, "{impact:e}");
}

#[test]
fn a_torque_free_body_keeps_energy_and_angular_momentum_by_steps_of_any_size() {
    for h in [1e-3, 0.05, 0.4] {
        let mut scene = Scene::default();
        scene.body([0.1, 0.0, 0.2, 0.01, 0.2, 0.03]);
        let mut worst = 0.0_f64;
        let (x, imbalance, _) = scene.run_conserving((h, 100_000), |_, _, x| {
            worst = worst.max((vec3::norm([x[3], x[4], x[5]]).powi(2) + x[6] * x[6] - 1.0).abs());
        });
        println!("h = {h}: energy moves by {imbalance:e}, parameters off by {worst:e}");
        assert!(imbalance.abs() < 1e-12 && worst < 1e-10);
        assert_eq!(x[10..], [0.01, 0.2, 0.03]);
    }
}

#[test]
fn a_tumbling_body_is_followed_to_order_two() {
    let run = |steps: u32, exact: bool| {
        let mut scene = Scene::default();
        scene.body([0.1, 0.0, 0.2, 0.01, 0.2, 0.03]);
        let h = 1.0 / f64::from(steps);
        if !exact {
            return scene.run_conserving((h, steps), |_, _, _| {}).0;
        }
        let method = Method::Rk4;
        let mut scratch = vec![0.0; method.scratch(13)];
        let advanced = scene.with(|world, state, _| {
            for n in 0..steps {
                method.step(&mut world.island, f64::from(n) * h, h, state, &mut scratch).expect("a step");
            }
        });
        advanced.0
    };
    let truth = run(4000, true);
    let off = |steps| {
        let x = run(steps, false);
        x.iter().zip(&truth).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    let [coarse, fine] = [off(100), off(200)];
    println!("off by {coarse:e}, {fine:e}");
    assert!((coarse / fine - 4.0).abs() < 0.1 && fine < 1e-3);
}

/// A bladder with sealed gas on a floating body, and a ball that flies into it.
fn floating(damping: f64, air_drag: f64) -> Scene {
    let mut scene = Scene { air_drag, ..Scene::floating_bladder() };
    scene.springs.iter_mut().for_each(|spring| spring.damping = damping);
    let chamber = Chamber { gas: Gas::air(), exponent: 1.4, ambient: 101_325.0, reference_volume: 0.0027 };
    let state = GasState { reference_pressure: 101_825.0, mass: 0.0033 };
    scene.cells[0].content = Content::Sealed { chamber, state };
    scene
}

#[test]
fn what_floats_keeps_energy_and_both_momenta_with_friction_and_attached_nodes() {
    // Gas pushes by a mean that follows volumes: angular momentum stays to the order of the method with it.
    for (gas, bound) in [(false, 1e-12), (true, 1e-8)] {
        let mut scene = floating(0.0, 0.0);
        scene.cells.truncate(usize::from(gas));
        let [momentum, angular] = collide(scene);
        assert!(momentum < 1e-12 && angular < bound, "{momentum:e} {angular:e}");
    }
}

/// Flies the ball into the bladder; returns by how much momentum and angular momentum move, of the sums of sizes.
fn collide(mut scene: Scene) -> [f64; 2] {
    let (mut drift, mut hit) = (scene.drift(), 0);
    let (_, imbalance, accounts) = scene.run_conserving((2e-4, 2000), |report, _, x| {
        hit += report.active;
        drift.see(x);
    });
    let moved = drift.moved;
    println!("{hit} contacts, momenta move by {moved:?}, ledger {imbalance:e} of {accounts:?}");
    assert!(hit > 50 && accounts.friction > 0.0);
    assert!(imbalance.abs() < 1e-10);
    moved
}

#[test]
fn dampers_and_air_take_what_the_account_says() {
    let (_, imbalance, accounts) = floating(1.0, 0.1).run_conserving((2e-4, 2000), |_, _, _| {});
    println!("ledger {imbalance:e} of {accounts:?}");
    assert!(accounts.damping > 1e-3 && accounts.drag > 1e-3);
    assert!(imbalance.abs() < 1e-10, "{imbalance:e}");
}

fn shaken(t: f64, _: usize) -> Frame<f64> {
    let (a, w) = (0.3 * (4.0 * t).sin(), 1.2 * (4.0 * t).cos());
    let axes: [Vec3<f64>; 3] = [[a.cos(), 0.0, -a.sin()], [0.0, 1.0, 0.0], [a.sin(), 0.0, a.cos()]];
    let (origin, velocity) = ([0.0, 0.0, 0.05 * (6.0 * t).sin()], [0.0, 0.0, 0.3 * (6.0 * t).cos()]);
    Frame { origin, axes, velocity, angular_velocity: [0.0, w, 0.0] }
}

#[test]
fn the_work_of_a_commanded_frame_is_booked_to_rounding() {
    let mut scene = Scene { room: 200, ..Scene::falling() };
    scene.parts.push(Part::Driven(Commanded { law: shaken as Law, ports: 1 }));
    let sheet = scene.bladder(7, 0.4, 500.0, Some(0));
    let ball = scene.ball(1.0, 0.1, [0.02, 0.03, 0.13], [0.0; 3]);
    scene.pair(sheet, ball, 0.4, 0.0);
    let (_, imbalance, accounts) = scene.run_conserving((2e-4, 2000), |_, _, _| {});
    println!("ledger {imbalance:e} of {accounts:?}");
    assert!(accounts.drive.abs() > 1e-2 && accounts.damping > 1e-3);
    assert!(imbalance.abs() < 1e-9, "{imbalance:e}");
}
