//! Orders at moments at which something is under way or wrong: each is carried out, or refused and changes nothing.

use crate::bench::{Bench, FRICTIONS, drive, target};
use smartbed_firmware::link::message::{Command, Outcome, Refusal, Trim};
use smartbed_firmware::plant::Defect;
use smartbed_firmware::tile::design::{PRESSURE, STROKE};
use smartbed_firmware::tile::drive::DRIVE;
use smartbed_firmware::tile::mode::Mode;

/// A tile on its way down.
fn on_its_way_down(ticks: u32, friction: Option<bool>) -> Bench {
    let mut bench = Bench::homed(25.0, [0.03, 0.0], drive(friction));
    bench.order(target(0.012, 0.0, 0.0));
    bench.until(Mode::Ready, 60_000);
    bench.order(target(-0.012, 0.05, 0.0));
    bench.run(ticks);
    bench
}

/// Legs that still move would show the motor of the new motion less work than they do later.
#[test]
fn resuscitation_may_begin_at_any_moment_of_a_motion() {
    for friction in FRICTIONS {
        for start in (100..4000).step_by(390) {
            let mut bench = on_its_way_down(start, friction);
            bench.order(Command::Flatten);
            bench.run(1000);
            assert_eq!(
                (bench.controller.mode(), bench.faults()),
                (Mode::Flatten, vec![]),
                "{start}, {friction:?}"
            );
        }
    }
    let mut bench = on_its_way_down(2000, None);
    bench.order(Command::Flatten);
    bench.run(30_000);
    assert!((bench.pose().zc + STROKE).abs() < 1e-4 && bench.faults().is_empty(), "{:?}", bench.faults());
}

#[test]
fn resuscitation_during_a_retreat_begins_at_its_end() {
    let (leg, height, above) = (1_u8, -0.004, false);
    let retreating = || {
        let mut bench = Bench::homed(25.0, [0.03, 0.0], DRIVE);
        bench.tile.air.fill(4000.0);
        bench.order(target(0.0, 0.0, 0.0));
        bench.until(Mode::Ready, 30_000);
        bench.tile.set_defect(Some(Defect::Block { leg, height, above }));
        bench.order(target(-0.012, 0.0, 0.0));
        bench.until(Mode::Retreat, 30_000);
        bench.run(500);
        bench
    };
    let mut bench = retreating();
    let lowest = bench.tile.heights()[usize::from(leg)];
    bench.order(Command::Flatten);
    // Neither stopped nor hurried, and the air goes at once.
    assert_eq!((bench.controller.mode(), bench.controller.outputs().vent), (Mode::Retreat, true));
    let mut back = 0.0_f32;
    let mut ticks = 0;
    while bench.controller.mode() == Mode::Retreat {
        bench.tick(None);
        back = back.max(bench.tile.heights()[usize::from(leg)] - lowest);
        ticks += 1;
    }
    assert!(back > 4e-3, "{back} m");
    bench.tile.set_defect(None);
    assert_eq!(bench.controller.mode(), Mode::Flatten);
    bench.run(30_000 - ticks);
    let down = (bench.pose().zc + STROKE).abs() < 1e-4;
    assert!(
        down && bench.tile.air.pressure() < 100.0,
        "{:?}, {} Pa",
        bench.pose(),
        bench.tile.air.pressure()
    );
    assert_eq!(bench.faults(), ["Obstruction"]);
    // Nothing else moves before the fault is cleared and motion is allowed again.
    assert_eq!(bench.tick(Some(&target(0.0, 0.0, 0.0))), Some(Outcome::Refused(Refusal::Faulted)));

    // Stop takes it back.
    let mut bench = retreating();
    bench.order(Command::Flatten);
    bench.order(Command::Stop);
    bench.run(10_000);
    assert_eq!((bench.controller.mode(), bench.controller.outputs().enable), (Mode::Hold, false));
}

#[test]
fn a_motion_right_after_a_stop_waits_until_the_legs_stand() {
    for pause in [0, 1, 3, 6, 20] {
        let mut bench = on_its_way_down(1500, None);
        bench.order(Command::Stop);
        bench.run(pause);
        bench.order(Command::Enable);
        bench.order(target(-0.012, 0.05, 0.0));
        let fastest =
            |bench: &Bench| bench.controller.sense().speeds.iter().fold(0.0_f32, |most, u| most.max(u.abs()));
        assert_eq!(fastest(&bench) > 1e-4, !bench.controller.outputs().enable, "{pause}");
        bench.until(Mode::Ready, 30_000);
        assert_eq!((bench.faults(), (bench.pose().zc + 0.012).abs() < 1e-4), (vec![], true), "{pause}");
    }
    // Homing is a motion too.
    let mut bench = on_its_way_down(1500, None);
    bench.order(Command::Stop);
    bench.order(Command::Enable);
    bench.order(Command::Home);
    bench.until(Mode::Ready, 60_000);
    assert!(bench.faults().is_empty());
}

#[test]
fn a_tile_that_is_lowered_cannot_be_enabled_before_it_is_down() {
    let mut bench = on_its_way_down(1500, None);
    bench.tile.air.fill(4000.0);
    bench.order(Command::Flatten);
    bench.run(1000);
    assert_eq!(bench.tick(Some(&Command::Enable)), Some(Outcome::Refused(Refusal::Busy)));
    assert_eq!(bench.controller.mode(), Mode::Flatten);
    bench.run(29_000);
    assert!((bench.pose().zc + STROKE).abs() < 1e-4 && bench.tile.air.pressure() < 100.0);
    bench.order(Command::Enable);
    assert_eq!((bench.controller.mode(), bench.faults()), (Mode::Ready, vec![]));
}

/// A vent that does not open is told, and no reason to stop half-way.
#[test]
fn a_bladder_that_does_not_empty_is_lowered_all_the_same() {
    let mut bench = Bench::homed(25.0, [0.03, 0.0], DRIVE);
    bench.order(target(0.012, 0.0, 0.0));
    bench.until(Mode::Ready, 60_000);
    bench.tile.air.fill(4000.0);
    bench.tile.set_defect(Some(Defect::ValveShut { vent: true }));
    bench.order(Command::Flatten);
    bench.run(30_000);
    assert_eq!((bench.controller.mode(), bench.faults()), (Mode::Flatten, vec!["ValveShut"]));
    assert!((bench.pose().zc + STROKE).abs() < 1e-4, "{:?}", bench.pose());
}

#[test]
fn a_calibration_tells_heights_at_once() {
    let mut bench = Bench::new(25.0, [0.0; 2], [-0.02; 3], DRIVE);
    bench.run(200);
    bench.order(Command::Calibrate(Trim::default()));
    let heights = bench.controller.state().heights;
    assert!(heights.iter().all(|height| (height + 0.02).abs() < 3e-4), "{heights:?}");
}

#[test]
fn a_calibration_clears_no_fault() {
    let mut bench = Bench::ready(25.0, [0.0; 2], [0.0; 3], DRIVE);
    bench.tile.air.fill(9000.0);
    bench.order(Command::Pressure(9000.0));
    bench.tile.set_defect(Some(Defect::ValveOpen { vent: false }));
    bench.until(Mode::Off, 60_000);
    bench.run(20_000);
    bench.order(Command::Calibrate(Trim::default()));
    let mut highest = 0.0_f32;
    for _ in 0..20_000 {
        bench.tick(None);
        highest = highest.max(bench.tile.air.pressure());
    }
    assert_eq!((bench.controller.mode(), bench.faults().contains(&"Overpressure")), (Mode::Off, true));
    assert!(highest < PRESSURE + 1500.0, "{highest} Pa: the vent is forced while sensors settle, too");
    // Repaired and cleared by name it is ready to be allowed to move.
    bench.tile.set_defect(None);
    bench.run(10_000);
    bench.order(Command::Clear(bench.controller.latched().bits()));
    assert_eq!(bench.controller.mode(), Mode::Unhomed);

    // It keeps the air that it has, although another pressure had been ordered.
    bench.run(20_000);
    let left = bench.tile.air.pressure();
    assert!((left - PRESSURE).abs() < 100.0, "{left} Pa");

    // Without a fault it is ready again.
    let mut bench = Bench::homed(25.0, [0.0; 2], DRIVE);
    bench.order(Command::Stop);
    bench.order(Command::Calibrate(Trim::default()));
    bench.run(200);
    assert_eq!((bench.controller.mode(), bench.faults()), (Mode::Unhomed, vec![]));
}
