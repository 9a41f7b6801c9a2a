//! Plans: commands to tiles, refusals, and runs whose maps add up to the weight.

use smartbed_bed::body::anthropometry::Table;
use smartbed_bed::body::figure::{Figure, Posture};
use smartbed_bed::body::{Body, Segment, Shape};
use smartbed_bed::metrics::{spatial, time};
use smartbed_bed::plan::check::check;
use smartbed_bed::plan::moments::{overridden, unseen};
use smartbed_bed::plan::run::run;
use smartbed_bed::plan::{Clock, Laying, Layout, Load, Move, Plan};
use smartbed_bed::pose::Pose;
use smartbed_bed::sheet::air::AMBIENT;

fn slab(mass: f64) -> Load {
    let shape = Shape { half: [0.1, 0.15, 0.02], radius: 0.03 };
    let name = "slab".to_owned();
    let segment =
        Segment { name, shape: shape.into(), mass, centre: [0.0; 3], foundation: 1e6, free: [true; 6] };
    Load { body: Body::single(segment), poses: vec![Pose::at([0.0; 3])], figure: None }.placed([0.0; 2])
}

pub fn plan(rows: usize, columns: usize, moves: Vec<Move>) -> Plan {
    let layout = Layout { rows, columns, intervals: [6, 8], ..Layout::default() };
    let load = slab(12.0);
    Plan {
        title: "t".to_owned(),
        layout,
        pressure: 4000.0,
        load,
        moves,
        seconds: 40.0,
        every: 10.0,
        cycle: 40.0,
        clock: Clock::QuasiStatic,
        laying: Laying::AtOnce,
    }
}

pub fn change(tiles: &[usize]) -> Move {
    Move { at: 10.0, over: 20.0, tiles: tiles.to_vec(), pressure: None, heave: None, slope: None }
}

#[test]
fn orders_follow_moves() {
    let mut p = plan(2, 2, vec![Move { heave: Some(0.01), pressure: Some(2000.0), ..change(&[1]) }]);
    p.moves.push(Move { at: 30.0, over: 0.0, pressure: Some(3000.0), ..change(&[1, 2]) });
    assert_eq!(p.order(1, 0.0).pressure, 4000.0);
    assert_eq!(p.order(1, 20.0).pressure, 3000.0);
    assert!((p.order(1, 20.0).command.heave - 0.005).abs() < 1e-15);
    assert_eq!(p.order(1, 30.0).pressure, 3000.0);
    assert_eq!(p.order(2, 29.0).pressure, 4000.0);
    assert_eq!(p.order(2, 30.0).pressure, 3000.0);
    assert_eq!(p.order(0, 40.0).pressure, 4000.0);
    assert_eq!(p.times(), [0.0, 10.0, 20.0, 30.0, 40.0]);
    assert_eq!(Layout::default().neighbours().count(), 45);
}

#[test]
fn moves_taken_back_between_moments_are_found() {
    // Times of a dip from 4 to 1.6 kPa and of its return, each with its duration, under moments every 10 s; whether any
    // of 10,000 intermediate orders that differ from 4 kPa is at a moment says whether a run can see it.
    let dip = |[at, over]: [f64; 2], [back, up]: [f64; 2]| {
        let down = Move { pressure: Some(1600.0), at, over, ..change(&[1]) };
        plan(2, 2, vec![down, Move { pressure: Some(4000.0), at: back, over: up, ..change(&[0, 1]) }])
    };
    for (down, back) in [
        ([1.0, 2.0], [6.0, 2.0]),
        ([1.0, 2.0], [8.0, 2.0]),
        ([1.0, 2.0], [9.0, 2.0]),
        ([0.0, 2.0], [6.0, 2.0]),
        ([10.0, 0.0], [15.0, 2.0]),
        ([10.0, 1.0], [15.0, 2.0]),
        ([12.0, 0.0], [20.0, 0.0]),
        ([12.0, 0.0], [20.0, 1.0]),
        ([5.0, 5.0], [10.0, 5.0]),
        ([38.0, 1.0], [39.0, 5.0]),
    ] {
        let p = dip(down, back);
        let is_seen = p.times().iter().any(|time| p.order(1, *time).pressure != 4000.0);
        let found = unseen(&p);
        assert_eq!(found.is_none(), is_seen, "{down:?} {back:?}: {found:?}");
        if let Some(found) = found {
            let expected = (0, 1, down[0], back[0] + back[1]);
            assert_eq!((found.index, found.tile, found.from, found.to), expected);
        }
    }
    // Two steps in one direction leave a trace, and so does a move that nothing takes back.
    let mut p = dip([1.0, 1.0], [3.0, 1.0]);
    p.moves[1].pressure = Some(1000.0);
    assert_eq!(unseen(&p), None);
    p.moves.truncate(1);
    assert_eq!(unseen(&p), None);
    // An alternation of 1 s seen every 5 s.
    p.moves = Plan::alternating(&p.layout, 1600.0, 4000.0, 1.0, 40.0);
    assert!(unseen(&p).is_some());
    p.moves = Plan::alternating(&p.layout, 1600.0, 4000.0, 40.0, 40.0);
    assert_eq!(unseen(&p), None);
    assert_eq!(overridden(&p), [[0; 3]; 0]);
    // A pressure ordered anew while it still changes, not where one move begins as the other ends.
    assert_eq!(overridden(&dip([1.0, 2.0], [2.5, 2.0])), [[0, 1, 1]]);
    assert_eq!(overridden(&dip([1.0, 2.0], [3.0, 2.0])), [[0; 3]; 0]);
}

/// What is ordered anew goes on from where it is, and its earlier order ends: both went on together, so that a bladder that
/// was let down at 7 kPa rose to 9.7 kPa.
#[test]
fn an_order_goes_on_from_where_it_is() {
    let up = Move { at: 0.0, over: 10.0, pressure: Some(10e3), heave: Some(0.02), ..change(&[0]) };
    let down = Move { at: 5.0, over: 100.0, pressure: Some(4e3), heave: Some(0.0), ..change(&[0]) };
    let p = plan(1, 1, vec![up, down]);
    let begin = p.order(0, f64::NEG_INFINITY).pressure;
    let turn = 0.5 * (begin + 10e3);
    for (time, pressure, heave) in [
        (5.0, turn, 0.01),
        (10.0, turn + 0.05 * (4e3 - turn), 0.0095),
        (55.0, 0.5 * (turn + 4e3), 0.005),
        (200.0, 4e3, 0.0),
    ] {
        let order = p.order(0, time);
        assert!((order.pressure - pressure).abs() < 1e-9, "{time}: {order:?}");
        assert!((order.command.heave - heave).abs() < 1e-15, "{time}: {order:?}");
    }
}

/// However far apart moments are, a jump is no slow move.
#[test]
fn a_screw_does_not_jump() {
    for every in [1.0, 10.0, 40.0] {
        let jump = Move { at: 10.0, over: 0.0, heave: Some(0.001), ..change(&[0]) };
        let p = Plan { every, ..plan(1, 1, vec![jump]) };
        let said = check(&p).expect_err("refused").to_string();
        assert!(said.contains("at 10.0000 s: screw 1 at inf mm/s, expected at most 6.70 mm/s"), "{said}");
    }
    // A plan may begin with any order, and pressures may jump.
    let first = Move { at: 0.0, over: 0.0, heave: Some(0.01), ..change(&[0]) };
    let valve = Move { at: 10.0, over: 0.0, pressure: Some(5e3), ..change(&[0]) };
    assert!(check(&plan(1, 1, vec![first, valve])).is_ok());
}

#[test]
fn an_alternation_has_a_largest_number_of_cycles() {
    let layout = plan(1, 1, Vec::new()).layout;
    let moves = |cycle: f64| Plan::alternating(&layout, 1600.0, 4000.0, cycle, 40.0);
    assert_eq!(moves(10.0).len(), 1 + 4 * 4);
    for cycle in [1e-9, 1e-300, 0.0] {
        assert_eq!(moves(cycle).len(), 1 + 4 * Plan::MOST_CYCLES, "{cycle}");
    }
}

#[test]
fn the_first_cycle_of_an_alternation_is_as_high_as_the_others() {
    let mut p = plan(1, 2, Vec::new());
    (p.pressure, p.seconds) = (3000.0, 240.0);
    p.moves = Plan::alternating(&p.layout, 1000.0, 5000.0, 120.0, 240.0);
    // Both tiles after a ramp of 4 s: 50 s, 10 s, 50 s, 10 s.
    for (time, pressures) in [(10.0, [1e3, 5e3]), (55.0, [5e3, 5e3]), (70.0, [5e3, 1e3]), (115.0, [5e3, 5e3])]
    {
        for start in [0.0, 120.0] {
            let own = [0, 1].map(|tile| p.order(tile, start + time).pressure);
            assert_eq!(own, pressures, "{time} s after {start} s");
        }
    }
}

#[test]
fn limits_are_refused_with_the_tile() {
    let refuse = |moves: Vec<Move>| check(&plan(2, 2, moves)).expect_err("refused").to_string();
    assert_eq!(
        refuse(vec![Move { heave: Some(0.05), ..change(&[0, 1, 2, 3]) }]),
        "tile 1 at 30.0000 s: screw 1 at 50.0 mm, expected at most 30.0 mm up or down, its stroke"
    );
    assert_eq!(
        refuse(vec![Move { pressure: Some(13e3), ..change(&[2]) }]),
        "tile 3 at 30.0000 s: pressure of 13.00 kPa, expected 0 to 12.00 kPa"
    );
    assert_eq!(
        refuse(vec![Move { heave: Some(0.025), ..change(&[3]) }]),
        "tile 2 at 30.0000 s: step of 25.0 mm to tile 4, expected 20.0 mm at most"
    );
    assert_eq!(
        refuse(vec![Move { heave: Some(0.02), over: 1.0, ..change(&[0, 1, 2, 3]) }]),
        "tile 1 at 11.0000 s: screw 1 at 20.00 mm/s, expected at most 6.70 mm/s; give the move more time (`over`)"
    );
    let low = refuse(vec![Move { pressure: Some(100.0), ..change(&[0, 1, 2, 3]) }]);
    assert!(low.contains("all bladders can carry") && low.contains("118 N"), "{low}");
    // A gap of 6 mm at 130 mm above the star closes at some 1.3 deg of opposite tilt.
    let lean = |degrees: f64| {
        let slope = degrees.to_radians().tan();
        vec![
            Move { slope: Some([slope, 0.0]), ..change(&[0]) },
            Move { slope: Some([-slope, 0.0]), ..change(&[1]) },
        ]
    };
    let narrow = |degrees: f64| check(&plan(1, 2, lean(degrees)));
    assert!(narrow(1.25).is_ok() && narrow(1.4).is_err());
    assert!(narrow(1.4).expect_err("touch").to_string().contains("with that of tile 2"));
    assert!(check(&plan(2, 2, Vec::new())).is_ok());
}

#[test]
fn a_run_carries_the_weight_and_feels_it() {
    let moves = vec![
        Move { pressure: Some(1500.0), ..change(&[0, 3]) },
        Move { slope: Some([0.02, 0.0]), at: 20.0, ..change(&[0, 1, 2, 3]) },
    ];
    for is_sealed in [false, true] {
        let mut p = plan(2, 2, moves.clone());
        p.layout.is_sealed = is_sealed;
        p.layout.intervals = [14, 18];
        p.seconds = 60.0;
        check(&p).expect("within limits");
        let history = run(&p, |_| true).expect("runs");
        assert_eq!(history.moments.len(), 7);
        for moment in &history.moments {
            assert!(
                moment.imbalance < 1e-6 && moment.sensed < 0.01,
                "{} {}",
                moment.imbalance,
                moment.sensed
            );
        }
        let last = history.moments.last().expect("moments");
        if is_sealed {
            // Gas that nobody lets out is pressed together: p V stays.
            assert!(last.gauges[1] > 4000.0 && last.gauges[1] < AMBIENT, "{:?}", last.gauges);
            assert!((last.gauges[0] - 1500.0).abs() > 1.0);
        } else {
            assert_eq!(last.gauges, [1500.0, 4000.0, 4000.0, 1500.0]);
        }
        // Skin and sensels feel the same load, each in its own sites.
        let load = |r: &smartbed_bed::map::Recording| -> f64 {
            let f = r.frames().last().expect("a map");
            r.sites().iter().zip(&f.pressure).map(|(s, p)| s.area * p).sum()
        };
        let ratio = load(&history.skin) / load(&history.sensels);
        assert!((ratio - 1.0).abs() < 0.15, "{ratio}");
    }
}

#[test]
fn a_run_gives_the_same_numbers_again() {
    let p = plan(2, 2, vec![Move { pressure: Some(2000.0), ..change(&[1]) }]);
    let [a, b] = [0, 1].map(|_| run(&p, |_| true).expect("runs"));
    assert_eq!(a.moments, b.moments);
    assert_eq!(a.sensels, b.sensels);
}

#[test]
fn an_alternating_cycle_relieves_the_skin() {
    let layout = Layout { intervals: [6, 8], ..Layout::default() };
    let figure = Figure::new(Table::DeLevaMale, 75.0, 1.75, Posture::Supine, &[]).expect("a figure");
    let load = Load { body: figure.body.clone(), poses: figure.poses.clone(), figure: Some(figure) };
    let moves = Plan::alternating(&layout, 1600.0, 5000.0, 600.0, 600.0);
    let p = Plan {
        title: "alternating".to_owned(),
        layout,
        pressure: 5000.0,
        load: load.placed([0.0, 0.0]),
        moves,
        seconds: 600.0,
        every: 25.0,
        cycle: 600.0,
        clock: Clock::QuasiStatic,
        laying: Laying::AtOnce,
    };
    check(&p).expect("within limits");
    let begin = std::time::Instant::now();
    let history = run(&p, |_| true).expect("runs");
    let taken = begin.elapsed().as_secs_f64();
    assert!(taken < 120.0, "{taken} s");
    assert!(history.moments.iter().all(|m| m.imbalance < 1e-6 && m.sensed < 0.01));
    let always = time::always_at_risk(&history.skin, 32.0 * 133.322);
    let occluded = time::persistent_occlusion(&history.skin, 600.0, 32.0 * 133.322).expect("a cycle");
    let ever: f64 = {
        let first = &history.skin.frames()[0];
        smartbed_bed::metrics::spatial::area_above(history.skin.sites(), &first.pressure, 32.0 * 133.322)
    };
    println!("occluded at first {ever:.4} m^2, always {always:.4}, over the cycle {occluded:.4}");
    assert!(occluded < 0.6 * ever, "{occluded} {ever}");
}

#[test]
fn a_finer_sheet_changes_the_peak_pressure_index_little() {
    let index = |n: usize| {
        let mut p = plan(1, 1, Vec::new());
        p.layout.intervals = [n, n];
        p.pressure = 2000.0;
        let name = "ball".to_owned();
        let shape = Shape::ball(0.1);
        let segment = Segment {
            name,
            shape: shape.into(),
            mass: 5.0,
            centre: [0.0; 3],
            foundation: 2e6,
            free: [true; 6],
        };
        let load = Load { body: Body::single(segment), poses: vec![Pose::at([0.0; 3])], figure: None };
        p.load = load.placed([0.0; 2]);
        p.seconds = 0.0;
        let history = run(&p, |_| true).expect("an equilibrium");
        let map = &history.sensels.frames()[0].pressure;
        spatial::peak_pressure_index(&history.grid, map, 9e-4).expect("a window")
    };
    let [coarse, fine] = [28, 56].map(index);
    println!("PPI {coarse} Pa with 27 nodes a side, {fine} Pa with 55");
    assert!((fine / coarse - 1.0).abs() < 0.05, "{coarse} {fine}");
}

#[test]
fn areas_are_those_of_the_map_that_is_measured() {
    // Without friction a bed that was at 4 kPa and one that never was press alike at 2 kPa, and on as much area.
    let told = |pressure: f64, moves: Vec<Move>| {
        let mut p = plan(2, 2, moves);
        p.layout.friction = 0.0;
        p.pressure = pressure;
        p.load.body.segments[0].free = [false, false, true, false, false, false];
        run(&p, |_| true).expect("a run")
    };
    let low = Move { at: 5.0, over: 10.0, pressure: Some(2000.0), ..change(&[0, 1, 2, 3]) };
    let [let_down, low] = [told(4000.0, vec![low]), told(2000.0, Vec::new())];
    let measured = |history: &smartbed_bed::plan::history::History| {
        let (sites, last) = (history.sensels.sites(), history.sensels.frames().last().expect("a map"));
        let spread = spatial::spread(sites, &last.pressure, 0.0).expect("contact");
        [spatial::area_above(sites, &last.pressure, 0.0), spread.mean]
    };
    let [a, b] = [&let_down, &low].map(measured);
    println!("area {:.6e} and {:.6e} m2, mean {:.4} and {:.4} Pa", a[0], b[0], a[1], b[1]);
    assert!((a[0] / b[0] - 1.0).abs() < 1e-6 && (a[1] / b[1] - 1.0).abs() < 1e-6, "{a:?} {b:?}");
    // All that presses carries the weight; slopes at the edges of the slab press sideways too.
    assert!((1.0..1.1).contains(&(a[0] * a[1] / (12.0 * 9.81))), "{a:?}");
}
