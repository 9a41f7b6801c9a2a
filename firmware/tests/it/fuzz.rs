//! Invalid frames: the node takes none for a command, and loses no valid one.
//!
//! 100,000 by default; `SMARTBED_FRAMES` sets another number.

use crate::wire::Wire;
use smartbed_firmware::link::frame::{Body, encode};
use smartbed_firmware::link::message::{Command, Outcome, Report, Target};
use smartbed_firmware::tile::mode::Mode;

/// A separate random generator, so that the frames are the same everywhere.
struct Dice(u64);

impl Dice {
    fn next(&mut self) -> u64 {
        // Marsaglia's xorshift.
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }
    fn below(&mut self, bound: usize) -> usize {
        (self.next() >> 11) as usize % bound
    }
}

/// Bytes that look like a frame: noise, a good body with bits changed under a right checksum, an old frame, half a
/// frame.
fn frame(dice: &mut Dice, old: &[Body]) -> Vec<u8> {
    let mut body = old[dice.below(old.len())].clone();
    match dice.below(5) {
        0 => return (0..dice.below(130)).map(|_| dice.next() as u8).collect(),
        1 => {
            let mut bytes = encode(&body).to_vec();
            bytes.truncate(dice.below(bytes.len() + 1));
            return bytes;
        }
        2 => {
            for _ in 0..=dice.below(4) {
                let (place, bit) = (dice.below(body.len()), dice.below(8));
                body[place] ^= 1 << bit;
            }
        }
        3 => body.truncate(dice.below(body.len() + 1)),
        _ => (),
    }
    encode(&body).to_vec()
}

#[test]
fn no_frame_without_a_fresh_tag_moves_anything() {
    let frames = std::env::var("SMARTBED_FRAMES").map_or(100_000, |n| n.parse::<u32>().expect("a number"));
    let mut dice = Dice(0x5EED);
    let mut wire = Wire::ready(20.0);
    // Orders of this life that have been used, and one of each kind with a tag of another key.
    let target = Target { heave: 0.003, slope_x: 0.01, slope_y: 0.0 };
    let commands = [
        Command::Enable,
        Command::Move(target),
        Command::Home,
        Command::Pressure(5000.0),
        Command::Flatten,
        Command::Beat(3),
        Command::Clear(7),
    ];
    let mut old: Vec<Body> =
        commands.iter().filter_map(|command| wire.peer.command(command, wire.now, 0)).collect();
    let mut other =
        smartbed_firmware::supervisor::Peer::new(5, smartbed_firmware::link::tag::Key::new([9; 16]));
    let identity = smartbed_firmware::link::message::Header {
        version: 0x81,
        tile: 5,
        boot: 1,
        sequence: 0,
        tick: wire.node.now(),
    };
    let report = Report::Identity(1, 0, 0, 0);
    let told = smartbed_firmware::link::message::write(&identity, &report).expect("it fits");
    other.take(&told, wire.now).expect("a report");
    old.extend(commands.iter().filter_map(|command| other.command(command, wire.now, 500)));
    // A later order uses up the sequence numbers of those above.
    assert_eq!(wire.order(&Command::Enable), Some(Outcome::Done));
    let at = wire.tile.heights();

    for count in 0..frames {
        let bytes = frame(&mut dice, &old);
        // As fast as the line brings them.
        wire.serial.line.down.extend(bytes);
        while !wire.serial.line.down.is_empty() {
            wire.tick();
            assert!(!wire.is_enabled(), "frame {count}");
        }
        if count % 1000 == 999 {
            assert_eq!(wire.tile.heights(), at, "frame {count}");
            // A stop needs no tag, and noise may hold one: then motion must be allowed anew.
            let is_held = matches!(wire.mode(), Mode::Hold);
            assert!(is_held || wire.mode() == Mode::Unhomed, "{:?}", wire.mode());
            wire.run(50);
            // A good frame after whatever came before is not lost.
            wire.reports.clear();
            assert_eq!(wire.order(&Command::Enable), Some(Outcome::Done), "frame {count}");
            // What was sent until now has become old.
            old[dice.below(7)] = wire.peer.command(&Command::Move(target), wire.now, 0).expect("it fits");
            assert_eq!(wire.order(&Command::Enable), Some(Outcome::Done), "frame {count}");
        }
        wire.reports.clear();
    }
}
