//! Drop scenes against trajectories computed in 80-bit arithmetic: end errors, orders, event times.
//!
//! Norm: largest component of position at the end. Each sample states how far two independent integrations
//! agree; it is used to that digit only.

use serde_json::Value;
use smartbed::scene::run::{EventRecord, Row, run};
use smartbed::scene::{Scene, Simulation, parse};

const CASES: [&str; 4] = ["single_spring", "single_spring_damped", "double_spring", "truss_damped"];

fn text(name: &str) -> String {
    let path = format!("{}/reference/{name}.json", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(path).expect("reference file")
}

fn reference(name: &str) -> Value {
    serde_json::from_str(&text(name)).expect("reference is JSON")
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("list").iter().map(|x| x.as_f64().expect("number")).collect()
}

fn scene(name: &str, method: &str, step: f64) -> Scene {
    let mut settings = vec![format!("method={method}"), format!("step={step:e}")];
    if ["dormand_prince", "dop853"].contains(&method) {
        settings.push("tolerance=1e-12".to_string());
    }
    parse(&format!("{name}.json"), &text(name), &settings).expect("scene")
}

fn rows(scene: &Scene) -> (Vec<Row>, Vec<EventRecord>) {
    let mut rows = Vec::new();
    let events = run::<f64>(scene, |row| rows.push(row.clone())).expect("run");
    (rows, events)
}

fn position_error(row: &Row, state: &[f64]) -> f64 {
    row.pos.iter().flatten().zip(state).map(|(x, r)| (x - r).abs()).fold(0.0, f64::max)
}

fn end_error(name: &str, method: &str, step: f64) -> f64 {
    let reference = reference(name);
    let states = reference["states"].as_array().expect("states");
    let (rows, _) = rows(&scene(name, method, step));
    position_error(rows.last().expect("a row"), &numbers(&states[states.len() - 1]))
}

#[test]
fn verlet_split_meets_its_end_errors() {
    let coarse = end_error("single_spring", "verlet", 1e-3);
    let fine = end_error("single_spring", "verlet", 1e-4);
    println!("single_spring verlet: {coarse:.3e} at 1 ms, {fine:.3e} at 0.1 ms");
    assert!(coarse <= 2.5e-3 && fine <= 3e-5);
}

/// Slope of log error over log step by least squares.
fn observed_order(name: &str, method: &str, steps: &[f64]) -> f64 {
    let points: Vec<(f64, f64)> = steps.iter().map(|h| (h.ln(), end_error(name, method, *h).ln())).collect();
    let n = points.len() as f64;
    let (mx, my) = (points.iter().map(|p| p.0).sum::<f64>() / n, points.iter().map(|p| p.1).sum::<f64>() / n);
    let covariance: f64 = points.iter().map(|p| (p.0 - mx) * (p.1 - my)).sum();
    covariance / points.iter().map(|p| (p.0 - mx).powi(2)).sum::<f64>()
}

#[test]
fn split_methods_keep_their_order() {
    // Steps from 1 ms down while the error stands at least 100 x above rounding (about 1e-14 in positions of 1 m).
    // double_spring with Verlet starts later: at 1 ms the error of 0.08 m is no longer small against its motion.
    let usual = [1e-3, 5e-4, 2.5e-4, 1.25e-4];
    let late = [1e-4, 5e-5, 2.5e-5];
    for name in CASES {
        let steps: &[f64] = if name == "double_spring" { &late } else { &usual };
        let order = observed_order(name, "verlet", steps);
        println!("{name} verlet: order {order:.3}");
        assert!(order >= 1.9, "{name}: {order}");
        let order = observed_order(name, "rk4", &usual);
        println!("{name} rk4: order {order:.3}");
        assert!(order >= 3.8, "{name}: {order}");
        // Nystrom's method has order 4 for forces of positions alone.
        if !name.ends_with("damped") {
            for method in ["nystrom4", "blanes_moan4"] {
                let order = observed_order(name, method, &usual);
                println!("{name} {method}: order {order:.3}");
                assert!(order >= 3.8, "{name}: {order}");
            }
        }
    }
}

#[test]
fn event_times_agree_to_a_nanosecond() {
    for name in CASES {
        let method = if name.ends_with("damped") { "rk4" } else { "blanes_moan4" };
        let (_, events) = rows(&scene(name, method, 1e-4));
        let reference = reference(name);
        let expected = reference["events"].as_array().expect("events");
        assert_eq!(events.len(), expected.len(), "{name}: number of events");
        // The times of the reference and of a second integration of it: an error between them cannot be judged.
        let second = numbers(&reference["events_dop853"]);
        let mut worst = 0.0_f64;
        for ((event, e), second) in events.iter().zip(expected).zip(second) {
            let first = e["t"].as_f64().expect("time");
            let (early, late) = (first.min(second), first.max(second));
            worst = worst.max(early - event.time).max(event.time - late);
            let touched: Vec<usize> = event.touches.iter().map(|t| t.0).collect();
            if e["type"] == "touch" {
                let points: Vec<usize> = numbers(&e["points"]).iter().map(|p| *p as usize).collect();
                assert_eq!(touched, points, "{name}: touching points");
            }
        }
        println!("{name} {method}: event times to {worst:.2e} s");
        assert!(worst <= 1e-9, "{name}: {worst:e}");
    }
}

/// Force evaluations that an undivided step of Verlet takes are 1; an event may add this many: trials, the rest of
/// the step, the forces after an impact.
const EVALUATIONS_PER_EVENT: usize = 6;

#[test]
fn an_event_costs_at_most_six_force_evaluations() {
    for name in CASES {
        let scene = scene(name, "verlet", 1e-3);
        let mut simulation = Simulation::<f64>::new(&scene.lists, &scene.around, scene.method).expect("body");
        simulation.begin(scene.step, &mut ()).expect("begin");
        let (mut events, mut extra, mut most) = (0, 0, 0);
        for _ in 0..(scene.seconds / scene.step) as usize {
            let report = simulation.step(scene.step, &mut ()).expect("step");
            let spent = report.trials + report.substeps - 1 + report.events;
            if report.events > 0 {
                most = most.max(spent.div_ceil(report.events));
            }
            (events, extra) = (events + report.events, extra + spent);
        }
        println!("{name}: {events} events, {extra} evaluations for them, at most {most} for one");
        let expected = reference(name)["events"].as_array().expect("events").len();
        assert!(events <= expected + 1, "{name}: {events} events, the reference has {expected}");
        assert!(events > 0 && most <= EVALUATIONS_PER_EVENT, "{name}: {most}");
    }
}

/// Rounding of positions and speeds of order 10 over some thousand steps.
const ROUNDING: f64 = 2e-13;

#[test]
fn dop853_reproduces_every_sample_to_its_digits() {
    for name in CASES {
        let reference = reference(name);
        let times = numbers(&reference["sample_times"]);
        let agreement = numbers(&reference["agreement"]["state_difference_per_sample"]);
        // Steps of 1 ms at most: in free fall the tolerance alone would let the stiff springs amplify rounding.
        let mut scene = scene(name, "dop853", 1e-3);
        scene.every = (times[0] / 1e-3).round() as usize;
        let (rows, _) = rows(&scene);
        let mut worst = 0.0_f64;
        for ((row, state), digits) in
            rows[1..].iter().zip(reference["states"].as_array().expect("states")).zip(agreement)
        {
            let state = numbers(state);
            let ours = row.pos.iter().chain(&row.vel).flatten();
            let error = ours.zip(&state).map(|(x, r)| (x - r).abs()).fold(0.0, f64::max);
            // "To the digits of its agreement": the power of ten above the difference of the two references.
            let allowed = 10.0_f64.powf(digits.log10().ceil()).max(ROUNDING);
            worst = worst.max(error / allowed);
            assert!(error <= allowed, "{name} at {}: {error:e} against {allowed:e}", row.t);
            let dissipated = state[state.len() - 1];
            let taken: f64 = row.energy.accounts[..4].iter().sum();
            assert!((taken - dissipated).abs() <= 1e-5 * (1.0 + dissipated), "{name}: dissipated energy");
        }
        println!("{name} dop853: at most {worst:.2} of what the reference is sure of");
    }
}
