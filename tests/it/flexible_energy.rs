//! Energy of the drop scenes: constant without damping, never rising with it, accounts that close; a ledger that
//! changes nothing.

use smartbed::scene::run::{Row, run};
use smartbed::scene::{Scene, Simulation, parse};

fn scene(name: &str, settings: &[&str]) -> Scene {
    let path = format!("{}/../models/scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).expect("scene file");
    let settings: Vec<String> = settings.iter().map(|s| (*s).to_string()).collect();
    parse(name, &text, &settings).expect("scene")
}

/// Changes of the total energy in a run, relative to E0.
struct Survey {
    /// Largest change at any row.
    change: f64,
    /// Mean change over the last second.
    drift: f64,
    /// Largest rise from one row to the next.
    rise: f64,
    /// Largest imbalance of the ledger.
    imbalance: f64,
}

fn survey(scene: &Scene) -> Survey {
    let mut last: Option<(f64, f64)> = None;
    let (mut sum, mut count) = (0.0, 0);
    let mut found = Survey { change: 0.0, drift: 0.0, rise: f64::NEG_INFINITY, imbalance: 0.0 };
    run::<f64>(scene, |row: &Row| {
        let total = row.energy.total;
        let (start, before) = last.unwrap_or((total, total));
        found.change = found.change.max((total - start).abs() / start);
        found.rise = found.rise.max((total - before) / start);
        found.imbalance = found.imbalance.max(row.energy.imbalance.abs() / start);
        if row.t > scene.seconds - 1.0 {
            (sum, count) = (sum + (total - start) / start, count + 1);
        }
        last = Some((start, total));
    })
    .expect("run");
    found.drift = sum / f64::from(count.max(1));
    found
}

/// The energy tested is the physical one, m v^2/2 + m g z + K s^2/2 with positions and speeds at the same
/// time: no modified energy, no mean.
#[test]
fn ten_seconds_keep_the_energy() {
    for (name, order_4) in [("single_spring", 1e-4), ("truss", 1e-4), ("cube", 1e-3)] {
        // (method, settings, allowed change at any row, allowed mean change over the last second).
        // All but the symplectic and the energy-momentum method anchor themselves to the ledger at each touch;
        // without that every touch of a vibrating body adds to Verlet's energy.
        // Its energy then swings by (w h)^2/8 of the vibration's: 0.4 % for the cube.
        for (method, anchor, change, drift) in [
            ("verlet", "", 5e-3, 5e-4),
            ("verlet", "anchor=false", 1e-2, 5e-3),
            ("nystrom4", "", order_4, order_4),
            ("blanes_moan4", "", 1e-7, 1e-7),
            ("rk4", "", order_4, order_4),
            ("energy_momentum", "", 1e-12, 1e-12),
        ] {
            let method_setting = format!("method={method}");
            let settings = ["T=10", &method_setting, anchor];
            let settings: Vec<&str> = settings.into_iter().filter(|s| !s.is_empty()).collect();
            let found = survey(&scene(name, &settings));
            println!("{name} {method} {anchor}: change {:.2e}, drift {:.2e}", found.change, found.drift);
            assert!(found.change <= change, "{name} {method} {anchor}: {:e}", found.change);
            assert!(found.drift.abs() <= drift, "{name} {method} {anchor}: {:e}", found.drift);
        }
    }
}

/// The classical method of order 4 damps: a vibration loses the part (w h)^6/72 of its energy in a step, whatever
/// happens at events. The anchor of the ledger gives it back.
#[test]
fn rk4_without_anchor_loses_what_its_polynomial_says() {
    for name in ["single_spring", "truss", "cube"] {
        let scene = scene(name, &["T=10", "method=rk4", "anchor=false"]);
        let found = survey(&scene);
        let stiffest = 2.0 / scene.largest_step.expect("springs");
        let per_step = (stiffest * scene.step).powi(6) / 72.0;
        let all_in_stiffest = 1.0 - (1.0 - per_step).powf(scene.seconds / scene.step);
        println!("{name} rk4: change {:.2e}, at most {all_in_stiffest:.2e}", found.change);
        assert!(found.change <= all_in_stiffest, "{name}: {:e}", found.change);
        assert!(found.drift < 0.0, "{name}: a gain of {:e}", found.drift);
    }
}

/// The energy-momentum method, in which the work of the forces equals the change of the stored energies to rounding.
const KEEPS: &str = "method=energy_momentum";
/// Energies are sums of some hundred terms of the size of E0.
const ROUNDING: f64 = 1e-12;

#[test]
fn drop_scenes_keep_their_energy_and_damped_ones_never_gain() {
    for name in [
        "single_spring",
        "double_spring",
        "cylinder",
        "truss",
        "prism",
        "cube",
        "ball",
        "complex_structure",
        "centre_masses",
    ] {
        let found = survey(&scene(name, &[KEEPS]));
        println!("{name}: change {:.1e}", found.change);
        assert!(found.change <= ROUNDING && found.imbalance <= ROUNDING, "{name}: {:e}", found.change);
        let found = survey(&scene(name, &[KEEPS, "C=10"]));
        println!("{name} damped: rise {:.1e}, imbalance {:.1e}", found.rise, found.imbalance);
        assert!(found.rise <= ROUNDING, "{name}: rise {:e}", found.rise);
        // The accounts integrate the dampers' power; the method's own quadrature differs in order h^2.
        assert!(found.imbalance <= 2e-3, "{name}: imbalance {:e}", found.imbalance);
    }
}

/// Four cubes of unit masses fall flat at speed 1, nine corners touch at once (thesis 5.9; Eqs. 4.10 to 4.12 by hand):
/// a centre gets D = 4/3 from its four corners; of these the outermost get 1/3 (-1, -1), those between two cubes 2/3
/// along the outer edge's normal, the middle one nothing. A = 44/9, b = -16/3, Q = 9/2.
#[test]
fn centres_alone_take_the_energy_of_corners() {
    let settings = ["g=0", "initial_velocity=[0,0,-1]", "drop_height=1e-4", "K=1e-9", "T=1e-3"];
    let end = |name: &str| {
        let mut last = None;
        run::<f64>(&scene(name, &settings), |row| last = Some(row.clone())).expect("run");
        last.expect("a row")
    };
    let row = end("centre_masses");
    let (a, b, q) = (44.0 / 9.0, -16.0 / 3.0, 4.5);
    let lambda = (-b - f64::sqrt(b * b + 4.0 * a * q)) / (2.0 * a);
    let mut off = 0.0_f64;
    let mut is = |found: f64, expected: f64| off = off.max((found - expected).abs());
    for (i, (x, v)) in row.pos.iter().zip(&row.vel).enumerate() {
        // Corners of three rows and columns in two storeys, then the centres.
        let side = |c: f64| (c - 1.0).round();
        let expected = match i {
            0..9 => [
                lambda / 3.0 * side(x[0]) * (2.0 - side(x[1]).abs()),
                lambda / 3.0 * side(x[1]) * (2.0 - side(x[0]).abs()),
                0.0,
            ],
            9..18 => [0.0, 0.0, -1.0],
            _ => [0.0, 0.0, -1.0 + 4.0 / 3.0 * lambda],
        };
        (0..3).for_each(|c| is(v[c], expected[c]));
    }
    println!("off by {off:e} of the speed");
    assert!(row.pos.len() == 22 && off < 1e-9, "{off:e}");
    // With all neighbours as receivers the upper corners take their share.
    let upper = end("complex_structure").vel[9][2];
    assert!(upper < -1.01, "{upper}");
}

#[test]
fn accounts_close_with_the_order_of_the_method() {
    let imbalance = |step: &str| survey(&scene("truss", &["C=10", "method=rk4", step])).imbalance;
    let (coarse, fine) = (imbalance("step=1e-3"), imbalance("step=1e-4"));
    println!("damped truss, rk4: imbalance {coarse:.1e} at 1 ms, {fine:.1e} at 0.1 ms");
    assert!(fine <= 1e-9 && coarse / fine >= 10.0_f64.powf(3.5));
}

#[test]
fn hung_and_held_scenes_keep_their_energy() {
    for (name, allowed) in
        [("spring_loaded_pendulum", 1e-12), ("closed_loop_3_links", 1e-11), ("mass_on_4_springs", 1e-12)]
    {
        let mut first = None;
        let mut worst = 0.0_f64;
        run::<f64>(&scene(name, &[KEEPS]), |row| {
            let start = *first.get_or_insert(row.energy.total);
            worst = worst.max((row.energy.total - start).abs());
        })
        .expect("run");
        assert!(worst <= allowed, "{name}: {worst:e} J");
        let (mut before, mut rise) = (f64::INFINITY, 0.0_f64);
        run::<f64>(&scene(name, &[KEEPS, "C=10"]), |row| {
            rise = rise.max(row.energy.total - before);
            before = row.energy.total;
        })
        .expect("run");
        assert!(rise <= ROUNDING, "{name} damped: rise {rise:e} J");
    }
    let mut worst = 0.0_f64;
    run::<f64>(&scene("bladder", &["T=0.5"]), |row| worst = worst.max(row.energy.imbalance.abs()))
        .expect("run");
    // Of about 1 kJ that the pressure puts in.
    assert!(worst <= 1e-4, "bladder: {worst:e} J");
}

#[test]
fn the_ledger_changes_no_bit() {
    for settings in [&["C=0"][..], &["C=10", "mu=0.3"], &["law=newton", "e=0.5"]] {
        let scene = scene("cube", settings);
        let mut watched = Vec::new();
        run::<f64>(&scene, |row| watched.push(row.pos.clone())).expect("run");
        let mut bare = Simulation::<f64>::new(&scene.lists, &scene.around, scene.method).expect("scene");
        bare.begin(scene.step, &mut ()).expect("begin");
        for row in &watched[1..] {
            bare.step(scene.step, &mut ()).expect("step");
            assert_eq!(bare.pos(), row.as_slice());
        }
    }
}
