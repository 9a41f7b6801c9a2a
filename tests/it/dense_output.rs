//! DOP853 with dense output on the host: its orders, and an independent computation of the dropped spring with it.
//!
//! The dropped spring here is four numbers and the law of two unit masses, written down in this file:
//! an oracle for the references that shares nothing with bodies, contact and scenes.

use smartbed::scene::dop853::Dop853;
use smartbed_runtime::ode::root;

/// x'' = -x from (1, 0): largest error of the dense output, and error at the end, for steps of length h.
fn oscillator(h: f64) -> (f64, f64) {
    let f = |_: f64, y: &[f64], k: &mut [f64]| k.copy_from_slice(&[y[1], -y[0]]);
    let mut solver = Dop853::new(f, 0.0, vec![1.0, 0.0], 1.0, h);
    let mut within = 0.0_f64;
    while solver.t < 6.0 - 1e-9 {
        let end = solver.t + h;
        let dense = solver.advance(end).expect("step");
        for n in 0..=10 {
            let theta = f64::from(n) / 10.0;
            let y = dense.at(theta);
            let t = dense.t + theta * dense.h;
            within = within.max((y[0] - t.cos()).abs()).max((y[1] + t.sin()).abs());
        }
    }
    (within, (solver.y[0] - solver.t.cos()).abs().max((solver.y[1] + solver.t.sin()).abs()))
}

#[test]
fn dense_output_has_order_7_and_the_method_8() {
    let (coarse, fine) = (oscillator(0.75), oscillator(0.375));
    let (dense, end) = ((coarse.0 / fine.0).log2(), (coarse.1 / fine.1).log2());
    println!("dense output: order {dense:.2}, {:.1e}; at the steps: {end:.2}, {:.1e}", fine.0, fine.1);
    assert!(dense >= 6.8 && end >= 7.5 && fine.0 <= 1e-8);
}

const K: f64 = 5000.0;
const G: f64 = 9.81;

/// y = (bottom, top, their speeds), rest length 1; the bottom rests or not.
struct Spring {
    held: bool,
}

impl Spring {
    fn slope(&self, y: &[f64], k: &mut [f64]) {
        let pull = K * (y[1] - y[0] - 1.0);
        let bottom = if self.held { 0.0 } else { pull - G };
        k.copy_from_slice(&[y[2], y[3], bottom, -pull - G]);
    }

    /// Falls to 0 at a touch or a release.
    fn guard(&self, y: &[f64]) -> f64 {
        if self.held { G - K * (y[1] - y[0] - 1.0) } else { y[0] }
    }
}

/// Eq. 4.13 for the top's speed: downwards if the top approaches and the ground need not pull, otherwise upwards.
fn touch(y: &[f64]) -> Vec<f64> {
    let speed = y[2].hypot(y[3]);
    let pushed_down = y[3] <= 0.0 && -y[2] - speed - y[3] >= 0.0;
    vec![0.0, y[1], 0.0, if pushed_down { -speed } else { speed }]
}

/// The event function of a released bottom is inactive until it is this high (m).
const ASLEEP: f64 = 1e-11;

/// Drops the spring from 1 m for 3 s: event times, end, evaluations.
fn drop_spring(tolerance: f64) -> (Vec<f64>, Vec<f64>, usize) {
    let spring = std::cell::RefCell::new(Spring { held: false });
    let f = |_: f64, y: &[f64], k: &mut [f64]| spring.borrow().slope(y, k);
    let mut solver = Dop853::new(f, 0.0, vec![1.0, 2.0, 0.0, 0.0], tolerance, 1e-3);
    let (mut events, mut armed) = (Vec::new(), true);
    while solver.t < 3.0 {
        let dense = solver.advance(3.0).expect("step");
        let guard = |theta: f64| spring.borrow().guard(&dense.at(theta));
        let mut bracket = None;
        for n in 1..=32 {
            let theta = f64::from(n) / 32.0;
            armed |= guard(theta) > ASLEEP;
            if armed && bracket.is_none() && guard(theta) < 0.0 {
                bracket = Some((theta - 1.0 / 32.0, theta));
            }
        }
        if let Some((low, high)) = bracket {
            let (_, theta) = root::locate(guard, low, high, 0.0).expect("bracketed");
            let t = dense.t + theta * dense.h;
            events.push(t);
            let y = dense.at(theta);
            let held = spring.borrow().held;
            let after = if held { y } else { touch(&y) };
            // A top that flies up pulls the bottom along at once: the bottom need not be held.
            let mut next = spring.borrow_mut();
            next.held = !held;
            if next.held && next.guard(&after) < 0.0 {
                next.held = false;
            }
            armed = next.held;
            drop(next);
            solver.restart(t, after, 1e-3);
        }
    }
    (events, solver.y, solver.evaluations)
}

#[test]
fn the_dropped_spring_anew() {
    let path = format!("{}/reference/single_spring.json", env!("CARGO_MANIFEST_DIR"));
    let reference: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(path).expect("file")).expect("JSON");
    let states = reference["states"].as_array().expect("states");
    // Columns: x y z of both points, then their velocities.
    let last = states[states.len() - 1].as_array().expect("row");
    let [bottom, top] = [2, 5].map(|i| last[i].as_f64().expect("number"));
    let (events, y, evaluations) = drop_spring(1e-12);
    let times: Vec<f64> = (reference["events"].as_array().expect("events").iter())
        .map(|e| e["t"].as_f64().expect("time"))
        .collect();
    assert_eq!(events.len(), times.len());
    let worst = events.iter().zip(&times).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let error = (y[0] - bottom).abs().max((y[1] - top).abs());
    println!("tolerance 1e-12: events to {worst:.1e} s, end to {error:.1e} m, {evaluations} evaluations");
    assert!(worst <= 1e-10 && error <= 1e-9);
    let (_, y, evaluations) = drop_spring(1e-6);
    let error = (y[0] - bottom).abs().max((y[1] - top).abs());
    println!("tolerance 1e-6: end to {error:.1e} m, {evaluations} evaluations");
    assert!(error <= 1e-4 && evaluations <= 10_000);
}
