//! A reset at every tick of a whole session: drives are off from the first write on, and nothing moves before a new
//! permission.

use crate::wire::Wire;
use smartbed_firmware::link::frame::Body;
use smartbed_firmware::link::message::{Command, Outcome, Target, Trim};
use smartbed_firmware::node::Node;
use smartbed_firmware::plant::{Defect, Tile};
use smartbed_firmware::tile::board::Sensors;
use smartbed_firmware::tile::drive::DRIVE;
use smartbed_firmware::tile::mode::Mode;

/// Duration of a run after a reset (ticks): boot, self-test, and some time at rest.
const LIFE: u32 = 180;
/// Drives that are switched off stop within this time (ticks) and distance (m) at the speeds that occur.
const STOPPED: (u32, f32) = (20, 2e-5);
/// Lives that are tried with a fresh permission too: each of so many.
const FRESH: u32 = 997;

/// Commands of the session, and the time for each (ticks): a calibration, homing, a motion, the bladder, a fault,
/// resuscitation.
const SESSION: [(Command, u32); 9] = [
    (Command::Calibrate(Trim { height: [1e-4, -1e-4, 0.0], pressure: 20.0 }), 300),
    (Command::Enable, 50),
    (Command::Home, 9000),
    (Command::Move(Target { heave: -0.026, slope_x: 0.015, slope_y: 0.01 }), 2800),
    (Command::Pressure(4500.0), 500),
    (Command::Move(Target { heave: -0.022, slope_x: 0.0, slope_y: 0.0 }), 1500),
    (Command::Status, 50),
    (Command::Clear(u32::MAX), 50),
    (Command::Flatten, 1000),
];
/// The second motion: an encoder is stuck in it.
const BROKEN: usize = 5;

/// A life after a reset in this state; `old` are orders of the life before, sent again all the time.
fn live(before: &Wire, old: &[Body], tick: u32) {
    let (mut node, mut tile) = (before.node.clone(), before.tile.clone());
    let mut node = Node::new(5, node.store_mut().clone(), 1);
    let (soon, near) = STOPPED;
    let (start, mut rest) = (tile.heights(), tile.heights());
    for after in 0..LIFE {
        if let Some(body) = old.get(after as usize % (old.len() + 1)) {
            node.deliver(body.clone());
        }
        let outputs = *node.tick(&tile.read());
        let is_off = !outputs.enable && !outputs.supply && !outputs.vent;
        assert!(is_off && (outputs.test || outputs.duty == [0.0; 3]), "{tick}, {after}: {outputs:?}");
        tile.advance(&outputs).expect("a step");
        if after == soon {
            rest = tile.heights();
        }
        let is_at_rest = after <= soon || tile.heights() == rest;
        let is_near = tile.heights().iter().zip(start).all(|(now, then)| (now - then).abs() < near);
        assert!(is_at_rest && is_near, "{tick}, {after}: {:?} {start:?}", tile.heights());
    }
}

/// The same run with a supervisor that allows motion again: only then the tile moves.
fn live_on(before: &Wire, tick: u32) {
    let mut wire = before.clone();
    let store = wire.node.store_mut().clone();
    wire.node = Node::new(5, store, 1);
    wire.tile.set_defect(None);
    wire.run(600);
    let up = Command::Move(Target { heave: -0.02, slope_x: 0.0, slope_y: 0.0 });
    assert!(!matches!(wire.order(&up), Some(Outcome::Done)), "{tick}: {:?}", wire.mode());
    assert_eq!(wire.order(&Command::Enable), Some(Outcome::Done), "{tick}: {:?}", wire.mode());
    assert_eq!(wire.order(&up), Some(Outcome::Done), "{tick}");
    assert_eq!((wire.mode(), wire.is_enabled()), (Mode::Moving, true), "{tick}");
}

#[test]
fn a_reset_at_any_tick_disables_the_drives() {
    let tile = Tile::loaded(20.0, [0.01, 0.0], [-0.0275; 3], DRIVE).expect("a start");
    let mut wire = Wire::with(tile);
    wire.run(400);
    let (mut ticks, mut old, mut modes) = (0, Vec::new(), Vec::new());
    for (number, (command, length)) in SESSION.iter().enumerate() {
        wire.tile.set_defect((number == BROKEN).then_some(Defect::EncoderStuck(1)));
        // All faults that are there are meant.
        let faults = wire.node.controller().latched().bits();
        let command = if matches!(command, Command::Clear(_)) { Command::Clear(faults) } else { *command };
        let body = wire.peer.command(&command, wire.now, 0).expect("it fits");
        wire.send(&body);
        old.push(body);
        for _ in 0..*length {
            wire.tick();
            live(&wire, &old, ticks);
            if ticks % FRESH == 0 {
                live_on(&wire, ticks);
            }
            ticks += 1;
            modes.extend(Some(wire.mode()).filter(|mode| modes.last() != Some(mode)));
        }
    }
    println!("{ticks} resets in {modes:?}");
    for mode in [Mode::Homing, Mode::Ready, Mode::Moving, Mode::Off, Mode::Flatten] {
        assert!(modes.contains(&mode), "{mode:?} is not in {modes:?}");
    }
}

/// Power that fails at any write while a boot is counted, or a calibration stored: the next life has a record, and is
/// off.
#[test]
fn a_cut_at_any_write_of_the_store_leaves_a_tile_that_starts() {
    let trim = Trim { height: [1e-4, -2e-4, 5e-5], pressure: 30.0 };
    let mut cuts = 0;
    for life in 0..200 {
        let mut wire = Wire::new(20.0);
        wire.run(400);
        let body = wire.peer.command(&Command::Calibrate(trim), wire.now, 0).expect("it fits");
        wire.node.store_mut().flash().set_life(life);
        wire.send(&body);
        wire.run(30);
        let is_stored = !wire.has(smartbed_firmware::tile::fault::Fault::Storage);
        let mut torn = wire.node.store_mut().clone();
        // It fails in the next start too.
        torn.flash().set_life(life);
        let mut node = Node::new(5, torn, 1);
        let mut store = node.store_mut().clone();
        store.flash().set_life(u32::MAX);
        let found = store.load().expect("a record").trim;
        assert!(found == trim || (found == Trim::default() && !is_stored), "cut at {life}: {found:?}");
        wire.node = Node::new(5, store, 1);
        live(&wire, &[body], life);
        wire.run(600);
        assert_eq!(wire.order(&Command::Enable), Some(Outcome::Done), "cut at {life}");
        cuts += u32::from(!is_stored);
    }
    assert!(cuts > 20, "{cuts}");
}
