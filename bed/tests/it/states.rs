//! Moments of a run: the last has no duration, a single one has no history; rows of tiles; forces in a maker's file.

use crate::plan::{change, plan};
use smartbed_bed::equilibrium::GRAVITY;
use smartbed_bed::map::Recording;
use smartbed_bed::metrics::report::{Report, Row};
use smartbed_bed::metrics::{Thresholds, spatial, time};
use smartbed_bed::plan::history::History;
use smartbed_bed::plan::run::run;
use smartbed_bed::plan::{Clock, Dynamics, Move, Start, states};

fn value(rows: &[Row], place: &str, metric: &str) -> Option<f64> {
    rows.iter().find(|row| row.place == place && row.metric == metric).expect("a row").value
}

fn rows(history: &History) -> Vec<Row> {
    let thresholds = Thresholds::default();
    Report { recording: &history.sensels, grid: Some(&history.grid), thresholds, friction: 0.4 }.rows()
}

#[test]
fn the_last_moment_is_looked_at_and_stands_for_no_time() {
    // Air is let out between the first moment and the second, which is the last.
    let mut p =
        plan(2, 2, vec![Move { at: 0.0, over: 5.0, pressure: Some(2000.0), ..change(&[0, 1, 2, 3]) }]);
    p.seconds = 10.0;
    let end_of = |history: &History| history.sensels.frames().last().expect("a map").clone();
    let let_down = run(&p, |_| true).expect("a run");
    assert_eq!(let_down.sensels.frames().len(), 2);
    assert_eq!(
        (end_of(&let_down).time, end_of(&let_down).seconds, let_down.sensels.seconds()),
        (10.0, 0.0, 10.0)
    );
    let [first, last] = [0, 1].map(|k| spatial::peak(&let_down.sensels.frames()[k].pressure));
    assert!(last < 0.8 * first, "{first} {last}");
    assert_eq!(value(&rows(&let_down), "bed", "peak pressure"), Some(last / 133.322));
    // Integrals are those of the frames that last.
    let sums = time::pressure_time(&let_down.sensels, 0.0);
    assert_eq!(sums.into_iter().fold(0.0, f64::max), 10.0 * first);
    // So is one moment alone, which has no history.
    p.seconds = 0.0;
    let alone = run(&p, |_| true).expect("an equilibrium");
    assert_eq!(alone.sensels.seconds(), 0.0);
    for metric in ["always at risk", "pressure time integral", "time below 10 mmHg", "shifts above 2 cm"] {
        assert_eq!(value(&rows(&alone), "bed", metric), None, "{metric}");
        assert!(value(&rows(&let_down), "bed", metric).is_some(), "{metric}");
    }
    assert!(value(&rows(&alone), "bed", "peak pressure").expect("a map") > 10.0);
}

#[test]
fn a_makers_file_keeps_the_force() {
    // Under a flat slab nearly all that presses points upwards; sheets are stretched by some percent.
    let mut p = plan(1, 1, Vec::new());
    p.layout.intervals = [28, 28];
    p.seconds = 0.0;
    p.load.body.segments[0].mass = 3.0;
    p.layout.friction = 0.0;
    let history = run(&p, |_| true).expect("an equilibrium");
    let sum = |recording: &Recording| {
        recording.frames()[0].pressure.iter().sum::<f64>() * history.grid.cell() / (3.0 * GRAVITY) - 1.0
    };
    let kept = history.over_cells(&history.sensels).expect("a recording");
    println!(
        "forces over nominal cells {:+.4} of the weight, pressures {:+.4}",
        sum(&kept),
        sum(&history.sensels)
    );
    let upwards = history.moments[0].borne[0] / (3.0 * GRAVITY) - 1.0;
    assert!(upwards.abs() < 1e-6 && sum(&kept).abs() < 0.01 && sum(&history.sensels).abs() > 0.02);
}

#[test]
fn tiles_tell_what_they_have_done() {
    // All rise by 10 mm within 20 of 40 s under 12 kg: m g h in all. One leans by 5 deg against one that stands.
    let all = |change: Move, rows, columns| {
        let mut p = plan(rows, columns, vec![change]);
        p.layout.friction = 0.8;
        let history = run(&p, |_| true).expect("a run");
        (states::tiles(&p, &history), states::drag(&p, &history).value.expect("a number"), history)
    };
    let (tiles, drag, _) = all(Move { heave: Some(0.01), ..change(&[0, 1, 2, 3]) }, 2, 2);
    let names = ["tile 1", "tile 2", "tile 3", "tile 4"];
    let work: f64 = names.iter().map(|n| value(&tiles, n, "work of lifting").expect("work")).sum();
    let load: f64 = names.iter().map(|n| value(&tiles, n, "load").expect("load")).sum();
    assert!(
        (work / (12.0 * GRAVITY * 0.01) - 1.0).abs() < 1e-6 && (load / (12.0 * GRAVITY) - 1.0).abs() < 1e-6
    );
    assert_eq!(value(&tiles, "tile 2", "motor duty"), Some(50.0));
    assert!((value(&tiles, "tile 4", "heave").expect("heave") - 10.0).abs() < 1e-12 && drag < 1e-12);
    // From 10 s to 50 s, but from 20 s on, for 5 s, to another height.
    let mut p = plan(1, 1, Vec::new());
    let to = |at: f64, over: f64, heave: f64| Move { at, over, heave: Some(heave), ..change(&[0]) };
    p.moves = vec![to(10.0, 40.0, 0.008), to(20.0, 5.0, 0.004)];
    let history = run(&p, |_| true).expect("a run");
    assert_eq!(value(&states::tiles(&p, &history), "tile 1", "motor duty"), Some(37.5));
    let slope = 1.0_f64.to_radians().tan();
    let (tiles, drag, _) = all(Move { slope: Some([slope, 0.0]), ..change(&[0]) }, 1, 2);
    // d sin(beta) of a rim 130 mm above the star, over the gap of 6 mm.
    assert!((drag / (0.13 * 1.0_f64.to_radians().sin() / 0.006) - 1.0).abs() < 0.01, "{drag}");
    assert!((value(&tiles, "tile 1", "tilt").expect("tilt") - 1.0).abs() < 1e-9);
    assert_eq!(value(&tiles, "tile 2", "motor duty"), Some(0.0));
}

#[test]
fn what_misses_the_gate_is_not_valid() {
    let mut p = plan(1, 1, Vec::new());
    (p.seconds, p.every) = (1.0, 0.1);
    let mut validity = |step: f64| {
        p.clock = Clock::Dynamics(Dynamics { step, start: Start::Dropped(0.02), ..Dynamics::default() });
        let gate = states::gate(&run(&p, |_| true).expect("motion"), None);
        (states::is_valid(&gate), value(&gate, "bed", "energy left over").expect("energy"))
    };
    let (fine, coarse) = (validity(2e-3), validity(0.1));
    println!("left over {:.1e} and {:.1e} J", fine.1, coarse.1);
    assert!(fine.0 && !coarse.0);
    // A map that sensors read 2 % off, and one that cannot be told.
    p.clock = Clock::QuasiStatic;
    let history = run(&p, |_| true).expect("equilibria");
    let with = |off: f64| states::is_valid(&states::gate(&history, Some(off)));
    assert!(with(0.009) && !with(0.02) && !with(f64::NAN));
}
