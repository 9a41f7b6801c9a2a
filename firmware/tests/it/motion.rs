//! The controller on the plant: requirements on the tile.

use crate::bench::{Bench, FRICTIONS, drive, target};
use smartbed_firmware::command::Pose;
use smartbed_firmware::link::message::{Command, Target, Trim};
use smartbed_firmware::plant::Defect;
use smartbed_firmware::tile::board::{Readings, Sensors};
use smartbed_firmware::tile::controller::Controller;
use smartbed_firmware::tile::design::{PAYLOAD, PRESSURE, RADIUS};
use smartbed_firmware::tile::drive::DRIVE;
use smartbed_firmware::tile::fault::{Fault, Faults};
use smartbed_firmware::tile::mode::Mode;

const FIVE_DEGREES: f32 = 0.087_488_66;

#[test]
fn homed_it_goes_where_it_is_told() {
    for friction in FRICTIONS {
        let mut bench = Bench::homed(25.0, [0.04, 0.0], drive(friction));
        bench.order(target(0.0, 0.0, 0.0));
        bench.until(Mode::Ready, 30_000);
        bench.order(target(0.0, FIVE_DEGREES, 0.0));
        let mut steepest = 0.0_f32;
        while bench.controller.mode() == Mode::Moving {
            bench.tick(None);
            let Pose { tx, ty, .. } = bench.pose();
            steepest = steepest.max((tx * tx + ty * ty).sqrt().atan().to_degrees());
        }
        bench.run(500);
        let Pose { zc, tx, ty } = bench.pose();
        let angle = (tx * tx + ty * ty).sqrt().atan().to_degrees();
        println!("friction {friction:?}: tilt {angle:.5} deg, most {steepest:.5}, heave {:.5} mm", zc * 1e3);
        assert!(
            (angle - 5.0).abs() < 0.02 && steepest < 5.05 && bench.faults().is_empty(),
            "{:?}",
            bench.faults()
        );
        bench.order(target(0.0, 0.0, 0.0));
        bench.until(Mode::Ready, 30_000);
        bench.order(target(0.02, 0.0, 0.0));
        bench.until(Mode::Ready, 30_000);
        bench.run(500);
        let Pose { zc, .. } = bench.pose();
        println!("  heave {:.5} mm", zc * 1e3);
        assert!((zc - 0.02).abs() < 5e-5);
    }
}

#[test]
fn the_pressure_is_kept() {
    let mut bench = Bench::homed(25.0, [0.0; 2], DRIVE);
    for wanted in [4000.0, 5500.0, 4200.0] {
        bench.order(Command::Pressure(wanted));
        bench.run(40_000);
        let mut worst = 0.0_f32;
        for _ in 0..5000 {
            bench.tick(None);
            worst = worst.max((bench.tile.air.pressure() - wanted).abs());
        }
        println!("{wanted} Pa within {worst} Pa");
        assert!(worst < 50.0, "{wanted}: {worst}; {:?}", bench.faults());
    }
    assert!(bench.faults().is_empty(), "{:?}", bench.faults());
}

#[test]
fn after_a_start_the_displacement_sensors_know_where_it_is() {
    let at = Pose { zc: 0.004, tx: 0.1, ty: -0.05 };
    let mut bench = Bench::ready(20.0, [0.0; 2], at.heights(RADIUS), DRIVE);
    bench.run(10);
    let known = bench.controller.sense().pose();
    let angle = |x: f32| x.atan().to_degrees();
    println!("heave {} mm", (known.zc - at.zc) * 1e3);
    assert!((known.zc - at.zc).abs() < 3e-4);
    assert!((angle(known.tx) - angle(at.tx)).abs() < 0.15 && (angle(known.ty) - angle(at.ty)).abs() < 0.15);
}

#[test]
fn resuscitation_levels_lowers_and_vents_in_thirty_seconds() {
    let steep = Pose { zc: 0.004, tx: 0.26, ty: 0.0 };
    let mut bench = Bench::ready(PAYLOAD, [0.0; 2], steep.heights(RADIUS), DRIVE);
    bench.tile.air.fill(10_000.0);
    bench.order(Command::Stop);
    assert_eq!(bench.controller.mode(), Mode::Hold);
    bench.order(Command::Flatten);
    bench.run(30_000);
    let Pose { zc, tx, ty } = bench.pose();
    println!("heave {} mm, slopes {tx} {ty}, {} Pa", zc * 1e3, bench.tile.air.pressure());
    assert!(zc < -0.0285 && tx.abs() < 5e-3 && ty.abs() < 5e-3 && bench.tile.air.pressure() < 100.0);
    assert!(bench.faults().is_empty(), "{:?}", bench.faults());
}

#[test]
fn a_bladder_that_cannot_be_shut_is_vented() {
    let mut bench = Bench::ready(25.0, [0.0; 2], [0.0; 3], DRIVE);
    bench.tile.air.fill(9000.0);
    bench.tile.set_defect(Some(Defect::ValveOpen { vent: false }));
    let mut highest = 0.0_f32;
    for _ in 0..60_000 {
        bench.tick(None);
        highest = highest.max(bench.tile.air.pressure());
    }
    println!("highest {highest} Pa, then {} Pa", bench.tile.air.pressure());
    assert_eq!(bench.controller.mode(), Mode::Off);
    assert!(highest < 12e3 && bench.tile.air.pressure() < PRESSURE + 1500.0);
}

/// For any readings in each tick the outputs are finite, and a tile without valid readings does not move.
#[test]
fn any_readings_give_finite_outputs() {
    let mut state = 1_u64;
    let mut dice = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state
    };
    let mut controller = Controller::new(Some(Trim::default()));
    for tick in 0..200_000_u32 {
        let mut readings = Readings::at_rest();
        if tick % 1000 > 400 {
            readings.encoder = [dice() as i32, dice() as i32 >> 12, 0];
            readings.displacement = [dice() as u16, 2048, dice() as u16 >> 4];
            readings.pressure = [dice() as u16, dice() as u16];
            readings.current = [dice() as u16; 3];
            readings.supply = dice() as u16;
            readings.low_closed = [dice() & 1 == 0; 3];
        }
        let command = [
            Command::Clear(u32::MAX),
            Command::Enable,
            Command::Move(Target { heave: 0.01, slope_x: 0.0, slope_y: 0.0 }),
            Command::Pressure(4000.0),
            Command::Flatten,
            Command::Home,
        ];
        let command = &command[dice() as usize % command.len()];
        controller.tick(&readings, Faults::default(), (tick % 7 == 0).then_some(command));
        let outputs = controller.outputs();
        assert!(outputs.duty.iter().all(|d| d.abs() <= 1.0), "tick {tick}: {outputs:?}");
        assert!(!(outputs.supply && outputs.vent));
        assert!(outputs.enable || outputs.test || outputs.duty == [0.0; 3]);
    }
}

#[test]
fn runs_repeat_to_the_bit() {
    let run = || {
        let mut bench = Bench::ready(20.0, [0.01, 0.0], [0.0; 3], DRIVE);
        bench.order(target(0.002, 0.01, 0.0));
        (0..2000)
            .map(|_| {
                bench.tick(None);
                (bench.tile.heights().map(f32::to_bits), bench.controller.outputs().duty.map(f32::to_bits))
            })
            .collect::<Vec<_>>()
    };
    assert!(run() == run());
}

/// Every fault that says OFF, as the link or a reading reports it, in the middle of a motion.
#[test]
fn a_fault_that_says_off_is_off_in_its_tick() {
    type Spoil = fn(&mut Readings);
    let spoil: [(Fault, Spoil); 3] = [
        (Fault::Overrun, |r| r.overrun = true),
        (Fault::Drive, |r| r.drive_fault[1] = true),
        (Fault::Height, |r| r.encoder[2] += 1_000_000),
    ];
    for (fault, spoil) in spoil {
        let mut bench = Bench::ready(20.0, [0.0; 2], [0.0; 3], DRIVE);
        bench.order(target(0.005, 0.0, 0.0));
        bench.run(700);
        assert!(bench.controller.outputs().enable);
        for _ in 0..5 {
            let mut readings = bench.tile.read();
            spoil(&mut readings);
            let (new, _) = bench.controller.tick(&readings, Faults::default(), None);
            let is_off = !bench.controller.outputs().enable && bench.controller.mode() == Mode::Off;
            assert_eq!(!bench.controller.latched().is_empty(), is_off, "{}", fault.name());
            assert!(new.is_empty() || is_off);
        }
        assert!(bench.controller.latched().has(fault), "{}: {:?}", fault.name(), bench.faults());
        assert_eq!(
            bench.tick(Some(&Command::Enable)),
            bench.tick(Some(&target(0.0, 0.0, 0.0))),
            "both are refused"
        );
        // Cleared by name once its cause is gone; motion must be allowed anew.
        let bits = bench.controller.latched().bits();
        bench.order(Command::Clear(bits));
        bench.run(10);
        assert!(!bench.controller.outputs().enable);
    }
}

#[test]
fn an_enable_that_does_not_cut_is_found_at_start() {
    let mut bench = Bench::new(20.0, [0.0; 2], [0.0; 3], DRIVE);
    bench.tile.set_defect(Some(Defect::Enable));
    bench.run(300);
    assert_eq!(bench.controller.mode(), Mode::Off);
    assert!(bench.faults().contains(&"EnableTest"), "{:?}", bench.faults());
    assert!(bench.tile.heights().iter().all(|h| h.abs() < 1e-4));
}
