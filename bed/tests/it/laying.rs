//! How a load is laid down: different histories give different pressures, and the only reason is friction.

use crate::clocks::{indices, patient};
use crate::plan::plan;
use smartbed_bed::body::anthropometry::Table;
use smartbed_bed::body::figure::{Figure, Posture};
use smartbed_bed::body::{Body, Segment, Shape};
use smartbed_bed::dynamics::{Matter, Method, Motion, dropped};
use smartbed_bed::equilibrium::passed::{deepest, passed};
use smartbed_bed::equilibrium::{Bed, Solution, lay_on, put_down};
use smartbed_bed::metrics::spatial;
use smartbed_bed::plan::history::History;
use smartbed_bed::plan::run::run;
use smartbed_bed::plan::states::over;
use smartbed_bed::plan::{Clock, Dynamics, Laying, Load, Plan, maps};
use smartbed_bed::pose::Pose;

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
    for (mass, pressure) in
        [(75.0, 4000.0), (75.0, 5000.0), (50.0, 5000.0), (75.1, 5000.0), (85.0, 8000.0), (40.0, 8000.0)]
    {
        let p = sitting(mass, pressure);
        let history = run(&p, |_| true).unwrap_or_else(|why| panic!("{mass} kg, {pressure} Pa: {why}"));
        assert!(history.moments.iter().all(|m| m.imbalance < 1e-6), "{mass} kg, {pressure} Pa");
        // Put down at once he sinks through the sheets; bladders are 100 mm deep.
        assert!(history.parts.is_some(), "{mass} kg, {pressure} Pa");
        let lowest = history.moments[0].segments.iter().map(|pose| pose.place[2]).fold(1.0, f64::min);
        println!("{mass} kg, {pressure} Pa: in {:?} parts, lowest {:.0} mm", history.parts, 1e3 * lowest);
        assert!(lowest > -0.02, "{mass} kg, {pressure} Pa: {lowest}");
    }
}

/// A patient who sits on 28 tiles.
fn sitting(mass: f64, pressure: f64) -> Plan {
    let figure = Figure::new(Table::DeLevaMale, mass, 1.75, Posture::Sitting, &[]).expect("a figure");
    let load = Load { body: figure.body.clone(), poses: figure.poses.clone(), figure: Some(figure) };
    let mut p = patient([8, 10]);
    (p.load, p.pressure, p.seconds) = (load.placed([0.0, 0.0]), pressure, 0.0);
    p
}

#[test]
fn who_has_passed_through_a_sheet_is_named_and_laid_on_in_parts() {
    let mut p = sitting(85.0, 8000.0);
    let bed = p.bed(0.0).expect("a bed");
    let start = bed.start(p.load.poses.clone());
    // At once: contact forces balance the weight, but legs hang below the bed.
    let down = put_down(&bed, &p.load.body, &start).expect("forces in balance");
    let found = passed(&bed, &p.load.body, &down.state).expect("passed");
    assert!(down.imbalance < 1e-6 && found.depth > 0.3, "{found:?}");
    // The run lays him on in parts by itself, with the same result as if they were asked for.
    let history = run(&p, |_| true).expect("rests");
    p.laying = Laying::InParts(history.parts.expect("in parts"));
    let asked = run(&p, |_| true).expect("rests");
    assert_eq!((&history.moments, asked.parts), (&asked.moments, None));
    // Too few parts are not valid.
    let few = Plan { laying: Laying::InParts(8), ..sitting(75.0, 5000.0) };
    let said = run(&few, |_| true).expect_err("below the sheets").to_string();
    assert!(
        said.contains(" has passed through the sheet of tile ") && said.contains("`run.parts = 8`"),
        "{said}"
    );
}

#[test]
fn a_part_below_a_sheet_is_found_by_its_depth() {
    // A ball that rests, then 100 mm lower, on a node, on an edge between triangles, and beside both.
    let bed = plan(2, 2, Vec::new()).bed(0.0).expect("a bed");
    let shape = Shape::ball(0.1).into();
    let (name, centre, free) = ("ball".to_owned(), [0.0; 3], [true; 6]);
    let body = Body::single(Segment { name, shape, mass: 10.0, centre, foundation: 1e7, free });
    let down = put_down(&bed, &body, &bed.start(vec![Pose::at([0.0, 0.0, 0.14])])).expect("rests");
    assert_eq!(deepest(&bed, &body, &down.state), None);
    let tile = bed.tiles[0].pose;
    for [x, y] in [[0.0, 0.0], [0.0, 0.013], [0.011, 0.007]] {
        let mut state = down.state.clone();
        state.sheets[0] = bed.lattice.flat();
        state.segments[0].place = tile.outwards([x, y, -0.1]);
        let found = passed(&bed, &body, &state).expect("below");
        assert!((found.segment, found.tile) == (0, 0) && (found.depth - 0.1).abs() < 1e-12, "{found:?}");
        state.segments[0].place = tile.outwards([x, y, 0.01]);
        assert_eq!(deepest(&bed, &body, &state), None);
    }
}

#[test]
fn who_falls_on_sealed_bladders_finds_their_valves_shut() {
    // What rests after a fall goes on in motion as if nothing had happened.
    let mut p = plan(2, 2, Vec::new());
    p.layout.is_sealed = true;
    let fall = Dynamics { step: 10e-3, ..Dynamics::default() };
    (p.seconds, p.every, p.laying) = (0.0, 1.0, Laying::Fallen(fall, 6.0));
    let still = run(&p, |_| true).expect("rests");
    (p.seconds, p.laying, p.clock) = (6.0, Laying::AtOnce, Clock::Dynamics(fall));
    let moved = run(&p, |_| true).expect("moves");
    let last = |history: &History| history.moments.last().expect("a moment").gauges.clone();
    let (found, expected) = (last(&still), last(&moved));
    println!("{found:.1?} Pa after a fall, {expected:.1?} Pa in motion");
    for (one, other) in found.iter().zip(&expected) {
        assert!(*one > p.pressure + 100.0 && (one / other - 1.0).abs() < 1e-3, "{found:?} {expected:?}");
    }
    // A limit between the order and what the load makes of it is said to be exceeded, by tile and time.
    assert_eq!(over(&p, &moved), None);
    p.layout.most_pressure = p.pressure + 50.0;
    let told = over(&p, &moved).expect("too much");
    assert!(told.gauge >= expected[told.tile] && told.time > 0.0, "{told:?}");
    assert!(told.to_string().starts_with("the sealed bladder of tile "), "{told}");
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

/// A patient whose weight is laid on evenly over so many seconds in motion, as `lay_on` does it in parts; then he is
/// let go.
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
