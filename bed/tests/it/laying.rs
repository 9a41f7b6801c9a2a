//! How a load is laid down: different histories give different pressures, and the only reason is friction.

use crate::clocks::{indices, patient};
use smartbed_bed::body::anthropometry::Table;
use smartbed_bed::body::figure::{Figure, Posture};
use smartbed_bed::dynamics::{Matter, Method, Motion, dropped};
use smartbed_bed::equilibrium::{Bed, Solution, lay_on};
use smartbed_bed::metrics::spatial;
use smartbed_bed::plan::run::run;
use smartbed_bed::plan::{Clock, Dynamics, Laying, Load, Plan, maps};

/// Peak pressure index (Pa).
fn index(p: &Plan, bed: &Bed, solution: &Solution) -> f64 {
    let sites = maps::sensels(&p.layout, bed, solution);
    let felt = maps::felt(&p.layout, solution, &sites);
    spatial::peak_pressure_index(&maps::grid(&p.layout), &felt.pressure, 9e-4).expect("a window")
}

#[test]
fn who_fell_is_pressed_alike_by_both_clocks() {
    // He falls from 20 mm and settles for 4 s; then half of all bladders are let down for 20 s.
    let (settling, fall) = (4.0, Dynamics { step: 10e-3, ..Dynamics::default() });
    let mut p = patient([8, 10]);
    p.moves = Plan::alternating(&p.layout, 1600.0, 5000.0, 600.0, 600.0);
    (p.seconds, p.every, p.laying) = (20.0, 1.0, Laying::Fallen(fall, settling));
    let still = indices(&run(&p, |_| true).expect("equilibria"));
    p.moves.iter_mut().for_each(|told| told.at += settling);
    (p.seconds, p.clock) = (settling + 20.0, Clock::Dynamics(fall));
    let moved = run(&p, |_| true).expect("motion");
    let moving = &indices(&moved)[settling as usize..];
    let off = moving.iter().zip(&still).map(|(a, b)| (a / b - 1.0).abs()).fold(0.0, f64::max);
    println!("PPI {:.0} to {:.0} Pa, clocks apart by {off:.1e}", still[0], still[20]);
    assert!(moving.len() == 21 && still[20] > 1.03 * still[0] && off < 0.02, "{moving:?} {still:?}");
    assert!(moved.moments.iter().all(|m| m.imbalance < 1e-6 && m.sensed < 0.01));
}

/// Tissue's curvature makes some of these far softer along the last steps than the Hessian, which leaves it out.
#[test]
fn a_sitting_patient_of_any_weight_comes_to_rest() {
    for (mass, pressure) in [(75.0, 4000.0), (75.0, 5000.0), (50.0, 5000.0), (75.1, 5000.0), (85.0, 8000.0)] {
        let figure = Figure::new(Table::DeLevaMale, mass, 1.75, Posture::Sitting, &[]).expect("a figure");
        let load = Load { body: figure.body.clone(), poses: figure.poses.clone(), figure: Some(figure) };
        let mut p = patient([8, 10]);
        (p.load, p.pressure, p.seconds) = (load.placed([0.0, 0.0]), pressure, 0.0);
        let history = run(&p, |_| true).unwrap_or_else(|why| panic!("{mass} kg, {pressure} Pa: {why}"));
        assert!(history.moments.iter().all(|m| m.imbalance < 1e-6), "{mass} kg, {pressure} Pa");
    }
}

#[test]
fn a_bent_knee_finds_its_rest() {
    let left = ("left knee".to_owned(), [-90.0, 0.0, 0.0]);
    let both = vec![left.clone(), ("right knee".to_owned(), [-90.0, 0.0, 0.0])];
    let with_hip = vec![left.clone(), ("left hip".to_owned(), [45.0, 0.0, 0.0])];
    for joints in [vec![left], both, with_hip] {
        for (pressure, has_stops) in [(4000.0, false), (6000.0, true)] {
            let figure =
                Figure::new(Table::DeLevaMale, 75.0, 1.75, Posture::Supine, &joints).expect("a figure");
            let figure = if has_stops { figure.with_stops() } else { figure };
            let load = Load { body: figure.body.clone(), poses: figure.poses.clone(), figure: Some(figure) };
            let mut p = patient([8, 10]);
            (p.load, p.pressure, p.seconds) = (load.placed([0.0, 0.0]), pressure, 0.0);
            let history = run(&p, |_| true).unwrap_or_else(|why| panic!("{joints:?}, {pressure} Pa: {why}"));
            assert!(history.moments.iter().all(|m| m.imbalance < 1e-6), "{joints:?}, {pressure} Pa");
        }
    }
}

/// A patient whose weight is laid on evenly over so many seconds in motion, as `lay_on` does it in parts; then he is let go.
fn lowered(p: &Plan, bed: &Bed, seconds: f64) -> Solution {
    let mut body = p.load.body.clone();
    let masses: Vec<f64> = body.segments.iter().map(|s| s.mass).collect();
    let first = body.segments[0].free;
    body.segments[0].free = [false, false, first[2], false, false, false];
    let state = dropped(bed, &body, &p.load.poses, 1e-4).expect("sheets at rest");
    let step = 10e-3;
    let mut motion = Motion::new(bed.clone(), body, state, Matter::default(), Method::Bdf2, step);
    while motion.time() < seconds + 4.0 {
        let share = ((motion.time() + step) / seconds).min(1.0);
        motion.body.segments.iter_mut().zip(&masses).for_each(|(own, mass)| own.mass = share * mass);
        if motion.time() > seconds + 1.0 {
            motion.body.segments[0].free = first;
        }
        motion.step(|_| bed.clone()).expect("a step");
    }
    println!("lowered in {seconds} s: {:.1e} m/s at the end", motion.fastest());
    motion.now
}

#[test]
fn who_is_lowered_slowly_is_pressed_as_equilibria_in_parts_say() {
    let p = patient([8, 10]);
    let bed = p.bed(0.0).expect("a bed");
    let parts = lay_on(&bed, &p.load.body, &bed.start(p.load.poses.clone()), 32).expect("rests");
    let [slow, still] = [lowered(&p, &bed, 8.0), parts].map(|found| index(&p, &bed, &found));
    println!("PPI {slow:.0} Pa lowered in motion, {still:.0} Pa in 32 parts");
    assert!((slow / still - 1.0).abs() < 0.02, "{slow} {still}");
}
