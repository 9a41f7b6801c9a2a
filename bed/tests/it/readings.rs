//! Instruments of tiles while a plan runs: their lag, their resolution, and equal readings from equal seeds.

use smartbed_bed::body::Body;
use smartbed_bed::plan::history::History;
use smartbed_bed::plan::readings::{Errors, readings};
use smartbed_bed::plan::{Clock, Laying, Layout, Load, Move, Plan, run::run};
use smartbed_bed::sensor::drive::Instruments;

/// Two tiles that lose 100 Pa a second and rise by 1 mm a second for 20 s.
fn plan() -> (Plan, History) {
    let layout = Layout { rows: 1, columns: 2, intervals: [4, 5], ..Layout::default() };
    let change = Move {
        at: 0.0,
        over: 20.0,
        tiles: vec![0, 1],
        pressure: Some(2000.0),
        heave: Some(0.02),
        slope: None,
    };
    let plan = Plan {
        title: "ramp".to_owned(),
        layout,
        pressure: 4000.0,
        load: Load { body: Body::default(), poses: Vec::new(), figure: None },
        moves: vec![change],
        seconds: 40.0,
        every: 5.0,
        cycle: 40.0,
        clock: Clock::QuasiStatic,
        laying: Laying::AtOnce,
    };
    let history = run(&plan, |_| true).expect("runs");
    (plan, history)
}

#[test]
fn a_pressure_that_falls_is_read_late_by_lag_and_delay() {
    let (plan, history) = plan();
    let mut exact = Instruments::default();
    (exact.pressure.noise, exact.pressure.bias, exact.pressure.resolution) = (0.0, 0.0, 0.0);
    exact.lvdt_noise = [0.0; 2];
    let found = readings(&plan, &history, exact, 1).expect("instruments");
    assert_eq!(found.len(), 2 * history.moments.len());
    for reading in &found {
        let late = reading.read.pressure - reading.gauge;
        // 100 Pa/s times 20 ms of the membrane and 10 ms to the reading; half a tick more or less by sampling.
        let expected = if (1.0..=20.0).contains(&reading.time) { 3.0 } else { 0.0 };
        assert!((late - expected).abs() < 0.1, "{reading:?}");
        for k in 0..3 {
            let step = exact.encoder;
            assert!((reading.read.encoders[k] - reading.heights[k]).abs() <= 0.5 * step * (1.0 + 1e-9));
            // A straight line to 0.25 % of 30 mm.
            assert!((reading.read.lvdts[k] - reading.heights[k]).abs() <= 75e-6 * (1.0 + 1e-9));
        }
        assert_eq!(reading.read.disagree(), None);
    }
    let end = found.last().expect("a reading");
    assert!((end.heights[0] - 0.02).abs() < 1e-12 && (end.gauge - 2000.0).abs() < 1e-9);
}

#[test]
fn a_slow_sensor_reads_the_same_however_rarely_it_is_read() {
    // From 3 kPa at 12 s to 4 kPa at 14 s, then constant.
    let (mut plan, _) = plan();
    let up = Move { at: 12.0, over: 2.0, pressure: Some(4000.0), heave: None, ..plan.moves[0].clone() };
    (plan.moves, plan.pressure, plan.seconds) = (vec![up], 3000.0, 20.0);
    for [lag, delay, period] in [[0.5, 0.2, 0.1], [0.0, 0.9, 0.3], [2.0, 0.0, 0.001]] {
        let mut exact = Instruments { lag, ..Instruments::default() };
        (exact.pressure.noise, exact.pressure.bias, exact.pressure.resolution) = (0.0, 0.0, 0.0);
        let ticks = |seconds: f64| (seconds * 1e3).round() as u32;
        (exact.pressure.delay, exact.pressure.period) = (ticks(delay), ticks(period));
        // A ramp from 0 through a lag T: t - T (1 - e^(-t/T)); what is read was sampled last at a multiple of the
        // period.
        let ramp = |t: f64| if t > 0.0 { t - lag * (1.0 - (-t / lag.max(1e-9)).exp()) } else { 0.0 };
        for every in [0.5, 2.0, 10.0] {
            plan.every = every;
            let history = run(&plan, |_| true).expect("runs");
            for reading in readings(&plan, &history, exact, 1).expect("instruments") {
                let sampled = ((reading.time - delay) / period + 1e-9).floor() * period - 12.0;
                let expected = 3000.0 + 500.0 * (ramp(sampled) - ramp(sampled - 2.0));
                // Half a tick of the ramp.
                let off = (reading.read.pressure - expected).abs();
                assert!(off < 0.5, "{lag} {delay} {period}, every {every}: {expected} {reading:?}");
            }
        }
    }
}

#[test]
fn readings_are_the_same_from_the_same_seed_and_as_wrong_as_they_are_said_to_be() {
    let (plan, history) = plan();
    let of = |seed: u64| readings(&plan, &history, Instruments::default(), seed).expect("instruments");
    let [one, again, other] = [of(3), of(3), of(4)];
    assert_eq!(one, again);
    assert_ne!(one, other);
    let errors = Errors::of(&one);
    // 3 Pa late, five deviations of noise and bias.
    assert!(errors.pressure > 0.5 && errors.pressure < 3.0 + 5.0 * (5.0 + 10.0), "{errors:?}");
    assert!(
        errors.lvdt > 1e-6 && errors.lvdt < 75e-6 + 5.0 * 5e-6 + 2e-6 && errors.disagree == 0,
        "{errors:?}"
    );
    let broken = Instruments { encoder: 2e-3, ..Instruments::default() };
    let apart = readings(&plan, &history, broken, 3).expect("instruments");
    assert!(Errors::of(&apart).disagree > 0);
}

#[test]
fn a_pressure_that_jumps_is_read_before_and_after_it_however_far_apart_moments_are() {
    // From 3 kPa to 2 kPa at 10 s; a sample is read 10 ms later.
    let (mut plan, _) = plan();
    let jump = Move { at: 10.0, over: 0.0, pressure: Some(2000.0), heave: None, ..plan.moves[0].clone() };
    (plan.moves, plan.pressure, plan.seconds) = (vec![jump], 3000.0, 20.0);
    let mut exact = Instruments::default();
    (exact.pressure.noise, exact.pressure.bias, exact.pressure.resolution) = (0.0, 0.0, 0.0);
    for every in [0.5, 2.0, 10.0] {
        plan.every = every;
        let history = run(&plan, |_| true).expect("runs");
        for reading in readings(&plan, &history, exact, 1).expect("instruments") {
            let expected = if reading.time > 10.1 { 2000.0 } else { 3000.0 };
            assert!((reading.read.pressure - expected).abs() < 0.1, "every {every}: {reading:?}");
        }
    }
    // Moments closer than a tick of 1 ms have readings, too.
    (plan.every, plan.seconds) = (4e-4, 4e-3);
    let history = run(&plan, |_| true).expect("runs");
    let found = readings(&plan, &history, exact, 1).expect("instruments");
    assert_eq!(found.len(), 2 * history.moments.len());
    assert!(found.iter().all(|reading| (reading.read.pressure - 3000.0).abs() < 1e-9), "{found:?}");
}
