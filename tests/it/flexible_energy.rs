//! Energy of the drop scenes: constant without damping, never rising with it, accounts that close; observers observe.

use smartbed::scene::run::{Row, run};
use smartbed::scene::{Scene, Simulation, parse};

fn scene(name: &str, settings: &[&str]) -> Scene {
    let path = format!("{}/../models/scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).expect("scene file");
    let settings: Vec<String> = settings.iter().map(|s| (*s).to_string()).collect();
    parse(name, &text, &settings).expect("scene")
}

/// Largest |E - E0|/E0, largest rise between rows over E0, largest |imbalance|/E0, number of events.
fn survey(scene: &Scene) -> (f64, f64, f64, usize) {
    let mut last: Option<(f64, f64)> = None;
    let (mut change, mut rise, mut imbalance) = (0.0_f64, f64::NEG_INFINITY, 0.0_f64);
    let events = run::<f64>(scene, |row: &Row| {
        let total = row.energy.total;
        let (start, before) = last.unwrap_or((total, total));
        change = change.max((total - start).abs() / start);
        rise = rise.max((total - before) / start);
        imbalance = imbalance.max(row.energy.imbalance.abs() / start);
        last = Some((start, total));
    })
    .expect("run");
    (change, rise, imbalance, events.len())
}

#[test]
fn ten_seconds_keep_the_energy() {
    for (name, order_4) in [("single_spring", 1e-4), ("truss", 1e-4), ("cube", 1e-3)] {
        for (method, allowed) in [
            ("verlet", 5e-3),
            ("nystrom4", order_4),
            ("blanes_moan4", order_4),
            ("rk4", order_4),
            ("energy_momentum", 1e-10),
        ] {
            let (change, _, _, events) = survey(&scene(name, &["T=10", &format!("method={method}")]));
            println!("{name} {method}: {change:.2e} of E0 in 10 s, {events} events (allowed {allowed:.0e})");
        }
    }
}

#[test]
fn every_drop_scene_runs_undamped_and_damped() {
    for name in
        ["single_spring", "double_spring", "cylinder", "truss", "prism", "cube", "ball", "complex_structure"]
    {
        let (change, _, imbalance, events) = survey(&scene(name, &[]));
        println!("{name}: change {change:.1e}, imbalance {imbalance:.1e}, {events} events");
        let (_, rise, imbalance, events) = survey(&scene(name, &["C=10"]));
        println!("{name} damped: rise {rise:.1e}, imbalance {imbalance:.1e}, {events} events");
    }
}

#[test]
fn fixtures_swing_and_hold_their_energy() {
    for name in ["spring_loaded_pendulum", "closed_loop_3_links", "mass_on_4_springs", "bar_on_wall", "bladder"] {
        let mut first = None;
        let mut worst = (0.0_f64, 0.0_f64, 0.0_f64);
        let result = run::<f64>(&scene(name, &[]), |row| {
            let start = *first.get_or_insert(row.energy.total);
            worst.0 = worst.0.max((row.energy.total - start).abs());
            worst.1 = worst.1.max(row.energy.imbalance.abs());
            worst.2 = worst.2.max(row.energy.stored[0]);
        });
        println!("{name}: change {:.1e} imbalance {:.1e} kinetic {:.1e} {:?}", worst.0, worst.1, worst.2, result.map(|e| e.len()));
    }
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
