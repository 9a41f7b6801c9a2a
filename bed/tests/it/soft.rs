//! Soft manipulation: the four states of the thesis' Fig. 2.1, and a check of its statements about them.

use smartbed_bed::body::{Body, Segment, Shape};
use smartbed_bed::plan::{Clock, Laying, Layout, Load, Plan};
use smartbed_bed::pose::Pose;
use smartbed_bed::soft::compare;

#[test]
fn what_the_thesis_says_of_soft_manipulation_is_shown_or_refuted() {
    let layout = Layout { rows: 1, columns: 1, intervals: [16, 20], ..Layout::default() };
    let shape = Shape { half: [0.05, 0.05, 0.0], radius: 0.06 };
    let name = "body".to_owned();
    let segment =
        Segment { name, shape: shape.into(), mass: 6.0, centre: [0.0; 3], foundation: 1e6, free: [true; 6] };
    let load = Load { body: Body::single(segment), poses: vec![Pose::at([0.0; 3])], figure: None };
    let plan = Plan {
        title: "soft".to_owned(),
        layout,
        pressure: 10e3,
        load: load.placed([0.0; 2]),
        moves: Vec::new(),
        seconds: 60.0,
        every: 5.0,
        cycle: 60.0,
        clock: Clock::QuasiStatic,
        laying: Laying::AtOnce,
    };
    let found = compare(&plan, 2500.0, 8.0_f64.to_radians().tan(), |_| true).expect("rests");
    for (history, state) in found.histories.iter().zip(&found.states) {
        // Whatever the state, the bladder carries the weight: no pressure is below weight over area.
        assert!(history.moments.iter().all(|m| m.imbalance < 1e-6 && m.sensed < 0.01));
        assert!(state.peak > 6.0 * 9.80665 / state.area, "{state:?}");
    }
    let [stiff, _, tilted, both] = [0, 1, 2, 3].map(|k| found.states[k]);
    assert_eq!((stiff.wandered, stiff.moved), (0.0, [0.0; 2]));
    // The tile's lean is 8 deg; a load that rolls on it turns by more.
    assert!(tilted.moved[1] > 8.0_f64.to_radians() && both.moved[1] > 8.0_f64.to_radians());
    let claims = found.claims();
    for claim in &claims {
        println!("{} {}: {}", if claim.holds { "shown" } else { "refuted" }, claim.says, claim.found);
    }
    // The first point of contact goes on bearing the air's pressure: a tilt of 8 deg does not take it off the bladder;
    // and shear is larger, not less, than deflated alone.
    let holds: Vec<bool> = claims.iter().map(|claim| claim.holds).collect();
    assert_eq!(holds, [true, true, true, true, true, true, false, false, true]);
}
