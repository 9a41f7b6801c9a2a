//! Policies: their inputs, their refused commands, and that the planner relieves more skin than alternating pressure.

use smartbed_bed::body::anthropometry::Table;
use smartbed_bed::body::figure::{Figure, Posture};
use smartbed_bed::body::{Body, Segment, Shape};
use smartbed_bed::metrics::time;
use smartbed_bed::plan::history::{History, RunError};
use smartbed_bed::plan::{Clock, Dynamics, Laying, Layout, Load, Move, Plan, Start};
use smartbed_bed::policy::bounds::Bounds;
use smartbed_bed::policy::planner::{Goal, Planner};
use smartbed_bed::policy::run::run as run_policy;
use smartbed_bed::policy::scheduled::Scheduled;
use smartbed_bed::policy::{Policy, View};
use smartbed_bed::pose::Pose;
use smartbed_bed::sensor::reader::{Quality, Reader};
use smartbed_bed::sensor::site::Site;

const OCCLUSION: f64 = 32.0 * 133.322;

fn supine(seconds: f64, every: f64) -> Plan {
    patient(75.0, Posture::Supine, 5000.0, [seconds, every])
}

fn patient(mass: f64, posture: Posture, pressure: f64, [seconds, every]: [f64; 2]) -> Plan {
    let layout = Layout { intervals: [6, 8], ..Layout::default() };
    let figure = Figure::new(Table::DeLevaMale, mass, 1.75, posture, &[]).expect("a figure");
    let load = Load { body: figure.body.clone(), poses: figure.poses.clone(), figure: Some(figure) };
    Plan {
        title: "supine".to_owned(),
        layout,
        pressure,
        load: load.placed([0.0, 0.0]),
        moves: Vec::new(),
        seconds,
        every,
        cycle: 600.0,
        clock: Clock::QuasiStatic,
        laying: Laying::AtOnce,
    }
}

fn reader() -> Reader {
    Reader::new(&Site::default(), Quality::default()).expect("a surface")
}

/// Sum of all commanded changes of pressure (Pa).
fn motion(plan: &Plan, history: &History) -> f64 {
    let told = plan.with(&history.moves);
    let times: Vec<f64> = plan.times();
    let of = |tile: usize| -> f64 {
        times
            .windows(2)
            .map(|w| (told.order(tile, w[1]).pressure - told.order(tile, w[0]).pressure).abs())
            .sum()
    };
    (0..plan.layout.count()).map(of).sum()
}

#[test]
fn the_planner_relieves_more_than_alternating_pressure_with_less_motion_within_its_bounds() {
    let plan = supine(600.0, 10.0);
    let run = |policy: &mut dyn Policy, bounds: &Bounds| {
        run_policy(&plan, policy, bounds, None, Some(&reader()), |_| true).expect("runs")
    };
    let shut =
        |history: &History| time::persistent_occlusion(&history.skin, 600.0, OCCLUSION).expect("a cycle");
    // Alternating pressure lets half of all bladders down: no bound of the planner's lets it.
    let half = Bounds { most_low: 14, ..Bounds::default() };
    let mut alternating = Scheduled::alternating(&plan.layout, 1600.0, 5000.0, 600.0, 600.0);
    let usual = run(&mut alternating, &half);
    let bounds = Bounds::default();
    let planned = run(&mut Planner::new(Goal::default()), &bounds);
    let [before, after] = [&usual, &planned].map(|h| (shut(h), motion(&plan, h)));
    let risk = |history: &History| time::always_at_risk(&history.skin, OCCLUSION);
    println!("always at risk {:.5} m^2 alternating, {:.5} planned", risk(&usual), risk(&planned));
    println!(
        "shut {:.5} m^2 by {:.0} kPa alternating, {:.5} m^2 by {:.0} kPa planned",
        before.0,
        before.1 / 1e3,
        after.0,
        after.1 / 1e3
    );
    assert!(after.0 < 0.8 * before.0 && after.1 < before.1, "{before:?} {after:?}");
    for moment in &planned.moments {
        assert!(moment.imbalance < 1e-6 && moment.sensed < 0.01);
        let low = moment.orders.iter().filter(|o| o.pressure < bounds.low).count();
        assert!(low <= bounds.most_low, "{low} at {}", moment.time);
    }
    assert!(planned.moments.iter().any(|m| m.orders.iter().any(|o| o.pressure < bounds.low)));
}

/// Ways of all tiles' middles up and down (m).
fn ways(history: &History) -> f64 {
    let pairs = history.moments.windows(2).flat_map(|w| w[0].orders.iter().zip(&w[1].orders));
    pairs.map(|(a, b)| (b.command.heave - a.command.heave).abs()).sum()
}

#[test]
fn patients_of_several_weights_and_postures_are_relieved_by_lowering_where_letting_down_is_in_vain() {
    let quiet = Goal { lower: 0.0, tilt: 0.0, ..Goal::default() };
    let bounds = Bounds::default();
    // Alternating pressure lets half of all bladders down.
    let half = Bounds { most_low: 14, ..bounds };
    let mut sums = [0.0; 2];
    for (mass, posture, pressure) in [
        (50.0, Posture::Supine, 4500.0),
        (120.0, Posture::Supine, 6500.0),
        (85.0, Posture::SideLying, 5500.0),
    ] {
        let plan = patient(mass, posture, pressure, [600.0, 10.0]);
        let runs = [quiet, Goal::default()].map(|goal| {
            run_policy(&plan, &mut Planner::new(goal), &bounds, None, Some(&reader()), |_| true)
                .expect("runs")
        });
        let shut_in = |history: &History| {
            1e4 * time::persistent_occlusion(&history.skin, 600.0, OCCLUSION).expect("a cycle")
        };
        let shut = runs.each_ref().map(shut_in);
        let mut alternating = Scheduled::alternating(&plan.layout, 1600.0, pressure, 600.0, 600.0);
        let usual =
            run_policy(&plan, &mut alternating, &half, None, Some(&reader()), |_| true).expect("runs");
        println!("alternating {:.1} cm2 by {:.0} kPa", shut_in(&usual), motion(&plan, &usual) / 1e3);
        assert!(shut[1] <= 0.6 * shut_in(&usual), "{shut:?}");
        let [told, more] = runs.each_ref().map(|history| motion(&plan, history) / 1e3);
        println!(
            "{mass} kg {posture:?}: {shut:.1?} cm2 by {told:.0} and {more:.0} kPa, {:.2} m",
            ways(&runs[1])
        );
        assert!(shut[1] <= shut[0] * (1.0 + 1e-9) && more <= told, "{shut:?} {told} {more}");
        assert_eq!(ways(&runs[0]), 0.0);
        for moment in runs.iter().flat_map(|history| &history.moments) {
            assert!(moment.imbalance < 1e-6);
            assert!(moment.orders.iter().filter(|o| o.pressure < bounds.low).count() <= bounds.most_low);
        }
        // All that was told at any time keeps to stroke, speed, steps, gaps and pressures.
        smartbed_bed::plan::check::check(&plan.with(&runs[1].moves)).expect("within all limits");
        (0..2).for_each(|k| sums[k] += shut[k]);
    }
    assert!(sums[1] < 0.85 * sums[0], "{sums:?}");
}

/// Tells one move, once.
struct Once(Option<Move>);

impl Policy for Once {
    fn decide(&mut self, view: &View<'_>) -> Vec<Move> {
        // A move that begins at once is told when time has begun to run.
        if view.time < 5.0 && self.0.as_ref().is_some_and(|m| m.over == 0.0) {
            return Vec::new();
        }
        self.0.take().into_iter().collect()
    }
}

#[test]
fn a_policy_is_refused_by_name_before_a_tile_hears_of_it() {
    let plan = supine(40.0, 10.0);
    let told =
        |tiles: Vec<usize>| Move { at: 10.0, over: 20.0, tiles, pressure: None, heave: None, slope: None };
    let say = |told: Move, bounds: Bounds| match run_policy(
        &plan,
        &mut Once(Some(told)),
        &bounds,
        None,
        None,
        |_| true,
    ) {
        Err(RunError::Refused(refusal)) => refusal.to_string(),
        other => panic!("{other:?}"),
    };
    let usual = Bounds::default();
    let low = |tiles: Vec<usize>| Move { pressure: Some(1000.0), ..told(tiles) };
    assert_eq!(
        say(low(vec![0, 1, 2, 3, 4]), usual),
        "at 30.0000 s: 5 bladders are below 2.50 kPa, expected 4 at most"
    );
    let weak = say(low((4..28).collect()), Bounds { most_low: 28, ..usual });
    assert!(
        weak.contains("bladders in reach can carry") && weak.contains("1.2 times the weight of 736 N"),
        "{weak}"
    );
    let high = say(Move { heave: Some(0.05), ..told((0..28).collect()) }, usual);
    assert!(high.contains("expected at most 30.0 mm"), "{high}");
    let quick = say(Move { heave: Some(0.02), over: 1.0, ..told((0..28).collect()) }, usual);
    assert!(quick.contains("expected at most 6.70 mm/s"), "{quick}");
    let jump = say(Move { heave: Some(0.002), over: 0.0, ..told((0..28).collect()) }, usual);
    assert!(jump.contains("mm/s, expected at most 6.70 mm/s"), "{jump}");
    let step = say(Move { heave: Some(0.025), ..told(vec![9]) }, usual);
    assert!(step.contains("step of 25.0 mm"), "{step}");
}

#[test]
fn a_policy_sees_what_sensors_read_and_the_same_again() {
    let plan = supine(60.0, 10.0);
    let run = |seed: u64| {
        let reader =
            Reader::new(&Site::default(), Quality { seed, ..Quality::default() }).expect("a surface");
        let goal = Goal { cycle: 60.0, slots: 2, ramp: 10.0, hold: 10.0, ..Goal::default() };
        let mut planner = Planner::new(goal);
        run_policy(&plan, &mut planner, &Bounds::default(), None, Some(&reader), |_| true).expect("runs")
    };
    let [one, again] = [run(3), run(3)];
    assert_eq!((&one.moments, &one.moves), (&again.moments, &again.moves));
    assert!(!one.moves.is_empty());
    // Nothing that presses: nothing moves.
    let mut empty = plan.clone();
    empty.load = Load { body: Default::default(), poses: Vec::new(), figure: None };
    let mut planner = Planner::new(Goal::default());
    let history =
        run_policy(&empty, &mut planner, &Bounds::default(), None, Some(&reader()), |_| true).expect("runs");
    assert!(history.moves.is_empty());
}

/// A flat load on four tiles, in motion for some seconds, let go above them or not.
fn in_motion(seconds: f64, start: Start) -> Plan {
    let segment = Segment {
        name: "slab".to_owned(),
        shape: Shape { half: [0.12, 0.12, 0.0], radius: 0.02 }.into(),
        mass: 15.0,
        centre: [0.0; 3],
        foundation: 1e7,
        free: [true; 6],
    };
    let load = Load { body: Body::single(segment), poses: vec![Pose::at([0.0; 3])], figure: None };
    Plan {
        layout: Layout { rows: 2, columns: 2, intervals: [6, 6], ..Layout::default() },
        load: load.placed([0.02, 0.01]),
        clock: Clock::Dynamics(Dynamics { start, step: 4e-3, ..Dynamics::default() }),
        seconds,
        every: 0.5,
        ..supine(0.0, 1.0)
    }
}

#[test]
fn a_policy_is_asked_once_the_load_that_falls_lies() {
    let bounds = Bounds { most_low: 2, ..Bounds::default() };
    let alternating = |plan: &Plan, bounds: &Bounds| {
        let mut policy = Scheduled::alternating(&plan.layout, 3000.0, plan.pressure, 60.0, plan.seconds);
        run_policy(plan, &mut policy, bounds, None, None, |_| true)
    };
    let fallen = in_motion(6.0, Start::Dropped(0.02));
    let history = alternating(&fallen, &bounds).expect("runs");
    let lay = history.lay.expect("comes to lie");
    println!("lies from {lay} s on");
    assert!((0.5..5.0).contains(&lay), "{lay}");
    assert!(!history.moves.is_empty() && history.moves.iter().all(|told| told.at >= lay));
    assert!(history.moments.iter().all(|m| m.imbalance < 1e-6));
    let last = history.moments.last().expect("a moment");
    assert!(last.gauges.iter().any(|p| *p < 4900.0), "{:?}", last.gauges);
    // What rests from the start is asked about from the start; what is in flight all the while never.
    assert_eq!(alternating(&in_motion(0.5, Start::AtRest), &bounds).expect("runs").lay, Some(0.0));
    let short = Plan { seconds: 0.1, every: 0.05, ..in_motion(0.5, Start::Dropped(0.1)) };
    let flight = alternating(&short, &bounds).expect("runs");
    assert!(flight.lay.is_none() && flight.moves.is_empty());
    // Bladders that cannot carry what lies on them are refused when it lies.
    let refused = alternating(&fallen, &Bounds { support: 100.0, ..bounds }).expect_err("cannot carry");
    let RunError::Refused(refusal) = refused else { panic!("{refused}") };
    assert!(refusal.time >= lay && refusal.what.contains("100 times the weight of 147 N"), "{refusal}");
}
