//! An obstacle in a leg's way is detected and released; a mere shift of the load is not taken for one.

use crate::bench::{Bench, FRICTIONS, drive, target};
use smartbed_firmware::link::message::Command;
use smartbed_firmware::plant::Defect;
use smartbed_firmware::plant::single::Parameters;
use smartbed_firmware::tile::design::{AREA, GRAVITY};
use smartbed_firmware::tile::mode::Mode;

#[test]
fn an_obstruction_is_left_alone() {
    let ways = [(true, 0.004, 0.01), (false, -0.004, -0.01)];
    let kinds = FRICTIONS.into_iter().flat_map(|f| [0.0, 25.0].map(|mass| (f, mass)));
    let kinds = kinds.flat_map(|(f, mass)| [0.0, 1.0].map(|shown| (f, mass, shown)));
    for ((friction, mass, shown), (above, height, way)) in kinds.flat_map(|kind| ways.map(|way| (kind, way)))
    {
        let mut bench = Bench::homed(mass, [0.0; 2], drive(friction));
        bench.tile.air.fill(shown * mass * GRAVITY / AREA);
        bench.order(target(0.0, 0.0, 0.0));
        bench.until(Mode::Ready, 30_000);
        bench.tile.set_defect(Some(Defect::Block { leg: 1, height, above }));
        bench.order(target(way, 0.0, 0.0));
        let (mut hardest, mut farthest) = (0.0_f32, 0.0_f32);
        while matches!(bench.controller.mode(), Mode::Moving | Mode::Retreat) {
            bench.tick(None);
            hardest = hardest.max(bench.tile.contacts()[1].abs());
            farthest = farthest.max(bench.tile.heights()[1] * way.signum());
        }
        let back = farthest - bench.tile.heights()[1] * way.signum();
        println!("{friction:?}, {mass} kg shown {shown}, above {above}: {hardest} N, {} mm back", back * 1e3);
        assert_eq!((bench.controller.mode(), bench.faults()), (Mode::Hold, vec!["Obstruction"]));
        assert!(hardest < 150.0, "{hardest} N");
        assert!((back - 5e-3).abs() < 2e-4, "{back}");
    }
}

/// Lowers or homes the tile onto an obstacle below leg 1; returns the largest force (N), and how far the leg moved back
/// (m).
fn go_down(bench: &mut Bench, command: Command) -> (f32, f32) {
    bench.order(command);
    let (mut hardest, mut lowest) = (0.0_f32, bench.tile.heights()[1]);
    for _ in 0..60_000 {
        if !matches!(bench.controller.mode(), Mode::Homing | Mode::Flatten | Mode::Retreat) {
            break;
        }
        bench.tick(None);
        hardest = hardest.max(bench.tile.contacts()[1].abs());
        lowest = lowest.min(bench.tile.heights()[1]);
    }
    (hardest, bench.tile.heights()[1] - lowest)
}

/// Resuscitation is allowed despite the fault that the obstacle has left.
#[test]
fn an_obstacle_is_left_alone_each_time_the_tile_is_lowered_onto_it() {
    for friction in FRICTIONS {
        let mut bench = Bench::ready(20.0, [0.0; 2], [0.0; 3], drive(friction));
        bench.tile.set_defect(Some(Defect::Block { leg: 1, height: -0.01, above: false }));
        for _ in 0..3 {
            let (hardest, back) = go_down(&mut bench, Command::Flatten);
            println!("{friction:?}: {hardest} N, {} mm back", back * 1e3);
            assert_eq!((bench.controller.mode(), bench.faults()), (Mode::Hold, vec!["Obstruction"]));
            assert!(hardest < 150.0, "{hardest} N");
            assert!((back - 5e-3).abs() < 3e-4, "{back}");
        }
    }
}

#[test]
fn an_obstacle_is_left_alone_while_switches_are_searched() {
    for (friction, height) in FRICTIONS.into_iter().flat_map(|f| [-0.01, -0.024].map(|height| (f, height))) {
        let mut bench = Bench::ready(20.0, [0.0; 2], [0.0; 3], drive(friction));
        bench.tile.set_defect(Some(Defect::Block { leg: 1, height, above: false }));
        let (hardest, back) = go_down(&mut bench, Command::Home);
        println!("{friction:?}: {hardest} N, {} mm back, {:?}", back * 1e3, bench.faults());
        assert_eq!((bench.controller.mode(), bench.faults()), (Mode::Hold, vec!["Obstruction"]));
        assert!(hardest < 150.0, "{hardest} N");
        assert!((back - 5e-3).abs() < 3e-4, "{back}");
    }
}

/// A steep tilt shifts the load of a patient from leg to leg, whatever friction is and however much of the load the
/// bladder shows: no obstruction.
#[test]
fn a_steep_tilt_under_load_is_no_obstruction() {
    let ways = [([0.0, 0.0], 1.0), ([0.02, -0.01], 0.7), ([0.04, 0.0], 0.35)];
    let mut wrong = Vec::new();
    for (friction, shown) in FRICTIONS.into_iter().flat_map(|f| [0.0, 0.4, 1.0].map(|shown| (f, shown))) {
        for (offset, share) in ways {
            let directions = [(0.26, 0.0), (-0.13, 0.22), (0.0, -0.26)];
            for (tx, ty) in directions.into_iter().take(if share == 1.0 { 3 } else { 1 }) {
                let mut bench = Bench::ready(25.0, offset, [0.0; 3], drive(friction));
                bench.tile.air.fill(shown * 25.0 * GRAVITY / AREA);
                for (tx, ty) in [(tx * share, ty * share), (0.0, 0.0)] {
                    bench.order(target(0.0, tx, ty));
                    while bench.controller.mode() == Mode::Moving {
                        bench.tick(None);
                    }
                    let (mode, faults) = (bench.controller.mode(), bench.faults());
                    if mode != Mode::Unhomed {
                        wrong.push(format!("{friction:?} {shown} {offset:?} to {tx} {ty}: {faults:?}"));
                        break;
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Steps of heave (mm), repeated. Positive is up; with the opposite sign the pattern goes down.
const PATTERNS: [&[f32]; 14] = [
    &[0.1],
    &[0.2],
    &[0.3],
    &[0.45],
    &[0.5],
    &[0.7],
    &[0.94],
    &[1.0],
    &[1.5],
    &[3.0],
    // Back and forth.
    &[0.2, 0.2, 0.2, -0.2],
    &[0.4, 0.4, -0.6],
    &[1.0, -0.5],
    &[1.5, -1.2],
];

/// Patients: mass (kg), and offset from the tile's middle (m).
const PATIENTS: [(f32, [f32; 2]); 3] = [(0.0, [0.0; 2]), (25.0, [0.02, -0.01]), (25.0, [0.04, 0.0])];

/// Follows a pattern of steps (mm) from this heave (m) for so far in all (m), or until the tile no longer waits for
/// orders; returns the largest force of an obstacle.
fn follow(bench: &mut Bench, from: f32, pattern: &[f32], sign: f32, way: f32) -> f32 {
    let (mut heave, mut hardest) = (from, 0.0_f32);
    for step in pattern.iter().cycle() {
        heave += sign * step * 1e-3;
        bench.order(target(heave, 0.0, 0.0));
        while matches!(bench.controller.mode(), Mode::Moving | Mode::Retreat) {
            bench.tick(None);
            hardest = bench.tile.contacts().iter().fold(hardest, |most, force| most.max(force.abs()));
        }
        if !bench.controller.mode().rests() || (heave - from).abs() >= way {
            break;
        }
        bench.run(20);
    }
    hardest
}

/// One trial: friction, patient, pattern, up or down.
type Trial = (Option<bool>, (f32, [f32; 2]), &'static [f32], f32);

/// All of them.
fn trials() -> impl Iterator<Item = Trial> {
    let kinds = FRICTIONS.into_iter().flat_map(|friction| PATIENTS.map(|patient| (friction, patient)));
    let patterns = PATTERNS.into_iter().flat_map(|pattern| [(pattern, 1.0), (pattern, -1.0)]);
    kinds.flat_map(move |(f, p)| patterns.clone().map(move |(pattern, sign)| (f, p, pattern, sign)))
}

/// Many short motions, also back and forth, press on an obstacle no harder than a long one, wherever it is; the leg
/// then retreats.
#[test]
fn short_ways_lean_on_an_obstacle_no_harder() {
    let places = [(0, -0.012), (1, 0.0), (2, 0.012)];
    let (mut wrong, mut most) = (Vec::new(), 0.0_f32);
    for (n, (friction, (mass, offset), pattern, sign)) in trials().enumerate() {
        let (leg, at) = places[n % places.len()];
        let mut bench = Bench::ready(mass, offset, [at; 3], drive(friction));
        let height = at + sign * 4e-4;
        bench.tile.set_defect(Some(Defect::Block { leg, height, above: sign > 0.0 }));
        let hardest = follow(&mut bench, at, pattern, sign, 8e-3);
        most = most.max(hardest);
        let (mode, found) = (bench.controller.mode(), bench.faults());
        let is_left = (bench.tile.heights()[usize::from(leg)] - height) * sign < 0.0;
        if (mode, found.as_slice()) != (Mode::Hold, &["Obstruction"]) || hardest > 150.0 || !is_left {
            wrong.push(format!(
                "{friction:?}, {mass} kg {offset:?}, {pattern:?} {sign}, leg {leg} at {at}: {mode:?}, {hardest} N, {found:?}, left {is_left}"
            ));
        }
    }
    println!("at most {most} N");
    assert!(wrong.is_empty(), "{}\n{}", wrong.len(), wrong.join("\n"));
}

/// Without an obstacle the same motions report none, over 30 mm; back and forth over 10 mm.
#[test]
fn short_ways_alone_are_no_obstacle() {
    let mut wrong = Vec::new();
    for (friction, (mass, offset), pattern, sign) in trials() {
        let from = -0.015 * sign;
        let mut bench = Bench::ready(mass, offset, [from; 3], drive(friction));
        let way = if pattern.len() == 1 { 0.03 } else { 0.01 };
        follow(&mut bench, from, pattern, sign, way);
        let (mode, found) = (bench.controller.mode(), bench.faults());
        if mode != Mode::Unhomed || !found.is_empty() {
            wrong
                .push(format!("{friction:?}, {mass} kg {offset:?}, {pattern:?} {sign}: {mode:?}, {found:?}"));
        }
    }
    assert!(wrong.is_empty(), "{}\n{}", wrong.len(), wrong.join("\n"));
}

/// Nor are tilts by small steps, there and back, which shift the load from leg to leg.
#[test]
fn tilts_by_short_ways_are_no_obstacle() {
    let mut wrong = Vec::new();
    for (friction, offset) in FRICTIONS.into_iter().flat_map(|f| [[0.0, 0.0], [0.02, -0.01]].map(|o| (f, o)))
    {
        for (slope, count) in [(0.003, 60_u8), (0.012, 15)] {
            let mut bench = Bench::ready(25.0, offset, [0.0; 3], drive(friction));
            for n in (1..=count).chain((0..count).rev()) {
                bench.order(target(0.0, slope * f32::from(n), 0.0));
                while bench.controller.mode() == Mode::Moving {
                    bench.tick(None);
                }
                if !bench.controller.mode().rests() {
                    wrong.push(format!("{friction:?} {offset:?} {slope} {n}: {:?}", bench.faults()));
                    break;
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Nor is a patient who turns over between two motions, nor one who is rocked for long.
#[test]
fn a_patient_who_moves_is_no_obstacle() {
    let mut wrong = Vec::new();
    for (friction, way) in FRICTIONS.into_iter().flat_map(|f| [2e-3, 1e-2].map(|way| (f, way))) {
        let mut bench = Bench::ready(25.0, [0.04, 0.0], [0.0; 3], drive(friction));
        for n in 0..40 {
            let turn = n as f32 * 2.4;
            let before = *bench.tile.mechanism().parameters();
            bench.tile.mechanism().set_parameters(Parameters {
                x_payload: 0.04 * turn.cos(),
                y_payload: 0.04 * turn.sin(),
                ..before
            });
            let side = if n % 2 == 0 { way } else { -way };
            bench.order(target(side, 5.0 * side, -3.0 * side));
            while bench.controller.mode() == Mode::Moving {
                bench.tick(None);
            }
            if !bench.controller.mode().rests() {
                wrong.push(format!("{friction:?} {way} {n}: {:?}", bench.faults()));
                break;
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
