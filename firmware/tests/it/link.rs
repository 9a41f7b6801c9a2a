//! A supervisor talks to a tile over a line.

use crate::wire::{Ends, KEY, Wire};
use smartbed_firmware::link::checksum::checksum;
use smartbed_firmware::link::message::{Command, Event, Outcome, Refusal, Report, Target, Trim};
use smartbed_firmware::link::serial::Serial;
use smartbed_firmware::link::session::SILENCE;
use smartbed_firmware::node::Node;
use smartbed_firmware::plant::flash::provided;
use smartbed_firmware::station::Station;
use smartbed_firmware::tile::board::{Outputs, Readings};
use smartbed_firmware::tile::fault::Fault;
use smartbed_firmware::tile::integrity::{Program, SLICE};
use smartbed_firmware::tile::mode::Mode;

const UP: Command = Command::Move(Target { heave: 0.004, slope_x: 0.0, slope_y: 0.0 });

#[test]
fn a_tile_is_moved_and_tells_of_it() {
    let mut wire = Wire::ready(20.0);
    assert_eq!(wire.order(&UP), Some(Outcome::Done));
    assert_eq!((wire.mode(), wire.is_enabled()), (Mode::Moving, true));
    wire.run(4000);
    assert_eq!((wire.mode(), wire.is_enabled()), (Mode::Unhomed, false));
    assert!(wire.tile.heights().iter().all(|h| (h - 0.004).abs() < 3e-4));
    let state = wire.peer.state().expect("telemetry");
    assert!(state.heights.iter().all(|h| (h - 0.004).abs() < 5e-5), "{state:?}");
    assert_eq!(wire.order(&Command::Log(0)), None);
    wire.run(60);
    let modes: Vec<u8> = wire
        .reports
        .iter()
        .filter_map(|r| if let Report::Entry(_, _, Event::Mode(mode)) = r { Some(*mode) } else { None })
        .collect();
    assert_eq!(modes, [Mode::SelfTest, Mode::Unhomed, Mode::Moving, Mode::Unhomed].map(|m| m as u8));
}

#[test]
fn silence_stops_motion() {
    let mut wire = Wire::ready(20.0);
    wire.order(&UP);
    wire.run(300);
    wire.beats = false;
    let mut moved = 0;
    while wire.is_enabled() {
        wire.tick();
        moved += 1;
    }
    assert!(moved <= SILENCE + 20, "{moved}");
    let at = wire.tile.heights();
    wire.run(1000);
    let way = (wire.tile.heights()[0] - at[0]).abs();
    assert!(way < 2e-5, "{way}");
    assert_eq!((wire.mode(), wire.has(Fault::Silence)), (Mode::Hold, true));
    // The fault must be cleared, and motion allowed anew.
    wire.beats = true;
    wire.run(300);
    assert_eq!(wire.order(&UP), Some(Outcome::Refused(Refusal::Faulted)));
    assert_eq!(wire.order(&Command::Clear(1 << Fault::Silence as u32)), Some(Outcome::Done));
    assert_eq!(wire.order(&UP), Some(Outcome::Refused(Refusal::Mode)));
    assert_eq!(wire.order(&Command::Enable), Some(Outcome::Done));
    assert_eq!(wire.order(&UP), Some(Outcome::Done));
}

/// Resuscitation is allowed despite the fault that an earlier silence has left.
#[test]
fn silence_stops_motion_each_time() {
    let mut wire = Wire::ready(20.0);
    wire.order(&UP);
    for command in [None, Some(Command::Flatten), Some(Command::Flatten)] {
        wire.beats = true;
        command.into_iter().for_each(|command| assert_eq!(wire.order(&command), Some(Outcome::Done)));
        wire.run(300);
        assert!(wire.is_enabled());
        wire.beats = false;
        wire.run(SILENCE + 200);
        assert_eq!((wire.mode(), wire.is_enabled(), wire.has(Fault::Silence)), (Mode::Hold, false, true));
    }
}

#[test]
fn a_refused_command_with_the_right_tag_is_a_sign_of_life_and_used_up() {
    let mut wire = Wire::ready(20.0);
    wire.order(&UP);
    wire.beats = false;
    for _ in 0..4 {
        wire.run(SILENCE - 100);
        assert_eq!(wire.order(&UP), Some(Outcome::Refused(Refusal::Busy)));
    }
    assert!(wire.is_enabled() && !wire.has(Fault::Silence));
    let body = wire.peer.command(&UP, wire.now, 0).expect("it fits");
    wire.reports.clear();
    for _ in 0..2 {
        wire.send(&body);
        wire.run(30);
    }
    let why = |report: &Report| match report {
        Report::Answer(_, Outcome::Refused(why)) => Some(*why),
        _ => None,
    };
    let refused: Vec<Refusal> = wire.reports.iter().filter_map(why).collect();
    assert_eq!(refused, [Refusal::Busy, Refusal::Replayed]);
}

#[test]
fn a_pressure_is_kept_without_a_supervisor() {
    let mut wire = Wire::ready(20.0);
    assert_eq!(wire.order(&Command::Pressure(5000.0)), Some(Outcome::Done));
    wire.beats = false;
    wire.run(20_000);
    let pressure = wire.tile.air.pressure();
    assert!((pressure - 5000.0).abs() < 50.0, "{pressure}");
    assert_eq!((wire.mode(), wire.has(Fault::Silence)), (Mode::Unhomed, false));
}

#[test]
fn a_stop_without_a_tag_stops_within_a_tick() {
    let mut wire = Wire::ready(20.0);
    wire.order(&UP);
    wire.run(500);
    let body = wire.peer.command(&Command::Stop, 0, 0).expect("it needs nothing");
    assert!(wire.node.deliver(body));
    wire.tick();
    assert_eq!((wire.mode(), wire.is_enabled()), (Mode::Hold, false));
    let at = wire.tile.heights();
    wire.run(100);
    assert!((wire.tile.heights()[0] - at[0]).abs() < 1e-3, "it stops within a millimetre");
}

#[test]
fn a_command_waits_for_its_tick() {
    let mut wire = Wire::ready(20.0);
    let start = wire.now;
    assert_eq!(wire.order_later(&UP, 1000), Some(Outcome::Waits));
    while !wire.is_enabled() {
        wire.tick();
    }
    let waited = wire.now - start;
    assert!((990..=1010).contains(&waited), "{waited}");
}

#[test]
fn clocks_that_run_apart_stop_the_tile() {
    let mut wire = Wire::ready(20.0);
    wire.order(&UP);
    for tick in 0..6000 {
        // Every fiftieth millisecond of the supervisor's passes unseen by the tile: 2 %.
        wire.now += u32::from(tick % 50 == 0);
        wire.tick();
    }
    assert!(wire.has(Fault::Clock) && wire.mode() == Mode::Hold);
}

#[test]
fn wrong_orders_are_refused_and_change_nothing() {
    let mut wire = Wire::ready(20.0);
    let far = |heave: f32, slope_x: f32| Command::Move(Target { heave, slope_x, slope_y: 0.0 });
    let cases = [
        (far(0.031, 0.0), Refusal::Stroke),
        (far(0.0, 0.3), Refusal::Tilt),
        (far(f32::NAN, 0.0), Refusal::NonFinite),
        (Command::Pressure(12e3), Refusal::Pressure),
        (Command::Pressure(-1.0), Refusal::Pressure),
        (Command::Calibrate(Trim::default()), Refusal::Busy),
    ];
    for (command, why) in cases {
        assert_eq!(wire.order(&command), Some(Outcome::Refused(why)), "{command:?}");
        assert_eq!((wire.mode(), wire.is_enabled()), (Mode::Unhomed, false));
    }
    // Each stands in the log, with its reason.
    wire.order(&Command::Log(0));
    wire.run(200);
    let logged: Vec<Refusal> = (wire.reports.iter())
        .filter_map(|r| if let Report::Entry(_, _, Event::Refused(_, why)) = r { Some(*why) } else { None })
        .collect();
    assert_eq!(logged, cases.map(|(_, why)| why));
    wire.order(&Command::Stop);
    let wide = Trim { height: [3e-3, 0.0, 0.0], pressure: 0.0 };
    assert_eq!(wire.order(&Command::Calibrate(wide)), Some(Outcome::Refused(Refusal::Trim)));
}

#[test]
fn a_calibration_outlives_the_power() {
    let mut wire = Wire::new(20.0);
    wire.run(400);
    let trim = Trim { height: [1e-4, -2e-4, 5e-5], pressure: 30.0 };
    assert_eq!(wire.order(&Command::Calibrate(trim)), Some(Outcome::Done));
    wire.run(300);
    let heights = wire.node.controller().sense().heights;
    for (height, offset) in heights.iter().zip(trim.height) {
        assert!((height - offset).abs() < 2e-5, "{heights:?}");
    }
}

#[test]
fn a_tile_without_a_key_moves_for_nobody() {
    let mut wire = Wire::new(20.0);
    wire.node =
        Node::new(5, smartbed_firmware::tile::store::Store::new(Default::default(), [0, 192], 192), 0);
    wire.run(400);
    assert!(wire.has(Fault::Storage) && wire.mode() == Mode::Off);
    assert_eq!(wire.order(&Command::Enable), Some(Outcome::Refused(Refusal::Storage)));
    assert_eq!(*wire.node.controller().outputs(), Outputs::default());
}

/// A bit of the program that flips, in its code or its vectors, puts the tile off within two rounds, for good.
#[test]
fn a_flipped_bit_of_the_program_is_off() {
    let station = |bytes: &[u8], sum: u32| {
        let node = Node::new(5, provided(KEY), 0);
        Station::new(node, Serial::<Ends>::default(), program(bytes), sum)
    };
    let bytes = vec![0xA5_u8; 4000];
    let sum = u32::from_le_bytes(checksum(&bytes));
    let readings = Readings::at_rest();
    for place in [0, VECTORS - 1, VECTORS, bytes.len() - 1] {
        let (mut sound, mut changed) = (station(&bytes, sum), bytes.clone());
        for _ in 0..1000 {
            sound.tick(&readings, program(&bytes));
        }
        assert_eq!(sound.node().controller().mode(), Mode::Unhomed);
        changed[place] ^= 0x80;
        for _ in 0..2 * bytes.len() / SLICE + 4 {
            sound.tick(&readings, program(&changed));
        }
        let controller = sound.node().controller();
        assert!(controller.mode() == Mode::Off && controller.latched().has(Fault::Program));
        // What has flipped while the tile was without power is found before the first tick.
        let mut station = station(&changed, sum);
        for _ in 0..1000 {
            assert_eq!(station.tick(&readings, program(&changed)), Outputs::default());
            let controller = station.node().controller();
            assert!(controller.mode() == Mode::Off && controller.latched().has(Fault::Program));
        }
    }
}

const VECTORS: usize = 392;

fn program(bytes: &[u8]) -> Program<'_> {
    let (vectors, code) = bytes.split_at(VECTORS);
    Program { vectors, code }
}
