//! Controller and simulated tile, one tick at a time, for a host that takes [`turns`](crate::turns).
//!
//! In: bytes from the host. Out: bytes to the host. Host and chip run the same code, so the bytes are the same.
//! `controller_tick` is a symbol of the image, so that the emulator can count it: line and node, without the simulated
//! tile.

use crate::defect::NAMED;
use crate::link::serial::{BYTES, Line, Serial};
use crate::node::Node;
use crate::plant::Tile;
use crate::plant::flash::{Flash, provided};
use crate::station::Station;
use crate::tile::board::{Outputs, Readings, Sensors};
use crate::tile::drive::DRIVE;
use crate::tile::integrity::Program;
use crate::turns::{BREAK, END, FAULT, HELLO, KEY, TICKS};
use heapless::{Deque, Vec};

/// Initial state of the simulated tile: heights (m), mass on it (kg) and the mass's position (m).
const START: ([f32; 3], f32, [f32; 2]) = ([-0.02; 3], 20.0, [0.02, 0.0]);

/// The connection to the host.
pub trait Host {
    /// The next byte; waits for it. None if the host is gone.
    fn read(&mut self) -> Option<u8>;
    /// Sends a byte.
    fn write(&mut self, byte: u8);
}

/// How a session ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Last {
    /// The host has ended it, or is gone.
    End,
    /// The host asks for an undefined instruction.
    Fault,
    /// The simulated tile refused a step.
    Refused,
}

/// Buffers of the line between host and node.
#[derive(Clone, Debug, Default)]
struct Ends {
    down: Deque<u8, 256>,
    up: Vec<u8, BYTES>,
}

impl Line for Ends {
    fn read(&mut self) -> Option<u8> {
        self.down.pop_front()
    }
    fn write(&mut self, byte: u8) -> bool {
        self.up.push(byte).is_ok()
    }
}

/// One tick of line and node.
#[expect(unsafe_code, reason = "the emulator's plug-in finds the function by its plain name")]
#[unsafe(no_mangle)]
#[inline(never)]
fn controller_tick(
    station: &mut Station<Flash, Serial<Ends>>,
    readings: &Readings,
    program: Program,
) -> Outputs {
    station.tick(readings, program)
}

/// Takes turns until the host ends the session; the controller checks `program` against its checksum.
pub fn serve(host: &mut impl Host, program: Program, checksum: u32) -> Last {
    host.write(HELLO);
    let Some(number) = host.read() else { return Last::End };
    let margin = DRIVE.with_friction(true).locking_margin() * 1000.0;
    (margin as u16).to_le_bytes().into_iter().for_each(|byte| host.write(byte));
    let (heights, mass, offset) = START;
    let Ok(mut tile) = Tile::loaded(mass, offset, heights, DRIVE) else { return Last::Refused };
    let mut station =
        Station::new(Node::new(number, provided(KEY), 0), Serial::<Ends>::default(), program, checksum);
    loop {
        let ticks = match host.read() {
            None | Some(END) => return Last::End,
            Some(FAULT) => return Last::Fault,
            Some(BREAK) => {
                let named = host.read().and_then(|number| NAMED.get(usize::from(number)));
                tile.set_defect(named.and_then(|(_, defect)| *defect));
                0
            }
            Some(turn @ 0..=TICKS) => {
                for _ in 0..turn {
                    let Some(byte) = host.read() else { return Last::End };
                    // A full line loses the byte, as a real one would.
                    let _ = station.bus.line.down.push_back(byte);
                }
                1
            }
            Some(turn) => turn - TICKS,
        };
        for _ in 0..ticks {
            let outputs = controller_tick(&mut station, &tile.read(), program);
            if tile.advance(&outputs).is_err() {
                return Last::Refused;
            }
            host.write(station.bus.line.up.len() as u8);
            station.bus.line.up.iter().for_each(|byte| host.write(*byte));
            station.bus.line.up.clear();
        }
    }
}
